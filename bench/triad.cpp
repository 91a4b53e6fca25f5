// Bandwidth of the memory as `quern bench` measures it (apps/quern/machine.h). Scene benchmarks
// print it beside each run: on a shared machine it says how much of the memory was left to the run.
//
// usage: quern_triad [THREADS]      prints GB/s
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "apps/quern/machine.h"

int main(int count, char** words) {
  const int threads = count > 1 ? std::max(1, std::atoi(words[1])) : 1;
  std::printf("%.2f\n", 1e-9 * quern::triad_bandwidth(threads));
}
