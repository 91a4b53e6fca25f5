// Topology, queries and geometry of walls. Oracles: solids whose edges can be counted, brute force
// over all triangles, and the liner files of tests/golden.
#include "soa/facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "io/mesh_reader.h"
#include "tests/support/test_walls.h"
#include "tests/support/wall_oracle.h"

namespace quern {
namespace {

using test::facets_of;
using test::Random;

BoxSpec unit_box() {
  BoxSpec box;
  box.high = Vec3(1, 2, 3);
  return box;
}

std::vector<Triangle> box_surface() { return box_faces(unit_box(), Vec3(0, -9.81, 0)); }

Index count(const Facets& f, EdgeKind kind) {
  return static_cast<Index>(std::count(f.edge_kind.begin(), f.edge_kind.end(), kind));
}

std::vector<Triangle> triangles_of(const Facets& f) {
  std::vector<Triangle> out;
  for (const auto& r : f.record) out.push_back({r.corner});
  return out;
}

TEST(Facets, WeldLooseTrianglesIntoABoxWithSixFaces) {
  const Facets f = facets_of(box_surface());
  EXPECT_EQ(f.triangles(), 12u);
  EXPECT_EQ(f.vertices(), 8u);
  EXPECT_EQ(f.edges(), 18u);
  EXPECT_EQ(f.groups, 6u);
  EXPECT_EQ(count(f, EdgeKind::kFlat), 6u);
  for (Index t = 0; t < 12; t += 2) EXPECT_EQ(f.group[t], f.group[t + 1]);
}

TEST(Facets, CallEdgesConcaveFromInsideABoxAndConvexFromOutside) {
  EXPECT_EQ(count(facets_of(box_surface()), EdgeKind::kConcave), 12u);
  EXPECT_EQ(count(facets_of(test::turned_over(box_surface())), EdgeKind::kConvex), 12u);
}

TEST(Facets, CountTheTrianglesAroundEdgesAndVertices) {
  const Facets f = facets_of(box_surface());
  for (auto n : f.edge_valence) EXPECT_EQ(n, 2);
  int sum = 0;
  for (auto n : f.vertex_valence) sum += n;
  EXPECT_EQ(sum, 36);
}

TEST(Facets, FindBoundaryAndNonManifoldEdges) {
  const Vec3 o(0, 0, 0), x(1, 0, 0), a(0, 1, 0), b(0, -1, 0), c(0, 0, 1);
  const Facets f = facets_of({{{o, x, a}}, {{x, o, b}}, {{o, x, c}}});
  EXPECT_EQ(f.report.non_manifold_edges, 1u);
  EXPECT_EQ(f.report.boundary_edges, 6u);
  EXPECT_EQ(count(f, EdgeKind::kNonManifold), 1u);
  EXPECT_EQ(f.groups, 3u);
}

TEST(Facets, TakeAPlateOfMixedOrientationForOnePlane) {
  auto plate = plane_patch({}, Vec3::Zero(), 1);
  plate[1] = test::turned_over(plate[1]);
  const Facets f = facets_of(plate);
  EXPECT_EQ(f.groups, 1u);
  EXPECT_EQ(f.report.flipped_edges, 1u);
  EXPECT_EQ(f.normal[0], Vec3(-f.normal[1]));
}

TEST(Facets, WeldCornersWithinAMillionthOfTheBox) {
  auto surface = box_surface();
  const double tolerance = 1e-6 * std::sqrt(14.0);
  surface[0].corner[0].x() += 0.9 * tolerance;
  EXPECT_EQ(facets_of(surface).vertices(), 8u);
  // The first corner came first: all others at this place move to it, five or four of them.
  EXPECT_GE(facets_of(surface).report.welded_vertices, 3u);
  surface[0].corner[0].x() += 0.2 * tolerance;
  EXPECT_GT(facets_of(surface).vertices(), 8u);
}

TEST(Facets, DropZeroAreaTrianglesAndRepeats) {
  auto surface = box_surface();
  surface.push_back({{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)}});
  surface.push_back(test::turned_over(surface[3]));
  const Facets f = facets_of(surface);
  EXPECT_EQ(f.triangles(), 12u);
  EXPECT_EQ(f.report.triangles_read, 14u);
  EXPECT_EQ(f.report.zero_area, 1u);
  EXPECT_EQ(f.report.duplicates, 1u);
}

// The rim of a plate of side 2 is all that may stay free once the joints match.
double free_length(const Facets& f) {
  double sum = 0;
  std::set<Index> seen;
  for (Index i = 0; i < f.edge_of.size(); ++i) {
    const Index e = f.edge_of[i], side = i % 3, first = i - side;
    if (f.edge_kind[e] != EdgeKind::kBoundary || !seen.insert(e).second) continue;
    sum += (f.vertex[f.corner[i]] - f.vertex[f.corner[first + (side + 1) % 3]]).norm();
  }
  return sum;
}

TEST(Facets, SplitEdgesAtTJunctionsUntilAPlateIsOneGroup) {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const auto plate =
        test::moved(test::random_plate(200, true, random), random.turn(), random.in_cube(3));
    const Facets f = facets_of(plate);
    EXPECT_EQ(f.groups, 1u);
    EXPECT_GT(f.report.split_edges, 0u);
    EXPECT_NEAR(free_length(f), 8, 1e-9);
    EXPECT_NEAR(test::area(triangles_of(f)), 4, 1e-12);
  }
}

