// Shapes: mass properties against closed forms, merging, orientation, the layout of soa/shapes.h.
//
// Rounding: sums of up to 360 terms of order 1 in f64 stay within 360 * 1.1e-16 = 4e-14 of their
// value; kExact leaves a factor of 25 for the cubes, squares and quotients behind them.
#include <gtest/gtest.h>

#include <set>

#include "io/mesh_reader.h"
#include "kernels/hull.h"
#include "kernels/mass_properties.h"
#include "tests/support/solids.h"
#include "tests/support/temp_folder.h"

namespace quern {
namespace {

constexpr double kExact = 1e-12;

Shape shape_of(const Triangles& triangles, ShapeReport& report) {
  return build_shape(triangles, "test.stl", {}, report);
}

Shape shape_of(const Triangles& triangles) {
  ShapeReport report;
  return shape_of(triangles, report);
}

Triangles read_shipped(const std::string& name) {
  const MeshResult mesh = read_stl(std::string(QUERN_SOURCE_DIR) + "/apps/shapes/" + name, 1);
  EXPECT_EQ(mesh.errors, std::vector<std::string>{});
  return mesh.triangles;
}

Vec3 sorted(Vec3 v) {
  std::sort(v.data(), v.data() + 3);
  return v;
}

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], tolerance) << "component " << k;
}

TEST(MassProperties, OfACubeAreItsClosedForms) {
  const double a = 0.7;
  const Vec3 low(11, -3, 5);  // rounding of the corners alone is 11 * 1.1e-16 there
  ShapeReport report;
  const Shape shape = shape_of(box_solid(low, low + Vec3::Constant(a)), report);
  EXPECT_NEAR(report.volume, a * a * a, kExact);
  expect_near(shape.file_centroid, low + Vec3::Constant(a / 2), kExact);
  const double r = std::cbrt(0.75 * a * a * a / kPi);
  EXPECT_NEAR(shape.file_scale, r, kExact);
  expect_near(shape.inertia, Vec3::Constant(a * a / 6 / (r * r)), kExact);
  EXPECT_NEAR(shape.inner_radius, a / 2 / r, kExact);
  EXPECT_NEAR(shape.bound_radius, std::sqrt(0.75) * a / r, kExact);
}

TEST(MassProperties, OfABoxKeepTheAxesOfTheFile) {
  const Vec3 sides(0.4, 1.3, 0.9);
  const Shape shape = shape_of(box_solid(Vec3::Zero(), sides));
  EXPECT_EQ(shape.file_axes, Mat3::Identity());
  const Vec3 s2 = sides.cwiseProduct(sides) / (12 * shape.file_scale * shape.file_scale);
  expect_near(shape.inertia, {s2[1] + s2[2], s2[0] + s2[2], s2[0] + s2[1]}, kExact);
}

