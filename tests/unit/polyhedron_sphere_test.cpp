// Polyhedron against sphere: the closest point, and every SIMD target against the plain kernel.
//
// Tolerances are in units of the size of what is subtracted: centre and corners of the body,
// kRounding each. A closest point costs some 20 roundings of half a unit in sums of three products
// of that size.
#include "kernels/pairs/polyhedron_sphere.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include "tests/support/contact_cases.h"
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

// By a sphere that reaches, the distance is known (test above); the plane that ends the search
// early must not lie about it.
TEST(PolyhedronSphere, TouchesWithinTheRadiusAndOtherwiseNamesNoMoreThanTheGap) {
  std::mt19937 draw(7);
  int touching = 0, apart = 0;
  for (const Shape& shape : all_shapes()) {
    for (int k = 0; k < 2000; ++k) {
      const Case c = random_case(shape, draw);
      const double reach = c.radius + 2 * c.pose.scale * shape.bound_radius;
      PolyhedronSphereTouch t;
      touch_polyhedron_sphere(c.pose, c.center, reach, t);
      const double gap = reach - t.overlap - c.radius;
      if (std::abs(gap) < kUnits * kUnit * reach) continue;
      EXPECT_EQ(touch_polyhedron_sphere(c.pose, c.center, c.radius, t), gap < 0);
      EXPECT_EQ(t.overlap > 0, gap < 0);
      EXPECT_GE(t.overlap, -gap - kUnits * kUnit * reach);
      ++(gap < 0 ? touching : apart);
    }
  }
  EXPECT_GT(touching, 1000);
  EXPECT_GT(apart, 1000);
}

