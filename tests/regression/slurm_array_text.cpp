// The job script of an array, for slurm_loopback.py.
//
// usage: slurm_array_text LOG_FOLDER CASES MEMORY_MIB MINUTES COMMAND [WORD ...]
#include <cstdio>
#include <cstdlib>

#include "apps/quern/slurm_array.h"

int main(int argc, char** argv) {
  if (argc < 6) return 2;
  quern::SlurmArray array;
  array.name = "loopback";
  array.log_folder = argv[1];
  array.cases = std::atoi(argv[2]);
  array.memory = std::atof(argv[3]) * (1 << 20);
  array.time_limit = std::atof(argv[4]) * 60;
  array.command.assign(argv + 5, argv + argc);
  std::fputs(quern::slurm_array_text(array).c_str(), stdout);
}