// With x, y, z >= 0, x + y + z <= 1: int 1 = 1/6, int x^2 = 1/60, int x y = 1/120; shifted to the
// centroid at 1/4 the second moments are 1/160 and -1/480.
TEST(MassProperties, OfATetrahedronAreItsClosedForms) {
  std::vector<Vec3> vertex = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const MassProperties mass = mass_properties(vertex, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
  EXPECT_NEAR(mass.volume, 1.0 / 6, kExact);
  expect_near(mass.centroid, Vec3::Constant(0.25), kExact);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(mass.inertia(i, k), i == k ? 1.0 / 80 : 1.0 / 480, kExact);

  const Shape shape = shape_of(corner_tetrahedron());
  const double r = std::cbrt(0.75 / 6 / kPi);
  const double along = 1.0 / 60, across = 1.0 / 96;  // of the axis (1, 1, 1)
  expect_near(sorted(shape.inertia), Vec3(across, across, along) * 6 / (r * r), kExact);
  EXPECT_NEAR(std::abs(shape.file_axes.col(2).dot(Vec3::Ones())), std::sqrt(3), kExact);
}

// Sections across the axis are regular polygons whose radius is linear in z between the rings;
// three-point Gauss integrates its fourth power exactly.
TEST(MassProperties, OfABallOfLatitudesAreItsClosedForms) {
  const int around = 20, rings = 10;
  const double phi = 2 * kPi / around;
  const double area = around * std::sin(phi) / 2;                          // over radius^2
  const double polar = around * std::sin(phi) * (2 + std::cos(phi)) / 12;  // over radius^4
  const double node[] = {-std::sqrt(0.6), 0, std::sqrt(0.6)},
               weight[] = {5. / 18, 8. / 18, 5. / 18};
  double volume = 0, axial = 0, height = 0;
  for (int k = 0; k < rings; ++k) {
    const double a = kPi * k / rings, b = kPi * (k + 1) / rings;
    const double thick = std::cos(a) - std::cos(b);
    for (int g = 0; g < 3; ++g) {
      const double s = (1 + node[g]) / 2;
      const double radius = std::sin(a) + s * (std::sin(b) - std::sin(a));
      const double z = std::cos(a) - s * thick;
      volume += weight[g] * thick * area * radius * radius;
      axial += weight[g] * thick * polar * std::pow(radius, 4);
      height += weight[g] * thick * area * radius * radius * z * z;
    }
  }
  ShapeReport report;
  const Shape shape = shape_of(latitude_ball(around, rings), report);
  const double r = std::cbrt(0.75 * volume / kPi), m = volume * r * r;
  EXPECT_NEAR(report.volume, volume, kExact);
  expect_near(sorted(shape.inertia), Vec3(axial, axial / 2 + height, axial / 2 + height) / m,
              kExact);
  // contact.md quotes .9596 of the sphere's volume: four digits
  EXPECT_NEAR(report.volume / (4 * kPi / 3), 0.9596, 5e-5);
  EXPECT_EQ(shape.faces, 200u);  // 160 trapezoids and 40 triangles
  EXPECT_EQ(shape.vertices, 182u);
  EXPECT_EQ(shape.file_axes, Mat3::Identity());
}

TEST(Shape, IsTheSameAfterAnyRigidMotionAndScaling) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-5, 5);
  for (int trial = 0; trial < 40; ++trial) {
    const Triangles rock = random_rock(random, 8 + trial);
    const Mat3 turn = random_turn(random);
    const Vec3 move(shift(random), shift(random), shift(random));
    const double factor = std::exp(shift(random));
    const Shape a = shape_of(rock);
    const Shape b =
        shape_of(mapped(rock, [&](const Vec3& p) { return Vec3(factor * (turn * p + move)); }));
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.vertices, b.vertices);
    expect_near(a.inertia, b.inertia, kExact);
    EXPECT_NEAR(a.bound_radius, b.bound_radius, kExact);
    EXPECT_NEAR(a.inner_radius, b.inner_radius, kExact);
    EXPECT_NEAR(b.file_scale / a.file_scale, factor, kExact * factor);
    expect_near(b.file_centroid, factor * (turn * a.file_centroid + move), 10 * factor * kExact);
  }
}

TEST(Shape, DoesNotDependOnHowTrianglesAreOriented) {
  std::mt19937 random(3);
  const Triangles rock = random_rock(random, 30);
  const auto n = static_cast<Index>(rock.size());
  const Shape right = shape_of(rock);
  ShapeReport report;
  const Shape wrong = shape_of(turned_inside_out(rock), report);
  EXPECT_EQ(report.flipped, n);
  EXPECT_EQ(report.warnings.size(), 1u);
  expect_near(wrong.inertia, right.inertia, kExact);
  EXPECT_NEAR(*report.volume_ratio, 1, kExact);

  Triangles mixed = rock;
  Index turned = 0;
  for (Triangle& t : mixed)
    if (random() % 3 == 0) {
      std::swap(t.corner[0], t.corner[1]);
      ++turned;
    }
  const Shape same = shape_of(mixed, report);
  EXPECT_EQ(report.flipped, turned);
  expect_near(same.inertia, right.inertia, kExact);
}

TEST(Shape, OfFortyTrianglesHasTwelveFacesAndTwentyVertices) {
  const Triangles triangles = read_shipped("ore12.stl");
  ShapeReport report;
  const Shape shape = shape_of(triangles, report);
  EXPECT_EQ(report.triangles_read, 40u);
  EXPECT_EQ(report.welded_vertices, 22u);
  EXPECT_EQ(report.spare_vertices, 2u);
  EXPECT_EQ(shape.faces, 12u);
  EXPECT_EQ(shape.vertices, 20u);
  EXPECT_EQ(shape.edges, 30u);
  EXPECT_TRUE(report.warnings.empty());
  // Seven digits in the file: each face moves by 5e-8 at most, of an area of about 4 and a volume
  // of 0.5.
  EXPECT_NEAR(*report.volume_ratio, 1, 4 * 5e-8 / 0.5);
}

