// The plain way: stages 3 to 5 with polygons, and the decisions both ways share.
//
// Slab cull: a face of A none of whose vertices reaches the lowest point of B along u cannot bound
// the overlap, because inside the slab its half-space is implied by the others (convexity);
// likewise for B. So the overlap is cut out by the kept planes alone, for any u.
#include "kernels/pairs/polyhedron_polyhedron.h"

#include <algorithm>
#include <cmath>

namespace quern {
namespace {

constexpr double kThin = 8 * 2.220446049250313e-16;  // thickness V/|S| over the size of both
// |S| over the surface below which one body is in the other. A tip that sticks out by h leaves an S
// of order h^2, so the step in the force is at h = 1e-4 of the body.
constexpr double kClosed = 1e-8;

// The planes and vertices of both bodies in the frame of the pair; labels are A's faces, then B's.
struct PairPlanes {
  Plane plane[2 * kMaxShapeFaces];
  bool kept[2 * kMaxShapeFaces];     // by the slab
  bool dropped[2 * kMaxShapeFaces];  // of B, as it lies in a face of A: it cuts and bounds nothing
  Vec3 vertex[2][kMaxShapeVertices];
  int kept_label[2 * kMaxShapeFaces];
  Plane kept_plane[2 * kMaxShapeFaces];
  int kept_faces = 0, kept_of_a = 0;
};

void place_bodies(const PairFrame& frame, PairPlanes& out) noexcept {
  const Shape& a = *frame.a;
  const Shape& b = *frame.b;
  for (std::size_t f = 0; f < a.faces; ++f) out.plane[f] = {a.normal(f), a.d[f]};
  for (std::size_t v = 0; v < a.vertices; ++v) out.vertex[0][v] = a.vertex(v);
  for (std::size_t f = 0; f < b.faces; ++f) {
    const Vec3 normal = frame.turn * b.normal(f);
    out.plane[a.faces + f] = {normal, frame.ratio * b.d[f] + normal.dot(frame.place)};
  }
  for (std::size_t v = 0; v < b.vertices; ++v) {
    out.vertex[1][v] = frame.place + frame.ratio * (frame.turn * b.vertex(v));
  }
}

void keep_faces(const Shape& shape, const Vec3* vertex, const Vec3& up, double least,
                bool* kept) noexcept {
  for (std::size_t f = 0; f < shape.faces; ++f) {
    kept[f] = false;
    for (std::size_t k = shape.face_begin[f]; k < shape.face_begin[f + 1] && !kept[f]; ++k) {
      kept[f] = up.dot(vertex[shape.face_vertex[k]]) >= least;
    }
  }
}

// False if the slab is empty.
bool cull(const PairFrame& frame, const Vec3* slab, PairPlanes& planes) noexcept {
  const Shape& a = *frame.a;
  const Shape& b = *frame.b;
  std::fill_n(planes.kept, a.faces + b.faces, true);
  std::fill_n(planes.dropped, a.faces + b.faces, false);
  if (slab == nullptr) return true;
  double high = slab->dot(planes.vertex[0][0]), low = slab->dot(planes.vertex[1][0]);
  for (std::size_t v = 1; v < a.vertices; ++v) {
    high = std::max(high, slab->dot(planes.vertex[0][v]));
  }
  for (std::size_t v = 1; v < b.vertices; ++v) {
    low = std::min(low, slab->dot(planes.vertex[1][v]));
  }
  if (high < low) return false;
  keep_faces(a, planes.vertex[0], *slab, low, planes.kept);
  keep_faces(b, planes.vertex[1], -*slab, -high, planes.kept + a.faces);
  return true;
}

// Of two faces in one plane with the same normal only A's stays. Otherwise rounding would decide
// corner by corner which of them bounds the overlap.
bool drop_coincident(const PairFrame& frame, PairPlanes& planes) noexcept {
  bool any = false;
  const std::size_t of_a = frame.a->faces, all = of_a + frame.b->faces;
  for (std::size_t g = of_a; g < all; ++g) {
    for (std::size_t f = 0; f < of_a && !planes.dropped[g]; ++f) {
      if (!planes.kept[f] || !planes.kept[g]) continue;
      const Plane &p = planes.plane[f], &q = planes.plane[g];
      if (std::abs(p.offset - q.offset) > kCoincident * frame.reach) continue;
      if ((p.normal - q.normal).squaredNorm() > kCoincidentNormals * kCoincidentNormals) continue;
      planes.dropped[g] = any = true;
    }
  }
  return any;
}

void gather_kept(const PairFrame& frame, PairPlanes& planes) noexcept {
  const std::size_t of_a = frame.a->faces, all = of_a + frame.b->faces;
  for (std::size_t f = 0; f < all; ++f) {
    if (!planes.kept[f]) continue;
    planes.kept_of_a += f < of_a ? 1 : 0;
    planes.kept_label[planes.kept_faces] = static_cast<int>(f);
    planes.kept_plane[planes.kept_faces++] = planes.plane[f];
  }
}

// Faces of one body, each clipped by the kept planes of the other.
void clip_side(const PairFrame& frame, const PairPlanes& planes, int side, ClipBuffers& buffers,
               OverlapSums& sums) noexcept {
  const Shape& shape = side == 0 ? *frame.a : *frame.b;
  const int base = side == 0 ? 0 : static_cast<int>(frame.a->faces);
  const int begin = side == 0 ? 0 : planes.kept_of_a;
  const int end = side == 0 ? planes.kept_of_a : planes.kept_faces;
  for (int own = begin; own < end; ++own) {
    const int label = planes.kept_label[own];
    if (planes.dropped[label]) continue;
    const std::size_t face = std::size_t(label - base);
    buffers.start();
    for (std::size_t k = shape.face_begin[face]; k < shape.face_begin[face + 1]; ++k) {
      const std::size_t edge = shape.face_edge[k];
      const std::size_t other = shape.edge_face[2 * edge] == face ? 1 : 0;
      buffers.add(planes.vertex[side][shape.face_vertex[k]],
                  base + shape.edge_face[2 * edge + other]);
    }
    bool left = true;
    for (int k = 0; k < planes.kept_faces && left; ++k) {
      if ((k >= begin && k < end) || planes.dropped[planes.kept_label[k]]) continue;
      left = clip_polygon(buffers, planes.kept_plane[k], planes.kept_label[k]);
    }
    if (left) sums.add_face(*buffers.now, planes.plane[label], label, side);
  }
}

// Exit from A less entry into B on the line through x along n, negative if it misses either.
// Heights within rounding are zero: a point on a face parallel to n must not be taken for outside.
double chord_on_line(const PairFrame& frame, const PairPlanes& planes, const Vec3& x,
                     const Vec3& n) noexcept {
  constexpr double kFar = 1e30;
  double entry[2] = {-kFar, -kFar}, exit[2] = {kFar, kFar};
  for (int k = 0; k < planes.kept_faces; ++k) {
    const int side = k < planes.kept_of_a ? 0 : 1;
    double height = planes.kept_plane[k].height(x);
    if (height <= kCoincident * frame.reach) height = std::min(0.0, height);
    const double slope = n.dot(planes.kept_plane[k].normal);
    if (slope > 1 / kFar) exit[side] = std::min(exit[side], -height / slope);
    if (slope < -1 / kFar) entry[side] = std::max(entry[side], -height / slope);
    if (std::abs(slope) <= 1 / kFar && height > 0) return -1;
  }
  const bool hits = entry[0] <= exit[0] && entry[1] <= exit[1];
  return hits && exit[0] < kFar && entry[1] > -kFar ? exit[0] - entry[1] : -1;
}

// An edge of one body with a face that was kept, in the frame of the pair.
struct KeptEdge {
  Vec3 from, along;
};
int gather_edges(const PairFrame& frame, const PairPlanes& planes, int side, const Vec3& outward,
                 KeptEdge* out) noexcept {
  const Shape& shape = side == 0 ? *frame.a : *frame.b;
  const std::size_t base = side == 0 ? 0 : frame.a->faces;
  int count = 0;
  for (std::size_t e = 0; e < shape.edges; ++e) {
    bool faces_out = false;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t face = base + shape.edge_face[2 * e + k];
      faces_out |= planes.kept[face] && outward.dot(planes.plane[face].normal) > 0;
    }
    if (!faces_out) continue;
    const Vec3& from = planes.vertex[side][shape.edge_vertex[2 * e]];
    out[count++] = {from, planes.vertex[side][shape.edge_vertex[2 * e + 1]] - from};
  }
  return count;
}

// How far B must move along n to leave A. The exit from A is a concave function over the plane
// across n, the entry into B a convex one, both linear in pieces: the greatest difference lies over
// a vertex or over a crossing of edges. All candidates are lower bounds.
double chord_between(const PairFrame& frame, const PairPlanes& planes, const Vec3& n) noexcept {
  double best = 0;
  for (int side = 0; side < 2; ++side) {
    const Shape& shape = side == 0 ? *frame.a : *frame.b;
    for (std::size_t v = 0; v < shape.vertices; ++v) {
      best = std::max(best, chord_on_line(frame, planes, planes.vertex[side][v], n));
    }
  }
  KeptEdge up[kMaxShapeEdges], down[kMaxShapeEdges];
  const int ups = gather_edges(frame, planes, 0, n, up);
  const int downs = gather_edges(frame, planes, 1, -n, down);
  for (int i = 0; i < ups; ++i) {
    const Vec3 across = n.cross(up[i].along);
    for (int j = 0; j < downs; ++j) {
      const Vec3 apart = down[j].from - up[i].from;
      const double turn = across.dot(down[j].along), sign = turn < 0 ? -1 : 1;
      const double t = sign * n.dot(apart.cross(down[j].along)), s = -sign * across.dot(apart);
      const double size = sign * turn;
      if (!(size > 0) || t < 0 || s < 0 || t > size || s > size) continue;
      best = std::max(
          best, (t / size) * n.dot(up[i].along) - (s / size) * n.dot(down[j].along) - n.dot(apart));
    }
  }
  return best;
}

}  // namespace

