// The start of a run: the world before its first step, from the scene, from another run's state or
// from a checkpoint, and the phases that it is to go through. Used by run, resume and bench.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/quern/load.h"
#include "io/checkpoint.h"
#include "scheduler/phases.h"
#include "scheduler/rain.h"
#include "soa/report.h"
#include "soa/world.h"

namespace quern {

template <class Real>
class Start {
 public:
  // `checkpoint`: of the run that goes on; empty: the scene says where it starts from. News of the
  // filling go to `say`.
  Start(LoadedScene loaded, const std::string& checkpoint, Say say);

  // Rain: lets in what is due by now, in the first phase. To be called before each step.
  void let_in();

  LoadedScene loaded;
  World<Real> world;
  std::vector<PhasePlan> plan;

 private:
  double fill(SceneGeometry& geometry);
  void start_from(const std::string& path);
  void restart_clock();
  std::vector<PlacedSphere> room_taken() const;

  Say say_;
  std::unique_ptr<Rain> rain_;
};

// The scene fills its domain itself, instead of starting from a file.
bool is_filled(const Scene& scene);

// What went wrong, where and when.
template <class Real>
std::string failure_text(const World<Real>& world, const StepReport& report,
                         const PhasePlan& phase);

// Rebuilds take and give back columns of many megabytes. Left to itself the allocator soon keeps
// such blocks, in pieces, and the run grows by half; above a megabyte each block is mapped and
// returned.
void return_large_blocks();

}  // namespace quern