struct Shipped {
  const char* name;
  Index triangles, faces, vertices, edges;
};

class ShippedShape : public testing::TestWithParam<Shipped> {};

TEST_P(ShippedShape, IsAcceptedAsItIs) {
  const Shipped& expected = GetParam();
  ShapeReport report;
  const Shape shape = shape_of(read_shipped(std::string(expected.name) + ".stl"), report);
  EXPECT_EQ(report.triangles_read, expected.triangles);
  EXPECT_EQ(shape.faces, expected.faces);
  EXPECT_EQ(shape.vertices, expected.vertices);
  EXPECT_EQ(shape.edges, expected.edges);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_NEAR(2 * shape.file_scale, 1, 2e-7);  // seven digits: volume to 4e-7, a third of it
}

const Shipped kShipped[] = {
    {"cube", 12, 6, 8, 12},
    {"tetrahedron", 4, 4, 4, 6},
    {"ball360", 360, 200, 182, 380},
    {"ore12", 40, 12, 20, 30},
    {"rock_blocky_10", 28, 10, 16, 24},
    {"rock_blocky_16", 52, 16, 28, 42},
    {"rock_flat_12", 36, 12, 20, 30},
    {"rock_flat_14", 44, 14, 24, 36},
    {"rock_elongated_12", 36, 12, 20, 30},
    {"rock_elongated_14", 44, 14, 24, 36},
};

INSTANTIATE_TEST_SUITE_P(Shape, ShippedShape, testing::ValuesIn(kShipped),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Shape, DropsVerticesThatShapeNothing) {
  Triangles cube = unit_cube();
  const auto split = [&cube](std::size_t t, const Vec3& p) {  // p inside triangle t
    const Triangle whole = cube[t];
    cube[t] = {{whole.corner[0], whole.corner[1], p}};
    cube.push_back({{whole.corner[1], whole.corner[2], p}});
    cube.push_back({{whole.corner[2], whole.corner[0], p}});
  };
  split(2, {0.3, 0.2, 1});
  split(6, {0.5, 1, 0.7});
  for (Triangle& t : cube)  // corners that differ by less than the welding distance
    for (Vec3& p : t.corner) p += 1e-9 * Vec3(std::sin(31 * p[0]), std::cos(17 * p[1]), p[2]);
  cube.push_back({{Vec3(0, 0, 0), Vec3(0, 0, 0.5), Vec3(0, 0, 1)}});  // no area
  cube.push_back(cube.front());                                       // twice
  ShapeReport report;
  const Shape shape = shape_of(cube, report);
  EXPECT_EQ(report.dropped, 2u);
  EXPECT_EQ(report.spare_vertices, 2u);
  EXPECT_EQ(shape.faces, 6u);
  EXPECT_EQ(shape.vertices, 8u);
  EXPECT_EQ(shape.edges, 12u);
}

TEST(Shape, MergesFacesThatAreFlatToSinglePrecisionOnly) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const Mat3 turn = random_turn(random);
    const Triangles cube = mapped(box_solid({-1, -1, -1}, {1, 0.7, 0.4}), [&](const Vec3& p) {
      return Vec3((turn * p).cast<float>().cast<double>());
    });
    const Shape shape = shape_of(cube);
    EXPECT_EQ(shape.faces, 6u);
    for (Index f = 0; f < shape.faces; ++f)  // planes and vertices are the same body
      for (Index k = shape.face_begin[f]; k < shape.face_begin[f + 1]; ++k)
        EXPECT_NEAR(shape.normal(f).dot(shape.vertex(shape.face_vertex[k])), shape.d[f], kExact);
  }
}