PairFrame pair_frame(const ShapePose& a, const ShapePose& b) noexcept {
  PairFrame frame{a.shape,
                  b.shape,
                  b.scale / a.scale,
                  a.turn.transpose() * b.turn,
                  a.turn.transpose() * (b.place - a.place) / a.scale,
                  0};
  frame.reach = a.shape->bound_radius + frame.ratio * b.shape->bound_radius;
  return frame;
}

TouchKind judge_overlap(const PairFrame& frame, PairOverlap& found) noexcept {
  const double area = found.vector_area.norm();
  if (!(found.volume > 0)) return TouchKind::kNone;
  const bool contained = area <= kClosed * found.surface;
  if (found.volume <= kThin * frame.reach * (contained ? found.surface : area)) {
    found.flags |= kTouchThin;
    return TouchKind::kNone;
  }
  if (!contained) return TouchKind::kTouching;
  found.flags |= kTouchContained;
  return TouchKind::kContained;
}

Vec3 overlap_normal(const PairFrame& frame, const PairOverlap& found, TouchKind kind,
                    const Vec3& last) noexcept {
  if (kind == TouchKind::kTouching) return found.vector_area.normalized();
  if (last.squaredNorm() > 0.5) return last.normalized();
  const double apart = frame.place.norm();
  if (apart > 1e-9 * frame.reach) return frame.place / apart;
  return Vec3::UnitX();
}

