// Stages 1 to 5 of a pair of polyhedra on one SIMD target; see polyhedron_polyhedron.h.
#if defined(QUERN_KERNELS_PAIRS_POLYHEDRON_POLYHEDRON_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_KERNELS_PAIRS_POLYHEDRON_POLYHEDRON_INL_H_
#undef QUERN_KERNELS_PAIRS_POLYHEDRON_POLYHEDRON_INL_H_
#else
#define QUERN_KERNELS_PAIRS_POLYHEDRON_POLYHEDRON_INL_H_
#endif

#include <cmath>

#include "kernels/pairs/polyhedron_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

enum class EdgeWay : std::uint8_t { kApart, kTouching, kAskPolygons };

// Stages 3 to 5 by edges, for shapes that are not too large. `u` and the heights of the slab in the
// frame of the pair.
HWY_NOINLINE EdgeWay overlap_by_edges(const PairFrame& frame, const PatchOptions& options,
                                      const Vec3& u, const Vec3& last, PairOverlap& found,
                                      Vec3& normal, double& overlap) {
  SlabPart a, b;
  {
    HWY_ALIGN double over_a[kFastVertices], over_b[kFastVertices];
    const double apart = u.dot(frame.place);
    const double high = heights_along(*frame.a, u, over_a);
    const double deep = heights_along(*frame.b, -(frame.turn.transpose() * u), over_b);
    const double low = apart - frame.ratio * deep;
    if (high < low) return EdgeWay::kApart;
    if (!gather_part(*frame.a, over_a, low, a)) return EdgeWay::kAskPolygons;
    if (!gather_part(*frame.b, over_b, (apart - high) / frame.ratio, b)) {
      return EdgeWay::kAskPolygons;
    }
  }
  place_part(frame, b);
  if (any_coincident(frame, a, b)) return EdgeWay::kAskPolygons;
  Intervals in_b, in_a;
  clip_edges(b, a, in_b);
  clip_edges(a, b, in_a);
  if ((in_b.inside | in_a.inside) == 0) return EdgeWay::kApart;
  // Sums are taken about a corner of the overlap.
  const Intervals& corner = in_b.inside != 0 ? in_b : in_a;
  const std::size_t k = static_cast<std::size_t>(__builtin_ctzll(corner.inside));
  const Vec3 reference(corner.px[k], corner.py[k], corner.pz[k]);
  FeetOf feet_a, feet_b;
  find_feet(a, reference, feet_a);
  find_feet(b, reference, feet_b);
  Pieces pieces;
  TraceEnds traces;
  collect_pieces<0>(a, feet_a, in_b, pieces, traces);
  pieces.of_a = pieces.count;
  collect_pieces<1>(b, feet_b, in_a, pieces, traces);
  pieces.of_edges = pieces.count;
  if (!collect_traces(a, feet_a, b, feet_b, traces, pieces)) return EdgeWay::kAskPolygons;
  sum_pieces(pieces, reference, options.model, found);
  const TouchKind kind = judge_overlap(frame, found);
  if (kind == TouchKind::kNone) return EdgeWay::kApart;
  normal = overlap_normal(frame, found, kind, last);
  overlap = options.overlap == OverlapMeasure::kWidth
                ? width_along(normal, pieces, reference)
                : chord_along(a, b, normal, kCoincident * frame.reach, in_b, in_a);
  found.moment += reference.cross(found.vector_area);
  found.centroid += reference;
  return EdgeWay::kTouching;
}

HWY_INLINE bool small_shape(const Shape& shape) {
  return shape.vertices <= kFastVertices && shape.faces <= kFastFaces && shape.edges <= kFastEdges;
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
