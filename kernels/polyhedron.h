// Polyhedron: the convex hull of points as vertices, planes and polygonal faces. Set-up code.
//
// Qhull (libqhull_r) finds the hull; what is flat to kFlat of the bound radius becomes one face,
// and vertices that then lie between fewer than three faces (inside a face, on an edge) are
// dropped. The rest does not depend on Qhull's order: vertices keep the order of the points, each
// face begins with its lowest vertex, faces are sorted. Where three faces meet, the vertex is moved
// into their planes: file coordinates in single precision are flat to 1e-7 only, contact wants both
// descriptions to be the same body.
#pragma once

#include <vector>

#include "soa/base.h"

namespace quern {

inline constexpr double kFlat = 1e-6;  // of the bound radius

struct Polyhedron {
  std::vector<Vec3> vertex;
  std::vector<std::vector<Index>> face;  // counterclockwise seen from outside
  std::vector<Vec3> normal;              // outwards, unit, per face
  std::vector<double> offset;            // n.x <= offset inside
  bool empty() const { return face.empty(); }
  std::size_t edges() const;
  std::vector<std::array<Index, 3>> triangles() const;  // faces as fans
};

// Empty where the points lie in a plane, on a line or in a point. Throws UserError (without a
// file's name) where details near kFlat leave no clean polyhedron.
Polyhedron convex_hull(const std::vector<Vec3>& points);

// How far the body reaches between two parallel planes, one of which holds a face: the least.
double least_width(const Polyhedron& body);

}  // namespace quern
