// Two polyhedra: overlap, normal, point and depth against independent answers.
//
// The oracle for volume, centroid and width is Qhull: the half-spaces of both bodies become the
// points of a dual hull, whose facets are the corners of the overlap; a second hull gives its
// volume.
#include <gtest/gtest.h>

#include <cfenv>

#include "tests/support/polyhedra.h"
extern "C" {
#include "libqhull_r/qhull_ra.h"
}

namespace quern {
namespace {

constexpr double kEpsilon = 2.220446049250313e-16;

// Facets of a hull as triangles of point ids, with the plane of each.
struct HullFacet {
  std::array<int, 3> corner;
  Vec3 normal;
  double offset;
};
std::vector<HullFacet> qhull(const std::vector<Vec3>& points) {
  qhT state;
  qhT* qh = &state;
  qh_zero(qh, nullptr);
  std::vector<double> flat;
  for (const Vec3& p : points) flat.insert(flat.end(), {p.x(), p.y(), p.z()});
  char command[] = "qhull Qt";
  FILE* null = std::fopen("/dev/null", "w");
  fedisableexcept(FE_ALL_EXCEPT);
  const int failed =
      qh_new_qhull(qh, 3, static_cast<int>(points.size()), flat.data(), 0, command, null, null);
  std::vector<HullFacet> out;
  if (failed == 0) {
    facetT* facet;
    FORALLfacets {
      HullFacet f{
          {0, 0, 0}, Vec3(facet->normal[0], facet->normal[1], facet->normal[2]), facet->offset};
      vertexT *vertex, **vertexp;
      std::size_t k = 0;
      FOREACHvertex_(facet->vertices) f.corner[k++] = qh_pointid(qh, vertex->point);
      if (facet->toporient) std::swap(f.corner[0], f.corner[1]);
      out.push_back(f);
    }
  }
  qh_freeqhull(qh, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(qh, &current, &total);
  std::fclose(null);
  std::feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  return out;
}

struct Solid {
  double volume = 0, width = 0;
  Vec3 centroid = Vec3::Zero();
};
void add_half_spaces(const ShapePose& pose, const Vec3& inside, std::vector<Vec3>& poles) {
  for (std::size_t f = 0; f < pose.shape->faces; ++f) {
    const Vec3 n = pose.turn * pose.shape->normal(f);
    const double slack = pose.scale * pose.shape->d[f] + n.dot(pose.place) - n.dot(inside);
    if (slack > 0) poles.push_back(n / slack);
  }
}
// The intersection of two bodies, from a point inside both and stretched along n, which makes a
// thin overlap round for Qhull; volumes and centroids go through stretching unharmed.
Solid intersect(const ShapePose& a, const ShapePose& b, const Vec3& inside, const Vec3& n) {
  std::vector<Vec3> poles;
  add_half_spaces(a, inside, poles);
  add_half_spaces(b, inside, poles);
  EXPECT_EQ(poles.size(), a.shape->faces + b.shape->faces) << "the point is not inside";
  std::vector<Vec3> corner;
  double reach = 0;
  for (const Vec3& p : poles) reach = std::max(reach, p.norm());
  for (Vec3& p : poles) p /= reach;
  for (const HullFacet& f : qhull(poles)) {
    if (f.offset < 0) corner.push_back(f.normal / (-f.offset * reach));
  }
  Solid out;
  double low = 1e300, high = -1e300, broad = 0;
  for (const Vec3& p : corner) {
    low = std::min(low, n.dot(p));
    high = std::max(high, n.dot(p));
    broad = std::max(broad, p.norm());
  }
  out.width = high - low;
  const double stretch = std::max(1.0, broad / out.width);
  for (Vec3& p : corner) p = (p + (stretch - 1) * n.dot(p) * n) / broad;
  for (const HullFacet& f : qhull(corner)) {
    const Vec3 p = corner[std::size_t(f.corner[0])], q = corner[std::size_t(f.corner[1])],
               r = corner[std::size_t(f.corner[2])];
    const double cone = std::abs(p.dot(q.cross(r))) / 6;
    out.volume += cone;
    out.centroid += cone * (p + q + r) / 4;
  }
  out.centroid *= broad / out.volume;
  out.centroid += (1 / stretch - 1) * n.dot(out.centroid) * n + inside;
  out.volume *= broad * broad * broad / stretch;
  return out;
}

class Pairs {
 public:
  explicit Pairs(std::uint64_t seed) : random_(seed) {
    for (std::uint64_t k = 1; k <= 4; ++k) {
      shapes_.push_back(rock_of_planes(k, 12));
      shapes_.push_back(rock_of_points(k, 22));
    }
  }
  // A random pair whose chord is a power of ten between the two.
  void next(double low, double high, ShapePose& a, ShapePose& b) {
    std::uniform_real_distribution<double> power(std::log10(low), std::log10(high));
    std::uniform_real_distribution<double> ratio(0.5, 2);
    a = b = ShapePose{};
    a.shape = &shapes_[random_() % shapes_.size()];
    b.shape = &shapes_[random_() % shapes_.size()];
    a.turn = random_turn(random_);
    b.turn = random_turn(random_);
    b.scale = ratio(random_);
    bring_to_overlap(a, b, random_direction(random_), std::pow(10, power(random_)));
  }
  std::mt19937_64& random() { return random_; }
  const Shape& shape(std::size_t k) const { return shapes_[k]; }

 private:
  std::mt19937_64 random_;
  std::vector<Shape> shapes_;
};

PolyhedronTouch touch(const ShapePose& a, const ShapePose& b, PatchOptions options = {}) {
  PairAxis axis;
  PolyhedronTouch out;
  EXPECT_TRUE(touch_polyhedra(a, b, options, axis, out));
  return out;
}
double volume_of(const ShapePose& a, const ShapePose& b) {
  PolyhedronTouch out;
  PairAxis axis;
  return touch_polyhedra(a, b, {}, axis, out) ? out.volume : 0;
}
ShapePose turned(ShapePose pose, const Vec3& axis, double angle) {
  pose.turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * pose.turn;
  return pose;
}

// Corners carry a rounding of eps R and the overlap is as thin as 1e-4 R: 1e-12 of it, and Qhull's
// own merging some tens of that. 1e-9 and 1e-8 leave room for the worst of 400.
TEST(PolyhedronOverlap, IsTheIntersectionOfHalfSpaces) {
  Pairs pairs(11);
  for (int k = 0; k < 400; ++k) {
    ShapePose a, b;
    pairs.next(1e-4, 0.3, a, b);
    const PolyhedronTouch chord = touch(a, b);
    PatchOptions options;
    options.overlap = OverlapMeasure::kWidth;
    const PolyhedronTouch width = touch(a, b, options);
    const Solid solid = intersect(a, b, chord.point, chord.normal);
    EXPECT_NEAR(chord.volume, solid.volume, 1e-9 * solid.volume);
    EXPECT_NEAR(width.overlap, solid.width, 1e-9 * solid.width);
    EXPECT_LE((chord.point - solid.centroid).norm(), 1e-8 * width.overlap);
    EXPECT_LE(chord.overlap, width.overlap + 64 * kEpsilon);  // R is about 1
  }
}

// B leaves A where the ray along n leaves the hull of all differences of vertices. Slender rocks
// lean, so that the line may leave B before it leaves A. 1e-9: rounding eps R over the least
// overlap, 1e-3 R, and Qhull's merging some tens of that.
TEST(PolyhedronOverlap, ChordIsTheWayOutAlongTheNormal) {
  Pairs pairs(19);
  for (int k = 0; k < 150; ++k) {
    ShapePose a, b;
    pairs.next(1e-3, 0.5, a, b);
    const PolyhedronTouch t = touch(a, b);
    PolyhedronTouch plain;
    ASSERT_TRUE(touch_polyhedra_plain(a, b, {}, nullptr, Vec3::Zero(), plain));
    std::vector<Vec3> differences;
    for (std::size_t i = 0; i < a.shape->vertices; ++i) {
      for (std::size_t j = 0; j < b.shape->vertices; ++j) {
        differences.push_back(a.turn * a.shape->vertex(i) - b.place -
                              b.scale * (b.turn * b.shape->vertex(j)));
      }
    }
    double way = 1e300;
    for (const HullFacet& f : qhull(differences)) {
      const double slope = f.normal.dot(t.normal);
      if (slope > 1e-12) way = std::min(way, -f.offset / slope);
    }
    EXPECT_NEAR(t.overlap, way, 1e-9 * way);
    EXPECT_NEAR(plain.overlap, way, 1e-9 * way);
  }
}

// Central differences over h: truncation (h/L)^2 with the overlap's size L, rounding eps R^3 / (h
// S).
TEST(PolyhedronOverlap, HasItsGradientInVectorAreaAndMoment) {
  Pairs pairs(12);
  PatchOptions options;
  options.model = NormalModel::kVolume;
  double worst_area = 0, worst_moment = 0;
  std::vector<double> area_errors, moment_errors;
  for (int k = 0; k < 60; ++k) {
    ShapePose a, b;
    pairs.next(3e-2, 0.3, a, b);
    const PolyhedronTouch t = touch(a, b, options);
    const double h = 1e-5 * t.overlap;
    Vec3 gradient, torque;
    for (int axis = 0; axis < 3; ++axis) {
      ShapePose more = b, less = b;
      more.place[axis] += h;
      less.place[axis] -= h;
      gradient[axis] = -(volume_of(a, more) - volume_of(a, less)) / (2 * h);
      const Vec3 about = Vec3::Unit(axis);
      torque[axis] =
          -(volume_of(a, turned(b, about, h)) - volume_of(a, turned(b, about, -h))) / (2 * h);
    }
    const Vec3 moment = t.moment + (t.point - b.place).cross(t.vector_area);
    area_errors.push_back((gradient - t.vector_area).norm() / t.area);
    moment_errors.push_back((torque - moment).norm() / t.area);
    worst_area = std::max(worst_area, area_errors.back());
    worst_moment = std::max(worst_moment, moment_errors.back());
  }
  EXPECT_LE(worst_area, 1e-6);
  EXPECT_LE(worst_moment, 1e-5);
}

// S from A's faces and S from B's differ by rounding of corners only.
TEST(PolyhedronOverlap, IsClosed) {
  Pairs pairs(13);
  for (int k = 0; k < 200; ++k) {
    ShapePose a, b;
    pairs.next(1e-3, 0.3, a, b);
    PolyhedronTouch ab, ba;
    ASSERT_TRUE(touch_polyhedra_plain(a, b, {}, nullptr, Vec3::Zero(), ab));
    ASSERT_TRUE(touch_polyhedra_plain(b, a, {}, nullptr, Vec3::Zero(), ba));
    const PolyhedronTouch edges = touch(a, b);  // from A's traces alone
    EXPECT_LE((ab.vector_area - edges.vector_area).norm(), 1e-10 * ab.area);
    EXPECT_LE((ab.vector_area + ba.vector_area).norm(), 1e-10 * ab.area);
  }
}

void expect_same(const PolyhedronTouch& x, const PolyhedronTouch& y, double tolerance) {
  EXPECT_NEAR(x.volume, y.volume, tolerance * y.volume);
  EXPECT_NEAR(x.overlap, y.overlap, tolerance * y.overlap);
  EXPECT_LE((x.normal - y.normal).norm(), tolerance);
  EXPECT_LE((x.point - y.point).norm(), tolerance * std::max(1.0, y.point.norm()));
}

TEST(PolyhedronOverlap, DoesNotDependOnTheSlabThatCulls) {
  Pairs pairs(14);
  for (int k = 0; k < 100; ++k) {
    ShapePose a, b;
    pairs.next(1e-3, 0.3, a, b);
    PolyhedronTouch full, culled;
    ASSERT_TRUE(touch_polyhedra_plain(a, b, {}, nullptr, Vec3::Zero(), full));
    std::vector<Vec3> slabs = {full.normal, (b.place - a.place).normalized()};
    for (int m = 0; m < 100; ++m) slabs.push_back(random_direction(pairs.random()));
    for (const Vec3& u : slabs) {
      ASSERT_TRUE(touch_polyhedra_plain(a, b, {}, &u, Vec3::Zero(), culled));
      expect_same(culled, full, 1e-10);
      PairAxis axis{{float(u.x()), float(u.y()), float(u.z())}, 0, kAxisTouched};
      ASSERT_TRUE(touch_polyhedra(a, b, {}, axis, culled));
      expect_same(culled, full, 1e-10);
    }
  }
}

// The caller evaluates a pair once, in the order of identity, and negates: whatever order it meets
// the partners in, the bits are those of one call.
TEST(PolyhedronOverlap, GivesOppositeForcesWhenThePartnersChangePlaces) {
  Pairs pairs(15);
  for (int k = 0; k < 200; ++k) {
    ShapePose a, b;
    pairs.next(1e-3, 0.1, a, b);
    const auto force_on_second = [](int first_id, const ShapePose& first, int second_id,
                                    const ShapePose& second) {
      const bool ordered = first_id < second_id;
      const PolyhedronTouch t = ordered ? touch(first, second) : touch(second, first);
      return Vec3((ordered ? 1.0 : -1.0) * t.overlap * t.normal);
    };
    const Vec3 on_b = force_on_second(3, a, 7, b), on_a = force_on_second(7, b, 3, a);
    EXPECT_EQ(on_b, Vec3(-on_a));
    // And the definition itself is symmetric, to rounding.
    const PolyhedronTouch ab = touch(a, b), ba = touch(b, a);
    EXPECT_LE((ab.normal + ba.normal).norm(), 1e-9);
    EXPECT_NEAR(ab.overlap, ba.overlap, 1e-9 * ab.overlap);
    EXPECT_LE((ab.point - ba.point).norm(), 1e-9);
  }
}

TEST(PolyhedronOverlap, GoesWithTheBodiesWhenBothAreMoved) {
  Pairs pairs(16);
  for (int k = 0; k < 100; ++k) {
    ShapePose a, b;
    pairs.next(1e-3, 0.1, a, b);
    const PolyhedronTouch t = touch(a, b);
    const Mat3 turn = random_turn(pairs.random());
    ShapePose c = a, d = b;
    c.turn = turn * a.turn;
    d.turn = turn * b.turn;
    d.place = turn * b.place;
    PolyhedronTouch moved = touch(c, d);
    moved.normal = turn.transpose() * moved.normal;
    moved.point = turn.transpose() * moved.point;
    expect_same(moved, t, 1e-9);
    for (const double scale : {1e-3, 1e3}) {
      ShapePose e = a, f = b;
      e.scale *= scale;
      f.scale *= scale;
      f.place *= scale;
      PolyhedronTouch scaled = touch(e, f);
      scaled.overlap /= scale;
      scaled.point /= scale;
      scaled.volume /= scale * scale * scale;
      expect_same(scaled, t, 1e-9);
    }
  }
}

// Cube on cube, shifted sideways: S holds the side strips, n tilts by the overlap over the shift,
// and the width picks that tilt up in both directions; the chord does not. 1e-3 covers what is of
// second order at 1e-6 and the quantum of the place (1e-16) at 1e-14 once the overlap is taken as
// it is.
TEST(PolyhedronOverlap, OfGrazingCubesIsOneChordAndThreeWidths) {
  const Shape cube = box_shape(1, 1, 1);
  ShapePose a, b;
  a.shape = b.shape = &cube;
  for (const double wanted : {1e-6, 1e-9, 1e-12, 1e-14}) {
    b.place = Vec3(0.1, 0.2, 1 - wanted);
    const double depth = 1 - b.place.z();
    const PolyhedronTouch chord = touch(a, b);
    PatchOptions options;
    options.overlap = OverlapMeasure::kWidth;
    EXPECT_NEAR(chord.overlap / depth, 1, 1e-3) << wanted;
    EXPECT_NEAR(touch(a, b, options).overlap / depth, 3, 1e-3) << wanted;
    EXPECT_NEAR(chord.normal.z(), 1, 1e-6) << wanted;
    EXPECT_NEAR(chord.area, 0.9 * 0.8, 1e-5) << wanted;
  }
}

TEST(PolyhedronOverlap, OfAVertexGrazingAFaceIsItsDepth) {
  const Shape cube = box_shape(1, 1, 1);
  // A tip at (0, 0, -1/2): an octahedron.
  const Shape tip = make_shape(
      "octahedron",
      {{0.5, 0, 0}, {-0.5, 0, 0}, {0, 0.5, 0}, {0, -0.5, 0}, {0, 0, 0.5}, {0, 0, -0.5}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  ShapePose a, b;
  a.shape = &cube;
  b.shape = &tip;
  b.place = Vec3(0.11, 0.07, 1 - 1e-12);
  const PolyhedronTouch t = touch(a, b);
  EXPECT_NEAR(t.overlap / (1 - b.place.z()), 1, 1e-3);
  EXPECT_NEAR(t.normal.z(), 1, 1e-6);
  b.place.z() = 1 - 1e-16;
  PairAxis axis;
  PolyhedronTouch none;
  if (touch_polyhedra(a, b, {}, axis, none)) {
    EXPECT_LT(none.overlap, 1e-15);
  }
}

// Two cubes flush on four sides, shifted across by rounding errors or a little more: one volume,
// one chord. A shift takes the cubes out of flush; then S holds one side strip (area = overlap h)
// for each direction of the shift and n tilts by h in each: the width is 1, 2 or 3 times h, less
// the second order sqrt(1 + strips h^2). A place within rounding of flush is flush: no strips.
TEST(PolyhedronOverlap, OfFlushCubesDoesNotJump) {
  const Shape cube = box_shape(1, 1, 1);
  const double h = 0.01;
  ShapePose a, b;
  a.shape = b.shape = &cube;
  PatchOptions by_width;
  by_width.overlap = OverlapMeasure::kWidth;
  for (const double shift : {0.0, 1e-16, -1e-16, 1e-12, -1e-12}) {
    for (const Vec3& across : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(1, -1, 0)}) {
      SCOPED_TRACE(testing::Message() << shift << " along " << across.transpose());
      b.place = Vec3(0, 0, 1 - h) + shift * across;
      const PolyhedronTouch t = touch(a, b);
      EXPECT_NEAR(t.volume, h, 1e-12 + 2 * std::abs(shift));
      EXPECT_NEAR(t.overlap, h, 1e-4 * h);
      const double strips = std::abs(shift) < 1e-15 ? 0 : across.squaredNorm();
      const double width = (1 + strips) * h / std::sqrt(1 + strips * h * h);
      // Strips of length 1 - shift, and rounding over h.
      EXPECT_NEAR(touch(a, b, by_width).overlap, width, 4e-12 * h);
    }
  }
}

TEST(PolyhedronOverlap, OfABodyInsideAnotherKeepsTheLastNormal) {
  const Shape small = box_shape(0.2, 0.2, 0.2), cube = box_shape(1, 1, 1);
  for (const bool inner_first : {true, false}) {
    ShapePose a, b;
    a.shape = inner_first ? &small : &cube;
    b.shape = inner_first ? &cube : &small;
    b.place = Vec3(0.05, 0.1, 0.2);
    PairAxis axis{{0, 0, 1}, 0, kAxisTouched};
    PolyhedronTouch t;
    ASSERT_TRUE(touch_polyhedra(a, b, {}, axis, t));
    EXPECT_NEAR(t.volume, 0.008, 1e-15);
    EXPECT_LT(t.area, 1e-15);
    EXPECT_EQ(t.flags & kTouchContained, kTouchContained);
    EXPECT_EQ(t.normal, Vec3(0, 0, 1));
    EXPECT_NEAR(t.overlap, 0.4, 1e-12) << "the way out along the normal";
    PairAxis unknown;
    ASSERT_TRUE(touch_polyhedra(a, b, {}, unknown, t));
    EXPECT_LT((t.normal - b.place.normalized()).norm(), 1e-15) << "between the centres";
  }
}

TEST(PolyhedronOverlap, OfABodyWithItselfIsFinite) {
  const Shape cube = box_shape(1, 1, 1), rock = rock_of_planes(3, 12);
  for (const Shape* shape : {&cube, &rock}) {
    ShapePose a;
    a.shape = shape;
    PairAxis axis;
    PolyhedronTouch t;
    ASSERT_TRUE(touch_polyhedra(a, a, {}, axis, t));
    EXPECT_EQ(t.flags & kTouchContained, kTouchContained);
    EXPECT_TRUE(std::isfinite(t.overlap) && t.overlap > 0);
    EXPECT_NEAR(t.normal.norm(), 1, 1e-15);
    EXPECT_TRUE(t.point.norm() < 1e-3);
  }
}

// The gap is a lower bound of the distance: the pair may be skipped until it is used up.
TEST(PairAxis, GapIsALowerBoundAndTheAxisParts) {
  Pairs pairs(17);
  for (int k = 0; k < 300; ++k) {
    ShapePose a, b;
    pairs.next(1e-4, 1e-3, a, b);
    const Vec3 away = b.place.normalized();
    b.place += 0.05 * away;
    PairAxis axis;
    PolyhedronTouch t;
    ASSERT_FALSE(touch_polyhedra(a, b, {}, axis, t));
    EXPECT_EQ(t.flags & kTouchSearched, kTouchSearched);
    ASSERT_GT(axis.gap, 0);
    EXPECT_LE(axis.gap, 0.05 + 1e-3);
    ASSERT_FALSE(touch_polyhedra(a, b, {}, axis, t));
    EXPECT_EQ(t.flags, 0u) << "the kept axis answers alone";
    ShapePose nearer = b;
    nearer.place -= 0.999 * double(axis.gap) * random_direction(pairs.random());
    PairAxis fresh;
    EXPECT_FALSE(touch_polyhedra(a, nearer, {}, fresh, t));
  }
}

// Planes cut off a slice of a rock: the same slice that a large box behind the plane shares with
// it.
TEST(PlaneOverlap, IsThatOfABoxBehindThePlane) {
  const Shape rock = rock_of_planes(5, 12), box = box_shape(20, 20, 20);
  std::mt19937_64 random(18);
  for (int k = 0; k < 100; ++k) {
    ShapePose a, b;
    a.shape = &rock;
    b.shape = &box;
    b.turn = random_turn(random);
    const Vec3 n = b.turn.col(2);
    bring_to_overlap(a, b, n, 0.05);
    const Plane plane{-n, -n.dot(b.place) + 10};
    PlaneOverlap slice;
    PatchOptions options;
    options.model = NormalModel::kVolume;
    ASSERT_TRUE(intersect_with_planes(rock, {&plane, 1}, options, slice));
    const PolyhedronTouch t = touch(a, b, options);
    EXPECT_NEAR(slice.volume, t.volume, 1e-10 * t.volume);
    EXPECT_NEAR(slice.overlap, t.overlap, 1e-10 * t.overlap);
    EXPECT_LE((slice.normal - n).norm(), 64 * kEpsilon);
    EXPECT_LE((slice.centroid - t.point).norm(), 1e-10);
    EXPECT_LE((slice.moment - t.point.cross(t.vector_area) - t.moment).norm(), 1e-10);
  }
}

}  // namespace
}  // namespace quern
