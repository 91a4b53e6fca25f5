#include "io/steadiness.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "io/statistics.h"
#include "soa/base.h"

namespace quern {
namespace {

constexpr std::size_t kBlocks = 10, kFewest = 2;  // blocks before and after a step
constexpr double kDriftErrors = 3.36, kStepErrors = 4.70;
constexpr double kMaterial = 0.01, kTooNoisy = 0.1;  // of the scale

using Blocks = std::array<double, kBlocks>;

Blocks block_means(std::span<const double> samples) {
  Blocks means{};
  for (std::size_t b = 0; b < kBlocks; ++b) {
    const std::size_t begin = b * samples.size() / kBlocks;
    const std::size_t end = (b + 1) * samples.size() / kBlocks;
    means[b] = block_mean(samples.subspan(begin, end - begin)).mean;
  }
  return means;
}

// Middle of a block, in windows from the middle of the window.
double middle(std::size_t block) { return (static_cast<double>(block) + 0.5) / kBlocks - 0.5; }

// Of blocks that scatter as the rest does about a fit of two parameters.
double variance_of(const Blocks& rest) {
  double squares = 0;
  for (const double r : rest) squares += r * r;
  return squares / (kBlocks - 2);
}

Change drift_of(const Blocks& blocks) {
  double mean = 0, product = 0, squares = 0;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    mean += blocks[b] / kBlocks;
    product += middle(b) * blocks[b];
    squares += middle(b) * middle(b);
  }
  const double slope = product / squares;
  Blocks rest{};
  for (std::size_t b = 0; b < kBlocks; ++b) rest[b] = blocks[b] - mean - slope * middle(b);
  return {slope, std::sqrt(variance_of(rest) / squares)};
}

// The step after the first `before` blocks.
Change step_after(const Blocks& blocks, std::size_t before) {
  const double n = static_cast<double>(before), m = static_cast<double>(kBlocks - before);
  double first = 0, last = 0;
  for (std::size_t b = 0; b < kBlocks; ++b) (b < before ? first : last) += blocks[b];
  first /= n;
  last /= m;
  Blocks rest{};
  for (std::size_t b = 0; b < kBlocks; ++b) rest[b] = blocks[b] - (b < before ? first : last);
  return {last - first, std::sqrt(variance_of(rest) * (1 / n + 1 / m))};
}

// By how many errors, without a division by zero.
bool clearer(const Change& a, const Change& b) {
  return std::abs(a.value) * b.standard_error > std::abs(b.value) * a.standard_error;
}

Trend trend_of(const Blocks& blocks) {
  Trend trend{drift_of(blocks), step_after(blocks, kFewest), kFewest / double(kBlocks)};
  for (std::size_t before = kFewest + 1; before + kFewest <= kBlocks; ++before) {
    const Change step = step_after(blocks, before);
    if (!clearer(step, trend.step)) continue;
    trend.step = step;
    trend.step_at = static_cast<double>(before) / kBlocks;
  }
  return trend;
}

bool beyond_chance(const Change& change, double errors, double scale) {
  const double size = std::abs(change.value);
  return size > kMaterial * scale && size > errors * change.standard_error;
}

std::string percent(const Change& change, double scale) {
  return fmt::format("{:+.2g} +- {:.1g} %", 100 * change.value / scale,
                     100 * change.standard_error / scale);
}

std::string joined(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Trend trend_of(std::span<const double> samples) {
  QUERN_CHECK(samples.size() >= kTrendSamples);
  return trend_of(block_means(samples));
}

Steadiness judge_steadiness(const std::vector<Watched>& quantities) {
  Steadiness result;
  std::vector<std::string> changing, noisy, quiet;
  for (const Watched& quantity : quantities) {
    QUERN_CHECK(quantity.scale > 0);
    if (quantity.samples.size() < kTrendSamples) {
      result.trends.clear();
      result.statement =
          fmt::format("cannot be told: {} rows of the series were recorded, it takes {}",
                      quantity.samples.size(), kTrendSamples);
      return result;
    }
    const Trend trend = trend_of(quantity.samples);
    result.trends.push_back(trend);
    const std::string line =
        fmt::format("{} {}", quantity.name, percent(trend.drift, quantity.scale));
    const bool drifts = beyond_chance(trend.drift, kDriftErrors, quantity.scale);
    if (drifts || beyond_chance(trend.step, kStepErrors, quantity.scale))
      changing.push_back(drifts ? line
                                : fmt::format("{} {} in a step at {:.0f} % of it", quantity.name,
                                              percent(trend.step, quantity.scale),
                                              100 * trend.step_at));
    else if (2 * trend.drift.standard_error > kTooNoisy * quantity.scale)
      noisy.push_back(line);
    else
      quiet.push_back(line);
  }
  if (quantities.empty()) {
    result.statement = "cannot be told: nothing moved";
  } else if (!changing.empty()) {
    result.verdict = Verdict::kNotSteady;
    result.statement = "not steady: over the recorded window " + joined(changing);
  } else if (!noisy.empty()) {
    result.statement =
        "cannot be told: over the recorded window " + joined(noisy) + ", too uncertain";
  } else {
    result.verdict = Verdict::kSteady;
    result.statement =
        "steady: over the recorded window " + joined(quiet) + ", no more than by chance or 1 %";
  }
  return result;
}

}  // namespace quern