TEST(Facets, HealTheGapOfADroppedCollinearTriangle) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), m(0.5, 0, 0), up(0.5, 1, 0), down(0.5, -1, 0);
  const Facets f = facets_of({{{a, b, up}}, {{a, m, b}}, {{m, a, down}}, {{b, m, down}}});
  EXPECT_EQ(f.report.zero_area, 1u);
  EXPECT_EQ(f.report.split_edges, 1u);
  EXPECT_EQ(f.triangles(), 4u);
  EXPECT_EQ(f.groups, 1u);
  EXPECT_EQ(f.report.boundary_edges, 4u);
}

TEST(Facets, ShareNothingBetweenWalls) {
  const auto box = box_surface();
  const Facets f = build_facets({{box, 4}, {box, 2}}, 0.5);
  EXPECT_EQ(f.vertices(), 16u);
  EXPECT_EQ(f.groups, 12u);
  for (Index t = 0; t < 24; ++t) EXPECT_EQ(f.wall[t], t < 12 ? 4u : 2u);
}

TEST(Facets, MarkWhatLiesInsideAGroupInTheRecord) {
  Random random(2);
  const Facets f = facets_of(test::random_plate(50, false, random));
  for (const auto& r : f.record) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 middle = 0.5 * (r.corner[k] + r.corner[(k + 1) % 3]);
      const bool edge_inside = middle.cwiseAbs().maxCoeff() < 1 - 1e-12;
      const bool vertex_inside = r.corner[k].cwiseAbs().maxCoeff() < 1 - 1e-12;
      EXPECT_EQ((r.edge[k] & kInsideGroup) != 0, edge_inside);
      EXPECT_EQ((r.vertex[k] & kInsideGroup) != 0, vertex_inside);
    }
  }
}

TEST(Facets, GiveAPlaneGroupOneNormalToTheLastBit) {
  Random random(3);
  const auto plate =
      test::moved(test::random_plate(300, true, random), random.turn(), random.in_cube(1));
  const Facets f = facets_of(plate);
  for (const auto& n : f.normal) EXPECT_EQ(n, f.normal[0]);
}

TEST(Facets, RefuseACornerThatIsNotFinite) {
  auto surface = box_surface();
  surface[5].corner[1].z() = std::nan("");
  EXPECT_THROW(facets_of(surface), UserError);
}

TEST(Facets, MayBeEmpty) {
  const Facets f = build_facets({}, 0.1);
  std::vector<Index> found;
  find_facets(f, Vec3::Zero(), 1, found);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(distance_to_facets(f, Vec3::Zero(), 3), 3);
}

// Loose triangles of many sizes in every direction.
std::vector<Triangle> clutter(int n, Random& random) {
  std::vector<Triangle> out;
  for (int i = 0; i < n; ++i) {
    const Vec3 at = random.in_cube(1);
    const double size = std::pow(10, random(-2, 0));
    out.push_back({{at, at + random.in_cube(size), at + random.in_cube(size)}});
  }
  return out;
}

TEST(FacetQueries, FindExactlyTheTrianglesWithinReach) {
  Random random(4);
  for (const double cell : {0.02, 0.3, 5.0}) {
    const Facets f = facets_of(clutter(200, random), cell);
    const auto surface = triangles_of(f);
    for (int i = 0; i < 300; ++i) {
      const Vec3 x = random.in_cube(2.5);
      const double reach = random(0, 0.6);
      std::vector<Index> found = {kNoIndex}, expected = {kNoIndex};
      find_facets(f, x, reach, found);
      for (Index t = 0; t < surface.size(); ++t) {
        if ((oracle::closest_on_triangle(surface[t], x) - x).norm() <= reach) expected.push_back(t);
      }
      EXPECT_EQ(found, expected);
    }
  }
}

