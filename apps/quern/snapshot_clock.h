// When snapshots of the recorded window are taken, and what they are called in run.h5.
//
// They go into the file as they are taken (TABLE/000001 ...), and all that is worked out of them is
// summed from there at the end. So nothing of it is state of the run: a resumed run writes the
// snapshots after its checkpoint anew, to the same bits, and finds those before it in the file.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "io/series.h"
#include "soa/scene.h"

namespace quern {

class SnapshotClock {
 public:
  // Steps count from the start of the run phase.
  SnapshotClock(const Scene& scene, double dt, std::uint64_t first_step, std::uint64_t last_step)
      : dt_(dt), first_(first_step), window_(last_step > first_step ? last_step - first_step : 1) {
    constexpr std::uint64_t kSnapshots = 100;
    const double every = scene.record.snapshots_every;
    every_ =
        every > 0 ? static_cast<std::uint64_t>(std::llround(every / dt)) : window_ / kSnapshots;
    every_ = std::max<std::uint64_t>(every_, 1);
  }

  bool due(std::uint64_t step) const { return step > first_ && (step - first_) % every_ == 0; }
  // Snapshots are numbered from 1; 0: none yet.
  std::uint64_t number(std::uint64_t step) const {
    return step > first_ ? (step - first_) / every_ : 0;
  }
  double time(std::uint64_t step) const { return static_cast<double>(step) * dt_; }
  double start() const { return time(first_); }  // s, of the window
  double first_time() const { return time(first_ + every_); }

  // Of `blocks` equal blocks of the window the one that the step at `step` belongs to, or `blocks`
  // where it does not lie in the window.
  std::uint64_t block(std::uint64_t step, std::uint64_t blocks) const {
    if (step <= first_ || step > first_ + window_) return blocks;
    return (step - first_ - 1) * blocks / window_;
  }

  static std::string name(const char* table, std::uint64_t number) {
    return fmt::format("{}/{:06}", table, number);
  }

 private:
  double dt_;
  std::uint64_t first_, window_, every_ = 1;
};

}  // namespace quern