// Turned together, or mirrored (a shape and its pose by x -> -x), the answer turns along.
TEST(PolyhedronSphere, TurnsAndMirrorsWithItsWorld) {
  std::mt19937 draw(8);
  const Shape box = test::box("box", {1, 1.6, 2.2});
  const Vec3 mirror(-1, 1, 1);
  for (int k = 0; k < 1000; ++k) {
    Case c = random_case(box, draw);
    PolyhedronSphereTouch t, turned, mirrored;
    const bool touching = touch_polyhedron_sphere(c.pose, c.center, c.radius, t);
    // Beside the medial axis, inside, rounding may choose another face.
    if (!touching || t.inside) continue;
    const double size = c.pose.scale * box.bound_radius + c.center.norm() + c.radius;
    const double error = kUnits * kUnit * size * (1 + 2 * c.radius / (c.radius - t.overlap));
    ShapePose other = c.pose;
    const Mat3 turn = random_turn(draw);
    other.turn = turn * c.pose.turn;
    touch_polyhedron_sphere(other, turn * c.center, c.radius, turned);
    EXPECT_LE((turned.point - turn * t.point).norm(), error);
    // The box is its own mirror image: M turn M is a rotation of it.
    other.turn = mirror.asDiagonal() * c.pose.turn * mirror.asDiagonal();
    touch_polyhedron_sphere(other, mirror.cwiseProduct(c.center), c.radius, mirrored);
    EXPECT_LE((mirrored.point - mirror.cwiseProduct(t.point)).norm(), error);
    EXPECT_NEAR(mirrored.overlap, t.overlap, error);
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

// What the kernel says of a sphere that it does not tell of.
constexpr NearTouch kNotTold = {{0, 0, 0}, 0, {0, 0, 0}, 0};

// Which spheres were open a step ago: those the kernel tells of even if they are apart.
enum class Open { kNone, kAll, kEveryThird };

struct Group {
  ShapePose pose;
  Column<double> in[4];
  std::vector<NearTouch> told, out;  // as told, and by sphere
  std::vector<Index> slot;
  std::vector<std::uint8_t> open;
  PolyhedronSphereGroup view;
  Group(const ShapePose& at, std::size_t count, Open opened = Open::kAll) : pose(at) {
    const std::size_t room = (count + kShapePad - 1) / kShapePad * kShapePad;
    for (Column<double>& c : in) {
      c.reset(room);
      c.fill(0);
    }
    told.resize(count);
    slot.resize(count);
    open.resize(room / kShapePad);
    for (std::size_t k = 0; k < room; ++k) {
      const bool is_open = opened == Open::kAll || (opened == Open::kEveryThird && k % 3 == 0);
      open[k / kShapePad] |= static_cast<std::uint8_t>((is_open ? 1u : 0u) << k % kShapePad);
    }
    view.pose = &pose;
    view.count = count;
    view.contacts = 3;
    view.radius = in[3].data();
    view.open = open.data();
    view.touch = told.data();
    view.slot = slot.data();
    for (int k = 0; k < 3; ++k) view.center[k] = in[k].data();
  }
  Group(const Group&) = delete;
  bool is_open(std::size_t k) const { return (open[k / kShapePad] >> k % kShapePad & 1) != 0; }
  // Returns how many touch. Told are, in order, those that touch or are open.
  std::size_t find() {
    const std::size_t count = choose_polyhedron_sphere().touch(view);
    out.assign(view.count, kNotTold);
    std::size_t touching = 0;
    for (std::size_t n = 0; n < count; ++n) {
      EXPECT_LT(slot[n], view.count);
      EXPECT_TRUE(n == 0 || slot[n - 1] < slot[n]);
      EXPECT_TRUE(told[n].overlap > 0 || is_open(slot[n]));
      EXPECT_EQ(told[n].body_contacts, view.contacts);
      out[slot[n]] = told[n];
      touching += told[n].overlap > 0 ? 1 : 0;
    }
    std::size_t open_count = 0;
    for (std::size_t k = 0; k < view.count; ++k) {
      open_count += out[k].overlap > 0 || is_open(k) ? 1 : 0;
    }
    EXPECT_EQ(count, open_count) << "what is open is told";
    return touching;
  }
  Vec3 center(std::size_t k) const { return {in[0][k], in[1][k], in[2][k]}; }
  Vec3 normal(std::size_t k) const { return Vec3(out[k].normal); }
  Vec3 point(std::size_t k) const { return Vec3(out[k].point); }
};

// A centre over the border of a face, beyond it by next to nothing: where rounding may decide
// between face and edge.
Vec3 over_a_border(const ShapePose& pose, double height, std::mt19937& draw) {
  std::uniform_real_distribution<double> u(0, 1);
  const Shape& s = *pose.shape;
  const std::size_t e = draw() % s.edges;
  const Vec3 a = s.vertex(s.edge_vertex[2 * e]), b = s.vertex(s.edge_vertex[2 * e + 1]);
  const Vec3 normal = s.normal(s.edge_face[2 * e]);
  const Vec3 beyond = std::pow(10, -16 + 8 * u(draw)) * (b - a).cross(normal).normalized();
  return pose.scale * (pose.turn * (a + u(draw) * (b - a) + height * normal + beyond));
}

// Spheres of many sizes about one body: in turn shallow touches, apart, anywhere, over a border.
void place_spheres(Group& g, std::mt19937& draw) {
  std::uniform_real_distribution<double> u(0, 1);
  const ShapePose& pose = g.pose;
  for (std::size_t k = 0; k < g.view.count; ++k) {
    Case c = random_case(*pose.shape, draw);
    c.center *= pose.scale / c.pose.scale;
    c.radius *= pose.scale / c.pose.scale;
    if (k % 4 == 3) c.center = over_a_border(pose, u(draw), draw);
    PolyhedronSphereTouch t;
    const double reach = 2 * pose.scale * pose.shape->bound_radius + c.radius + c.center.norm();
    touch_polyhedron_sphere(pose, c.center, reach, t);
    const double distance = reach - t.overlap;
    if (k % 2 == 0 && distance > 0) c.radius = distance * (1 + std::exp(-12 * u(draw) - 1));
    if (k % 4 == 1 && distance > 0) c.radius = distance * u(draw);
    if (k % 4 == 3) c.radius = distance * (1 + u(draw));
    for (int a = 0; a < 3; ++a) g.in[a][k] = c.center[a];
    g.in[3][k] = c.radius;
  }
}

// The sharpest or flattest edge: the least sine of the angle between neighbouring planes.
double least_sine(const Shape& s) {
  double least = 1;
  for (std::size_t e = 0; e < s.edges; ++e) {
    const Vec3 n = s.normal(s.edge_face[2 * e]), m = s.normal(s.edge_face[2 * e + 1]);
    least = std::min(least, n.cross(m).norm());
  }
  return least;
}

// Both answers are closest points to rounding of everything that enters (`size`); the direction to
// a point that is d away is known to size / d units. Next to the border between face and edge the
// two kernels may name different features: a foot that is outside by `error` lies beside the edge
// by error / sine of the angle between the planes. Beside by b the distance differs by b^2 / 2 d,
// and by b at most.
void expect_same(const Group& g, std::size_t k, double sine) {
  const ShapePose& pose = g.pose;
  PolyhedronSphereTouch t;
  const bool touching = touch_polyhedron_sphere(pose, g.center(k), g.in[3][k], t);
  const double size = pose.scale * pose.shape->bound_radius + g.center(k).norm() + g.in[3][k];
  const double error = kUnits * kUnit * size, beside = error / sine;
  const double distance = std::abs(g.in[3][k] - t.overlap);
  const double overlap_error =
      error + std::min(beside, 0.5 * beside * beside / std::max(distance, kUnit * size));
  EXPECT_NEAR(g.out[k].overlap, t.overlap, overlap_error);
  if (!touching || !(g.out[k].overlap > 0)) {
    EXPECT_LE(g.out[k].overlap, touching ? error : 0);
    EXPECT_EQ(g.normal(k), Vec3::Zero());
    EXPECT_EQ(g.point(k), Vec3::Zero());
    return;
  }
  EXPECT_NEAR(g.normal(k).norm(), 1, 1e-14);
  const Vec3 to_point = g.center(k) - (g.in[3][k] - 0.5 * g.out[k].overlap) * g.normal(k);
  EXPECT_LE((g.point(k) - to_point).norm(), error);
  // Inside, two planes may be equally near: the normal is then either one's.
  if (t.inside || distance < 2 * beside) return;
  EXPECT_LE((g.normal(k) - t.normal).norm(), 1e-15 + beside / distance);
}

TEST(PolyhedronSphereKernel, AgreesWithThePlainOneOnEveryTarget) {
  const std::vector<Shape> shapes = all_shapes();
  test::for_each_target<double>([&](const std::string& target) {
    std::mt19937 draw(5);
    ASSERT_EQ(choose_polyhedron_sphere().target, target);
    std::size_t touching = 0, apart = 0;
    for (const Shape& shape : shapes) {
      const double sine = least_sine(shape);
      for (std::size_t count = 1; count <= 25; ++count) {
        SCOPED_TRACE(target + ", " + shape.name + ", " + std::to_string(count));
        Group g({&shape, 0.02 * double(count), Vec3(1, 2, 3), random_turn(draw)}, count);
        place_spheres(g, draw);
        const std::size_t touches = g.find();
        std::size_t positive = 0;
        for (std::size_t k = 0; k < count; ++k) {
          positive += g.out[k].overlap > 0 ? 1 : 0;
          expect_same(g, k, sine);
        }
        EXPECT_EQ(touches, positive);
        Group none_open(g.pose, count, Open::kNone);
        for (std::size_t c = 0; c < 4; ++c) {
          std::copy(g.in[c].begin(), g.in[c].end(), none_open.in[c].begin());
        }
        EXPECT_EQ(none_open.find(), positive);
        touching += positive;
        apart += count - positive;
        if (testing::Test::HasFailure()) return;
      }
    }
    EXPECT_GT(touching, 500u);
    EXPECT_GT(apart, 500u);
  });
}

// Nearer to the surface than 1e-12 radii no direction to the closest point can be told: the normal
// is that of a face, and nothing is divided by the distance.
TEST(PolyhedronSphereKernel, TakesAFaceNormalWhereTheCentreIsOnTheSurface) {
  const std::vector<Shape> shapes = all_shapes();
  test::for_each_target<double>([&](const std::string& target) {
    std::mt19937 draw(9);
    for (const Shape& shape : shapes) {
      SCOPED_TRACE(target + ", " + shape.name);
      Group g({&shape, 1, Vec3::Zero(), Mat3::Identity()}, 2 * shape.vertices);
      for (std::size_t k = 0; k < 2 * shape.vertices; ++k) {
        const Vec3 place = shape.vertex(k / 2);
        // On the vertex, and 20 ulp or more above it but below 1e-12 radii.
        const Vec3 center = place + (k % 2 == 0 ? 0 : 1e-13) * place.normalized();
        for (int a = 0; a < 3; ++a) g.in[a][k] = center[a];
        g.in[3][k] = 1;
      }
      EXPECT_EQ(g.find(), g.view.count);
      for (std::size_t k = 0; k < g.view.count; ++k) {
        double closest = 2;
        for (std::size_t f = 0; f < shape.faces; ++f) {
          closest = std::min(closest, (g.normal(k) - shape.normal(f)).norm());
        }
        EXPECT_LE(closest, 4 * kUnit);
        EXPECT_NEAR(g.out[k].overlap, 1, 1e-12);
      }
    }
  });
}

// A sphere in another place of another group, longer than the kernel's chunk, has the same bits;
// and what lies in the padding, here spheres that would touch, is neither counted nor told.
TEST(PolyhedronSphereKernel, GivesASphereTheSameBitsInAnyPlaceOfAnyGroup) {
  const std::vector<Shape> shapes = all_shapes();
  test::for_each_target<double>([&](const std::string& target) {
    std::mt19937 draw(6);
    for (const Shape& shape : shapes) {
      SCOPED_TRACE(target + ", " + shape.name);
      Group all({&shape, 0.3, Vec3::Zero(), random_turn(draw)}, 133, Open::kEveryThird);
      place_spheres(all, draw);
      for (std::size_t k = 133; k < all.in[3].size(); ++k) all.in[3][k] = 1;
      const std::size_t touching = all.find();
      std::size_t one_by_one = 0;
      for (std::size_t k = 0; k < 133; ++k) {
        Group one(all.pose, 1, all.is_open(k) ? Open::kAll : Open::kNone);
        for (std::size_t c = 0; c < 4; ++c) one.in[c][0] = all.in[c][k];
        one_by_one += one.find();
        EXPECT_EQ(std::memcmp(&one.out[0], &all.out[k], sizeof(NearTouch)), 0) << k;
      }
      EXPECT_EQ(touching, one_by_one);
    }
  });
}

}  // namespace
}  // namespace quern
