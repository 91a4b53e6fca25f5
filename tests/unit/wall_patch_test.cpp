// Overlap of a shape with a wall of one to four planes, against brute force on its corners.
#include "kernels/pairs/wall_patch.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

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

// The ring of edges against polygons of faces. Corners of both are good to a few roundings of the
// shape's size, which volumes and centroids of a part of extent e feel as 1e-15 / e, and flat ones
// as 1e-15 over their depth.
void expect_same_cut(const Shape& shape, const Plane& plane, int& by_edges) {
  ClipBuffers fast_section, plain_section;
  PlaneCut fast, plain;
  const bool cuts = section_of_shape(shape, plane, fast_section, fast);
  const bool cuts_plain = section_of_shape(shape, plane, plain_section, plain, CutWay::kPolygons);
  ASSERT_FALSE(plain.by_edges);
  EXPECT_NEAR(fast.sides.deepest, plain.sides.deepest, 2e-15);
  // Flush or just touching: rounding decides.
  const bool grazes =
      std::abs(plain.sides.deepest) < 4e-15 || std::abs(plain.sides.highest) < 4e-15;
  if (grazes) return;
  ASSERT_EQ(cuts, cuts_plain);
  if (!cuts) return;
  by_edges += fast.by_edges;
  const ClippedPolygon &one = *fast_section.now, &two = *plain_section.now;
  const double area = polygon_area(one, plane.normal), depth = -plain.sides.deepest;
  EXPECT_NEAR(area, polygon_area(two, plane.normal), 1e-13);
  for (int k = 0; k < one.corners; ++k) {
    EXPECT_NEAR(plane.height(one.corner[k]), 0, 1e-14);
    const std::size_t f = static_cast<std::size_t>(one.beyond[k]);
    const Vec3& next = one.corner[k + 1 < one.corners ? k + 1 : 0];
    EXPECT_NEAR(shape.normal(f).dot(one.corner[k]), shape.d[f], 1e-13);
    EXPECT_NEAR(shape.normal(f).dot(next), shape.d[f], 1e-13);
  }
  WallOverlap a, b;
  const bool thick = overlap_behind_plane(shape, plane, fast, {one.corner[0], area}, a);
  ASSERT_EQ(thick, overlap_behind_plane(shape, plane, plain, {two.corner[0], area}, b));
  if (!thick) return;
  EXPECT_NEAR(a.volume / b.volume, 1, 1e-12 / depth);
  EXPECT_LT((a.centroid - b.centroid).norm(), 1e-12 / depth * std::sqrt(area));
  EXPECT_NEAR(a.depth, b.depth, 2e-15);
}

// Sections of rocks and boxes by all kinds of planes.
void expect_same_cuts() {
  Random random(3);
  int by_edges = 0, cuts = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Shape shapes[] = {rock(12, seed), rock(20, seed), built_box({1, 1, 1}),
                            built_box({3, 1, 0.3})};
    for (const Shape& shape : shapes) {
      for (int trial = 0; trial < 20; ++trial) {
        const double depth = std::pow(10.0, random(-5, 0.2));
        const Case c = random_case(shape, 1, depth, random);
        expect_same_cut(shape, c.walls[0], by_edges);
        // Flush with a face, and through a vertex.
        const std::size_t f = static_cast<std::size_t>(trial) % shape.faces;
        const Vec3 n = -shape.normal(f);
        for (const double off : {1e-4, 1e-9, 0.0}) {
          expect_same_cut(shape, {n, off - shape.d[f]}, by_edges);
        }
        const Vec3 corner = shape.vertex(static_cast<std::size_t>(trial) % shape.vertices);
        expect_same_cut(shape, {c.normal, c.normal.dot(corner)}, by_edges);
        ++cuts;
      }
    }
  }
  EXPECT_GT(by_edges, cuts);
}

TEST(PlaneCut, IsTheSameByEdgesAndByPolygonsOnEveryTarget) {
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    expect_same_cuts();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

TEST(WallPatch, PlanesThatMissLeaveNothing) {
  const Shape shape = rock(12, 5);
  WallOverlap found;
  const Plane away{Vec3::UnitZ(), -3};
  EXPECT_FALSE(overlap_with_wall(shape, {&away, 1}, Vec3::UnitZ(), found));
  ClipBuffers buffers;
  PlaneCut cut;
  EXPECT_FALSE(section_of_shape(shape, away, buffers, cut));
}

}  // namespace
}  // namespace quern::test
