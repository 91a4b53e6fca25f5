// Spheres on walls that move: conveyor, shaker, drum and mill.
//
// Oracles: closed forms of a sphere on a moving plane, the wall's own pose, and the balance between
// the work that walls are booked with and the torque that they feel, which a wrong wall velocity
// would break although the energy account would still close.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/laws/damping.h"
#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

constexpr double kRadius = 1.0 / 128, kGravity = 9.81;
const double kMass = sphere_mass(2 * kRadius);

template <class Real>
class MovingWalls : public testing::Test {};
TYPED_TEST_SUITE(MovingWalls, Precisions, Names);

double softened(const Law& law, double dt) {  // kn' of a sphere on a wall
  const double zeta = damping_ratio(law.restitution, law.normal_force);
  return law.kn / (1 + zeta * std::sqrt(law.kn / kMass) * dt);
}

Motion translation(const Vec3& axis, double speed) {
  Motion motion;
  motion.kind = MotionKind::kTranslation;
  motion.axis = axis;
  motion.rate.points = {{0, speed}};
  return motion;
}

TYPED_TEST(MovingWalls, ConveyorTakesARestingSphereToTwoSeventhsOfItsSpeed) {
  const Law law;
  const double belt = 0.7, dt = 1e-5;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = {0, 0, -kGravity};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ(), translation(Vec3::UnitX(), belt));
  add_sphere(scene, 2 * kRadius, {0.1, 0.2, kRadius - kMass * kGravity / softened(law, dt)});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  // Slides until 2 v / (7 mu g) = 41 ms; then rolls. The belt's speed is that of the step before,
  // so it has none at t = 0 and the first half kick is without friction: v = mu g (t - dt).
  run_until(world, stepper, 0.02);
  EXPECT_NEAR(velocity_of(world, 0).x(), law.sliding * kGravity * (0.02 - dt), 1e-7 * belt);
  run_until(world, stepper, 0.06);
  // Arms are short by half the overlap, 3e-7; f32 spins 6e-8.
  EXPECT_NEAR(velocity_of(world, 0).x(), 2 * belt / 7, 2e-6 * belt);
  EXPECT_NEAR(kRadius * spin_of(world, 0).y(), -5 * belt / 7, 2e-6 * belt);
}

TYPED_TEST(MovingWalls, ConveyorWithRollingFrictionTakesASphereToItsSpeed) {
  Law law;
  law.rolling = 0.05;
  const double belt = 0.3, dt = 1e-5;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = {0, 0, -kGravity};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ(), translation(Vec3(0.6, 0.8, 0), belt));
  add_sphere(scene, 2 * kRadius, {0.1, 0.2, kRadius - kMass * kGravity / softened(law, dt)});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  // 5/7 of the belt's speed are left to gain after sliding, at 5/7 mu_r g = 0.35 m/s^2: 0.61 s.
  run_until(world, stepper, 0.8);
  EXPECT_LT((velocity_of(world, 0) - belt * Vec3(0.6, 0.8, 0)).norm(), 1e-8);
  EXPECT_LT(kRadius * spin_of(world, 0).norm(), 1e-8);
}

TYPED_TEST(MovingWalls, SphereOnAShakerFollowsIt) {
  const Law law;
  const double dt = 1e-5, amplitude = 1e-3, rate = 2 * kPi * 10;
  Motion shake;
  shake.kind = MotionKind::kOscillation;
  shake.axis = Vec3::UnitZ();
  shake.amplitude = amplitude;
  shake.frequency = 10;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = {0, 0, -kGravity};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ(), shake);
  const double kn = softened(law, dt), overlap = kMass * kGravity / kn;
  add_sphere(scene, 2 * kRadius, {0.1, 0.2, kRadius - overlap}, {0, 0, amplitude * rate});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  double worst_place = 0, worst_force = 0;
  while (world.time() < 0.2) {
    const double t = world.time();  // at which the next step takes its forces
    const double height = place_of(world, 0).z();
    stepper.step();
    if (t < 0.01) continue;
    const double push = kGravity - amplitude * rate * rate * std::sin(rate * t);
    const double wall = amplitude * std::sin(rate * t);
    worst_place = std::max(worst_place, std::abs(height - wall - kRadius + kMass * push / kn));
    worst_force = std::max(worst_force, std::abs(world.wall_totals[0].force[2] / kMass + push));
  }
  // The spring swings 750 times faster than the shaker: quasi-static to w_s / w = 1.3e-3 (times
  // 2 zeta, the dashpot's share) of the changing part, A w_s^2.
  const double share = 2 * 0.26 * rate / std::sqrt(law.kn / kMass) * 1.2;
  EXPECT_LT(worst_force, share * amplitude * rate * rate);
  EXPECT_LT(worst_place, 2 * share * kMass * amplitude * rate * rate / kn + 1e-6 * overlap);
}

