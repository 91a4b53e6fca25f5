// The law and the step at the ends of what a scene may ask for: sizes 1:100 and masses 1:1e6,
// stiffness 1e3 ... 1e10 N/m, restitution 0.01 ... 1, friction 0 ... 10, none, one and two
// particles, stacks of 50 bodies, a column of 20 m.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/laws/damping.h"
#include "kernels/tally.h"
#include "scheduler/check_lists.h"
#include "tests/support/small_scene.h"
#include "tests/support/test_walls.h"

namespace quern::test {
namespace {

template <class Real>
class Extremes : public testing::Test {};
TYPED_TEST_SUITE(Extremes, Precisions, Names);

template <class Real>
constexpr double kUlp = sizeof(Real) == 4 ? 6e-8 : 1.1e-16;

template <class Real>
double kinetic(const World<Real>& world) {
  return world.totals.translational + world.totals.rotational;
}

// A sphere of 1 m hits one of 10 mm, a millionth of its mass, which flies off at (1 + e) times the
// speed but for that millionth. The delivered restitution is right to 3e-3 at 50 steps per contact
// (Restitution.*); what the large one loses is a millionth of its momentum, told to 1e-3 of that.
TYPED_TEST(Extremes, ASphereThrowsOneOfAMillionthOfItsMass) {
  Law law;
  law.restitution = 0.5;
  const double small = 0.01, mass = sphere_mass(small), speed = 0.5;
  Scene scene = small_scene(law, normal_contact_time(mass, law.kn) / 50);
  add_sphere(scene, 1, {0, 0, 0}, {speed, 0, 0});
  add_sphere(scene, small, {0.5 + 0.5 * small + 1e-5, 0, 0});
  EXPECT_NEAR(sphere_mass(1) / mass, 1e6, 1e-3);
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  run_steps(world, stepper, 600);
  EXPECT_EQ(world.totals.pair_contacts, 0);
  const double small_speed = velocity_of(world, 1).x(), lost = speed - velocity_of(world, 0).x();
  EXPECT_NEAR(small_speed / speed, 1.5, 3e-3);
  EXPECT_NEAR(lost * sphere_mass(1) / (mass * small_speed), 1, 1e-3);
}

// A sphere of 1 m comes to rest on a bed of spheres of 10 mm, in a box: the lists of a grid with a
// size ratio of 100 miss no contact, the account closes, and the floor carries the weight of all.
TYPED_TEST(Extremes, ASphereSettlesOnABedOfAHundredthOfItsSize) {
  Law law;
  law.restitution = 0.2;
  const double small = 0.01, dt = normal_contact_time(0.5 * sphere_mass(small), law.kn) / 12;
  Scene scene = small_scene(law, dt, 1.5);
  scene.run.gravity = Vec3(0, 0, -9.81);
  scene.run.tile_size = 16;
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  for (int k = 0; k < 37; ++k) {
    const Vec3 at(0.0102 * (k % 6 - 2.5), 0.0102 * (k / 6 - 2.5), 0);
    add_sphere(scene, small, at + Vec3(0, 0, 0.00501));
  }
  add_sphere(scene, 1, {0.002, 0.001, 0.51});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  world.drag = std::exp(-40 * dt);
  for (int k = 0; k < 25; ++k) {
    run_steps(world, stepper, 10000);
    for (const std::string& line : missed_contacts(world)) ADD_FAILURE() << line;
  }
  world.drag = 1;
  double force = 0;
  for (int k = 0; k < 1000; ++k) {
    run_steps(world, stepper, 1);
    force -= world.wall_totals[0].force[2] / 1000;
  }
  std::printf("  floor %.9g of the weight, kinetic energy %.2g J\n",
              force / (9.81 * world.total_mass), kinetic(world));
  EXPECT_NEAR(force / (9.81 * world.total_mass), 1, 1e-3);
  // To lift the large one by a thousandth of a small radius takes 0.1 J.
  EXPECT_LT(kinetic(world), 1e-4);
  EXPECT_EQ(world.clock.warnings, 0u);
}

// A sphere on a plate 3 m from the origin at every stiffness. What it bounces with is the
// restitution, whatever the stiffness: overlaps of a hundredth of the radius and 50 steps per
// contact, as in Restitution.*. At rest it stays within what the rounding of its place can do: a
// push of k ulp in each step, that is a speed of ulp w, over the damping of a contact.
TYPED_TEST(Extremes, AnyStiffnessBouncesAndRestsAlike) {
  const double diameter = 1.0 / 64, mass = sphere_mass(diameter), ulp = 4.5e-16;
  for (double kn = 1e3; kn < 2e10; kn *= 10) {
    SCOPED_TRACE(kn);
    Law law;
    law.kn = kn;
    law.kt = 0.4 * kn;
    const double frequency = std::sqrt(kn / mass);
    const double dt = kPi / frequency / 50, speed = 0.005 * diameter * frequency;
    Scene scene = small_scene(law, dt);
    add_plane(scene, {0, 0, 3}, Vec3::UnitZ());
    add_sphere(scene, diameter, {0, 0, 3 + diameter / 2 + 0.3 * speed * dt}, {0, 0, -speed});
    World<TypeParam> bouncing = world_of<TypeParam>(scene);
    Stepper<TypeParam> bounce(bouncing, 1);
    run_steps(bouncing, bounce, 60);
    EXPECT_NEAR(velocity_of(bouncing, 0).z() / speed, 0.5, 3e-3);

    scene.run.gravity = Vec3(0, 0, -9.81);
    ExplicitParticle& sphere = scene.particles[0].explicit_particles[0];
    sphere = {{0, 0, 3 + diameter / 2 - 9.81 * mass / kn}, Vec3::Zero(), Vec3::Zero(), diameter};
    World<TypeParam> resting = world_of<TypeParam>(scene);
    Stepper<TypeParam> rest(resting, 1);
    run_steps(resting, rest, 20000);
    double most = 0;
    for (int k = 0; k < 1000; ++k) {
      run_steps(resting, rest, 1);
      most = std::max(most, velocity_of(resting, 0).norm());
    }
    EXPECT_LT(most, 10 * ulp * frequency);
    // In mixed the mass is rounded too.
    EXPECT_NEAR(resting.wall_totals[0].force[2], -9.81 * mass,
                10 * kn * ulp + 9.81 * mass * kUlp<TypeParam>);
  }
}

// Clamped contacts deliver what they are asked for down to e^-2 and e^-2 below (the reader warns of
// that, SceneReader.*), unclamped ones deliver any; 50 steps per contact, bounds of Restitution.*.
TYPED_TEST(Extremes, RestitutionIsDeliveredFromAHundredthToOne) {
  const double diameter = 1.0 / 64, mass = sphere_mass(diameter);
  for (const NormalForce mode : {NormalForce::kClamped, NormalForce::kUnclamped}) {
    for (const double e : {0.01, 0.05, 0.12, 0.15, 0.5, 0.99, 1.0}) {
      SCOPED_TRACE(e);
      Law law;
      law.normal_force = mode;
      law.restitution = e;
      const double dt = normal_contact_time(mass, law.kn) / 50;
      double mean = 0;
      constexpr int kPhases = 20;
      for (int phase = 0; phase < kPhases; ++phase) {
        Scene scene = small_scene(law, dt);
        add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
        const double gap = (phase + 0.5) / kPhases * 0.5 * dt;
        add_sphere(scene, diameter, {0, 0, diameter / 2 + gap}, {0, 0, -0.5});
        World<TypeParam> world = world_of<TypeParam>(scene);
        Stepper<TypeParam> stepper(world, 1);
        // Near critical damping a contact that does not pull lasts long.
        for (int k = 0; k < 2000 && (k < 5 || world.totals.wall_contacts > 0); ++k) {
          run_steps(world, stepper, 1);
        }
        mean += velocity_of(world, 0).z() / 0.5 / kPhases;
      }
      const double least = mode == NormalForce::kClamped ? kLeastClampedRestitution : 0;
      EXPECT_NEAR(mean, std::max(e, least), e < 0.2 ? 6e-3 : 3e-3);
    }
  }
}

// A heap of spheres in a box at any friction: nothing heats, no part of the account gives energy
// back, and it closes.
TYPED_TEST(Extremes, FrictionFromNoneToTenLosesEnergyOnly) {
  for (const double mu : {0.0, 0.3, 2.0, 10.0}) {
    SCOPED_TRACE(mu);
    Law law;
    law.kn = 1e5;
    law.kt = 4e4;
    law.restitution = 0.3;
    law.sliding = mu;
    const double d = 0.015, dt = normal_contact_time(0.5 * sphere_mass(d), law.kn) / 15;
    Scene scene = small_scene(law, dt, 0.2);
    scene.run.gravity = Vec3(0, 0, -9.81);
    BoxSpec box;
    box.name = "box";
    box.material = "ore";
    box.low = Vec3(-0.03, -0.03, 0);
    box.high = Vec3(0.03, 0.03, 0.15);
    scene.boxes = {box};
    Random random(3);
    for (int k = 0; k < 54; ++k) {
      const Vec3 cell(0.018 * (k % 3 - 1), 0.018 * (k / 3 % 3 - 1), 0.012 + 0.018 * (k / 9));
      add_sphere(scene, d, cell + random.in_cube(1e-3), random.in_cube(0.5), random.in_cube(50));
    }
    World<TypeParam> world = world_of<TypeParam>(scene);
    Stepper<TypeParam> stepper(world, 1);
    double dissipated = 0, slid = 0;
    while (world.time() < 1.5) {
      run_steps(world, stepper, 100);
      const Ledger& l = world.ledger;
      // Single steps of the normal part may give back a thousandth, as the scheme has it.
      EXPECT_GE(l.dissipated(), dissipated * (1 - 1e-6));
      EXPECT_GE(l.slide, slid * (1 - 1e-9));
      dissipated = l.dissipated();
      slid = l.slide;
    }
    std::printf("  mu %-3g kinetic energy %.2g J of %.2g J dissipated, slid %.2g J, error %.1g\n",
                mu, kinetic(world), dissipated, slid, ledger_error(world.ledger));
    EXPECT_LT(ledger_error(world.ledger), 1e-5);  // walls of several planes: tests/README.md
    EXPECT_EQ(slid > 0, mu > 0);
    // At rest but for one or two of 54 that still roll. Without friction they spin as they did.
    EXPECT_LT(mu > 0 ? kinetic(world) : world.totals.translational, 1e-4 * dissipated);
  }
}

// A scene of no particle is refused; one whose particles are still to rain in steps without any.
TYPED_TEST(Extremes, NoParticleIsNoSceneButMayBeYetToCome) {
  Scene scene = small_scene(Law(), 1e-5);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_sphere(scene, 1.0 / 64, {0, 0, 1});
  const std::vector<ParticleSeed> later = draw_sizes(scene);
  World<TypeParam> world =
      make_world<TypeParam>(scene, build_geometry(scene, {}, later), later, {}, {});
  Stepper<TypeParam> stepper(world, 2);
  run_steps(world, stepper, 100);
  EXPECT_EQ(world.clock.step, 100u);
  EXPECT_EQ(world.particles.size(), 0u);
  EXPECT_EQ(kinetic(world), 0);
  scene.particles.clear();
  EXPECT_THROW(world_of<TypeParam>(scene), UserError);
}

// One that falls on a plate bounces by the restitution, alone in its tile, whatever the threads.
TYPED_TEST(Extremes, OneParticleIsAScene) {
  Scene scene = small_scene(Law(), 1e-6);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_sphere(scene, 1.0 / 64, {0, 0, 1.0 / 128 + 1e-6}, {0, 0, -1});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 3);
  run_steps(world, stepper, 200);
  EXPECT_NEAR(velocity_of(world, 0).z(), 0.5, 3e-3);
  EXPECT_LT(ledger_error(world.ledger), 1e-6);
}

// Two spheres in one place have no normal: the step says that they overlap by all there is and who
// they are, and makes no number that is not finite.
TYPED_TEST(Extremes, TwoInOnePlaceAreNamed) {
  Scene scene = small_scene(Law(), 1e-6);
  for (int k = 0; k < 2; ++k) add_sphere(scene, 1.0 / 64, {0.25, 0.5, 0.125});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  const StepReport report = stepper.step();
  EXPECT_EQ(report.bits & kFatalBits, std::uint32_t{kDeepOverlap});
  EXPECT_NEAR(report.max_overlap, 2, 1e-6);
  EXPECT_EQ(report.first.id + report.first.partner, 1u);
  for (const Index id : {0u, 1u}) EXPECT_EQ(velocity_of(world, id), Vec3::Zero());
}

// Overlap under a force at rest: the implicit damping takes 1 + zeta w dt off the spring.
double rest_overlap(const Law& law, double force, double inverse_reduced_mass, double dt) {
  const double zeta = damping_ratio(law.restitution, law.normal_force);
  const double a = 2 * zeta * std::sqrt(law.kn) * std::sqrt(inverse_reduced_mass);
  return force / law.kn * (1 + 0.5 * dt * a);
}

// A stack in its equilibrium. Returns the scene; heights of the centres, from below.
Scene stack_of_spheres(int count, double diameter, const Law& law, double dt,
                       std::vector<double>& heights) {
  Scene scene = small_scene(law, dt, 25);
  scene.run.gravity = Vec3(0, 0, -9.81);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  const double mass = sphere_mass(diameter);
  double z = 0;
  for (int k = 0; k < count; ++k) {
    const double weight = 9.81 * mass * (count - k);
    z += (k == 0 ? 0.5 : 1) * diameter - rest_overlap(law, weight, (k == 0 ? 1 : 2) / mass, dt);
    heights.push_back(z);
    add_sphere(scene, diameter, {0, 0, z});
  }
  return scene;
}

struct Held {
  double highest = 0;  // m/s, of any body
  double moved = 0;    // m, of any centre
  double floor = 0;    // force over the weight
};

template <class Real>
Held hold(const Scene& scene, const std::vector<double>& heights, int steps) {
  World<Real> world = world_of<Real>(scene);
  Stepper<Real> stepper(world, 1);
  Held held;
  for (int k = 0; k < steps; ++k) {
    run_steps(world, stepper, 1);
    if (k % 10 != 0) continue;
    for (std::size_t row = 0; row < heights.size(); ++row) {
      const Vec3 v = velocity_of(world, static_cast<Index>(row));
      const Vec3 x = place_of(world, static_cast<Index>(row));
      held.highest = std::max(held.highest, v.norm());
      held.moved = std::max(held.moved, (x - Vec3(0, 0, heights[row])).norm());
    }
  }
  held.floor = -world.wall_totals[0].force[2] / (scene.run.gravity.norm() * world.total_mass);
  return held;
}

// A stack of 50 spheres that stands in its equilibrium stays: the forces in `mixed` are rounded to
// 6e-8, so a body feels up to 50 weights x 6e-8 more or less, g x 3e-6, which pushes the stack,
// whose slowest swing takes 64 contact times of a pair, by a few 1e-6 of its own shortening.
TYPED_TEST(Extremes, AStackOfFiftySpheresStands) {
  Law law;
  law.kn = 1e6;
  const double d = 1.0 / 64, dt = normal_contact_time(0.5 * sphere_mass(d), law.kn) / 10;
  std::vector<double> heights;
  const Scene scene = stack_of_spheres(50, d, law, dt, heights);
  const Held held = hold<TypeParam>(scene, heights, 20000);
  const double shortening = 50 * d - d / 2 - heights.back();
  std::printf("  moved %.2g of the shortening (%.2g m), fastest %.2g m/s, floor 1 %+.1g\n",
              held.moved / shortening, shortening, held.highest, held.floor - 1);
  EXPECT_LT(held.moved, (sizeof(TypeParam) == 4 ? 1e-5 : 1e-9) * shortening);
  EXPECT_NEAR(held.floor, 1, sizeof(TypeParam) == 4 ? 1e-5 : 1e-9);
}

// A column of 20 m of spheres of 0.1 m under its own weight: at the top, 20 m from the origin, a
// sphere rests on 1.2e-7 of its radius, the lowest ones on 200 times that. The same bounds as above
// with 200 weights.
TYPED_TEST(Extremes, AColumnOfTwentyMetresStands) {
  Law law;
  const double d = 0.125, dt = normal_contact_time(0.5 * sphere_mass(d), law.kn) / 10;
  std::vector<double> heights;
  const Scene scene = stack_of_spheres(160, d, law, dt, heights);
  const Held held = hold<TypeParam>(scene, heights, 40000);
  const double shortening = 160 * d - d / 2 - heights.back();
  std::printf("  moved %.2g of the shortening (%.2g m), fastest %.2g m/s, floor 1 %+.1g\n",
              held.moved / shortening, shortening, held.highest, held.floor - 1);
  EXPECT_GT(heights.back(), 19.9);
  EXPECT_LT(held.moved, (sizeof(TypeParam) == 4 ? 1e-4 : 1e-8) * shortening);
  EXPECT_NEAR(held.floor, 1, sizeof(TypeParam) == 4 ? 1e-4 : 1e-8);
}

}  // namespace
}  // namespace quern::test
