// The job script that runs a batch of cases as an array of Slurm, one task a case.
//
// Ahead of its time limit a task is told by SIGUSR1, which the script hands on to the case: the
// case writes a checkpoint and ends, the task goes back into the queue and later on from there.
#pragma once

#include <string>
#include <vector>

namespace quern {

struct SlurmArray {
  std::string name;                  // of the job
  std::vector<std::string> command;  // runs or goes on with a case, whose number is its last word
  std::string log_folder;            // exists; slurm-<case>.log of each task
  int cases = 1;                     // numbered from 0
  int threads = 1;                   // of a task
  double memory = 0;                 // of a task, B
  double time_limit = 0;             // of a task until it is queued again, s
};

// For `sbatch`. Memory is rounded up to MiB, the time limit to minutes, as Slurm counts them. Slurm
// tells a task a quarter of the limit ahead, 2 min at most, or up to a minute earlier.
std::string slurm_array_text(const SlurmArray& array);

}  // namespace quern
