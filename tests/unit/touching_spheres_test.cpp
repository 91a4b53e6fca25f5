// Who may touch in `single`: places on a grid against f64, on every SIMD target of this CPU. All
// who touch are found, and nobody who is apart by more than the first pass says.
//
// It asks for d^2 < R^2 (1 + 2^-19) + 4 R s, s the spacing of the grid. A number is off by half a
// spacing and a difference by one, axis by axis: d by sqrt(3) s. A difference has three roundings
// (to f32, the spacing, the product), d^2 doubles them and adds five without fused operations, the
// limit has five: 16 x 2^-24 R^2 in all. So what is found is apart by at most R (2^-20 + 2^-21) +
// (2 + sqrt(3)) s.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/contact.h"
#include "tests/support/contact_cases.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

constexpr double kPeriod = 10;  // m, of z
const Vec3 kLow(-5, -5, -5), kHigh(5, 5, 5);

// Pairs 2k, 2k + 1 of spheres about to touch, some of them across the periodic faces.
struct Pairs {
  Column<Record<float>> record;
  Column<Traits<float>> traits;
  Column<GridPlace> on_grid;
  PlaceGrid grid{kLow, kHigh, {false, false, true}, 0.06};
  std::vector<double> overlap, farthest;  // m: of each pair, what may be found

  Pairs(std::size_t count, unsigned seed) : overlap(count), farthest(count) {
    test::Random random(seed);
    record.reset(2 * count);
    traits.reset(2 * count);
    on_grid.reset(2 * count);
    for (std::size_t k = 0; k < count; ++k) {
      // To a share of R below what f32 tells and far above it.
      const double reach = random(0.005, 0.05) + random(0.005, 0.05);
      const double depth = reach * std::pow(10, random(-7.5, -1)) * (random.below(2) ? 1 : -1);
      Vec3 x = random.in_cube(4.9);
      if (random.below(3) == 0) x.z() = random(4.95, 5.05);
      const Vec3 y = x + (reach - depth) * random.in_cube(1).normalized();
      const double share = random(0.2, 0.8);
      place(2 * k, x, share * reach);
      place(2 * k + 1, y, (1 - share) * reach);
      measure(k);
    }
  }

 private:
  void place(std::size_t at, Vec3 x, double radius) {
    x.z() -= kPeriod * std::floor((x.z() + 5) / kPeriod);
    record[at] = test::record_of<float>(x, Vec3::Zero(), Vec3::Zero(), radius);
    on_grid[at] = grid.at(x.x(), x.y(), x.z(), record[at].radius);
  }
  void measure(std::size_t k) {
    const Record<float>&a = record[2 * k], &b = record[2 * k + 1];
    Vec3 apart(a.x - b.x, a.y - b.y, a.z - b.z);
    apart.z() -= kPeriod * std::round(apart.z() / kPeriod);
    const double reach = static_cast<double>(a.radius) + static_cast<double>(b.radius);
    overlap[k] = reach - apart.norm();
    farthest[k] = reach * (0x1p-20 + 0x1p-21) + (2 + std::sqrt(3.0)) * grid.coarsest();
  }
};

