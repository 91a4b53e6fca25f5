// How deep an overlap is along its normal: the chord, or the width; see polyhedron_polyhedron.h.
//
// Included once per Highway target. The exit from A is a concave function over the plane across n,
// the entry into B a convex one, both linear in pieces: the greatest difference lies over a vertex
// or over a crossing of edges, and everything tried is a lower bound. All kept planes count, those
// across n too: a line beside the body must not be taken for one through it. Most chords are shown
// to be the longest without trying, by two parallel planes that part the bodies once moved by it.
#if defined(QUERN_KERNELS_PAIRS_POLYHEDRON_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_KERNELS_PAIRS_POLYHEDRON_DEPTH_INL_H_
#undef QUERN_KERNELS_PAIRS_POLYHEDRON_DEPTH_INL_H_
#else
#define QUERN_KERNELS_PAIRS_POLYHEDRON_DEPTH_INL_H_
#endif

#include <cmath>

#include "kernels/pairs/polyhedron_edges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

constexpr double kFar = 1e30;    // longer than any line
constexpr double kSteep = 0.5;   // cosine against the normal of planes that may show a chord
constexpr double kNever = 1e60;  // moves a way along a line out of everything's reach

// The planes of a part against the normal: a line from height h above plane k meets it h inverse[k]
// further on. One of the two offsets is zero and tells whether the line leaves there or enters.
struct Slopes {
  HWY_ALIGN double inverse[kKeptPlanes + 9], leaves[kKeptPlanes + 9], enters[kKeptPlanes + 9];
  std::uint64_t rising = 0, falling = 0, across = 0;  // planes that look along n, against, neither
};

HWY_INLINE void slopes_along(const SlabPart& part, const Vec3& normal, Slopes& out) {
  const D64 d;
  const VD zero = hn::Zero(d), one = hn::Set(d, 1.0), least = hn::Set(d, 1 / kFar);
  const VD never = hn::Set(d, kNever);
  const Vec3V<VD> n = broadcast(normal);
  for (std::size_t k = 0; k < part.planes; k += hn::Lanes(d)) {
    const VD slope = dot(n, load3(part.nx, part.ny, part.nz, k));
    const auto up = hn::Gt(slope, least), down = hn::Lt(slope, hn::Neg(least));
    const auto either = hn::Or(up, down);
    const VD inverse = hn::Div(hn::Neg(one), hn::IfThenElse(either, slope, one));
    hn::StoreU(hn::IfThenElseZero(either, inverse), d, out.inverse + k);
    hn::StoreU(hn::IfThenZeroElse(up, never), d, out.leaves + k);
    hn::StoreU(hn::IfThenZeroElse(down, hn::Neg(never)), d, out.enters + k);
    out.rising |= bits_of(d, hn::Gt(slope, zero)) << k;
    out.falling |= bits_of(d, hn::Lt(slope, zero)) << k;
    out.across |= bits_of(d, hn::Not(either)) << k;
  }
  const std::uint64_t kept = (1ull << part.planes) - 1;
  out.rising &= kept;
  out.falling &= kept;
  out.across &= kept;
}

// Heights within rounding are zero: a point on a face across n must not be taken for outside.
HWY_INLINE VD height_over(const SlabPart& part, std::size_t f, const Vec3V<VD>& p, VD near) {
  const D64 d;
  const Vec3V<VD> n = {hn::Set(d, part.nx[f]), hn::Set(d, part.ny[f]), hn::Set(d, part.nz[f])};
  const VD height = hn::Sub(dot(n, p), hn::Set(d, part.d[f]));
  return hn::IfThenElse(hn::Gt(height, near), height, hn::Min(height, hn::Zero(d)));
}

// Where the lines through p enter and leave a part.
HWY_INLINE void meet_part(const SlabPart& part, const Slopes& slopes, const Vec3V<VD>& p, VD near,
                          VD& entry, VD& exit) {
  const D64 d;
  entry = hn::Set(d, -kFar);
  exit = hn::Set(d, kFar);
  for (std::size_t f = 0; f < part.planes; ++f) {
    const VD height = height_over(part, f, p, near), inverse = hn::Set(d, slopes.inverse[f]);
    exit = hn::Min(exit, hn::MulAdd(height, inverse, hn::Set(d, slopes.leaves[f])));
    entry = hn::Max(entry, hn::MulAdd(height, inverse, hn::Set(d, slopes.enters[f])));
  }
  for (std::uint64_t bits = slopes.across; bits != 0; bits &= bits - 1) {
    const std::size_t f = static_cast<std::size_t>(__builtin_ctzll(bits));
    const auto outside = hn::Gt(height_over(part, f, p, near), hn::Zero(d));
    exit = hn::IfThenElse(outside, hn::Set(d, -2 * kFar), exit);
  }
}

