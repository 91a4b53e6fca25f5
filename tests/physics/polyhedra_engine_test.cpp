// Polyhedra in the engine itself: at rest, stacked, on an incline; what is conserved.
//
// Cubes of side 1 m and density 1 under gravity 1 with kn = 1e4: a cube at rest overlaps by 1e-4.
// 25 steps per contact of a cube with a wall. Bounds are those of the narrow integrators' tests
// (polyhedron_rest_test.cpp); here the lists, the law's lanes and the sums are in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "kernels/laws/damping.h"
#include "tests/support/small_scene.h"
#include "tests/support/temp_folder.h"

namespace quern::test {
namespace {

constexpr double kStiffness = 1e4;
const double kCubeDiameter = std::cbrt(6 / kPi);  // of the sphere of equal volume

Scene cube_scene(double restitution = 0.5) {
  Law law;
  law.kn = kStiffness;
  law.kt = 0.4 * kStiffness;
  law.restitution = restitution;
  const double dt = kPi * std::sqrt(1 / kStiffness) / 25;
  Scene scene = small_scene(law, dt, 40);
  scene.materials[0].density = 1;
  scene.folder = QUERN_SOURCE_DIR "/apps/shapes";
  scene.particles[0].name = "cube";
  scene.particles[0].shape = ShapeKind::kPolyhedron;
  scene.particles[0].meshes = {"cube.stl"};
  return scene;
}

ExplicitParticle cube_at(const Vec3& place, const Vec3& axis = Vec3::UnitZ(), double angle = 0) {
  ExplicitParticle p;
  p.position = place;
  p.diameter = kCubeDiameter;
  p.orientation = Turn{axis, angle};
  return p;
}

template <class Real>
Vec3 corner(const World<Real>& world, std::size_t body, std::size_t vertex) {
  const Polyhedra<Real>& p = world.polyhedra;
  return p.place(body) +
         p.scale[body] * (p.orientation(body) * world.shapes[p.shape[body]].vertex(vertex));
}

template <class Real>
class PolyhedraInTheEngine : public testing::Test {};
TYPED_TEST_SUITE(PolyhedraInTheEngine, Precisions);

// A cube dropped on a plate with one side up, leaning by `tilt`.
Scene dropped_cube(double tilt) {
  Scene scene = cube_scene();
  scene.run.gravity = Vec3(0, 0, -1);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  const double high = 0.5 * (std::cos(tilt) + std::sin(tilt)) + 1e-3;
  scene.particles[0].explicit_particles = {cube_at({0, 0, high}, {1, 0.3, 0}, tilt)};
  return scene;
}

TYPED_TEST(PolyhedraInTheEngine, ACubeComesToRestOnAPlate) {
  for (const double tilt : {0.0, 1e-6, 1e-2, 0.3}) {
    SCOPED_TRACE(tilt);
    World<TypeParam> world = world_of<TypeParam>(dropped_cube(tilt));
    Stepper<TypeParam> stepper(world, 1);
    run_steps(world, stepper, 100000);
    EXPECT_LT(world.polyhedra.velocity(0).norm(), 1e-10);
    EXPECT_LT(world.polyhedra.spin(0).norm(), 1e-10);
    // kn' of the implicit damping: kn / (1 + zeta w dt), w dt = pi / 25. Places are f64.
    const double zeta = damping_ratio(0.5, NormalForce::kClamped);
    const double rest = (1 + zeta * kPi / 25) / kStiffness;
    int corners = 0;
    for (std::size_t v = 0; v < 8; ++v) {
      const double z = corner(world, 0, v).z();
      if (z > 0.5) continue;
      ++corners;
      EXPECT_NEAR(-z / rest, 1, 1e-6);
    }
    EXPECT_EQ(corners, 4);
    EXPECT_EQ(world.polyhedra.contacts[0], 1u);
  }
}

// Without the moments of the patch the cube rocks for ever, but no more than so much. This
// documents the law as it is written: one spring and one dashpot in the centroid. Spins in sqrt(g /
// side).
TYPED_TEST(PolyhedraInTheEngine, ACubeRocksOnAPlateWithoutPatchDamping) {
  for (const double tilt : {1e-2, 0.3}) {
    SCOPED_TRACE(tilt);
    Scene scene = dropped_cube(tilt);
    scene.contact.patch_damping = false;
    World<TypeParam> world = world_of<TypeParam>(scene);
    Stepper<TypeParam> stepper(world, 1);
    run_steps(world, stepper, 90000);
    double most = 0;
    for (int k = 0; k < 10000; ++k) {
      run_steps(world, stepper, 1);
      most = std::max(most, world.polyhedra.spin(0).norm());
    }
    EXPECT_LE(most, 5e-2);
    EXPECT_GT(most, 1e-4);
  }
}

TYPED_TEST(PolyhedraInTheEngine, TwoStackedCubesSettleAtOneHeightHoweverTheyAreAligned) {
  double height[2] = {};
  for (int k = 0; k < 2; ++k) {
    Scene scene = cube_scene();
    scene.run.gravity = Vec3(0, 0, -1);
    add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
    const double shift = k == 0 ? 0 : 1e-12;
    scene.particles[0].explicit_particles = {cube_at({0, 0, 0.5}), cube_at({shift, 0, 1.5})};
    World<TypeParam> world = world_of<TypeParam>(scene);
    Stepper<TypeParam> stepper(world, 1);
    run_steps(world, stepper, 60000);
    EXPECT_LT(world.polyhedra.velocity(1).norm(), 1e-9);
    height[k] = world.polyhedra.z[1];
    EXPECT_LT(height[k], 1.5 - 2.9e-4);  // 2 m g / kn below, m g / kn between
  }
  EXPECT_NEAR(height[0], height[1], 1e-3 / kStiffness);
}

// A box of 2 x 2 x 0.4 m as an STL file.
std::string flat_box(const TempFolder& folder) {
  const std::string path = folder / "box.stl";
  std::ofstream out(path);
  out << "solid box\n";
  const Vec3 half(1, 1, 0.2);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 n = side * Vec3::Unit(axis), u = Vec3::Unit((axis + 1) % 3), v = n.cross(u);
      const Vec3 corner[4] = {n - u - v, n + u - v, n + u + v, n - u + v};
      for (const auto& t : {std::array<int, 3>{0, 1, 2}, std::array<int, 3>{0, 2, 3}}) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const int k : t) {
          const Vec3 x = corner[k].cwiseProduct(half);
          out << "vertex " << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
        }
        out << "endloop\nendfacet\n";
      }
    }
  }
  out << "endsolid box\n";
  return path;
}

