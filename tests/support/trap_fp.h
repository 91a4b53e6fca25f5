// Trap: a test that divides by zero, overflows or makes a NaN dies at the spot, with SIGFPE.
//
// Include this and the environment is registered; nothing to call. It is the proof that padded and
// masked lanes hold values that raise nothing: vector instructions raise for every lane they touch.
// Threads that are started later inherit the trap.
#pragma once

#include <gtest/gtest.h>

#include <cfenv>

namespace quern {

class TrapFloatingPoint : public testing::Environment {
 public:
  void SetUp() override { feenableexcept(kTraps); }
  void TearDown() override { fedisableexcept(kTraps); }

 private:
  static constexpr int kTraps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
};

inline testing::Environment* const kTrapFloatingPoint =
    testing::AddGlobalTestEnvironment(new TrapFloatingPoint);

}  // namespace quern