TEST(Shape, TakesTheHullWhenAskedAndTellsTheVolumes) {
  const Triangles two = joined(unit_cube(), box_solid({0, 0, 2}, {1, 1, 3}));
  ShapeReport report;
  const Shape shape = build_shape(two, "two.stl", {true}, report);
  EXPECT_EQ(shape.faces, 6u);
  EXPECT_NEAR(report.volume, 3, kExact);
  EXPECT_NEAR(*report.mesh_volume, 2, kExact);
  EXPECT_NEAR(*report.volume_ratio, 1.5, kExact);
  ASSERT_EQ(report.warnings.size(), 2u);
  EXPECT_EQ(report.warnings[0],
            "two.stl: has 2 separate bodies, a shape is one; its hull was taken");
  EXPECT_EQ(report.warnings[1], "two.stl: the hull has 1.5 times the volume of the mesh");
}

// Half the depth that counts as a dent; its three faces then bend outwards along their diagonals.
TEST(Shape, TakesADentOfRoundingForConvex) {
  ShapeReport report;
  const Shape shape =
      shape_of(mapped(unit_cube(),
                      [](const Vec3& p) { return Vec3(p == Vec3::Ones() ? p * (1 - 4e-6) : p); }),
               report);
  EXPECT_EQ(shape.faces, 9u);
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Shape, HullOfAConvexBodyIsTheBody) {
  ShapeReport report;
  const Shape shape = build_shape(unit_cube(), "cube.stl", {true}, report);
  EXPECT_EQ(shape.faces, 6u);
  EXPECT_EQ(*report.volume_ratio, 1);
  EXPECT_TRUE(report.warnings.empty());
}

// The reader takes it by its size; what it holds is then a shape like any other.
TEST(Shape, IsReadFromBinaryThatBeginsWithSolid) {
  const Triangles cube = unit_cube();
  std::string bytes = "solid made by a CAD program";
  bytes.resize(80, ' ');
  const auto append = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<std::uint32_t>(cube.size()));
  for (const Triangle& t : cube) {
    for (int k = 0; k < 3; ++k) append(0.0f);
    for (const Vec3& p : t.corner)
      for (int k = 0; k < 3; ++k) append(static_cast<float>(p[k]));
    append(std::uint16_t{0});
  }
  const TempFolder folder;
  write_bytes(folder / "cube.stl", bytes);
  const MeshResult mesh = read_stl(folder / "cube.stl", 1);
  ASSERT_EQ(mesh.errors, std::vector<std::string>{});
  const Shape shape = shape_of(mesh.triangles);
  EXPECT_EQ(shape.faces, 6u);
  EXPECT_EQ(shape.vertices, 8u);
}

class ShapeLayout : public testing::TestWithParam<int> {
 protected:
  static Triangles body(int k) {
    std::mt19937 random(11);
    if (k == 0) return unit_cube();
    if (k == 1) return corner_tetrahedron();
    if (k == 2) return latitude_ball(20, 10);  // more than 64 faces
    return random_rock(random, 10 * k);
  }
};

TEST_P(ShapeLayout, PlanesHoldAllVerticesAndTouchTheirOwn) {
  const Shape shape = shape_of(body(GetParam()));
  for (Index f = 0; f < shape.faces; ++f) {
    EXPECT_NEAR(shape.normal(f).norm(), 1, kExact);
    EXPECT_GE(shape.d[f], shape.inner_radius);
    for (Index v = 0; v < shape.vertices; ++v)
      EXPECT_LE(shape.normal(f).dot(shape.vertex(v)), shape.d[f] + kExact);
    for (Index k = shape.face_begin[f]; k < shape.face_begin[f + 1]; ++k)
      EXPECT_NEAR(shape.normal(f).dot(shape.vertex(shape.face_vertex[k])), shape.d[f], kExact);
  }
  double bound = 0;
  for (Index v = 0; v < shape.vertices; ++v) bound = std::max(bound, shape.vertex(v).norm());
  EXPECT_EQ(bound, shape.bound_radius);
}

