// A convex shape pressed into a wall that is bounded by a few planes: section, volume, depth.
//
// One plane is by far the most frequent. Its section and what lies behind come from the edges of
// the shape that cross it or lie behind it (cut_by_edges); polygons of whole faces are for larger
// shapes, for signs that do not pair up, for what is about as thin as rounding, and for tests.
//
// All in the body frame of the shape with unit equivalent radius (convex_clip.h). The wall is what
// lies behind all of `planes`: its surface, and limits of the part of it that is looked at. Planes
// of one contact are few, those of the shape many, hence not the code for two polyhedra: only faces
// that the planes leave are ever clipped.
//
//   depth along n   how far the shape must move along n to leave the wall: the greatest distance,
//                   along n, from a point of the shape up to where the wall ends above it
//
// Of a corner that leans this is more than the longest segment of the overlap; behind a single
// plane it is the depth of the deepest vertex. It is found at a corner of the overlap, or where an
// edge of the wall passes over an edge of the shape.
#pragma once

#include <array>
#include <span>

#include "kernels/pairs/convex_clip.h"

namespace quern {

inline constexpr int kMaxPatchPlanes = 32;

// Faces with a vertex behind a plane, and faces with one before it. Left uninitialised on purpose.
using FaceSet = std::array<std::uint64_t, kMaxShapeFaces / 64>;
struct FaceSides {
  FaceSet behind, before;
  double deepest, highest;  // heights of vertices
};

// A shape cut by a plane. Left uninitialised on purpose.
struct PlaneCut {
  FaceSides sides;
  bool by_edges;  // then what follows is known of the part behind the plane, but not sides.before
  double volume;
  double reach2;  // square of the greatest distance from corner 0 of the section
  Vec3 centroid;
};

// The polygon in which the plane cuts the shape, in buffers.now, and the sides of the plane; false
// if it does not cut.
enum class CutWay : std::uint8_t { kEdges, kPolygons };
bool section_of_shape(const Shape& shape, const Plane& plane, ClipBuffers& buffers, PlaneCut& cut,
                      CutWay way = CutWay::kEdges) noexcept;

// What section_of_shape() does first, with lanes over vertices and edges (plane_cut.cpp). False if
// the plane does not cut or the signs of heights do not pair up; the heights of `cut` are set even
// then.
inline constexpr std::size_t kMaxCutEdges = 64;  // and vertices, and faces: one word of bits
inline bool can_cut_by_edges(const Shape& shape) noexcept {
  return shape.vertices <= kMaxCutEdges && shape.faces <= kMaxCutEdges &&
         shape.edges <= 64;
}
bool cut_by_edges(const Shape& shape, const Plane& plane, ClipBuffers& buffers,
                  PlaneCut& cut) noexcept;

struct WallOverlap {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
  double depth = 0, width = 0;  // along the normal that was asked
  bool full = false;            // a scratch limit was met
};

// A section that is known: one of its corners, and its area.
struct Section {
  Vec3 corner;
  double area;
};

// The part of the shape behind one plane. False if it is thinner than rounding.
bool overlap_behind_plane(const Shape& shape, const Plane& plane, const PlaneCut& cut,
                          const Section& section, WallOverlap& out) noexcept;

// False if the overlap is empty or thinner than rounding. At most kMaxPatchPlanes planes.
bool overlap_with_wall(const Shape& shape, std::span<const Plane> planes, const Vec3& normal,
                       WallOverlap& out) noexcept;

}  // namespace quern
