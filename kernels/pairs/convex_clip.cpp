// Clipping of polygons and sums over the faces of an overlap; see convex_clip.h.
//
// Sums are taken relative to a corner of the overlap, so that they are as exact as its own size,
// not as its distance from the origin: V = sum h A / 3 over the faces, first moment by cones (3/4
// rule).
#include "kernels/pairs/convex_clip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quern {
namespace {

constexpr double kParallel = 1e-30;  // a line this flat against a plane never meets it

// The square of a plane that surely covers the shape, by which intersect_with_planes() begins.
void start_on_plane(ClipBuffers& buffers, const Plane& plane, double reach, int own) noexcept {
  Vec3 across = Vec3::Unit(0);
  if (std::abs(plane.normal.x()) > 0.7) across = Vec3::Unit(1);
  const Vec3 u = plane.normal.cross(across).normalized();
  const Vec3 v = plane.normal.cross(u);
  const Vec3 center = plane.offset * plane.normal;
  buffers.start();
  buffers.add(center + reach * (-u - v), own);
  buffers.add(center + reach * (u - v), own);
  buffers.add(center + reach * (u + v), own);
  buffers.add(center + reach * (v - u), own);
}

}  // namespace

bool clip_polygon(ClipBuffers& buffers, const Plane& plane, int label) noexcept {
  const ClippedPolygon& in = *buffers.now;
  double height[kMaxCorners];
  bool any_out = false, any_in = false;
  for (int k = 0; k < in.corners; ++k) {
    height[k] = plane.height(in.corner[k]);
    any_out |= height[k] > 0;
    any_in |= height[k] <= 0;
  }
  if (!any_out) return in.corners > 0;
  if (!any_in) {
    buffers.now->corners = 0;
    return false;
  }
  if (in.corners + 2 > kMaxCorners) {
    buffers.full = true;
    return true;
  }
  ClippedPolygon& out = *buffers.spare;
  int count = 0;
  for (int k = 0; k < in.corners && count + 2 <= kMaxCorners; ++k) {
    const int next = k + 1 < in.corners ? k + 1 : 0;
    const bool inside = height[k] <= 0, next_inside = height[next] <= 0;
    if (inside) {
      out.corner[count] = in.corner[k];
      out.beyond[count++] = in.beyond[k];
    }
    if (inside && !next_inside) {
      out.corner[count] = crossing(in.corner[k], height[k], in.corner[next], height[next]);
      out.beyond[count++] = label;
    } else if (!inside && next_inside) {
      out.corner[count] = crossing(in.corner[next], height[next], in.corner[k], height[k]);
      out.beyond[count++] = in.beyond[k];
    }
  }
  out.corners = count;
  std::swap(buffers.now, buffers.spare);
  return true;
}

bool clip_by_shape(ClipBuffers& buffers, const Shape& shape, int first_label) noexcept {
  for (std::size_t f = 0; f < shape.faces; ++f) {
    const Plane plane{shape.normal(f), shape.d[f]};
    if (!clip_polygon(buffers, plane, first_label + static_cast<int>(f))) return false;
  }
  return true;
}

double polygon_area(const ClippedPolygon& polygon, const Vec3& normal) noexcept {
  double twice = 0;
  for (int k = 1; k + 1 < polygon.corners; ++k) {
    const Vec3 a = polygon.corner[k] - polygon.corner[0];
    const Vec3 b = polygon.corner[k + 1] - polygon.corner[0];
    twice += normal.dot(a.cross(b));
  }
  return 0.5 * twice;
}

void OverlapSums::add_cones(const ClippedPolygon& polygon, const Plane& own, int side) noexcept {
  const double distance = -own.height(reference_);
  const Vec3 first = polygon.corner[0] - reference_;
  for (int k = 1; k + 1 < polygon.corners; ++k) {
    const Vec3 a = polygon.corner[k] - reference_, b = polygon.corner[k + 1] - reference_;
    const double area = 0.5 * own.normal.dot((a - first).cross(b - first));
    const Vec3 middle = (first + a + b) / 3.0;
    const double cone = area * distance / 3.0;
    area_ += area;
    volume_ += cone;
    first_ += (0.75 * cone) * middle;
    side_[side] += area * own.normal;
    moment_[side] += area * middle.cross(own.normal);
  }
}

void OverlapSums::add_face(const ClippedPolygon& polygon, const Plane& own, int plane,
                           int side) noexcept {
  if (polygon.corners < 3) return;
  if (!begun_) start(polygon.corner[0]);
  add_cones(polygon, own, side);
  for (int k = 0; k < polygon.corners; ++k) {
    if (edges_ == kMaxOverlapEdges) {
      full_ = true;
      return;
    }
    edge_[edges_++] = {polygon.corner[k], polygon.corner[k + 1 < polygon.corners ? k + 1 : 0],
                       plane, polygon.beyond[k]};
  }
}

