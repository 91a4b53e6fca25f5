// Mills with polyhedra and spheres: the same bits for any number of threads, any order of the
// tiles, with or without a restart; and lists that never miss a contact.
//
// Two scenes: the laboratory mill (300 polyhedra, 80 balls) and a small cut of the SAG slice
// (periodic; 128 polyhedra among 1639 spheres, sizes 1:4).
#include <gtest/gtest.h>

#include "scheduler/check_lists.h"
#include "tests/support/hashed_runs.h"

namespace quern {
namespace {

// Long enough to fall, meet the lifters and tumble; short, as polyhedra cost microseconds.
constexpr std::uint64_t kWarmUp = 12000, kSteps = 1000;

using Overrides = std::vector<std::string>;

Scene scene_with(const char* name, Overrides overrides, const Overrides& more) {
  overrides.push_back("run.settle=none");
  overrides.insert(overrides.end(), more.begin(), more.end());
  return shipped_scene(name, overrides);
}

Scene lab_mill(const Overrides& more) {
  return scene_with("lab_mill",
                    {"run.tile_size=4", "mill.rotation=60 rpm", "particles.ball.count=130",
                     "particles.ore.count=150"},
                    more);
}

Scene sag_slice(const Overrides& more) {
  const std::string sizes =
      "[{ from = \"35 mm\", to = \"45 mm\", count = 1180 }, "
      "{ from = \"45 mm\", to = \"75 mm\", count = 334 }, "
      "{ from = \"75 mm\", to = \"150 mm\", count = 160, shape = \"polyhedron\" }]";
  return scene_with("sag_slice_small_ph",
                    {"run.tile_size=16", "mill.length=0.48 m", "particles.ball.count=125",
                     "particles.ore.sizes=" + sizes},
                    more);
}

// Open contacts of polyhedra with spheres, polyhedra and walls.
struct Contacts {
  std::size_t spheres = 0, pairs = 0, walls = 0;
};
template <class Real>
Contacts open_contacts(const World<Real>& world) {
  const Polyhedra<Real>& p = world.polyhedra;
  Contacts open;
  for (const PolyhedronPair& pair : p.pairs) open.pairs += pair.touching != 0 ? 1 : 0;
  open.walls = p.walls.size();
  for (std::size_t g = 0; g < p.spheres.polyhedron.size(); ++g) {
    for (Index slot = p.spheres.begin[g]; slot < p.spheres.begin[g] + p.spheres.count[g]; ++slot) {
      open.spheres += p.spheres.is_open(slot) ? 1 : 0;
    }
  }
  return open;
}

struct Case {
  const char* name;
  Scene (*scene)(const Overrides&);
};
void PrintTo(const Case& c, std::ostream* to) { *to << c.name; }

class PolyhedraInMotion : public testing::TestWithParam<Case> {
 protected:
  Start start(const Overrides& more = {}) const { return Start(GetParam().scene(more), kWarmUp); }
};

TEST_P(PolyhedraInMotion, GiveTheSameBitsForAnyThreadsAndAnyOrderOfTheTiles) {
  const Start s = start();
  const auto straight = s.world_after({}, kSteps);
  const Contacts open = open_contacts(*straight);
  EXPECT_GT(open.spheres, 20u);
  EXPECT_GT(open.pairs, 3u);
  EXPECT_GT(open.walls, 3u);
  const std::uint64_t one = state_hash(*straight);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(s.hash_after({.threads = threads}, kSteps), one) << threads << " threads";
  }
  EXPECT_EQ(s.hash_after({.threads = 1, .shuffle = 1}, kSteps), one);
  EXPECT_EQ(s.hash_after({.threads = 3, .shuffle = 99}, kSteps), one);
}

TEST_P(PolyhedraInMotion, GiveTheSameBitsWithARestartInBetween) {
  const Start s = start();
  const std::uint64_t one = s.hash_after({}, kSteps);
  EXPECT_EQ(s.hash_after({.resume_at = 500}, kSteps), one);
  EXPECT_EQ(s.hash_after({.threads = 2, .resume_at = 371}, kSteps), one) << "with two threads";
  EXPECT_EQ(s.hash_after({.resume_at = 1}, kSteps), one);
  EXPECT_EQ(s.hash_after({.checkpoint_at = 777}, kSteps), one) << "a checkpoint disturbs the run";
  EXPECT_NE(s.hash_after({}, kSteps + 1), one);
}

TEST_P(PolyhedraInMotion, AreMissedByNoList) {
  World<float> world = world_of<float>(GetParam().scene({}));
  Stepper<float> stepper(world, 1);
  std::size_t looks = 0, rebuilds = 0;
  Contacts seen;
  while (world.clock.step < 2 * kWarmUp) {
    const StepReport report = stepper.step();
    ASSERT_EQ(report.bits & kFatalBits, 0u) << "at t = " << world.time();
    rebuilds += report.rebuilt ? 1 : 0;
    // A prime number: not in step with the windows of the lists.
    if (world.clock.step % 101 != 0 || world.clock.list_stale != 0) continue;
    ++looks;
    const Contacts open = open_contacts(world);
    seen.spheres += open.spheres;
    seen.pairs += open.pairs;
    seen.walls += open.walls;
    for (const std::string& fault : missed_contacts(world)) ADD_FAILURE() << fault;
    for (const std::string& fault : unequal_twins(world)) ADD_FAILURE() << fault;
    ASSERT_FALSE(HasFailure()) << "at t = " << world.time();
  }
  EXPECT_GT(looks, 150u);
  EXPECT_GT(rebuilds, 20u);
  EXPECT_GT(seen.spheres / looks, 10u);
  EXPECT_GT(seen.pairs / looks, 1u);
  EXPECT_GT(seen.walls / looks, 1u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PolyhedraInMotion,
                         testing::Values(Case{"LabMill", lab_mill}, Case{"SagSlice", sag_slice}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace quern