// The oracle solves a least-squares problem: its error grows with the condition of the triangle.
TEST(FacetQueries, GiveTheDistanceOfTheNearestTriangle) {
  Random random(5);
  for (const double cell : {0.02, 0.3, 5.0}) {
    const Facets f = facets_of(clutter(100, random), cell);
    const auto surface = triangles_of(f);
    for (int i = 0; i < 300; ++i) {
      const Vec3 x = random.in_cube(3);
      double nearest = 1e9;
      for (Index t = 0; t < surface.size(); ++t) {
        const Vec3 p = oracle::closest_on_triangle(surface[t], x);
        nearest = std::min(nearest, (p - x).norm());
        EXPECT_LT((closest_point(f, t, x) - p).norm(), 1e-10);
      }
      for (const double limit : {0.05, 0.5, 10.0}) {
        EXPECT_NEAR(distance_to_facets(f, x, limit), std::min(nearest, limit), 1e-10);
      }
    }
  }
}

TEST(FacetQueries, MeetAPlaneFromBehindAsWellAsFromTheFront) {
  const Facets f = facets_of(plane_patch({}, Vec3::Zero(), 1), 0.1);
  for (const double z : {-0.3, -1e-9, 0.0, 0.3}) {
    std::vector<Index> found;
    find_facets(f, Vec3(0.5, 0.1, z), 0.31, found);
    EXPECT_EQ(found.size(), 1u);
    EXPECT_DOUBLE_EQ(distance_to_facets(f, Vec3(0.5, 0.1, z), 1), std::abs(z));
  }
}

TEST(FacetQueries, KeepTheGridWithinMemoryForAnyCell) {
  const Facets f = facets_of(box_surface(), 1e-7);
  EXPECT_LT(f.cell_begin.size(), 70000u);
  EXPECT_DOUBLE_EQ(distance_to_facets(f, Vec3(0.4, 1, 1), 1), 0.4);
}

std::filesystem::path golden(const char* name) {
  return std::filesystem::path(__FILE__).parent_path().parent_path() / "golden" / name;
}

// Every corner of `a` is a corner of `b` within the tolerance.
bool corners_are_among(const std::vector<Triangle>& a, const std::vector<Triangle>& b,
                       double tolerance) {
  for (const auto& t : a) {
    for (const auto& p : t.corner) {
      double nearest = 1;
      for (const auto& u : b) {
        for (const auto& q : u.corner) nearest = std::min(nearest, (p - q).norm());
      }
      if (nearest > tolerance) return false;
    }
  }
  return true;
}

// For every triangle of `a` there is one in `b` of the same middle and area vector.
bool triangles_match(const std::vector<Triangle>& a, const std::vector<Triangle>& b,
                     double tolerance) {
  const auto middle = [](const Triangle& t) {
    return Vec3((t.corner[0] + t.corner[1] + t.corner[2]) / 3);
  };
  const auto normal = [](const Triangle& t) {
    return Vec3((t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]));
  };
  return std::all_of(a.begin(), a.end(), [&](const Triangle& t) {
    return std::any_of(b.begin(), b.end(), [&](const Triangle& u) {
      return (middle(t) - middle(u)).norm() < tolerance &&
             (normal(t) - normal(u)).norm() < tolerance;
    });
  });
}

// The files have nine digits: 5e-10 on coordinates of 0.15.
TEST(MillGeometry, ShellEqualsTheLinerOfTheReferenceRuns) {
  const auto shell = mill_shell(test::lab_mill(), -0.002, 0.042);
  const auto file = read_stl(golden("lab_mill_liner.stl").string(), 1).triangles;
  ASSERT_EQ(file.size(), shell.size());
  EXPECT_TRUE(corners_are_among(shell, file, 1e-8));
  EXPECT_TRUE(corners_are_among(file, shell, 1e-8));
  EXPECT_TRUE(triangles_match(shell, file, 1e-9));
  EXPECT_NEAR(test::area(shell), test::area(file), 1e-9);
}

TEST(MillGeometry, EndsEqualThoseOfTheReferenceRuns) {
  const auto ends = mill_ends(test::lab_mill());
  const auto file = read_stl(golden("lab_mill_ends.stl").string(), 1).triangles;
  ASSERT_EQ(file.size(), ends.size());
  EXPECT_TRUE(corners_are_among(ends, file, 1e-8));
  EXPECT_TRUE(triangles_match(ends, file, 1e-9));
}

