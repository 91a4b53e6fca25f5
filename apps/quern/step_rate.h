// How fast a scene's steps are here and now, measured on its charge as it is placed.
#pragma once

#include <optional>

#include "apps/quern/load.h"

namespace quern {

struct StepRate {
  double particles = 0;
  double steps = 0, run_steps = 0;  // of the scene: all, settling at most so long; of the run phase
  double per_second = 0;            // particle steps; 0: particles overlap where they are placed
  int threads = 1;

  // About what so many steps take once the charge has settled.
  double settled_seconds(double count) const;
};

// Steps for `time` (s); nothing where the particles rain in and have no room all at once. `loaded`
// is as before afterwards.
std::optional<StepRate> measure_steps(LoadedScene& loaded, int threads, double time, Say say);

}  // namespace quern
