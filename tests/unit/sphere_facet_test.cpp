// Sphere against triangulated walls: one contact where there is one, none lost, none doubled.
//
// Oracles: the analytic plane, the cone of an edge, and tests/support/wall_oracle.h.
#include "kernels/pairs/sphere_facet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/test_walls.h"
#include "tests/support/wall_oracle.h"

namespace quern {
namespace {

using test::facets_of;
using test::Random;
using Touches = std::vector<WallTouch>;

Touches touches(const Facets& f, const Vec3& center, double radius) {
  std::vector<Index> candidates;
  find_facets(f, center, 1.01 * radius, candidates);
  Touches out(kMaxWallTouches);
  const int n = sphere_facet_touches(f, center, radius, candidates, out.data(), kMaxWallTouches);
  out.resize(static_cast<std::size_t>(n));
  return out;
}

std::vector<Triangle> triangles_of(const Facets& f) {
  std::vector<Triangle> out;
  for (const auto& r : f.record) out.push_back({r.corner});
  return out;
}

// A plate moved anywhere, with its plane known before rounding.
struct Plate {
  Mat3 turn;
  Vec3 shift;
  Facets facets;
  std::vector<Triangle> flat;  // before moving
  Plate(int cuts, bool t_junctions, Random& random)
      : turn(random.turn()), shift(random.in_cube(1)) {
    flat = test::random_plate(cuts, t_junctions, random);
    facets = facets_of(test::moved(flat, turn, shift), 0.1);
  }
};

// Points of a triangle where triangles could disagree, and some where they can't.
std::vector<Vec3> delicate_points(const Triangle& t, Random& random) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = t.corner[k], &b = t.corner[(k + 1) % 3];
    for (const Vec3& p : {a, Vec3(0.5 * (a + b)), Vec3(a + random(0, 1) * (b - a))}) {
      points.push_back(p);
      points.push_back(p + Vec3(1e-15, 0, 0));
      points.push_back(p + Vec3(-1e-15, 1e-15, 0));
      points.push_back(p + Vec3(0, -1e-15, 0));
    }
  }
  for (int i = 0; i < 4; ++i)
    points.push_back(test::inner_point(t, random(0, 0.5), random(0, 0.5)));
  return points;
}

// One touch, its force (overlap) and normal those of the plane. Coordinates of size 3 round at
// 4e-16, so 1e-10 of the overlap 1e-3 leaves a factor of 100.
bool is_one_plane_contact(const Plate& plate, const Vec3& foot, double radius, double overlap) {
  const Vec3 n = plate.turn * Vec3::UnitZ();
  const Vec3 center = plate.turn * (foot + (radius - overlap) * Vec3::UnitZ()) + plate.shift;
  const Touches found = touches(plate.facets, center, radius);
  if (found.size() != 1) return false;
  const WallTouch& t = found[0];
  const bool on_rim = foot.cwiseAbs().maxCoeff() > 1 - 1e-12;
  return t.nearest && !t.behind && (t.feature == 0 || on_rim) && (t.normal - n).norm() < 1e-12 &&
         std::abs(t.overlap - overlap) < 1e-10 * overlap &&
         (t.point - (plate.turn * foot + plate.shift)).norm() < 1e-12;
}

TEST(SphereFacet, TouchesAPlateOnceHoweverItIsTriangulated) {
  Random random(1);
  int positions = 0, wrong = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const Plate plate(60 + 5 * trial, trial % 2 == 1, random);
    ASSERT_EQ(plate.facets.groups, 1u);
    for (const auto& t : plate.flat) {
      for (Vec3 p : delicate_points(t, random)) {
        p = p.cwiseMax(Vec3(-1, -1, 0)).cwiseMin(Vec3(1, 1, 0));
        ++positions;
        wrong += is_one_plane_contact(plate, p, 0.1, 1e-3) ? 0 : 1;
      }
    }
  }
  EXPECT_GT(positions, 79000);
  EXPECT_EQ(wrong, 0);
}

