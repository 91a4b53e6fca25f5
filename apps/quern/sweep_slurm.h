// A sweep as job arrays of Slurm: writes the scripts, submits them.
//
//   OUT/slurm/fillings.sh   a task for each filling that several cases start from
//   OUT/slurm/cases.sh      a task for each case; waits for the end of the former array
//   OUT/slurm/*.log         what the tasks print
//
// A task is `quern sweep FILE --out OUT --case K`, of fillings with --filling: what it finds in the
// folder decides what is left to do, as on one machine.
#pragma once

#include "apps/quern/sweep.h"
#include "apps/quern/sweep_plan.h"

namespace quern {

// Exit code. SystemError: sbatch is missing or refuses; the scripts are there.
int submit_sweep(const SweepPlan& plan, const SweepOptions& options);

}  // namespace quern