// A sphere in the corner of shell and end of a drum, pushed against the end while its springs are
// empty. When the push has slowly gone, friction holds a sixth of it: along the axis at the shell,
// radially at the end, with equal moments, for which friction has to be over 1.
template <class Real>
struct Centrifuge {
  static constexpr double kRate = 600 * 2 * kPi / 60;  // rad/s
  static constexpr double kPush = 100;                 // m/s^2, a fifth of the centrifugal one
  World<Real> world;

  static Scene scene() {
    Law law;
    law.kn = 1e5;  // of the lab mill
    law.kt = 4e4;
    law.restitution = 0.3;
    law.sliding = 2;
    const double dt = 1e-5;
    Scene scene = small_scene(law, dt);
    scene.domain.low.reset();
    scene.domain.high.reset();
    MillSpec mill;
    mill.material = "ore";
    mill.diameter = 0.3;
    mill.length = 0.04;
    mill.pieces_per_arc = 72;
    mill.rotation.points = {{0, kRate}};
    scene.mill = mill;
    // In the groove between two of the 72 pieces, at angle 0 (the middle of a piece is a hill to
    // what is flung outwards), and touching the end z = 0.
    const double half_turn = kPi / 72, shell = 0.15 * std::cos(half_turn);
    const double kn = softened(law, dt), at = (shell - kRadius) / std::cos(half_turn);
    const double push = kMass * kRate * kRate * at / (2 * kn);
    const Vec3 place(at + push, 0, kRadius - kMass * kPush / kn);
    const Vec3 spin(0, 0, kRate);
    add_sphere(scene, 2 * kRadius, place, spin.cross(place), spin);
    return scene;
  }

  // Springs of all contacts in the frame of the mill.
  std::vector<Vec3> springs() const {
    std::vector<Vec3> all;
    for (const WallSpring& s : world.tile_walls[0].springs) {
      const Body& body = world.bodies[world.walls[s.wall].body];
      all.push_back(body.pose.rotation.transpose() * s.spring);
    }
    return all;
  }
};

TYPED_TEST(MovingWalls, CentrifugedSphereKeepsItsSpringOverTenTurns) {
  Centrifuge<TypeParam> drum{world_of<TypeParam>(Centrifuge<TypeParam>::scene())};
  World<TypeParam>& world = drum.world;
  // One turn after the start, which the walls make from rest, with a jolt.
  world.clock.step = 10000;
  Stepper<TypeParam> stepper(world, 1);
  for (int k = 0; k < 4000; ++k) {
    world.gravity = {0, 0, -drum.kPush * std::min(1.0, (4000 - k) / 3000.0)};
    stepper.step();
  }
  world.gravity = Vec3::Zero();
  // Rocking about the radius is the softest mode, it rings for two seconds.
  run_until(world, stepper, 3.1);
  const std::vector<Vec3> start = drum.springs();
  ASSERT_EQ(start.size(), 3u);
  for (const Vec3& spring : start) ASSERT_GT(spring.norm(), 1e-6);
  double longer = 0, turned = 0;
  for (int turn = 1; turn <= 10; ++turn) {
    run_until(world, stepper, 3.1 + 0.1 * turn);
    const std::vector<Vec3> now = drum.springs();
    ASSERT_EQ(now.size(), 3u) << turn;
    for (std::size_t k = 0; k < 3; ++k) {
      longer = std::max(longer, std::abs(now[k].norm() / start[k].norm() - 1));
      turned = std::max(turned, (now[k] - start[k]).norm() / start[k].norm());
    }
  }
  std::printf("  springs of %.3g ... %.3g m: length off by %.2g, direction by %.2g\n",
              start.front().norm(), start.back().norm(), longer, turned);
  EXPECT_LT(longer, 1e-6);  // the acceptance limit
  EXPECT_LT(turned, 1e-5);  // spin about the normal: theta^3 / 6 a step, 4e-6 over 1e5 steps
}

