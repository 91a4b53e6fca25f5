// Block means against closed forms and against series whose true uncertainty is known.
#include "io/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace quern {
namespace {

TEST(BlockMean, OfAConstantHasNoError) {
  const Mean mean = block_mean(std::vector<double>(97, 4.5));
  EXPECT_EQ(mean.mean, 4.5);
  EXPECT_EQ(mean.standard_error, 0);
}

// Ten blocks of means 0 ... 9: variance of the means 55/6, so error sqrt(55/6/10).
TEST(BlockMean, MatchesTheClosedFormOfARamp) {
  std::vector<double> samples;
  for (int i = 0; i < 1000; ++i) samples.push_back(i / 100);
  const Mean mean = block_mean(samples);
  EXPECT_NEAR(mean.mean, 4.5, 1e-15 * 10);  // a few ulp of the largest sample
  EXPECT_NEAR(mean.standard_error, std::sqrt(55.0 / 60.0), 1e-15 * 10);
}

TEST(BlockMean, FewSamplesAreTheirOwnBlocks) {
  const std::vector<double> samples = {1, 2, 3};
  const Mean mean = block_mean(samples);
  EXPECT_DOUBLE_EQ(mean.mean, 2);
  EXPECT_DOUBLE_EQ(mean.standard_error, std::sqrt(1.0 / 3.0));
}

TEST(BlockMean, OneSampleHasNoKnownErrorAndNoneNoMean) {
  EXPECT_EQ(block_mean(std::vector<double>{3}).mean, 3);
  EXPECT_TRUE(std::isnan(block_mean(std::vector<double>{3}).standard_error));
  EXPECT_TRUE(std::isnan(block_mean({}).mean));
}

TEST(BlockMean, NotFiniteSamplesShow) {
  EXPECT_TRUE(std::isnan(block_mean(std::vector<double>{1, NAN, 2}).mean));
}

// Offset by 1e9, a spread of order one must survive: the doubles there are 1.2e-7 apart.
TEST(BlockMean, KeepsASmallSpreadOnALargeMean) {
  std::vector<double> plain, shifted;
  for (int i = 0; i < 1000; ++i) {
    plain.push_back((i * 37 % 101) / 64.0);  // exact in binary, also after the shift
    shifted.push_back(plain.back() + 1e9);
  }
  EXPECT_NEAR(block_mean(shifted).standard_error, block_mean(plain).standard_error, 2e-7);
}

// Correlated samples x_i = a x_{i-1} + e_i: the error of the mean of n is s_e / (1 - a) / sqrt(n)
// for long series, (1 + a) / (1 - a) times the naive variance. Over 400 series the mean square of
// the estimate has a relative spread of sqrt(2 / (9 * 400)) = 2.4 %; 15 % covers it and the
// remaining correlation of neighbouring blocks (about 2 a / (1 - a^2) / block length = 4 %).
TEST(BlockMean, EstimatesTheErrorOfCorrelatedSamples) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  constexpr double kA = 0.9;
  constexpr int kSamples = 4000, kSeries = 400;
  double squares = 0;
  for (int s = 0; s < kSeries; ++s) {
    std::vector<double> samples;
    double x = normal(random) / std::sqrt(1 - kA * kA);
    for (int i = 0; i < kSamples; ++i) samples.push_back(x = kA * x + normal(random));
    squares += std::pow(block_mean(samples).standard_error, 2);
  }
  const double expected = 1 / (1 - kA) / std::sqrt(kSamples);
  EXPECT_NEAR(squares / kSeries / (expected * expected), 1, 0.15);
}

}  // namespace
}  // namespace quern
