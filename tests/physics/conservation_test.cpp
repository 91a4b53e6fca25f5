// What is conserved, and to which order; symmetries of every pair type under every option of the
// law.
//
// Pair types: two spheres, a sphere on a rock, two rocks, spheres and rocks on a plate of
// triangles, all in one scene. The scene is moved, turned, mirrored, its bodies are given other
// identities: the result is to be the same one moved, turned, mirrored, renamed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

#include "io/mesh_reader.h"
#include "tests/support/small_scene.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_walls.h"

namespace quern::test {
namespace {

// Largest error of the energy in a gas of elastic spheres without friction, over the time of some
// tens of collisions.
template <class Real>
double energy_error(double steps) {
  Law law;
  law.restitution = 1;
  law.sliding = 0;
  law.tangential_damping = false;
  const double d = 1.0 / 64, contact = normal_contact_time(0.5 * sphere_mass(d), law.kn);
  Scene scene = small_scene(law, contact / steps);
  scene.domain.low = Vec3::Zero();
  scene.domain.high = Vec3::Constant(6 * d);
  for (bool& p : scene.domain.periodic) p = true;
  Random random(4);
  for (int k = 0; k < 64; ++k) {
    const Vec3 cell(k % 4, k / 4 % 4, k / 16);
    add_sphere(scene, d, 1.5 * d * (cell + Vec3::Constant(0.5)) + random.in_cube(0.2 * d),
               random.in_cube(1));
  }
  World<Real> world = world_of<Real>(scene);
  Stepper<Real> stepper(world, 1);
  double sum = 0, first = 0;
  const int count = static_cast<int>(100 * steps);
  for (int k = 0; k < count; ++k) {
    EXPECT_EQ(stepper.step().bits & kFatalBits, 0u);
    const double energy =
        world.totals.translational + world.totals.rotational + world.totals.elastic;
    if (k == 0) first = energy;
    sum += std::pow(energy / first - 1, 2);
  }
  return std::sqrt(sum / count);
}

// Without damping and friction the step is leapfrog: the energy is right to the second order. Hits
// start and end between steps, which adds an error of the same order at random to each.
TEST(EnergyOfElasticSpheres, IsRightToTheSquareOfTheStep) {
  double error[3];
  for (int k = 0; k < 3; ++k) {
    error[k] = energy_error<double>(20 << k);
    std::printf("  %d steps per contact: %.3g\n", 20 << k, error[k]);
  }
  EXPECT_LT(error[0], 1e-4);
  EXPECT_NEAR(error[0] / error[1], 4, 1);
  EXPECT_NEAR(error[1] / error[2], 4, 1);
}

struct LawCase {
  const char* name;
  NormalForce force;
  bool damping;
  double rolling;
  OverlapMeasure overlap;
  NormalModel model;
  ForceLaw springs = ForceLaw::kLinearSpringDashpot;
};
constexpr LawCase kLaws[] = {
    {"Clamped", NormalForce::kClamped, true, 0, OverlapMeasure::kChord, NormalModel::kStiffness},
    {"Rolling", NormalForce::kClamped, true, 0.05, OverlapMeasure::kChord, NormalModel::kStiffness},
    {"Unclamped", NormalForce::kUnclamped, false, 0, OverlapMeasure::kChord,
     NormalModel::kStiffness},
    {"Width", NormalForce::kClamped, true, 0, OverlapMeasure::kWidth, NormalModel::kStiffness},
    {"Volume", NormalForce::kClamped, true, 0, OverlapMeasure::kChord, NormalModel::kVolume},
    {"Hertz", NormalForce::kClamped, true, 0.05, OverlapMeasure::kChord, NormalModel::kStiffness,
     ForceLaw::kHertzMindlin}};

struct Change {
  Mat3 turn = Mat3::Identity();  // may be a reflection
  Vec3 shift = Vec3::Zero();
  std::vector<std::size_t> spheres = {0, 1, 2}, rocks = {0, 1, 2};  // order of identities
};

struct State {
  Vec3 place, velocity, spin;
};

struct Seed {
  Vec3 place, velocity, spin;
};
// Apart from each other at first, they fall together on the plate; spheres, then rocks.
const Seed kSpheres[] = {{{0.1, 0.0, 1.95}, {0.05, 0.1, -1}, {0.2, 0.4, -0.5}},
                         {{1.35, -0.1, 0.55}, {-0.6, 0, -0.3}, {0.5, -0.2, 0.1}},
                         {{-0.1, 1.15, 2.05}, {0.1, -0.5, -0.9}, {0, 0.3, 0.7}}};
const Seed kRocks[] = {{{0.0, 0.0, 0.75}, {0.3, 0.1, -0.5}, {0.3, -0.2, 0.4}},
                       {{0.2, 1.45, 0.8}, {0.05, -0.7, -0.4}, {-0.2, 0.1, 0.3}},
                       {{1.3, 0.9, 1.75}, {-0.6, -0.4, -1.1}, {0.1, 0.6, -0.3}}};

void write_mesh(const std::string& path, const std::vector<Triangle>& mesh) {
  std::ofstream out(path);
  out.precision(17);
  out << "solid s\n";
  for (const Triangle& t : mesh) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& c : t.corner)
      out << "vertex " << c.x() << ' ' << c.y() << ' ' << c.z() << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid s\n";
}

class Heap {
 public:
  Heap(const LawCase& law, const Change& change)
      : law_(law), change_(change), handed_(change.turn.determinant()) {
    std::vector<Triangle> rock =
        read_stl(QUERN_SOURCE_DIR "/apps/shapes/rock_blocky_10.stl", 1).triangles;
    if (handed_ < 0) rock = turned_over(moved(rock, change.turn, Vec3::Zero()));
    write_mesh(folder_ / "rock.stl", rock);
  }