// Deep enough that dozens of triangles are within the radius.
TEST(SphereFacet, TouchesAPlateOnceAtLargeOverlapToo) {
  Random random(2);
  int wrong = 0;
  for (int trial = 0; trial < 4; ++trial) {
    const Plate plate(60, trial % 2 == 1, random);
    for (const auto& t : plate.flat) {
      for (const Vec3& p : delicate_points(t, random)) {
        if (p.cwiseAbs().maxCoeff() > 1) continue;
        wrong += is_one_plane_contact(plate, p, 0.1, 0.04) ? 0 : 1;
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(SphereFacet, TouchesAFanOf360TrianglesOnceAtItsMiddle) {
  std::vector<Triangle> fan;
  const auto rim = [](int i) { return Vec3(std::cos(i * kPi / 180), std::sin(i * kPi / 180), 0); };
  for (int i = 0; i < 360; ++i) fan.push_back({{Vec3::Zero(), rim(i), rim((i + 1) % 360)}});
  const Facets f = facets_of(fan);
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Vec3 off = random.in_cube(std::pow(10, random(-17, -1)));
    const Touches found = touches(f, Vec3(off.x(), off.y(), 0.095), 0.1);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].overlap, 0.005, 1e-13);
  }
}

// The top edge of lifter 0 on the +y side, the direction of its top and of its face.
struct LifterEdge {
  Facets facets = facets_of(mill_shell(test::lab_mill(), 0, 0.04), 0.01);
  Vec3 top{-1, 0, 0};
  Vec3 side{-std::sin(14 * kPi / 180), std::cos(14 * kPi / 180), 0};
  Vec3 at(double z) const { return {0.14, 0.005, z}; }
};

TEST(SphereFacet, SweepsTheConeOfAConvexEdgeWithOneContact) {
  const LifterEdge lifter;
  const double radius = 0.004, distance = 0.0038;
  const double opening = std::acos(lifter.top.dot(lifter.side));
  const int steps = 2000;
  Vec3 last = lifter.top;
  for (int i = -400; i <= steps + 400; ++i) {
    // Beyond the cone the sphere goes on along the top or the face of the lifter.
    const double angle = opening * std::clamp(i, 0, steps) / steps;
    const Vec3 n = Eigen::AngleAxisd(-angle, Vec3::UnitZ()) * lifter.top;
    const Vec3 along = i < 0 ? Vec3(0, -1, 0) : Vec3(lifter.side.y(), -lifter.side.x(), 0);
    const double past = i < 0 ? -i : std::max(0, i - steps);
    const Vec3 center = lifter.at(0.017) + distance * n + 1e-6 * past * along;
    const Touches found = touches(lifter.facets, center, radius);
    ASSERT_EQ(found.size(), 1u) << i;
    EXPECT_LT((found[0].normal - n).norm(), 1e-12);
    EXPECT_NEAR(found[0].overlap, radius - distance, 1e-15);
    EXPECT_LT((found[0].normal - last).norm(), 1.01 * opening / steps);
    last = found[0].normal;
  }
}

TEST(SphereFacet, NamesFacesAndTheirConvexEdgeDifferently) {
  const LifterEdge lifter;
  const Vec3 middle = (lifter.top + lifter.side).normalized();
  const auto feature = [&](const Vec3& n, const Vec3& shift) {
    return touches(lifter.facets, lifter.at(0.02) + 0.0038 * n + shift, 0.004).at(0).feature;
  };
  const Index edge = feature(middle, Vec3::Zero());
  EXPECT_GE(edge, lifter.facets.groups);
  EXPECT_EQ(edge, feature(lifter.top * 0.3 + middle * 0.7, Vec3(0, 0, 0.011)));
  const Index top = feature(lifter.top, Vec3(0, -0.003, 0));
  EXPECT_LT(top, lifter.facets.groups);
  EXPECT_NE(top, feature(lifter.side, Vec3(0.003, 0, 0)));
}

// In the corner between a lifter's face and the first piece of the shell.
TEST(SphereFacet, TouchesAConcaveCornerTwice) {
  const auto profile = mill_profile(test::lab_mill());
  const LifterEdge lifter;
  const Vec3 base(profile[3].x(), profile[3].y(), 0), next(profile[4].x(), profile[4].y(), 0);
  const Vec3 along = (next - base).normalized(), shell(-along.y(), along.x(), 0);
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const double radius = 0.004, a = random(0.9, 0.9999) * radius, b = random(0.9, 0.9999) * radius;
    // The point at distances a from the lifter's face and b from the shell.
    Eigen::Matrix2d m;
    m << lifter.side.x(), lifter.side.y(), shell.x(), shell.y();
    const Eigen::Vector2d off = m.inverse() * Eigen::Vector2d(a, b);
    const Vec3 center = base + Vec3(off.x(), off.y(), random(0.005, 0.035));
    const Touches found = touches(lifter.facets, center, radius);
    ASSERT_EQ(found.size(), 2u);
    const bool first_is_face = found[0].normal.dot(lifter.side) > 0.99;
    const WallTouch &on_face = found[first_is_face ? 0 : 1],
                    &on_shell = found[first_is_face ? 1 : 0];
    EXPECT_LT((on_face.normal - lifter.side).norm(), 1e-12);
    EXPECT_LT((on_shell.normal - shell).norm(), 1e-12);
    EXPECT_NEAR(on_face.overlap, radius - a, 1e-15);
    EXPECT_NEAR(on_shell.overlap, radius - b, 1e-15);
    EXPECT_EQ(on_face.nearest, a < b);
    EXPECT_EQ(on_shell.nearest, b < a);
  }
}

