// Impact trial: the restitution that collisions of a scene deliver at its time step, and how deep
// they go.
#pragma once

#include <span>

#include "scheduler/sizes.h"

namespace quern {

// Of the pair of materials that is furthest off what the scene asks for.
struct DeliveredRestitution {
  double asked = 1, mean = 1;
  double scatter = 0;  // standard deviation over the phases of arrival
};

// Head-on collisions of spheres, of each pair of materials the two smallest that meet, at a hundred
// shares of a step before first touch; in the scene's precision. A second or so on one thread.
DeliveredRestitution measure_restitution(const Scene& scene,
                                         std::span<const ParticleSeed> particles, double dt);

// Overlap over radius when two of the heaviest particles meet undamped at typical_speed(): how soft
// the springs are. Linear ones softened f times give sqrt(f) times as much.
double impact_overlap(const Scene& scene, std::span<const ParticleSeed> particles);

}  // namespace quern
