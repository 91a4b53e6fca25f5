// Lists of walls, made at a rebuild: the facets that a sphere may meet before the lists are stale.
#pragma once

#include <vector>

#include "kernels/candidates.h"
#include "soa/world.h"

namespace quern {

// Largest way a particle at x with velocity v can move against a body within the span from `time`
// on.
double wall_reach(const Body& body, const Vec3& x, const Vec3& v, double time, double span);

Vec3 velocity_of(const SearchPoint& point);

// Lists the facets near the spheres of a tile; raises `speed` (m/s, by sphere) to that relative to
// walls that are listed.
template <class Real>
void find_wall_candidates(World<Real>& world, const SearchPoint* points, std::size_t tile,
                          std::vector<float>& speed);

// Wall springs follow their particles to their new tiles, in particle order.
template <class Real>
void carry_wall_springs(World<Real>& world, const std::vector<Index>& new_of_old);

}  // namespace quern
