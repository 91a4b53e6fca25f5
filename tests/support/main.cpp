// main() of every test program; floating-point exceptions are trapped (trap_fp.h).
#include "tests/support/trap_fp.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
