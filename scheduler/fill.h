// Fill: puts the drawn particles into the scene without overlap.
//
// Random sequential addition, largest first: draw a place, keep it if the sphere overlaps neither a
// wall nor a sphere placed before, else draw again. It needs no physics, is exact in every
// geometry, and wide mixes pack densely because the small ones find the gaps that the large ones
// left. Where a level bounds the region from above (segment, rain), it rises by a few percent
// whenever one sphere finds no place, so the charge is as dense as addition reaches at a bounded
// price. Particle i's draws are a function of (seed, i, attempt), and no more than one thread
// works. Polyhedra are placed as they are, in the orientation that was drawn for them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scheduler/sizes.h"
#include "soa/facets.h"

namespace quern {

struct FillReport {
  double seconds = 0;   // of wall clock
  double fraction = 0;  // solid over the volume of the region below the level reached
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // bounds of all particles that have a place
  // m: how far they may fall.
  double height(const Vec3& gravity) const {
    return (high - low).dot(gravity.normalized().cwiseAbs());
  }
};

// Whether the scene lets particles rain in over time (scheduler/rain).
bool inserted_later(const Scene& scene);

// Sets the positions of all but the explicit particles, which stay; with kRain over a time it
// leaves the others to scheduler/rain. `walls` are in the pose of t = 0. Throws UserError if they
// don't fit.
//   kSegment  below a level against gravity, starting from fill.max_fraction; above the rim of an
//             open box where the box itself is too small
//   kRandom   anywhere in the region
//   kRain     over == 0: a loose column above an open box; anywhere in any other region
FillReport place_particles(const Scene& scene, std::span<const Facets* const> walls,
                           std::vector<ParticleSeed>& particles);

// One line for each particle that overlaps a wall or another particle by more than `allowed` times
// the smaller radius; the deepest first, at most `most_lines` and a count of the rest.
std::vector<std::string> check_overlaps(const Scene& scene, std::span<const Facets* const> walls,
                                        std::span<const ParticleSeed> particles,
                                        double allowed = 0.1, std::size_t most_lines = 10);

}  // namespace quern
