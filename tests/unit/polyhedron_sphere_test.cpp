// Polyhedron against sphere: the closest point, and every SIMD target against the plain kernel.
//
// Tolerances are in units of the size of what is subtracted: centre and corners of the body,
// kRounding each. A closest point costs some 20 roundings of half a unit in sums of three products
// of that size.
#include "kernels/pairs/polyhedron_sphere.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include "tests/support/convex_shapes.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

using test::all_shapes;
using test::random_direction;
using test::random_turn;

constexpr double kUnit = 0x1p-52;
constexpr double kUnits = 40;

struct Case {
  ShapePose pose;
  Vec3 center;
  double radius;
};

// Centres about the surface: outside, inside and in touch in equal parts.
Case random_case(const Shape& shape, std::mt19937& draw) {
  std::uniform_real_distribution<double> u(0, 1);
  Case c;
  c.pose = {&shape, std::exp(4 * u(draw) - 2), Vec3::Zero(), random_turn(draw)};
  c.radius = c.pose.scale * std::exp(3 * u(draw) - 2.5);
  const double reach = c.pose.scale * shape.bound_radius + c.radius;
  c.center = reach * std::cbrt(u(draw)) * random_direction(draw);
  return c;
}

// Distance from c (body frame, unit scale) to plane f.
double height(const Shape& s, std::size_t f, const Vec3& c) { return s.normal(f).dot(c) - s.d[f]; }

// How far (p, n) is from closest point and normal of the body for centre p + distance n: p beyond
// any plane, and n outside the cone of the normals of the planes that p lies on. For a centre
// outside the cone condition reads: no vertex of the body lies further along n than p.
double optimality_gap(const Shape& s, const Vec3& p, const Vec3& n) {
  double gap = 0;
  for (std::size_t f = 0; f < s.faces; ++f) gap = std::max(gap, height(s, f, p));
  for (std::size_t k = 0; k < s.vertices; ++k) gap = std::max(gap, n.dot(s.vertex(k) - p));
  return gap;
}

TEST(PolyhedronSphere, FindsTheClosestPointOfTheBody) {
  std::mt19937 draw(1);
  int inside = 0, faces = 0, edges = 0, vertices = 0;
  for (const Shape& shape : all_shapes()) {
    for (int k = 0; k < 2000; ++k) {
      const Case c = random_case(shape, draw);
      PolyhedronSphereTouch t;
      // A radius that always reaches, so that every centre has a closest point to judge.
      const double radius = c.radius + 2 * c.pose.scale * shape.bound_radius;
      ASSERT_TRUE(touch_polyhedron_sphere(c.pose, c.center, radius, t));
      const double distance = (radius - t.overlap) / c.pose.scale;
      const Vec3 n = c.pose.turn.transpose() * t.normal;
      const Vec3 p = c.pose.turn.transpose() * c.center / c.pose.scale - distance * n;
      const double size = radius / c.pose.scale;
      EXPECT_NEAR(n.norm(), 1, 1e-14);
      EXPECT_LT((c.center - 0.5 * (2 * radius - t.overlap) * t.normal - t.point).norm(),
                1e-14 * radius);
      if (t.inside) {
        ++inside;
        double highest = -kFarPlane;
        for (std::size_t f = 0; f < shape.faces; ++f) {
          highest = std::max(highest, height(shape, f, p + distance * n));
        }
        EXPECT_LE(highest, 1e-14 * size);
        EXPECT_NEAR(distance, highest, 1e-14 * size) << "pushed out through the nearest plane";
      } else {
        faces += t.feature == PolyhedronFeature::kFace ? 1 : 0;
        edges += t.feature == PolyhedronFeature::kEdge ? 1 : 0;
        vertices += t.feature == PolyhedronFeature::kVertex ? 1 : 0;
        // The direction to a centre that is d away is known to size / d units only; it moves a
        // vertex at a distance of twice the body's radius.
        const double turned = 2 * shape.bound_radius * kUnits * kUnit * size / distance;
        EXPECT_LT(optimality_gap(shape, p, n), 1e-12 * size + turned) << shape.name;
      }
    }
  }
  for (const int kind : {inside, faces, edges, vertices}) EXPECT_GT(kind, 1000);
}

