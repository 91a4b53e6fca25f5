// What a run that goes wrong says of polyhedra: whose overlap was the deepest, against what, where;
// and who has left the domain. Spheres come first in the order of identity, polyhedra behind them.
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/polyhedron_world.h"
#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

template <class Real>
class Offenders : public testing::Test {};
TYPED_TEST_SUITE(Offenders, Precisions, Names);

ExplicitParticle one_at(const Vec3& place, double diameter) {
  return {place, Vec3::Zero(), Vec3::Zero(), diameter};
}

// Balls 0 and 1 overlap by 0.6 of their radius, rocks 3 and 4 by less than theirs; ball 2 is free.
Scene scene_of_shallow_contacts() {
  Scene scene = small_scene(Law(), 1e-6);
  scene.folder = QUERN_SOURCE_DIR "/apps/shapes";
  scene.particles[0].explicit_particles = {one_at({0, 5, 0}, 1), one_at({0.7, 5, 0}, 1),
                                           one_at({0, -5, 0}, 0.25)};
  ParticleSpec rocks;
  rocks.name = "rock";
  rocks.material = "ore";
  rocks.shape = ShapeKind::kPolyhedron;
  rocks.meshes = {"ore12.stl"};
  rocks.explicit_particles = {one_at({-4, 0, 0}, 1), one_at({-3.3, 0, 0}, 1)};
  scene.particles.push_back(rocks);
  return scene;
}

template <class Real>
StepReport first_step(World<Real>& world) {
  Stepper<Real> stepper(world, 1);
  return stepper.step();
}

template <class Real>
void expect_at(const Offender& found, const Vec3& place) {
  EXPECT_EQ(Vec3(found.position[0], found.position[1], found.position[2]), place);
}

TYPED_TEST(Offenders, AreNoneWhileContactsAreShallow) {
  World<TypeParam> world = world_of<TypeParam>(scene_of_shallow_contacts());
  const StepReport report = first_step(world);
  EXPECT_EQ(report.bits, std::uint32_t{kOverlapWarning});
  EXPECT_EQ(world.totals.pair_contacts, 2);
}

TYPED_TEST(Offenders, OfTwoRocksAreNamedBoth) {
  Scene scene = scene_of_shallow_contacts();
  for (const double x : {4.0, 4.05}) {
    scene.particles[1].explicit_particles.push_back(one_at({x, 1, 0}, 1));
  }
  World<TypeParam> world = world_of<TypeParam>(scene);
  const StepReport report = first_step(world);
  ASSERT_NE(report.bits & kDeepOverlap, 0u);
  EXPECT_EQ(report.first.id, 6u);
  EXPECT_EQ(report.first.partner, 5u);
  EXPECT_FALSE(report.first.partner_is_wall);
  expect_at<TypeParam>(report.first, world.polyhedra.place(3));
  EXPECT_NEAR(report.first.position[0], 4.05, 1e-3);
  EXPECT_EQ(report.first.overlap, report.max_overlap);
}

TYPED_TEST(Offenders, OfARockAndABallAreNamedBoth) {
  Scene scene = scene_of_shallow_contacts();
  scene.particles[1].explicit_particles.push_back(one_at({0.05, -5, 0}, 1));
  World<TypeParam> world = world_of<TypeParam>(scene);
  const StepReport report = first_step(world);
  ASSERT_NE(report.bits & kDeepOverlap, 0u);
  EXPECT_EQ(report.first.id, 5u);
  EXPECT_EQ(report.first.partner, 2u);
  EXPECT_FALSE(report.first.partner_is_wall);
  expect_at<TypeParam>(report.first, world.polyhedra.place(2));
  EXPECT_NEAR(report.first.overlap / report.max_overlap, 1, 1e-6);  // history is f32 in mixed
}

// A wall is as thick as the rock's inner radius: a rock in it is warned of, and named only once
// its centre has left the domain.
TYPED_TEST(Offenders, BehindAWallAreNamedWhenTheyLeaveTheDomain) {
  Scene scene = scene_of_shallow_contacts();
  scene.particles[0].explicit_particles.resize(1);
  scene.particles[1].explicit_particles = {one_at({-4, 0, 0}, 1), one_at({3, 2, -7.9}, 1)};
  scene.particles[1].explicit_particles[1].velocity = Vec3(0, 0, -100);
  add_plane(scene, {0, 0, -7.6}, Vec3::UnitZ());
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  StepReport report = stepper.step();
  const Shape& shape = world.shapes[0];
  EXPECT_EQ(report.bits, std::uint32_t{kOverlapWarning});
  EXPECT_EQ(world.totals.wall_contacts, 1);
  EXPECT_NEAR(report.max_overlap, shape.inner_radius, 1e-12);
  int steps = 1;
  for (; (report.bits & kFatalBits) == 0 && steps < 2000; ++steps) report = stepper.step();
  EXPECT_GT(steps, 900);
  ASSERT_EQ(report.bits & kFatalBits, std::uint32_t{kOutside});
  EXPECT_EQ(report.first.id, 2u);
  EXPECT_EQ(report.first.partner, kNoIndex);
  expect_at<TypeParam>(report.first, world.polyhedra.place(1));
  EXPECT_LT(report.first.position[2], -8);
}

// Of a state by hand: the wall of the deepest contact, and the first identity outside.
TYPED_TEST(Offenders, AreFoundInAnyState) {
  World<TypeParam> world = world_by_hand<TypeParam>();
  Polyhedra<TypeParam>& p = world.polyhedra;
  p.pairs[0].overlap = 1.25;
  for (const double deepest : {1.5, 1.0}) {
    p.walls[0].overlap = 1;
    p.walls[1].overlap = deepest;
    p.walls[1].wall = 3;
    p.spheres.numbers.fill(0);
    const Offender found = find_offender(world, kDeepOverlap);
    EXPECT_EQ(found.id, kSpheres + (deepest > 1.25 ? 2u : 1u));
    EXPECT_EQ(found.partner, deepest > 1.25 ? 3u : kSpheres);
    EXPECT_EQ(found.partner_is_wall, deepest > 1.25);
  }
  p.vz[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(find_offender(world, kNotFinite).id, kSpheres + 2);
  p.y[1] = -33;
  EXPECT_EQ(find_offender(world, kOutside).id, kSpheres + 1);
  expect_at<TypeParam>(find_offender(world, kOutside), p.place(1));
  world.periodic[1] = true;
  EXPECT_EQ(find_offender(world, kNotFinite).id, kSpheres + 2);
  world.particles.record[4].x = 33;
  EXPECT_EQ(find_offender(world, kOutside).id, world.particles.id[4]);
}

}  // namespace
}  // namespace quern::test
