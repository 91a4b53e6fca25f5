// Tumbling mills, watched: no contact is ever missing from the lists, the copies of contacts
// between tiles never differ by a bit, and pair forces add up to nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "scheduler/check_lists.h"
#include "scheduler/random.h"
#include "tests/support/build_world.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

// The laboratory mill at twice its speed, in tiles of 16: 24 tiles, most contacts between two.
const std::vector<std::string> kLabMill = {"run.settle=none", "run.tile_size=16",
                                           "mill.rotation=60 rpm"};

// Sizes 1:6 in a slice of a mill with periodic ends; 1500 spheres.
constexpr const char* kMixedMill = R"(
format = 1
[run]
duration = "0.3 s"
time_step = "1e-5 s"
tile_size = 32
[materials.ore]
density = "4500 kg/m^3"
[contact]
normal_stiffness = "5e5 N/m"
tangential_stiffness = "2e5 N/m"
sliding_friction = 0.5
rolling_friction = 0.01
restitution = 0.4
[mill]
material = "ore"
diameter = "300 mm"
length = "130 mm"
ends = "periodic"
rotation = "60 rpm"
[mill.lifters]
count = 12
height = "10 mm"
face_angle = "14 deg"
top_width = "10 mm"
[[particles]]
name = "ore"
material = "ore"
sizes = [
  { from = "8 mm", to = "12 mm", count = 1350 },
  { from = "12 mm", to = "25 mm", count = 130 },
  { from = "25 mm", to = "48 mm", count = 20 },
]
)";

struct Watch {
  std::size_t looks = 0, rebuilds = 0;
  double pair_contacts = 0, wall_contacts = 0;
};

// Looks every few steps (a prime number: not in step with the windows of the lists).
template <class Real>
void tumble(const Scene& scene, double time, std::uint64_t every, Watch& watch) {
  World<Real> world = world_of<Real>(scene);
  Stepper<Real> stepper(world, 1);
  while (world.time() < time) {
    const StepReport report = stepper.step();
    ASSERT_EQ(report.bits & kFatalBits, 0u) << "at t = " << world.time();
    watch.rebuilds += report.rebuilt ? 1 : 0;
    if (world.clock.step % every != 0 || world.clock.list_stale != 0) continue;
    ++watch.looks;
    watch.pair_contacts += world.totals.pair_contacts;
    watch.wall_contacts += world.totals.wall_contacts;
    for (const std::string& fault : missed_contacts(world)) ADD_FAILURE() << fault;
    for (const std::string& fault : unequal_twins(world)) ADD_FAILURE() << fault;
    EXPECT_EQ(sum_of_pair_forces(world), Vec3(0, 0, 0));
    ASSERT_FALSE(testing::Test::HasFailure()) << "at t = " << world.time();
  }
}

template <class Real>
class ListsInMotion : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ListsInMotion, Precisions);

TYPED_TEST(ListsInMotion, MissNothingInALabMill) {
  Watch watch;
  tumble<TypeParam>(shipped_scene("lab_mill_spheres", kLabMill), 0.3, 37, watch);
  EXPECT_GT(watch.looks, 500u);
  EXPECT_GT(watch.rebuilds, 50u);
  EXPECT_GT(watch.pair_contacts / static_cast<double>(watch.looks), 100);
  EXPECT_GT(watch.wall_contacts / static_cast<double>(watch.looks), 20);
}

TEST(ListsInMotion, MissNothingInAMixOfSizesWithPeriodicEnds) {
  Watch watch;
  tumble<float>(scene_of(kMixedMill), 0.3, 149, watch);
  EXPECT_GT(watch.looks, 100u);
  EXPECT_GT(watch.pair_contacts / static_cast<double>(watch.looks), 500);
}

TEST(ListsInMotion, MissNothingInSingleAndCopiesAreEqualToTheBit) {
  Scene scene = scene_of(kMixedMill);
  scene.run.precision = Precision::kSingle;
  Watch watch;
  tumble<float>(scene, 0.3, 149, watch);
  EXPECT_GT(watch.looks, 100u);
  EXPECT_GT(watch.pair_contacts / static_cast<double>(watch.looks), 500);
}

Index owner_of(const PairBatch<float>& pairs, std::size_t slot) {
  std::size_t block = 0;
  while (pairs.row_begin[block + 1] <= slot / kPairPad) ++block;
  return pairs.owner[block * kPairPad + slot % kPairPad];
}

