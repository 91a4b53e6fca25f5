// Candidates of walls: whatever a particle does within half the slack of its straight line, no
// facet of a moving wall that it touches within the window is missing. missed_contacts(), which
// looks at all facets at their pose of the moment, is the oracle; pairs are checked on the way.
#include <gtest/gtest.h>

#include "scheduler/check_lists.h"
#include "scheduler/random.h"
#include "tests/support/build_world.h"
#include "tests/support/mill_of_spheres.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

// Builds the lists for a window, then puts everything where it may be at `share` of the window.
struct Flight {
  World<double> world;
  std::vector<Record<double>> start;

  Flight(const Schedule& rotation, std::uint64_t steps, unsigned seed)
      : world(world_of<double>(scene_of(test::kMillOfSpheres))) {
    CounterRandom random(seed);
    for (Body& body : world.bodies) body.motion.rate = rotation;
    for (Record<double>& r : world.particles.record) {
      for (double* v : {&r.vx, &r.vy, &r.vz}) *v = random.uniform(-5, 5);
    }
    world.clock.list_window = steps;
    Graph graph(1);
    RebuildScratch<double> scratch;
    world.tile_walls.resize(world.tiles());
    for (Body& body : world.bodies) body.pose = pose_at(body.motion, world.wall_time());
    rebuild(world, graph, scratch);
    start.assign(world.particles.record.begin(), world.particles.record.end());
  }

  void look(std::uint64_t step, CounterRandom& random) {
    world.clock.step = step;
    for (std::size_t k = 0; k < start.size(); ++k) {
      Record<double>& r = world.particles.record[k];
      Vec3 off(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      off *= 0.998 * world.particles.list_allowance[k] / off.norm();
      r.x = start[k].x + world.time() * start[k].vx + off.x();
      r.y = start[k].y + world.time() * start[k].vy + off.y();
      r.z = start[k].z + world.time() * start[k].vz + off.z();
    }
    ASSERT_EQ(world.clock.list_stale, 0u) << "stale lists would not be looked at";
    EXPECT_EQ(missed_contacts(world), std::vector<std::string>());
  }
};

void fly(const Schedule& rotation, double window) {
  const std::uint64_t steps = static_cast<std::uint64_t>(window / 1e-5);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Flight flight(rotation, steps, seed);
    CounterRandom random(seed + 1000);
    for (std::uint64_t part = 0; part <= 8; ++part) flight.look(steps * part / 8, random);
  }
}

TEST(WallLists, MissNoFacetOfATurningMill) {
  for (const double window : {1e-3, 5e-3, 12e-3, 40e-3}) {
    SCOPED_TRACE("window " + std::to_string(window));
    fly({{{0, 2 * kPi}}}, window);
  }
}

TEST(WallLists, MissNoFacetOfAMillThatReverses) {
  fly({{{0, 6 * kPi}, {2e-3, 6 * kPi}, {3e-3, -5.5 * kPi}}}, 12e-3);
}

}  // namespace
}  // namespace quern
