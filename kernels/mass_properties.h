// Mass properties of a closed triangle mesh, exact to rounding. Set-up code.
//
// The volume is cut into tetrahedra between a reference point and the triangles; volume, first and
// second moments of a tetrahedron are closed forms (Tonon 2005; Mirtich 1996 gives the same by
// surface integrals). A first pass, relative to vertex 0, finds the centroid; a second one takes
// the moments relative to it, so that a body far from the file's origin loses no digits.
#pragma once

#include <array>
#include <vector>

#include "soa/base.h"

namespace quern {

struct MassProperties {
  double volume = 0;  // negative where the triangles are oriented inwards
  Vec3 centroid = Vec3::Zero();
  Mat3 inertia = Mat3::Zero();  // about the centroid, for unit density
};

// Triangles are counterclockwise seen from outside. A volume of zero gives the centroid of vertex
// 0.
MassProperties mass_properties(const std::vector<Vec3>& vertex,
                               const std::vector<std::array<Index, 3>>& triangle);

struct PrincipalAxes {
  Mat3 axes = Mat3::Identity();  // columns, right-handed
  Vec3 moments = Vec3::Zero();   // along them, ascending unless the given axes were kept
};

// Keeps the given axes where they are principal to 1e-12 of the trace (cubes, balls, boxes).
PrincipalAxes principal_axes(const Mat3& inertia);

}  // namespace quern
