// The statement on steadiness, on series whose trend is known: correlated noise alone, with a
// drift, with a step.
#include "io/steadiness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace quern {
namespace {

// 400 samples of 100 with noise of deviation 2 that forgets itself over `memory` samples, a drift
// over the window and a step at `at` of it.
struct Series {
  double memory = 5, drift = 0, step = 0, at = 0.5;

  std::vector<double> samples(std::uint64_t seed) const {
    constexpr int kSamples = 400;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0, 2);
    const double keep = std::exp(-1 / memory), fresh = std::sqrt(1 - keep * keep);
    double now = noise(random);
    std::vector<double> all;
    for (int k = 0; k < kSamples; ++k) {
      const double share = (k + 0.5) / kSamples;
      all.push_back(100 + now + drift * share + (share > at ? step : 0));
      now = keep * now + fresh * noise(random);
    }
    return all;
  }
};

// Share of 300 runs that are found not to be steady.
double alarms(const Series& series) {
  constexpr int kRuns = 300;
  int found = 0;
  for (int seed = 1; seed <= kRuns; ++seed) {
    const Steadiness result = judge_steadiness({{"power", series.samples(seed), 100}});
    found += result.verdict == Verdict::kNotSteady;
  }
  return found / static_cast<double>(kRuns);
}

// Two questions at 1 % each, 2 % together: of 300 runs six, with a deviation of 2.4. A block is 40
// samples: noise that lasts as long makes neighbouring blocks alike (14 % of 3000 runs).
TEST(Steadiness, IsRarelyDeniedToCorrelatedNoise) {
  EXPECT_LE(alarms({.memory = 0.1}), 0.045);
  EXPECT_LE(alarms({.memory = 5}), 0.045);
  EXPECT_LE(alarms({.memory = 40}), 0.2);
}

// Blocks of 40 samples with a memory of 5 scatter by 2 sqrt(2 x 5 / 40) = 1, so the drift's error
// is 1 / sqrt(0.825) = 1.1 and the step's 1 x sqrt(2 / 5) = 0.63: both are seven errors.
TEST(Steadiness, IsDeniedToADriftOrAStep) {
  EXPECT_GE(alarms({.drift = 8}), 0.95);
  EXPECT_GE(alarms({.step = 5}), 0.95);
  EXPECT_GE(alarms({.step = -5}), 0.95);
  EXPECT_GE(alarms({.step = 8, .at = 0.2}), 0.95);
}

TEST(Trend, IsWhatTheSeriesHas) {
  double drift = 0, squares = 0, claimed = 0;
  constexpr int kRuns = 200;
  for (int seed = 1; seed <= kRuns; ++seed) {
    const Trend trend = trend_of(Series{.drift = 8}.samples(seed));
    drift += trend.drift.value / kRuns;
    squares += std::pow(trend.drift.value - 8, 2) / kRuns;
    claimed += std::pow(trend.drift.standard_error, 2) / kRuns;
  }
  // 1.1 / sqrt(200) = 0.08: four of it.
  EXPECT_NEAR(drift, 8, 0.32);
  // The error is right: squares of 200 and of 200 x 8 are known to 10 and 4 %, and blocks that are
  // a little alike (0.1) claim less than they should, by a tenth or two.
  EXPECT_GT(claimed, 0.6 * squares);
  EXPECT_LT(claimed, 1.4 * squares);
}

TEST(Trend, FindsTheMomentOfAStep) {
  const Trend trend = trend_of(Series{.step = -12, .at = 0.7}.samples(4));
  EXPECT_NEAR(trend.step_at, 0.7, 1e-9);
  EXPECT_NEAR(trend.step.value, -12, 4 * 0.7);  // error: 1 x sqrt(1 / 7 + 1 / 3) = 0.7
}

TEST(Steadiness, OfAStraightLineAndOfAConstant) {
  std::vector<double> line(100, 7), flat(100, 7);
  for (std::size_t k = 0; k < line.size(); ++k) line[k] += 0.01 * static_cast<double>(k);
  EXPECT_EQ(judge_steadiness({{"power", flat, 7}}).verdict, Verdict::kSteady);
  const Steadiness rising = judge_steadiness({{"power", flat, 7}, {"kinetic energy", line, 7}});
  EXPECT_EQ(rising.verdict, Verdict::kNotSteady);
  EXPECT_NE(rising.statement.find("kinetic energy +14"), std::string::npos) << rising.statement;
  EXPECT_EQ(rising.statement.find("power"), std::string::npos) << rising.statement;
  ASSERT_EQ(rising.trends.size(), 2u);
  EXPECT_NEAR(rising.trends[1].drift.value, 1, 1e-9);
}

TEST(Steadiness, IsNotClaimedWhereItCannotBeTold) {
  const Steadiness few = judge_steadiness({{"power", std::vector<double>(19, 1.0), 1}});
  EXPECT_EQ(few.verdict, Verdict::kUnknown);
  EXPECT_NE(few.statement.find("19 rows"), std::string::npos);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(1, 3);
  std::vector<double> wild(100);
  for (double& x : wild) x = noise(random);
  EXPECT_EQ(judge_steadiness({{"power", wild, 1}}).verdict, Verdict::kUnknown);
  EXPECT_EQ(judge_steadiness({}).verdict, Verdict::kUnknown);
}

}  // namespace
}  // namespace quern