// What a single particle on a plate does when gravity leans slowly from upright to `slope`.
struct Slide {
  double crept;   // m, while it leans and 1000 steps more
  double change;  // m/s, over `time` after that
  double time;    // s
  double speed;   // m/s, at last
};
template <class Real>
Slide slide_down(const Scene& scene, double slope, int steps) {
  World<Real> world = world_of<Real>(scene);
  Stepper<Real> stepper(world, 1);
  run_steps(world, stepper, 10000);
  const double place = world.polyhedra.x[0];
  for (int k = 1; k <= 2000; ++k) {
    const double lean = std::atan(slope) * k / 2000;
    world.gravity = Vec3(std::sin(lean), 0, -std::cos(lean));
    run_steps(world, stepper, 8);
  }
  run_steps(world, stepper, 1000);
  const double crept = world.polyhedra.x[0] - place, speed = world.polyhedra.vx[0];
  run_steps(world, stepper, steps);
  const double last = world.polyhedra.vx[0];
  return {crept, last - speed, steps * world.clock.dt, last};
}

// Sticks while tan a < mu, but for the spring and what a cube leans: some 1e-4 m. Slides above with
// g (sin a - mu cos a); its rocking leaves 5 mm/s, hence 10 s, and more close to the angle.
template <class Real>
void expect_sticks_then_slides(Scene scene, std::initializer_list<double> steeper) {
  scene.run.gravity = Vec3(0, 0, -1);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  const double mu = *scene.contact.sliding_friction;
  for (const double slope : {0.5 * mu, mu * (1 - 1e-3)}) {
    SCOPED_TRACE(slope);
    const Slide found = slide_down<Real>(scene, slope, 3000);
    EXPECT_LT(std::abs(found.crept), 2e-4);
    EXPECT_LT(std::abs(found.speed), 1e-6);
  }
  std::vector<double> above = {mu * (1 + 1e-3)};
  above.insert(above.end(), steeper);
  for (const double slope : above) {
    SCOPED_TRACE(slope);
    const double a = std::atan(slope), rate = std::sin(a) - mu * std::cos(a);
    const Slide found = slide_down<Real>(scene, slope, rate < 0.05 ? 20000 : 8000);
    EXPECT_NEAR(found.change / found.time, rate, 1e-3);
    EXPECT_GT(found.change / found.time, 0.5 * rate);
  }
}