// Vertices of both bodies in the slab, filled up with the first.
struct Points {
  HWY_ALIGN double x[2 * kKeptPoints + 16], y[2 * kKeptPoints + 16], z[2 * kKeptPoints + 16];
  std::size_t count = 0;

  HWY_INLINE void add(const SlabPart& part) {
    const D64 d;
    for (std::size_t k = 0; k < part.points; k += hn::Lanes(d)) {
      hn::StoreU(hn::LoadU(d, part.x + k), d, x + count + k);
      hn::StoreU(hn::LoadU(d, part.y + k), d, y + count + k);
      hn::StoreU(hn::LoadU(d, part.z + k), d, z + count + k);
    }
    count += part.points;
  }
  HWY_INLINE void fill() {
    const D64 d;
    hn::StoreU(hn::Set(d, x[0]), d, x + count);
    hn::StoreU(hn::Set(d, y[0]), d, y + count);
    hn::StoreU(hn::Set(d, z[0]), d, z + count);
  }
};

// Exit from A less entry into B on the lines along the normal through the vertices; see
// chord_on_line() of the plain way.
HWY_INLINE VD chord_over_points(const SlabPart& a, const SlabPart& b, const Slopes& of_a,
                                const Slopes& of_b, double within) {
  const D64 d;
  Points points;
  points.add(a);
  points.add(b);
  points.fill();
  const VD far = hn::Set(d, kFar), near = hn::Set(d, within);
  VD best = hn::Zero(d);
  for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
    const Vec3V<VD> p = load3(points.x, points.y, points.z, k);
    VD entry[2], exit[2];
    meet_part(a, of_a, p, near, entry[0], exit[0]);
    meet_part(b, of_b, p, near, entry[1], exit[1]);
    const auto hits = hn::And(hn::Le(entry[0], exit[0]), hn::Le(entry[1], exit[1]));
    const auto ends = hn::And(hn::Lt(exit[0], far), hn::Gt(entry[1], hn::Neg(far)));
    best = hn::Max(best, hn::IfThenElseZero(hn::And(hits, ends), hn::Sub(exit[0], entry[1])));
  }
  return best;
}

// Edges seen along n: where they begin, and the way to their end.
struct Shadows {
  HWY_ALIGN double x[kKeptEdges + 9], y[kKeptEdges + 9], height[kKeptEdges + 9];
  HWY_ALIGN double to_x[kKeptEdges + 9], to_y[kKeptEdges + 9], rise[kKeptEdges + 9];
};
HWY_INLINE void cast_shadows(const SlabPart& part, const Vec3V<VD> (&frame)[3], Shadows& out) {
  const D64 d;
  for (std::size_t k = 0; k < part.edges; k += hn::Lanes(d)) {
    const Vec3V<VD> from = load3(part.ax, part.ay, part.az, k);
    const Vec3V<VD> along = load3(part.bx, part.by, part.bz, k) - from;
    hn::StoreU(dot(frame[0], from), d, out.x + k);
    hn::StoreU(dot(frame[1], from), d, out.y + k);
    hn::StoreU(dot(frame[2], from), d, out.height + k);
    hn::StoreU(dot(frame[0], along), d, out.to_x + k);
    hn::StoreU(dot(frame[1], along), d, out.to_y + k);
    hn::StoreU(dot(frame[2], along), d, out.rise + k);
  }
}

// Edges with a face among `planes`.
HWY_INLINE std::uint64_t edges_around(const SlabPart& part, std::uint64_t planes) {
  std::uint64_t edges = 0;
  for (std::uint64_t k = (1ull << part.edges) - 1; k != 0; k &= k - 1) {
    const int e = __builtin_ctzll(k);
    edges |= ((planes >> part.left[e] | planes >> part.right[e]) & 1) << e;
  }
  return edges;
}

