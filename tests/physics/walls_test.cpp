// Spheres on walls that stand still: the triangulation must not be felt, corners and edges give the
// contacts that geometry says, and what a wall receives is what the charge loses.
//
// The oracle of a random triangulation is the same run on a plate of two triangles.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/laws/damping.h"
#include "tests/support/small_scene.h"
#include "tests/support/test_walls.h"

namespace quern::test {
namespace {

constexpr double kRadius = 1.0 / 128, kGravity = 9.81;

template <class Real>
class Walls : public testing::Test {};
TYPED_TEST_SUITE(Walls, Precisions, Names);

double rest_overlap(const Law& law, double dt) {
  const double mass = sphere_mass(2 * kRadius);
  const double zeta = damping_ratio(law.restitution, law.normal_force);
  return mass * kGravity / law.kn * (1 + zeta * std::sqrt(law.kn / mass) * dt);
}

struct Track {
  std::vector<Vec3> place, velocity;
  int most_contacts = 0, least_contacts = 100;
};

// A sphere rolls over the plate z = 0, turned by `turn`, for 1 s under rolling friction.
template <class Real>
Track roll(const std::vector<Triangle>& plate, const Mat3& turn) {
  Law law;
  law.rolling = 0.02;
  const double dt = 1e-5;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = turn * Vec3(0, 0, -kGravity);
  add_mesh(scene, "plate");
  const Vec3 velocity(0.9, 0.37, 0), spin = Vec3::UnitZ().cross(velocity) / kRadius;
  add_sphere(scene, 2 * kRadius, turn * Vec3(-0.51, -0.22, kRadius - rest_overlap(law, dt)),
             turn * velocity, turn * spin);
  World<Real> world = world_of<Real>(scene, {moved(plate, turn, Vec3::Zero())});
  Stepper<Real> stepper(world, 1);
  Track track;
  for (int k = 1; k <= 100000; ++k) {
    stepper.step();
    const int contacts = static_cast<int>(world.totals.wall_contacts);
    track.most_contacts = std::max(track.most_contacts, contacts);
    track.least_contacts = std::min(track.least_contacts, contacts);
    if (k % 5000 != 0) continue;
    track.place.push_back(place_of(world, 0));
    track.velocity.push_back(velocity_of(world, 0));
  }
  return track;
}

TYPED_TEST(Walls, RollingAcrossAnyTriangulationIsRollingOnAPlane) {
  // 1e-10 of the speed is the limit of the method in f64; with f32 spins two runs differ by
  // roundings of the spin, 6e-8 each, which friction takes back.
  const double limit = sizeof(TypeParam) == 8 ? 1e-10 : 1e-6;
  Random random(7);
  const Vec3 a(-1, -1, 0), b(1, -1, 0), c(1, 1, 0), d(-1, 1, 0);
  const std::vector<Triangle> two = {{{a, b, c}}, {{a, c, d}}};
  for (const bool turned : {false, true}) {
    const Mat3 turn = turned ? random.turn() : Mat3(Mat3::Identity());
    const Track plain = roll<TypeParam>(two, turn);
    for (const bool t_junctions : {false, true}) {
      const Track cut = roll<TypeParam>(random_plate(400, t_junctions, random), turn);
      EXPECT_EQ(cut.most_contacts, 1);
      EXPECT_EQ(cut.least_contacts, 1);
      ASSERT_EQ(cut.place.size(), plain.place.size());
      for (std::size_t k = 0; k < plain.place.size(); ++k) {
        EXPECT_LT((cut.place[k] - plain.place[k]).norm(), limit) << k;
        EXPECT_LT((cut.velocity[k] - plain.velocity[k]).norm(), limit * 0.97) << k;
      }
    }
    // And the speed falls as on an analytic plane: 5/7 mu_r g, arms are 5e-7 short, loading the
    // spring takes a part of 1e-4 of the first step's slip, spins are 6e-8.
    const double speed = std::sqrt(0.9 * 0.9 + 0.37 * 0.37), time = 1 - 0.5e-5;
    EXPECT_NEAR(plain.velocity.back().norm(), speed - 5.0 / 7 * 0.02 * kGravity * time,
                2e-6 * speed + 1e-5);
  }
}

// A lifter on a floor, seen along -y: height 10 mm, top 10 mm, faces 14 degrees from the upright.
struct LifterSection {
  double height = 0.010, half_top = 0.005, slope = std::tan(14 * kPi / 180);
  double half_base() const { return half_top + height * slope; }