  // Spheres and rocks after the run, in the frame of the unchanged scene and in its order.
  template <class Real>
  std::vector<State> run() {
    World<Real> world = world_of<Real>(scene(), {plate()});
    Stepper<Real> stepper(world, 1);
    double contacts[5] = {};
    for (int k = 0; k < 1800; ++k) {
      const StepReport report = stepper.step();
      EXPECT_EQ(report.bits, 0u);  // no overlap above half a radius either
      const StepTotals& t = world.totals;
      contacts[0] += t.pair_contacts - t.polyhedron_sphere_contacts - t.polyhedron_pair_contacts;
      contacts[1] += t.polyhedron_sphere_contacts;
      contacts[2] += t.polyhedron_pair_contacts;
      contacts[3] += t.wall_contacts - t.polyhedron_wall_contacts;
      contacts[4] += t.polyhedron_wall_contacts;
    }
    for (const double count : contacts) EXPECT_GE(count, 10);
    std::vector<State> out(6);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index id = static_cast<Index>(k);
      out[change_.spheres[k]] =
          back(place_of(world, id), velocity_of(world, id), spin_of(world, id));
      out[3 + change_.rocks[k]] =
          back(world.polyhedra.place(k), world.polyhedra.velocity(k), world.polyhedra.spin(k));
    }
    return out;
  }

 private:
  static constexpr double kStiffness = 1e4;

  Scene scene() const {
    Law law;
    law.kn = kStiffness;
    law.kt = 0.4 * kStiffness;
    law.springs = law_.springs;
    law.young = 3e5;  // as stiff as the linear springs at an overlap of a hundredth
    law.rolling = law_.rolling;
    law.normal_force = law_.force;
    law.tangential_damping = law_.damping;
    Scene scene = small_scene(law, kPi * std::sqrt(1 / kStiffness) / 40, 60);
    scene.domain.low = change_.shift - Vec3::Constant(60);
    scene.domain.high = change_.shift + Vec3::Constant(60);
    scene.contact.overlap = law_.overlap;
    scene.contact.normal_model = law_.model;
    if (law_.model == NormalModel::kVolume) scene.contact.volume_stiffness = 1e3;
    scene.materials[0].density = 1;
    scene.folder = folder_.path();
    scene.run.gravity = change_.turn * Vec3(0, 0, -1);
    add_mesh(scene, "plate");
    ParticleSpec rocks = scene.particles[0];
    rocks.name = "rock";
    rocks.shape = ShapeKind::kPolyhedron;
    rocks.meshes = {"rock.stl"};
    for (const std::size_t k : change_.spheres) {
      scene.particles[0].explicit_particles.push_back(body(kSpheres[k], 1));
    }
    for (const std::size_t k : change_.rocks) {
      ExplicitParticle rock = body(kRocks[k], 1);
      const Mat3 lies =
          Eigen::AngleAxisd(0.5 + static_cast<double>(k), Vec3(1, 2, 3).normalized()).matrix();
      // Of a mirrored mesh: the mirror, the turn, the mirror.
      const Mat3 turn = handed_ < 0 ? Mat3(change_.turn * lies * change_.turn.transpose())
                                    : Mat3(change_.turn * lies);
      const Eigen::AngleAxisd about(turn);
      rock.orientation = Turn{about.axis(), about.angle()};
      rocks.explicit_particles.push_back(rock);
    }
    scene.particles.push_back(rocks);
    return scene;
  }

