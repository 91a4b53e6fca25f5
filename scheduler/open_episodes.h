// Collisions that have not ended yet, counted from the contacts: for the files.
#pragma once

#include <vector>

#include "soa/world.h"

namespace quern {

struct OpenEpisodes {
  double count = 0, dissipated = 0;  // 1, J so far
};

// Of each kind, while collisions are recorded.
template <class Real>
std::vector<OpenEpisodes> open_episodes(const World<Real>& world);

}  // namespace quern