// The checks must be able to fail: take one contact out of a list, change one copy by one bit.
TEST(ListChecks, NoticeAMissingContactAndAChangedTwin) {
  World<float> world = world_of<float>(shipped_scene("lab_mill_spheres", kLabMill));
  Stepper<float> stepper(world, 1);
  run_until(world, stepper, 0.1);
  while (world.clock.list_stale != 0) stepper.step();
  ASSERT_TRUE(missed_contacts(world).empty());
  ASSERT_TRUE(unequal_twins(world).empty());
  PairBatch<float>& pairs = world.pairs;
  int changed = 0, removed = 0;
  for (std::size_t tile = 0; tile < world.tiles(); ++tile) {
    // The lists are changed while they are looked at: copy what there is to try.
    std::vector<std::pair<std::size_t, bool>> slots;
    pairs.for_each(tile, PairBatch<float>::Part::kOwn, [&](std::size_t slot, Index, Index j) {
      if (pairs.is_open(slot)) slots.emplace_back(slot, j / world.tile_size != tile);
    });
    for (const auto& [slot, crosses] : slots) {
      if (crosses && changed++ == 0) {
        float& force = pairs.number(tile, slot, 3);
        const float was = force;
        force = std::nextafter(was, 2 * was);
        EXPECT_EQ(unequal_twins(world).size(), 1u);
        EXPECT_NE(sum_of_pair_forces(world).x(), 0);
        force = was;
      }
      if (!crosses && removed++ == 0) {
        const Index was = std::exchange(pairs.partner[slot], owner_of(pairs, slot));
        EXPECT_EQ(missed_contacts(world).size(), 1u);
        pairs.partner[slot] = was;
      }
    }
  }
  EXPECT_GT(changed, 0);
  EXPECT_GT(removed, 0);
  for (TileWalls& t : world.tile_walls) t.candidates.particle.clear();
  EXPECT_FALSE(missed_contacts(world).empty());
}

// A cloud without walls or weight: forces are f32, but exactly opposite and added in f64, so that
// momentum changes by f64 rounding alone. Each particle's velocity is rounded once a step and once
// a contact (half a unit each, up to 12 contacts): 7 units of the sum of m |v| a step.
void expect_momentum_of_a_cloud(Precision precision) {
  std::string text = R"(
format = 1
[run]
duration = "1 s"
time_step = "1e-5 s"
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
tile_size = 16
[materials.ore]
density = "2000 kg/m^3"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
sliding_friction = 0.4
restitution = 0.9
[domain]
low = ["0 mm", "0 mm", "0 mm"]
high = ["80 mm", "80 mm", "80 mm"]
periodic = ["x", "y", "z"]
[[particles]]
name = "ore"
material = "ore"
diameter = "10 mm"
count = 300
[fill]
method = "random"
)";
  Scene scene = scene_of(text);
  scene.run.precision = precision;
  ASSERT_FALSE(testing::Test::HasFailure());
  World<float> world = world_of<float>(scene);
  CounterRandom random(7);
  for (Record<float>& r : world.particles.record) {
    for (double* v : {&r.vx, &r.vy, &r.vz}) *v = random.uniform(-1, 1);
  }
  const auto momentum = [&](double& size) {
    Vec3 sum = Vec3::Zero();
    size = 0;
    for (std::size_t k = 0; k < world.particles.size(); ++k) {
      const Record<float>& r = world.particles.record[k];
      const double mass = 1 / static_cast<double>(world.particles.traits[k].inverse_mass);
      sum += mass * Vec3(r.vx, r.vy, r.vz);
      size += mass * Vec3(r.vx, r.vy, r.vz).norm();
    }
    return sum;
  };
  double size = 0;
  const Vec3 before = momentum(size);
  Stepper<float> stepper(world, 1);
  constexpr int kSteps = 3000;
  double touched = 0;
  for (int k = 0; k < kSteps; ++k) {
    ASSERT_EQ(stepper.step().bits & kFatalBits, 0u);
    touched += world.totals.pair_contacts;
  }
  double ignored = 0;
  EXPECT_LE((momentum(ignored) - before).norm(), 7 * kSteps * 0x1p-52 * size);
  EXPECT_GT(touched, kSteps) << "a cloud without contacts proves nothing";
}
TEST(ListsInMotion, KeepTheMomentumOfAFreeCloudToRounding) {
  expect_momentum_of_a_cloud(Precision::kMixed);
}
TEST(ListsInMotion, KeepTheMomentumOfAFreeCloudToRoundingInSingle) {
  expect_momentum_of_a_cloud(Precision::kSingle);
}

}  // namespace
}  // namespace quern
