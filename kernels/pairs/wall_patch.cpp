// Section and overlap of a shape with a few planes; see wall_patch.h.
//
// A face can bound the overlap only if it has a vertex behind each plane, and bounds the section
// with a plane only if it has vertices on both of its sides: bit sets of faces, gathered from the
// vertices, choose them. The wall's own polygon is added first, so that volumes count from its
// plane.
#include "kernels/pairs/wall_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace quern {
namespace {

constexpr std::size_t kFaceWords = kMaxShapeFaces / 64;
using FaceSet = std::array<std::uint64_t, kFaceWords>;

bool has(const FaceSet& set, std::size_t face) { return (set[face / 64] >> (face % 64)) & 1; }

// Faces with a vertex behind the plane, and faces with one before it.
struct FaceSides {
  FaceSet behind{}, before{};
  double deepest = 0, highest = 0;  // heights of vertices
};

FaceSides sides_of(const Shape& shape, const Plane& plane) noexcept {
  FaceSides sides;
  sides.deepest = std::numeric_limits<double>::max();
  sides.highest = -sides.deepest;
  for (std::size_t k = 0; k < shape.vertices; ++k) {
    const double height = plane.height(shape.vertex(k));
    sides.deepest = std::min(sides.deepest, height);
    sides.highest = std::max(sides.highest, height);
    FaceSet& set = height <= 0 ? sides.behind : sides.before;
    for (std::size_t w = 0; w < shape.face_words; ++w) {
      set[w] |= shape.vertex_faces[k * shape.face_words + w];
    }
  }
  return sides;
}

Plane face_plane(const Shape& shape, std::size_t f) { return {shape.normal(f), shape.d[f]}; }

void start_square(const Plane& plane, double reach, int label, ClipBuffers& buffers) noexcept {
  const Vec3 u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
  const Vec3 foot = plane.offset * plane.normal;
  buffers.start();
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    buffers.add(foot + (a * reach) * u + (b * reach) * v, label);
  }
}

bool section(const Shape& shape, const Plane& plane, const FaceSides& sides, int label,
             ClipBuffers& buffers) noexcept {
  start_square(plane, 2 * shape.bound_radius, label, buffers);
  for (std::size_t f = 0; f < shape.faces; ++f) {
    if (!has(sides.behind, f) || !has(sides.before, f)) continue;
    if (!clip_polygon(buffers, face_plane(shape, f), static_cast<int>(f))) return false;
  }
  return true;
}

// An edge of the overlap between two planes of the wall, or between two faces of the shape.
struct Ridge {
  Vec3 from, along;
};
constexpr int kMaxRidges = 512;
struct Ridges {
  Ridge list[kMaxRidges];
  int count = 0;
  bool full = false;
  void add(const Vec3& from, const Vec3& to) noexcept {
    if (count < kMaxRidges) {
      list[count++] = {from, to - from};
    } else {
      full = true;
    }
  }
};

// Planes by label: faces of the shape first, then those of the wall.
struct Bodies {
  const Shape& shape;
  std::span<const Plane> planes;
  const Vec3& normal;

  int faces() const { return static_cast<int>(shape.faces); }
  bool is_wall(int label) const { return label >= faces(); }
  double slope(int label) const {
    return is_wall(label) ? normal.dot(planes[static_cast<std::size_t>(label - faces())].normal)
                          : normal.dot(shape.normal(static_cast<std::size_t>(label)));
  }
  // From where the line through x along the normal enters the shape to where it leaves the wall. x
  // lies in both, so a positive height is rounding.
  double depth_at(const Vec3& x) const noexcept {
    double up = std::numeric_limits<double>::max(), down = 0;
    for (const Plane& plane : planes) {
      const double rise = plane.normal.dot(normal);
      if (rise > 1e-12) up = std::min(up, -std::min(0.0, plane.height(x)) / rise);
    }
    if (up == std::numeric_limits<double>::max()) return 0;
    down = -std::numeric_limits<double>::max();
    for (std::size_t f = 0; f < shape.faces; ++f) {
      const Plane plane = face_plane(shape, f);
      const double rise = plane.normal.dot(normal);
      if (rise < -1e-12) down = std::max(down, -std::min(0.0, plane.height(x)) / rise);
    }
    return up - down;
  }
};