// The plates of a concave corner are cut at random, so that the contact that is not the nearest one
// also runs over edges and vertices.
TEST(SphereFacet, LosesNoContactInATriangulatedCorner) {
  Random random(6);
  int wrong = 0;
  for (int trial = 0; trial < 4; ++trial) {
    const auto floor = test::random_plate(60, trial % 2 == 1, random);
    auto surface = test::moved(floor, Mat3::Identity(), Vec3(1, 1, 0));
    const Mat3 upright = Eigen::AngleAxisd(-kPi / 2, Vec3::UnitY()).toRotationMatrix();
    auto wall = test::moved(test::random_plate(60, true, random), upright, Vec3(0, 1, 1));
    surface.insert(surface.end(), wall.begin(), wall.end());
    const Mat3 turn = random.turn();
    const Facets f = facets_of(test::moved(surface, turn, Vec3::Zero()), 0.1);
    for (const auto& t : floor) {
      for (Vec3 p : delicate_points(t, random)) {
        p += Vec3(1, 1, 0);
        if (p.x() < 0.05 || p.y() < 0 || p.y() > 2 || p.x() > 1.9) continue;
        // The sphere presses on the wall at x = 0 more than on the floor.
        const double radius = 1.02 * p.x();
        const Touches found = touches(f, turn * (p + 0.995 * radius * Vec3::UnitZ()), radius);
        wrong += found.size() == 2 && std::abs(found[0].overlap + found[1].overlap -
                                               (0.005 * radius + radius - p.x())) < 1e-13
                     ? 0
                     : 1;
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

// Whether the touches are exactly the oracle's points.
bool agrees(const Touches& found, const std::vector<Vec3>& points, double radius) {
  if (found.size() != points.size()) return false;
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return std::any_of(found.begin(), found.end(),
                       [&](const WallTouch& t) { return (t.point - p).norm() < 1e-5 * radius; });
  });
}

// Bumpy ground: a grid of heights, each square cut along a random diagonal.
std::vector<Triangle> ground(int n, double roughness, Random& random) {
  std::vector<std::vector<Vec3>> p(std::size_t(n + 1), std::vector<Vec3>(std::size_t(n + 1)));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < p.size(); ++j) {
      p[i][j] = Vec3(double(i) + random(-0.3, 0.3), double(j) + random(-0.3, 0.3),
                     random(-roughness, roughness));
    }
  }
  std::vector<Triangle> out;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    for (std::size_t j = 0; j + 1 < p.size(); ++j) {
      const Vec3 &a = p[i][j], &b = p[i + 1][j], &c = p[i + 1][j + 1], &d = p[i][j + 1];
      const bool cut = random(0, 1) < 0.5;
      out.push_back(cut ? Triangle{{a, b, c}} : Triangle{{a, b, d}});
      out.push_back(cut ? Triangle{{a, c, d}} : Triangle{{b, c, d}});
    }
  }
  return out;
}

