// The command `quern sweep`: many runs of a scene, on one machine or a cluster.
#pragma once

#include <string>
#include <vector>

namespace quern {

struct SweepOptions {
  std::string file, out;
  int at_once = 0, threads = 0;     // processes, and threads of each; 0: as is fastest
  int only = 0;                     // the number of one case, from 1; 0: all
  bool filling = false;             // of that case only the filling
  bool plan = false;                // run nothing: what there is to do and about how long it takes
  bool collect = false;             // run nothing: the table and page of what is there
  bool slurm = false;               // run nothing here: submit the cases as an array of jobs
  bool no_submit = false;           // with slurm: write the job scripts only
  std::string time_limit = "4 h";   // with slurm: of a job until it is queued again
  std::vector<std::string> sbatch;  // with slurm: more options of sbatch, without the dashes
};

// Exit codes: 0 done, or stopped by a signal (the same command goes on); 4: a case failed, and the
// others are done.
int sweep_command(const SweepOptions& options);

}  // namespace quern
