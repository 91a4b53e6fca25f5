// The closest point of one triangle to a point, and the feature of the triangle it lies on.
//
// The foot of the point on the plane is tested against the three edges; outside, the nearest of the
// edges that see it wins (the closest point of a convex polygon lies on such an edge). Unlike a
// walk over Voronoi regions this can't name a far feature on a sliver. Everything is formed
// relative to the point, so that the error is a few ulp of the triangle's size, wherever the
// triangle is.
#pragma once

#include <algorithm>

#include "soa/facets.h"

namespace quern {

// Regions of a triangle: 0 the face, 1 + k the edge from corner k to k + 1, 4 + k the corner k.
struct ClosestPoint {
  Vec3 offset;       // closest point minus the point asked for
  double distance2;  // squared length of offset
  int region;
};

// Closest point of the edge k to the point x that is `from` corner k.
inline ClosestPoint closest_on_edge(const Vec3& from, const Vec3& edge, int k) noexcept {
  const double along = from.dot(edge), length2 = edge.squaredNorm();
  const double t = std::clamp(along / length2, 0.0, 1.0);
  const Vec3 offset = t * edge - from;
  const int region = t <= 0 ? 4 + k : t >= 1 ? 4 + (k + 1) % 3 : 1 + k;
  return {offset, offset.squaredNorm(), region};
}

inline ClosestPoint closest_on_facet(const FacetRecord& facet, const Vec3& x) noexcept {
  const auto& p = facet.corner;
  ClosestPoint best{Vec3::Zero(), -1, 0};
  for (int k = 0; k < 3; ++k) {
    const std::size_t i = static_cast<std::size_t>(k), j = k == 2 ? 0 : i + 1;
    const Vec3 from = x - p[i], edge = p[j] - p[i];
    if (facet.normal.dot(edge.cross(from)) >= 0) continue;
    const ClosestPoint found = closest_on_edge(from, edge, k);
    if (best.distance2 < 0 || found.distance2 < best.distance2) best = found;
  }
  if (best.distance2 >= 0) return best;
  const double height = facet.normal.dot(x - p[0]);
  return {-height * facet.normal, height * height, 0};
}

}  // namespace quern
