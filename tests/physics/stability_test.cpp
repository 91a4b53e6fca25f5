// Packings at rest stay at rest at a step of 4.4 contacts: the case that ordinary damping, taken
// from the velocity of the half step before, keeps hot.
//
// Spheres are placed and settled as any scene is; then the walls' clock starts and nothing moves.
// The measure is the median kinetic energy of a particle, which single rattlers can't spoil.
// Limits: 1e-13 J, thirty times below the 3e-9 ... 3e-13 J that lagged damping leaves in such beds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

// Settles and runs as the program does, without output.
template <class Real>
void run_phases(World<Real>& world, const Scene& scene, double depth, double smallest_radius) {
  Stepper<Real> stepper(world, 1);
  const std::vector<PhasePlan> plan =
      plan_phases(scene, *scene.run.time_step, depth, world.total_mass, smallest_radius);
  for (std::size_t row = 0; row < plan.size(); ++row) {
    enter_phase(world, scene, plan, row);
    while (!phase_is_over(world, plan[row])) {
      const StepReport report = stepper.step();
      ASSERT_EQ(report.bits & kFatalBits, 0u) << "phase " << row << ", t " << world.time();
    }
  }
}

template <class Real>
std::vector<double> kinetic_energies(const World<Real>& world) {
  std::vector<double> all;
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    const Record<Real>& r = world.particles.record[k];
    const Vec3 v(r.vx, r.vy, r.vz);
    const Vec3 w(world.particles.spin_x[k], world.particles.spin_y[k], world.particles.spin_z[k]);
    const double radius = static_cast<double>(r.radius);
    all.push_back(0.5 / static_cast<double>(world.particles.traits[k].inverse_mass) *
                  (v.squaredNorm() + 0.4 * radius * radius * w.squaredNorm()));
  }
  std::sort(all.begin(), all.end());
  return all;
}

struct Heat {
  double median = 0, highest = 0, contacts = 0;  // J, J, pair contacts per particle (both ends)
};

template <class Real>
Heat heat_at_rest(const Scene& scene, double depth, double smallest_radius) {
  World<Real> world = world_of<Real>(scene);
  run_phases(world, scene, depth, smallest_radius);
  const std::vector<double> energy = kinetic_energies(world);
  const double n = static_cast<double>(energy.size());
  const Heat heat = {energy[energy.size() / 2], energy.back(), 2 * world.totals.pair_contacts / n};
  std::printf("  median %.2g J, highest %.2g J, Z = %.2f\n", heat.median, heat.highest,
              heat.contacts);
  return heat;
}

// A box of ore as in the SAG mill: e 0.3, mu 0.5, clamped, tangential damping on, 1e-5 s.
Scene box_of_ore(double from, double to, long count) {
  Law law;
  law.restitution = 0.3;
  Scene scene = small_scene(law, 1e-5);
  scene.domain.low.reset();
  scene.domain.high.reset();
  scene.run.gravity = {0, 0, -9.81};
  scene.run.settle = SettleKind::kUntilRest;
  scene.run.duration = 0.8;
  BoxSpec box;
  box.name = "box";
  box.material = "ore";
  box.high = {0.09, 0.09, 0.3};
  box.open_top = true;
  scene.boxes = {box};
  scene.particles[0].sizes = {{from, to, count, std::nullopt}};
  return scene;
}

template <class Real>
class PackingAtRest : public testing::Test {};
TYPED_TEST_SUITE(PackingAtRest, Precisions, Names);

constexpr double kCold = 1e-13;  // J

// `contacts` a sphere, walls not counted, make it a packing.
template <class Real>
void expect_cold(const Scene& scene, double seconds, double contacts) {
  const Heat heat = heat_at_rest<Real>(scene, seconds, 0.0075);
  EXPECT_LT(heat.median, kCold);
  EXPECT_GT(heat.contacts, contacts);
}

TYPED_TEST(PackingAtRest, OfEqualSpheresIsColdAtFourStepsPerContact) {
  const Scene scene = box_of_ore(0.015, 0.015, 200);
  const double steps = normal_contact_time(0.5 * sphere_mass(0.015), Law().kn) / 1e-5;
  EXPECT_NEAR(steps, 4.43, 0.01);
  expect_cold<TypeParam>(scene, 0.15, 3);
}

TYPED_TEST(PackingAtRest, OfMixedSizesIsColdAtFourStepsPerContact) {
  expect_cold<TypeParam>(box_of_ore(0.015, 0.025, 200), 0.2, 2.8);
}

// The first pass of `single` finds some that are next to touching, as spheres at rest may be.
TEST(PackingAtRestInSingle, IsColdAtFourStepsPerContact) {
  Scene equal = box_of_ore(0.015, 0.015, 200), mixed = box_of_ore(0.015, 0.025, 200);
  equal.run.precision = mixed.run.precision = Precision::kSingle;
  expect_cold<float>(equal, 0.15, 3);
  expect_cold<float>(mixed, 0.2, 2.8);
}

TYPED_TEST(PackingAtRest, OfABedWithThePeersLawIsCold) {
  // A cut of the shipped bed: unclamped, no tangential damping, periodic sides.
  Scene scene = shipped_scene("bed");
  scene.domain.high = Vec3(0.12, 0.12, 1.2);
  scene.fill.high = Vec3(0.12, 0.12, 0.4);
  scene.particles[0].count = 250;
  scene.run.duration = 1;
  // Without tangential damping a contact that gives way just before the end stirs one bed in a
  // dozen: of three the middle one counts.
  std::vector<double> medians;
  for (const std::uint64_t seed : {1, 2, 3}) {
    scene.run.seed = seed;
    const Heat heat = heat_at_rest<TypeParam>(scene, 0.4, 0.01);
    medians.push_back(heat.median);
    EXPECT_GT(heat.contacts, 3.5);
  }
  std::sort(medians.begin(), medians.end());
  EXPECT_LT(medians[1], kCold);
}

}  // namespace
}  // namespace quern::test
