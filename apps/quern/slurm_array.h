// The job script that runs cases as an array of Slurm, one task a case.
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
  std::string log;                   // NUMBER.log of each task, behind this; its folder exists
  std::vector<int> cases;            // their numbers, ascending
  int at_once = 0;                   // tasks; 0: as Slurm has room for
  int threads = 1;                   // of a task
  double memory = 0;                 // of a task, B
  double time_limit = 0;             // of a task until it is queued again, s
  std::vector<std::string> options;  // of sbatch, without the dashes; these come last and prevail
};

// For `sbatch`. Memory is rounded up to MiB, the time limit to minutes, as Slurm counts them. Slurm
// tells a task a quarter of the limit ahead, 2 min at most, or up to a minute earlier.
std::string slurm_array_text(const SlurmArray& array);

// The text as one word of a shell.
std::string shell_word(const std::string& text);

}  // namespace quern