// Where an edge of A that bounds a face looking along n passes over one of B that bounds a face
// looking against it; lanes over B's edges. Of the differences of heights, num / den, the greatest
// is sought on products.
HWY_INLINE VD chord_over_crossings(const SlabPart& a, const SlabPart& b, const Slopes& of_a,
                                   const Slopes& of_b, const Vec3& normal) {
  const D64 d;
  const Vec3 across = normal.unitOrthogonal();
  const Vec3V<VD> frame[3] = {broadcast(across), broadcast(normal.cross(across)),
                              broadcast(normal)};
  Shadows up, down;
  cast_shadows(a, frame, up);
  cast_shadows(b, frame, down);
  const std::uint64_t ups = edges_around(a, of_a.rising), downs = edges_around(b, of_b.falling);
  const VD zero = hn::Zero(d), one = hn::Set(d, 1.0);
  VD num = zero, den = one;
  for (std::size_t k = 0; k < b.edges; k += hn::Lanes(d)) {
    const VD x = hn::LoadU(d, down.x + k), y = hn::LoadU(d, down.y + k),
             height = hn::LoadU(d, down.height + k), to_x = hn::LoadU(d, down.to_x + k),
             to_y = hn::LoadU(d, down.to_y + k), rise = hn::LoadU(d, down.rise + k);
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(downs >> k), 0, 0, 0, 0, 0, 0, 0};
    const auto looks = hn::LoadMaskBits(d, bytes);
    for (std::uint64_t bits = ups; bits != 0; bits &= bits - 1) {
      const std::size_t i = static_cast<std::size_t>(__builtin_ctzll(bits));
      const VD along_x = hn::Set(d, up.to_x[i]), along_y = hn::Set(d, up.to_y[i]);
      const VD apart_x = hn::Sub(x, hn::Set(d, up.x[i])), apart_y = hn::Sub(y, hn::Set(d, up.y[i]));
      const VD turn = hn::MulSub(along_x, to_y, hn::Mul(along_y, to_x));
      const VD size = hn::Abs(turn), sign = hn::CopySignToAbs(one, turn);
      const VD t = hn::Mul(sign, hn::MulSub(apart_x, to_y, hn::Mul(apart_y, to_x)));
      const VD s = hn::Mul(sign, hn::MulSub(apart_x, along_y, hn::Mul(apart_y, along_x)));
      auto crosses = hn::And(hn::Ge(hn::Min(t, s), zero), hn::Le(hn::Max(t, s), size));
      crosses = hn::And(hn::And(crosses, looks), hn::Gt(size, zero));
      const VD lead = hn::MulSub(t, hn::Set(d, up.rise[i]), hn::Mul(s, rise));
      const VD over = hn::NegMulAdd(size, hn::Sub(height, hn::Set(d, up.height[i])), lead);
      const auto better = hn::And(crosses, hn::Gt(hn::Mul(over, den), hn::Mul(num, size)));
      num = hn::IfThenElse(better, over, num);
      den = hn::IfThenElse(better, size, den);
    }
  }
  return hn::Div(num, den);
}

HWY_NOINLINE double chord_by_trial(const SlabPart& a, const SlabPart& b, const Vec3& n,
                                   double near) {
  const D64 d;
  Slopes of_a, of_b;
  slopes_along(a, n, of_a);
  slopes_along(b, n, of_b);
  const VD best =
      hn::Max(chord_over_points(a, b, of_a, of_b, near), chord_over_crossings(a, b, of_a, of_b, n));
  return hn::GetLane(hn::MaxOfLanes(d, best));
}

// The most that w . x is over the ends of the kept edges.
HWY_INLINE double support_of_edges(const SlabPart& part, const Vec3& w) {
  const D64 d;
  const Vec3V<VD> axis = broadcast(w);
  VD best = hn::Set(d, -kFar);
  for (std::size_t k = 0; k < part.edges; k += hn::Lanes(d)) {
    const VD from = dot(axis, load3(part.ax, part.ay, part.az, k));
    const VD to = dot(axis, load3(part.bx, part.by, part.bz, k));
    best = hn::Max(best, hn::Max(from, to));
  }
  return hn::GetLane(hn::MaxOfLanes(d, best));
}

// Whether a part holds x.
HWY_INLINE bool holds(const SlabPart& part, const Vec3& x, double near) {
  const D64 d;
  const Vec3V<VD> p = broadcast(x);
  VD most = hn::Set(d, -kFar);
  for (std::size_t k = 0; k < part.planes; k += hn::Lanes(d)) {
    const VD along = dot(load3(part.nx, part.ny, part.nz, k), p);
    most = hn::Max(most, hn::Sub(along, hn::LoadU(d, part.d + k)));
  }
  return hn::GetLane(hn::MaxOfLanes(d, most)) <= near;
}

