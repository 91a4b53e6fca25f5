// Polyhedra from the scene to the world: orientations, places, columns, steps per contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/pairs/polyhedron_polyhedron.h"
#include "kernels/pairs/polyhedron_sphere.h"
#include "kernels/rotate.h"
#include "scheduler/rain.h"
#include "tests/support/build_world.h"
#include "tests/support/test_shapes.h"

namespace quern {
namespace {

constexpr double kDensity = 2000;  // kg/m^3

// `count` polyhedra of 10 mm, the scene's second species, behind `spheres` spheres of 8 mm.
Scene mixed_scene(long count, long spheres = 0) {
  Scene scene;
  scene.run.gravity = Vec3(0, 0, -9.81);
  scene.run.time_step = 1e-6;
  scene.run.duration = 1;
  scene.materials = {{"ore", kDensity, 0}, {"steel", 7800, 0}};
  scene.contact.normal_stiffness = 1e5;
  scene.contact.tangential_stiffness = 4e4;
  scene.contact.restitution = 0.5;
  scene.contact.sliding_friction = 0.5;
  scene.domain.low = Vec3::Constant(-0.1);
  scene.domain.high = Vec3::Constant(0.4);
  scene.particles.resize(2);
  scene.particles[0].name = "ball";
  scene.particles[0].material = "steel";
  scene.particles[0].diameter = 0.008;
  scene.particles[0].count = spheres;
  scene.particles[1].name = "rock";
  scene.particles[1].material = "ore";
  scene.particles[1].shape = ShapeKind::kPolyhedron;
  scene.particles[1].meshes = {"rock.stl"};
  scene.particles[1].diameter = 0.01;
  scene.particles[1].count = count;
  return scene;
}

// The second species as particles at given places; sides of the body are those of `shape`.
void set_entries(Scene& scene, std::vector<ExplicitParticle> entries) {
  scene.particles[1].diameter.reset();
  scene.particles[1].count.reset();
  scene.particles[1].explicit_particles = std::move(entries);
}

std::vector<Shape> one_shape(const Vec3& sides) {
  std::vector<Shape> shapes;
  shapes.push_back(test::built_box(sides));
  return shapes;
}

std::vector<ParticleSeed> seeds_of(const Scene& scene, const std::vector<Shape>& shapes) {
  std::vector<ParticleSeed> seeds = draw_sizes(scene);
  const std::vector<Index> rows[] = {{}, {0}};
  assign_shapes(shapes, rows, seeds);
  return seeds;
}

// Equivalent diameter of a box with these sides.
double diameter_of(const Vec3& sides) { return std::cbrt(6 * sides.prod() / kPi); }

// Smallest distance between two surrounding spheres.
double smallest_gap(const std::vector<ParticleSeed>& seeds) {
  double gap = HUGE_VAL;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      gap = std::min(gap, (seeds[i].position - seeds[j].position).norm() - seeds[i].reach() -
                              seeds[j].reach());
    }
  }
  return gap;
}

bool overlap(const ParticleSeed& a, const ParticleSeed& b) {
  if (a.is_sphere())
    return b.is_sphere() ? (a.position - b.position).norm() < a.radius + b.radius : overlap(b, a);
  const ShapePose pose{a.shape, a.radius, Vec3::Zero(), a.orientation.toRotationMatrix()};
  const Vec3 between = b.position - a.position;
  PolyhedronSphereTouch ball;
  if (b.is_sphere()) return touch_polyhedron_sphere(pose, between, b.radius, ball);
  const ShapePose other{b.shape, b.radius, between, b.orientation.toRotationMatrix()};
  PolyhedronTouch touch;
  return touch_polyhedra_plain(pose, other, {}, nullptr, between, touch);
}