// The bits of all pairs; `exchanged`: the second one of each is the owner.
std::vector<bool> told(const Pairs& pairs, bool exchanged) {
  const std::size_t count = pairs.overlap.size(), blocks = (count + kPairPad - 1) / kPairPad;
  std::vector<Index> owner(blocks * kPairPad, 0), partner(owner), row_begin, first(blocks);
  std::vector<std::uint16_t> open(blocks, 0);
  for (std::size_t k = 0; k < count; ++k) {
    owner[k] = static_cast<Index>(2 * k + (exchanged ? 1 : 0));
    partner[k] = static_cast<Index>(2 * k + (exchanged ? 0 : 1));
  }
  for (Index b = 0; b <= blocks; ++b) row_begin.push_back(b);
  std::vector<Index> found_i(owner.size() + kPairPad), found_j(found_i), state(found_i);
  FoundPairs found = {found_i.data(), found_j.data(), state.data()};
  StepConstants<float> step{};
  step.grid = pairs.grid;
  choose_kernels<float>(ForceLaw::kLinearSpringDashpot, Precision::kSingle)
      .find_pairs(step, {pairs.record.data(), pairs.traits.data(), pairs.on_grid.data()},
                  {owner.data(), row_begin.data(), partner.data(), open.data(), first.data(),
                   blocks, blocks},
                  found);
  std::vector<bool> bits;
  std::size_t touching = 0;
  for (std::size_t k = 0; k < owner.size(); ++k) {
    const bool bit = (open[k / kPairPad] >> k % kPairPad & 1) != 0;
    if (k >= count) {
      EXPECT_FALSE(bit) << "a lane without a pair";
    } else {
      bits.push_back(bit);
    }
    if (bit) {
      EXPECT_EQ(found.i[touching++], owner[k]);
    }
  }
  EXPECT_EQ(found.touching, touching);
  EXPECT_EQ(found.own, touching);
  return bits;
}

TEST(TouchOnAGrid, IsFoundOnEveryTargetWhoeverIsTheOwner) {
  test::for_each_target<float>([&](const std::string& target) {
    int near = 0, spared = 0, touching = 0, across = 0;
    for (std::size_t count = 1; count <= 3 * kPairPad + 1; ++count) {
      SCOPED_TRACE(target + ", " + std::to_string(count));
      const Pairs pairs(count, static_cast<unsigned>(count));
      const std::vector<bool> bits = told(pairs, false);
      EXPECT_EQ(told(pairs, true), bits);
      for (std::size_t k = 0; k < count; ++k) {
        const double overlap = pairs.overlap[k];
        if (overlap > 0) {
          EXPECT_TRUE(bits[k]) << "overlap " << overlap;
        } else if (overlap < -pairs.farthest[k]) {
          EXPECT_FALSE(bits[k]) << "overlap " << overlap;
        }
        near += overlap > 0 && overlap < pairs.farthest[k];
        spared += overlap < -pairs.farthest[k] && overlap > -3 * pairs.farthest[k];
        touching += overlap > 0;
        across += std::abs(pairs.record[2 * k].z - pairs.record[2 * k + 1].z) > 1;
      }
    }
    // The test is worth what its cases are.
    EXPECT_GT(near, 20);
    EXPECT_GT(spared, 20);
    EXPECT_GT(touching, 20);
    EXPECT_GT(across, 20);
  });
}

TEST(TouchOnAGrid, IsNotToldOfTwoInFarCornersOfTheDomain) {
  const double radius = 0.06;
  const PlaceGrid grid(kLow, kHigh, {false, false, true}, radius);
  const auto apart = [&](const Vec3& x, const Vec3& y) {
    const GridPlace a = grid.at(x.x(), x.y(), x.z(), 0), b = grid.at(y.x(), y.y(), y.z(), 0);
    const auto minus = [](std::int32_t p, std::int32_t q) {
      return static_cast<std::int32_t>(static_cast<std::uint32_t>(p) -
                                       static_cast<std::uint32_t>(q));
    };
    return Vec3(minus(a.x, b.x) * grid.spacing[0], minus(a.y, b.y) * grid.spacing[1],
                minus(a.z, b.z) * grid.spacing[2]);
  };
  EXPECT_GT(apart({-5, 0, 0}, {5, 0, 0}).norm(), 3.9 * radius);
  EXPECT_GT(apart({0, 5, 0}, {0, -5, 0}).norm(), 3.9 * radius);
  EXPECT_NEAR(apart({0, 0, 4.99}, {0, 0, -4.99}).z(), -0.02, grid.spacing[2]);
  EXPECT_NEAR(apart({1000, 1000, 0}, {999.9, 1000.3, 0}).y(), -0.3, grid.spacing[1]);
}

}  // namespace
}  // namespace quern
