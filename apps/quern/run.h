// The commands `quern run` and `quern resume`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace quern {

struct RunOptions {
  std::string scene;  // path, for run
  std::string out;    // folder; for resume the folder of the run
  int threads = 0;    // 0: all
  std::optional<double> until;  // s of mill time
  std::vector<std::string> overrides;
};

// Exit codes: 0 done, or stopped by a signal with a checkpoint; 4 the run went wrong.
int run_command(const RunOptions& options);
int resume_command(const RunOptions& options);

}  // namespace quern
