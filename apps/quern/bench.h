// The command `quern bench`: what a step of a scene costs, stage by stage, and what it makes of the
// machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace quern {

struct BenchOptions {
  std::string scene;           // path
  int threads = 0;             // 0: all
  std::uint64_t steps = 1000;  // of a repeat, after a warm-up of a tenth
  int repeats = 3;
  std::vector<std::string> overrides;
  std::string target;  // SIMD; empty: the best of this CPU
  bool json = false;
};

// Exit codes: 0 done; 4 the run went wrong or its result is none: no figures then.
int bench_command(const BenchOptions& options);

}  // namespace quern
