// Two-pass sums: the spread of a power draw is a small difference of large numbers.
#include "io/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "soa/base.h"

namespace quern {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double mean_of(std::span<const double> values) {
  const double count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double rest = 0;  // what rounding lost
  for (const double value : values) rest += value - mean;
  return mean + rest / count;
}

}  // namespace

Mean block_mean(std::span<const double> samples, int blocks) {
  QUERN_CHECK(blocks >= 2);
  const std::size_t n = samples.size();
  if (n == 0) return {kUnknown, kUnknown};
  const double mean = mean_of(samples);
  if (n == 1) return {mean, kUnknown};

  const std::size_t count = std::min(static_cast<std::size_t>(blocks), n);
  double squares = 0;
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t begin = b * n / count, end = (b + 1) * n / count;
    const double block = mean_of(samples.subspan(begin, end - begin));
    squares += (block - mean) * (block - mean);
  }
  const double k = static_cast<double>(count);
  return {mean, std::sqrt(squares / (k - 1) / k)};
}

}  // namespace quern
