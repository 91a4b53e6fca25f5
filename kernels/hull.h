// From the triangles of a file to a Shape: checks, hull, mass properties, body frame. Set-up code.
//
// A shape must be one closed, convex body. It is then rebuilt from the hull of its vertices, which
// merges coplanar triangles and drops vertices that shape nothing; its mass is that of the rebuilt
// body. With `hull` any mesh with volume is taken by its hull, and the ratio of the two volumes is
// told. Whatever cannot be used is refused with a message that names the file and the place.
#pragma once

#include <optional>

#include "soa/facets.h"
#include "soa/shapes.h"

namespace quern {

struct ShapeOptions {
  bool hull = false;  // take the convex hull of what is no convex body
};

struct ShapeReport {
  Index triangles_read = 0;
  Index welded_vertices = 0;  // of the mesh, after welding
  Index dropped = 0;          // triangles without area, and repeats of a triangle
  Index flipped = 0;          // triangles that were turned to face outwards
  Index bodies = 0;           // parts that share no edge
  Index open_edges = 0, crowded_edges = 0;
  Index faces = 0, vertices = 0, edges = 0;
  Index merged_triangles = 0;                // those that became part of a larger face
  Index spare_vertices = 0;                  // welded ones that the shape does without
  double volume = 0;                         // of the shape, in the file's units
  std::optional<double> mesh_volume;         // of the file's mesh, where it is closed
  std::optional<double> volume_ratio;        // volume / mesh_volume
  double least_width = 0, bound_radius = 0;  // in the file's units
  Vec3 box = Vec3::Zero();  // extents along the principal axes, descending, in the file's units
  std::vector<std::string> warnings;
};

// `name` stands in messages and in the shape: the file. Lengths are those of the triangles. Throws
// UserError with a complete message.
Shape build_shape(const std::vector<Triangle>& triangles, const std::string& name,
                  const ShapeOptions& options, ShapeReport& report);

}  // namespace quern
