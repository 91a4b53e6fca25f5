// Nasty pairs of polyhedra: needles, plates, slivers, spare vertices, aligned and lattice places.
//
// What must hold for any pair: finite answers, no negative volume, the fast way and the plain way
// and the swapped pair agree on whether there is a contact of any volume, at any scale and offset,
// and on every SIMD target.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "tests/support/contact_cases.h"
#include "tests/support/polyhedra.h"
#include "tests/support/wall_oracle.h"

namespace quern {
namespace {

// Latitude and longitude: rings - 1 rings of `around` vertices and two poles.
Shape ball_shape(int around, int rings) {
  std::vector<Vec3> v = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  for (int i = 1; i < rings; ++i) {
    for (int k = 0; k < around; ++k) {
      const double polar = kPi * i / rings, turn = 2 * kPi * k / around;
      v.emplace_back(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                     std::cos(polar));
    }
  }
  const auto at = [&](int i, int k) { return Index(2 + (i - 1) * around + k % around); };
  std::vector<std::vector<Index>> faces;
  for (int k = 0; k < around; ++k) {
    faces.push_back({0, at(1, k), at(1, k + 1)});
    faces.push_back({1, at(rings - 1, k + 1), at(rings - 1, k)});
    for (int i = 1; i + 1 < rings; ++i) {  // two coplanar triangles, not merged
      faces.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      faces.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return make_shape("ball", v, faces);
}

// A cube with a corner twice, a vertex on an edge, and a top of two coplanar faces.
Shape spoilt_cube() {
  std::vector<Vec3> v;
  for (int k = 0; k < 8; ++k) v.emplace_back(k & 1 ? .5 : -.5, k & 2 ? .5 : -.5, k & 4 ? .5 : -.5);
  v.push_back(v[0]);                // 8: a duplicate of 0
  v.emplace_back(0.1, -0.5, -0.5);  // 9: on the edge 0-1
  return make_shape("spoilt", v,
                    {{8, 2, 3, 1, 9},
                     {4, 5, 7},
                     {4, 7, 6},
                     {0, 8, 9, 1, 5, 4},
                     {2, 6, 7, 3},
                     {0, 4, 6, 2, 8},
                     {1, 3, 7, 5}});
}

const std::vector<Shape>& nasty_shapes() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> out;
    out.push_back(rock_of_planes(1, 12));
    out.push_back(rock_of_points(1, 22));
    out.push_back(box_shape(1, 1, 1));
    out.push_back(box_shape(1, 1, 1e-3));
    out.push_back(box_shape(1, 1e-3, 1e-3));
    out.push_back(box_shape(1, 1e-6, 1e-6));
    out.push_back(box_shape(10, 10, 0.1));
    out.push_back(ball_shape(20, 10));
    out.push_back(make_shape("sliver",
                             {{-.5, -.5, 0}, {.5, .5, 0}, {-.5, .5, 1e-4}, {.5, -.5, 1e-4}},
                             {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}));
    out.push_back(spoilt_cube());
    return out;
  }();
  return shapes;
}

Mat3 aligned_turn(std::mt19937_64& random) {
  const Vec3 axes[3] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const std::size_t first = random() % 3, second = (first + 1 + random() % 2) % 3;
  Mat3 turn;
  turn.col(0) = (random() % 2 ? 1 : -1) * axes[first];
  turn.col(1) = (random() % 2 ? 1 : -1) * axes[second];
  turn.col(2) = turn.col(0).cross(turn.col(1));
  return turn;
}

void random_pair(std::mt19937_64& random, ShapePose& a, ShapePose& b) {
  const std::vector<Shape>& shapes = nasty_shapes();
  std::uniform_real_distribution<double> unit(-1, 1);
  a = b = ShapePose{};
  a.shape = &shapes[random() % shapes.size()];
  b.shape = &shapes[random() % shapes.size()];
  const int kind = static_cast<int>(random() % 3);
  a.turn = kind == 0 ? random_turn(random) : aligned_turn(random);
  b.turn = kind == 0 ? random_turn(random) : kind == 1 ? a.turn : aligned_turn(random);
  const double reach = 0.6 * std::min(a.shape->bound_radius + b.shape->bound_radius, 3.0);
  for (int k = 0; k < 3; ++k) {
    b.place[k] = kind == 0 ? reach * unit(random) : 0.25 * double(random() % 9) - 1;
  }
  if (kind != 0) b.place += std::pow(10, -3 - double(random() % 15)) * random_direction(random);
}

struct FuzzCount {
  int hits = 0, thin = 0, polygons = 0, contained = 0, moments = 0;
};

// From the highest point of A along n down to the lowest of B: no way out along n is longer.
double slab_width(const ShapePose& a, const ShapePose& b, const Vec3& n) {
  double high = -1e300, low = 1e300;
  for (std::size_t v = 0; v < a.shape->vertices; ++v) {
    high = std::max(high, n.dot(a.place + a.scale * (a.turn * a.shape->vertex(v))));
  }
  for (std::size_t v = 0; v < b.shape->vertices; ++v) {
    low = std::min(low, n.dot(b.place + b.scale * (b.turn * b.shape->vertex(v))));
  }
  return high - low;
}

// The integral of x cross n over A's surface in B, about the place of A; finite with its point.
Vec3 moment_about_place(const PolyhedronTouch& t) {
  return t.moment + t.point.cross(t.vector_area);
}

// One pair; `scale`: lengths of the pair.
void check_pair(const ShapePose& a, const ShapePose& b, const PatchOptions& options, double scale,
                FuzzCount& count) {
  const double cube = scale * scale * scale;
  PairAxis axis, swapped_axis;
  PolyhedronTouch fast, plain, swapped;
  const Vec3 last = Vec3::Zero();
  const bool hit = touch_polyhedra(a, b, options, axis, fast);
  const bool plain_hit = touch_polyhedra_plain(a, b, options, nullptr, last, plain);
  const bool swapped_hit = touch_polyhedra(b, a, options, swapped_axis, swapped);
  const double volume = std::max(
      {hit ? fast.volume : 0, plain_hit ? plain.volume : 0, swapped_hit ? swapped.volume : 0});
  if (volume > 1e-12 * cube) {
    EXPECT_TRUE(hit && plain_hit && swapped_hit)
        << a.shape->name << " " << b.shape->name << " " << hit << plain_hit << swapped_hit << " "
        << volume;
  }
  for (const auto& [touching, t] :
       {std::pair{hit, &fast}, {plain_hit, &plain}, {swapped_hit, &swapped}}) {
    if (!touching) continue;
    EXPECT_TRUE(std::isfinite(t->overlap) && t->point.allFinite() && t->normal.allFinite());
    EXPECT_GT(t->volume, -1e-12 * cube);
    EXPECT_GE(t->overlap, 0);
    const double most = t == &swapped ? slab_width(b, a, t->normal) : slab_width(a, b, t->normal);
    // A line meets the flattest faces of needles at 1e-6 rad: corners off by eps R count eps R /
    // 1e-6.
    EXPECT_LE(t->overlap, most + 1e-9 * scale) << a.shape->name << " " << b.shape->name;
    EXPECT_NEAR(t->normal.norm(), 1, 1e-14);
    EXPECT_TRUE(t->vector_area.allFinite());
    EXPECT_TRUE(options.model == NormalModel::kStiffness || t->moment.allFinite());
  }
  EXPECT_TRUE(std::isfinite(axis.gap) && axis.gap >= 0);
  count.hits += hit;
  count.thin += (fast.flags & kTouchThin) != 0;
  count.polygons += (fast.flags & kTouchPolygons) != 0;
  count.contained += hit && (fast.flags & kTouchContained) != 0;
  if (hit && plain_hit && volume > 1e-9 * cube && fast.area > 1e-6 * scale * scale &&
      !((fast.flags | plain.flags) & (kTouchContained | kTouchCoincident))) {
    // Corners are off by eps R; a volume V of surface |S| then by eps R times its surface, which
    // for the largest plate is 200 R^2.
    EXPECT_NEAR(fast.volume, plain.volume, 1e-12 * cube)
        << a.shape->name << " " << b.shape->name << " " << fast.flags << " " << plain.flags;
    if (options.model == NormalModel::kVolume) {
      // Arms of up to 7 R besides, for the largest plate.
      const double off = (moment_about_place(fast) - moment_about_place(plain)).norm();
      EXPECT_LE(off, 2e-12 * cube);
      ++count.moments;
    }
  }
}

void fuzz(int pairs, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  FuzzCount count;
  for (int k = 0; k < pairs; ++k) {
    ShapePose a, b;
    random_pair(random, a, b);
    double scale = 1;
    if (k % 4 == 1) scale = 1e-3;
    if (k % 4 == 2) scale = 1e3;
    a.scale *= scale;
    b.scale *= scale;
    b.place *= scale;
    if (k % 4 == 3) {  // far away: the relative place is formed first, as the engine does
      const Vec3 origin = 1e3 * random_direction(random);
      b.place = (origin + b.place) - origin;
    }
    // All four with each scale.
    const PatchOptions options = {k / 4 % 2 ? OverlapMeasure::kWidth : OverlapMeasure::kChord,
                                  k / 8 % 2 ? NormalModel::kVolume : NormalModel::kStiffness};
    check_pair(a, b, options, scale, count);
    if (testing::Test::HasFailure()) FAIL() << "pair " << k;
  }
  EXPECT_GT(count.hits, pairs / 4);
  EXPECT_GT(count.contained, 0);
  EXPECT_GT(count.moments, pairs / 20);
  std::printf("%d pairs: %d hits, %d thin, %d by polygons, %d contained, %d with moments\n", pairs,
              count.hits, count.thin, count.polygons, count.contained, count.moments);
}

TEST(PolyhedronFuzz, TwentyThousandNastyPairsAgree) { fuzz(20000, 101); }
TEST(SlowPolyhedronFuzz, TwoHundredThousandNastyPairsAgree) { fuzz(200000, 202); }

// Of all sizes of sets: from one vector of faces to several words of vertices.
std::vector<Shape> rocks_of_all_sizes() {
  std::vector<Shape> shapes;
  for (std::uint64_t k = 1; k <= 3; ++k) {
    shapes.push_back(rock_of_planes(k, 12));
    shapes.push_back(rock_of_points(k, 22));
  }
  for (const int faces : {4, 5, 7, 9, 16, 17, 25, 30}) shapes.push_back(rock_of_planes(9, faces));
  // Sets of several words.
  for (const int points : {63, 65, 182}) shapes.push_back(rock_of_points(9, points));
  return shapes;
}

// The twin is the plain way: no lanes, no traces, all faces. The overlap is 1e-3 R or more, so that
// eps R of the corners is 1e-13 of it, and some tens of roundings more.
TEST(PolyhedronTargets, AgreeWithTheScalarTwin) {
  const std::vector<Shape> shapes = rocks_of_all_sizes();
  std::mt19937_64 random(7);
  std::vector<std::pair<ShapePose, ShapePose>> pairs;
  for (int k = 0; k < 300; ++k) {
    ShapePose a, b;
    a.shape = &shapes[random() % shapes.size()];
    b.shape = &shapes[random() % shapes.size()];
    a.turn = random_turn(random);
    b.turn = random_turn(random);
    b.scale = 0.8;
    bring_to_overlap(a, b, random_direction(random), k % 2 ? 1e-3 : 0.2);
    pairs.emplace_back(a, b);
  }
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    int by_edges = 0;
    for (const auto& [a, b] : pairs) {
      for (const OverlapMeasure measure : {OverlapMeasure::kChord, OverlapMeasure::kWidth}) {
        const PatchOptions options{measure, NormalModel::kVolume};
        PairAxis axis;
        PolyhedronTouch fast, plain;
        ASSERT_TRUE(touch_polyhedra(a, b, options, axis, fast)) << hwy::TargetName(target);
        ASSERT_TRUE(touch_polyhedra_plain(a, b, options, nullptr, Vec3::Zero(), plain));
        by_edges += (fast.flags & kTouchPolygons) == 0;
        EXPECT_NEAR(fast.volume, plain.volume, 1e-10 * plain.volume) << hwy::TargetName(target);
        EXPECT_NEAR(fast.overlap, plain.overlap, 1e-10 * plain.overlap);
        EXPECT_LE((fast.normal - plain.normal).norm(), 1e-10);
        EXPECT_LE((fast.point - plain.point).norm(), 1e-10);
        EXPECT_LE((fast.moment - plain.moment).norm(), 1e-10 * plain.area);
      }
    }
    // Deep pairs of 40 faces keep more planes than the fast way takes.
    EXPECT_GT(by_edges, 400) << "the fast way was hardly asked";
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

std::vector<Triangle> surface_of(const ShapePose& pose) {
  const Shape& shape = *pose.shape;
  const auto corner = [&](std::size_t k) {
    return Vec3(pose.place + pose.scale * (pose.turn * shape.vertex(shape.face_vertex[k])));
  };
  std::vector<Triangle> out;
  for (std::size_t f = 0; f < shape.faces; ++f) {
    const std::size_t first = shape.face_begin[f];
    for (std::size_t k = first + 1; k + 1 < shape.face_begin[f + 1]; ++k) {
      out.push_back({{corner(first), corner(k), corner(k + 1)}});
    }
  }
  return out;
}

// Between the inner points of two segments that come nearest; where an end does, far.
double distance_across(const Vec3& from, const Vec3& along, const Vec3& other_from,
                       const Vec3& other_along) {
  const Vec3 between = from - other_from;
  const double a = along.squaredNorm(), b = along.dot(other_along), c = other_along.squaredNorm();
  const double d = along.dot(between), e = other_along.dot(between), size = a * c - b * b;
  const double s = b * e - c * d, t = a * e - b * d;
  if (size <= 1e-20 * a * c || s <= 0 || t <= 0 || s >= size || t >= size) return HUGE_VAL;
  return (between + s / size * along - t / size * other_along).norm();
}

// Of two bodies that are apart, by all corners with all triangles and all sides with all sides.
double distance_between(const ShapePose& a, const ShapePose& b) {
  const std::vector<Triangle> of_a = surface_of(a), of_b = surface_of(b);
  const auto size = [](const Triangle& t) {
    return std::max((t.corner[1] - t.corner[0]).norm(), (t.corner[2] - t.corner[0]).norm());
  };
  double least = HUGE_VAL;
  for (const Triangle& p : of_a) {
    for (const Triangle& q : of_b) {
      if ((p.corner[0] - q.corner[0]).norm() > least + size(p) + size(q)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        least = std::min({least, (oracle::closest_on_triangle(q, p.corner[i]) - p.corner[i]).norm(),
                          (oracle::closest_on_triangle(p, q.corner[i]) - q.corner[i]).norm()});
        for (std::size_t j = 0; j < 3; ++j) {
          const Vec3 &from = p.corner[i], &other = q.corner[j];
          least = std::min(least, distance_across(from, p.corner[(i + 1) % 3] - from, other,
                                                  q.corner[(j + 1) % 3] - other));
        }
      }
    }
  }
  return least;
}

// A pair at a given distance or overlap along a line, the same moved by less than half of that, and
// what is true of both.
struct NearPair {
  ShapePose a, b, moved;
  bool touching = false;
  double distance = 0, distance_moved = 0;
};
NearPair near_pair(const std::vector<Shape>& shapes, bool touching, std::mt19937_64& random) {
  std::uniform_real_distribution<double> power(-9, -0.5);
  NearPair p;
  p.touching = touching;
  p.a.shape = &shapes[random() % shapes.size()];
  p.b.shape = &shapes[random() % shapes.size()];
  p.a.turn = random_turn(random);
  p.b.turn = random_turn(random);
  p.b.scale = 0.8;
  const Vec3 direction = random_direction(random);
  bring_to_overlap(p.a, p.b, direction, 1e-13);
  p.b.place += (touching ? -1 : 1) * std::pow(10, power(random)) * direction;
  p.moved = p.b;
  PolyhedronTouch plain;
  EXPECT_EQ(touch_polyhedra_plain(p.a, p.b, {}, nullptr, Vec3::Zero(), plain), touching);
  if (touching) return p;
  p.distance = distance_between(p.a, p.b);
  p.moved.place += 0.2 * p.distance * random_direction(random);
  p.moved.turn = Eigen::AngleAxisd(0.1 * p.distance, random_direction(random)) * p.b.turn;
  EXPECT_FALSE(touch_polyhedra_plain(p.a, p.moved, {}, nullptr, Vec3::Zero(), plain));
  p.distance_moved = distance_between(p.a, p.moved);
  return p;
}

// Gaps are differences of heights of size R = 2, each with a few roundings. An axis is kept in f32:
// it leans by 2^-25 in each direction, with supports up to 2 R aside of each other, so that what it
// parts by less than kLean may be asked again.
constexpr double kGapRounding = 4e-15, kLean = 4e-7;

// The answer; `axis` is what was known, and what is then. Returns the flags of the touch.
std::uint32_t expect_answer(const NearPair& p, const ShapePose& b, double distance,
                            PairAxis& axis) {
  PolyhedronTouch t;
  EXPECT_EQ(touch_polyhedra(p.a, b, {}, axis, t), p.touching);
  EXPECT_EQ(axis.flags, p.touching ? kAxisTouched : 0);
  EXPECT_GE(axis.gap, 0);
  EXPECT_LE(axis.gap, distance + kGapRounding);
  return t.flags;
}

void expect_same_answers(const NearPair& p, const Vec3& any) {
  PairAxis first, across, touched;  // nothing known; an axis that parts nothing; after a touch
  const Vec3 u = (p.b.place - p.a.place).cross(any).normalized();
  for (int k = 0; k < 3; ++k) across.axis[k] = touched.axis[k] = static_cast<float>(u[k]);
  touched.flags = kAxisTouched;
  EXPECT_EQ(expect_answer(p, p.b, p.distance, first) & kTouchSearched, kTouchSearched);
  EXPECT_EQ(expect_answer(p, p.b, p.distance, across) & kTouchSearched, kTouchSearched);
  EXPECT_EQ(expect_answer(p, p.b, p.distance, touched) & kTouchSearched, 0u);
  EXPECT_EQ(touched.gap, 0) << "the clip says that it is over, not how far";
  PairAxis kept = first, after = first;
  const std::uint32_t kept_flags = expect_answer(p, p.b, p.distance, kept);
  const std::uint32_t after_flags = expect_answer(p, p.moved, p.distance_moved, after);
  if (p.distance < kLean) return;
  // GJK ends at nine tenths of the distance; the axis then answers alone, for what it still parts.
  for (const PairAxis& found : {first, across}) EXPECT_GE(found.gap, 0.9 * p.distance - kLean);
  EXPECT_EQ(kept_flags, 0u);
  EXPECT_NEAR(kept.gap, first.gap, kLean / 2 + 2.4e-7 * p.distance);
  EXPECT_EQ(after_flags, 0u);
  EXPECT_GE(after.gap, 0.5 * p.distance - kLean);
}

TEST(PolyhedronTargets, PartPairsAsThePlainWayDoesAndKnowNoGapBeyondTheDistance) {
  const std::vector<Shape> shapes = rocks_of_all_sizes();
  std::mt19937_64 random(8);
  std::vector<NearPair> pairs;
  std::vector<Vec3> any;
  for (int k = 0; k < 240; ++k) {
    pairs.push_back(near_pair(shapes, k % 3 == 0, random));
    any.push_back(random_direction(random));
  }
  test::for_each_target<double>([&](const std::string& target) {
    SCOPED_TRACE(target);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      SCOPED_TRACE(testing::Message() << "pair " << k << ", distance " << pairs[k].distance);
      expect_same_answers(pairs[k], any[k]);
      if (testing::Test::HasFailure()) return;
    }
  });
}

}  // namespace
}  // namespace quern
