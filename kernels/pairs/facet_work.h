// Scratch of polyhedron_facet.cpp: what one polyhedron has found so far about the walls near it.
//
// All arrays are left uninitialised on purpose: few of their entries are used.
#pragma once

#include <array>

#include "kernels/pairs/polyhedron_facet.h"
#include "kernels/pairs/wall_patch.h"

namespace quern::facet_work {

inline constexpr int kMaxSurfaces = kMaxPatchPlanes;
inline constexpr int kMaxParts = 192;
inline constexpr int kMaxCornersKept = 3072;
inline constexpr int kMaxJoints = 256;

// A range of kept corners.
struct Kept {
  int first, count;
};

// A plane of the wall that cuts the polyhedron, in body units.
struct Surface {
  Plane plane;
  Vec3 normal;  // in the frame of the wall's body
  Index group, wall;
  Kept section;  // empty: the plane does not cut the polyhedron
  PlaneCut cut;
  double section_area;
  Vec3 middle;     // of a circle about the section, in the frame of the wall's body
  double radius;   // m, of that circle
  bool edged;      // an edge that ends the group comes near the circle
  bool centred;    // a triangle has the middle
  Index triangle;  // one near the section, or kNoIndex
  double area;     // of the wall in the polyhedron
  Vec3 moment;     // integral of x cross normal over that
  int patch;       // lowest surface of the same patch
};

// A triangle in a plane that cuts the polyhedron, near the section.
struct NearTriangle {
  Index triangle;
  int surface;
};

// The part of a triangle inside the polyhedron.
struct Part {
  Index triangle;
  int surface;
  std::uint32_t edges;  // bit k: the triangle's edge k reaches into the polyhedron
  Kept corners;
};

// A convex edge of a candidate triangle near the polyhedron.
struct Joint {
  Index edge;
  int surface;
};

struct Work {
  const Facets& facets;
  const ShapePose& pose;
  const Shape& shape;
  ClipBuffers buffers;
  std::array<Surface, kMaxSurfaces> surface;  // not set before use, nor are the next

  std::array<NearTriangle, kMaxParts> near;
  std::array<Part, kMaxParts> part;
  std::array<Joint, kMaxJoints> joint;
  std::array<Vec3, kMaxCornersKept> corner;
  int surfaces = 0, nears = 0, parts = 0, joints = 0, corners = 0;
  bool full = false;
  bool crowded = false;  // more planes than are remembered: none is known to cover its section

  Work(const Facets& f, const ShapePose& p) noexcept : facets(f), pose(p), shape(*p.shape) {}
  Vec3 turned(const Vec3& direction) const { return pose.turn.transpose() * direction; }
};

}  // namespace quern::facet_work