TEST(PolyhedronSeeds, AreOrientedUniformly) {
  constexpr long kCount = 20000;
  Mat3 sum = Mat3::Zero(), squares = Mat3::Zero();
  for (const ParticleSeed& seed : draw_sizes(mixed_scene(kCount))) {
    ASSERT_NEAR(seed.orientation.norm(), 1, 4e-16);
    const Mat3 turn = seed.orientation.toRotationMatrix();
    sum += turn;
    squares += turn.cwiseProduct(turn);
  }
  // An entry of a random rotation is uniform in [-1, 1]: mean 0 of variance 1/3, and its square has
  // mean 1/3 of variance 4/45. Five standard errors.
  const double mean_error = 5 * std::sqrt(1.0 / 3 / kCount);
  const double square_error = 5 * std::sqrt(4.0 / 45 / kCount);
  EXPECT_LT((sum / kCount).cwiseAbs().maxCoeff(), mean_error);
  EXPECT_LT((squares / kCount - Mat3::Constant(1.0 / 3)).cwiseAbs().maxCoeff(), square_error);
}

TEST(PolyhedronSeeds, AreAFunctionOfSeedAndIdentity) {
  Scene scene = mixed_scene(50, 3);
  const std::vector<ParticleSeed> few = draw_sizes(scene);
  scene.particles[1].count = 100;
  const std::vector<ParticleSeed> many = draw_sizes(scene);
  scene.run.seed = 2;
  const std::vector<ParticleSeed> other = draw_sizes(scene);
  for (std::size_t k = 3; k < few.size(); ++k) {
    EXPECT_EQ(few[k].orientation.coeffs(), many[k].orientation.coeffs());
    EXPECT_NE(few[k].orientation.coeffs(), other[k].orientation.coeffs());
  }
  EXPECT_EQ(few[0].orientation.coeffs(), Quat::Identity().coeffs());  // spheres take no draw
}

TEST(PolyhedronSeeds, TurnTheMeshAsTheEntrySays) {
  Scene scene = mixed_scene(0);
  const Vec3 rest = Vec3::Zero(), sides(0.01, 0.02, 0.03);
  // A quarter turn about z: what pointed along x points along y.
  set_entries(scene, {{rest, rest, rest, diameter_of(sides), Turn{Vec3::UnitZ(), kPi / 2}}});
  const std::vector<Shape> shapes = one_shape(sides);
  const ParticleSeed seed = seeds_of(scene, shapes).front();
  Vec3 high = Vec3::Zero();
  for (std::size_t v = 0; v < shapes[0].vertices; ++v) {
    high = high.cwiseMax(Vec3(seed.radius * (seed.orientation * shapes[0].vertex(v))));
  }
  // Vertices of the shape are made in a few tens of operations on lengths of 0.01 m.
  EXPECT_LT((high - Vec3(0.01, 0.005, 0.015)).norm(), 1e-15);
  EXPECT_NEAR(seed.reach(), 0.5 * sides.norm(), 1e-15);
  EXPECT_NEAR(seed.inner(), 0.005, 1e-15);
}

TEST(PolyhedronFill, PlacesThemApartFromAllAndFromWalls) {
  Scene scene = mixed_scene(60, 60);
  scene.boxes.push_back({"box", "steel", Vec3::Zero(), Vec3::Constant(0.08), false, Motion()});
  scene.fill.method = FillMethod::kRandom;
  const std::vector<Shape> shapes = one_shape(Vec3(1, 2, 3));
  std::vector<ParticleSeed> seeds = seeds_of(scene, shapes);
  const SceneGeometry geometry = build_geometry(scene, {}, seeds);
  const FillReport report = place_particles(scene, geometry.facets(), seeds);
  EXPECT_LT(smallest_gap(seeds), 0);  // denser than the spheres around them would lie
  EXPECT_LE(report.low.maxCoeff(), 0.01);
  for (const ParticleSeed& p : seeds) {
    if (p.is_sphere()) continue;
    for (std::size_t v = 0; v < shapes[0].vertices; ++v) {
      const Vec3 corner = p.position + p.radius * (p.orientation * shapes[0].vertex(v));
      EXPECT_GE(corner.minCoeff(), -1e-16);  // some roundings of 0.1 m
      EXPECT_LE(corner.maxCoeff(), 0.08 + 3e-17);
    }
  }
  // By polygons and by planes, neither of which the filling asks for pairs of polyhedra.
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(seeds[i], seeds[j])) << i << ", " << j;
  }
  EXPECT_TRUE(check_overlaps(scene, geometry.facets(), seeds, 0).empty());
}