TEST_P(ShapeLayout, FacesRunCounterclockwiseAndKnowTheirEdges) {
  const Shape shape = shape_of(body(GetParam()));
  EXPECT_EQ(shape.vertices + shape.faces, shape.edges + 2);
  std::set<std::pair<Index, Index>> directed;
  for (Index f = 0; f < shape.faces; ++f) {
    const Index begin = shape.face_begin[f], end = shape.face_begin[f + 1];
    Vec3 area = Vec3::Zero();
    for (Index k = begin; k < end; ++k) {
      const Index from = shape.face_vertex[k], to = shape.face_vertex[k + 1 < end ? k + 1 : begin];
      area += shape.vertex(from).cross(shape.vertex(to));
      directed.insert({from, to});
      const std::size_t e = shape.face_edge[k];
      const bool forwards = shape.edge_vertex[2 * e] == from;
      EXPECT_EQ(shape.edge_vertex[2 * e + (forwards ? 1 : 0)], to);
      EXPECT_EQ(shape.edge_vertex[2 * e + (forwards ? 0 : 1)], from);
      EXPECT_EQ(shape.edge_face[2 * e + (forwards ? 0 : 1)], f);
    }
    EXPECT_GT(area.dot(shape.normal(f)), 0) << f;
  }
  EXPECT_EQ(directed.size(), 2u * shape.edges);
  for (const auto& [from, to] : directed) EXPECT_TRUE(directed.contains({to, from}));
}

TEST_P(ShapeLayout, VerticesNameTheFacesAroundThem) {
  const Shape shape = shape_of(body(GetParam()));
  ASSERT_EQ(shape.face_words, (shape.faces + 63) / 64);
  for (Index v = 0; v < shape.vertices; ++v)
    for (Index f = 0; f < shape.faces; ++f) {
      const auto* begin = shape.face_vertex.begin() + shape.face_begin[f];
      const auto* end = shape.face_vertex.begin() + shape.face_begin[f + 1];
      const bool named = shape.vertex_faces[v * shape.face_words + f / 64] >> f % 64 & 1;
      EXPECT_EQ(named, std::find(begin, end, v) != end) << v << " " << f;
    }
}

TEST_P(ShapeLayout, VerticesNameTheEdgesAtThem) {
  const Shape shape = shape_of(body(GetParam()));
  ASSERT_EQ(shape.edge_words, (shape.edges + 63) / 64);
  for (Index v = 0; v < shape.vertices; ++v)
    for (Index e = 0; e < shape.edges; ++e) {
      const bool named = shape.vertex_edges[v * shape.edge_words + e / 64] >> e % 64 & 1;
      EXPECT_EQ(named, shape.edge_vertex[2 * e] == v || shape.edge_vertex[2 * e + 1] == v);
    }
}

TEST_P(ShapeLayout, PaddingIsHarmless) {
  const Shape shape = shape_of(body(GetParam()));
  for (std::size_t v = shape.vertices; v < shape.padded_vertices(); ++v)
    EXPECT_EQ(shape.vertex(v), shape.vertex(0));
  for (std::size_t f = shape.faces; f < shape.padded_faces(); ++f) {
    EXPECT_EQ(shape.normal(f), Vec3::Zero());
    EXPECT_EQ(shape.d[f], kFarPlane);
  }
}

TEST_P(ShapeLayout, BodyFrameIsPrincipalAndOfUnitSize) {
  const Triangles file = body(GetParam());
  const Shape shape = shape_of(file);
  std::vector<Vec3> vertex;
  std::vector<std::array<Index, 3>> fans;
  for (Index v = 0; v < shape.vertices; ++v) vertex.push_back(shape.vertex(v));
  for (Index f = 0; f < shape.faces; ++f)
    for (Index k = shape.face_begin[f] + 1u; k + 1u < shape.face_begin[f + 1]; ++k)
      fans.push_back(
          {shape.face_vertex[shape.face_begin[f]], shape.face_vertex[k], shape.face_vertex[k + 1]});
  const MassProperties mass = mass_properties(vertex, fans);
  EXPECT_NEAR(mass.volume, 4 * kPi / 3, 5 * kExact);
  expect_near(mass.centroid, Vec3::Zero(), kExact);
  const Mat3 inertia = mass.inertia / mass.volume;
  EXPECT_LT((inertia - Mat3(shape.inertia.asDiagonal())).cwiseAbs().maxCoeff(), kExact);
  EXPECT_NEAR(shape.file_axes.determinant(), 1, kExact);
  for (const Triangle& t : file)  // every corner of the file is found again
    for (const Vec3& p : t.corner) {
      double nearest = 1;
      for (const Vec3& v : vertex)
        nearest = std::min(
            nearest, (shape.file_centroid + shape.file_scale * (shape.file_axes * v) - p).norm());
      EXPECT_LT(nearest, kExact);
    }
}

INSTANTIATE_TEST_SUITE_P(Shape, ShapeLayout, testing::Range(0, 6));

}  // namespace
}  // namespace quern