TEST(SphereFacet, FindsEveryLocalMinimumOnBumpyGround) {
  Random random(7);
  int wrong = 0, several = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Facets f = facets_of(ground(5, 0.05 + 0.1 * trial, random), 0.5);
    const auto surface = triangles_of(f);
    for (int i = 0; i < 300; ++i) {
      const Vec3 center(random(-0.5, 5.5), random(-0.5, 5.5), random(-2, 2));
      const double radius = random(0.2, 2.0);
      const auto points = oracle::contact_points(surface, center, radius);
      several += points.size() > 1 ? 1 : 0;
      wrong += agrees(touches(f, center, radius), points, radius) ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(several, 500);
}

TEST(SphereFacet, FindsEveryLocalMinimumInTheLabMill) {
  Random random(8);
  auto surface = mill_shell(test::lab_mill(), 0, 0.04);
  const Facets f = facets_of(surface, 0.01);
  for (int i = 0; i < 1500; ++i) {
    const double angle = random(0.0, 2 * kPi), r = random(0.125, 0.16),
                 radius = random(0.003, 0.02);
    const Vec3 center(r * std::cos(angle), r * std::sin(angle), random(-0.005, 0.045));
    EXPECT_TRUE(agrees(touches(f, center, radius), oracle::contact_points(surface, center, radius),
                       radius));
  }
}

TEST(SphereFacet, AlwaysReportsTheNearestPointOfEachWall) {
  Random random(9);
  const auto first = ground(4, 0.5, random);
  const auto second = test::moved(ground(4, 0.5, random), random.turn(), Vec3(1, 1, 0.5));
  const Facets f = build_facets({{first, 7}, {second, 3}}, 0.5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 center = Vec3(2, 2, 0) + random.in_cube(2);
    const double radius = random(0.1, 1.0);
    const Touches found = touches(f, center, radius);
    for (const auto& [wall, surface] : {std::pair{7u, &first}, std::pair{3u, &second}}) {
      double nearest = radius;
      for (const auto& t : *surface) {
        nearest = std::min(nearest, (oracle::closest_on_triangle(t, center) - center).norm());
      }
      const auto is_it = [&, w = wall](const WallTouch& t) { return t.wall == w && t.nearest; };
      const auto at = std::find_if(found.begin(), found.end(), is_it);
      EXPECT_EQ(std::count_if(found.begin(), found.end(), is_it), nearest < radius ? 1 : 0);
      if (at == found.end()) continue;
      EXPECT_NEAR(radius - at->overlap, nearest, 1e-12);
    }
  }
}

// Two pieces of a shell that meet at a concave angle phi, seen at lateral distance s from the joint
// on the side of the first. The foot on the second exists for s < d tan(phi).
struct NearlyFlatJoint {
  double phi;
  Facets facets;
  explicit NearlyFlatJoint(double angle) : phi(angle) {
    const Vec3 a(-1, 0, 0), o(0, 0, 0), b(std::cos(phi), std::sin(phi), 0), z(0, 0, 1);
    facets = facets_of({{{a - z, o + z, o - z}},
                        {{a - z, a + z, o + z}},
                        {{o - z, b + z, b - z}},
                        {{o - z, o + z, b + z}}});
  }
  Touches at(double s, double overlap, double radius) const {
    return touches(facets, Vec3(-s, radius - overlap, 0.123), radius);
  }
};

TEST(SphereFacet, LetsASecondContactFadeInOnANearlyFlatConcaveJoint) {
  const NearlyFlatJoint joint(0.08);
  const double radius = 0.05, phi = joint.phi, fade = 0.5 * radius * phi * phi;
  ASSERT_EQ(joint.facets.groups, 2u);
  // Shallower than R phi^2 / 2 the second plane is reached before its foot is lost: overlap from 0
  // on.
  const double shallow = 0.5 * fade, d = radius - shallow;
  const double onset = (radius - d * std::cos(phi)) / std::sin(phi);
  EXPECT_EQ(joint.at(onset * 1.0001, shallow, radius).size(), 1u);
  const Touches faint = joint.at(onset * 0.9999, shallow, radius);
  ASSERT_EQ(faint.size(), 2u);
  EXPECT_LT(std::min(faint[0].overlap, faint[1].overlap), 1e-3 * shallow);
  // Deeper it appears at once, by the overlap less R phi^2 / 2.
  const double deep = 4 * fade, edge = (radius - deep) * std::tan(phi);
  EXPECT_EQ(joint.at(edge * 1.0001, deep, radius).size(), 1u);
  const Touches sudden = joint.at(edge * 0.9999, deep, radius);
  ASSERT_EQ(sudden.size(), 2u);
  EXPECT_NEAR(std::min(sudden[0].overlap, sudden[1].overlap), deep - fade, 0.03 * fade);
}

TEST(SphereFacet, IsFiniteWithTheCenterExactlyOnAFaceEdgeOrVertex) {
  const LifterEdge lifter;
  const FacetRecord& r = lifter.facets.record[3];
  const Vec3 face = (r.corner[0] + r.corner[1] + r.corner[2]) / 3;
  for (const Vec3& center : {face, Vec3(0.5 * (r.corner[0] + r.corner[1])), r.corner[0],
                             r.corner[1], r.corner[2], Vec3(r.corner[2] + Vec3(1e-20, 0, 0))}) {
    const Touches found = touches(lifter.facets, center, 0.004);
    const auto nearest =
        std::find_if(found.begin(), found.end(), [](auto& t) { return t.nearest; });
    ASSERT_NE(nearest, found.end());
    EXPECT_NEAR(nearest->overlap, 0.004, 1e-16);
    EXPECT_NEAR(nearest->normal.norm(), 1, 1e-14);
    EXPECT_FALSE(nearest->behind && nearest->overlap == 0.004);
  }
}

TEST(SphereFacet, NeverNamesAFeatureTwiceAndOrdersByWallAndFeature) {
  Random random(10);
  const auto surface = ground(5, 0.6, random);
  const Facets f = build_facets({{surface, 1}, {surface, 0}}, 0.5);
  for (int i = 0; i < 1000; ++i) {
    const Touches found = touches(f, Vec3(2.5, 2.5, 0) + random.in_cube(2), random(0.2, 1.5));
    for (std::size_t k = 1; k < found.size(); ++k) {
      const auto key = [&](std::size_t j) { return std::pair(found[j].wall, found[j].feature); };
      EXPECT_LT(key(k - 1), key(k));
    }
  }
}

TEST(SphereFacet, DoesNotDependOnTheOrderOrNumberOfCandidates) {
  Random random(11);
  const Facets f = facets_of(ground(5, 0.6, random), 0.5);
  std::vector<Index> all(f.triangles());
  for (Index t = 0; t < all.size(); ++t) all[t] = f.triangles() - 1 - t;
  for (int i = 0; i < 500; ++i) {
    const Vec3 center = Vec3(2.5, 2.5, 0) + random.in_cube(2);
    const Touches found = touches(f, center, 1);
    WallTouch other[kMaxWallTouches];
    const int n = sphere_facet_touches(f, center, 1, all, other, kMaxWallTouches);
    ASSERT_EQ(static_cast<std::size_t>(n), found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].feature, other[k].feature);
      EXPECT_EQ(found[k].overlap, other[k].overlap);
      EXPECT_EQ(found[k].normal, other[k].normal);
    }
  }
}