double OverlapSums::width(const Vec3& n) const noexcept {
  double low = 0, high = 0;
  for (int k = 0; k < edges_; ++k) {
    const double height = n.dot(edge_[k].from - reference_);
    low = k == 0 ? height : std::min(low, height);
    high = k == 0 ? height : std::max(high, height);
  }
  return high - low;
}

double OverlapSums::depth_below(const Plane& plane) const noexcept {
  double deepest = 0;
  for (int k = 0; k < edges_; ++k) deepest = std::min(deepest, plane.height(edge_[k].from));
  return -deepest;
}

double OverlapSums::chord(const Vec3& n, std::span<const Plane> planes,
                          std::size_t of_a) const noexcept {
  const auto slope = [&](int plane) { return n.dot(planes[std::size_t(plane)].normal); };
  // The point lies in the overlap, so a positive height is rounding: no plane is behind it.
  const auto chord_at = [&](const Vec3& x) {
    double exit = std::numeric_limits<double>::max(), entry = -exit;
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const double rise = n.dot(planes[k].normal);
      const double along =
          -std::min(0.0, planes[k].height(x)) / (std::abs(rise) > kParallel ? rise : 1);
      if (k < of_a && rise > kParallel) exit = std::min(exit, along);
      if (k >= of_a && rise < -kParallel) entry = std::max(entry, along);
    }
    const bool bounded =
        exit < std::numeric_limits<double>::max() && entry > -std::numeric_limits<double>::max();
    return bounded ? exit - entry : 0;
  };
  double best = 0;
  for (int k = 0; k < edges_; ++k) best = std::max(best, chord_at(edge_[k].from));
  for (int i = 0; i < edges_; ++i) {
    const OverlapEdge& top = edge_[i];
    if (top.left > top.right || slope(top.left) <= 0 || slope(top.right) <= 0) continue;
    const Vec3 along = top.to - top.from;
    for (int j = 0; j < edges_; ++j) {
      const OverlapEdge& base = edge_[j];
      if (base.left > base.right || slope(base.left) >= 0 || slope(base.right) >= 0) continue;
      const Vec3 other = base.to - base.from, apart = base.from - top.from;
      const double turn = n.dot(along.cross(other));
      if (turn == 0) continue;
      const double t = n.dot(apart.cross(other)), s = n.dot(apart.cross(along));
      if (t * turn < 0 || s * turn < 0 || std::abs(t) > std::abs(turn) ||
          std::abs(s) > std::abs(turn)) {
        continue;
      }
      best = std::max(best, chord_at(top.from + (t / turn) * along));
    }
  }
  return best;
}

bool intersect_with_planes(const Shape& shape, std::span<const Plane> extra,
                           const PatchOptions& options, PlaneOverlap& out) noexcept {
  Plane planes[2 * kMaxShapeFaces];
  const std::size_t faces = shape.faces;
  const std::size_t count = faces + std::min<std::size_t>(extra.size(), kMaxShapeFaces);
  for (std::size_t f = 0; f < faces; ++f) planes[f] = {shape.normal(f), shape.d[f]};
  std::copy_n(extra.begin(), count - faces, planes + faces);
  const auto clip = [&](ClipBuffers& buffers, std::size_t from, std::size_t to, std::size_t own) {
    for (std::size_t k = from; k < to; ++k) {
      if (k != own && !clip_polygon(buffers, planes[k], static_cast<int>(k))) return false;
    }
    return true;
  };
  ClipBuffers buffers;
  OverlapSums sums;
  for (std::size_t f = 0; f < faces; ++f) {
    buffers.start();
    for (std::size_t k = shape.face_begin[f]; k < shape.face_begin[f + 1]; ++k) {
      const std::size_t edge = shape.face_edge[k];
      const std::size_t side = shape.edge_face[2 * edge] == f ? 1 : 0;
      buffers.add(shape.vertex(shape.face_vertex[k]), shape.edge_face[2 * edge + side]);
    }
    if (clip(buffers, faces, count, f)) {
      sums.add_face(*buffers.now, planes[f], static_cast<int>(f), 0);
    }
  }
  for (std::size_t k = faces; k < count; ++k) {
    start_on_plane(buffers, planes[k], 2 * shape.bound_radius, static_cast<int>(k));
    if (clip(buffers, 0, count, k)) sums.add_face(*buffers.now, planes[k], static_cast<int>(k), 1);
  }
  const Vec3 area = sums.vector_area();
  const double size = area.norm();
  if (sums.empty() || size <= 0 || sums.volume() <= 0.5 * kCoincident * shape.bound_radius * size) {
    return false;
  }
  out.volume = sums.volume();
  out.centroid = sums.centroid();
  out.vector_area = area;
  out.moment = sums.moment();
  out.normal = area / size;
  out.overlap = options.overlap == OverlapMeasure::kWidth
                    ? sums.width(out.normal)
                    : sums.chord(out.normal, {planes, count}, faces);
  out.full = buffers.full || sums.full();
  return true;
}

}  // namespace quern
