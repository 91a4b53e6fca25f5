// Overlap of a shape with a wall of one to four planes, against brute force on its corners.
#include "kernels/pairs/wall_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/test_shapes.h"

namespace quern::test {
namespace {

// How far the shape must move along n to leave what lies behind the planes, by bisection: moving
// the shape by t n is moving the wall by -t n, and they meet while their planes have a common
// corner.
double depth_by_bisection(const Shape& shape, const std::vector<Plane>& walls, const Vec3& n) {
  const auto meet = [&](double t) {
    std::vector<Plane> all = planes_of(shape);
    for (const Plane& w : walls) all.push_back({w.normal, w.offset - t * w.normal.dot(n)});
    return !corners_behind(all, 1e-14).empty();
  };
  double low = 0, high = 4;
  for (int k = 0; k < 46; ++k) {
    const double middle = 0.5 * (low + high);
    (meet(middle) ? low : high) = middle;
  }
  return low;
}

struct Case {
  std::vector<Plane> walls;
  Vec3 normal;
};

// Planes about one direction that all pass `depth` into the shape.
Case random_case(const Shape& shape, int count, double depth, Random& random) {
  Case c;
  const Vec3 up = random.in_cube(1).normalized();
  double lowest = HUGE_VAL;
  for (std::size_t k = 0; k < shape.vertices; ++k) {
    lowest = std::min(lowest, up.dot(shape.vertex(k)));
  }
  const Vec3 apex = (lowest + depth) * up + 0.05 * random.in_cube(1);
  c.normal = Vec3::Zero();
  for (int k = 0; k < count; ++k) {
    const Vec3 n = (up + (count > 1 ? 0.6 : 0.0) * random.in_cube(1)).normalized();
    c.walls.push_back({n, n.dot(apex)});
    c.normal += random(0.2, 1) * n;
  }
  c.normal.normalize();
  return c;
}

// Corners of the oracle are good to 1e-14 times the condition of three planes.
TEST(WallPatch, HasVolumeCentroidAndWidthOfTheBodyBehindThePlanes) {
  Random random(1);
  int compared = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const Shape shape = rock(12, seed);
    const int count = 1 + static_cast<int>(seed % 4);
    const Case c = random_case(shape, count, std::pow(10.0, random(-1.5, -0.3)), random);
    std::vector<Plane> all = planes_of(shape);
    all.insert(all.end(), c.walls.begin(), c.walls.end());
    const std::vector<Vec3> corners = corners_behind(all, 1e-13);
    WallOverlap found;
    const bool hit = overlap_with_wall(shape, c.walls, c.normal, found);
    if (corners.size() < 4) {
      EXPECT_FALSE(hit && found.volume > 1e-9);
      continue;
    }
    ASSERT_TRUE(hit);
    const Polyhedron body = convex_hull(corners);
    if (body.empty() || found.volume < 1e-5) continue;  // qhull merges what is this flat
    double volume = 0, low = HUGE_VAL, high = -HUGE_VAL;
    Vec3 first = Vec3::Zero();
    for (const Vec3& x : corners) {
      low = std::min(low, c.normal.dot(x));
      high = std::max(high, c.normal.dot(x));
    }
    const Vec3 o = body.vertex[0];
    for (const auto& t : body.triangles()) {
      const Vec3 p = body.vertex[t[0]] - o, q = body.vertex[t[1]] - o, r = body.vertex[t[2]] - o;
      const double piece = p.dot(q.cross(r)) / 6;
      volume += piece;
      first += piece / 4 * (p + q + r);
    }
    ++compared;
    EXPECT_NEAR(found.volume / volume, 1, 1e-8);
    EXPECT_LT((found.centroid - o - first / volume).norm(), 1e-8);
    EXPECT_NEAR(found.width, high - low, 1e-11);
    EXPECT_FALSE(found.full);
  }
  EXPECT_GT(compared, 40);
}

// The depth is that of the linear programme; 1e-11 is 46 halvings of 4 and the corners' tolerance
// over the flattest angle between a wall and a face.
TEST(WallPatch, HasTheDepthAtWhichTheShapeComesFree) {
  Random random(2);
  int compared = 0;
  for (unsigned seed = 1; seed <= 80; ++seed) {
    const Shape shape = rock(12, seed);
    const int count = 1 + static_cast<int>(seed % 4);
    const Case c = random_case(shape, count, std::pow(10.0, random(-3, -0.3)), random);
    WallOverlap found;
    const bool hit = overlap_with_wall(shape, c.walls, c.normal, found);
    EXPECT_NEAR(hit ? found.depth : 0, depth_by_bisection(shape, c.walls, c.normal), 1e-11) << seed;
    compared += hit;
  }
  EXPECT_GT(compared, 40);
}

// A limit across the wall takes away what is beyond it: cube, half of it over the limit.
TEST(WallPatch, ALimitTakesAwayWhatIsBeyondIt) {
  const Shape cube = built_box({1, 1, 1});
  const double half = cube.vertex(0).cwiseAbs().maxCoeff();
  const Plane wall{Vec3::UnitZ(), -half + 0.1}, limit{Vec3::UnitX(), 0.2};
  const Plane planes[2] = {wall, limit};
  WallOverlap found;
  ASSERT_TRUE(overlap_with_wall(cube, planes, Vec3::UnitZ(), found));
  EXPECT_NEAR(found.depth, 0.1, 1e-15);
  EXPECT_NEAR(found.volume, 0.1 * 2 * half * (half + 0.2), 1e-14);
  EXPECT_LT((found.centroid - Vec3(0.1 - half / 2, 0, -half + 0.05)).norm(), 1e-14);
}

TEST(WallPatch, PlanesThatMissLeaveNothing) {
  const Shape shape = rock(12, 5);
  WallOverlap found;
  const Plane away{Vec3::UnitZ(), -3};
  EXPECT_FALSE(overlap_with_wall(shape, {&away, 1}, Vec3::UnitZ(), found));
  ClipBuffers buffers;
  FaceSides sides;
  EXPECT_FALSE(section_of_shape(shape, away, buffers, sides));
}

}  // namespace
}  // namespace quern::test
