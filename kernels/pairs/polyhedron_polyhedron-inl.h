// Stages 1 to 5 of a pair of polyhedra on one SIMD target; see polyhedron_polyhedron.h.
#if defined(QUERN_KERNELS_PAIRS_POLYHEDRON_POLYHEDRON_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_KERNELS_PAIRS_POLYHEDRON_POLYHEDRON_INL_H_
#undef QUERN_KERNELS_PAIRS_POLYHEDRON_POLYHEDRON_INL_H_
#else
#define QUERN_KERNELS_PAIRS_POLYHEDRON_POLYHEDRON_INL_H_
#endif

#include <cmath>
#include <limits>

#include "kernels/pairs/polyhedron_edges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

enum class EdgeWay : std::uint8_t { kApart, kTouching, kAskPolygons };

// Planes of the kept faces; false if they are too many.
HWY_INLINE bool keep_planes(const Shape& shape, std::uint64_t faces, KeptPlanes& out) {
  if (static_cast<std::size_t>(__builtin_popcountll(faces)) > kFastKept) return false;
  for (; faces != 0; faces &= faces - 1) {
    const std::size_t f = static_cast<std::size_t>(__builtin_ctzll(faces));
    out.slot[f] = static_cast<std::uint8_t>(out.count);
    out.nx[out.count] = shape.nx[f];
    out.ny[out.count] = shape.ny[f];
    out.nz[out.count] = shape.nz[f];
    out.d[out.count++] = shape.d[f];
  }
  return true;
}

HWY_INLINE void place_planes(const PairFrame& frame, KeptPlanes& planes) {
  for (std::size_t k = 0; k < planes.count; ++k) {
    const Vec3 normal = frame.turn * planes.normal(k);
    planes.nx[k] = normal.x();
    planes.ny[k] = normal.y();
    planes.nz[k] = normal.z();
    planes.d[k] = frame.ratio * planes.d[k] + normal.dot(frame.place);
  }
}

HWY_INLINE void place_vertices(const PairFrame& frame, double* x, double* y, double* z) {
  const D64 d;
  const Shape& b = *frame.b;
  const Mat3 turn = frame.ratio * frame.turn;
  const Vec3V<VD> place = broadcast(frame.place);
  const Vec3V<VD> cx = broadcast(turn.col(0)), cy = broadcast(turn.col(1)),
                  cz = broadcast(turn.col(2));
  for (std::size_t k = 0; k < b.vertices; k += hn::Lanes(d)) {
    const Vec3V<VD> v = load3(b.x.data(), b.y.data(), b.z.data(), k);
    const Vec3V<VD> w =
        add_scaled(add_scaled(add_scaled(place, v.z, cz), v.y, cy), v.x, cx);
    hn::StoreU(w.x, d, x + k);
    hn::StoreU(w.y, d, y + k);
    hn::StoreU(w.z, d, z + k);
  }
}

// Two faces in one plane, normals alike: which of them bounds the overlap is the polygons' affair.
HWY_INLINE bool any_coincident(const PairFrame& frame, const KeptPlanes& a, const KeptPlanes& b) {
  const double near = kCoincident * frame.reach;
  for (std::size_t g = 0; g < b.count; ++g) {
    for (std::size_t f = 0; f < a.count; ++f) {
      if (std::abs(a.d[f] - b.d[g]) > near) continue;
      if ((a.normal(f) - b.normal(g)).squaredNorm() <= kCoincidentNormals * kCoincidentNormals) {
        return true;
      }
    }
  }
  return false;
}

// Points of the overlap whose chords are wanted, in lanes.
struct ChordPoints {
  static constexpr std::size_t kRoom = 2 * kFastPieces;
  HWY_ALIGN double x[kRoom + 8], y[kRoom + 8], z[kRoom + 8];
  std::size_t count = 0;
  HWY_INLINE void add(const Vec3& p) {
    x[count] = p.x();
    y[count] = p.y();
    z[count++] = p.z();
  }
};

