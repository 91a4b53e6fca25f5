// Allowances: who may be hit hard may leave its line far, who rests among resting ones may not, and
// lists are complete as long as nobody does more than it may.
#include <gtest/gtest.h>

#include "scheduler/check_lists.h"
#include "scheduler/random.h"
#include "scheduler/rebuild.h"
#include "tests/support/build_world.h"

namespace quern {
namespace {

constexpr const char* kBox = R"(
format = 1
[run]
duration = "1 s"
time_step = "1e-5 s"
tile_size = 32
list_slack = "1 mm"
[domain]
low = ["0 m", "0 m", "0 m"]
high = ["100 mm", "100 mm", "100 mm"]
periodic = ["x", "y", "z"]
[materials.ore]
density = "2500 kg/m^3"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
restitution = 0.5
sliding_friction = 0.5
[fill]
method = "random"
[[particles]]
name = "ore"
material = "ore"
diameter = "6 mm"
count = 1
)";

std::vector<std::string> count_of(int count) {
  return {"particles.ore.count=" + std::to_string(count)};
}

void build_lists(World<double>& world, std::uint64_t window) {
  world.clock.list_window = window;
  Graph graph(1);
  RebuildScratch<double> scratch;
  world.tile_walls.resize(world.tiles());
  rebuild(world, graph, scratch);
}

std::size_t index_of(const World<double>& world, Index id) {
  std::size_t k = 0;
  while (world.particles.id[k] != id) ++k;
  return k;
}

double allowance_of(const World<double>& world, Index id) {
  return static_cast<double>(world.particles.list_allowance[index_of(world, id)]);
}

// Four spheres in a row, 6.5 mm apart; the first flies at the second.
TEST(ListAllowance, IsWideForWhoMeetsAFastOneAlone) {
  World<double> world = world_of<double>(scene_of(kBox, count_of(4)));
  for (Record<double>& r : world.particles.record) r.vx = r.vy = r.vz = 0;
  const double window = 100e-5, speed = 0.3;
  for (Index id = 0; id < 4; ++id) {
    Record<double>& r = world.particles.record[index_of(world, id)];
    r.x = 0.03 + 0.0065 * id;
    r.y = r.z = 0.05;
    if (id == 0) r.vx = speed;
  }
  build_lists(world, 100);
  const double quiet = allowance_of(world, 3);
  EXPECT_GT(quiet, 0);
  EXPECT_LT(quiet, 0.1 * 0.5e-3);
  EXPECT_EQ(allowance_of(world, 2), quiet);
  EXPECT_NEAR(allowance_of(world, 1), quiet + window * speed, 1e-9);
  EXPECT_NEAR(allowance_of(world, 0), quiet + window * speed, 1e-9);
  // 0 and 1 are listed; the others are 0.5 mm apart, more than they may do.
  std::size_t listed = 0;
  for (const Index count : world.particles.pair_count) listed += count;
  EXPECT_EQ(listed, 1u);
}

TEST(ListAllowance, IsNeverMoreThanHalfTheSlack) {
  World<double> world = world_of<double>(scene_of(kBox, count_of(400)));
  CounterRandom random(5);
  for (Record<double>& r : world.particles.record) {
    for (double* v : {&r.vx, &r.vy, &r.vz}) *v = random.uniform(-20, 20);
  }
  build_lists(world, 400);
  double most = 0;
  for (const float a : world.particles.list_allowance)
    most = std::max(most, static_cast<double>(a));
  EXPECT_LE(2 * most, world.clock.slack);
  EXPECT_GT(2 * most, 0.999 * world.clock.slack);
}

// One in twenty is fast. Everybody goes as far off its line as it may, in any direction.
TEST(ListAllowance, MissesNoContactOfWhoKeepsToIt) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    World<double> world = world_of<double>(scene_of(kBox, count_of(2000)));
    CounterRandom random(seed);
    for (Record<double>& r : world.particles.record) {
      const double speed = random.uniform(0, 1) < 0.05 ? 2 : 1e-3;
      for (double* v : {&r.vx, &r.vy, &r.vz}) *v = random.uniform(-speed, speed);
    }
    build_lists(world, 100);
    const std::vector<Record<double>> start(world.particles.record.begin(),
                                            world.particles.record.end());
    std::size_t wide = 0, narrow = 0;
    for (const float a : world.particles.list_allowance) {
      ++(static_cast<double>(a) > 0.2 * world.clock.slack ? wide : narrow);
    }
    EXPECT_GT(wide, 50u);
    EXPECT_GT(narrow, 200u);
    for (std::uint64_t part = 0; part <= 4; ++part) {
      world.clock.total_steps = world.clock.step = 25 * part;
      for (std::size_t k = 0; k < start.size(); ++k) {
        Record<double>& r = world.particles.record[k];
        Vec3 off(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        off *= 0.9999 * static_cast<double>(world.particles.list_allowance[k]) / off.norm();
        r.x = start[k].x + world.time() * start[k].vx + off.x();
        r.y = start[k].y + world.time() * start[k].vy + off.y();
        r.z = start[k].z + world.time() * start[k].vz + off.z();
      }
      EXPECT_EQ(missed_contacts(world), std::vector<std::string>());
    }
  }
}