TYPED_TEST(PolyhedraInTheEngine, AFlatBoxSticksBelowTheAngleOfFrictionAndSlidesAbove) {
  const TempFolder folder;
  Scene scene = cube_scene();
  scene.folder.clear();
  scene.particles[0].meshes = {flat_box(folder)};
  scene.particles[0].explicit_particles = {cube_at({-35, 0, 0.2})};
  scene.particles[0].explicit_particles[0].diameter = kCubeDiameter * std::cbrt(1.6);
  expect_sticks_then_slides<TypeParam>(scene, {0.52, 0.7, 1.0});
}

// A cube's weight passes through its face at tan(a) / 2 from the middle, under friction at mu / 2.
// Up to 1/6, the middle third, the whole face stays down; beyond, the cube rocks on half of it and
// its friction with it, before it falls over at 1/2. Hence mu = 0.2 and slopes under 1/3.
TYPED_TEST(PolyhedraInTheEngine, ACubeSticksBelowTheAngleOfFrictionAndSlidesAbove) {
  Scene scene = cube_scene();
  scene.contact.sliding_friction = 0.2;
  scene.particles[0].explicit_particles = {cube_at({-35, 0, 0.5})};
  expect_sticks_then_slides<TypeParam>(scene, {0.22, 0.3});
}

// A box slides at one speed over the edge between two facets of a plate, where one patch ends and
// another begins: friction keeps its spring. One that began anew would give half of it or less.
TYPED_TEST(PolyhedraInTheEngine, AWallSpringSurvivesAChangeOfThePatch) {
  const TempFolder folder;
  for (const double fall : {0.0, 2e-5}) {  // of the second facet, rad; flat up to 1.4e-5
    for (const bool second_first : {false, true}) {
      SCOPED_TRACE(testing::Message() << fall << (second_first ? " second first" : ""));
      Scene scene = cube_scene();
      scene.folder.clear();
      scene.particles[0].meshes = {flat_box(folder)};
      scene.contact.tangential_damping = false;  // friction is the spring's alone
      const double mass = 1.6, mu = 0.5, speed = 0.05;
      const double lean = std::atan(mu);
      scene.run.gravity = Vec3(std::sin(lean), 0, -std::cos(lean));
      scene.particles[0].explicit_particles = {
          cube_at({-1.05, 0, 0.2 - mass * std::cos(lean) / kStiffness})};
      ExplicitParticle& box = scene.particles[0].explicit_particles[0];
      box.diameter = kCubeDiameter * std::cbrt(mass);
      box.velocity = Vec3(speed, 0, 0);
      add_mesh(scene, "plate");
      const Vec3 a(-9, -9, 0), b(0, -9, 0), c(0, 9, 0), d(-9, 9, 0);
      const Vec3 e(9, -9, -9 * fall), f(9, 9, -9 * fall);
      std::vector<Triangle> plate = {{{a, b, c}}, {{a, c, d}}, {{b, e, f}}, {{b, f, c}}};
      if (second_first) std::rotate(plate.begin(), plate.begin() + 2, plate.end());
      World<TypeParam> world = world_of<TypeParam>(scene, {plate});
      Stepper<TypeParam> stepper(world, 1);
      run_steps(world, stepper, 400);
      std::set<Index> features;
      double least = 1;
      while (world.polyhedra.x[0] < 1.02) {
        run_steps(world, stepper, 1);
        ASSERT_EQ(world.polyhedra.walls.size(), 1u);
        ASSERT_LT(world.clock.step, 60000u);
        const PolyhedronWall& wall = world.polyhedra.walls[0];
        features.insert(wall.feature);
        const double pressed = wall.force.dot(wall.normal);
        least = std::min(least, (wall.force - pressed * wall.normal).norm() / (mu * pressed));
      }
      EXPECT_GT(least, 0.9);
      EXPECT_EQ(features.size(), fall > 0 ? 2u : 1u);
    }
  }
}