TEST(SphereFacet, KeepsTheDeepestTouchesWhereRoomIsShort) {
  Random random(12);
  const Facets f = facets_of(ground(5, 1.0, random), 0.5);
  std::vector<Index> all(f.triangles());
  for (Index t = 0; t < all.size(); ++t) all[t] = t;
  for (int i = 0; i < 500; ++i) {
    const Vec3 center = Vec3(2.5, 2.5, 0) + random.in_cube(1);
    Touches found = touches(f, center, 1.5);
    if (found.size() < 3) continue;
    WallTouch two[2];
    ASSERT_EQ(sphere_facet_touches(f, center, 1.5, all, two, 2), 2);
    EXPECT_TRUE(two[0].nearest || two[1].nearest);
    std::sort(found.begin(), found.end(), [](auto& a, auto& b) { return a.overlap > b.overlap; });
    EXPECT_EQ(std::min(two[0].overlap, two[1].overlap), found[1].overlap);
  }
}

TEST(SphereFacet, TurnsWithTheWall) {
  Random random(13);
  const auto surface = ground(4, 0.5, random);
  const Mat3 turn = random.turn();
  const Facets f = facets_of(surface, 0.5),
               g = facets_of(test::moved(surface, turn, Vec3::Ones()), 0.5);
  for (int i = 0; i < 500; ++i) {
    const Vec3 center = Vec3(2, 2, 0) + random.in_cube(1.5);
    const Touches a = touches(f, center, 0.8), b = touches(g, turn * center + Vec3::Ones(), 0.8);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(a[k].behind, b[k].behind);
      EXPECT_LT((turn * a[k].normal - b[k].normal).norm(), 1e-10);
    }
  }
}

