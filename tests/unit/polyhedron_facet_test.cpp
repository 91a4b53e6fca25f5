// Patches of walls in a polyhedron: plates in any triangulation, edges, corners, shells, sheets.
#include "kernels/pairs/polyhedron_facet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/polyhedron_contacts.h"
#include "tests/support/test_shapes.h"

namespace quern::test {
namespace {

std::vector<WallPatch> touches(const Facets& facets, const ShapePose& pose,
                               const WallPatchOptions& options = {}) {
  std::vector<Index> candidates;
  find_facets(facets, pose.place, pose.scale * pose.shape->bound_radius, candidates);
  std::vector<WallPatch> out(kMaxWallPatches);
  out.resize(static_cast<std::size_t>(
      polyhedron_facet_touches(facets, pose, candidates, options, out.data(), kMaxWallPatches)));
  return out;
}

// Two triangles over |x|, |y| < half in the plane z = 0, facing up.
std::vector<Triangle> plate(double half) {
  const Vec3 a(-half, -half, 0), b(half, -half, 0), c(half, half, 0), d(-half, half, 0);
  return {{{a, b, c}}, {{a, c, d}}};
}

// A strip |y| < 1 over the polyline of (x, z) points, facing up where it runs along +x.
std::vector<Triangle> strip(const std::vector<Eigen::Vector2d>& line) {
  std::vector<Triangle> out;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec3 a(line[k].x(), -1, line[k].y()), b(line[k + 1].x(), -1, line[k + 1].y());
    const Vec3 c(b.x(), 1, b.z()), d(a.x(), 1, a.z());
    out.push_back({{a, b, c}});
    out.push_back({{a, c, d}});
  }
  return out;
}

// A pose whose deepest vertex is `depth` below the plane n.x = 0.
ShapePose pressed(const Shape& shape, double scale, const Mat3& turn, const Vec3& place,
                  const Vec3& n, double depth) {
  ShapePose pose{&shape, scale, place, turn};
  pose.place += (deepest_vertex(pose, n, 0) - depth) * n;
  return pose;
}

// T13. Rounding of places of size 1 is 2e-16, of which an overlap of 1e-5 R = 1e-6 keeps 1e-9.
TEST(PolyhedronOnPlate, IsOneContactAsDeepAsItsDeepestVertex) {
  Random random(1);
  const std::vector<Shape> shapes = [] {
    std::vector<Shape> list;
    for (unsigned seed : {1u, 2u, 3u}) list.push_back(rock(12, seed));
    list.push_back(built_box({1, 1, 1}));
    list.push_back(built_box({3, 1, 0.3}));
    return list;
  }();
  for (int trial = 0; trial < 40; ++trial) {
    const Mat3 frame = random.turn();
    const Vec3 n = frame.col(2);
    const Facets wall =
        facets_of(moved(random_plate(30, trial % 2 == 0, random), frame, Vec3::Zero()));
    for (const Shape& shape : shapes) {
      for (const double overlap : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
        const double scale = 0.1;
        const Vec3 over = frame * Vec3(random(-0.5, 0.5), random(-0.5, 0.5), 0);
        const ShapePose pose = pressed(shape, scale, random.turn(), over, n, overlap * scale);
        const auto found = touches(wall, pose, {OverlapMeasure::kChord, 1});
        ASSERT_EQ(found.size(), 1u);
        EXPECT_LT((found[0].normal - n).norm(), 1e-12);
        EXPECT_NEAR(found[0].overlap / deepest_vertex(pose, n, 0), 1, 1e-9);
        EXPECT_EQ(found[0].flags & ~kPatchBehind, 0u);
        EXPECT_EQ(found[0].feature, 0u);
      }
    }
  }
}

TEST(PolyhedronOnPlate, IsTheSameInEveryTriangulationAndSizeOfThePlate) {
  Random random(2);
  const Shape shape = rock(12, 4);
  const Facets coarse = facets_of(plate(1)), large = facets_of(plate(500), 100);
  for (int trial = 0; trial < 100; ++trial) {
    const Facets fine = facets_of(random_plate(60, trial % 2 == 0, random));
    const double overlap = 0.1 * std::pow(10.0, random(-4, -1));
    const ShapePose pose =
        pressed(shape, 0.1, random.turn(), Vec3(random(-0.5, 0.5), random(-0.5, 0.5), 0),
                Vec3::UnitZ(), overlap);
    const auto one = touches(coarse, pose);
    for (const Facets* other : {&fine, &large}) {
      const auto two = touches(*other, pose);
      ASSERT_EQ(one.size(), 1u);
      ASSERT_EQ(two.size(), 1u);
      // Edges and planes of a plate of 500 are good to 1e-13: the size of the rounding of its
      // corners times the direction's.
      const double noise = other == &large ? 1e-12 : 1e-15;
      EXPECT_NEAR(two[0].overlap / one[0].overlap, 1, 1e-10 + noise / overlap);
      EXPECT_LT((two[0].point - one[0].point).norm(), 1e-10 * 0.1 + noise);
      EXPECT_NEAR(two[0].area / one[0].area, 1, 1e-10 + noise / overlap);
      EXPECT_EQ(two[0].normal, one[0].normal);
    }
  }
}

// What spares the narrow phase: a body found apart is moved and turned within what its distance
// allows, and must not touch. The valley's edges, its outer ones and its slopes all bound some poses.
TEST(PolyhedronApartFromWall, TouchesNothingAsLongAsItsDistanceHolds) {
  Random random(31);
  const Facets valley = facets_of(strip({{-1, 0.5}, {0, 0}, {1, 0.5}}));
  std::vector<Index> all;
  for (Index t = 0; t < valley.triangles(); ++t) all.push_back(t);
  const double scale = 0.1;
  int apart = 0, held = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Shape shape = rock(12, static_cast<unsigned>(trial % 5 + 1));
    const Vec3 place(random(-1.2, 1.2), random(-1.2, 1.2), random(-0.2, 0.7));
    const ShapePose pose{&shape, scale, place, random.turn()};
    const double distance = distance_from_facets(valley, pose, all);
    if (!touches(valley, pose).empty()) {
      EXPECT_EQ(distance, 0);
      continue;
    }
    if (distance == 0) continue;
    ++apart;
    const ApartFromWall known{pose.place, pose.turn, distance};
    for (int k = 0; k < 8; ++k) {
      const double turned = random(0, 1.2) * distance / (scale * shape.bound_radius);
      const double moved_by = random(0, 1.2) * distance;
      ShapePose now = pose;
      const Vec3 axis = random.turn().col(0);
      now.turn = Eigen::AngleAxisd(turned, axis).toRotationMatrix() * pose.turn;
      now.place += moved_by * random.turn().col(0);
      if (!known.holds(now)) continue;
      ++held;
      EXPECT_TRUE(touches(valley, now).empty());
    }
  }
  EXPECT_GT(apart, 500);
  EXPECT_GT(held, 500);
}

