// Sizes: counts, masses, shares and distributions against what was asked for.
#include "scheduler/sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soa/facets.h"

namespace quern {
namespace {

constexpr double kOre = 4500, kSteel = 7800;

Scene scene_with(const ParticleSpec& spec) {
  Scene scene;
  scene.materials = {{"steel", kSteel, 0}, {"ore", kOre, 0}};
  scene.particles = {spec};
  return scene;
}

ParticleSpec ore() {
  ParticleSpec spec;
  spec.name = "ore";
  spec.material = "ore";
  return spec;
}

SizeClass counted(double from, double to, long count) {
  SizeClass c;
  c.from = from;
  c.to = to;
  c.count = count;
  return c;
}

SizeClass shared(double from, double to, double share) {
  SizeClass c;
  c.from = from;
  c.to = to;
  c.mass_share = share;
  return c;
}

double mass_of(double diameter, double density = kOre) {
  return density * kPi / 6 * diameter * diameter * diameter;
}

// Mass of the particles with from < diameter <= to, and the sum of its squares.
struct MassSum {
  double mass = 0, squares = 0;
  long count = 0;
};
MassSum sum_between(const std::vector<ParticleSeed>& particles, double from, double to) {
  MassSum sum;
  for (const ParticleSeed& p : particles) {
    if (2 * p.radius <= from || 2 * p.radius > to) continue;
    const double m = mass_of(2 * p.radius);
    sum.mass += m;
    sum.squares += m * m;
    ++sum.count;
  }
  return sum;
}

std::string error_of(const Scene& scene) {
  try {
    draw_sizes(scene);
  } catch (const UserError& e) {
    return e.what();
  }
  return "";
}

TEST(Sizes, DealTheMeshesInTurnByIdentity) {
  ParticleSpec balls = ore();
  balls.diameter = 0.125;
  balls.count = 2;
  ParticleSpec rock = ore();
  rock.meshes = {"a.stl", "b.stl", "c.stl"};
  rock.sizes = {counted(0.01, 0.02, 3), counted(0.02, 0.03, 5)};
  rock.sizes[1].shape = ShapeKind::kPolyhedron;
  Scene scene = scene_with(balls);
  scene.particles.push_back(rock);
  std::vector<std::uint16_t> meshes;
  for (const ParticleSeed& p : draw_sizes(scene)) meshes.push_back(p.mesh);
  const std::uint16_t ball = kNoMesh;  // five spheres come first, so identity 5 has mesh 5 mod 3
  EXPECT_EQ(meshes, (std::vector<std::uint16_t>{ball, ball, ball, ball, ball, 2, 0, 1, 2, 0}));

  scene.particles[1].shape = ShapeKind::kPolyhedron;  // a class may say otherwise
  scene.particles[1].sizes[1].shape = ShapeKind::kSphere;
  meshes.clear();
  for (const ParticleSeed& p : draw_sizes(scene)) meshes.push_back(p.mesh);
  EXPECT_EQ(meshes,
            (std::vector<std::uint16_t>{ball, ball, 2, 0, 1, ball, ball, ball, ball, ball}));

  scene.particles[1].meshes.clear();
  EXPECT_EQ(error_of(scene), "particles 'ore': polyhedra need a mesh");
}

TEST(Sizes, FollowTheOrderOfSpeciesAndClasses) {
  ParticleSpec balls = ore();
  balls.material = "steel";
  balls.diameter = 0.125;
  balls.count = 3;
  Scene scene = scene_with(balls);
  ParticleSpec rock = ore();
  rock.sizes = {counted(0.02, 0.03, 5), counted(0.01, 0.02, 7)};
  scene.particles.push_back(rock);
  scene.fill.velocity = Vec3(1, 2, 3);
  const auto list = draw_sizes(scene);
  ASSERT_EQ(list.size(), 15u);
  for (std::size_t i = 0; i < 15; ++i) {
    const double low = i < 3 ? 0.125 : (i < 8 ? 0.02 : 0.01);
    const double high = i < 3 ? 0.125 : (i < 8 ? 0.03 : 0.02);
    EXPECT_GE(2 * list[i].radius, low);
    EXPECT_LE(2 * list[i].radius, high);
    EXPECT_EQ(list[i].species, i < 3 ? 0 : 1);
    EXPECT_EQ(list[i].material, i < 3 ? 0 : 1);
    EXPECT_EQ(list[i].velocity, Vec3(1, 2, 3));
  }
}

TEST(Sizes, AreUniformInDiameterWithinAClass) {
  ParticleSpec spec = ore();
  constexpr long kCount = 20000;
  spec.sizes = {counted(0.015, 0.025, kCount)};
  auto list = draw_sizes(scene_with(spec));
  ASSERT_EQ(list.size(), static_cast<std::size_t>(kCount));
  std::sort(list.begin(), list.end(),
            [](const ParticleSeed& a, const ParticleSeed& b) { return a.radius < b.radius; });
  double farthest = 0;  // Kolmogorov-Smirnov
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double u = (2 * list[i].radius - 0.015) / 0.010;
    farthest = std::max(farthest, std::abs(u - (static_cast<double>(i) + 0.5) / kCount));
  }
  EXPECT_LT(farthest, 1.63 / std::sqrt(kCount));  // the 1 % point
}

// The classes of a SAG charge were chosen for these shares of the ore's volume and this mass.
TEST(Sizes, ReproduceTheMassSplitOfASagCharge) {
  ParticleSpec spec = ore();
  const double edge[] = {0.015, 0.025, 0.035, 0.045, 0.075, 0.105, 0.150};
  const long count[] = {298410, 66227, 23616, 6683, 2051, 513};
  const double share[] = {0.25, 0.18, 0.15, 0.15, 0.15, 0.12};
  for (int k = 0; k < 6; ++k) spec.sizes.push_back(counted(edge[k], edge[k + 1], count[k]));
  const auto list = draw_sizes(scene_with(spec));
  const double total = sum_between(list, 0, 1).mass;
  EXPECT_NEAR(total, 23740, 0.01 * 23740);
  for (int k = 0; k < 6; ++k) {
    // Uniform diameters put 0.109 into the coarsest class where the shares say 0.12.
    EXPECT_NEAR(sum_between(list, edge[k], edge[k + 1]).mass / total, share[k], 0.013) << k;
  }
}

TEST(Sizes, MeetMassSharesToHalfAParticle) {
  ParticleSpec spec = ore();
  spec.mass = 50;
  spec.sizes = {shared(0.01, 0.02, 0.3), shared(0.02, 0.05, 0.5), shared(0.05, 0.1, 0.2)};
  const auto list = draw_sizes(scene_with(spec));
  for (const SizeClass& c : spec.sizes) {
    const double mass = sum_between(list, c.from, c.to).mass;
    EXPECT_NEAR(mass, 50 * *c.mass_share, 0.5 * mass_of(c.to));
  }
}

TEST(Sizes, SplitATotalCountByMassShares) {
  ParticleSpec spec = ore();
  spec.count = 50000;
  spec.sizes = {shared(0.01, 0.02, 0.4), shared(0.02, 0.04, 0.6)};
  const auto list = draw_sizes(scene_with(spec));
  EXPECT_EQ(list.size(), 50000u);
  const MassSum fine = sum_between(list, 0, 0.02), coarse = sum_between(list, 0.02, 1);
  const double noise = 4 * std::sqrt(fine.squares + coarse.squares) / (fine.mass + coarse.mass);
  EXPECT_NEAR(fine.mass / (fine.mass + coarse.mass), 0.4, noise);
}

TEST(Sizes, MeetAFillingLevel) {
  ParticleSpec spec = ore();
  spec.diameter = 0.05;
  spec.filling_level = 0.3;
  Scene scene = scene_with(spec);
  MillSpec mill;
  mill.diameter = 2;
  mill.length = 0.5;
  mill.lifters = LifterSpec{12, 0.08, 0.2, 0.08};
  scene.mill = mill;
  const double bulk = 0.3 * mill_inner_area(mill) * 0.5;
  const double solid = static_cast<double>(draw_sizes(scene).size()) * mass_of(0.05) / kOre;
  EXPECT_NEAR(solid / 0.6, bulk, 0.5 * mass_of(0.05) / kOre / 0.6 * (1 + 1e-9));
}

TEST(Sizes, FollowATableOfPassing) {
  ParticleSpec spec = ore();
  spec.mass = 200;
  spec.distribution.kind = DistributionKind::kPassingTable;
  spec.distribution.passing = {{0.008, 0.0}, {0.016, 0.25}, {0.04, 0.7}, {0.08, 1.0}};
  const auto list = draw_sizes(scene_with(spec));
  const MassSum all = sum_between(list, 0, 1);
  EXPECT_NEAR(all.mass, 200, mass_of(0.016));
  for (std::size_t k = 1; k < 4; ++k) {  // the curve at its points: to the rounding of a piece
    const auto [diameter, passing] = spec.distribution.passing[k];
    const MassSum below = sum_between(list, 0, diameter);
    EXPECT_NEAR(below.mass, 200 * passing, mass_of(2.5 * diameter));
  }
  for (std::size_t k = 1; k < 4; ++k) {  // half way in log d: half the piece's mass
    const auto [from, under] = spec.distribution.passing[k - 1];
    const auto [to, over] = spec.distribution.passing[k];
    const MassSum piece = sum_between(list, from, to);
    const MassSum half = sum_between(list, from, std::sqrt(from * to));
    EXPECT_NEAR(half.mass / piece.mass, 0.5, 4 * std::sqrt(piece.squares) / piece.mass) << k;
  }
}

TEST(Sizes, FollowRosinRammlerBetweenItsCuts) {
  ParticleSpec spec = ore();
  spec.mass = 500;
  SizeDistribution& d = spec.distribution;
  d.kind = DistributionKind::kRosinRammler;
  d.d63 = 0.05;
  d.exponent = 1.3;
  d.from = 0.01;
  d.to = 0.12;
  const auto list = draw_sizes(scene_with(spec));
  const auto curve = [&](double x) { return 1 - std::exp(-std::pow(x / d.d63, d.exponent)); };
  const MassSum all = sum_between(list, 0, 1);
  EXPECT_NEAR(all.mass, 500, mass_of(0.011));
  for (const double x : {0.015, 0.02, 0.03, 0.05, 0.08, 0.1}) {
    const double expected = (curve(x) - curve(d.from)) / (curve(d.to) - curve(d.from));
    // Pieces are 4 % wide in d, so inside one the mass is off by a particle or a piece's noise.
    EXPECT_NEAR(sum_between(list, 0, x).mass, 500 * expected, 4 * mass_of(1.04 * x)) << x;
  }
  for (const ParticleSeed& p : list) {
    EXPECT_GE(2 * p.radius, 0.01 * (1 - 1e-12));
    EXPECT_LE(2 * p.radius, 0.12 * (1 + 1e-12));
  }
}

// By numbers exactly; by mass to what drawing scatters, some 1/sqrt(n) of thousands, and half a
// particle a class.
TEST(Sizes, AreCountedBeforeTheyAreDrawn) {
  ParticleSpec classes = ore(), share = ore(), curve = ore(), level = ore(), entries = ore();
  classes.meshes = share.meshes = {"a.stl"};
  classes.sizes = {counted(0.01, 0.02, 300), counted(0.02, 0.03, 50)};
  classes.sizes[1].shape = ShapeKind::kPolyhedron;
  share.count = 5000;
  share.sizes = {shared(0.01, 0.02, 0.4), shared(0.02, 0.04, 0.6)};
  share.sizes[0].shape = ShapeKind::kPolyhedron;
  curve.mass = 50;
  curve.distribution.kind = DistributionKind::kPassingTable;
  curve.distribution.passing = {{0.008, 0.0}, {0.016, 0.25}, {0.04, 1.0}};
  level.diameter = 0.05;
  level.filling_level = 0.3;
  entries.explicit_particles.resize(7);
  for (ExplicitParticle& p : entries.explicit_particles) p.diameter = 0.01;
  for (const ParticleSpec& spec : {classes, share, curve, level, entries}) {
    Scene scene = scene_with(spec);
    scene.mill = MillSpec();
    scene.mill->diameter = 2;
    scene.mill->length = 0.5;
    ParticleCount drawn;
    for (const ParticleSeed& p : draw_sizes(scene)) {
      (p.is_sphere() ? drawn.spheres : drawn.polyhedra) += 1;
    }
    const ParticleCount count = count_particles(scene);
    const bool exact = !spec.mass && !spec.filling_level;
    EXPECT_NEAR(count.spheres, drawn.spheres, exact ? 1 : 0.05 * drawn.spheres);
    EXPECT_NEAR(count.polyhedra, drawn.polyhedra, 1);
    EXPECT_GT(drawn.spheres + drawn.polyhedra, 6);
  }
}

TEST(Sizes, TakeExplicitParticlesAsTheyAre) {
  ParticleSpec spec = ore();
  spec.explicit_particles = {{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9), 0.5}};
  const auto list = draw_sizes(scene_with(spec));
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].position, Vec3(1, 2, 3));
  EXPECT_EQ(list[0].velocity, Vec3(4, 5, 6));
  EXPECT_EQ(list[0].spin, Vec3(7, 8, 9));
  EXPECT_EQ(list[0].radius, 0.25);
}

