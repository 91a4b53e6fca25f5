#include "apps/quern/machine.h"

#include <algorithm>
#include <barrier>
#include <cmath>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

#include "kernels/peak.h"
#include "scheduler/stage_times.h"
#include "soa/base.h"

namespace quern {

namespace {

constexpr int kPasses = 10;

// Least seconds of a pass in which all threads work at once.
template <class Prepare, class Pass>
double best_pass(int threads, const Prepare& prepare, const Pass& pass) {
  std::barrier together(static_cast<std::ptrdiff_t>(threads));
  double best = HUGE_VAL;
  const auto work = [&](int thread) {
    prepare(thread);
    for (int k = 0; k < kPasses; ++k) {
      Stopwatch watch;  // from before the barrier: never less than what all took
      together.arrive_and_wait();
      pass(thread);
      together.arrive_and_wait();
      if (thread == 0) best = std::min(best, watch.lap());
    }
  };
  std::vector<std::jthread> others;
  for (int k = 1; k < threads; ++k) others.emplace_back(work, k);
  work(0);
  others.clear();
  return best;
}

}  // namespace

double triad_bandwidth(int threads) {
  constexpr std::size_t kElements = std::size_t{1} << 23;
  // Not initialized: each page is first touched by the thread that will use it.
  const std::unique_ptr<double[]> a(new double[kElements]), b(new double[kElements]),
      c(new double[kElements]);
  const auto begin = [&](int thread) {
    return kElements * static_cast<std::size_t>(thread) / static_cast<std::size_t>(threads);
  };
  const double best = best_pass(
      threads,
      [&](int thread) {
        std::fill(&a[begin(thread)], a.get() + begin(thread + 1), 0.0);
        std::fill(&b[begin(thread)], b.get() + begin(thread + 1), 1.0);
        std::fill(&c[begin(thread)], c.get() + begin(thread + 1), 2.0);
      },
      [&](int thread) {
        const std::size_t end = begin(thread + 1);
        for (std::size_t k = begin(thread); k < end; ++k) a[k] = b[k] + 3.0 * c[k];
      });
  QUERN_CHECK(a[kElements / 3] == 7.0);
  return 24.0 * static_cast<double>(kElements) / best;
}

template <class Real>
double peak_arithmetic(int threads) {
  constexpr std::size_t kRounds = 100'000;  // some hundred microseconds
  std::vector<PeakRun> done(static_cast<std::size_t>(threads));
  const double best = best_pass(
      threads, [](int) {},
      [&](int thread) {
        done[static_cast<std::size_t>(thread)] = run_multiply_adds<Real>(kRounds);
      });
  double operations = 0;
  for (const PeakRun& run : done) {
    QUERN_CHECK(run.sum > 0);
    operations += run.operations;
  }
  return operations / best;
}

template double peak_arithmetic<float>(int);
template double peak_arithmetic<double>(int);

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

}  // namespace quern
