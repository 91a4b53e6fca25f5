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

constexpr double kAlong = 1e-12;  // rad

bool has(const FaceSet& set, std::size_t face) { return (set[face / 64] >> (face % 64)) & 1; }

// Heights of the vertices over the plane, their least and greatest.
void vertex_heights(const Shape& shape, const Plane& plane, double* height, FaceSides& sides) {
  double deepest = std::numeric_limits<double>::max(), highest = -deepest;
  const double* x = shape.x.data();
  const double* y = shape.y.data();
  const double* z = shape.z.data();
  for (std::size_t k = 0; k < shape.vertices; ++k) {
    const double h =
        plane.normal.x() * x[k] + plane.normal.y() * y[k] + plane.normal.z() * z[k] - plane.offset;
    height[k] = h;
    deepest = h < deepest ? h : deepest;
    highest = h > highest ? h : highest;
  }
  sides.deepest = deepest;
  sides.highest = highest;
}

void find_sides(const Shape& shape, const double* height, FaceSides& sides) noexcept {
  const std::size_t words = shape.face_words;
  for (std::size_t w = 0; w < words; ++w) {
    std::uint64_t behind = 0, before = 0;
    const std::uint64_t* faces = shape.vertex_faces.data() + w;
    for (std::size_t k = 0; k < shape.vertices; ++k, faces += words) {
      const std::uint64_t mask = height[k] <= 0 ? ~std::uint64_t{0} : 0;
      behind |= *faces & mask;
      before |= *faces & ~mask;
    }
    sides.behind[w] = behind;
    sides.before[w] = before;
  }
}

void sides_of(const Shape& shape, const Plane& plane, FaceSides& sides) noexcept {
  double height[kMaxShapeVertices];
  vertex_heights(shape, plane, height, sides);
  find_sides(shape, height, sides);
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

// Behind one plane, save for limits along the normal, the depth is that of the deepest corner.
bool bounded_by_first(std::span<const Plane> planes, const Vec3& normal) noexcept {
  if (planes[0].normal.dot(normal) < 1 - kAlong) return false;
  for (std::size_t k = 1; k < planes.size(); ++k) {
    if (std::abs(planes[k].normal.dot(normal)) >= kAlong) return false;
  }
  return true;
}

// Planes of the shape, then those of the wall. One that lies along the normal up to rounding bounds
// nothing along it, but would divide rounding by rounding.
double depth_along(const Shape& shape, std::span<const Plane> planes, const Vec3& normal,
                   const OverlapSums& sums) noexcept {
  if (bounded_by_first(planes, normal)) return sums.depth_below(planes[0]);
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

bool section_of_shape(const Shape& shape, const Plane& plane, ClipBuffers& buffers, PlaneCut& cut,
                      CutWay way) noexcept {
  if (way == CutWay::kEdges && can_cut_by_edges(shape)) {
    cut.by_edges = cut_by_edges(shape, plane, buffers, cut);
    if (!(cut.sides.deepest < 0 && cut.sides.highest > 0)) return false;
    if (cut.by_edges) return true;
  }
  double height[kMaxShapeVertices];
  cut.by_edges = false;
  vertex_heights(shape, plane, height, cut.sides);
  if (!(cut.sides.deepest < 0 && cut.sides.highest > 0)) return false;
  find_sides(shape, height, cut.sides);
  return section(shape, plane, cut.sides, static_cast<int>(shape.faces), buffers);
}

bool overlap_behind_plane(const Shape& shape, const Plane& plane, const PlaneCut& cut,
                          const Section& section, WallOverlap& out) noexcept {
  out.depth = -cut.sides.deepest;
  out.width = std::min(0.0, cut.sides.highest) - cut.sides.deepest;
  // A convex body has less surface than a ball around it.
  const double ball = 4 * kPi * cut.reach2;
  if (cut.by_edges && cut.volume > kCoincident * shape.bound_radius * ball) {
    out.volume = cut.volume;
    out.centroid = cut.centroid;
    out.full = false;
    return true;
  }
  FaceSides sides;
  sides_of(shape, plane, sides);
  ClipBuffers buffers;
  OverlapSums sums;
  sums.start(section.corner);
  for (std::size_t f = 0; f < shape.faces; ++f) {
    if (!has(sides.behind, f)) continue;
    start_face(shape, f, buffers);
    const int label = static_cast<int>(shape.faces);
    if (has(sides.before, f) && !clip_polygon(buffers, plane, label)) continue;
    sums.add_cones(*buffers.now, face_plane(shape, f), 0);
  }
  const double area = sums.area() + section.area;
  if (sums.volume() <= kCoincident * shape.bound_radius * area) return false;
  out.volume = sums.volume();
  out.centroid = sums.centroid();
  out.full = buffers.full;
  return true;
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
  if (planes.size() == 1) {
    PlaneCut cut;
    Section section = {planes[0].offset * planes[0].normal, 0};
    if (section_of_shape(shape, planes[0], buffers, cut)) {
      section = {buffers.now->corner[0], polygon_area(*buffers.now, planes[0].normal)};
    }
    if (cut.sides.deepest >= 0) return false;
    return overlap_behind_plane(shape, planes[0], cut, section, out);
  }
  OverlapSums sums;
  FaceSet candidates;
  candidates.fill(~std::uint64_t{0});
  for (std::size_t k = 0; k < planes.size(); ++k) {
    PlaneCut cut;
    const bool cuts = section_of_shape(shape, planes[k], buffers, cut);
    if (cut.sides.deepest >= 0) return false;
    if (!cuts) sides_of(shape, planes[k], cut.sides);
    for (std::size_t w = 0; w < shape.face_words; ++w) candidates[w] &= cut.sides.behind[w];
    if (cuts && clip(buffers, k)) {
      sums.add_face(*buffers.now, planes[k], faces + static_cast<int>(k), 1);
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
  out.depth = depth_along(shape, planes, normal, sums);
  out.width = sums.width(normal);
  out.full = buffers.full || sums.full();
  return true;
}

}  // namespace quern