TEST(Sizes, DependOnSeedAndPlaceInTheListOnly) {
  ParticleSpec spec = ore();
  spec.sizes = {counted(0.01, 0.02, 50)};
  Scene scene = scene_with(spec);
  const auto first = draw_sizes(scene);
  scene.particles.push_back(spec);  // a later species leaves the earlier alone
  const auto longer = draw_sizes(scene);
  scene.run.seed = 2;
  const auto other = draw_sizes(scene);
  int same = 0;
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(first[i].radius, longer[i].radius);
    same += first[i].radius == other[i].radius ? 1 : 0;
  }
  EXPECT_EQ(same, 0);
}

TEST(Sizes, SayWhatIsMissingOrContradictory) {
  ParticleSpec spec = ore();
  spec.diameter = 0.01;
  EXPECT_NE(error_of(scene_with(spec)).find("no amount given"), std::string::npos);
  spec.filling_level = 0.3;
  EXPECT_NE(error_of(scene_with(spec)).find("needs a [mill]"), std::string::npos);
  spec.filling_level.reset();
  spec.mass = 1e9;
  spec.diameter = 1e-4;
  EXPECT_NE(error_of(scene_with(spec)).find("more than 1e9"), std::string::npos);
  spec.diameter.reset();
  EXPECT_NE(error_of(scene_with(spec)).find("no sizes given"), std::string::npos);
  spec.sizes = {shared(0.01, 0.02, 0.3), shared(0.02, 0.03, 0.3)};
  EXPECT_NE(error_of(scene_with(spec)).find("add up to"), std::string::npos);
  spec.material = "cheese";
  EXPECT_NE(error_of(scene_with(spec)).find("unknown material 'cheese'"), std::string::npos);
}

}  // namespace
}  // namespace quern
