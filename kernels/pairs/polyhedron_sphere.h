// Polyhedron against sphere: the closest point of a closed convex body to the sphere's centre.
//
// p is the point of the polyhedron nearest to the centre c, the normal points from p to c, the
// overlap is radius - |c - p| and the contact point lies half an overlap outside p towards the
// body. A centre on or inside the body is pushed out through the face whose plane is nearest. The
// overlap is C^1 in the pose while the centre is outside, so with a linear spring the contact
// conserves energy; the normal jumps on the medial axis only, which takes an overlap beyond the
// radius.
//
// touch_polyhedron_sphere() is the plain statement of that, one pair at a time: the oracle of the
// SIMD kernel, which takes a group of spheres near one polyhedron. Both work in the body frame in
// units of the polyhedron's scale: one rotation of the centre, no vertex is ever moved. All f64.
//
// Source: Xie, Ma, Song, Zhao, Powder Technology 386 (2021) 154, section 2.2, in three dimensions.
#pragma once

#include <cstddef>

#include "soa/shapes.h"

namespace quern {

enum class PolyhedronFeature : std::uint8_t { kFace, kEdge, kVertex };

struct PolyhedronSphereTouch {
  Vec3 normal = Vec3::Zero();  // unit, from the polyhedron to the sphere, world axes
  double overlap = 0;          // m; <= 0: apart, and then minus a lower bound of the gap
  Vec3 point = Vec3::Zero();   // contact point, from the polyhedron's place, world axes
  PolyhedronFeature feature = PolyhedronFeature::kFace;
  Index face = 0;       // the plane that is farthest below the centre
  bool inside = false;  // the centre is on or inside the polyhedron
  bool deep = false;    // overlap beyond half the radius: near where normals jump
};

// Whether they touch. `center` is relative to the polyhedron's place, world axes; pose.place is not
// read, so that a difference of places formed in f64 keeps all its bits.
bool touch_polyhedron_sphere(const ShapePose& pose, const Vec3& center, double radius,
                             PolyhedronSphereTouch& out) noexcept;

// A sphere that touches a polyhedron: a cache line, which the law turns to lanes.
struct alignas(64) NearTouch {
  double normal[3];      // unit, from the polyhedron to the sphere; 0 where they are apart
  double overlap;        // m; <= 0: apart, and then minus a lower bound of the gap
  double point[3];       // m, contact point from the polyhedron's place; 0 where they are apart
  double body_contacts;  // of the polyhedron in the last step
};

// Spheres near one polyhedron. Columns hold `count` entries, padded to whole kShapePad with any
// finite numbers.
struct PolyhedronSphereGroup {
  const ShapePose* pose = nullptr;
  std::size_t count = 0;
  double contacts = 0;           // of the polyhedron in the last step, for `touch`
  const double* center[3] = {};  // m, relative to the polyhedron's place, world axes
  const double* radius = nullptr;
  const std::uint8_t* open = nullptr;  // a bit for each that is told even if it is apart
  // Out, room for `count`: what touches or is open, in order, and which of the group it is.
  NearTouch* touch = nullptr;
  Index* slot = nullptr;
};

struct PolyhedronSphereKernel {
  // Returns how many of the group are told.
  std::size_t (*touch)(const PolyhedronSphereGroup&) noexcept;
  const char* target;
};

// The kernel for the best target this CPU and `use_simd_target` allow.
PolyhedronSphereKernel choose_polyhedron_sphere();

}  // namespace quern
