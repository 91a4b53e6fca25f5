// Strays: a new line for one sphere keeps the lists complete, or is refused.
#include "scheduler/relist.h"

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
list_slack = "2 mm"
[domain]
low = ["0 m", "0 m", "-10 mm"]
high = ["100 mm", "100 mm", "100 mm"]
periodic = ["x", "y"]
[materials.ore]
density = "2500 kg/m^3"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
restitution = 0.5
sliding_friction = 0.5
[[walls]]
name = "floor"
material = "ore"
point = ["0 m", "0 m", "0 m"]
normal = [0, 0, 1]
[fill]
method = "random"
[[particles]]
name = "ore"
material = "ore"
sizes = [{ from = "4 mm", to = "8 mm", count = 1 }]
)";

constexpr std::uint64_t kWindow = 100;

World<double> box_of(int count, unsigned seed) {
  World<double> world = world_of<double>(
      scene_of(kBox, {"particles.ore.sizes=[{ from = \"4 mm\", to = \"8 mm\", count = " +
                          std::to_string(count) + " }]",
                      "run.seed=" + std::to_string(seed)}));
  for (Record<double>& r : world.particles.record) r.vx = r.vy = r.vz = 0;
  return world;
}

void build_lists(World<double>& world) {
  world.clock.list_window = kWindow;
  Graph graph(1);
  RebuildScratch<double> scratch;
  world.tile_walls.resize(world.tiles());
  rebuild(world, graph, scratch);
}

std::vector<std::size_t> all_tiles(const World<double>& world) {
  std::vector<std::size_t> tiles;
  for (std::size_t tile = 0; tile < world.tiles(); ++tile) tiles.push_back(tile);
  return tiles;
}

double elapsed(const World<double>& world) {
  return static_cast<double>(world.clock.total_steps - world.clock.list_step) * world.clock.dt;
}

Vec3 line_of(const Particles<double>& p, std::size_t k, double time) {
  return Vec3(p.list_x[k], p.list_y[k], p.list_z[k]) +
         time * Vec3(static_cast<double>(p.list_vx[k]), static_cast<double>(p.list_vy[k]),
                     static_cast<double>(p.list_vz[k]));
}

void put(Record<double>& r, const Vec3& x) { r.x = x.x(), r.y = x.y(), r.z = x.z(); }
void send(Record<double>& r, const Vec3& v) { r.vx = v.x(), r.vy = v.y(), r.vz = v.z(); }

// Everybody anywhere that its line and allowance let it be.
void scatter(World<double>& world, CounterRandom& random) {
  Particles<double>& p = world.particles;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vec3 any(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    put(p.record[k], line_of(p, k, elapsed(world)) +
                         0.998 * static_cast<double>(p.list_allowance[k]) * any.normalized());
  }
}

TEST(Relister, KeepsTheListsCompleteOrRefuses) {
  int kept = 0, refused = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    World<double> world = box_of(1500, seed);
    Particles<double>& p = world.particles;
    CounterRandom random(seed + 100);
    const auto any = [&](double size) {
      return Vec3(random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size));
    };
    for (Record<double>& r : p.record) send(r, any(random.uniform(0, 1) < 0.1 ? 0.5 : 0.05));
    build_lists(world);
    Relister<double> relister;
    for (int round = 0; round < 5; ++round) {
      world.clock.total_steps = world.clock.step += 15;
      scatter(world, random);
      for (int hit = 0; hit < 3; ++hit) {
        const std::size_t k = random.bits() % p.size();
        const double allowance = static_cast<double>(p.list_allowance[k]);
        put(p.record[k], line_of(p, k, elapsed(world)) + 1.2 * allowance * any(1).normalized());
        send(p.record[k], any(1));
      }
      const bool complete = relister.relist(world, all_tiles(world));
      ++(complete ? kept : refused);
      if (!complete) break;
      for (std::size_t k = 0; k < p.size(); ++k) {
        const Vec3 off =
            Vec3(p.record[k].x, p.record[k].y, p.record[k].z) - line_of(p, k, elapsed(world));
        ASSERT_LE(off.norm(), static_cast<double>(p.list_allowance[k]) + 1e-12);
      }
      const std::uint64_t now = world.clock.step;
      const std::vector<Record<double>> places(p.record.begin(), p.record.end());
      for (std::uint64_t step = now; step <= kWindow; step += 5) {
        world.clock.total_steps = world.clock.step = step;
        scatter(world, random);
        ASSERT_EQ(missed_contacts(world), std::vector<std::string>()) << seed << ", " << step;
      }
      world.clock.total_steps = world.clock.step = now;
      std::copy(places.begin(), places.end(), p.record.begin());
    }
  }
  EXPECT_GT(kept, 40);
  EXPECT_GT(refused, 5);
}

// Two spheres too far apart to be listed, one of which is thrown beside the other.
TEST(Relister, RefusesAStrayBesideAStranger) {
  World<double> world = box_of(2, 1);
  Particles<double>& p = world.particles;
  for (std::size_t k = 0; k < 2; ++k) {
    put(p.record[k], Vec3(0.02 + 0.05 * static_cast<double>(k), 0.05, 0.05));
  }
  build_lists(world);
  world.clock.total_steps = world.clock.step = 10;
  Relister<double> relister;
  Record<double>&a = p.record[0], &b = p.record[1];
  EXPECT_TRUE(relister.relist(world, all_tiles(world)));
  const double touch = a.radius + b.radius;
  put(a, Vec3(b.x - touch - 1e-3, b.y, b.z));
  EXPECT_TRUE(relister.relist(world, all_tiles(world)));
  EXPECT_LT(static_cast<double>(p.list_allowance[0]), 1e-3);
  put(a, Vec3(b.x - touch - 1e-6, b.y, b.z));
  EXPECT_FALSE(relister.relist(world, all_tiles(world)));
}

TEST(Relister, RefusesAStrayBesideAWall) {
  World<double> world = box_of(1, 1);
  put(world.particles.record[0], Vec3(0.05, 0.05, 0.05));
  build_lists(world);
  Record<double>& r = world.particles.record[0];
  world.clock.total_steps = world.clock.step = 10;
  Relister<double> relister;
  put(r, Vec3(0.05, 0.05, r.radius + 1e-3));
  EXPECT_TRUE(relister.relist(world, all_tiles(world)));
  put(r, Vec3(0.05, 0.05, r.radius + 1e-7));
  EXPECT_FALSE(relister.relist(world, all_tiles(world)));
}

}  // namespace
}  // namespace quern
