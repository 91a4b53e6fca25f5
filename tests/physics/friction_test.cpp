// Friction of a single sphere on a plane, and motion without contacts, against closed forms.
//
// Spheres start at the overlap at which they rest, so that the normal force is the weight from the
// first step on; radii are powers of two, exact in f32. Velocities of the engine belong to the half
// step before its time: closed forms are taken at t - dt / 2.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/laws/damping.h"
#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

constexpr double kRadius = 1.0 / 128, kGravity = 9.81, kDt = 1e-6;
const double kMass = sphere_mass(2 * kRadius);

template <class Real>
class Friction : public testing::Test {};
TYPED_TEST_SUITE(Friction, Precisions, Names);
template <class Real>
class Flight : public testing::Test {};
TYPED_TEST_SUITE(Flight, Precisions, Names);

// A plane z = 0 inclined by `angle` towards +x, as gravity sees it; one sphere rests on it.
Scene incline(const Law& law, double angle, const Vec3& velocity, const Vec3& spin,
              double dt = kDt) {
  Scene scene = small_scene(law, dt);
  scene.run.gravity = kGravity * Vec3(std::sin(angle), 0, -std::cos(angle));
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  // At rest the scheme's spring is kn / (1 + zeta w dt).
  const double zeta = damping_ratio(law.restitution, law.normal_force);
  const double soft = 1 + zeta * std::sqrt(law.kn / kMass) * dt;
  const double overlap = kMass * kGravity * std::cos(angle) * soft / law.kn;
  // Away from the edge between the triangles of the plane.
  add_sphere(scene, 2 * kRadius, {0.0625, 0.03125, kRadius - overlap}, velocity, spin);
  return scene;
}

// In `mixed` mass and spin are rounded to 6e-8; overlap over radius, in arms, is 6e-7.
constexpr double kRounding = 2e-6;

TYPED_TEST(Friction, SlidingSphereRollsAfterTwoSeventhsOfV0OverMuG) {
  const Law law;
  const double v0 = 1, mu = law.sliding, turn = 2 * v0 / (7 * mu * kGravity);
  World<TypeParam> world = world_of<TypeParam>(incline(law, 0, {v0, 0, 0}, Vec3::Zero()));
  Stepper<TypeParam> stepper(world, 1);
  for (double t = 0.1 * turn; t < 1.6 * turn; t += 0.1 * turn) {
    run_until(world, stepper, t);
    const double at = world.time() - 0.5 * kDt;
    const double speed = velocity_of(world, 0).x(), rim = kRadius * spin_of(world, 0).y();
    if (t < 0.99 * turn) {
      EXPECT_NEAR(speed, v0 - mu * kGravity * at, kRounding * v0) << t / turn;
      EXPECT_NEAR(rim, 2.5 * mu * kGravity * at, kRounding * v0) << t / turn;
    } else if (t > 1.05 * turn) {
      EXPECT_NEAR(speed, 5 * v0 / 7, kRounding * v0) << t / turn;
      EXPECT_NEAR(rim, 5 * v0 / 7, kRounding * v0) << t / turn;
    }
  }
}

TYPED_TEST(Friction, OnAnInclineSphereRollsBelowSevenHalvesMuAndSlidesAbove) {
  const Law law;
  const double mu = law.sliding, limit = std::atan(3.5 * mu);
  for (const double angle : {0.1, 0.5 * limit, limit - 0.02, limit + 0.02, 1.3}) {
    World<TypeParam> world = world_of<TypeParam>(incline(law, angle, Vec3::Zero(), Vec3::Zero()));
    Stepper<TypeParam> stepper(world, 1);
    run_until(world, stepper, 0.02);
    const double at = world.time() - 0.5 * kDt, down = kGravity * std::sin(angle);
    const double grip = mu * kGravity * std::cos(angle);
    const double speed = velocity_of(world, 0).x(), rim = kRadius * spin_of(world, 0).y();
    if (angle < limit) {
      // What the spring does while it takes up the load is damped away; the moment about the
      // contact is exact.
      EXPECT_NEAR(speed / (5.0 / 7 * down * at), 1, kRounding) << angle;
      EXPECT_NEAR(rim / speed, 1, kRounding) << angle;
    } else {
      // Until the spring is at the cone, at most half a swing of the tangential mode, friction is
      // below its final value.
      const double loading = normal_contact_time(kMass * 2 / 7, law.kt);
      EXPECT_NEAR(speed, (down - grip) * at, grip * loading + kRounding * speed) << angle;
      EXPECT_NEAR(rim, 2.5 * grip * at, 2.5 * grip * loading + kRounding * speed) << angle;
      EXPECT_GT(speed, rim) << angle;
    }
  }
}