// Slopes and offsets (relative to the reference) of all kept planes against the normal.
struct ChordPlanes {
  Vec3 normal[2 * kFastKept];
  double offset[2 * kFastKept], slope[2 * kFastKept];
  std::size_t kept_a, kept_b;
};

// The longest chord through any of the points. A point lies in the overlap, so that a positive
// height is rounding and taken as zero.
HWY_INLINE double longest_chord(const ChordPlanes& planes, ChordPoints& points) {
  const D64 d;
  for (std::size_t k = points.count; k < points.count + hn::Lanes(d); ++k) {
    points.x[k] = points.x[0];
    points.y[k] = points.y[0];
    points.z[k] = points.z[0];
  }
  const VD zero = hn::Zero(d);
  VD best = zero;
  for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
    const Vec3V<VD> p = load3(points.x, points.y, points.z, k);
    VD up = hn::Set(d, 1e30), down = hn::Set(d, -1e30);
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t base = side * kFastKept;
      const std::size_t end = base + (side == 0 ? planes.kept_a : planes.kept_b);
      for (std::size_t f = base; f < end; ++f) {
        const double slope = planes.slope[f];
        if (std::abs(slope) <= 1e-30) continue;
        const VD height = hn::Min(
            zero, hn::Sub(dot(broadcast(planes.normal[f]), p), hn::Set(d, planes.offset[f])));
        const VD along = hn::Mul(height, hn::Set(d, -1 / slope));
        if (slope > 0) {
          up = hn::Min(up, along);
        } else {
          down = hn::Max(down, along);
        }
      }
    }
    best = hn::Max(best, hn::Sub(up, down));
  }
  const double chord = hn::GetLane(hn::MaxOfLanes(d, best));
  return chord < 1e30 ? chord : 0;
}

// Where an edge between two faces that look up passes over one between two that look down.
HWY_INLINE double chord_over_crossings(const Pieces& pieces, const Vec3& n,
                                       const ChordPlanes& planes, ChordPoints& points) {
  std::uint8_t top[kFastPieces], base[kFastPieces];
  std::size_t tops = 0, bases = 0;
  for (std::size_t k = 0; k < pieces.count; ++k) {
    const double left = planes.slope[pieces.left[k]], right = planes.slope[pieces.right[k]];
    if (left > 0 && right > 0) top[tops++] = static_cast<std::uint8_t>(k);
    if (left < 0 && right < 0) base[bases++] = static_cast<std::uint8_t>(k);
  }
  double best = 0;
  for (std::size_t i = 0; i < tops; ++i) {
    const Vec3 from = pieces.from[top[i]], along = pieces.to[top[i]] - from;
    const Vec3 across = n.cross(along);
    for (std::size_t j = 0; j < bases; ++j) {
      const Vec3 other = pieces.to[base[j]] - pieces.from[base[j]];
      const Vec3 apart = pieces.from[base[j]] - from;
      const double turn = across.dot(other), s = -across.dot(apart);
      const double t = n.dot(apart.cross(other));
      const double sign = turn < 0 ? -1 : 1, size = std::abs(turn);
      if (turn == 0 || s * sign < 0 || s * sign > size || t * sign < 0 || t * sign > size) continue;
      if (points.count == ChordPoints::kRoom) {
        best = std::max(best, longest_chord(planes, points));
        points.count = 0;
      }
      points.add(from + (t / turn) * along);
    }
  }
  return std::max(best, points.count > 0 ? longest_chord(planes, points) : 0);
}