// Two equal rocks meet with opposite velocities: opposite forces keep these opposite, bit by bit.
// With identities swapped the pair is evaluated from the other side: the same to rounding.
TYPED_TEST(PolyhedraInTheEngine, ForcesOfAPairAreOppositeToTheLastBitWhicheverComesFirst) {
  unsigned state = 7;
  const auto draw = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<double>(state >> 8) / (1 << 23) - 1;
  };
  for (int trial = 0; trial < 30; ++trial) {
    SCOPED_TRACE(trial);
    ExplicitParticle rock[2];
    for (int k = 0; k < 2; ++k) {
      const double side = k == 0 ? -1 : 1;
      rock[k] = cube_at({side * 0.6, 0, 0}, Vec3(draw(), draw(), draw()).normalized(), 3 * draw());
      rock[k].diameter = 1;
      rock[k].velocity = side * Vec3(-0.5, 0.1, 0.05);
    }
    Vec3 after[2][2];
    for (const std::size_t first : {0u, 1u}) {
      Scene scene = cube_scene();
      scene.particles[0].meshes = {"ore12.stl"};
      scene.particles[0].explicit_particles = {rock[first], rock[1 - first]};
      World<TypeParam> world = world_of<TypeParam>(scene);
      Stepper<TypeParam> stepper(world, 1);
      int touching = 0;
      for (int k = 0; k < 400; ++k) {
        run_steps(world, stepper, 1);
        touching += world.totals.polyhedron_pair_contacts > 0 ? 1 : 0;
        const Vec3 one = world.polyhedra.velocity(0), other = world.polyhedra.velocity(1);
        ASSERT_EQ(one, Vec3(-other)) << "step " << k;
      }
      EXPECT_GT(touching, 3);
      EXPECT_GT((world.polyhedra.velocity(0) - rock[first].velocity).norm(), 0.1);
      for (const std::size_t k : {0u, 1u}) {
        after[first][k] = world.polyhedra.velocity(first == 0 ? k : 1 - k);
      }
    }
    EXPECT_LT((after[0][0] - after[1][0]).norm(), 1e-11);
  }
}

// A sphere on a face feels the same spring as on a plane. The cube is so large that it does not
// move.
TYPED_TEST(PolyhedraInTheEngine, ASphereOnAFaceFeelsAPlane) {
  double speed[2] = {};
  for (int k = 0; k < 2; ++k) {
    Scene scene = cube_scene(1);
    const double radius = 0.125, overlap = 1e-3;
    if (k == 0) {
      scene.particles[0].explicit_particles = {cube_at({0, 0, -8})};
      scene.particles[0].explicit_particles[0].diameter = 16 * kCubeDiameter;
    } else {
      scene.particles.clear();
      add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
    }
    ParticleSpec sphere;
    sphere.name = "sphere";
    sphere.material = "ore";
    sphere.explicit_particles = {{{0.3, 0.2, radius - overlap}, {0, 0, 0}, {0, 0, 0}, 2 * radius}};
    scene.particles.push_back(sphere);
    World<TypeParam> world = world_of<TypeParam>(scene);
    Stepper<TypeParam> stepper(world, 1);
    run_steps(world, stepper, 1);
    speed[k] = world.particles.record[0].vz;
    EXPECT_GT(speed[k], 0);
  }
  // The place of the face is right to rounding of a body of 16 m: 16 * 2e-16 over the overlap.
  EXPECT_NEAR(speed[0] / speed[1], 1, 1e-11);
}