  ExplicitParticle body(const Seed& seed, double diameter) const {
    ExplicitParticle p;
    p.position = change_.turn * seed.place + change_.shift;
    p.velocity = change_.turn * seed.velocity;
    p.spin = handed_ * (change_.turn * seed.spin);
    p.diameter = diameter;
    return p;
  }

  std::vector<Triangle> plate() const {
    const Vec3 a(-9, -8, 0), b(10, -9, 0), c(9, 11, 0), d(-10, 9, 0);
    std::vector<Triangle> all = moved({{{a, b, c}}, {{a, c, d}}}, change_.turn, change_.shift);
    return handed_ < 0 ? turned_over(all) : all;
  }

  State back(const Vec3& place, const Vec3& velocity, const Vec3& spin) const {
    const Mat3 turn = change_.turn.transpose();
    return {turn * (place - change_.shift), turn * velocity, handed_ * (turn * spin)};
  }

  TempFolder folder_;
  LawCase law_;
  Change change_;
  double handed_;
};

double difference(const std::vector<State>& a, const std::vector<State>& b) {
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    worst = std::max({worst, (a[k].place - b[k].place).norm(),
                      (a[k].velocity - b[k].velocity).norm(), (a[k].spin - b[k].spin).norm()});
  }
  return worst;
}

class SymmetryOf : public testing::TestWithParam<LawCase> {
 protected:
  // Places are rounded to 1e-16 of lengths of 1, meshes and turns likewise; that over overlaps of
  // 1e-3 ... 1e-2 is 1e-13, which a dozen collisions multiply by up to 1e5. Contacts of spheres are
  // f32 in mixed: the same with 6e-8, but for fewer collisions.
  template <class Real>
  static void expect_same(const Change& change) {
    const double worst =
        difference(Heap(GetParam(), change).run<Real>(), Heap(GetParam(), {}).run<Real>());
    std::printf("  %s: %.2g\n", sizeof(Real) == 4 ? "mixed" : "double", worst);
    EXPECT_LT(worst, sizeof(Real) == 4 ? 5e-4 : 1e-8);
  }
  static void expect_same_in_both(const Change& change) {
    expect_same<float>(change);
    expect_same<double>(change);
  }
};

TEST_P(SymmetryOf, MovingMoves) {
  Change change;
  change.shift = Vec3(1.25, -2.5, 0.75);
  expect_same_in_both(change);
}
TEST_P(SymmetryOf, TurningTurns) {
  Change change;
  change.turn = Random(2).turn();
  expect_same_in_both(change);
}
TEST_P(SymmetryOf, MirroringMirrors) {
  Change change;
  change.turn = Random(7).turn() * Vec3(1, -1, 1).asDiagonal();
  expect_same_in_both(change);
}
TEST_P(SymmetryOf, RenamingRenames) {
  Change change;
  change.spheres = {2, 0, 1};
  change.rocks = {1, 2, 0};
  expect_same_in_both(change);
  change.spheres = {1, 0, 2};
  change.rocks = {2, 1, 0};
  expect_same_in_both(change);
}

INSTANTIATE_TEST_SUITE_P(Laws, SymmetryOf, testing::ValuesIn(kLaws),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace quern::test
