// Welding: from loose triangles to a mesh with shared vertices and no T-junctions. Set-up code.
//
// A corner within 1e-6 of the component's bounding-box diagonal of an earlier vertex becomes that
// vertex. Triangles lower than that tolerance are dropped, and so are repeats of a triangle. Then
// every free edge that runs past free vertices is split at them: contact counts the triangles
// around a feature, and a T-junction would hide one from the other.
#pragma once

#include <array>
#include <vector>

#include "soa/facets.h"

namespace quern {

struct WeldedMesh {
  std::vector<Vec3> vertex;
  std::vector<std::array<Index, 3>> triangle;
};

// Adds what it found to `report`. Throws UserError where a corner is not finite.
WeldedMesh weld(const std::vector<Triangle>& triangles, FacetReport& report);

// A triangle's side as seen from its edge: sorted, equal edges lie together.
struct EdgeUse {
  Index low, high;       // vertices, low < high
  Index triangle, side;  // side k joins corners k and k + 1
  auto operator<=>(const EdgeUse&) const = default;
  bool same_edge(const EdgeUse& o) const { return low == o.low && high == o.high; }
};
std::vector<EdgeUse> sorted_edge_uses(const std::vector<std::array<Index, 3>>& triangles);

}  // namespace quern
