// The fewest steps per contact that keep a dense packing at rest, walls included.
//
// The measured limits of the damping scheme (kernels/README.md): packings of 15-25 mm and of 15 mm
// only, with tangential damping and without. An independent small code found 2.8 and 2.6 for the
// mix, 4.0 and 3.8 for equal spheres, in steps of about a tenth; the trial looks at a coarser row
// of steps, so a limit may be met one entry later. What a run at 4.4 steps relies on is checked:
// all four packings come to rest there.
#include <gtest/gtest.h>

#include <cstdio>

#include "scheduler/trial.h"

namespace quern::test {
namespace {

Scene ore_scene(bool tangential_damping) {
  Scene scene;
  scene.materials.push_back({"ore", 4500, 0});
  scene.contact.normal_stiffness = 2e7;
  scene.contact.tangential_stiffness = 8e6;
  scene.contact.restitution = 0.3;
  scene.contact.sliding_friction = 0.5;
  scene.contact.tangential_damping = tangential_damping;
  return scene;
}

double limit_of(double to, bool tangential_damping) {
  TrialSpec spec;
  spec.from = 0.015;
  spec.to = to;
  spec.material = spec.wall_material = "ore";
  const StabilityTrial trial = measure_stability(ore_scene(tangential_damping), spec);
  std::printf("  15-%g mm, tangential damping %s: at rest down to %g steps per contact\n", 1e3 * to,
              tangential_damping ? "on" : "off", trial.limit);
  for (const StabilityPoint& p : trial.points) {
    std::printf("    %4.1f steps: median %.1e J a particle\n", p.steps_per_contact, p.energy);
  }
  return trial.limit;
}

TEST(SlowStabilityLimits, OfDensePackingsLieBelowTheStepOfTheSagMill) {
  for (const double to : {0.025, 0.015}) {
    for (const bool damping : {true, false}) {
      const double limit = limit_of(to, damping);
      EXPECT_GT(limit, 0) << "nothing held";
      EXPECT_LE(limit, 4.4);
    }
  }
}

// A soft packing without tangential damping swings for seconds once it has been set going: the
// trial must begin with one in which all but rattlers rest.
TEST(StabilityLimits, AreFoundForSoftSpringsOfHertzMindlin) {
  Scene scene;
  Material charge = {"charge", 1190, 0};
  charge.young_modulus = 5e7;
  charge.poisson_ratio = 0.3;
  scene.materials.push_back(charge);
  scene.contact.law = ForceLaw::kHertzMindlin;
  scene.contact.normal_force = NormalForce::kUnclamped;
  scene.contact.tangential_damping = false;
  scene.contact.restitution = 0.65;
  scene.contact.sliding_friction = 0.3;
  scene.contact.impact_speed = 2.43;
  TrialSpec spec;
  spec.from = spec.to = 0.01375;
  spec.material = spec.wall_material = "charge";
  const double limit = measure_stability(scene, spec).limit;
  EXPECT_GT(limit, 0) << "nothing held";
  EXPECT_LE(limit, 6.5);
}

}  // namespace
}  // namespace quern::test
