// Oblique impacts and sliding to rolling against runs of independent solvers (LAMMPS, LIGGGHTS, see
// tests/golden/README.md), with the same law: unclamped
// normal force, no tangential damping.
//
// All angles of a case run side by side in one world, far from each other. Limits: rebound
// velocities and rim speeds (spin times radius) within 0.5 % of the speed of impact, at 370 and
// more steps per contact. Of these, half a step of the dashpot at entry and exit is at most 2 zeta
// w dt e = 0.16 %, and arms (the other solver takes the radius, this engine the distance to the
// contact point) differ by half the overlap, below 0.25 % of the radius. Hertz-Mindlin: 0.1 %, at
// 500 and more steps of contacts that begin and end softly.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

using Row = std::map<std::string, double>;

std::vector<Row> read_csv(const std::string& name) {
  std::ifstream file(QUERN_SOURCE_DIR "/tests/golden/" + name);
  const auto cells = [](const std::string& line) {
    std::vector<std::string> all;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) all.push_back(cell);
    return all;
  };
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> head = cells(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cell = cells(line);
    EXPECT_EQ(cell.size(), head.size()) << name << ": " << line;
    Row row;
    for (std::size_t k = 0; k < cell.size(); ++k) row[head[k]] = std::stod(cell[k]);
    rows.push_back(row);
  }
  EXPECT_FALSE(rows.empty()) << name;
  return rows;
}

// Rows of one run's parameters: the file has them one after another, angles rising.
std::vector<std::vector<Row>> cases_of(const std::vector<Row>& rows) {
  std::vector<std::vector<Row>> cases;
  for (const Row& row : rows) {
    if (cases.empty() || row.at("angle_deg") <= cases.back().back().at("angle_deg")) {
      cases.emplace_back();
    }
    cases.back().push_back(row);
  }
  return cases;
}

bool is_hertz(const Row& c) { return c.count("young") > 0; }

// Spheres hit what is of the second material.
Scene scene_of_case(const Row& c) {
  Law law = peer_law(c.at("restitution"), c.at("mu"));
  if (is_hertz(c)) {
    law.springs = ForceLaw::kHertzMindlin;
    law.young = c.at("young");
    law.poisson = c.at("poisson");
  } else {
    law.kn = c.at("kn");
    law.kt = c.at("kt");
  }
  Scene scene = small_scene(law, c.at("dt"));
  scene.materials[0].density = c.at("density");
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "other";
  if (is_hertz(c)) {
    scene.materials[1].young_modulus = c.at("young2");
    scene.materials[1].poisson_ratio = c.at("poisson2");
  }
  return scene;
}

// Long enough for the slowest approach (85 degrees), its contact and some steps more.
int steps_of_case(const Row& c, double reduced_mass, double reduced_radius) {
  const double gap = 1e-6, slowest = c.at("v0") * std::cos(85 * kPi / 180);
  double contact = 0;
  if (is_hertz(c)) {
    const double modulus = 4.0 / 3 /
                           ((1 - std::pow(c.at("poisson"), 2)) / c.at("young") +
                            (1 - std::pow(c.at("poisson2"), 2)) / c.at("young2"));
    contact = hertz_contact_time(reduced_mass, reduced_radius, modulus, slowest);
  } else {
    contact = normal_contact_time(reduced_mass, c.at("kn"));
  }
  return static_cast<int>((gap / slowest + 1.5 * contact) / c.at("dt")) + 10;
}

// Of v0. LIGGGHTS takes the arms that this engine takes.
double limit_of(const Row& c) { return is_hertz(c) ? 1e-3 : 5e-3; }

// Of the two solvers' results, over the speed of impact.
struct Differences {
  double worst = 0;
  void add(const Row& r, const Vec3& off) {
    const double share = off.norm() / r.at("v0");
    worst = std::max(worst, share);
    EXPECT_LT(share, limit_of(r)) << "e " << r.at("restitution") << ", " << r.at("angle_deg")
                                  << " degrees";
  }
  ~Differences() {
    std::printf("  largest difference %.2g %% of the speed of impact\n", 100 * worst);
  }
};

template <class Real>
void compare_on_plane(const std::string& file) {
  Differences differences;
  for (const std::vector<Row>& rows : cases_of(read_csv(file))) {
    const Row& c = rows.front();
    const double radius = 0.5 * c.at("diameter"), v0 = c.at("v0");
    Scene scene = scene_of_case(c);
    add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
    scene.planes[0].material = "other";
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double angle = rows[k].at("angle_deg") * kPi / 180;
      add_sphere(scene, c.at("diameter"), {0, 0.1 * static_cast<double>(k), radius + 1e-6},
                 {v0 * std::sin(angle), 0, -v0 * std::cos(angle)});
    }
    World<Real> world = world_of<Real>(scene);
    Stepper<Real> stepper(world, 1);
    const double mass = sphere_mass(c.at("diameter"), c.at("density"));
    run_steps(world, stepper, steps_of_case(c, mass, radius));
    for (Index k = 0; k < rows.size(); ++k) {
      const Row& r = rows[k];
      differences.add(r, velocity_of(world, k) - Vec3(r.at("vx"), 0, r.at("vz")));
      differences.add(r, radius * (spin_of(world, k) - Vec3(0, r.at("omega_y"), 0)));
    }
  }
}

