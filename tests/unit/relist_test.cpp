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

// Spheres and rocks at rest.
World<double> box_of_rocks(int spheres, int rocks, unsigned seed) {
  Scene scene = scene_of(kBox, {"particles.ore.sizes=[{ from = \"4 mm\", to = \"8 mm\", count = " +
                                    std::to_string(spheres) + " }]",
                                "run.seed=" + std::to_string(seed)});
  ParticleSpec rock;
  rock.name = "rock";
  rock.material = "ore";
  rock.shape = ShapeKind::kPolyhedron;
  rock.meshes = {"ore12.stl"};
  rock.sizes = {{0.01, 0.018, rocks, std::nullopt}};
  scene.particles.push_back(rock);
  scene.folder = QUERN_SOURCE_DIR "/apps/shapes";
  World<double> world = world_of<double>(scene);
  for (Record<double>& r : world.particles.record) r.vx = r.vy = r.vz = 0;
  return world;
}

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

template <class Columns>
Vec3 line_of(const Columns& p, std::size_t k, double time) {
  return Vec3(p.list_x[k], p.list_y[k], p.list_z[k]) +
         time * Vec3(static_cast<double>(p.list_vx[k]), static_cast<double>(p.list_vy[k]),
                     static_cast<double>(p.list_vz[k]));
}

void put(Record<double>& r, const Vec3& x) { r.x = x.x(), r.y = x.y(), r.z = x.z(); }
void send(Record<double>& r, const Vec3& v) { r.vx = v.x(), r.vy = v.y(), r.vz = v.z(); }

// A rock turned so far about any axis that its points have gone `way`, as lists count it.
void turn(World<double>& world, std::size_t k, double way, CounterRandom& random) {
  Polyhedra<double>& q = world.polyhedra;
  const double reach = q.scale[k] * world.shapes[q.shape[k]].bound_radius;
  const Vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  const double angle = 4 * std::asin(std::min(1.0, way / (4 * reach)));
  const Quat now = Quat(Eigen::AngleAxisd(angle, axis.normalized())) * q.list_orientation(k);
  q.qw[k] = now.w(), q.qx[k] = now.x(), q.qy[k] = now.y(), q.qz[k] = now.z();
}
void put(Polyhedra<double>& q, std::size_t k, const Vec3& x) {
  q.x[k] = x.x(), q.y[k] = x.y(), q.z[k] = x.z();
}

// Everybody anywhere that its line and allowance let it be.
void scatter(World<double>& world, CounterRandom& random) {
  Particles<double>& p = world.particles;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vec3 any(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    put(p.record[k], line_of(p, k, elapsed(world)) +
                         0.998 * static_cast<double>(p.list_allowance[k]) * any.normalized());
  }
  Polyhedra<double>& q = world.polyhedra;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const Vec3 any(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    put(q, k,
        line_of(q, k, elapsed(world)) +
            0.998 * static_cast<double>(q.list_allowance[k]) * any.normalized());
    turn(world, k, 0.998 * static_cast<double>(q.list_turn[k]), random);
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

// Spheres and rocks among each other: some are hit, some rocks turn more than they may.
TEST(Relister, KeepsTheListsOfPolyhedraCompleteOrRefuses) {
  int kept = 0, refused = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    World<double> world = box_of_rocks(500, 200, seed);
    Particles<double>& p = world.particles;
    Polyhedra<double>& q = world.polyhedra;
    CounterRandom random(seed + 100);
    const auto any = [&](double size) {
      return Vec3(random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size));
    };
    for (Record<double>& r : p.record) send(r, any(random.uniform(0, 1) < 0.1 ? 0.5 : 0.05));
    for (std::size_t k = 0; k < q.size(); ++k) {
      const Vec3 w = any(60);
      q.wx[k] = w.x(), q.wy[k] = w.y(), q.wz[k] = w.z();
    }
    build_lists(world);
    Relister<double> relister;
    for (int round = 0; round < 4; ++round) {
      world.clock.total_steps = world.clock.step += 20;
      scatter(world, random);
      const std::size_t ball = random.bits() % p.size();
      const std::size_t hit = random.bits() % q.size(), spun = random.bits() % q.size();
      put(p.record[ball],
          line_of(p, ball, elapsed(world)) +
              1.2 * static_cast<double>(p.list_allowance[ball]) * any(1).normalized());
      send(p.record[ball], any(1));
      put(q, hit,
          line_of(q, hit, elapsed(world)) +
              1.2 * static_cast<double>(q.list_allowance[hit]) * any(1).normalized());
      const Vec3 v = any(0.5), w = any(40);
      q.vx[hit] = v.x(), q.vy[hit] = v.y(), q.vz[hit] = v.z();
      turn(world, spun, 1.2 * static_cast<double>(q.list_turn[spun]), random);
      q.wx[spun] = w.x(), q.wy[spun] = w.y(), q.wz[spun] = w.z();
      const bool complete = relister.relist(world, all_tiles(world));
      ++(complete ? kept : refused);
      if (!complete) break;
      ASSERT_LE((q.place(hit) - line_of(q, hit, elapsed(world))).norm(), 1e-12);
      ASSERT_LE((q.orientation(spun).coeffs() - q.list_orientation(spun).coeffs()).norm(), 1e-12);
      const std::uint64_t now = world.clock.step;
      const std::vector<Record<double>> places(p.record.begin(), p.record.end());
      for (std::uint64_t step = now; step <= kWindow; step += 10) {
        world.clock.total_steps = world.clock.step = step;
        scatter(world, random);
        ASSERT_EQ(missed_contacts(world), std::vector<std::string>()) << seed << ", " << step;
      }
      world.clock.total_steps = world.clock.step = now;
      std::copy(places.begin(), places.end(), p.record.begin());
    }
  }
  EXPECT_GT(kept, 30);
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

// The same of two rocks, by the spheres about them, and of one and the floor.
TEST(Relister, RefusesARockBesideAStrangerOrAWall) {
  World<double> world = box_of_rocks(1, 2, 1);
  Polyhedra<double>& q = world.polyhedra;
  const auto reach = [&](std::size_t k) { return q.scale[k] * world.shapes[0].bound_radius; };
  put(world.particles.record[0], Vec3(0.05, 0.05, 0.09));
  put(q, 0, Vec3(0.03, 0.03, 0.05));
  put(q, 1, Vec3(0.07, 0.07, 0.05));
  build_lists(world);
  world.clock.total_steps = world.clock.step = 10;
  Relister<double> relister;
  const double touch = reach(0) + reach(1);
  put(q, 0, q.place(1) - Vec3(touch + 1e-3, 0, 0));
  EXPECT_TRUE(relister.relist(world, all_tiles(world)));
  EXPECT_LT(static_cast<double>(q.list_allowance[0]), 1e-3);
  put(q, 0, q.place(1) - Vec3(touch + 1e-6, 0, 0));
  EXPECT_FALSE(relister.relist(world, all_tiles(world)));
  put(q, 0, Vec3(0.03, 0.03, reach(0) + 1e-3));
  EXPECT_TRUE(relister.relist(world, all_tiles(world)));
  EXPECT_LT(static_cast<double>(q.list_allowance[0]), 1e-3);
  put(q, 0, Vec3(0.03, 0.03, reach(0) + 1e-7));
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