TEST(PolyhedronFill, RainsThemInApart) {
  Scene scene = mixed_scene(40, 20);
  scene.domain.high = Vec3::Constant(1);
  scene.boxes.push_back({"box", "steel", Vec3::Zero(), Vec3(0.08, 0.08, 0.1), true, Motion()});
  scene.fill.method = FillMethod::kRain;
  scene.fill.over = 1;
  const std::vector<Shape> shapes = one_shape(Vec3(1, 2, 3));
  std::vector<ParticleSeed> seeds = seeds_of(scene, shapes);
  const SceneGeometry geometry = build_geometry(scene, {}, seeds);
  Rain rain(scene, geometry.facets(), seeds);
  std::vector<ParticleSeed> in;
  for (const std::size_t k : rain.insert(0.5, {}, seeds)) in.push_back(seeds[k]);
  EXPECT_EQ(in.size(), 30u);
  EXPECT_GE(smallest_gap(in), -1e-16);
}

TEST(PolyhedronOverlaps, AreThoseOfTheBodiesNotOfTheSpheresAroundThem) {
  Scene scene = mixed_scene(0);
  const double side = 0.01, gap = 1e-5, deep = 2e-3;
  const double diameter = diameter_of(Vec3::Constant(side));
  const Vec3 rest = Vec3::Zero();
  const auto cube = [&](double x, double z) {
    return ExplicitParticle{Vec3(x, 0, z), rest, rest, diameter, Turn()};
  };
  // Three on a plate in a row: a gap, then an overlap; one far off that stands in the plate.
  set_entries(scene, {cube(0, 0.5 * side), cube(side + gap, 0.5 * side),
                      cube(2 * side + gap - deep, 0.5 * side), cube(0.2, 0.5 * side - deep)});
  scene.planes.push_back({"floor", "steel", Vec3::Zero(), Vec3::UnitZ(), Motion()});
  scene.particles[0].count.reset();  // a ball beside the first: its surface 3 mm inside that sphere
  scene.particles[0].diameter.reset();
  scene.particles[0].explicit_particles = {
      {Vec3(-0.5 * side - 0.004 - gap, 0, 0.5 * side), rest, rest, 0.008}};
  const std::vector<Shape> shapes = one_shape(Vec3::Ones());
  const std::vector<ParticleSeed> seeds = seeds_of(scene, shapes);
  const SceneGeometry geometry = build_geometry(scene, {}, seeds);
  // The cubes and the ball that touch the floor overlap it by rounding only.
  const std::vector<std::string> lines = check_overlaps(scene, geometry.facets(), seeds, 1e-6);
  ASSERT_EQ(lines.size(), 2u) << lines.front();
  const std::string both = lines[0] + lines[1];
  EXPECT_NE(both.find("particle 3 ('rock') overlaps particle 2 ('rock') by 0.002 m"),
            std::string::npos)
      << both;
  EXPECT_NE(both.find("particle 4 ('rock') overlaps a wall by 0.002 m"), std::string::npos) << both;
  scene.particles[0].explicit_particles[0].position.x() += deep;  // into the first cube
  const std::vector<ParticleSeed> closer = seeds_of(scene, shapes);
  EXPECT_EQ(check_overlaps(scene, geometry.facets(), closer, 1e-6).size(), 3u);
}

template <class Real>
class PolyhedronWorld : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(PolyhedronWorld, Precisions);

