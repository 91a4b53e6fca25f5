// Steps of springs that stiffen: contact time of an impact, Rayleigh's wave, the step that follows.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/laws/damping.h"
#include "tests/support/build_world.h"

namespace quern {
namespace {

const std::vector<std::string> kPlain = {"run.settle=none"};

StepAdvice advice_for(const Scene& scene, const std::string& a, const std::string& b) {
  for (const StepAdvice& row : advise_steps(scene, draw_sizes(scene), 1)) {
    if (row.a == a && row.b == b) return row;
  }
  ADD_FAILURE() << "no advice for " << a << " and " << b;
  return {};
}

TEST(HertzAdvice, TakesTheFallThroughTheMillForTheSpeedOfImpacts) {
  Scene scene = shipped_scene("lab_mill_hertz", kPlain);
  EXPECT_DOUBLE_EQ(typical_speed(scene), std::sqrt(2 * 9.81 * 0.3));
  scene.mill->rotation.points = {{0, 0}, {1, -30}};  // rad/s: 4.5 m/s at the shell
  EXPECT_DOUBLE_EQ(typical_speed(scene), 4.5);
  scene.particles[0].explicit_particles = {{Vec3::Zero(), Vec3(0, 3, -4), Vec3::Zero(), 0.01}};
  EXPECT_DOUBLE_EQ(typical_speed(scene), 5);
  scene.contact.impact_speed = 1.5;
  EXPECT_EQ(typical_speed(scene), 1.5);
}

TEST(HertzAdvice, TakesWallsTheDomainAndNothingAtAll) {
  Scene scene;
  EXPECT_EQ(typical_speed(scene), 1);  // gravity, but nowhere to fall
  scene.domain.low = Vec3(0, -1, 0);
  scene.domain.high = Vec3(3, 1, 0);
  EXPECT_DOUBLE_EQ(typical_speed(scene), std::sqrt(2 * 9.81 * 2));
  Motion turning;
  turning.kind = MotionKind::kRotation;
  turning.rate.points = {{0, 10}};
  scene.meshes.push_back({"drum", "", "", 1, turning});
  EXPECT_DOUBLE_EQ(typical_speed(scene), 10 * 0.5 * std::sqrt(13));
  Motion shaken;
  shaken.kind = MotionKind::kOscillation;
  shaken.amplitude = 0.1;
  shaken.frequency = 50;
  scene.planes.push_back({"table", "", Vec3::Zero(), Vec3::UnitZ(), shaken});
  EXPECT_DOUBLE_EQ(typical_speed(scene), 2 * kPi * 5);
}

TEST(HertzAdvice, IsTheContactTimeOfAnImpactAndTheRayleighTime) {
  Scene scene = shipped_scene("lab_mill_hertz", kPlain);
  scene.contact.impact_speed = 2;
  const double r = 0.006875, big = 0.009, e = 5e7, nu = 0.3;
  const auto mass = [](double radius) { return 1190 * sphere_volume(radius); };
  const auto time = [&](double m, double radius, double speed) {  // 2.8683 (m^2 / (R E*^2 v))^(1/5)
    const double modulus = e / (2 * (1 - nu * nu));
    return 2.8683 * std::pow(m * m / (radius * modulus * modulus * speed), 0.2);
  };
  const double two = mass(r) * mass(big) / (mass(r) + mass(big)), both = r * big / (r + big);
  const StepAdvice pair = advice_for(scene, "small 13.75 mm", "large 18 mm");
  const StepAdvice wall = advice_for(scene, "small 13.75 mm", "liner");
  EXPECT_NEAR(pair.contact_time / time(two, both, 2), 1, 1e-4);  // four digits of 2.8683
  EXPECT_NEAR(wall.contact_time / time(mass(r), r, 2), 1, 1e-4);
  // At the deepest point, with d = 0.3398 of v times the contact time.
  const double shear = e / (2 * (1 + nu)), along = 8 * shear / (2 * (2 - nu));
  const double kt = along * std::sqrt(r * 2 * wall.contact_time / 2.94328);
  EXPECT_NEAR(wall.tangential_time / (kPi * std::sqrt(2.0 / 7 * mass(r) / kt)), 1, 1e-4);
  const double wave = kPi * r * std::sqrt(1190 / shear) / (0.8766 + 0.1631 * nu);
  EXPECT_NEAR(pair.rayleigh_time / wave, 1, 1e-12);
  EXPECT_NEAR(wall.rayleigh_time / wave, 1, 1e-12);
}

TEST(HertzAdvice, MakesTheStepThatASceneDoesNotGive) {
  Scene scene = shipped_scene("lab_mill_hertz", kPlain);
  scene.run.time_step.reset();
  const std::vector<ParticleSeed> seeds = draw_sizes(scene);
  scene.contact.impact_speed = 2;
  const StepAdvice finest = advice_for(scene, "small 13.75 mm", "small 13.75 mm");
  EXPECT_DOUBLE_EQ(choose_time_step(scene, seeds), finest.contact_time / 25);
  scene.contact.impact_speed = 1e-4;  // long contacts
  EXPECT_DOUBLE_EQ(choose_time_step(scene, seeds), 0.2 * finest.rayleigh_time);
}

// A hundredth of the stiffness: contacts take 100^(2/5) as long.
TEST(HertzAdvice, StretchesTheStepOfTheSoftPhaseAsContactsAre) {
  Scene scene = shipped_scene("lab_mill_hertz", {"run.soft_stiffness=0.01"});
  const std::vector<PhasePlan> plan = plan_phases(scene, 1e-5, 0.1, 1, 0.005);
  ASSERT_EQ(plan[0].kind, Phase::kSoft);
  EXPECT_NEAR(plan[0].dt / 1e-5, std::pow(100, 0.4), 1e-12);
}

// Of two materials: 1/E* and 1/G* add up.
TEST(HertzLaw, TakesItsTableFromTheModuliOfBothMaterials) {
  Scene scene = shipped_scene("lab_mill_hertz", kPlain);
  scene.materials[1].young_modulus = 2e8;
  scene.materials[1].poisson_ratio = 0.2;
  const PairValues v = resolve_pairs(scene)[1];
  EXPECT_NEAR(v.normal_stiffness * ((1 - 0.09) / 5e7 + (1 - 0.04) / 2e8), 4.0 / 3, 1e-12);
  const double ga = 5e7 / 2.6, gb = 2e8 / 2.4;
  EXPECT_NEAR(v.tangential_stiffness * ((2 - 0.3) / ga + (2 - 0.2) / gb), 8, 1e-12);
  EXPECT_EQ(v.restitution, 0.75);
  const World<double> world = world_of<double>(scene);
  EXPECT_EQ(world.force_law, ForceLaw::kHertzMindlin);
  const double zeta = damping_ratio(0.75, NormalForce::kUnclamped);
  EXPECT_DOUBLE_EQ(world.wall_law.normal_damping[1],
                   2 * zeta * std::sqrt(1.25 * v.normal_stiffness));
}

}  // namespace
}  // namespace quern