TEST(KeepSide, PushesASphereThatCrossedASheetBackOut) {
  const Facets sheet = facets_of(plane_patch({}, Vec3::Zero(), 1));
  const double radius = 0.1;
  Vec3 stored = Vec3::UnitZ();
  double last = radius - 0.05;
  for (int i = 0; i <= 1000; ++i) {
    const double z = 0.05 - 1e-4 * i;
    Touches found = touches(sheet, Vec3(0.2, 0.3, z), radius);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].behind, z < -1e-12 * radius);
    keep_side(found[0], stored, radius);
    stored = found[0].normal;
    EXPECT_EQ(stored, Vec3(0, 0, 1));
    EXPECT_NEAR(found[0].overlap, radius - z, 1e-15);
    EXPECT_NEAR(found[0].overlap - last, i == 0 ? 0 : 1e-4, 1e-14);
    last = found[0].overlap;
  }
}

TEST(KeepSide, HoldsBothFacesOfAThinPlateApart) {
  BoxSpec box;
  box.low = Vec3(-1, -1, -0.02);
  box.high = Vec3(1, 1, 0);
  const Facets plate = facets_of(test::turned_over(box_faces(box, Vec3::Zero())));
  const double radius = 0.1;
  const auto top_at = [&](double z) {
    const Touches found = touches(plate, Vec3(0.2, 0.3, z), radius);
    return *std::find_if(found.begin(), found.end(),
                         [](const WallTouch& t) { return std::abs(t.point.z()) < 1e-9; });
  };
  const Index top = top_at(0.09).feature;
  for (const double z : {0.09, 0.05, 0.001, -0.005, -0.015, -0.03}) {
    WallTouch t = top_at(z);
    EXPECT_EQ(t.feature, top);
    EXPECT_EQ(t.behind, z < 0);
    keep_side(t, Vec3::UnitZ(), radius);
    EXPECT_EQ(t.normal, Vec3(0, 0, 1));
    EXPECT_NEAR(t.overlap, radius - z, 1e-15);
  }
}

TEST(KeepSide, TakesTheNormalOfAFaceThatHasTurnedSince) {
  const Facets sheet = facets_of(plane_patch({}, Vec3::Zero(), 1));
  WallTouch t = touches(sheet, Vec3(0.2, 0.3, -0.01), 0.1).at(0);
  keep_side(t, Vec3(1e-3, 0, 1).normalized(), 0.1);
  EXPECT_EQ(t.normal, Vec3(0, 0, 1));
  EXPECT_NEAR(t.overlap, 0.11, 1e-15);
}

TEST(KeepSide, LeavesAContactThatTurnsAroundAnEdge) {
  const LifterEdge lifter;
  const Vec3 n = (lifter.top + lifter.side).normalized();
  WallTouch t = touches(lifter.facets, lifter.at(0.02) + 0.0038 * n, 0.004).at(0);
  const WallTouch before = t;
  keep_side(t, lifter.top, 0.004);
  EXPECT_EQ(t.normal, before.normal);
  EXPECT_EQ(t.overlap, before.overlap);
}

}  // namespace
}  // namespace quern
