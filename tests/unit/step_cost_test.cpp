// What a step streams and computes, for worlds so small that every slot is known.
#include "scheduler/step_cost.h"

#include <gtest/gtest.h>

#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

// Two spheres of radius 1; two slots if their tiles are not the same: own and imported.
struct Pair {
  Scene scene;
  World<float> world;
  StepCost cost;
  Pair(double distance, Index tile_size, Law law = {}) : scene(small_scene(law, 1e-5)) {
    scene.run.tile_size = tile_size;
    scene.run.list_slack = 0.5;
    add_sphere(scene, 2, Vec3(-0.5 * distance, 0, 0));
    add_sphere(scene, 2, Vec3(0.5 * distance, 0, 0));
    world = world_of<float>(scene);
    Stepper<float> stepper(world, 1);
    stepper.step();
    cost = count_step(world);
  }
  double bytes(Stage stage) const { return cost.bytes[static_cast<std::size_t>(stage)]; }
  double pairs() const { return cost.listed[static_cast<std::size_t>(Stage::kSpherePairs)]; }
};

// Of one row: owners, begin and end, partners, open slots read and written, the first contact.
constexpr double kLists = 16 * 4 + 2 * 4 + 16 * 4 + 2 * 2 + 4;
constexpr double kHistory = 9 * 4;  // of a contact

TEST(StepCost, OfATouchingPairIsARowAndAHistoryReadAndWritten) {
  const Pair pair(1.99, 512);
  EXPECT_EQ(pair.pairs(), 1);
  EXPECT_EQ(pair.cost.slots, 16);
  EXPECT_EQ(pair.bytes(Stage::kSpherePairs), kLists + 2 * kHistory);
  EXPECT_EQ(pair.bytes(Stage::kMotion), 2 * (2 * (64 + 8 + 24 + 12) + 24 + 12 + 4));
  EXPECT_EQ(pair.bytes(Stage::kSphereWalls), 0);
  EXPECT_EQ(pair.cost.operations.real,
            kOfIdleSlot.real + kOfTouchingSlot.real + kOfDamping.real);
  EXPECT_EQ(pair.cost.operations.f64,
            kOfIdleSlot.f64 + kOfTouchingSlot.f64 + 2 * kOfMotion.f64);
}

TEST(StepCost, OfAnIdlePairIsARow) {
  const Pair pair(2.01, 512);
  EXPECT_EQ(pair.pairs(), 1);
  EXPECT_EQ(pair.bytes(Stage::kSpherePairs), kLists);
  EXPECT_EQ(pair.cost.operations.real, kOfIdleSlot.real);
  EXPECT_EQ(pair.cost.operations.f64, kOfIdleSlot.f64 + 2 * kOfMotion.f64);
}

TEST(StepCost, OfAPairInTwoTilesIsPaidInBoth) {
  const Pair pair(1.99, 1);
  EXPECT_EQ(pair.pairs(), 1);
  EXPECT_EQ(pair.cost.slots, 32);
  EXPECT_EQ(pair.bytes(Stage::kSpherePairs), 2 * (kLists + 2 * kHistory) - 4);
  EXPECT_EQ(pair.cost.operations.real, 2 * (kOfIdleSlot.real + kOfTouchingSlot.real + kOfDamping.real));
}

TEST(StepCost, OfRollingFrictionIsAWiderHistoryAndMoreArithmetic) {
  Law law;
  law.rolling = 0.1;
  law.tangential_damping = false;
  const Pair pair(1.99, 512, law);
  EXPECT_EQ(pair.bytes(Stage::kSpherePairs), kLists + 2 * (kHistory + 3 * 4));
  EXPECT_EQ(pair.cost.operations.real,
            kOfIdleSlot.real + kOfTouchingSlot.real + kOfRolling.real);
}

TEST(StepCost, OfARebuildGrowsWithParticlesAndSlots) {
  const Pair near(1.99, 512), apart(6, 512);
  EXPECT_EQ(apart.cost.slots, 0);
  EXPECT_GT(apart.cost.rebuild_bytes, 2 * 2 * (64 + 8 + 24 + 24 + 12 + 4));
  // A pair found, sixteen slots of partners and one history.
  EXPECT_EQ(near.cost.rebuild_bytes - apart.cost.rebuild_bytes, 2 * (16 + 16 * 4 + kHistory));
}

TEST(StepCost, SharesAddUpToAMean) {
  const Pair touching(1.99, 512), idle(2.01, 512);
  StepCost mean;
  mean.add(touching.cost, 0.5);
  mean.add(idle.cost, 0.5);
  EXPECT_EQ(mean.slots, 16);
  EXPECT_EQ(mean.bytes[static_cast<std::size_t>(Stage::kSpherePairs)],
            kLists + kHistory);
}

}  // namespace
}  // namespace quern::test