TEST(PolyhedronSphere, ACentreOnAFeatureHasTheFullOverlapAndAFaceNormal) {
  std::mt19937 draw(2);
  for (const Shape& shape : all_shapes()) {
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < shape.vertices; ++k) places.push_back(shape.vertex(k));
    for (std::size_t e = 0; e < shape.edges; ++e) {
      places.push_back(0.5 * (shape.vertex(shape.edge_vertex[2 * e]) +
                              shape.vertex(shape.edge_vertex[2 * e + 1])));
    }
    for (std::size_t f = 0; f < shape.faces; ++f) {
      Vec3 middle = Vec3::Zero();
      const std::size_t begin = shape.face_begin[f], end = shape.face_begin[f + 1];
      for (std::size_t k = begin; k < end; ++k) middle += shape.vertex(shape.face_vertex[k]);
      places.push_back(middle / double(end - begin));
    }
    for (const Vec3& place : places) {
      const ShapePose pose{&shape, 0.7, Vec3::Zero(), random_turn(draw)};
      const Vec3 center = pose.scale * (pose.turn * place);
      PolyhedronSphereTouch t;
      ASSERT_TRUE(touch_polyhedron_sphere(pose, center, 0.3, t));
      EXPECT_TRUE(t.point.allFinite() && t.normal.allFinite());
      EXPECT_EQ(t.feature, PolyhedronFeature::kFace);
      EXPECT_TRUE(t.deep);
      EXPECT_NEAR(t.overlap, 0.3, kUnits * kUnit * pose.scale * shape.bound_radius);
      EXPECT_NEAR(t.normal.norm(), 1, 1e-14);
    }
  }
}

// A face of the body is a plane: what a sphere feels there is radius minus height, exactly.
TEST(PolyhedronSphere, OnAFaceIsTheSphereOnAPlane) {
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> u(0, 1);
  for (const Shape& shape : all_shapes()) {
    for (int k = 0; k < 500; ++k) {
      const std::size_t f = draw() % shape.faces;
      Vec3 foot = Vec3::Zero();
      double sum = 0;
      for (std::size_t c = shape.face_begin[f]; c < shape.face_begin[f + 1]; ++c) {
        const double part = 0.01 + u(draw);
        foot += part * shape.vertex(shape.face_vertex[c]);
        sum += part;
      }
      foot /= sum;
      const ShapePose pose{&shape, 0.5 + u(draw), Vec3::Zero(), random_turn(draw)};
      const double radius = pose.scale * (0.2 + u(draw)),
                   deep = radius * std::exp(-14 * u(draw) - 0.1);
      const Vec3 normal = pose.turn * shape.normal(f);
      const Vec3 center = pose.scale * (pose.turn * foot) + (radius - deep) * normal;
      PolyhedronSphereTouch t;
      ASSERT_TRUE(touch_polyhedron_sphere(pose, center, radius, t));
      const double stiffness = 2e7;
      EXPECT_LT((stiffness * t.overlap * t.normal - stiffness * deep * normal).norm(),
                1e-12 * stiffness * radius);
      EXPECT_LT((t.point - (center - (radius - 0.5 * deep) * normal)).norm(), 1e-12 * radius);
    }
  }
}

// The facet ball lies between its inscribed sphere and the unit sphere through its corners. For a
// centre at distance D its closest point is at least D - 1 and at most D - r_in away, so that
// overlap falls short of the analytic ball's by 0 to the sagitta 1 - r_in. The normal: p lies
// within the unit ball and not beneath the inner one, nearer to the centre than the facet plane's
// highest ball point, hence |p - c| <= D - r_in; the angle at c between the line to p and that to
// the middle follows from the triangle (|p| <= 1, D, |p - c| = d) by the law of cosines.
TEST(PolyhedronSphere, ABallOfFacetsDiffersFromABallByItsFacetErrorAndNoMore) {
  const Shape ball = test::ball_of_facets();
  const double sagitta = 1 - ball.inner_radius;
  EXPECT_NEAR(sagitta, 0.0245, 0.003);  // the trapezoids at the equator, 18 by 18 degrees
  std::mt19937 draw(4);
  double worst = 0;
  for (int k = 0; k < 20000; ++k) {
    std::uniform_real_distribution<double> u(0, 1);
    const ShapePose pose{&ball, 0.05, Vec3::Zero(), random_turn(draw)};
    const double radius = pose.scale * (0.2 + u(draw));
    const double deep = (sagitta + 0.1 * u(draw)) * pose.scale;
    const double away = pose.scale + radius - deep;
    const Vec3 out = random_direction(draw);
    PolyhedronSphereTouch t;
    ASSERT_TRUE(touch_polyhedron_sphere(pose, away * out, radius, t)) << "deeper than the sagitta";
    const double missing = (deep - t.overlap) / pose.scale;
    EXPECT_GT(missing, -1e-14);
    EXPECT_LT(missing, sagitta + 1e-14);
    worst = std::max(worst, missing);
    const double d = (radius - t.overlap) / pose.scale, far = away / pose.scale;
    EXPECT_GE(t.normal.dot(out), (far * far + d * d - 1) / (2 * far * d) - 1e-14);
  }
  EXPECT_GT(worst, 0.8 * sagitta) << "the bound is met somewhere";
}

