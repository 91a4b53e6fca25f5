// A start with deep overlaps comes apart gently where the scene asks for it, and is refused by the
// first step where it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/small_scene.h"
#include "tests/support/test_walls.h"

namespace quern::test {
namespace {

constexpr double kDiameter = 1.0 / 64, kSide = 0.1;

template <class Real>
class DenseStart : public testing::Test {};
TYPED_TEST_SUITE(DenseStart, Precisions, Names);

// Spheres at random places in a box, half of its volume: most stand deep in others.
Scene crowd() {
  Law law;
  law.kn = 1e5;
  law.kt = 4e4;
  law.restitution = 0.5;
  const double dt = normal_contact_time(0.5 * sphere_mass(kDiameter), law.kn) / 20;
  Scene scene = small_scene(law, dt, 0.5);
  scene.run.gravity = Vec3(0, 0, -9.81);
  scene.domain.low = Vec3(-0.01, -0.01, -0.01);
  scene.domain.high = Vec3(kSide + 0.01, kSide + 0.01, 0.5);
  BoxSpec box;
  box.name = "box";
  box.material = "ore";
  box.low = Vec3::Zero();
  box.high = Vec3(kSide, kSide, 0.4);
  scene.boxes = {box};
  Random random(5);
  for (int k = 0; k < 250; ++k) {
    const double r = kDiameter / 2;
    add_sphere(scene, kDiameter,
               {random(r, kSide - r), random(r, kSide - r), random(r, kSide - r)});
  }
  return scene;
}

struct Course {
  double fastest = 0;        // m/s, while relaxing
  double deepest_first = 0;  // over the radius
  double deepest_last = 0;
  std::uint64_t capped = 0, steps = 0;
  std::uint32_t bits = 0;
};

template <class Real>
Course relax(World<Real>& world, const Scene& scene) {
  const std::vector<PhasePlan> plan =
      plan_phases(scene, *scene.run.time_step, 0.1, world.total_mass, kDiameter / 2);
  Stepper<Real> stepper(world, 1);
  Course course;
  for (std::size_t row = 0; row + 1 < plan.size() && course.bits == 0; ++row) {
    enter_phase(world, scene, plan, row);
    while (!phase_is_over(world, plan[row]) && course.bits == 0) {
      const StepReport report = stepper.step();
      course.bits = report.bits & kFatalBits;
      if (++course.steps == 1) course.deepest_first = report.max_overlap;
      course.deepest_last = report.max_overlap;
      for (const Record<Real>& r : world.particles.record) {
        course.fastest = std::max(course.fastest, Vec3(r.vx, r.vy, r.vz).norm());
      }
    }
  }
  course.capped = world.capped_contacts;
  return course;
}

// Without a cap the first step says who stands too deep in whom. A run that went on regardless
// would give the springs' energy to the spheres: two that overlap by all of a diameter part at 70
// m/s.
TYPED_TEST(DenseStart, IsRefusedByDefault) {
  const Scene scene = crowd();
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  StepReport report = stepper.step();
  EXPECT_EQ(report.bits & kFatalBits, std::uint32_t{kDeepOverlap});
  EXPECT_NE(report.first.id, kNoIndex);
  EXPECT_NE(report.first.partner, kNoIndex);
  EXPECT_EQ(report.capped, 0u);
  double fastest = 0;
  for (int k = 0; k < 20 && (report.bits & kOutside) == 0; ++k) {
    report = stepper.step();
    for (const Record<TypeParam>& r : world.particles.record) {
      fastest = std::max(fastest, Vec3(r.vx, r.vy, r.vz).norm());
    }
  }
  EXPECT_GT(fastest, 10);
}

// With `relax` and `overlap_cap` no contact comes apart faster than where its spring and its
// dashpot cancel, cap sqrt(k/m_e) / (2 zeta); a sphere has a dozen of them, and falls. What is left
// when the true law holds again is a heap without an overlap above a tenth of the radius.
TYPED_TEST(DenseStart, RelaxesUnderACap) {
  Scene scene = crowd();
  scene.run.relax = 0.5;
  scene.run.overlap_cap = 0.01 * kDiameter / 2;
  World<TypeParam> world = world_of<TypeParam>(scene);
  const Course course = relax(world, scene);
  const double part =
      *scene.run.overlap_cap * std::sqrt(1e5 / (0.5 * sphere_mass(kDiameter))) / (2 * 0.2553);
  std::printf(
      "  deepest %.2f R, then %.3f R; fastest %.2f m/s (%.2f of one contact); %llu pushed "
      "at the cap in %llu steps\n",
      course.deepest_first, course.deepest_last, course.fastest, part,
      static_cast<unsigned long long>(course.capped),
      static_cast<unsigned long long>(course.steps));
  EXPECT_EQ(course.bits, 0u);
  EXPECT_GT(course.deepest_first, 1.5);
  EXPECT_LT(course.deepest_last, 0.1);
  EXPECT_LT(course.fastest, part);
  EXPECT_GT(course.capped, 100u);
  EXPECT_EQ(world.overlap_cap, 0);
}

// The cap takes nothing else from the law: what no contact reaches changes no bit.
TYPED_TEST(DenseStart, ACapThatIsNotReachedChangesNothing) {
  Scene scene = small_scene(Law(), 1e-6);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_sphere(scene, kDiameter, {0, 0, kDiameter / 2 + 1e-6}, {0.3, 0, -1}, {5, 6, 7});
  add_sphere(scene, kDiameter, {0.1 * kDiameter, 0, 1.5 * kDiameter + 2e-6}, {0, 0, -2});
  Vec3 velocity[2];
  for (int capped = 0; capped < 2; ++capped) {
    World<TypeParam> world = world_of<TypeParam>(scene);
    world.overlap_cap = capped * kDiameter;
    world.caps_spheres = capped == 1;
    Stepper<TypeParam> stepper(world, 1);
    for (int k = 0; k < 300; ++k) EXPECT_EQ(stepper.step().capped, 0u);
    velocity[capped] = velocity_of(world, 1);
  }
  EXPECT_EQ(velocity[0], velocity[1]);
  EXPECT_GT(velocity[0].z(), -2);
}

// While it pushes at the cap a contact keeps its account: energy goes to springs, dashpots,
// friction and motion and nowhere else.
TYPED_TEST(DenseStart, ACappedContactKeepsItsAccount) {
  Law law;
  law.restitution = 0.7;
  Scene scene = small_scene(law, 1e-6);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_sphere(scene, kDiameter, {0, 0, kDiameter / 2 + 1e-6}, {0.3, 0, -1}, {5, 6, 7});
  add_sphere(scene, kDiameter, {0.1 * kDiameter, 0, 1.5 * kDiameter + 2e-6}, {0, 0, -2});
  World<TypeParam> world = world_of<TypeParam>(scene);
  world.overlap_cap = 1e-6;
  world.caps_spheres = true;
  Stepper<TypeParam> stepper(world, 1);
  std::uint64_t capped = 0;
  for (int k = 0; k < 2000; ++k) capped += stepper.step().capped;
  EXPECT_GT(capped, 500u);
  const Ledger& l = world.ledger;
  const double missing = l.start_kinetic + l.start_elastic - l.kinetic - l.elastic;
  EXPECT_NEAR(l.dissipated(), missing, 1e-6 * l.start_kinetic);
}

}  // namespace
}  // namespace quern::test
