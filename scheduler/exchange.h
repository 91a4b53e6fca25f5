// Exchange: spheres of a settled charge become polyhedra of equal volume.
//
// A bed of polyhedra takes long to settle; one of spheres of the same sizes is near it. What the
// scene asks as a polyhedron takes the place, velocity and spin of its sphere, with the orientation
// that the scene draws for it, and loses its springs; all other particles and contacts keep
// everything. Corners then stand in neighbours, deeply beside small ones: the charge has to be
// relaxed under a capped overlap before its true law holds (Phase::kRelax, scheduler/phases).
#pragma once

#include <span>

#include "scheduler/sizes.h"
#include "soa/world.h"

namespace quern {

// `settled` has the constants of this scene, the state of a charge of spheres, and no polyhedra;
// `seeds` are the scene's particles in the order of the identities in that state, with their shapes
// in `shapes`. New identities: spheres from 0 on in their old order, polyhedra behind them in
// theirs. The lists are stale. Throws UserError where state and scene differ in number, species or
// size of their particles.
template <class Real>
World<Real> exchange_shapes(World<Real>&& settled, const Scene& scene,
                            std::span<const ParticleSeed> seeds, std::vector<Shape> shapes);

}  // namespace quern
