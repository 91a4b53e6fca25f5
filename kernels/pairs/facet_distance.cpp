// How far a polyhedron is from all candidates at least; see polyhedron_facet.h.
#include <algorithm>
#include <limits>

#include "kernels/pairs/polyhedron_facet.h"

namespace quern {

double distance_from_facets(const Facets& facets, const ShapePose& pose,
                            std::span<const Index> candidates) noexcept {
  const Shape& shape = *pose.shape;
  const double reach = shape.bound_radius * pose.scale;
  // How far the polyhedron lies beyond the plane through `at` with this unit normal.
  const auto beyond = [&](const Vec3& normal, const Vec3& at) {
    const double center = normal.dot(pose.place - at);
    if (center >= 2 * reach) return reach;
    const Vec3 n = pose.turn.transpose() * normal;
    double lowest = std::numeric_limits<double>::max();
    for (std::size_t v = 0; v < shape.vertices; ++v) {
      const double height = n.x() * shape.x[v] + n.y() * shape.y[v] + n.z() * shape.z[v];
      lowest = height < lowest ? height : lowest;
    }
    return std::min(reach, center + pose.scale * lowest);
  };
  double least = reach;
  for (const Index triangle : candidates) {
    const FacetRecord& facet = facets.record[triangle];
    double apart =
        std::max(beyond(facet.normal, facet.corner[0]), beyond(-facet.normal, facet.corner[0]));
    for (std::size_t k = 0; k < 3 && apart < least; ++k) {
      const Vec3 side = facet.corner[(k + 1) % 3] - facet.corner[k];
      apart = std::max(apart, beyond(side.cross(facet.normal).normalized(), facet.corner[k]));
    }
    least = std::min(least, apart);
    if (least <= 0) return 0;
  }
  return least;
}

}  // namespace quern