// Work booked on the walls against the integral of -torque x omega, with any schedule.
TYPED_TEST(MovingWalls, WorkOfAMillIsTheIntegralOfTorqueTimesRate) {
  for (const bool ramp : {false, true}) {
    Scene scene = shipped_scene("lab_mill_spheres", {"run.settle=none", "mill.rotation=60 rpm"});
    if (ramp) scene.mill->rotation.points = {{0, 0}, {0.1, 8}, {0.2, 3}};
    World<TypeParam> world = world_of<TypeParam>(scene);
    Stepper<TypeParam> stepper(world, 1);
    const auto torque_of = [&] {
      return world.wall_totals[0].torque[2] + world.wall_totals[1].torque[2];
    };
    stepper.step();
    double torque = torque_of(), integral = 0;
    while (world.time() < 0.2) {
      const double between = world.time() - 0.5 * world.clock.dt;
      stepper.step();
      const double next = torque_of();
      integral -=
          0.5 * (torque + next) * world.clock.dt * schedule_value(scene.mill->rotation, between);
      torque = next;
    }
    ASSERT_GT(integral, 1e-3);
    // The force before works on the chord that begins at its point, the force now on the one that
    // ends at its own: what chords differ from w x r cancels but for (w dt)^2 = 4e-9. One chord for
    // both would give 3e-6, w x r in place of chords 1.3e-4.
    const double off = world.ledger.wall_work / integral - 1;
    std::printf("  %s: work over integral - 1 = %.2g\n", ramp ? "ramp" : "constant rate", off);
    EXPECT_NEAR(off, 0, 2e-8);
  }
}

// A closed box shakes, turns or travels with the spheres in it; the domain that the walls give
// reaches wherever they go, so nobody is taken for lost.
TEST(MovingBox, TakesItsSpheresAlong) {
  Motion turning, shaking, travelling;
  turning.kind = MotionKind::kRotation;
  turning.axis = Vec3::UnitY();
  turning.center = Vec3(0, 0, -0.1);
  turning.rate = {{{0, 2 * kPi * 2}}};
  shaking.kind = MotionKind::kOscillation;
  shaking.axis = Vec3::UnitX();
  shaking.amplitude = 0.05;
  shaking.frequency = 5;
  travelling.kind = MotionKind::kTranslation;
  travelling.axis = Vec3::UnitZ();
  travelling.rate = {{{0, 0}, {0.2, 2}, {0.3, -1}}};
  for (const Motion& motion : {turning, shaking, travelling}) {
    Scene scene = small_scene({1e5, 4e4, 0.5, 0.3}, 2e-5);
    scene.domain = {};
    scene.run.duration = 0.4;
    scene.run.gravity = Vec3(0, 0, -9.81);
    scene.boxes = {{"box", "ore", Vec3::Constant(-0.05), Vec3::Constant(0.05), false, motion}};
    for (int k = 0; k < 27; ++k) {
      add_sphere(scene, 0.02, 0.025 * Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));  // NOLINT: rows
    }
    World<float> world = world_of<float>(scene);
    Stepper<float> stepper(world, 1);
    while (world.time() < 0.4) {
      const StepReport report = stepper.step();
      ASSERT_EQ(report.bits & kFatalBits, 0u) << world.time();
    }
    const Pose pose = pose_at(motion, world.time());
    for (const Record<float>& r : world.particles.record) {
      const Vec3 x = pose.rotation.transpose() * (Vec3(r.x, r.y, r.z) - pose.shift);
      EXPECT_LT(x.cwiseAbs().maxCoeff(), 0.045);
    }
  }
}

}  // namespace
}  // namespace quern::test
