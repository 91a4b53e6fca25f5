// Bandwidth of the memory by the triad of STREAM (McCalpin 1995): a = b + s c over three arrays far
// larger than the caches, each thread its own part. Prints the best of ten passes in GB/s, 24 bytes
// counted for an element. Scene benchmarks print it beside each run: on a shared machine it says
// how much of the memory was left to the run.
//
// usage: quern_triad [THREADS]
#include <algorithm>
#include <barrier>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

namespace {

constexpr std::size_t kElements = std::size_t{1} << 23;  // of each array: 64 MiB
constexpr int kPasses = 10;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

int main(int count, char** words) {
  const std::size_t threads = count > 1 ? std::max(1ul, std::strtoul(words[1], nullptr, 10)) : 1;
  // Not initialized: each page is first touched by the thread that will use it.
  const std::unique_ptr<double[]> a(new double[kElements]), b(new double[kElements]),
      c(new double[kElements]);
  std::barrier together(static_cast<std::ptrdiff_t>(threads));
  double best = 1e300;
  const auto work = [&](std::size_t thread) {
    const std::size_t begin = kElements * thread / threads,
                      end = kElements * (thread + 1) / threads;
    std::fill(&a[begin], a.get() + end, 0.0);
    std::fill(&b[begin], b.get() + end, 1.0);
    std::fill(&c[begin], c.get() + end, 2.0);
    for (int pass = 0; pass < kPasses; ++pass) {
      const double start = seconds();  // before the barrier: never less than what all took
      together.arrive_and_wait();
      for (std::size_t k = begin; k < end; ++k) a[k] = b[k] + 3.0 * c[k];
      together.arrive_and_wait();
      if (thread == 0) best = std::min(best, seconds() - start);
    }
  };
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < threads; ++k) others.emplace_back(work, k);
  work(0);
  others.clear();
  if (a[kElements / 3] != 7.0) return 1;
  std::printf("%.2f\n", 24e-9 * static_cast<double>(kElements) / best);
}
