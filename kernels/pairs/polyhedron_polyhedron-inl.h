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
    const Vec3V<VD> w = add_scaled(add_scaled(add_scaled(place, v.z, cz), v.y, cy), v.x, cx);
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

// What the depth along a normal is taken from: kept planes with their slopes against it, vertices
// in the slab, edges in the slab.
struct DepthInput {
  const KeptPlanes* planes[2];
  const EdgeLanes* edges[2];
  double slope[2][kFastKept];
  HWY_ALIGN double x[2 * kFastVertices + 8], y[2 * kFastVertices + 8], z[2 * kFastVertices + 8];
  std::size_t points = 0;
  double near;  // heights below are rounding

  HWY_INLINE void add_points(std::uint64_t vertices, const double* px, const double* py,
                             const double* pz) {
    for (; vertices != 0; vertices &= vertices - 1) {
      const std::size_t v = static_cast<std::size_t>(__builtin_ctzll(vertices));
      x[points] = px[v];
      y[points] = py[v];
      z[points++] = pz[v];
    }
  }
};

// Exit from A less entry into B on the lines along the normal through the points; see
// chord_on_line() of the plain way.
HWY_NOINLINE double chord_over_points(DepthInput& in) {
  constexpr double kFar = 1e30;
  const D64 d;
  for (std::size_t k = in.points; k < in.points + hn::Lanes(d); ++k) {
    in.x[k] = in.x[0];
    in.y[k] = in.y[0];
    in.z[k] = in.z[0];
  }
  const VD zero = hn::Zero(d), near = hn::Set(d, in.near);
  VD best = zero;
  for (std::size_t k = 0; k < in.points; k += hn::Lanes(d)) {
    const Vec3V<VD> p = load3(in.x, in.y, in.z, k);
    VD entry[2] = {hn::Set(d, -kFar), hn::Set(d, -kFar)};
    VD exit[2] = {hn::Set(d, kFar), hn::Set(d, kFar)};
    for (std::size_t side = 0; side < 2; ++side) {
      const KeptPlanes& planes = *in.planes[side];
      for (std::size_t f = 0; f < planes.count; ++f) {
        const Vec3V<VD> n = {hn::Set(d, planes.nx[f]), hn::Set(d, planes.ny[f]),
                             hn::Set(d, planes.nz[f])};
        VD height = hn::Sub(dot(n, p), hn::Set(d, planes.d[f]));
        height = hn::IfThenElse(hn::Gt(height, near), height, hn::Min(height, zero));
        const double slope = in.slope[side][f];
        if (std::abs(slope) > 1 / kFar) {
          const VD along = hn::Mul(height, hn::Set(d, -1 / slope));
          if (slope > 0) {
            exit[side] = hn::Min(exit[side], along);
          } else {
            entry[side] = hn::Max(entry[side], along);
          }
        } else {
          exit[side] = hn::IfThenElse(hn::Gt(height, zero), hn::Set(d, -2 * kFar), exit[side]);
        }
      }
    }
    const auto hits = hn::And(hn::Le(entry[0], exit[0]), hn::Le(entry[1], exit[1]));
    best = hn::Max(best, hn::IfThenElseZero(hits, hn::Sub(exit[0], entry[1])));
  }
  const double chord = hn::GetLane(hn::MaxOfLanes(d, best));
  return chord < kFar ? chord : 0;
}

// Where an edge of A that bounds a face looking along n passes over one of B that bounds a face
// looking against it; lanes over B's edges.
HWY_NOINLINE double chord_over_crossings(const DepthInput& in, const Vec3& normal) {
  const D64 d;
  const EdgeLanes &up = *in.edges[0], &down = *in.edges[1];
  HWY_ALIGN double counts[kFastEdges + 9];
  for (std::size_t k = 0; k < down.count + hn::Lanes(d); ++k) counts[k] = 0;
  for (std::size_t k = 0; k < down.count; ++k) {
    counts[k] = in.slope[1][down.left[k]] < 0 || in.slope[1][down.right[k]] < 0 ? 1 : 0;
  }
  const VD zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const Vec3V<VD> n = broadcast(normal);
  VD best = zero;
  for (std::size_t k = 0; k < down.count; k += hn::Lanes(d)) {
    const Vec3V<VD> from = load3(down.ax, down.ay, down.az, k);
    const Vec3V<VD> other = load3(down.bx, down.by, down.bz, k) - from;
    const Vec3V<VD> side = cross(other, n);
    const VD other_rise = dot(n, other);
    const auto looks = hn::Gt(hn::LoadU(d, counts + k), zero);
    for (std::size_t i = 0; i < up.count; ++i) {
      if (in.slope[0][up.left[i]] <= 0 && in.slope[0][up.right[i]] <= 0) continue;
      const Vec3 start(up.ax[i], up.ay[i], up.az[i]);
      const Vec3 along = Vec3(up.bx[i], up.by[i], up.bz[i]) - start;
      const Vec3V<VD> apart = from - broadcast(start);
      const Vec3V<VD> across = broadcast(normal.cross(along));
      const VD turn = dot(across, other);
      const VD size = hn::Abs(turn);
      const VD t = hn::Mul(hn::CopySignToAbs(one, turn), dot(side, apart));
      const VD s = hn::Neg(hn::Mul(hn::CopySignToAbs(one, turn), dot(across, apart)));
      auto crosses = hn::And(hn::And(hn::Ge(t, zero), hn::Le(t, size)),
                             hn::And(hn::Ge(s, zero), hn::Le(s, size)));
      crosses = hn::And(hn::And(crosses, looks), hn::Gt(size, zero));
      const VD share = hn::Div(one, hn::IfThenElse(crosses, size, one));
      const VD rise = hn::Sub(hn::Mul(hn::Mul(t, share), hn::Set(d, normal.dot(along))),
                              hn::Mul(hn::Mul(s, share), other_rise));
      best = hn::Max(best, hn::IfThenElseZero(crosses, hn::Sub(rise, dot(n, apart))));
    }
  }
  return hn::GetLane(hn::MaxOfLanes(d, best));
}