// A cube of 0.2 within one of 1: as deep as it goes, so it is counted and stops a run as well.
// While overlaps are capped it is neither.
TYPED_TEST(PolyhedraInTheEngine, ACubeWithinAnotherIsCountedAndIsTooDeep) {
  Scene scene = cube_scene();
  scene.particles[0].explicit_particles = {cube_at({0, 0, 0}), cube_at({0.15, 0.1, 0.05})};
  scene.particles[0].explicit_particles[1].diameter = 0.2 * kCubeDiameter;
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  const StepReport report = stepper.step();
  EXPECT_EQ(report.fallbacks.contained, 1u);
  EXPECT_EQ(report.fallbacks.bounded, 0u);
  EXPECT_EQ(report.fallbacks.wall_depth, 0u);
  EXPECT_EQ(report.bits, std::uint32_t{kDeepOverlap | kOverlapWarning});
  EXPECT_EQ(world.polyhedra.fallbacks.contained, 1u);
  world = world_of<TypeParam>(scene);
  world.overlap_cap = 1e-3;
  Stepper<TypeParam> capped(world, 1);
  EXPECT_FALSE(capped.step().fallbacks.any());
  EXPECT_FALSE(world.polyhedra.fallbacks.any());
}

// Of 12 x 12 squares of side h about the origin, facing up.
std::vector<Triangle> fine_plate(double h) {
  std::vector<Triangle> plate;
  for (int k = 0; k < 144; ++k) {
    const Vec3 at = h * Vec3(k % 12 - 6, k / 12 - 6, 0);
    const Vec3 x = at + h * Vec3::UnitX(), y = at + h * Vec3::UnitY(), xy = x + y - at;
    plate.push_back({{at, x, xy}});
    plate.push_back({{at, xy, y}});
  }
  return plate;
}

// A dozen of 288 triangles below a cube, or all of them: more than the narrow phase has room for.
TYPED_TEST(PolyhedraInTheEngine, ALimitOfTheNarrowPhaseIsCountedInEachStep) {
  for (const double h : {0.5, 0.1}) {
    Scene scene = cube_scene();
    add_mesh(scene, "plate");
    scene.particles[0].explicit_particles = {cube_at({0, 0, 0.499})};
    World<TypeParam> world = world_of<TypeParam>(scene, {fine_plate(h)});
    Stepper<TypeParam> stepper(world, 1);
    run_steps(world, stepper, 2);
    EXPECT_EQ(world.totals.polyhedron_wall_contacts, 1);
    EXPECT_EQ(world.polyhedra.fallbacks.bounded, h < 0.5 ? 2u : 0u);
    EXPECT_EQ(world.polyhedra.fallbacks.wall_depth, 0u);
  }
}

// An overlap of 0.8 of the radius: all that a wall gives, however deep the cube is.
TYPED_TEST(PolyhedraInTheEngine, ACubeDeepInAWallIsCountedAndNotStopped) {
  Scene scene = cube_scene();
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  scene.particles[0].explicit_particles = {cube_at({0, 0, -0.1})};
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  const StepReport report = stepper.step();
  EXPECT_EQ(report.bits, std::uint32_t{kOverlapWarning});
  EXPECT_EQ(report.fallbacks.wall_depth, 1u);
  EXPECT_NEAR(report.max_overlap, 0.5 / (0.5 * kCubeDiameter), 1e-5);
}