// Spheres among polyhedra: bodies stray and turn by what they may as well.
TEST(ListAllowance, MissesNoSphereNearAPolyhedronThatTurns) {
  const std::string sizes =
      "[{ from = \"35 mm\", to = \"45 mm\", count = 1180 }, "
      "{ from = \"75 mm\", to = \"150 mm\", count = 128, shape = \"polyhedron\" }]";
  for (unsigned seed = 1; seed <= 2; ++seed) {
    World<double> world = world_of<double>(
        shipped_scene("sag_slice_small_ph",
                      {"run.settle=none", "mill.length=0.48 m", "particles.ball.count=125",
                       "run.seed=" + std::to_string(seed), "particles.ore.sizes=" + sizes}));
    Polyhedra<double>& bodies = world.polyhedra;
    CounterRandom random(seed + 50);
    const auto any = [&](double size) {
      return Vec3(random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size));
    };
    for (Record<double>& r : world.particles.record) {
      const Vec3 v = any(2);
      r.vx = v.x(), r.vy = v.y(), r.vz = v.z();
    }
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Vec3 v = any(1), w = any(5);
      bodies.vx[k] = v.x(), bodies.vy[k] = v.y(), bodies.vz[k] = v.z();
      bodies.wx[k] = w.x(), bodies.wy[k] = w.y(), bodies.wz[k] = w.z();
    }
    world.moving_walls = false;
    build_lists(world, 400);
    const std::vector<Record<double>> start(world.particles.record.begin(),
                                            world.particles.record.end());
    for (std::uint64_t part = 0; part <= 4; ++part) {
      const double time = 100 * static_cast<double>(part) * world.clock.dt;
      world.clock.total_steps = world.clock.step = 100 * part;
      for (std::size_t k = 0; k < start.size(); ++k) {
        Record<double>& r = world.particles.record[k];
        const Vec3 off =
            0.999 * static_cast<double>(world.particles.list_allowance[k]) * any(1).normalized();
        r.x = start[k].x + time * start[k].vx + off.x();
        r.y = start[k].y + time * start[k].vy + off.y();
        r.z = start[k].z + time * start[k].vz + off.z();
      }
      for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Vec3 off =
            0.999 * static_cast<double>(bodies.list_allowance[k]) * any(1).normalized();
        bodies.x[k] = bodies.list_x[k] + time * static_cast<double>(bodies.list_vx[k]) + off.x();
        bodies.y[k] = bodies.list_y[k] + time * static_cast<double>(bodies.list_vy[k]) + off.y();
        bodies.z[k] = bodies.list_z[k] + time * static_cast<double>(bodies.list_vz[k]) + off.z();
        const double reach = bodies.scale[k] * world.shapes[bodies.shape[k]].bound_radius;
        const double turn =
            0.999 * static_cast<double>(bodies.list_turn[k]) / reach;  // rad, or less
        const Quat q =
            Quat(Eigen::AngleAxisd(turn, any(1).normalized())) * bodies.list_orientation(k);
        bodies.qw[k] = q.w(), bodies.qx[k] = q.x(), bodies.qy[k] = q.y(), bodies.qz[k] = q.z();
      }
      EXPECT_EQ(missed_contacts(world), std::vector<std::string>());
    }
  }
}

}  // namespace
}  // namespace quern
