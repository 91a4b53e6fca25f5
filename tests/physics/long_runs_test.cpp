// What only shows after many steps: drift, heating, and the limit of the step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/rotate.h"
#include "kernels/tally.h"
#include "scheduler/trial.h"
#include "tests/support/polyhedra.h"
#include "tests/support/small_scene.h"
#include "tests/support/test_walls.h"

namespace quern::test {
namespace {

template <class Real>
class SlowLongRuns : public testing::Test {};
TYPED_TEST_SUITE(SlowLongRuns, Precisions, Names);

// A million steps of free rotation, 0.05 rad each, of a rock with three different moments: the
// angular momentum is kept to rounding, a random walk of 1e6 ulp at 1e3, and the energy, which the
// splitting changes by 1e-2 (dt w)^2 to and fro, has no trend: its mean over the last tenth is that
// over the first to the 1e-3 of the swing that a tenth leaves.
TEST(LongRotation, OfAMillionStepsKeepsEnergyAndAngularMomentum) {
  Column<double> column[16];
  for (auto& c : column) {
    c.reset(1);
    c.fill(0);
  }
  RotationView view{};
  Column<double>* next = column;
  for (auto& p : view.orientation) p = (next++)->data();
  for (auto& p : view.momentum) p = (next++)->data();
  for (auto& p : view.spin) p = (next++)->data();
  for (auto& p : view.torque) p = (next++)->data();
  for (auto& p : view.inverse_inertia) p = (next++)->data();
  view.count = 1;
  const Vec3 inertia(0.35, 0.7, 1), momentum = Vec3(0.2, 0.6, 0.3).normalized() * 0.6;
  for (std::size_t a = 0; a < 3; ++a) {
    column[4 + a][0] = momentum[static_cast<Eigen::Index>(a)];
    column[13 + a][0] = 1 / inertia[static_cast<Eigen::Index>(a)];
  }
  column[0][0] = 1;
  const auto now = [&](std::size_t first) {
    return Vec3(column[first][0], column[first + 1][0], column[first + 2][0]);
  };
  const double start = 0.5 * momentum.dot(momentum.cwiseQuotient(inertia));
  constexpr int kSteps = 1000000, kTenth = kSteps / 10;
  double largest = 0, first = 0, last = 0;
  for (int k = 0; k < kSteps; ++k) {
    rotate_bodies(view, 0.05, 0.05);
    const double error = 0.5 * now(4).dot(now(7)) / start - 1;
    largest = std::max(largest, std::abs(error));
    if (k < kTenth) first += error / kTenth;
    if (k >= kSteps - kTenth) last += error / kTenth;
  }
  const double norm = std::sqrt(column[0][0] * column[0][0] + column[1][0] * column[1][0] +
                                column[2][0] * column[2][0] + column[3][0] * column[3][0]);
  std::printf("  energy within %.2g, trend %.2g; momentum %.2g\n", largest, last - first,
              (now(4) - momentum).norm() / momentum.norm());
  EXPECT_LT(largest, 0.05 * 0.05 * 2e-2);
  EXPECT_LT(std::abs(last - first), 1e-3 * largest);
  EXPECT_LT((now(4) - momentum).norm(), 1e-13 * momentum.norm());
  EXPECT_NEAR(norm, 1, 4e-16);
}

// Ore as in the SAG mill on a floor between periodic sides, at 10 steps per contact.
Scene small_bed() {
  Law law;
  law.restitution = 0.3;
  const double d = 0.015, dt = normal_contact_time(0.5 * sphere_mass(d), law.kn) / 10;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = Vec3(0, 0, -9.81);
  scene.domain.low = Vec3(0, 0, -0.02);
  scene.domain.high = Vec3(0.048, 0.048, 0.3);
  scene.domain.periodic[0] = scene.domain.periodic[1] = true;
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  Random random(11);
  for (int k = 0; k < 36; ++k) {
    const Vec3 cell(k % 3 + 0.5, k / 3 % 3 + 0.5, 1.2 * (k / 9) + 0.6);
    add_sphere(scene, d * (1 - 0.1 * (k % 4)), 0.016 * cell + random.in_cube(5e-4));
  }
  return scene;
}

template <class Real>
std::vector<Vec3> places(const World<Real>& world) {
  std::vector<Vec3> all;
  for (Index id = 0; id < world.particles.size(); ++id) all.push_back(place_of(world, id));
  return all;
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, (a[k] - b[k]).norm());
  return most;
}

// Ten million steps of a bed at rest. In f64 nothing moves any more. In mixed forces are rounded to
// 6e-8 of themselves, some 1e-8 N, anew in each step: a sphere swings with what a contact's damping
// leaves of that. No trend: the second half is as cold as the first, and no sphere has gone
// further than a ten-thousandth of the overlap that it rests on, some 1e-8 m.
TYPED_TEST(SlowLongRuns, ABedAtRestNeitherDriftsNorHeats) {
  const Scene scene = small_bed();
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  // Until a sphere that touches nothing but the floor, and rolls on for ever, has stopped as well.
  world.drag = std::exp(-20 * world.clock.dt);
  run_steps(world, stepper, 1000000);
  world.drag = 1;
  run_steps(world, stepper, 200000);
  if (this->HasFatalFailure()) return;
  const std::vector<Vec3> start = places(world);
  EXPECT_GT(2 * world.totals.pair_contacts / 36, 3);  // it is a packing: the floor not counted
  double hottest[2] = {}, floor = 0;
  constexpr int kBlocks = 100, kBlock = 100000;
  for (int block = 0; block < kBlocks; ++block) {
    run_steps(world, stepper, kBlock);
    if (this->HasFatalFailure()) return;
    const double kinetic = world.totals.translational + world.totals.rotational;
    double& most = hottest[block < kBlocks / 2 ? 0 : 1];
    most = std::max(most, kinetic);
    floor = -world.wall_totals[0].force[2] / (9.81 * world.total_mass);
  }
  const double drift = farthest(places(world), start);
  std::printf("  %d steps: hottest %.2g J, then %.2g J; drift %.2g m; floor 1 %+.1g; Z %.2f\n",
              kBlocks * kBlock, hottest[0], hottest[1], drift, floor - 1,
              2 * world.totals.pair_contacts / 36);
  EXPECT_LT(hottest[0], 1e-20);
  EXPECT_LT(hottest[1], 2 * hottest[0] + 1e-30);
  EXPECT_LT(drift, 1e-12);
  EXPECT_NEAR(floor, 1, 1e-6);
}

// A dense column of 20 m, 4400 spheres of 0.1 m, in mixed, placed loosely over 58 m: it falls
// together, comes to rest under its own weight, and the floor carries it. With soft springs as the
// program settles it; without, `drag_time` s of a drag follow.
void expect_standing_column(double soft_stiffness, double drag_time) {
  Law law;
  law.restitution = 0.3;
  constexpr int kSpheres = 4400;
  const double d = 0.1, dt = normal_contact_time(0.5 * sphere_mass(d), law.kn) / 10;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = Vec3(0, 0, -9.81);
  scene.run.settle = SettleKind::kUntilRest;
  if (soft_stiffness == 1) scene.run.settle_time = 12;
  scene.run.soft_stiffness = soft_stiffness;
  scene.domain.low = Vec3(0, 0, -0.2);
  scene.domain.high = Vec3(0.4, 0.4, 30);
  scene.domain.periodic[0] = scene.domain.periodic[1] = true;
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  Random random(3);
  for (int k = 0; k < kSpheres; ++k) {
    const Vec3 cell(k % 3, k / 3 % 3, k / 9);
    add_sphere(scene, d * random(0.9, 1),
               0.133 * cell.cwiseProduct(Vec3(1, 1, 0.9)) + Vec3(0.066, 0.066, 0.06) +
                   random.in_cube(0.01));
  }
  scene.domain.high->z() = 60;
  World<float> world = world_of<float>(scene);
  const std::vector<PhasePlan> plan = plan_phases(scene, dt, 58, world.total_mass, d / 2);
  Stepper<float> stepper(world, 2);
  for (std::size_t row = 0; row + 1 < plan.size(); ++row) {
    enter_phase(world, scene, plan, row);
    while (!phase_is_over(world, plan[row])) {
      ASSERT_EQ(stepper.step().bits & kFatalBits, 0u) << "phase " << row;
    }
  }
  enter_phase(world, scene, plan, plan.size() - 1);
  world.drag = std::exp(-10 * dt);
  for (int k = 0; k * dt < drag_time; ++k) ASSERT_EQ(stepper.step().bits & kFatalBits, 0u);
  world.drag = 1;
  double force = 0;
  constexpr int kSteps = 20000;
  for (int k = 0; k < 2 * kSteps; ++k) {
    ASSERT_EQ(stepper.step().bits & kFatalBits, 0u);
    if (k >= kSteps) force -= world.wall_totals[0].force[2] / kSteps;
  }
  double top = 0;
  for (const Record<float>& r : world.particles.record) top = std::max(top, r.z);
  const double kinetic = world.totals.translational + world.totals.rotational;
  std::printf(
      "  %.1f m high, kinetic energy %.2g J a sphere, floor %.6f of the weight, deepest %.2g R\n",
      top, kinetic / kSpheres, force / (9.81 * world.total_mass), world.totals.max_overlap);
  EXPECT_GT(top, 20);
  EXPECT_NEAR(force / (9.81 * world.total_mass), 1, 1e-3);
  // A lift by a millionth of the radius takes 1e-6 J.
  EXPECT_LT(kinetic / kSpheres, 1e-6);
  EXPECT_LT(world.totals.max_overlap, 0.1);
}

TEST(SlowLongColumn, OfTwentyMetresComesToRestInMixed) {
  expect_standing_column(RunSpec().soft_stiffness, 0);
}

// Its slowest swing, half a second long, is damped by dashpots within half a minute only: a drag
// does it in six seconds.
TEST(SlowLongColumn, OfTwentyMetresStandsOnceADragHasStilledIt) { expect_standing_column(1, 6); }

// The limit that a trial finds is one: at 0.9 of the step of the limit a dense packing rests,
// at 1.1 of it it does not, and even there it only stays warm: nobody jumps a diameter high, and no
// number fails. A run is refused there anyway if it is below 4 steps per contact.
TEST(SlowStepLimit, IsWhereAPackingStopsComingToRest) {
  Scene scene;
  scene.materials.push_back({"ore", 4500, 0});
  scene.contact.normal_stiffness = 2e7;
  scene.contact.tangential_stiffness = 8e6;
  scene.contact.restitution = 0.3;
  scene.contact.sliding_friction = 0.5;
  TrialSpec spec;
  spec.from = spec.to = 0.015;
  spec.material = spec.wall_material = "ore";
  spec.steps_per_contact.clear();
  for (double steps = 6; steps > 2; steps /= 1.04) spec.steps_per_contact.push_back(steps);
  const double limit = measure_stability(scene, spec).limit;
  ASSERT_GT(limit, 0);
  const double weight = sphere_mass(0.015) * 9.81 * 0.015;
  spec.steps_per_contact = {8, limit / 0.9};
  const StabilityTrial below = measure_stability(scene, spec);
  spec.steps_per_contact = {8, limit / 1.1};
  const StabilityTrial above = measure_stability(scene, spec);
  ASSERT_EQ(below.points.size(), 2u);
  ASSERT_EQ(above.points.size(), 2u);
  std::printf(
      "  limit %.2f steps per contact; at 0.9 of its step %.1e J, at 1.1 %.1e J a particle "
      "(m g d %.1e J)\n",
      limit, below.points[1].energy, above.points[1].energy, weight);
  EXPECT_TRUE(below.points[1].stable);
  EXPECT_FALSE(above.points[1].stable);
  EXPECT_LT(above.points[1].energy, weight);
}

}  // namespace
}  // namespace quern::test
