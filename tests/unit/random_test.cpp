// Random numbers: the published sequence, evenness, and independence of seed, stream and number.
#include "scheduler/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace quern {
namespace {

TEST(CounterRandom, WalksTheSequenceOfSplitMix64) {
  // First values of the public-domain reference (Vigna, splitmix64.c) from state 1234567.
  CounterRandom random(1234567);
  EXPECT_EQ(random.bits(), 6457827717110365317u);
  EXPECT_EQ(random.bits(), 3203168211198807973u);
  EXPECT_EQ(random.bits(), 9817491932198370423u);
  EXPECT_EQ(random.bits(), 4593380528125082431u);
  EXPECT_EQ(random.bits(), 16408922859458223821u);
}

// Over numbers, not over one generator: this is how a fill uses them.
TEST(CounterRandom, IsUniformOverParticleNumbers) {
  constexpr int kDraws = 200000, kBins = 64;
  std::array<int, kBins> count{};
  double sum = 0, lagged = 0, last = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = CounterRandom(7, RandomStream::kSize, static_cast<std::uint64_t>(i)).uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    ++count[static_cast<std::size_t>(u * kBins)];
    sum += u - 0.5;
    lagged += (u - 0.5) * (last - 0.5);
    last = u;
  }
  const double n = kDraws;
  EXPECT_LT(std::abs(sum / n), 4 / std::sqrt(12 * n));       // 4 sigma of a mean
  EXPECT_LT(std::abs(lagged / n), 4 / (12 * std::sqrt(n)));  // 4 sigma of a product
  double chi2 = 0;
  for (const int c : count) chi2 += (c - n / kBins) * (c - n / kBins) / (n / kBins);
  EXPECT_LT(chi2, 63 + 4 * std::sqrt(2 * 63.0));  // 63 degrees of freedom, 4 sigma
}

TEST(CounterRandom, DiffersBySeedStreamAndNumber) {
  std::set<std::uint64_t> first;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const RandomStream stream : {RandomStream::kSize, RandomStream::kPlace,
                                      RandomStream::kRainOrder, RandomStream::kRainPlace}) {
      for (std::uint64_t number = 0; number < 500; ++number) {
        first.insert(CounterRandom(seed, stream, number).bits());
      }
    }
  }
  EXPECT_EQ(first.size(), 20u * 4u * 500u);
}

TEST(CounterRandom, GivesTheSameAgain) {
  static_assert(CounterRandom(1, RandomStream::kPlace, 2).bits() ==
                CounterRandom(1, RandomStream::kPlace, 2).bits());
  CounterRandom a(9, RandomStream::kPlace, 4), b(9, RandomStream::kPlace, 4);
  for (int k = 0; k < 1000; ++k) EXPECT_EQ(a.bits(), b.bits());
}

TEST(CounterRandom, KeepsToItsInterval) {
  CounterRandom random(3);
  for (int k = 0; k < 10000; ++k) {
    const double x = random.uniform(-2, 5);
    EXPECT_GE(x, -2);
    EXPECT_LE(x, 5);
  }
}

}  // namespace
}  // namespace quern