TYPED_TEST(Friction, RollingFrictionStopsASphereWhereClosedFormSays) {
  Law law;
  law.rolling = 0.05;
  const double v0 = 0.2, slowing = 5.0 / 7 * law.rolling * kGravity, dt = 5e-6;
  World<TypeParam> world =
      world_of<TypeParam>(incline(law, 0, {v0, 0, 0}, {0, v0 / kRadius, 0}, dt));
  Stepper<TypeParam> stepper(world, 1);
  const double start = place_of(world, 0).x(), stop = v0 / slowing;
  run_until(world, stepper, 0.5 * stop);
  EXPECT_NEAR(velocity_of(world, 0).x(), 0.5 * v0, kRounding * v0 + slowing * dt);
  // When it stops the contact still holds the force that slowed it; its spring swings back, a
  // little.
  const double force = kMass * slowing, root = std::sqrt(law.kt * kMass * 2 / 7);
  const double swing = force / root;  // m/s, of the contact point
  double least = 1;
  while (world.time() < 1.2 * stop) {
    stepper.step();
    least = std::min(least, kRadius * spin_of(world, 0).y());
  }
  EXPECT_GT(least, -swing);
  EXPECT_LT(std::abs(velocity_of(world, 0).x()), 1e-9);
  EXPECT_LT(std::abs(kRadius * spin_of(world, 0).y()), 1e-9);
  // The load of the spring at first, while the sphere goes at v0: a swing of the tangential mode.
  const double distance = 0.5 * v0 * v0 / slowing;
  const double loading = v0 * swing / slowing;
  EXPECT_NEAR(place_of(world, 0).x() - start, distance, loading + kRounding * distance);
}

TYPED_TEST(Friction, RollingFrictionLeavesSpinAboutTheNormalAlone) {
  Law law;
  law.rolling = 0.05;
  World<TypeParam> world = world_of<TypeParam>(incline(law, 0, Vec3::Zero(), {0, 0, 40}, 5e-6));
  Stepper<TypeParam> stepper(world, 1);
  run_until(world, stepper, 0.05);
  EXPECT_EQ(spin_of(world, 0), Vec3(0, 0, 40));
}

TYPED_TEST(Friction, SphereAtRestStays) {
  Law law;
  law.rolling = 0.01;
  World<TypeParam> world = world_of<TypeParam>(incline(law, 0, Vec3::Zero(), Vec3::Zero(), 1e-5));
  Stepper<TypeParam> stepper(world, 1);
  const Vec3 start = place_of(world, 0);
  run_until(world, stepper, 0.1);
  // The weight is right to 6e-8 (f32 mass), the overlap is 5e-9 m; an ulp of the place is 9e-19 m.
  EXPECT_LT((place_of(world, 0) - start).norm(), 5e-9 * 2e-7);
  EXPECT_LT(velocity_of(world, 0).norm(), 1e-10);
}

TYPED_TEST(Flight, FreeFallIsTheDiscreteParabolaToRounding) {
  Scene scene = small_scene(Law(), 1e-4, 100);
  scene.run.gravity = {0.3, -9.81, 0.7};
  const Vec3 x0(0.1, 0.2, 0.3), v0(2, 3, -1), g = scene.run.gravity;
  add_sphere(scene, 2 * kRadius, x0, v0);
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  for (int n = 1; n <= 10000; ++n) {
    stepper.step();
    if (n % 500 != 0) continue;
    // With the half kick at the start the leapfrog's places are those of the parabola, its
    // velocities those of the half step before. One rounding a step, growing as a sum: n ulp of
    // 1e-16 times the size reached.
    const double t = n * 1e-4, half = t - 0.5e-4;
    const Vec3 v = v0 + half * g, x = x0 + t * v0 + 0.5 * t * t * g;
    const double ulps = n * 1.2e-16;
    EXPECT_LT((velocity_of(world, 0) - v).norm(), ulps * 12) << n;
    EXPECT_LT((place_of(world, 0) - x).norm(), ulps * 12) << n;
  }
}

TYPED_TEST(Flight, SpinWithoutContactIsConstantToTheBit) {
  Scene scene = small_scene(Law(), 1e-4, 100);
  scene.run.gravity = {0, 0, -9.81};
  const Vec3 spin(1.1, -2.3, 70.7);
  add_sphere(scene, 2 * kRadius, Vec3::Zero(), {1, 2, 3}, spin);
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  run_steps(world, stepper, 2000);
  EXPECT_EQ(spin_of(world, 0), spin);
}

TYPED_TEST(Flight, UniformMotionIsAStraightLine) {
  Scene scene = small_scene(Law(), 1e-3, 100);
  add_sphere(scene, 2 * kRadius, {-1, 0, 0}, {3, 1, -2});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  run_steps(world, stepper, 1000);
  EXPECT_EQ(velocity_of(world, 0), Vec3(3, 1, -2));
  EXPECT_LT((place_of(world, 0) - Vec3(2, 1, -2)).norm(), 1000 * 4e-16);
}

}  // namespace
}  // namespace quern::test
