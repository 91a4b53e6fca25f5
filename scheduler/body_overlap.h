// How deep drawn particles overlap one another and walls: the bodies as they are. Set-up code.
#pragma once

#include <span>

#include "scheduler/sizes.h"
#include "soa/facets.h"

namespace quern {

// Overlap in m of two particles whose surrounding spheres overlap by `depth`; 0: apart. `between`
// leads from the place of a to that of b.
double overlap_of(const ParticleSeed& a, const ParticleSeed& b, const Vec3& between, double depth);

// The deepest overlap of a polyhedron with the walls in their pose of t = 0, m; 0: apart.
double polyhedron_wall_overlap(std::span<const Facets* const> walls, const ParticleSeed& p);

}  // namespace quern
