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
constexpr double kAlong = 1e-12;  // rad
using FaceSet = std::array<std::uint64_t, kFaceWords>;

bool has(const FaceSet& set, std::size_t face) { return (set[face / 64] >> (face % 64)) & 1; }

// Faces with a vertex behind the plane, and faces with one before it.
struct FaceSides {
  FaceSet behind, before;
  double deepest, highest;  // heights of vertices
};

bool is_cut(const Shape& shape, const Plane& plane) noexcept {
  double deepest = std::numeric_limits<double>::max(), highest = -deepest;
  const double* x = shape.x.data();
  const double* y = shape.y.data();
  const double* z = shape.z.data();
  for (std::size_t k = 0; k < shape.vertices; ++k) {
    const double height =
        plane.normal.x() * x[k] + plane.normal.y() * y[k] + plane.normal.z() * z[k] - plane.offset;
    deepest = height < deepest ? height : deepest;
    highest = height > highest ? height : highest;
  }
  return deepest < 0 && highest > 0;
}

FaceSides sides_of(const Shape& shape, const Plane& plane) noexcept {
  FaceSides sides;
  sides.deepest = std::numeric_limits<double>::max();
  sides.highest = -sides.deepest;
  for (std::size_t w = 0; w < shape.face_words; ++w) sides.behind[w] = sides.before[w] = 0;
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

void start_face(const Shape& shape, std::size_t f, ClipBuffers& buffers) noexcept {
  buffers.start();
  for (std::size_t k = shape.face_begin[f]; k < shape.face_begin[f + 1]; ++k) {
    const std::size_t edge = shape.face_edge[k];
    const std::size_t other = shape.edge_face[2 * edge] == f ? 1 : 0;
    buffers.add(shape.vertex(shape.face_vertex[k]), shape.edge_face[2 * edge + other]);
  }
}

// Planes of the shape, then those of the wall. One that lies along the normal up to rounding bounds
// nothing along it, but would divide rounding by rounding.
double depth_along(const Shape& shape, std::span<const Plane> planes, const Vec3& normal,
                   const OverlapSums& sums) noexcept {
  std::array<Plane, kMaxShapeFaces + kMaxPatchPlanes> all;
  const auto bound = [&](const Plane& plane) {
    const bool along = std::abs(plane.normal.dot(normal)) < kAlong;
    return along ? Plane{Vec3::Zero(), 0} : plane;
  };
  for (std::size_t f = 0; f < shape.faces; ++f) all[f] = bound(face_plane(shape, f));
  for (std::size_t k = 0; k < planes.size(); ++k) all[shape.faces + k] = bound(planes[k]);
  return sums.chord(-normal, {all.data(), shape.faces + planes.size()}, shape.faces);
}

}  // namespace

bool section_of_shape(const Shape& shape, const Plane& plane, ClipBuffers& buffers) noexcept {
  return is_cut(shape, plane) &&
         section(shape, plane, sides_of(shape, plane), static_cast<int>(shape.faces), buffers);
}

bool overlap_with_wall(const Shape& shape, std::span<const Plane> planes, const Vec3& normal,
                       WallOverlap& out) noexcept {
  const int faces = static_cast<int>(shape.faces);
  const auto clip = [&](ClipBuffers& buffers, std::size_t own) {
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (k != own && !clip_polygon(buffers, planes[k], faces + static_cast<int>(k))) return false;
    }
    return true;
  };
  ClipBuffers buffers;
  OverlapSums sums;
  FaceSet candidates;
  candidates.fill(~std::uint64_t{0});
  double deepest = 0;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const FaceSides sides = sides_of(shape, planes[k]);
    if (sides.deepest >= 0) return false;
    deepest = sides.deepest;
    for (std::size_t w = 0; w < shape.face_words; ++w) candidates[w] &= sides.behind[w];
    const int label = faces + static_cast<int>(k);
    if (sides.highest > 0 && section(shape, planes[k], sides, label, buffers) && clip(buffers, k)) {
      sums.add_face(*buffers.now, planes[k], label, 1);
    }
  }
  for (std::size_t f = 0; f < shape.faces; ++f) {
    if (!has(candidates, f)) continue;
    start_face(shape, f, buffers);
    if (clip(buffers, planes.size())) {
      sums.add_face(*buffers.now, face_plane(shape, f), static_cast<int>(f), 0);
    }
  }
  if (sums.empty() || sums.volume() <= kCoincident * shape.bound_radius * sums.area()) return false;
  out.volume = sums.volume();
  out.centroid = sums.centroid();
  out.depth = planes.size() == 1 ? -deepest : depth_along(shape, planes, normal, sums);
  out.width = sums.width(normal);
  out.full = buffers.full || sums.full();
  return true;
}

}  // namespace quern