TYPED_TEST(PolyhedronWorld, HasTheColumnsOfItsBodies) {
  Scene scene = mixed_scene(0, 5);
  const Vec3 sides(0.01, 0.02, 0.03), place(0.1, 0.2, 0.3), v(1, 2, 3), w(10, 20, 30);
  set_entries(scene, {{place, v, w, diameter_of(sides), Turn{Vec3::UnitZ(), kPi / 2}}});
  std::vector<Shape> shapes = one_shape(sides);
  const std::vector<ParticleSeed> seeds = seeds_of(scene, shapes);
  World<TypeParam> world = make_world<TypeParam>(scene, build_geometry(scene, {}, seeds), seeds,
                                                 seeds, std::move(shapes));
  const Polyhedra<TypeParam>& p = world.polyhedra;
  ASSERT_EQ(p.size(), 1u);
  EXPECT_EQ(world.particles.size(), 5u);
  EXPECT_EQ(p.first_id, 5u);
  EXPECT_EQ(p.place(0), place);
  EXPECT_EQ(p.velocity(0), v);
  EXPECT_EQ(p.spin(0), w);
  // A box by its closed forms, along its own axes; relative errors of some tens of roundings.
  const double mass = kDensity * sides.prod();
  const Vec3 inertia = mass / 12 * (Vec3::Constant(sides.squaredNorm()) - sides.cwiseAbs2());
  EXPECT_NEAR(p.inverse_mass[0] * mass, 1, 1e-14);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(p.inverse_inertia(0)[k] * inertia[k], 1, 1e-13);
  const Vec3 momentum(inertia[1] * w.x(), inertia[0] * w.y(), inertia[2] * w.z());  // turned by 90
  EXPECT_LT((p.momentum(0) - momentum).norm(), 1e-13 * momentum.norm());
  EXPECT_LT((spin_of(p.orientation(0), p.momentum(0), p.inverse_inertia(0)) - w).norm(),
            1e-13 * w.norm());
  EXPECT_EQ(p.scale[0], 0.5 * diameter_of(sides));
  EXPECT_EQ(p.shape[0], 0u);
  EXPECT_EQ(p.material[0], 0u);
  EXPECT_EQ(p.species[0], 1u);
  EXPECT_NEAR(world.smallest_radius, 0.004, 1e-9);  // the balls; half the least side is 0.005
  const double balls = 5 * 7800 * sphere_volume(0.004);
  EXPECT_NEAR(world.total_mass, mass + balls, 1e-6 * mass);  // masses of spheres are f32 in mixed
  EXPECT_EQ(world.shapes.size(), 1u);
}

TYPED_TEST(PolyhedronWorld, NumbersItsBodiesBehindAllSpheresThatComeLater) {
  Scene scene = mixed_scene(4, 6);
  std::vector<Shape> shapes = one_shape(Vec3::Ones());
  std::vector<ParticleSeed> seeds = seeds_of(scene, shapes);
  const std::vector<ParticleSeed> early = {seeds[0], seeds[7]};
  World<TypeParam> world = make_world<TypeParam>(scene, build_geometry(scene, {}, seeds), seeds,
                                                 early, std::move(shapes));
  world.ledger.open = 1;
  ParticleSeed late = seeds[6];
  late.velocity = Vec3(3, 0, 0);
  append_particles<TypeParam>(world, scene, std::vector<ParticleSeed>{late, seeds[1]});
  EXPECT_EQ(world.particles.size(), 2u);
  EXPECT_EQ(world.particles.id[1], 1u);
  ASSERT_EQ(world.polyhedra.size(), 2u);
  EXPECT_EQ(world.polyhedra.first_id, 6u);
  EXPECT_EQ(world.polyhedra.orientation(0).coeffs(), seeds[7].orientation.coeffs());
  EXPECT_EQ(world.polyhedra.orientation(1).coeffs(), seeds[6].orientation.coeffs());
  const double mass = kDensity * sphere_volume(0.005);
  // Both are kept with the velocity of half a step before, h slower along gravity; the energy is the
  // product with that of half a step after. The step that counts gravity's work from then on is
  // given back.
  const double ball = 1 / static_cast<double>(world.particles.traits[1].inverse_mass);
  const double gravity = world.gravity.norm(), h = 0.5 * world.clock.dt * gravity;
  EXPECT_EQ(world.polyhedra.velocity(1), late.velocity - 0.5 * world.clock.dt * world.gravity);
  EXPECT_NEAR(world.ledger.start_kinetic, 0.5 * mass * 9 - 0.5 * (mass + ball) * h * h,
              1e-15 * mass * 9);
  EXPECT_NEAR(world.ledger.gravity_work / ((mass + ball) * world.clock.dt * gravity * h), 1, 1e-7);  // f32 mass
  EXPECT_EQ(world.clock.list_stale, 1u);
}