template <class Real>
void compare_pairs(const std::string& file) {
  Differences differences;
  for (const std::vector<Row>& rows : cases_of(read_csv(file))) {
    const Row& c = rows.front();
    const double r1 = 0.5 * c.at("diameter"), r2 = 0.5 * c.at("diameter2"), v0 = c.at("v0");
    Scene scene = scene_of_case(c);
    scene.particles.push_back(scene.particles[0]);
    scene.particles[1].name = scene.particles[1].material = "other";
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double angle = rows[k].at("angle_deg") * kPi / 180;
      const Vec3 course(std::cos(angle), std::sin(angle), 0);
      const Vec3 touch(0, 0, 0.2 * static_cast<double>(k));
      add_sphere(scene, c.at("diameter"), touch - 1e-6 * course, v0 * course);
      scene.particles[1].explicit_particles.push_back(
          {touch + Vec3(r1 + r2, 0, 0), Vec3::Zero(), Vec3::Zero(), c.at("diameter2")});
    }
    World<Real> world = world_of<Real>(scene);
    Stepper<Real> stepper(world, 1);
    const double m1 = sphere_mass(2 * r1, c.at("density")),
                 m2 = sphere_mass(2 * r2, c.at("density"));
    run_steps(world, stepper, steps_of_case(c, m1 * m2 / (m1 + m2), r1 * r2 / (r1 + r2)));
    const Index all = static_cast<Index>(rows.size());
    for (Index k = 0; k < all; ++k) {
      const Row& r = rows[k];
      differences.add(r, velocity_of(world, k) - Vec3(r.at("v1x"), r.at("v1y"), 0));
      differences.add(r, velocity_of(world, all + k) - Vec3(r.at("v2x"), r.at("v2y"), 0));
      differences.add(r, r1 * (spin_of(world, k) - Vec3(0, 0, r.at("omega1_z"))));
      differences.add(r, r2 * (spin_of(world, all + k) - Vec3(0, 0, r.at("omega2_z"))));
    }
  }
}

template <class Real>
class Impacts : public testing::Test {};
TYPED_TEST_SUITE(Impacts, Precisions, Names);

TYPED_TEST(Impacts, OnAPlaneReboundAsInLammps) { compare_on_plane<TypeParam>("impacts_plane.csv"); }

TYPED_TEST(Impacts, OfTwoSizesReboundAsInLammps) { compare_pairs<TypeParam>("impacts_pair.csv"); }

TYPED_TEST(Impacts, OnAPlaneWithHertzMindlinReboundAsInLiggghts) {
  compare_on_plane<TypeParam>("hertz_impacts_plane.csv");
}

TYPED_TEST(Impacts, OfTwoSizesWithHertzMindlinReboundAsInLiggghts) {
  compare_pairs<TypeParam>("hertz_impacts_pair.csv");
}

TYPED_TEST(Impacts, SlidingTurnsIntoRollingAsInLammps) {
  const std::vector<Row> rows = read_csv("sliding_to_rolling.csv");
  Scene scene = shipped_scene("slide_to_roll");
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  const double radius = 0.01, v0 = 1;
  double worst = 0;
  for (const Row& r : rows) {
    run_until(world, stepper, r.at("t"));
    // 0.2 % of v0; the engine's velocity is half a step older: mu g dt / 2 = 2.5e-6 m/s.
    const double off = velocity_of(world, 0).x() - r.at("vx");
    const double spin_off = radius * (spin_of(world, 0).y() - r.at("omega_y"));
    const double place_off = place_of(world, 0).x() - r.at("x");
    worst = std::max({worst, std::abs(off), std::abs(spin_off)});
    EXPECT_NEAR(off, 0, 2e-3 * v0) << "t " << r.at("t");
    EXPECT_NEAR(spin_off, 0, 2e-3 * v0) << "t " << r.at("t");
    EXPECT_NEAR(place_off, 0, 2e-3 * v0 * std::max(r.at("t"), 1e-6)) << "t " << r.at("t");
  }
  std::printf("  largest difference %.2g %% of v0\n", 100 * worst / v0);
}

}  // namespace
}  // namespace quern::test
