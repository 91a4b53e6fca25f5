// Hand-over of wall springs between features.
#include "kernels/pairs/wall_history.h"

#include <gtest/gtest.h>

#include <vector>

namespace quern {
namespace {

struct Contact {
  Index wall, feature;
  Vec3 normal = Vec3::UnitY(), point = Vec3::Zero();
};

std::vector<int> match(const std::vector<Contact>& before, const std::vector<Contact>& after) {
  std::vector<WallSpring> old;
  for (const auto& c : before) {
    old.push_back({c.wall, c.feature, Vec3::Zero(), Vec3::Zero(), c.normal, c.point});
  }
  std::vector<Index> wall, feature;
  std::vector<Vec3> normal, point;
  for (const auto& c : after) {
    wall.push_back(c.wall);
    feature.push_back(c.feature);
    normal.push_back(c.normal);
    point.push_back(c.point);
  }
  std::vector<int> out(after.size(), -7);
  match_wall_springs(old, {wall, feature, normal, point}, 1.0, out.data());
  return out;
}

using Matches = std::vector<int>;

TEST(WallHistory, FollowsTheSameWallAndFeatureWhateverItsPlace) {
  EXPECT_EQ(match({{0, 3}, {0, 8}, {2, 3}}, {{0, 8, -Vec3::UnitY(), Vec3(9, 9, 9)}, {2, 3}}),
            (Matches{1, 2}));
}

TEST(WallHistory, HandsAVanishedContactToANewFeatureBesideIt) {
  const Vec3 tilted(0.43, 0.902829, 0);
  EXPECT_EQ(match({{0, 3}}, {{0, 90, tilted, Vec3(0.19, 0, 0)}}), Matches{0});
}

TEST(WallHistory, StartsAtZeroWhereTheNormalDiffers) {
  const Vec3 tilted(0.45, 0.893029, 0);
  EXPECT_EQ(match({{0, 3}}, {{0, 90, tilted}}), Matches{-1});
}

TEST(WallHistory, StartsAtZeroWhereThePointIsFar) {
  EXPECT_EQ(match({{0, 3}}, {{0, 90, Vec3::UnitY(), Vec3(0.21, 0, 0)}}), Matches{-1});
}

TEST(WallHistory, NeverCrossesFromWallToWall) {
  EXPECT_EQ(match({{0, 3}}, {{1, 90}}), Matches{-1});
}

TEST(WallHistory, LeavesContactsThatGoOnToThemselves) {
  // The new feature 1 could take the spring of feature 3, but that contact still exists.
  EXPECT_EQ(match({{0, 3}}, {{0, 1}, {0, 3}}), (Matches{-1, 0}));
}

TEST(WallHistory, GivesEachVanishedContactOnceInOrderOfFeature) {
  EXPECT_EQ(match({{0, 5}, {0, 6}}, {{0, 7}, {0, 8}, {0, 9}}), (Matches{0, 1, -1}));
}

TEST(WallHistory, StartsAtZeroWithoutAPast) {
  EXPECT_EQ(match({}, {{0, 1}, {4, 2}}), (Matches{-1, -1}));
  EXPECT_EQ(match({{0, 1}}, {}), Matches{});
}

}  // namespace
}  // namespace quern