TEST(PolyhedronLaw, IsTakenFromTheScene) {
  Scene scene = mixed_scene(0, 1);
  scene.particles.resize(1);
  scene.fill.method = FillMethod::kRandom;
  scene.contact.overlap = OverlapMeasure::kWidth;
  scene.contact.normal_model = NormalModel::kVolume;
  scene.contact.volume_stiffness = 3e9;
  scene.contact.patch_damping = false;
  const World<double> world = world_of<double>(scene);
  EXPECT_EQ(world.patch.overlap, OverlapMeasure::kWidth);
  EXPECT_EQ(world.patch.model, NormalModel::kVolume);
  EXPECT_EQ(world.patch.volume_stiffness, 3e9);
  EXPECT_FALSE(world.patch.damping);
  EXPECT_TRUE(world.polyhedra.empty());
}

// Normal and tangential contact time of the pair of classes (a, b).
std::pair<double, double> contact_times(const Scene& scene, std::span<const ParticleSeed> seeds,
                                        const std::string& a, const std::string& b) {
  for (const StepAdvice& advice : advise_steps(scene, seeds, 1)) {
    if (advice.a == a && advice.b == b) return {advice.contact_time, advice.steps_tangential};
  }
  ADD_FAILURE() << "no advice for " << a << " and " << b;
  return {};
}

TEST(PolyhedronSteps, CountWithTheMassAtACorner) {
  Scene scene = mixed_scene(3, 2);
  scene.planes.push_back({"floor", "steel", Vec3::Zero(), Vec3::UnitZ(), Motion()});
  const double kn = 1e5, kt = 4e4;
  const double m = kDensity * sphere_volume(0.005), ball = 7800 * sphere_volume(0.004);
  const auto time = [](double mass, double k) { return kPi * std::sqrt(mass / k); };
  // Sides 1, 1, s: pushed at a corner along x, 1/m_n = 1/m + (1/4) / (m/6) + (s^2/4) / (m (1 +
  // s^2)/12).
  for (const double s : {1.0, 2.0, 100.0}) {
    const std::vector<Shape> shapes = one_shape(Vec3(1, 1, s));
    const std::vector<ParticleSeed> seeds = seeds_of(scene, shapes);
    const double corner = m / (1 + 1.5 + 3 / (1 + 1 / (s * s)));
    const double both = corner * ball / (corner + ball);
    EXPECT_NEAR(
        contact_times(scene, seeds, "rock 10 mm", "rock 10 mm").first / time(corner / 2, kn), 1,
        1e-12)
        << s;
    EXPECT_NEAR(contact_times(scene, seeds, "rock 10 mm", "floor").first / time(corner, kn), 1,
                1e-12);
    EXPECT_NEAR(contact_times(scene, seeds, "ball 8 mm", "rock 10 mm").first / time(both, kn), 1,
                1e-12);
  }
  // Along the surface a cube gives way in the plane across its diagonal: 1/m + (3/4) / (m/6).
  const std::vector<Shape> cube = one_shape(Vec3::Ones());
  const std::vector<ParticleSeed> seeds = seeds_of(scene, cube);
  EXPECT_NEAR(contact_times(scene, seeds, "rock 10 mm", "floor").second / time(m / 5.5, kt), 1,
              1e-12);
  scene.contact.overlap = OverlapMeasure::kWidth;  // three springs, where both sides can be flat
  EXPECT_NEAR(contact_times(scene, seeds, "rock 10 mm", "floor").first / time(m / 4, 3 * kn), 1,
              1e-12);
  EXPECT_NEAR(contact_times(scene, seeds, "rock 10 mm", "rock 10 mm").first / time(m / 8, 3 * kn),
              1, 1e-12);
  EXPECT_NEAR(contact_times(scene, seeds, "ball 8 mm", "ball 8 mm").first / time(ball / 2, kn), 1,
              1e-12);
  scene.run.time_step.reset();
  EXPECT_NEAR(choose_time_step(scene, seeds) * 25 / time(m / 8, 3 * kn), 1, 1e-12);
}

