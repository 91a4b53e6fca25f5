// The impact trial against what is asked for, and against the discrete scheme's known scatter.
#include "scheduler/impact_trial.h"

#include "kernels/laws/damping.h"
#include "scheduler/setup.h"
#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

constexpr double kDiameter = 1.0 / 64;

Scene trial_scene(double restitution, double steps, Precision precision) {
  Law law;
  law.restitution = restitution;
  const double m = sphere_mass(kDiameter) / 2;
  Scene scene = small_scene(law, normal_contact_time(m, law.kn) / steps);
  scene.run.precision = precision;
  add_sphere(scene, kDiameter, Vec3::Zero());
  add_sphere(scene, 2 * kDiameter, Vec3(1, 0, 0));
  return scene;
}

DeliveredRestitution delivered(const Scene& scene) {
  const std::vector<ParticleSeed> seeds = draw_sizes(scene);
  return measure_restitution(scene, seeds, *scene.run.time_step);
}

TEST(ImpactTrial, AtFiftyStepsWhatIsAskedForIsDelivered) {
  for (const Precision precision : {Precision::kMixed, Precision::kDouble}) {
    for (const double e : {0.3, 0.65, 0.9}) {
      // The acceptance limits of the scheme, as in restitution_test.cpp.
      const DeliveredRestitution found = delivered(trial_scene(e, 50, precision));
      EXPECT_DOUBLE_EQ(found.asked, e);
      EXPECT_NEAR(found.mean, e, 1e-3) << e;
      EXPECT_LT(found.scatter, 1.5e-3) << e;
    }
  }
}

TEST(ImpactTrial, ScatterGrowsAsStepsGrow) {
  // The mean's error and the scatter of a second-order scheme fall about as dt^2: between 5 and 20
  // steps by more than 4, by 16 at most times what a hundred phases leave open.
  const DeliveredRestitution coarse = delivered(trial_scene(0.65, 5, Precision::kDouble)),
                             fine = delivered(trial_scene(0.65, 20, Precision::kDouble));
  EXPECT_GT(coarse.scatter, 4 * fine.scatter);
  EXPECT_GT(coarse.scatter, 0.01);
}

TEST(ImpactTrial, TellsThePairOfMaterialsThatIsFurthestOff) {
  Scene scene = trial_scene(0.65, 20, Precision::kDouble);
  scene.materials.push_back({"steel", 7800, 0});
  ParticleSpec balls;
  balls.name = "ball";
  balls.material = "steel";
  balls.explicit_particles.push_back({Vec3(2, 0, 0), Vec3::Zero(), Vec3::Zero(), kDiameter});
  scene.particles.push_back(balls);
  // Below e^-2 the clamped law cannot go: that pair delivers 0.135 and is far off.
  scene.contact.pairs.push_back({"steel", "steel", {}, {}, 0.01, {}, {}});
  const DeliveredRestitution found = delivered(scene);
  EXPECT_DOUBLE_EQ(found.asked, 0.01);
  EXPECT_NEAR(found.mean, kLeastClampedRestitution, 0.006);
}

// 1 m/s is typical of a scene without gravity; the step is 200th of the contact at it.
TEST(ImpactTrial, OfSpringsThatStiffenWhatIsAskedForIsDeliveredAtTheScenesImpacts) {
  Scene scene = trial_scene(0.65, 200, Precision::kDouble);
  scene.contact.law = ForceLaw::kHertzMindlin;
  scene.contact.normal_stiffness = scene.contact.tangential_stiffness = std::nullopt;
  scene.materials[0].young_modulus = 1e8;
  scene.materials[0].poisson_ratio = 0.25;
  const std::vector<ParticleSeed> seeds = draw_sizes(scene);
  double contact = HUGE_VAL;
  for (const StepAdvice& a : advise_steps(scene, seeds, 1)) {
    contact = std::min(contact, a.contact_time);
  }
  const auto at = [&](double steps) { return measure_restitution(scene, seeds, contact / steps); };
  EXPECT_NEAR(at(200).mean, 0.65, 1e-3);  // as in hertz_test.cpp
  EXPECT_GT(at(5).scatter, 10 * at(50).scatter);
}

TEST(ImpactTrial, ImpactOverlapIsTheDepthOfAnUndampedImpactOfTwoOfTheHeaviest) {
  Scene scene = trial_scene(0.65, 20, Precision::kMixed);
  scene.contact.impact_speed = 3;
  const std::vector<ParticleSeed> seeds = draw_sizes(scene);
  // Undamped: m_e v^2 = k d^2 with m_e = m / 2, over the radius.
  const double m = sphere_mass(2 * kDiameter);
  EXPECT_NEAR(impact_overlap(scene, seeds) / (std::sqrt(0.5 * m * 9 / 2e7) / kDiameter), 1, 1e-12);
  // Of Hertz: 2/5 k d^(5/2) = 1/2 m_e v^2, k = 4/3 E* sqrt(R / 2), E* = E / (2 (1 - nu^2)).
  scene.contact.law = ForceLaw::kHertzMindlin;
  scene.contact.normal_stiffness = scene.contact.tangential_stiffness = std::nullopt;
  scene.materials[0].young_modulus = 1e8;
  scene.materials[0].poisson_ratio = 0.25;
  const double k = 4.0 / 3 * 1e8 / (2 * (1 - 0.0625)) * std::sqrt(kDiameter / 2);
  const double deepest = std::pow(2.5 * 0.5 * (m / 2) * 9 / k, 0.4);
  EXPECT_NEAR(impact_overlap(scene, seeds) / (deepest / kDiameter), 1, 1e-6);
}

}  // namespace
}  // namespace quern::test
