// Impacts at 100 m/s on a liner plate of 2 mm: nothing passes through it unnoticed.
//
// At every stiffness and every step that a run accepts (4 steps per contact and more), at any phase
// of arrival, a body either comes back from the side that it came from or the step that would let
// it through says so: an overlap above the radius, or a way above the radius within a step.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/small_scene.h"
#include "tests/support/solids.h"

namespace quern::test {
namespace {

constexpr double kSpeed = 100, kThick = 0.002;

template <class Real>
class FastImpact : public testing::Test {};
TYPED_TEST_SUITE(FastImpact, Precisions, Names);

struct Outcome {
  int back = 0, told = 0, through = 0;
  int too_fast = 0, too_deep = 0;  // of those told
};

// From a metre above to where it is told of or gone by half a metre.
template <class Real>
void shoot(const Scene& scene, const std::vector<Triangle>& plate, double radius, Outcome& out) {
  World<Real> world = world_of<Real>(scene, {plate});
  Stepper<Real> stepper(world, 1);
  const bool sphere = world.polyhedra.empty();
  const int most = static_cast<int>(4 / (kSpeed * world.clock.dt)) + 4000000;
  for (int k = 0; k < most; ++k) {
    const StepReport report = stepper.step();
    if ((report.bits & kFatalBits) != 0) {
      EXPECT_EQ(report.first.id, 0u);
      EXPECT_EQ(report.first.partner_is_wall, (report.bits & kOutside) == 0);
      out.too_fast += (report.bits & kTooFast) != 0 ? 1 : 0;
      out.too_deep += (report.bits & kDeepOverlap) != 0 ? 1 : 0;
      out.told += 1;
      return;
    }
    const double z = sphere ? world.particles.record[0].z : world.polyhedra.z[0];
    const double vz = sphere ? world.particles.record[0].vz : world.polyhedra.vz[0];
    if (z < -kThick - radius) return void(out.through += 1);
    if (z > radius && vz > 0) return void(out.back += 1);
  }
  ADD_FAILURE() << "neither back nor through";
}

Scene impact(double diameter, double kn, double steps, double restitution, double phase) {
  Law law;
  law.kn = kn;
  law.kt = 0.4 * kn;
  law.restitution = restitution;
  const double dt = normal_contact_time(sphere_mass(diameter), kn) / steps;
  Scene scene = small_scene(law, dt, 8);
  add_mesh(scene, "plate");
  const double above = std::max(1.0, 1.5 * kSpeed * dt) + phase * kSpeed * dt;
  add_sphere(scene, diameter, {0.013, -0.021, diameter / 2 + std::min(above, 7.5)},
             {0, 0, -kSpeed});
  return scene;
}

std::vector<Triangle> thin_plate() {
  return box_solid(Vec3(-0.5, -0.5, -kThick), Vec3(0.5, 0.5, 0));
}

TYPED_TEST(FastImpact, OfASphereNeverPassesAPlateUnnoticed) {
  Outcome all;
  for (const double diameter : {0.015, 0.15}) {
    for (const double kn : {1e3, 1e5, 2e7, 1e9}) {
      for (const double steps : {4.0, 4.4, 10.0, 50.0}) {
        Outcome here;
        for (const double restitution : {0.01, 1.0}) {
          for (int phase = 0; phase < 5; ++phase) {
            const Scene scene = impact(diameter, kn, steps, restitution, (phase + 0.5) / 5);
            shoot<TypeParam>(scene, thin_plate(), diameter / 2, here);
          }
        }
        if (here.through > 0) {
          std::printf("  d %g, kn %g, %g steps: %d back, %d told, %d through\n", diameter, kn,
                      steps, here.back, here.told, here.through);
        }
        all.back += here.back;
        all.told += here.told;
        all.through += here.through;
        all.too_fast += here.too_fast;
        all.too_deep += here.too_deep;
      }
    }
  }
  std::printf("  %d came back, %d were told of (%d too fast, %d too deep), %d passed\n", all.back,
              all.told, all.too_fast, all.too_deep, all.through);
  EXPECT_EQ(all.through, 0);
  EXPECT_GT(all.back, 50);
  EXPECT_GT(all.too_fast, 50);
  EXPECT_GT(all.too_deep, 10);
}

// Slow enough for its step it is nobody's business, fast or not, far from walls or near them.
TYPED_TEST(FastImpact, IsNotToldOfWhatOnlyFliesFast) {
  Scene scene = impact(0.015, 2e7, 10, 0.5, 0);
  scene.run.time_step = 0.9 * 0.0075 / kSpeed;
  scene.particles[0].explicit_particles[0].position = Vec3(2, 0, 7);  // past the plate
  scene.particles[0].explicit_particles[0].velocity = Vec3(0, 0, -3 * kSpeed);
  World<TypeParam> world = world_of<TypeParam>(scene, {thin_plate()});
  Stepper<TypeParam> stepper(world, 1);
  run_steps(world, stepper, 500);  // 10 m, three radii a step
  EXPECT_LT(world.particles.record[0].z, -2);
}

// A polyhedron's overlap with a wall ends at its inner radius, so that one may be pressed through a
// plate thinner than that, or stick in it. Then each of these steps has said so (kOverlapWarning),
// if it was not too fast for them anyway.
TYPED_TEST(FastImpact, OfAPolyhedronNeverPassesAPlateUncounted) {
  Outcome all;
  int counted = 0, stuck = 0;
  for (const double kn : {1e5, 2e7, 1e9}) {
    for (const double steps : {4.0, 10.0}) {
      for (int phase = 0; phase < 3; ++phase) {
        Scene scene = impact(0.05, kn, 2 * steps, 0.5, (phase + 0.5) / 3);
        scene.folder = QUERN_SOURCE_DIR "/apps/shapes";
        scene.particles[0].shape = ShapeKind::kPolyhedron;
        scene.particles[0].meshes = {phase == 0 ? "cube.stl" : "rock_flat_12.stl"};
        Outcome here;
        World<TypeParam> world = world_of<TypeParam>(scene, {thin_plate()});
        Stepper<TypeParam> stepper(world, 1);
        std::uint64_t warnings = 0;
        for (int k = 0; k < 40000; ++k) {
          const StepReport report = stepper.step();
          warnings += report.warnings;
          if ((report.bits & kFatalBits) != 0) {
            here.told += 1;
            break;
          }
          if (world.polyhedra.z[0] < -0.05) {
            here.through += 1;
            break;
          }
          if (world.polyhedra.vz[0] > 0 && world.polyhedra.z[0] > 0.05) {
            here.back += 1;
            break;
          }
        }
        if (here.back + here.told + here.through == 0) stuck += 1;
        if (here.back + here.told == 0) counted += warnings > 0 ? 1 : 0;
        all.back += here.back;
        all.told += here.told;
        all.through += here.through;
      }
    }
  }
  std::printf("  %d came back, %d were told of, %d passed, %d stuck, %d of these counted\n",
              all.back, all.told, all.through, stuck, counted);
  EXPECT_EQ(counted, all.through + stuck);
  EXPECT_GT(all.back, 0);
  EXPECT_GT(all.told, 0);
}

}  // namespace
}  // namespace quern::test
