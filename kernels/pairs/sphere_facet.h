// One sphere against triangulated walls: where it touches, by local minima of the distance.
//
// Reads Facets (body frame) and candidate triangles, writes up to `capacity` touches, ordered by
// wall and feature id. For each wall by itself: the nearest point always counts; any other point
// counts if it is the closest point of every triangle around its feature, that is, if it is a local
// minimum of the distance. So a plate is one contact however it is triangulated, a convex edge is
// one whose normal sweeps the cone of the edge, a concave corner is two. There are no thresholds on
// angles. Plain f64 code that stores nothing between calls; sides are kept by the caller, see
// keep_side().
#pragma once

#include <span>

#include "soa/facets.h"

namespace quern {

struct WallTouch {
  Vec3 normal;     // unit, from the wall to the sphere's centre (body frame)
  double overlap;  // radius minus distance, m; > 0
  Vec3 point;      // closest point of the wall (body frame)
  Index feature;   // see soa/facets.h
  Index wall;
  Index facet;   // one that the point is on
  bool nearest;  // of its wall
  bool behind;   // the centre is on the back of the wall here; the normal then points to the back
};

// A sphere has far fewer contacts with walls than this; see sphere_facet_touches().
inline constexpr int kMaxWallTouches = 32;

// Returns the number of touches written. `candidates`: ids of triangles, each at most once, among
// them every triangle within `radius` of the centre, on either side; their order is of no effect.
// If there are more touches than `capacity`, those of least overlap are left out. Past 192
// triangles within the radius only the nearest 192 are looked at.
int sphere_facet_touches(const Facets& facets, const Vec3& center, double radius,
                         std::span<const Index> candidates, WallTouch* out, int capacity) noexcept;

// How far the centre may move while sphere_facet_touches() surely reports nothing (facet: kNoIndex),
// or nothing but a touch of the face of `facet`, with the centre in front.
struct FacetFreedom {
  double way;  // m; 0: unknown
  Index facet;
};
FacetFreedom facet_freedom(const Facets& facets, const Vec3& center, double radius,
                           std::span<const Index> candidates) noexcept;

// Keeps the side by history. `stored_normal` (body frame) is the normal the same contact had a step
// ago: if the centre has crossed the wall since, the normal stays and the overlap is the radius
// plus the distance, so that the sphere is pushed back out where it came in. Straight through a
// face the face's own normal is taken, which turns with the wall.
void keep_side(WallTouch& touch, const Vec3& stored_normal, double radius) noexcept;

}  // namespace quern