// Area and moment are those of the section, the point is the centroid of what is below: brute
// force.
TEST(PolyhedronOnPlate, HasTheAreaAndCentroidOfTheClippedBody) {
  Random random(3);
  const Facets wall = facets_of(random_plate(20, false, random));
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Shape shape = rock(12, seed);
    const ShapePose pose = pressed(shape, 0.2, random.turn(), Vec3::Zero(), Vec3::UnitZ(),
                                   0.2 * std::pow(10.0, random(-3, -0.5)));
    std::vector<Plane> planes = planes_of(shape);
    planes.push_back(to_body(pose, Plane{Vec3::UnitZ(), 0}));
    const Polyhedron below = convex_hull(corners_behind(planes, 1e-13));
    ASSERT_FALSE(below.empty());
    double volume = 0;
    Vec3 first = Vec3::Zero();
    const Vec3 o = below.vertex[0];
    for (const auto& t : below.triangles()) {
      const Vec3 a = below.vertex[t[0]] - o, b = below.vertex[t[1]] - o, c = below.vertex[t[2]] - o;
      const double piece = a.dot(b.cross(c)) / 6;
      volume += piece;
      first += piece / 4 * (a + b + c);
    }
    const auto found = touches(wall, pose);
    ASSERT_EQ(found.size(), 1u);
    // Corners of the oracle are good to 1e-13 over a depth of 1e-3 of the radius.
    EXPECT_NEAR(found[0].volume / (volume * 8e-3), 1, 1e-9);
    EXPECT_LT((found[0].point - point_of(pose, o + first / volume)).norm(), 1e-9);
    // -dV/dz of the clipped body is its section: central differences err by (1e-7 / depth)^2 / 3.
    EXPECT_LT((found[0].vector_area - found[0].area * Vec3::UnitZ()).norm(), 1e-15);
    ShapePose up = pose, down = pose;
    up.place.z() += 1e-7;
    down.place.z() -= 1e-7;
    EXPECT_NEAR((touches(wall, down)[0].volume - touches(wall, up)[0].volume) / 2e-7, found[0].area,
                1e-6 * found[0].area);
  }
}

