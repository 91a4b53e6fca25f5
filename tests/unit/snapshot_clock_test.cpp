// When snapshots are due, and which block of the window a step belongs to.
#include "apps/quern/snapshot_clock.h"

#include <gtest/gtest.h>

#include <map>

namespace quern {
namespace {

TEST(SnapshotClock, TakesAHundredUnlessToldOtherwise) {
  Scene scene;
  const SnapshotClock clock(scene, 1e-3, 500, 1500);
  int due = 0;
  for (std::uint64_t step = 0; step <= 1500; ++step) due += clock.due(step);
  EXPECT_EQ(due, 100);
  EXPECT_FALSE(clock.due(500));
  EXPECT_TRUE(clock.due(510));
  EXPECT_EQ(clock.number(509), 0u);
  EXPECT_EQ(clock.number(1500), 100u);
  EXPECT_NEAR(clock.start(), 0.5, 1e-12);
  EXPECT_NEAR(clock.first_time(), 0.51, 1e-12);
  scene.record.snapshots_every = 0.1;
  EXPECT_EQ(SnapshotClock(scene, 1e-3, 500, 1500).number(1500), 10u);
}

// Each step of the window lies in one of ten blocks, equally many in each, the snapshots with them.
TEST(SnapshotClock, CutsTheWindowIntoEqualBlocks) {
  const SnapshotClock clock(Scene(), 1e-3, 500, 1500);
  std::map<std::uint64_t, int> steps;
  for (std::uint64_t step = 0; step <= 1600; ++step) ++steps[clock.block(step, 10)];
  EXPECT_EQ(steps[10], 501 + 100);  // before and after
  for (std::uint64_t block = 0; block < 10; ++block) EXPECT_EQ(steps[block], 100);
  EXPECT_EQ(clock.block(600, 10), 0u);  // the tenth snapshot
  EXPECT_EQ(clock.block(601, 10), 1u);
}

}  // namespace
}  // namespace quern