void finish_touch(const ShapePose& a, const PairOverlap& found, const Vec3& normal, double overlap,
                  PolyhedronTouch& out) noexcept {
  const double length = a.scale, square = length * length;
  out.normal = a.turn * normal;
  out.point = a.place + length * (a.turn * found.centroid);
  out.overlap = length * overlap;
  out.volume = square * length * found.volume;
  out.vector_area = square * (a.turn * found.vector_area);
  out.area = square * found.vector_area.norm();
  out.moment =
      square * length * (a.turn * (found.moment - found.centroid.cross(found.vector_area)));
  out.flags = found.flags;
}

bool overlap_by_polygons(const PairFrame& frame, const PatchOptions& options, const Vec3* slab,
                         const Vec3& last, PairOverlap& found, Vec3& normal,
                         double& overlap) noexcept {
  PairPlanes planes;
  found.flags |= kTouchPolygons;
  place_bodies(frame, planes);
  if (!cull(frame, slab, planes)) return false;
  if (drop_coincident(frame, planes)) found.flags |= kTouchCoincident;
  gather_kept(frame, planes);
  ClipBuffers buffers;
  OverlapSums sums;
  clip_side(frame, planes, 0, buffers, sums);
  clip_side(frame, planes, 1, buffers, sums);
  if (sums.empty() || !(sums.volume() > 0)) return false;
  found.volume = sums.volume();
  found.surface = sums.area();
  found.centroid = sums.centroid();
  found.vector_area = sums.vector_area();
  found.moment = sums.moment();
  if (buffers.full || sums.full()) found.flags |= kTouchFull;
  const TouchKind kind = judge_overlap(frame, found);
  if (kind == TouchKind::kNone) return false;
  normal = overlap_normal(frame, found, kind, last);
  overlap = options.overlap == OverlapMeasure::kWidth ? sums.width(normal)
                                                      : chord_between(frame, planes, normal);
  return true;
}

bool touch_polyhedra_plain(const ShapePose& a, const ShapePose& b, const PatchOptions& options,
                           const Vec3* slab, const Vec3& last, PolyhedronTouch& out) noexcept {
  const PairFrame frame = pair_frame(a, b);
  PairOverlap found;
  found.flags = 0;
  Vec3 normal;
  double overlap = 0;
  const Vec3 last_here = a.turn.transpose() * last;
  Vec3 slab_here = slab != nullptr ? Vec3(a.turn.transpose() * *slab) : Vec3::Zero();
  const Vec3* cull_along = slab != nullptr ? &slab_here : nullptr;
  bool touching =
      overlap_by_polygons(frame, options, cull_along, last_here, found, normal, overlap);
  if (touching && slab != nullptr && slab_here.dot(normal) <= 0) {
    slab_here = normal;
    touching = overlap_by_polygons(frame, options, cull_along, last_here, found, normal, overlap);
  }
  if (touching) {
    finish_touch(a, found, normal, overlap, out);
  } else {
    out.flags = found.flags;
  }
  return touching;
}

}  // namespace quern