// A face pressed onto a right edge that points up: by symmetry the normal halves the corner, and
// the edge stands as deep in the polyhedron as it was pressed.
TEST(PolyhedronOnConvexEdge, IsOneContactAlongTheSumOfTheAreas) {
  const Facets wall = facets_of(strip({{-1, -1}, {0, 0}, {1, -1}}));
  ASSERT_EQ(wall.report.boundary_edges, 6u);
  const Shape cube = built_box({1, 1, 1});
  const double half = 0.5 * cube.vertex(0).cwiseAbs().maxCoeff() * 2 * 0.1;
  const ShapePose pose{&cube, 0.1, Vec3(0, 0.3, half - 1e-3), Mat3::Identity()};
  for (const OverlapMeasure measure : {OverlapMeasure::kChord, OverlapMeasure::kWidth}) {
    const auto found = touches(wall, pose, {measure, 0});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LT((found[0].normal - Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(found[0].overlap, 1e-3, 1e-14);
    // A prism of triangular section: its centroid is a third of the height above its base.
    EXPECT_LT((found[0].point - Vec3(0, 0.3, -1e-3 * 2 / 3)).norm(), 1e-12);
    EXPECT_NEAR(found[0].area, 2e-3 * 2 * half, 1e-14);
  }
}

// Rolling over the edge with a corner in front, the force turns from one face's normal to the
// other's without a jump: the largest change between neighbours halves when samples double. What a
// jump of a tenth would leave is 0.9.
TEST(PolyhedronOnConvexEdge, PassesOverWithoutAJump) {
  const Facets wall = facets_of(strip({{-1, -0.2}, {0, 0}, {1, -0.5}}));
  const Shape shape = rock(12, 6);
  const auto largest_step = [&](int samples) {
    Vec3 before = Vec3::Zero();
    double most = 0;
    for (int k = 0; k <= samples; ++k) {
      const double t = static_cast<double>(k) / samples;
      const Mat3 turn = Eigen::AngleAxisd(2 * t, Vec3(0.1, 1, 0.2).normalized()).toRotationMatrix();
      const ShapePose pose{&shape, 0.1, Vec3(-0.1 + 0.2 * t, 0.1, 0.045), turn};
      const auto found = touches(wall, pose, {OverlapMeasure::kChord, 1});
      EXPECT_EQ(found.size(), 1u);
      if (found.size() != 1) continue;
      const Vec3 force = found[0].overlap * found[0].normal;
      if (k > 0) most = std::max(most, (force - before).norm());
      before = force;
    }
    return most;
  };
  const double coarse = largest_step(1000), fine = largest_step(4000);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine / coarse, 0.35);
}

TEST(PolyhedronInConcaveCorner, IsTwoContactsEachAsDeepAsItsOwnWall) {
  Random random(4);
  const Facets wall = facets_of(strip({{0, 1}, {0, 0}, {1, 0}}));  // floor, and a wall facing +x
  const Shape cube = built_box({1, 1, 1});
  const double half = 0.1 * cube.vertex(0).cwiseAbs().maxCoeff();
  const ShapePose flush{&cube, 0.1, Vec3(half - 2e-3, 0, half - 1e-3), Mat3::Identity()};
  const auto found = touches(wall, flush);
  ASSERT_EQ(found.size(), 2u);
  const bool floor_first = found[0].normal.z() > 0.5;
  const WallPatch &floor = found[floor_first ? 0 : 1], &side = found[floor_first ? 1 : 0];
  EXPECT_LT((floor.normal - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((side.normal - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_NEAR(floor.overlap, 1e-3, 1e-14);
  EXPECT_NEAR(side.overlap, 2e-3, 1e-14);
  EXPECT_NEAR(floor.point.x(), half - 1e-3, 1e-12);  // behind the floor only, not behind the wall
  EXPECT_NE(floor.flags & kPatchLimited, 0u);
}

TEST(PolyhedronInConcaveCorner, KeepsTheLargerPatchWhereThereIsRoomForOne) {
  const Facets wall = facets_of(strip({{0, 1}, {0, 0}, {1, 0}}));
  const Shape box = built_box({1, 1, 0.5});
  Vec3 half = Vec3::Zero();
  for (std::size_t k = 0; k < box.vertices; ++k) half = half.cwiseMax(0.1 * box.vertex(k));
  const ShapePose pose{&box, 0.1, Vec3(half.x() - 1e-3, 0, half.z() - 1e-3), Mat3::Identity()};
  std::vector<Index> candidates;
  find_facets(wall, pose.place, 0.1 * box.bound_radius, candidates);
  WallPatch one[1], two[2];
  ASSERT_EQ(polyhedron_facet_touches(wall, pose, candidates, {}, two, 2), 2);
  ASSERT_EQ(polyhedron_facet_touches(wall, pose, candidates, {}, one, 1), 1);
  EXPECT_EQ(one[0].area, std::max(two[0].area, two[1].area));
  EXPECT_NE(two[0].area, two[1].area);
  EXPECT_EQ(polyhedron_facet_touches(wall, pose, candidates, {}, one, 0), 0);
}

// The chord behind a limited wall is that of the corner inside the limit: a tilted cube over the
// edge of an open sheet, its deepest edge beyond. The height of the cube's face at the sheet's
// edge, on paper: the face through (0, -depth) at angle a rises as tan a.
TEST(PolyhedronOverAFreeEdge, IsPressedByTheSheetOnly) {
  const Facets wall = facets_of(plate(1));
  const Shape cube = built_box({1, 1, 1});
  const double half = 0.1 * cube.vertex(0).cwiseAbs().maxCoeff(), a = 0.1;
  const Mat3 turn = Eigen::AngleAxisd(a, Vec3::UnitY()).toRotationMatrix();  // +x side down
  // The lowest edge of the cube, relative to its centre.
  const Vec3 low = turn * Vec3(half, 0, -half);
  const double beyond = 0.02, depth = 3e-3;
  const ShapePose pose{&cube, 0.1, Vec3(1 + beyond - low.x(), 0, -depth - low.z()), turn};
  const auto found = touches(wall, pose);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((found[0].normal - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(found[0].overlap, depth - beyond * std::tan(a), 1e-14);
  EXPECT_LT(found[0].point.x(), 1);
  EXPECT_NE(found[0].flags & kPatchLimited, 0u);
  ShapePose off = pose;
  off.place.x() += 0.011;  // the sheet's edge is now where the face leaves the plane
  EXPECT_TRUE(touches(wall, off).empty());
}

TEST(PolyhedronOverAFreeEdge, SlidesOffWithoutAJump) {
  const Facets wall = facets_of(plate(1));
  const Shape shape = rock(12, 8);
  const Mat3 turn = Random(5).turn();
  const auto largest_step = [&](int samples) {
    double before = -1, most = 0;
    for (int k = 0; k <= samples; ++k) {
      const ShapePose pose =
          pressed(shape, 0.1, turn, Vec3(0.9 + 0.2 * k / samples, 0, 0), Vec3::UnitZ(), 5e-3);
      const auto found = touches(wall, pose);
      const double overlap = found.empty() ? 0 : found[0].overlap;
      EXPECT_LE(found.size(), 1u);
      if (before >= 0) most = std::max(most, std::abs(overlap - before));
      before = overlap;
    }
    EXPECT_EQ(before, 0);
    return most;
  };
  EXPECT_LT(largest_step(4000) / largest_step(1000), 0.35);
}

// Shell of many pieces of 13 mm, nearly flat concave edges, and a rock of 8 mm that slides round it
// with its deepest vertex up to 0.34 mm behind the pieces.
struct ShellSlide {
  double largest_step = 0, largest_force = 0;  // force in units of the stiffness, m
  int single = 0, twice = 0, other = 0;
};

ShellSlide slide_round(const Facets& wall, const Shape& shape, const Mat3& turn, int samples) {
  ShellSlide slide;
  Vec3 before = Vec3::Zero();
  for (int k = 0; k <= samples; ++k) {
    const double angle = 0.5 * k / samples;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    ShapePose pose{&shape, 0.004, Vec3::Zero(), turn};
    pose.place = (0.15 + 2e-4 - deepest_vertex(pose, -out, 0)) * out;
    const auto found = touches(wall, pose);
    slide.single += found.size() == 1;
    slide.twice += found.size() == 2;
    slide.other += found.empty() || found.size() > 2;
    Vec3 force = Vec3::Zero();
    for (const WallPatch& p : found) {
      force += p.overlap * p.normal;
      EXPECT_LT(p.normal.dot(out), -0.99);
      EXPECT_LT(p.overlap, 4e-4);  // 2e-4, the sagitta 1.43e-4, and 2.5 degrees of turn
    }
    if (k > 0) slide.largest_step = std::max(slide.largest_step, (force - before).norm());
    slide.largest_force = std::max(slide.largest_force, force.norm());
    before = force;
  }
  return slide;
}

Facets shell_of_pieces() {
  MillSpec mill = lab_mill();
  mill.lifters.reset();
  mill.pieces_per_arc = 72;
  return facets_of(mill_shell(mill, -0.1, 0.1), 0.02);
}

// One contact in the middle of a piece, two about an edge, never none, and the force goes from
// piece to piece without a jump. (Where walls are not limited at concave edges, half of it appears
// at once.)
TEST(PolyhedronInAShell, PassesFromPieceToPieceWithoutAJump) {
  const Facets wall = shell_of_pieces();
  for (unsigned seed : {10u, 11u, 12u}) {
    const Shape shape = rock(12, seed);
    const Mat3 turn = Random(seed).turn();
    const ShellSlide coarse = slide_round(wall, shape, turn, 1000);
    const ShellSlide fine = slide_round(wall, shape, turn, 4000);
    EXPECT_EQ(fine.other, 0);
    EXPECT_GT(fine.single, 1000);
    EXPECT_GT(fine.twice, 100);
    EXPECT_LT(fine.largest_step / coarse.largest_step, 0.35);
  }
}

// A face that leans over the edge before it enters the next piece brings the depth it leans over
// with it: measured 8 % of the largest force, in whatever steps.
TEST(PolyhedronInAShell, ALeaningFaceEntersWithAFractionOfTheForce) {
  const Facets wall = shell_of_pieces();
  const ShellSlide fine = slide_round(wall, rock(12, 9), Mat3::Identity(), 16000);
  EXPECT_EQ(fine.other, 0);
  EXPECT_LT(fine.largest_step, 0.1 * fine.largest_force);
}

// Whatever the grouping, nothing of the liner is lost: the patches' area vectors add up to those of
// all triangles, each clipped for itself.
TEST(PolyhedronInAMill, PatchesAddUpToTheLinerInsideThePolyhedron) {
  Random random(6);
  std::vector<Triangle> liner = mill_shell(lab_mill(), -0.02, 0.02);
  for (const Triangle& t : mill_ends(lab_mill())) liner.push_back(t);
  const Facets wall = facets_of(liner, 0.02);
  const Shape shape = rock(12, 10);
  int many = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double angle = random(0, 2 * kPi), r = random(0.12, 0.148);
    const ShapePose pose{&shape, random(0.004, 0.012),
                         Vec3(r * std::cos(angle), r * std::sin(angle), random(-0.02, 0.02)),
                         random.turn()};
    Vec3 expected = Vec3::Zero();
    for (const FacetRecord& facet : wall.record) {
      ClipBuffers buffers;
      buffers.start();
      for (const Vec3& c : facet.corner) buffers.add(to_body(pose, c), 0);
      if (!clip_by_shape(buffers, shape, 0)) continue;
      const Vec3 n = pose.turn.transpose() * facet.normal;
      expected += polygon_area(*buffers.now, n) * pose.scale * pose.scale * facet.normal;
    }
    Vec3 sum = Vec3::Zero();
    const auto found = touches(wall, pose, {OverlapMeasure::kChord, 1});
    many += found.size() > 2;
    for (const WallPatch& p : found) {
      sum += p.vector_area;
      EXPECT_EQ(p.flags & kPatchFull, 0u);
      EXPECT_GT(p.overlap, 0);
      EXPECT_TRUE(p.point.allFinite());
      EXPECT_LT((p.point - pose.place).norm(), pose.scale * shape.bound_radius * (1 + 1e-12));
    }
    for (std::size_t k = 1; k < found.size(); ++k) {
      EXPECT_LT(found[k - 1].feature, found[k].feature);
    }
    EXPECT_LT((sum - expected).norm(), 1e-10 * pose.scale * pose.scale);
  }
  EXPECT_GT(many, 50);
}

TEST(PolyhedronInAMill, TurnsAndMovesWithTheMill) {
  Random random(7);
  const std::vector<Triangle> shell = mill_shell(lab_mill(), -0.02, 0.02);
  const Mat3 turn = random.turn();
  const Vec3 shift(0.3, -0.2, 0.5);
  const Facets here = facets_of(shell, 0.02), there = facets_of(moved(shell, turn, shift), 0.02);
  const Shape shape = rock(12, 11);
  for (int trial = 0; trial < 500; ++trial) {
    const double angle = random(0, 2 * kPi), r = random(0.12, 0.14);
    const ShapePose pose{&shape, 0.01, Vec3(r * std::cos(angle), r * std::sin(angle), 0),
                         random.turn()};
    const ShapePose carried{&shape, 0.01, turn * pose.place + shift, turn * pose.turn};
    const auto one = touches(here, pose), two = touches(there, carried);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      // Places of size 1 are good to 1e-16, that is 1e-14 R; grazing patches may be that deep.
      if (one[k].overlap < 1e-8) continue;
      EXPECT_NEAR(two[k].overlap, one[k].overlap, 1e-13);
      EXPECT_LT((two[k].normal - turn * one[k].normal).norm(), 1e-8);
      EXPECT_LT((two[k].point - (turn * one[k].point + shift)).norm(), 1e-8);
    }
  }
}

TEST(PolyhedronOnPlate, StopsAtTheThicknessOfTheWall) {
  const Facets wall = facets_of(plate(1));
  const Shape cube = built_box({1, 1, 1});
  const ShapePose pose = pressed(cube, 0.1, Mat3::Identity(), Vec3::Zero(), Vec3::UnitZ(), 0.05);
  const auto thick = touches(wall, pose),
             thin = touches(wall, pose, {OverlapMeasure::kChord, 0.01});
  ASSERT_EQ(thick.size(), 1u);
  EXPECT_NEAR(thick[0].overlap, 0.05, 1e-15);
  EXPECT_EQ(thick[0].flags, 0u);
  ASSERT_EQ(thin.size(), 1u);
  EXPECT_EQ(thin[0].overlap, 0.01);
  EXPECT_EQ(thin[0].flags, std::uint32_t{kPatchDeep});
}

// Three quarters of a plate, the corner of the notch below a cube: the edges of the notch cannot
// both be limits, for each would take away a quarter of the sheet that carries.
TEST(PolyhedronOnPlate, ANotchTakesNothingAway) {
  std::vector<Triangle> sheet;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}}) {
    for (const Triangle& t : moved(plate(0.5), Mat3::Identity(), Vec3(x, y, 0))) sheet.push_back(t);
  }
  const Facets wall = facets_of(sheet);
  const Shape cube = built_box({1, 1, 1});
  const ShapePose pose = pressed(cube, 0.1, Mat3::Identity(), Vec3::Zero(), Vec3::UnitZ(), 1e-3);
  const auto found = touches(wall, pose);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3::UnitZ());
  EXPECT_NEAR(found[0].overlap, 1e-3, 1e-15);
  const double side = 0.2 * cube.vertex(0).cwiseAbs().maxCoeff();
  EXPECT_NEAR(found[0].area, 0.75 * side * side, 1e-15);
  EXPECT_EQ(found[0].flags, std::uint32_t{kPatchNotched});
}

TEST(PolyhedronOnPlate, FlushOrApartRaisesNothing) {
  const Facets wall = facets_of(plate(1));
  const Shape cube = built_box({1, 1, 1});
  for (const double depth : {-1e-3, -1e-16, 0.0, 1e-16}) {
    const ShapePose pose = pressed(cube, 0.1, Mat3::Identity(), Vec3::Zero(), Vec3::UnitZ(), depth);
    for (const WallPatch& p : touches(wall, pose)) EXPECT_LT(p.overlap, 1e-15);
  }
}

}  // namespace
}  // namespace quern::test
