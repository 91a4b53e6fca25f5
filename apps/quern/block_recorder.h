// What collisions and wear had added up to at each tenth of the recorded window, in run.h5:
// the differences are ten blocks, from which sums of the window get their standard errors.
//
// Like snapshots (snapshot_clock.h) the tables go into the file when they are due and are no state:
// a resumed run writes those after its checkpoint anew.
#pragma once

#include "io/series.h"
#include "soa/world.h"

namespace quern {

class BlockRecorder {
 public:
  // Steps count from the start of the run phase.
  BlockRecorder(std::uint64_t first_step, std::uint64_t last_step)
      : first_(first_step), window_(last_step > first_step ? last_step - first_step : 0) {}

  bool due(std::uint64_t step) const;
  // sum_blocks/000001 ... 000010: `count` and `energy` (kinds x bins) of ended collisions, and
  // `wear`, the sums of the models over all cells of walls; each where it is recorded.
  template <class Real>
  void write(const World<Real>& world, SeriesWriter& series) const;

 private:
  std::uint64_t block_of(std::uint64_t step) const;

  std::uint64_t first_, window_;
};

}  // namespace quern
