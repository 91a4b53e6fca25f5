// Contacts in frames: all that touch and nothing else, with the forces that moved the particles.
//
// The oracle is what particles did: the sum of a particle's contact forces and its weight is its
// mass times the change of its velocity in the step, and the moments of these forces, at the points
// that the frame gives, turned it. So a force or point that is wrong, missed or told twice shows.
#include "kernels/laws/damping.h"
#include "scheduler/contact_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "io/frames.h"
#include "tests/support/hashed_runs.h"
#include "tests/support/mill_of_spheres.h"
#include "tests/support/small_scene.h"

namespace quern {
namespace {

using Precisions = test::Precisions;
using Strings = std::vector<std::string>;

Vec3 vector_of(const std::vector<float>& all, std::size_t k) {
  return {all[3 * k], all[3 * k + 1], all[3 * k + 2]};
}
Vec3 vector_of(const std::vector<double>& all, std::size_t k) {
  return {all[3 * k], all[3 * k + 1], all[3 * k + 2]};
}

// Ten times as heavy as on Earth, and soon at the bottom. Tiles are small: many pairs lie in two.
const Strings kHeavy = {"run.tile_size=16",
                        "run.gravity=[\"0 m/s^2\", \"-98.1 m/s^2\", \"0 m/s^2\"]"};

Scene mill_of_spheres() { return scene_of(test::kMillOfSpheres, kHeavy); }

// Without rolling friction and damping of patches, which are moments beyond those of the forces.
Scene lab_mill() {
  Strings overrides = {"run.settle=none", "particles.ball.count=100", "particles.ore.count=80",
                       "contact.rolling_friction=0", "contact.patch_damping=false"};
  overrides.insert(overrides.end(), kHeavy.begin(), kHeavy.end());
  return shipped_scene("lab_mill", overrides);
}

// A particle between two steps.
struct Moving {
  Vec3 place, velocity, angular_momentum;
  double mass = 0, radius = 0;
};

template <class Real>
std::vector<Moving> charge_of(const World<Real>& world) {
  const Particles<Real>& p = world.particles;
  std::vector<Moving> all(world.bodies_of_charge());
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Record<Real>& r = p.record[k];
    const double mass = 1 / static_cast<double>(p.traits[k].inverse_mass);
    const double radius = static_cast<double>(r.radius);
    const Vec3 spin(p.spin_x[k], p.spin_y[k], p.spin_z[k]);
    all[p.id[k]] = {
        {r.x, r.y, r.z}, {r.vx, r.vy, r.vz}, 0.4 * mass * radius * radius * spin, mass, radius};
  }
  const Polyhedra<Real>& q = world.polyhedra;
  for (std::size_t k = 0; k < q.size(); ++k) {
    all[q.first_id + k] = {q.place(k), q.velocity(k), q.momentum(k), 1 / q.inverse_mass[k],
                           q.scale[k]};
  }
  return all;
}

// What the contacts of a frame do to each particle, and the magnitudes that their rounding goes by.
struct Pushed {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  double all_forces = 0, all_moments = 0;
};
std::vector<Pushed> add_up(const ContactFrame& f, const std::vector<Moving>& charge) {
  std::vector<Pushed> sums(charge.size());
  const auto push = [&](std::size_t id, const Vec3& force, const Vec3& point) {
    const Vec3 arm = point - charge[id].place;
    sums[id].force += force;
    sums[id].moment += arm.cross(force);
    sums[id].all_forces += force.norm();
    sums[id].all_moments += arm.norm() * force.norm();
  };
  for (std::size_t k = 0; k < f.first.size(); ++k) {
    const Vec3 force = vector_of(f.force, k), point = vector_of(f.point, k);
    push(f.first[k], force, point);
    if (f.wall[k] == 0) push(f.second[k], -force, point);
  }
  return sums;
}

// A charge that has fallen, and one more step of it.
template <class Real>
struct LastStep {
  World<Real> world;
  std::vector<Moving> before, after;
  ContactFrame frame;