// Rocks and balls that fly into each other in empty space.
Scene cloud(double restitution, NormalModel model) {
  Scene scene = cube_scene(restitution);
  scene.contact.normal_model = model;
  scene.particles[0].meshes = {"ore12.stl", "rock_flat_12.stl", "rock_elongated_14.stl"};
  ParticleSpec balls;
  balls.name = "ball";
  balls.material = "ore";
  unsigned state = 1;
  const auto draw = [&](double size) {
    state = state * 1664525u + 1013904223u;
    return size * (static_cast<double>(state >> 8) / (1 << 23) - 1);
  };
  for (int k = 0; k < 27; ++k) {
    const Vec3 cell(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    ExplicitParticle p;
    p.position = 1.7 * cell;
    p.diameter = 1;
    p.velocity = -0.5 * cell + Vec3(draw(0.1), draw(0.1), draw(0.1));
    p.spin = Vec3(draw(0.5), draw(0.5), draw(0.5));
    if (k % 3 == 2) {
      balls.explicit_particles.push_back(p);
    } else {
      p.orientation = Turn{Vec3(draw(1), draw(1), draw(1)), draw(3)};
      scene.particles[0].explicit_particles.push_back(p);
    }
  }
  scene.particles.push_back(balls);
  return scene;
}

template <class Real>
void add_momenta(const World<Real>& world, Vec3& linear, Vec3& angular, double& size) {
  linear = angular = Vec3::Zero();
  size = 0;
  const double dt = world.clock.dt;
  const auto add = [&](double mass, const Vec3& x, const Vec3& v, const Vec3& spin) {
    linear += mass * v;
    // Places are those of the whole step, velocities of the half step before.
    angular += mass * (x - 0.5 * dt * v).cross(v) + spin;
    size += mass * v.norm();
  };
  const Particles<Real>& p = world.particles;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Record<Real>& r = p.record[k];
    const double mass = 1 / static_cast<double>(p.traits[k].inverse_mass);
    const double radius = static_cast<double>(r.radius);
    add(mass, {r.x, r.y, r.z}, {r.vx, r.vy, r.vz},
        0.4 * mass * radius * radius * Vec3(p.spin_x[k], p.spin_y[k], p.spin_z[k]));
  }
  for (std::size_t k = 0; k < world.polyhedra.size(); ++k) {
    add(1 / world.polyhedra.inverse_mass[k], world.polyhedra.place(k), world.polyhedra.velocity(k),
        world.polyhedra.momentum(k));
  }
}

TYPED_TEST(PolyhedraInTheEngine, MomentumAndItsMomentAreConserved) {
  for (const NormalModel model : {NormalModel::kStiffness, NormalModel::kVolume}) {
    World<TypeParam> world = world_of<TypeParam>(cloud(0.5, model));
    Stepper<TypeParam> stepper(world, 1);
    Vec3 linear, angular, linear_now, angular_now;
    double size, contacts[3] = {0, 0, 0};
    add_momenta(world, linear, angular, size);
    for (int k = 0; k < 4000; ++k) {
      ASSERT_EQ(stepper.step().bits & kFatalBits, 0u);
      contacts[0] += world.totals.polyhedron_sphere_contacts;
      contacts[1] += world.totals.polyhedron_pair_contacts;
      contacts[2] += world.totals.pair_contacts;
    }
    add_momenta(world, linear_now, angular_now, size);
    EXPECT_GT(contacts[0], 100);
    EXPECT_GT(contacts[1], 100);
    // Pair forces of spheres are f32 in mixed, but opposite to the last bit; sums are f64. Their
    // torques on both sides are rounded each for itself: 6e-8 of each, lengths of 1 m.
    const double eps = sizeof(TypeParam) == 4 ? 1e-7 : 1e-12;
    EXPECT_LT((linear_now - linear).norm(), 1e-12 * size);
    EXPECT_LT((angular_now - angular).norm(), eps * size);
  }
}

TYPED_TEST(PolyhedraInTheEngine, EnergyIsAccountedForToTheLastContact) {
  for (const NormalModel model : {NormalModel::kStiffness, NormalModel::kVolume}) {
    World<TypeParam> world = world_of<TypeParam>(cloud(0.5, model));
    Stepper<TypeParam> stepper(world, 1);
    for (int k = 0; k < 4000; ++k) ASSERT_EQ(stepper.step().bits & kFatalBits, 0u);
    const Ledger& l = world.ledger;
    const double missing = l.start_kinetic + l.start_elastic - l.kinetic - l.elastic;
    EXPECT_GT(l.dissipated(), 0.01 * l.start_kinetic);
    // Free rotation keeps the energy of the half steps' product to (w dt)^2 only.
    EXPECT_NEAR(l.dissipated() / missing, 1, 1e-3);
    // The volume model has a potential; what is left is the error of the step.
    if (model == NormalModel::kVolume) {
      EXPECT_LT(std::abs(l.model_work), 5e-3 * l.dissipated());
    }
  }
}

}  // namespace
}  // namespace quern::test