HWY_INLINE double overlap_along(const Pieces& pieces, const Vec3& n, OverlapMeasure measure,
                                ChordPlanes& planes) {
  if (measure == OverlapMeasure::kWidth) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (std::size_t k = 0; k < pieces.of_edges; ++k) {
      const double p = n.dot(pieces.from[k]), q = n.dot(pieces.to[k]);
      low = std::min(low, std::min(p, q));
      high = std::max(high, std::max(p, q));
    }
    return high - low;
  }
  for (std::size_t f = 0; f < 2 * kFastKept; ++f) {
    const bool kept = f < kFastKept ? f < planes.kept_a : f < kFastKept + planes.kept_b;
    if (kept) planes.slope[f] = n.dot(planes.normal[f]);
  }
  ChordPoints points;
  for (std::size_t k = 0; k < pieces.of_edges; ++k) {
    points.add(pieces.from[k]);
    points.add(pieces.to[k]);
  }
  return chord_over_crossings(pieces, n, planes, points);
}

// Stages 3 to 5 by edges, for shapes of at most 64 vertices and faces. `u` and the heights of the slab
// in the frame of the pair.
HWY_INLINE EdgeWay overlap_by_edges(const PairFrame& frame, const PatchOptions& options,
                                    const Vec3& u, const Vec3& last, PairOverlap& found,
                                    Vec3& normal, double& overlap) {
  const Shape& a = *frame.a;
  const Shape& b = *frame.b;
  const Vec3 ub = frame.turn.transpose() * u;
  const double apart = u.dot(frame.place);
  const double high = support_height(a, u), low = apart - frame.ratio * support_height(b, -ub);
  if (high < low) return EdgeWay::kApart;
  const std::uint64_t in_a = vertices_above(a, u, low);
  const std::uint64_t in_b = vertices_above(b, -ub, (apart - high) / frame.ratio);
  KeptPlanes planes_a, planes_b;
  EdgeLanes edges_a, edges_b;
  HWY_ALIGN double x[kFastVertices + 8], y[kFastVertices + 8], z[kFastVertices + 8];
  if (!keep_planes(a, faces_around(a, in_a), planes_a)) return EdgeWay::kAskPolygons;
  if (!keep_planes(b, faces_around(b, in_b), planes_b)) return EdgeWay::kAskPolygons;
  place_planes(frame, planes_b);
  if (any_coincident(frame, planes_a, planes_b)) return EdgeWay::kAskPolygons;
  place_vertices(frame, x, y, z);
  if (!gather_edges(a, in_a, a.x.data(), a.y.data(), a.z.data(), planes_a.slot, edges_a) ||
      !gather_edges(b, in_b, x, y, z, planes_b.slot, edges_b)) {
    return EdgeWay::kAskPolygons;
  }
  clip_edges(planes_b, edges_a);
  clip_edges(planes_a, edges_b);
  Pieces pieces;
  TraceEnds traces;
  Vec3 reference = Vec3::Zero();
  collect_pieces(edges_a, 0, reference, pieces, traces);
  pieces.of_a = pieces.count;
  collect_pieces(edges_b, 1, reference, pieces, traces);
  pieces.of_edges = pieces.count;
  if (pieces.count == 0) return EdgeWay::kApart;
  if (!traces.paired() || !collect_traces(traces, pieces)) return EdgeWay::kAskPolygons;

  ChordPlanes planes;
  planes.kept_a = planes_a.count;
  planes.kept_b = planes_b.count;
  Vec3 foot[2 * kFastKept];
  for (std::size_t side = 0; side < 2; ++side) {
    const KeptPlanes& kept = side == 0 ? planes_a : planes_b;
    for (std::size_t k = 0; k < kept.count; ++k) {
      const std::size_t f = side * kFastKept + k;
      planes.normal[f] = kept.normal(k);
      planes.offset[f] = kept.d[k] - planes.normal[f].dot(reference);
      foot[f] = planes.offset[f] * planes.normal[f];
    }
  }
  sum_pieces(pieces, foot, planes.normal, options.model, found);
  const TouchKind kind = judge_overlap(frame, found);
  if (kind == TouchKind::kNone) return EdgeWay::kApart;
  normal = overlap_normal(frame, found, kind, last);
  overlap = overlap_along(pieces, normal, options.overlap, planes);
  found.moment += reference.cross(found.vector_area);
  found.centroid += reference;
  return EdgeWay::kTouching;
}