  LastStep(const Scene& scene, int steps) : world(world_of<Real>(scene)) {
    Stepper<Real> stepper(world, 1);
    test::run_steps(world, stepper, steps);
    before = charge_of(world);
    test::run_steps(world, stepper, 1);
    after = charge_of(world);
    frame = contact_frame(world);
  }
  double of_walls() const {
    return static_cast<double>(std::count(frame.wall.begin(), frame.wall.end(), 1));
  }
};

// Forces are rounded to f32, 6e-8 of each; points, in mixed precision, to as much of an arm.
template <class Real>
void expect_the_motion_seen(const LastStep<Real>& last) {
  constexpr double kRounding = 1e-6;
  const double dt = last.world.clock.dt;
  const std::vector<Pushed> pushed = add_up(last.frame, last.before);
  std::size_t touched = 0;
  for (std::size_t id = 0; id < pushed.size(); ++id) {
    const Moving &was = last.before[id], &is = last.after[id];
    const Pushed& p = pushed[id];
    touched += p.all_forces > 0 ? 1 : 0;
    const Vec3 force = was.mass * ((is.velocity - was.velocity) / dt - last.world.gravity);
    const Vec3 moment = (is.angular_momentum - was.angular_momentum) / dt;
    const double weight = was.mass * last.world.gravity.norm();
    // What a change of velocity in one step is rounded by, 1e-16 m/s / dt, over gravity.
    EXPECT_LT((p.force - force).norm(), kRounding * p.all_forces + 1e-9 * weight) << id;
    EXPECT_LT((p.moment - moment).norm(),
              2 * kRounding * p.all_moments + 1e-9 * weight * was.radius)
        << id;
  }
  EXPECT_GT(touched, pushed.size() / 4) << "a charge without contacts proves nothing";
}

// Pairs of spheres whose surfaces overlap, the smaller first, by looking at all.
std::set<std::array<std::size_t, 2>> touching_spheres(const std::vector<Moving>& charge,
                                                      std::size_t spheres) {
  std::set<std::array<std::size_t, 2>> pairs;
  for (std::size_t a = 0; a < spheres; ++a) {
    for (std::size_t b = a + 1; b < spheres; ++b) {
      const double reach = charge[a].radius + charge[b].radius;
      if ((charge[a].place - charge[b].place).squaredNorm() >= reach * reach) continue;
      if (charge[b].radius < charge[a].radius) {
        pairs.insert({b, a});
      } else {
        pairs.insert({a, b});
      }
    }
  }
  return pairs;
}

template <class Real>
void expect_counts_and_order(const LastStep<Real>& last) {
  const ContactFrame& f = last.frame;
  const StepTotals& totals = last.world.totals;
  EXPECT_EQ(static_cast<double>(f.first.size()), totals.pair_contacts + totals.wall_contacts);
  EXPECT_EQ(last.of_walls(), totals.wall_contacts);
  const std::size_t spheres = last.world.particles.size();
  const auto touching = touching_spheres(last.before, spheres);
  std::set<std::array<std::size_t, 2>> found;
  std::array<std::size_t, 3> previous = {0, 0, 0};
  for (std::size_t k = 0; k < f.first.size(); ++k) {
    const std::array<std::size_t, 3> now = {f.first[k], f.wall[k], f.second[k]};
    EXPECT_LE(previous, now);
    previous = now;
    if (f.wall[k] != 0 || f.first[k] >= spheres || f.second[k] >= spheres) continue;
    EXPECT_TRUE(found.insert({f.first[k], f.second[k]}).second) << "told twice";
  }
  EXPECT_EQ(found, touching);
}

template <class Real>
void expect_parts_that_agree(const LastStep<Real>& last) {
  const ContactFrame& f = last.frame;
  for (std::size_t k = 0; k < f.first.size(); ++k) {
    const Vec3 force = vector_of(f.force, k), normal = vector_of(f.normal, k);
    EXPECT_NEAR(normal.norm(), 1, 1e-6);
    EXPECT_GE(f.overlap[k], 0);
    EXPECT_GE(f.normal_force[k], 0) << "the law does not pull";
    EXPECT_NEAR(f.normal_force[k], force.dot(normal), 1e-6 * force.norm());
    EXPECT_NEAR(std::hypot(f.normal_force[k], f.tangential_force[k]), force.norm(),
                1e-6 * force.norm());
    EXPECT_LT((vector_of(f.point, k) - last.before[f.first[k]].place).dot(normal), 0)
        << "the normal points to i";
  }
}

template <class Real>
class Contacts : public testing::Test {};
TYPED_TEST_SUITE(Contacts, Precisions, test::Names);

TYPED_TEST(Contacts, OfSpheresAreAllThatTouchWithTheForcesThatMovedThem) {
  const LastStep<TypeParam> last(mill_of_spheres(), 14000);
  expect_counts_and_order(last);
  expect_parts_that_agree(last);
  expect_the_motion_seen(last);
  EXPECT_GT(last.of_walls(), 10);
  const ContactFrame& f = last.frame;
  for (std::size_t k = 0; k < f.first.size(); ++k) {
    const Moving& i = last.before[f.first[k]];
    if (f.wall[k] != 0) continue;
    const Moving& j = last.before[f.second[k]];
    // To the rounding of the overlap to f32, and of places to 1e-16 m.
    const double overlap = i.radius + j.radius - (i.place - j.place).norm();
    EXPECT_NEAR(f.overlap[k], overlap, 1e-6 * overlap + 1e-15);
    EXPECT_LT((vector_of(f.normal, k) - (i.place - j.place).normalized()).norm(), 1e-6);
  }
}

TYPED_TEST(Contacts, OfPolyhedraAreAllThatTouchWithTheForcesThatMovedThem) {
  const LastStep<TypeParam> last(lab_mill(), 7000);
  expect_counts_and_order(last);
  expect_parts_that_agree(last);
  expect_the_motion_seen(last);
  const StepTotals& totals = last.world.totals;
  EXPECT_GT(totals.polyhedron_sphere_contacts, 5);
  EXPECT_GT(totals.polyhedron_pair_contacts, 3);
  EXPECT_GT(totals.polyhedron_wall_contacts, 3);
  const ContactFrame& f = last.frame;
  const std::size_t spheres = last.world.particles.size();
  const auto name = [&](std::size_t id) -> std::string { return id < spheres ? "media" : "ore"; };
  for (std::size_t k = 0; k < f.first.size(); ++k) {
    const std::string i = name(f.first[k]), j = f.wall[k] != 0 ? "liner" : name(f.second[k]);
    const bool ore_first = i == "ore" || j == "liner";
    EXPECT_EQ(last.world.groups.kind_name(f.kind[k]), ore_first ? i + "-" + j : j + "-" + i);
  }
}

TYPED_TEST(Contacts, OfASphereAtRestCarryItsWeight) {
  const test::Law law;
  Scene scene = test::small_scene(law, 1e-6);
  scene.run.gravity = Vec3(0, 0, -9.81);
  const double diameter = 0.0625, weight = 9.81 * test::sphere_mass(diameter);
  // The spring is softer by what damping takes off it in a step, see kernels/README.md.
  const double rate = std::sqrt(law.kn / test::sphere_mass(diameter));
  const double zeta = damping_ratio(law.restitution, law.normal_force);
  const double overlap = weight / law.kn * (1 + 1e-6 * zeta * rate);
  test::add_sphere(scene, diameter, Vec3(1, 2, 0.5 * diameter - overlap));
  test::add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  test::run_steps(world, stepper, 20000);
  const ContactFrame f = contact_frame(world);
  ASSERT_EQ(f.first.size(), 1u);
  EXPECT_EQ(f.first[0], 0u);
  EXPECT_EQ(f.second[0], 0u);
  EXPECT_EQ(f.wall[0], 1);
  // Mass and radius are f32 in mixed precision, and it swings by what that moves its rest.
  EXPECT_NEAR(f.normal_force[0], weight, 1e-6 * weight);
  EXPECT_LT(f.tangential_force[0], 1e-6 * weight);
  EXPECT_NEAR(f.overlap[0], overlap, 1e-6 * overlap);
  EXPECT_LT((vector_of(f.point, 0) - Vec3(1, 2, -0.5 * overlap)).norm(), 1e-12);
  EXPECT_EQ(vector_of(f.normal, 0), Vec3::UnitZ());
}

TYPED_TEST(Contacts, ThroughAPeriodicSideLieInsideTheDomain) {
  Scene scene = test::small_scene(test::Law(), 1e-6, 0.5);
  scene.domain.periodic[0] = true;
  // The middle of the overlap is 1/64 m inside the high side.
  test::add_sphere(scene, 0.0625, Vec3(-0.5 + 0.015625 - 0.0009765625, 0, 0));
  test::add_sphere(scene, 0.125, Vec3(0.5 - 0.078125 + 0.0009765625, 0, 0));
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  test::run_steps(world, stepper, 1);
  const ContactFrame f = contact_frame(world);
  ASSERT_EQ(f.first.size(), 1u);
  EXPECT_EQ(f.first[0], 0u);
  EXPECT_EQ(f.second[0], 1u);
  EXPECT_NEAR(f.overlap[0], 0.001953125, 1e-9);
  EXPECT_LT((vector_of(f.point, 0) - Vec3(0.5 - 0.015625, 0, 0)).norm(), 1e-9);
  EXPECT_LT((vector_of(f.normal, 0) - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_GT(f.force[0], 0);
}

// The file of contacts that a world gives.
std::string bytes_of(World<float>& world) {
  const TempFolder folder;
  FrameWriter(folder.path()).write(1, ParticleFrame(), {}, {}, contact_frame(world));
  return read_bytes(folder / "contacts_000001.hdf");
}

TEST(ContactFiles, AreTheSameBytesForAnyThreadsAndAfterARestart) {
  const Start start(lab_mill(), 7000);
  constexpr std::uint64_t steps = 300;
  const std::string one = bytes_of(*start.world_after({}, steps));
  EXPECT_TRUE(bytes_of(*start.world_after({.threads = 3}, steps)) == one);
  EXPECT_TRUE(bytes_of(*start.world_after({.threads = 3, .shuffle = 7}, steps)) == one);
  EXPECT_TRUE(bytes_of(*start.world_after({.threads = 2, .resume_at = steps}, steps)) == one)
      << "a world that was just read";
  EXPECT_FALSE(bytes_of(*start.world_after({}, steps + 1)) == one);
}

}  // namespace
}  // namespace quern
