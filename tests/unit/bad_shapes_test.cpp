// Broken bodies, each with exactly its message; what has only a hull is taken when asked.
#include <gtest/gtest.h>

#include <limits>

#include "kernels/hull.h"
#include "tests/support/solids.h"

namespace quern {
namespace {

constexpr const char* kTakesHull = "; hull = true (quern shape: --hull) takes its convex hull";

Triangles without_first(Triangles triangles) {
  triangles.erase(triangles.begin());
  return triangles;
}

// A cube whose corner (1, 1, 1) is pushed in.
Triangles dented(double depth) {
  return mapped(unit_cube(), [depth](const Vec3& p) {
    return p == Vec3::Ones() ? Vec3(Vec3::Ones() * (1 - depth)) : p;
  });
}

// A box with a hollow in the shape of another.
Triangles hollow() {
  return joined(unit_cube(),
                turned_inside_out(box_solid(Vec3::Constant(0.4), Vec3::Constant(0.6))));
}

// Two tetrahedra that share one edge: four triangles around it.
Triangles sharing_an_edge() {
  const Triangles one = corner_tetrahedron();
  return joined(one, mapped(one, [](const Vec3& p) { return Vec3(-p[0], -p[1], p[2]); }));
}

// Two pyramids over a pentagram: bent outwards at every edge, yet it goes around twice.
Triangles star_pyramids() {
  Triangles out;
  for (int k = 0; k < 5; ++k) {
    const double a = 4 * kPi * k / 5, b = 4 * kPi * ((k + 1) % 5) / 5;
    const Vec3 p(std::cos(a), std::sin(a), 0), q(std::cos(b), std::sin(b), 0);
    out.push_back({{p, q, Vec3(0, 0, 1)}});
    out.push_back({{q, p, Vec3(0, 0, -1)}});
  }
  return out;
}

// Four corners of a square, as if they were a tetrahedron's.
Triangles flat_tetrahedron() {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
  return {{{a, c, b}}, {{a, b, d}}, {{a, d, c}}, {{b, c, d}}};
}

// The Klein bottle in its figure-8 form: closed, with one side only.
Triangles klein_bottle() {
  constexpr int kAround = 24, kAcross = 12;
  const auto point = [](int i, int k) {
    const double u = 2 * kPi * i / kAround, v = 2 * kPi * (k + 0.5) / kAcross;
    const double w = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
    return Vec3(w * std::cos(u), w * std::sin(u),
                std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v));
  };
  // After one turn v goes over into -v.
  const auto corner = [&](int i, int k) {
    return i == kAround ? point(0, (2 * kAcross - 1 - k) % kAcross) : point(i, k % kAcross);
  };
  Triangles out;
  for (int i = 0; i < kAround; ++i)
    for (int k = 0; k < kAcross; ++k) {
      out.push_back({{corner(i, k), corner(i + 1, k), corner(i + 1, k + 1)}});
      out.push_back({{corner(i, k), corner(i + 1, k + 1), corner(i, k + 1)}});
    }
  return out;
}

Triangles with_corner(double value) {
  Triangles cube = unit_cube();
  cube[4].corner[2][1] = value;
  return cube;
}

struct BadShape {
  const char* name;
  Triangles triangles;
  std::string message;  // without the file's name
  bool has_hull;
};

std::vector<BadShape> bad_shapes() {
  return {
      {"Empty", {}, "the mesh has no triangles", false},
      {"OneTriangle", {unit_cube()[0]}, "the mesh has 1 triangle, a body needs at least 4", false},
      {"NaN", with_corner(std::numeric_limits<double>::quiet_NaN()),
       "triangle 5 has a corner that is not a finite number", false},
      {"Infinite", with_corner(std::numeric_limits<double>::infinity()),
       "triangle 5 has a corner that is not a finite number", false},
      {"Open", without_first(unit_cube()),
       std::string("not closed: 3 edges with one triangle only, the first at (0.5, 0.5, 0)") +
           kTakesHull,
       true},
      {"NonManifold", sharing_an_edge(),
       std::string("not a simple surface: 1 edge with more than two triangles, the first at "
                   "(0, 0, 0.5)") +
           kTakesHull,
       true},
      {"OneSided", klein_bottle(),
       std::string("its surface has one side only: inside and outside are the same") + kTakesHull,
       true},
      {"TwoBodies", joined(unit_cube(), box_solid({3, 0, 0}, {4, 1, 1})),
       std::string("has 2 separate bodies, a shape is one") + kTakesHull, true},
      {"Hollow", hollow(), std::string("has 2 separate bodies, a shape is one") + kTakesHull, true},
      {"Dented", dented(0.5),
       std::string("not convex: bent inwards by 0.7869 of its bound radius at (0.25, 0.75, 0.25), "
                   "its hull has 1.66667 times its volume") +
           kTakesHull,
       true},
      {"DentedALittle", dented(1e-4),
       std::string("not convex: bent inwards by 0.0001155 of its bound radius at (0.5, 1, 0.5), "
                   "its hull has 1.00005 times its volume") +
           kTakesHull,
       true},
      {"SelfIntersecting", star_pyramids(),
       std::string("its surface intersects itself, its hull has 1.61803 times its volume") +
           kTakesHull,
       true},
      {"Flat", flat_tetrahedron(),
       "flat: its least width is 0 of its diameter, at least 0.0001 is needed", false},
      {"Sheet", mapped(unit_cube(), [](const Vec3& p) { return Vec3(p[0], p[1], 0); }),
       "flat: only 2 triangles of 12 have an area of their own", false},
      {"Thin", box_solid({0, 0, 0}, {1, 1, 1e-4}),
       "flat: its least width is 7.071e-05 of its diameter, at least 0.0001 is needed", false},
      {"TooManyFaces", latitude_ball(240, 70),
       "too many details: 16531 faces and 16562 vertices, a shape may have 512 and 1024; simplify "
       "the mesh",
       false},
  };
}

class BadShapeTest : public testing::TestWithParam<BadShape> {};

TEST_P(BadShapeTest, GivesExactlyItsMessage) {
  ShapeReport report;
  try {
    build_shape(GetParam().triangles, "rock.stl", {}, report);
    FAIL() << "accepted";
  } catch (const UserError& error) {
    EXPECT_EQ(error.what(), "rock.stl: " + GetParam().message);
  }
}

TEST_P(BadShapeTest, IsTakenByItsHullOrStillRefused) {
  ShapeReport report;
  if (GetParam().has_hull) {
    const Shape shape = build_shape(GetParam().triangles, "rock.stl", {true}, report);
    EXPECT_GE(shape.faces, 4u);
    ASSERT_FALSE(report.warnings.empty());
    EXPECT_TRUE(report.warnings[0].ends_with("; its hull was taken")) << report.warnings[0];
  } else {
    EXPECT_THROW(build_shape(GetParam().triangles, "rock.stl", {true}, report), UserError);
  }
}

INSTANTIATE_TEST_SUITE_P(Shape, BadShapeTest, testing::ValuesIn(bad_shapes()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace quern