HWY_INLINE double chord_along(const Vec3& n, DepthInput& in) {
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t f = 0; f < in.planes[side]->count; ++f) {
      in.slope[side][f] = n.dot(in.planes[side]->normal(f));
    }
  }
  return std::max(chord_over_points(in), chord_over_crossings(in, n));
}

HWY_INLINE double width_along(const Vec3& n, const Pieces& pieces) {
  double low = std::numeric_limits<double>::max(), high = -low;
  for (std::size_t k = 0; k < pieces.of_edges; ++k) {
    const double p = n.dot(pieces.from[k]), q = n.dot(pieces.to[k]);
    low = std::min(low, std::min(p, q));
    high = std::max(high, std::max(p, q));
  }
  return high - low;
}

// Stages 3 to 5 by edges, for shapes of at most 64 vertices and faces. `u` and the heights of the
// slab in the frame of the pair.
HWY_NOINLINE EdgeWay overlap_by_edges(const PairFrame& frame, const PatchOptions& options,
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

  Vec3 foot[2 * kFastKept], plane_normal[2 * kFastKept];
  for (std::size_t side = 0; side < 2; ++side) {
    const KeptPlanes& kept = side == 0 ? planes_a : planes_b;
    for (std::size_t k = 0; k < kept.count; ++k) {
      const Vec3 face_normal = kept.normal(k);
      plane_normal[side * kFastKept + k] = face_normal;
      foot[side * kFastKept + k] = (kept.d[k] - face_normal.dot(reference)) * face_normal;
    }
  }
  sum_pieces(pieces, foot, plane_normal, options.model, found);
  const TouchKind kind = judge_overlap(frame, found);
  if (kind == TouchKind::kNone) return EdgeWay::kApart;
  normal = overlap_normal(frame, found, kind, last);
  if (options.overlap == OverlapMeasure::kWidth) {
    overlap = width_along(normal, pieces);
  } else {
    DepthInput depth;
    depth.planes[0] = &planes_a;
    depth.planes[1] = &planes_b;
    depth.edges[0] = &edges_a;
    depth.edges[1] = &edges_b;
    depth.near = kCoincident * frame.reach;
    depth.add_points(in_a, a.x.data(), a.y.data(), a.z.data());
    depth.add_points(in_b, x, y, z);
    overlap = chord_along(normal, depth);
  }
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

// A gap in f32 stays below the one in f64, along an axis whose length f32 has rounded by 6e-8 too.
constexpr double kRoundDown = 1 - 1.3e-7;

HWY_INLINE void keep_axis(const Vec3& u, double gap, std::uint32_t flags, PairAxis& axis) {
  for (int k = 0; k < 3; ++k) axis.axis[k] = static_cast<float>(u[k]);
  axis.gap = static_cast<float>(gap * kRoundDown);
  axis.flags = flags;
}

// What is left for pairs that the known axis does not part. `u` (world frame, unit) begins the
// search.
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
  const bool small = small_shape(*a.shape) && small_shape(*b.shape);
  PairOverlap found;
  Vec3 normal;
  double overlap = 0;
  bool touching = false;
  // The depth needs a slab that does not run against the normal (contained bodies, a poor axis).
  for (int k = 0; k < 2; ++k) {
    found.flags = out.flags;
    EdgeWay way = EdgeWay::kAskPolygons;
    if (small) way = overlap_by_edges(frame, options, slab, last, found, normal, overlap);
    touching = way == EdgeWay::kTouching;
    if (way == EdgeWay::kAskPolygons) {
      found.flags = out.flags;
      touching = overlap_by_polygons(frame, options, &slab, last, found, normal, overlap);
    }
    if (!touching || slab.dot(normal) > 0) break;
    slab = normal;
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
    const double gap = gap_along(a, b, u);
    if (gap > 0) {
      axis.gap = static_cast<float>(gap * kRoundDown);
      axis.flags = 0;
      return false;
    }
    u *= 1 / std::sqrt(length2);
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