double depth_along(const Bodies& bodies, const Ridges& top, const Ridges& base,
                   double best) noexcept {
  for (int i = 0; i < top.count; ++i) {
    for (int j = 0; j < base.count; ++j) {
      const Ridge &a = top.list[i], &b = base.list[j];
      const Vec3 apart = b.from - a.from;
      const double turn = bodies.normal.dot(a.along.cross(b.along));
      const double t = bodies.normal.dot(apart.cross(b.along)) * (turn < 0 ? -1 : 1);
      const double s = bodies.normal.dot(apart.cross(a.along)) * (turn < 0 ? -1 : 1);
      const double size = std::abs(turn);
      if (size == 0 || t < 0 || s < 0 || t > size || s > size) continue;
      best = std::max(best, bodies.depth_at(a.from + (t / size) * a.along));
    }
  }
  return best;
}

struct Overlap {
  ClipBuffers buffers;
  OverlapSums sums;
  Ridges top, base;
  double depth = 0;

  // The polygon in `buffers`, which lies in plane `label`.
  void add(const Bodies& bodies, const Plane& own, int label, bool want_depth) noexcept {
    const ClippedPolygon& p = *buffers.now;
    sums.add_face(p, own, label, bodies.is_wall(label) ? 1 : 0);
    if (!want_depth) return;
    const double slope = bodies.slope(label);
    for (int k = 0; k < p.corners; ++k) {
      depth = std::max(depth, bodies.depth_at(p.corner[k]));
      const int other = p.beyond[k];
      if (other <= label || bodies.is_wall(other) != bodies.is_wall(label)) continue;
      const Vec3& to = p.corner[k + 1 < p.corners ? k + 1 : 0];
      if (slope > 0 && bodies.is_wall(label)) top.add(p.corner[k], to);
      if (slope < 0 && !bodies.is_wall(label) && bodies.slope(other) < 0) base.add(p.corner[k], to);
    }
  }
};

void start_face(const Shape& shape, std::size_t f, ClipBuffers& buffers) noexcept {
  buffers.start();
  for (std::size_t k = shape.face_begin[f]; k < shape.face_begin[f + 1]; ++k) {
    const std::size_t edge = shape.face_edge[k];
    const std::size_t other = shape.edge_face[2 * edge] == f ? 1 : 0;
    buffers.add(shape.vertex(shape.face_vertex[k]), shape.edge_face[2 * edge + other]);
  }
}

}  // namespace

bool section_of_shape(const Shape& shape, const Plane& plane, ClipBuffers& buffers) noexcept {
  const FaceSides sides = sides_of(shape, plane);
  return sides.deepest < 0 && sides.highest > 0 &&
         section(shape, plane, sides, static_cast<int>(shape.faces), buffers);
}

bool overlap_with_wall(const Shape& shape, std::span<const Plane> planes, std::size_t walls,
                       const Vec3& normal, WallOverlap& out) noexcept {
  const Bodies bodies{shape, planes, normal};
  const bool single = planes.size() == 1;
  const auto clip = [&](ClipBuffers& buffers, std::size_t own) {
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const int label = bodies.faces() + static_cast<int>(k);
      if (k != own && !clip_polygon(buffers, planes[k], label)) return false;
    }
    return true;
  };
  Overlap overlap;
  ClipBuffers& buffers = overlap.buffers;
  FaceSet candidates;
  candidates.fill(~std::uint64_t{0});
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const FaceSides sides = sides_of(shape, planes[k]);
    if (sides.deepest >= 0) return false;
    if (single) overlap.depth = -sides.deepest;
    for (std::size_t w = 0; w < shape.face_words; ++w) candidates[w] &= sides.behind[w];
    if (sides.highest <= 0) continue;
    const int label = bodies.faces() + static_cast<int>(k);
    if (section(shape, planes[k], sides, label, buffers) && clip(buffers, k)) {
      overlap.add(bodies, planes[k], label, !single && k < walls);
    }
  }
  for (std::size_t f = 0; f < shape.faces; ++f) {
    if (!has(candidates, f)) continue;
    start_face(shape, f, buffers);
    if (clip(buffers, planes.size())) {
      overlap.add(bodies, face_plane(shape, f), static_cast<int>(f), !single);
    }
  }
  const OverlapSums& sums = overlap.sums;
  if (sums.empty() || sums.volume() <= kCoincident * shape.bound_radius * sums.area()) return false;
  out.volume = sums.volume();
  out.centroid = sums.centroid();
  out.depth =
      single ? overlap.depth : depth_along(bodies, overlap.top, overlap.base, overlap.depth);
  out.width = sums.width(normal);
  out.full = buffers.full || sums.full() || overlap.top.full || overlap.base.full;
  return true;
}

}  // namespace quern