HWY_INLINE bool small_shape(const Shape& shape) {
  return shape.vertices <= kFastVertices && shape.faces <= kFastFaces && shape.edges <= 192;
}

// The distance between the bodies along u (world frame, unit); negative if they overlap.
HWY_INLINE double gap_along(const ShapePose& a, const ShapePose& b, const Vec3& u) {
  const double high = a.scale * support_height(*a.shape, a.turn.transpose() * u);
  const double low = b.scale * support_height(*b.shape, -(b.turn.transpose() * u));
  return u.dot(b.place - a.place) - low - high;
}

constexpr double kRoundDown = 1 - 1.3e-7;  // a gap in f32 stays below the one in f64

HWY_INLINE void keep_axis(const Vec3& u, double gap, std::uint32_t flags, PairAxis& axis) {
  for (int k = 0; k < 3; ++k) axis.axis[k] = static_cast<float>(u[k]);
  axis.gap = static_cast<float>(gap * kRoundDown);
  axis.flags = flags;
}

// What is left for pairs that the known axis does not part. `u` (world frame, unit) begins the search.
HWY_NOINLINE bool search_and_clip(const ShapePose& a, const ShapePose& b,
                                  const PatchOptions& options, const Vec3& u, PairAxis& axis,
                                  PolyhedronTouch& out) noexcept {
  const PairFrame frame = pair_frame(a, b);
  const bool touched = (axis.flags & kAxisTouched) != 0;
  Vec3 slab = a.turn.transpose() * u;
  const Vec3 last = touched ? slab : Vec3::Zero();
  if (!touched) {
    out.flags |= kTouchSearched;
    double gap = -1;
    slab = find_axis(frame, slab, gap);
    if (gap > 0) {
      keep_axis(a.turn * slab, 0, 0, axis);
      const Vec3 kept = Vec3(axis.axis[0], axis.axis[1], axis.axis[2]).normalized();
      keep_axis(a.turn * slab, std::max(0.0, gap_along(a, b, kept)), 0, axis);
      return false;
    }
  }
  PairOverlap found;
  found.flags = out.flags;
  Vec3 normal;
  double overlap = 0;
  EdgeWay way = EdgeWay::kAskPolygons;
  if (small_shape(*a.shape) && small_shape(*b.shape)) {
    way = overlap_by_edges(frame, options, slab, last, found, normal, overlap);
  }
  bool touching = way == EdgeWay::kTouching;
  if (way == EdgeWay::kAskPolygons) {
    found.flags = out.flags;
    touching = overlap_by_polygons(frame, options, &slab, last, found, normal, overlap);
  }
  out.flags = found.flags;
  if (touching) finish_touch(a, found, normal, overlap, out);
  keep_axis(touching ? out.normal : Vec3(a.turn * slab), 0, touching ? kAxisTouched : 0, axis);
  return touching;
}

HWY_INLINE bool touch_pair(const ShapePose& a, const ShapePose& b, const PatchOptions& options,
                           PairAxis& axis, PolyhedronTouch& out) noexcept {
  out.flags = 0;
  Vec3 u(axis.axis[0], axis.axis[1], axis.axis[2]);
  const double length2 = u.squaredNorm();
  if (length2 > 0.25) {
    u *= 1 / std::sqrt(length2);
    const double gap = gap_along(a, b, u);
    if (gap > 0) {
      axis.gap = static_cast<float>(gap * kRoundDown);
      axis.flags = 0;
      return false;
    }
  } else {
    u = b.place - a.place;
    const double distance = u.norm();
    u = distance > 0 ? Vec3(u / distance) : Vec3::UnitX();
  }
  return search_and_clip(a, b, options, u, axis, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
