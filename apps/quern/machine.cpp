#include "apps/quern/machine.h"

#include <sys/resource.h>

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

// A number in a file of the system; infinity where there is none.
double number_in(const std::string& path) {
  std::ifstream file(path);
  double value = 0;
  return file >> value ? value : HUGE_VAL;
}

// The least limit of the control groups, of versions 1 and 2; in a container their own folder is
// the root of what can be seen.
double group_limit() {
  double least = HUGE_VAL;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {  // number:controllers:path
    const std::size_t path_at = line.rfind(':') + 1;
    for (const std::string& path : {std::string(), line.substr(path_at)}) {
      if (line.find(":memory:") != std::string::npos) {
        least =
            std::min(least, number_in("/sys/fs/cgroup/memory" + path + "/memory.limit_in_bytes"));
      } else if (line.starts_with("0::")) {
        least = std::min(least, number_in("/sys/fs/cgroup" + path + "/memory.max"));
      }
    }
  }
  return least;
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

double available_memory() {
  double available = HUGE_VAL;
  std::ifstream info("/proc/meminfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("MemAvailable:")) available = 1024 * std::stod(line.substr(13));
  }
  rlimit own{};
  if (getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY) {
    available = std::min(available, static_cast<double>(own.rlim_cur));
  }
  return std::min(available, group_limit());
}

}  // namespace quern
