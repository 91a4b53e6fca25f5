// `single`: the first pass finds by f32 who may touch, the law asks again. Forces of contacts are
// those of `mixed` to the bit; what is found besides shifts the order in which they are added, by
// an f64 rounding. Mills move alike until chaos has raised that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/hashed_runs.h"
#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

struct Difference {
  std::size_t bits = 0;  // spheres whose place or velocity differ by a bit
  double farthest = 0;   // m
};

Difference difference(const World<float>& a, const World<float>& b) {
  Difference d;
  for (Index id = 0; id < a.particles.size(); ++id) {
    const Vec3 apart = place_of(a, id) - place_of(b, id);
    d.bits += apart != Vec3::Zero() || velocity_of(a, id) != velocity_of(b, id) ? 1 : 0;
    d.farthest = std::max(d.farthest, apart.norm());
  }
  return d;
}

// From the same start in both precisions: as near after so many steps as `within` (m), with the
// same contacts, and sums to the rounding of f32 tallies.
void expect_same_motion(Scene scene, std::uint64_t steps, double within) {
  World<float> mixed = world_of<float>(scene);
  scene.run.precision = Precision::kSingle;
  World<float> single = world_of<float>(scene);
  ASSERT_EQ(single.precision, Precision::kSingle);
  advance(mixed, {}, steps);
  advance(single, {}, steps);
  ASSERT_EQ(mixed.particles.size(), single.particles.size());
  const Difference d = difference(mixed, single);
  std::printf("  %zu of %zu differ, by %.2g m at most; %g contacts\n", d.bits,
              mixed.particles.size(), d.farthest, mixed.totals.pair_contacts);
  EXPECT_LT(d.farthest, within);
  EXPECT_EQ(mixed.totals.pair_contacts, single.totals.pair_contacts);
  EXPECT_GT(mixed.totals.pair_contacts, 50) << "a charge without contacts proves nothing";
  EXPECT_NEAR(mixed.ledger.slide, single.ledger.slide, 1e-5 * mixed.ledger.slide);
  EXPECT_NEAR(mixed.ledger.contact_work, single.ledger.contact_work,
              1e-5 * std::abs(mixed.ledger.contact_work));
}

constexpr double kNear = 1e-10;

TEST(Single, MovesALabMillAsMixed) {
  expect_same_motion(shipped_scene("lab_mill_spheres",
                                   {"run.settle=none", "run.tile_size=16", "mill.rotation=60 rpm"}),
                     10000, kNear);
}

TEST(Single, MovesALabMillOfHertzMindlinSpringsAsMixed) {
  expect_same_motion(shipped_scene("lab_mill_hertz", {"run.settle=none", "run.tile_size=16"}),
                     10000, kNear);
}

// Periodic ends, sizes 1:4, two materials.
TEST(Single, MovesASliceAsMixed) {
  expect_same_motion(
      shipped_scene(
          "sag_slice_small_sp",
          {"run.settle=none", "run.tile_size=64", "mill.length=0.32 m", "particles.ball.count=125",
           "particles.ore.sizes=[{ from = \"35 mm\", to = \"45 mm\", count = 1180 }, { "
           "from = \"45 mm\", to = \"75 mm\", count = 334 }]"}),
      10000, kNear);
}

// Pulling contacts: what is found beyond the touch must not pull.
TEST(Single, MovesABedOfPullingContactsAsMixed) {
  Scene scene = shipped_scene("bed", {"run.settle=none"});
  scene.domain.high = Vec3(0.12, 0.12, 1.2);
  scene.fill.high = Vec3(0.12, 0.12, 0.4);
  scene.particles[0].count = 250;
  expect_same_motion(scene, 24000, kNear);
}

}  // namespace
}  // namespace quern::test
