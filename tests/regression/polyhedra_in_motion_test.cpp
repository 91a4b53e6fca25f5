// Mills with polyhedra and spheres: the same bits for any number of threads, any order of the
// tiles, with or without a restart; and lists that never miss a contact.
//
// Two scenes: the laboratory mill (300 polyhedra, 80 balls) and a small cut of the SAG slice
// (periodic; 128 polyhedra among 1639 spheres, sizes 1:4). And a box of rocks and balls, small
// enough for both precisions and every law of polyhedra.
#include <gtest/gtest.h>

#include <set>

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

// A box in which rocks and balls fall.
Scene box_of(OverlapMeasure overlap, NormalModel model) {
  Scene scene;
  scene.run.gravity = Vec3(0, 0, -80);  // soon at the bottom
  scene.run.time_step = 1e-5;
  scene.run.duration = 1;
  scene.run.tile_size = 4;
  scene.materials = {{"ore", 2000, 0}};
  scene.contact.normal_stiffness = 1e5;
  scene.contact.tangential_stiffness = 4e4;
  scene.contact.restitution = 0.5;
  scene.contact.sliding_friction = 0.5;
  scene.contact.overlap = overlap;
  scene.contact.normal_model = model;
  scene.boxes.push_back({"box", "ore", Vec3::Zero(), Vec3(0.08, 0.08, 0.15), false, Motion()});
  scene.fill.method = FillMethod::kRandom;
  scene.folder = QUERN_SOURCE_DIR "/apps/shapes";
  scene.particles.resize(2);
  scene.particles[0].name = "rock";
  scene.particles[0].shape = ShapeKind::kPolyhedron;
  scene.particles[0].meshes = {"ore12.stl", "rock_flat_12.stl"};
  scene.particles[0].sizes = {{0.012, 0.018, 60, std::nullopt}};
  scene.particles[1].name = "ball";
  scene.particles[1].sizes = {{0.008, 0.012, 100, std::nullopt}};
  for (ParticleSpec& species : scene.particles) species.material = "ore";
  return scene;
}

template <class Real>
class RocksAndBalls : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RocksAndBalls, Precisions);

TYPED_TEST(RocksAndBalls, GiveTheSameBitsUnderEveryLaw) {
  const Scene scenes[] = {box_of(OverlapMeasure::kChord, NormalModel::kStiffness),
                          box_of(OverlapMeasure::kWidth, NormalModel::kStiffness),
                          box_of(OverlapMeasure::kChord, NormalModel::kVolume)};
  std::set<std::uint64_t> seen;
  for (std::size_t k = 0; k < 3; ++k) {
    SCOPED_TRACE(testing::Message() << "law " << k);
    constexpr std::uint64_t steps = 400;
    const StartIn<TypeParam> s(scenes[k], 7000);
    const auto straight = s.world_after({}, steps);
    const Contacts open = open_contacts(*straight);
    EXPECT_GT(open.spheres, 20u);
    EXPECT_GT(open.pairs, 10u);
    EXPECT_GT(open.walls, 10u);
    const std::uint64_t one = state_hash(*straight);
    for (const int threads : {2, 3, 8}) {
      EXPECT_EQ(s.hash_after({.threads = threads}, steps), one) << threads << " threads";
    }
    EXPECT_EQ(s.hash_after({.threads = 1, .shuffle = 1}, steps), one);
    EXPECT_EQ(s.hash_after({.threads = 3, .shuffle = 99}, steps), one);
    EXPECT_EQ(s.hash_after({.threads = 2, .resume_at = 171}, steps), one);
    EXPECT_NE(s.hash_after({}, steps + 1), one);
    seen.insert(one);
  }
  EXPECT_EQ(seen.size(), 3u) << "laws that make no difference";
}

}  // namespace
}  // namespace quern