  std::vector<Triangle> surface() const {
    const std::vector<Vec3> profile = {{-0.1, 0, 0},           {-half_base(), 0, 0},
                                       {-half_top, 0, height}, {half_top, 0, height},
                                       {half_base(), 0, 0},    {0.1, 0, 0}};
    std::vector<Triangle> out;
    const Vec3 y(0, 0.1, 0);
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
      const Vec3 p = profile[k] - y, q = profile[k + 1] - y, r = profile[k + 1] + y,
                 s = profile[k] + y;
      out.push_back({{p, q, r}});
      out.push_back({{p, r, s}});
    }
    return out;
  }
};

TYPED_TEST(Walls, SphereInTheFootOfALifterRestsOnTwoContacts) {
  const LifterSection lifter;
  Law law;
  law.sliding = 0;  // friction would hold the sphere where it was wedged first
  Scene scene = small_scene(law, 1e-5);
  // Into the corner, so that floor and face share the weight.
  const Vec3 face(std::cos(14 * kPi / 180), 0, std::sin(14 * kPi / 180));
  const Vec3 down = -(face + Vec3::UnitZ()).normalized();
  scene.run.gravity = kGravity * down;
  add_mesh(scene, "lifter");
  // Touches the face half way up the radius: R (1 + sin) / cos from the foot along the floor.
  const double x =
      lifter.half_base() + kRadius * (1 - std::sin(14 * kPi / 180)) / std::cos(14 * kPi / 180);
  add_sphere(scene, 2 * kRadius, {x, 0, kRadius});
  World<TypeParam> world = world_of<TypeParam>(scene, {lifter.surface()});
  Stepper<TypeParam> stepper(world, 1);
  run_until(world, stepper, 0.05);
  EXPECT_EQ(world.totals.wall_contacts, 2);
  EXPECT_LT(velocity_of(world, 0).norm(), 1e-9);
  ASSERT_EQ(world.tile_walls[0].springs.size(), 2u);
  const double weight = sphere_mass(2 * kRadius) * kGravity;
  for (const WallSpring& s : world.tile_walls[0].springs) {
    const bool on_floor = s.normal.z() > 0.9;
    // Normals of faces are exact to rounding.
    EXPECT_LT((s.normal - (on_floor ? Vec3(Vec3::UnitZ()) : face)).norm(), 1e-12);
    // By symmetry each takes half: weight / (2 cos(half the angle between the normals)).
    const double half_angle = 0.5 * std::acos(face.z());
    EXPECT_NEAR(s.force.dot(s.normal), 0.5 * weight / std::cos(half_angle), 1e-5 * weight);
  }
  const WallTotal& total = world.wall_totals[0];
  const Vec3 force(total.force[0], total.force[1], total.force[2]);
  // f32 mass: 6e-8.
  EXPECT_LT((force - weight * down).norm(), 1e-6 * weight);
}

TYPED_TEST(Walls, EdgeOfALifterIsOneContactAndTurnsACentralHitRound) {
  const LifterSection lifter;
  Law law;
  law.restitution = 1;
  law.sliding = 0;
  const double dt = normal_contact_time(sphere_mass(2 * kRadius), law.kn) / 50;
  for (const double degrees : {5.0, 30.0, 60.0, 80.0}) {
    // Directions between the normals of top plate (0) and face (76 degrees from it) hit the edge
    // alone; beyond them the nearest point lies on the face, off centre.
    const double angle = degrees * kPi / 180;
    const Vec3 out(std::sin(angle), 0, std::cos(angle));
    const Vec3 edge(lifter.half_top, 0.013, lifter.height);
    const Vec3 face(std::cos(14 * kPi / 180), 0, std::sin(14 * kPi / 180));
    const double reach = (kRadius + 0.3 * dt) / (degrees < 76 ? 1 : out.dot(face));
    Scene scene = small_scene(law, dt);
    add_mesh(scene, "lifter");
    add_sphere(scene, 2 * kRadius, edge + reach * out, -out);
    World<TypeParam> world = world_of<TypeParam>(scene, {lifter.surface()});
    Stepper<TypeParam> stepper(world, 1);
    int touching = 0;
    for (int k = 0; k < 80; ++k) {
      stepper.step();
      EXPECT_LE(world.totals.wall_contacts, 1);
      touching += world.totals.wall_contacts > 0 ? 1 : 0;
    }
    EXPECT_NEAR(touching, 50, 1.01) << degrees;
    if (degrees < 76) {
      // (w dt)^2 / 8 of an elastic hit; a central one stays central to rounding.
      EXPECT_NEAR(velocity_of(world, 0).dot(out), 1, 5e-4) << degrees;
      EXPECT_LT(velocity_of(world, 0).cross(out).norm(), 1e-9) << degrees;
    } else {
      const Vec3 mirrored = -out + 2 * out.dot(face) * face;
      EXPECT_LT((velocity_of(world, 0) - mirrored).norm(), 1e-3) << degrees;
    }
  }
}

TYPED_TEST(Walls, SphereRollingOffALifterKeepsOneContactOverTheEdge) {
  const LifterSection lifter;
  Scene scene = small_scene(Law(), 1e-5);
  scene.run.gravity = {0, 0, -kGravity};
  add_mesh(scene, "lifter");
  // Slowly over the edge at x = 5 mm: it pivots about the edge, then leaves it.
  const double speed = 0.02, overlap = rest_overlap(Law(), 1e-5);
  add_sphere(scene, 2 * kRadius, {0.004, 0.013, lifter.height + kRadius - overlap}, {speed, 0, 0},
             {0, speed / kRadius, 0});
  World<TypeParam> world = world_of<TypeParam>(scene, {lifter.surface()});
  Stepper<TypeParam> stepper(world, 1);
  bool has_left = false;
  double least_height = 1;
  while (!has_left && world.time() < 1) {
    stepper.step();
    ASSERT_LE(world.totals.wall_contacts, 1) << world.time();
    has_left = world.totals.wall_contacts == 0;
    if (!has_left) least_height = place_of(world, 0).z() - lifter.height;
  }
  ASSERT_TRUE(has_left);
  // A sphere that pivots about an edge without slip from rest leaves it at cos a = 10/17; friction
  // of 0.5 lets it slip a little before, and the speed of 20 mm/s adds v^2 / (g R) = 0.5 %.
  const double angle = std::acos(least_height / kRadius);
  EXPECT_GT(angle, 0.6);
  EXPECT_LT(angle, std::acos(10.0 / 17) + 0.02);
}

TYPED_TEST(Walls, WallUnderASphereAtRestCarriesItsWeight) {
  const Law law;
  Scene scene = small_scene(law, 1e-5);
  scene.run.gravity = {0, 0, -kGravity};
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_sphere(scene, 2 * kRadius, {0.1, 0.2, kRadius + 1e-4});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  run_until(world, stepper, 0.2);
  const double weight = sphere_mass(2 * kRadius) * kGravity;
  const auto& force = world.wall_totals[0].force;
  EXPECT_NEAR(force[2] / -weight, 1, 1e-6);  // f32 mass: 6e-8
  EXPECT_NEAR(force[0], 0, 1e-12 * weight);
  EXPECT_NEAR(force[1], 0, 1e-12 * weight);
}

TYPED_TEST(Walls, ChangeOfMomentumIsTheSumOfForcesInEveryStep) {
  Law law;
  law.restitution = 0.8;
  Scene scene = small_scene(law, 1e-5);
  scene.run.gravity = {0.5, -kGravity, 0.2};
  BoxSpec box;
  box.name = "box";
  box.material = "ore";
  box.low = Vec3::Zero();
  box.high = Vec3::Constant(0.1);
  scene.boxes = {box};
  Random random(3);
  for (int k = 0; k < 27; ++k) {
    const Vec3 place(0.02 + 0.03 * (k % 3), 0.02 + 0.03 * (k / 3 % 3), 0.02 + 0.03 * (k / 9));
    add_sphere(scene, 2 * kRadius, place, random.in_cube(3), random.in_cube(100));
  }
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  const auto vec = [](const std::array<double, 3>& v) { return Vec3(v[0], v[1], v[2]); };
  stepper.step();
  Vec3 momentum, force;
  double worst = 0, size = 0;
  for (int k = 0; k < 20000; ++k) {
    stepper.step();
    if (k > 0) {
      const Vec3 change = vec(world.totals.momentum) - momentum;
      const Vec3 expected = world.clock.dt * (world.total_mass * world.gravity - force);
      worst = std::max(worst, (change - expected).norm());
    }
    momentum = vec(world.totals.momentum);
    force = vec(world.wall_totals[0].force);
    size = std::max(size, momentum.norm());
  }
  // Sums of 27 terms m v, each good to an ulp: 27 x 1e-16 x the sum of m |v| (0.24 kg x 5 m/s).
  EXPECT_LT(worst, 27 * 1.2e-16 * world.total_mass * 5 * 2);
  EXPECT_GT(size, 0.1 * world.total_mass);
}

}  // namespace
}  // namespace quern::test