// A vertex of `own` inside `other`, under the plane that has cut one of its edges; n leads out of
// `own`.
HWY_INLINE double chord_of_vertex(const SlabPart& own, const SlabPart& other, const Vec3& n,
                                  double near, const Intervals& in) {
  const std::size_t k = static_cast<std::size_t>(__builtin_ctzll(in.inside));
  const std::size_t cut0 = static_cast<std::size_t>(static_cast<int>(in.cut0[k]));
  const std::size_t cut1 = static_cast<std::size_t>(static_cast<int>(in.cut1[k]));
  if ((cut0 == kNoPlane) == (cut1 == kNoPlane)) return -1;
  const bool first = cut0 == kNoPlane;
  const std::size_t g = first ? cut1 : cut0;
  const Vec3 vertex =
      first ? Vec3(own.ax[k], own.ay[k], own.az[k]) : Vec3(own.bx[k], own.by[k], own.bz[k]);
  const Vec3 face(other.nx[g], other.ny[g], other.nz[g]);
  const double slope = -n.dot(face), height = face.dot(vertex);
  if (!(slope > kSteep) || support_of_edges(own, -face) > near - height) return -1;
  const double chord = (other.d[g] - height) / slope;
  return holds(other, vertex - chord * n, near) ? chord : -1;
}

// Edge i of A and edge j of B.
HWY_INLINE double chord_of_edges(const SlabPart& a, const SlabPart& b, const Vec3& n, double near,
                                 int i, int j) {
  const Vec3 from(a.ax[i], a.ay[i], a.az[i]), other(b.ax[j], b.ay[j], b.az[j]);
  const Vec3 along = Vec3(a.bx[i], a.by[i], a.bz[i]) - from;
  const Vec3 other_along = Vec3(b.bx[j], b.by[j], b.bz[j]) - other, apart = other - from;
  Vec3 w = along.cross(other_along);
  const double sign = n.dot(w) < 0 ? -1 : 1;
  w *= sign;
  const double size = n.dot(w), slack = near * w.norm();
  if (!(size * near > kSteep * slack)) return -1;
  const double t = sign * n.dot(apart.cross(other_along)), s = sign * n.dot(apart.cross(along));
  if (t < 0 || s < 0 || t > size || s > size) return -1;
  if (support_of_edges(a, w) > w.dot(from) + slack) return -1;
  if (support_of_edges(b, -w) > slack - w.dot(other)) return -1;
  return -w.dot(apart) / size;
}

// A part whose kept edges all end below (along w) a vertex of it in the slab lies below it as a
// whole: none of that vertex's neighbours is higher, and the body is convex. So the bodies come
// apart along n where the planes across w through the highest of A and the lowest of B meet, at the
// latest: if a vertex meets a face there, or an edge an edge, that is the chord. Negative: it could
// not be shown, and lines must be tried.
HWY_INLINE double chord_of_features(const SlabPart& a, const SlabPart& b, const Vec3& n,
                                    double near, const Intervals& in_b, const Intervals& in_a) {
  const int of_a = __builtin_popcountll(in_b.inside), of_b = __builtin_popcountll(in_a.inside);
  if (of_a == 1 && of_b == 1) {
    return chord_of_edges(a, b, n, near, __builtin_ctzll(in_b.inside),
                          __builtin_ctzll(in_a.inside));
  }
  if (of_b == 0) return chord_of_vertex(a, b, n, near, in_b);
  if (of_a == 0) return chord_of_vertex(b, a, -n, near, in_a);
  return -1;
}

HWY_INLINE double chord_along(const SlabPart& a, const SlabPart& b, const Vec3& n, double near,
                              const Intervals& in_b, const Intervals& in_a) {
  const double shown = chord_of_features(a, b, n, near / 8, in_b, in_a);
  return shown >= 0 ? shown : chord_by_trial(a, b, n, near);
}

// Places less the reference, as an overlap may be thinner than the rounding of places.
HWY_INLINE double width_along(const Vec3& n, const Pieces& pieces, const Vec3& reference) {
  const D64 d;
  const Vec3V<VD> origin = broadcast(reference);
  const Vec3V<VD> axis = broadcast(n);
  VD low = hn::Set(d, kFar), high = hn::Set(d, -kFar);
  for (std::size_t k = 0; k < pieces.of_edges; k += hn::Lanes(d)) {
    const auto there = hn::FirstN(d, pieces.of_edges - k);
    const VD p = dot(axis, load_first(there, pieces.px, pieces.py, pieces.pz, k) - origin);
    const VD q = dot(axis, load_first(there, pieces.qx, pieces.qy, pieces.qz, k) - origin);
    low = hn::IfThenElse(there, hn::Min(low, hn::Min(p, q)), low);
    high = hn::IfThenElse(there, hn::Max(high, hn::Max(p, q)), high);
  }
  return hn::GetLane(hn::MaxOfLanes(d, high)) - hn::GetLane(hn::MinOfLanes(d, low));
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