// 4.4 steps per contact between two ore spheres of 15 mm at the paper's step of 10 us; below 4, at
// 11.1 us, a run is refused.
TEST(PolyhedronSteps, AreThoseOfThePapersMill) {
  const Scene scene = shipped_scene("sag_slice_ph");
  const DrawnScene all = drawn(scene);
  const double fine = contact_times(scene, all.seeds, "ore 15-25 mm", "ore 15-25 mm").first;
  // The least of 298410 diameters lies within 1e-6 of 15 mm; pi sqrt(m / 2 kn) goes as d^1.5.
  const double mass = 4500 * sphere_volume(0.0075);
  EXPECT_NEAR(fine / (kPi * std::sqrt(mass / 2 / 2e7)), 1, 1e-4);
  EXPECT_NEAR(fine / 1e-5, 4.43, 0.01);
  double worst = HUGE_VAL;
  for (const StepAdvice& a : advise_steps(scene, all.seeds, 1e-5)) {
    worst = std::min(worst, a.steps_normal);
  }
  EXPECT_EQ(worst, fine / 1e-5);  // the polyhedra are no worse
  EXPECT_GT(worst, kRefusedSteps);
  EXPECT_LT(fine / 1.12e-5, kRefusedSteps);
}

// A cube of edge a on its face: k_V a^2 dt / m is its speed after one step.
TEST(PolyhedronSteps, TellHowHighTheVolumeModelThrowsAFlatFace) {
  Scene scene = shipped_scene("lab_mill_faceted");
  const DrawnScene all = drawn(scene);
  EXPECT_EQ(flat_face_toss(scene, all.seeds, 1e-5), 0);
  scene.contact.normal_model = NormalModel::kVolume;
  const Shape cube = test::built_box({1, 1, 1});
  ParticleSeed seed = all.seeds.front();
  seed.shape = &cube;
  seed.radius = 0.01;
  const double mass = scene.materials[seed.material].density * sphere_volume(0.01);
  const double area = std::pow(sphere_volume(0.01), 2.0 / 3);
  for (const double stiffness : {1e4, 1e5 / 0.01}) {  // given; that of the spring over the radius
    if (stiffness < 1e6) scene.contact.volume_stiffness = stiffness;
    if (stiffness > 1e6) scene.contact.volume_stiffness.reset();
    const double speed = stiffness * area * 1e-5 / mass;
    const double height = speed * speed / (2 * scene.run.gravity.norm());
    EXPECT_NEAR(flat_face_toss(scene, {&seed, 1}, 1e-5) / (height / 0.02), 1, 1e-12);
  }
}

// Both sides of the laboratory scenes keep above the number of steps that is warned of.
TEST(PolyhedronSteps, SufficeInTheLaboratoryScenes) {
  for (const char* name : {"box_packing", "lab_mill", "lab_mill_faceted"}) {
    const Scene scene = shipped_scene(name);
    const DrawnScene all = drawn(scene);
    for (const StepAdvice& a : advise_steps(scene, all.seeds, *scene.run.time_step)) {
      EXPECT_GT(a.steps_normal, kWarnedSteps) << name << ": " << a.a << ", " << a.b;
    }
  }
}

}  // namespace
}  // namespace quern
