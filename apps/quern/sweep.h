// The command `quern sweep`: many runs of a scene, on one machine.
#pragma once

#include <string>

namespace quern {

struct SweepOptions {
  std::string file, out;
  int at_once = 0, threads = 0;  // processes, and threads of each; 0: as is fastest
  int only = 0;                  // the number of one case, from 1; 0: all
  bool plan = false;             // run nothing: what there is to do and about how long it takes
};

// Exit codes: 0 done, or stopped by a signal (the same command goes on); 4: a case failed, and the
// others are done.
int sweep_command(const SweepOptions& options);

}  // namespace quern