struct Group {
  Column<double> in[4], out[7];
  PolyhedronSphereGroup view;
  Group(const ShapePose& pose, std::size_t count) {
    const std::size_t room = (count + kShapePad - 1) / kShapePad * kShapePad;
    for (Column<double>& c : in) {
      c.reset(room);
      c.fill(0);
    }
    for (Column<double>& c : out) {
      c.reset(room);
      c.fill(-7);
    }
    view.pose = pose;
    view.count = count;
    view.radius = in[3].data();
    view.overlap = out[3].data();
    for (int k = 0; k < 3; ++k) {
      view.center[k] = in[k].data();
      view.normal[k] = out[k].data();
      view.point[k] = out[4 + k].data();
    }
  }
  Vec3 center(std::size_t k) const { return {in[0][k], in[1][k], in[2][k]}; }
  Vec3 normal(std::size_t k) const { return {out[0][k], out[1][k], out[2][k]}; }
  Vec3 point(std::size_t k) const { return {out[4][k], out[5][k], out[6][k]}; }
};

// Spheres of many sizes about one body: a third apart, a third shallow, the rest anywhere.
void place_spheres(Group& g, std::mt19937& draw) {
  std::uniform_real_distribution<double> u(0, 1);
  for (std::size_t k = 0; k < g.view.count; ++k) {
    Case c = random_case(*g.view.pose.shape, draw);
    const double unit = g.view.pose.scale / c.pose.scale;
    c.center *= unit;
    c.radius *= unit;
    PolyhedronSphereTouch t;
    const double reach = 2 * g.view.pose.scale * g.view.pose.shape->bound_radius + c.radius;
    touch_polyhedron_sphere(g.view.pose, c.center, reach, t);
    const double distance = reach - t.overlap;
    if (k % 3 == 0 && distance > 0) c.radius = distance * (1 + std::exp(-12 * u(draw) - 1));
    if (k % 3 == 1 && distance > 0) c.radius = distance * u(draw);
    for (int a = 0; a < 3; ++a) g.in[a][k] = c.center[a];
    g.in[3][k] = c.radius;
  }
}

// Both answers are closest points to rounding of everything that enters (`size`); the direction to
// a point that is d away is known to size / d units. Next to the border between face and edge the
// two kernels may name different features: a foot that is outside by w units lies beside the edge
// by w / sin(angle between the planes), at least 0.2 in these shapes, which adds the factor 5.
void expect_same(const Group& g, std::size_t k) {
  const ShapePose& pose = g.view.pose;
  PolyhedronSphereTouch t;
  const bool touching = touch_polyhedron_sphere(pose, g.center(k), g.in[3][k], t);
  const double size = pose.scale * pose.shape->bound_radius + g.center(k).norm() + g.in[3][k];
  const double error = kUnits * kUnit * size;
  EXPECT_NEAR(g.out[3][k], t.overlap, error);
  if (!touching || !(g.out[3][k] > 0)) {
    EXPECT_LE(g.out[3][k], touching ? error : 0);
    return;
  }
  const double distance = std::abs(g.in[3][k] - t.overlap);
  // Inside, two planes may be equally near: the normal is then either one's.
  if (t.inside || distance < 100 * error) return;
  EXPECT_LE((g.normal(k) - t.normal).norm(), 1e-15 + 5 * error / distance);
  EXPECT_LE((g.point(k) - t.point).norm(), error + 5 * error / distance * g.in[3][k]);
}

template <class Work>
void for_each_target(Work work) {
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    work(std::string(choose_polyhedron_sphere().target));
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(PolyhedronSphereKernel, AgreesWithThePlainOneOnEveryTarget) {
  const std::vector<Shape> shapes = all_shapes();
  for_each_target([&](const std::string& target) {
    std::mt19937 draw(5);
    for (const Shape& shape : shapes) {
      for (std::size_t count = 1; count <= 25; ++count) {
        SCOPED_TRACE(target + ", " + shape.name + ", " + std::to_string(count));
        Group g({&shape, 0.02 * double(count), Vec3(1, 2, 3), random_turn(draw)}, count);
        place_spheres(g, draw);
        const std::size_t touching = choose_polyhedron_sphere().touch(g.view);
        std::size_t positive = 0;
        for (std::size_t k = 0; k < count; ++k) {
          positive += g.out[3][k] > 0 ? 1 : 0;
          expect_same(g, k);
        }
        EXPECT_EQ(touching, positive);
        if (testing::Test::HasFailure()) return;
      }
    }
  });
}

}  // namespace
}  // namespace quern