TEST(MillGeometry, ShellHasTwoConvexEdgesALifter) {
  const Facets f = facets_of(mill_shell(test::lab_mill(), 0, 0.04), 0.01);
  EXPECT_EQ(count(f, EdgeKind::kConvex), 36u);
  EXPECT_EQ(count(f, EdgeKind::kConcave), 5u * 18);
  EXPECT_EQ(count(f, EdgeKind::kFlat), 7u * 18);
  EXPECT_EQ(count(f, EdgeKind::kBoundary), 14u * 18);
  EXPECT_EQ(f.report.split_edges, 0u);
}

TEST(MillGeometry, LiftersHaveTheirHeightWidthAndFaceAngle) {
  const auto p = mill_profile(test::lab_mill());
  EXPECT_NEAR(p[1].x(), 0.14, 1e-15);
  EXPECT_NEAR(p[2].x(), 0.14, 1e-15);
  EXPECT_NEAR(p[2].y() - p[1].y(), 0.01, 1e-15);
  EXPECT_NEAR(p[3].norm(), 0.15, 1e-15);
  const double angle = std::atan2(p[3].y() - p[2].y(), p[3].x() - p[2].x());
  EXPECT_NEAR(angle, 14 * kPi / 180, 1e-13);
}

TEST(MillGeometry, InnerAreaOfAPlainShellIsThatOfItsPolygon) {
  MillSpec mill;
  mill.diameter = 2;
  mill.pieces_per_arc = 90;
  EXPECT_NEAR(mill_inner_area(mill), 45 * std::sin(2 * kPi / 90), 1e-13);
}

// Shell triangles and the profile describe the same body: its volume from the closed surface.
TEST(MillGeometry, InnerAreaIsWhatTheShellEncloses) {
  double twice = 0;
  for (const auto& t : mill_shell(test::lab_mill(), 0, 1)) {
    const Vec3 normal = 0.5 * (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]);
    twice -= normal.dot(t.corner[0]);
  }
  EXPECT_NEAR(mill_inner_area(test::lab_mill()), 0.5 * twice, 1e-15);
}

TEST(MillGeometry, ProfileContainsTheChargeAndNotTheLifters) {
  const auto profile = mill_profile(test::lab_mill());
  EXPECT_TRUE(profile_contains(profile, 0, 0));
  EXPECT_TRUE(profile_contains(profile, 0.1399, 0.004));
  EXPECT_FALSE(profile_contains(profile, 0.1401, 0.004));
  EXPECT_FALSE(profile_contains(profile, 0.16, 0));
  const double between = kPi / 18;
  EXPECT_TRUE(profile_contains(profile, 0.149 * std::cos(between), 0.149 * std::sin(between)));
}

TEST(WallShapes, PlanePatchLiesInThePlaneAndFacesTheCharge) {
  PlaneSpec plane;
  plane.point = Vec3(1, 2, 3);
  plane.normal = Vec3(0.3, -2, 0.5);
  const auto patch = plane_patch(plane, Vec3(4, -1, 2), 2.5);
  const Vec3 n = plane.normal.normalized();
  EXPECT_NEAR(test::area(patch), 25, 1e-12);
  const Facets f = facets_of(patch);
  for (const auto& r : f.record) {
    EXPECT_LT((r.normal - n).norm(), 1e-15);
    EXPECT_NEAR(n.dot(r.corner[0] - plane.point), 0, 1e-14);
  }
  Vec3 middle = 0.5 * (patch[0].corner[0] + patch[0].corner[2]);
  EXPECT_LT((middle - Vec3(4, -1, 2)).cross(n).norm(), 1e-14);
}

TEST(WallShapes, BoxFacesLookInwards) {
  const Vec3 middle(0.5, 1, 1.5);
  for (const auto& r : facets_of(box_surface()).record) {
    EXPECT_GT(r.normal.dot(middle - r.corner[0]), 0.4);
  }
}

TEST(WallShapes, OpenBoxLacksTheFaceAgainstGravity) {
  BoxSpec box = unit_box();
  box.open_top = true;
  const auto has = [&](const Vec3& gravity, const Vec3& on_face) {
    const auto f = facets_of(box_faces(box, gravity));
    return distance_to_facets(f, on_face, 1) < 1e-12;
  };
  EXPECT_FALSE(has(Vec3(0, -9.81, 0), Vec3(0.5, 2, 1.5)));
  EXPECT_TRUE(has(Vec3(0, -9.81, 0), Vec3(0.5, 0, 1.5)));
  EXPECT_FALSE(has(Vec3(0, 0, 9.81), Vec3(0.5, 1, 0)));
  EXPECT_TRUE(has(Vec3(0, 0, 9.81), Vec3(0.5, 1, 3)));
}

}  // namespace
}  // namespace quern
