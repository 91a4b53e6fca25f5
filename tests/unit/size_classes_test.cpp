// Size classes: numbered over the scene, and found again from what a particle keeps.
#include "soa/size_classes.h"

#include <gtest/gtest.h>

#include "scheduler/snapshot.h"
#include "tests/support/small_scene.h"

namespace quern {
namespace {

constexpr ShapeKind kBall = ShapeKind::kSphere, kRock = ShapeKind::kPolyhedron;

SizeClass counted(double from, double to, long count, ShapeKind shape = kBall) {
  return {from, to, count, std::nullopt, shape};
}

// Balls of one size, ore in four classes, pebbles of a curve.
Scene mill_charge() {
  Scene scene = test::small_scene(test::Law(), 1e-6, 1);
  scene.particles.resize(3, scene.particles[0]);
  scene.particles[0].diameter = 0.125;
  scene.particles[0].count = 3;
  scene.particles[1].sizes = {counted(0.075, 0.105, 20), counted(0.105, 0.15, 20),
                              counted(0.015, 0.025, 20), counted(0.2, 0.2, 2)};
  scene.particles[2].distribution = {DistributionKind::kPassingTable, {{0.04, 0}, {0.08, 1}}};
  scene.particles[2].count = 20;
  scene.fill.method = FillMethod::kRandom;
  return scene;
}

TEST(SizeClasses, AreNumberedSpeciesBySpeciesAndClassByClass) {
  const SizeClasses classes(mill_charge());
  EXPECT_EQ(classes.of(0, kBall, 0.125), 0);
  EXPECT_EQ(classes.of(1, kBall, 0.08), 1);
  EXPECT_EQ(classes.of(1, kBall, 0.12), 2);
  EXPECT_EQ(classes.of(1, kBall, 0.02), 3);
  EXPECT_EQ(classes.of(1, kBall, 0.2), 4);
  EXPECT_EQ(classes.of(2, kBall, 0.05), 5);
  EXPECT_EQ(classes.of(3, kBall, 0.05), SizeClasses::kUnknown);
  EXPECT_EQ(SizeClasses().of(0, kBall, 0.05), SizeClasses::kUnknown);
}

TEST(SizeClasses, HaveNamesAndRangesOfTheirOwn) {
  Scene scene = mill_charge();
  scene.particles[0].name = "ball";
  scene.particles[1].name = "ore";
  scene.particles[2].name = "pebble";
  scene.particles[1].sizes.push_back(counted(0.105, 0.15, 3, kRock));
  scene.particles[1].sizes.push_back(counted(0.105, 0.15, 3, kRock));
  const SizeClasses classes(scene);
  const std::vector<SizeClasses::Row>& rows = classes.rows();
  std::vector<std::string> names;
  for (const SizeClasses::Row& row : rows) names.push_back(row.name);
  EXPECT_EQ(names, (std::vector<std::string>{
                       "ball", "ore 75-105 mm", "ore 105-150 mm", "ore 15-25 mm", "ore 200 mm",
                       "ore 105-150 mm polyhedra", "ore 105-150 mm polyhedra 2", "pebble"}));
  EXPECT_EQ(rows[0].from, 0.125);
  EXPECT_EQ(rows[0].to, 0.125);
  EXPECT_EQ(rows[7].from, 0.04);
  EXPECT_EQ(rows[7].to, 0.08);
}

// The frame's energies are what the run itself reports.
TEST(EnergyFrames, HoldTheMassesOfTheCharge) {
  const World<double> world = world_of<double>(mill_charge());
  const ParticleFrame frame = particle_frame(world);
  const EnergyFrame energy = energy_frame(world);
  double mass = 0;
  for (const double m : energy.mass) mass += m;
  EXPECT_NEAR(mass, world.total_mass, 1e-9 * mass);
  for (std::size_t i = 0; i < energy.mass.size(); ++i) {
    const Eigen::Vector3f spin(&frame.spin[3 * i]);
    const double radius = frame.radius[i];
    EXPECT_NEAR(energy.rotational_energy[i],
                0.2 * energy.mass[i] * radius * radius * spin.cast<double>().squaredNorm(),
                1e-5 * energy.rotational_energy[i]);
  }
}

template <class Real>
class SizeClassesInFrames : public testing::Test {};
TYPED_TEST_SUITE(SizeClassesInFrames, test::Precisions, test::Names);

// Identities of spheres follow the order in which they are drawn: class by class.
TYPED_TEST(SizeClassesInFrames, AreThoseTheParticlesWereDrawnFrom) {
  const ParticleFrame frame = particle_frame(world_of<TypeParam>(mill_charge()));
  std::vector<std::uint16_t> expected;
  for (const auto& [number, count] :
       {std::pair{0, 3}, {1, 20}, {2, 20}, {3, 20}, {4, 2}, {5, 20}}) {
    expected.insert(expected.end(), static_cast<std::size_t>(count),
                    static_cast<std::uint16_t>(number));
  }
  EXPECT_EQ(frame.size_class, expected);
}

TEST(SizeClasses, TellSpheresFromPolyhedraOfTheSameSize) {
  Scene scene;
  scene.particles.resize(1);
  scene.particles[0].sizes = {counted(0.01, 0.02, 1, kRock), counted(0.01, 0.02, 1),
                              counted(0.02, 0.03, 1, kRock)};
  const SizeClasses classes(scene);
  EXPECT_EQ(classes.of(0, kRock, 0.015), 0);
  EXPECT_EQ(classes.of(0, kBall, 0.015), 1);
  EXPECT_EQ(classes.of(0, kRock, 0.025), 2);
  EXPECT_EQ(classes.of(0, kBall, 0.025), 1);  // the only one of spheres
  scene.particles[0].sizes.erase(scene.particles[0].sizes.begin() + 1);
  EXPECT_EQ(SizeClasses(scene).of(0, kBall, 0.025), 1);  // spheres of another scene's state
}

TEST(SizeClasses, OverlappingTakeTheNarrowestThenTheFirst) {
  Scene scene;
  scene.particles.resize(1);
  scene.particles[0].sizes = {counted(0.01, 0.03, 1), counted(0.03, 0.05, 1),
                              counted(0.04, 0.04, 1)};
  const SizeClasses classes(scene);
  EXPECT_EQ(classes.of(0, kBall, 0.03), 0);
  EXPECT_EQ(classes.of(0, kBall, 0.031), 1);
  EXPECT_EQ(classes.of(0, kBall, static_cast<double>(0.04f)), 2);  // to rounding of f32
  EXPECT_EQ(classes.of(0, kBall, 0.041), 1);
  EXPECT_EQ(classes.of(0, kBall, 0.07), 1);
}

}  // namespace
}  // namespace quern
