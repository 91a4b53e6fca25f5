// Runs what a sweep has planned: so many at a time, each a process of its own.
//
// All that has to be known is in the folders: what is finished stays, what was stopped goes on from
// its checkpoint, so the same command goes on after any end of this program. A run that ends badly
// is started once more (from its checkpoint, if there is one) and then left, with the reason in
// FOLDER/failed.txt; a later command tries again what did not go wrong by itself but was killed.
#pragma once

#include <vector>

#include "apps/quern/sweep_plan.h"

namespace quern {

struct SweepWidth {
  int at_once = 1, threads = 1;  // processes; of each
};

struct JobsResult {
  std::size_t finished = 0, failed = 0;
  bool stopped = false;  // by a signal: all have written checkpoints
};

enum class JobsPart { kCases, kFillings };  // cases and what they need, or their fillings alone

// From now on SIGINT, SIGTERM and SIGUSR1 end the runs, with checkpoints, and then run_cases().
void heed_signals();

// `cases`: rows of plan.cases. `seconds_per_step` (wall clock, a particle and step of one process)
// serves the first guess of the time left; 0: none. The result counts what `part` says.
JobsResult run_cases(const SweepPlan& plan, const std::vector<std::size_t>& cases,
                     const SweepWidth& width, double seconds_per_step, JobsPart part);

}  // namespace quern
