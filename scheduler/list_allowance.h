// How far each sphere may leave its straight line before the lists are stale.
//
// A sphere leaves its line when it is hit, by at most about the speed that a hit of one of its
// neighbours, spheres, polyhedra and walls alike, can give it: that relative to itself, twice as
// much if the other one is far heavier, next to nothing if it is far lighter. One fast sphere in a
// resting bed therefore gets wide lists for itself and its neighbours only; the others need no more
// than a share of the slack, and their lists hold little beside their contacts.
#pragma once

#include <vector>

#include "kernels/candidates.h"
#include "scheduler/polyhedron_lists.h"
#include "soa/world.h"

namespace quern {

// What a tile's spheres may meet in the window.
struct TileMeetings {
  const std::vector<CandidatePair>& own;
  const std::vector<CandidatePair>& imported;
  const std::vector<NearSphere>* near;  // null: no polyhedra
};

// Sets the allowances of the spheres of a tile: a share of half the slack, and the way that the
// fastest meeting covers in the window, up to half the slack. `speed` (m/s, by sphere) holds the
// speeds relative to walls on entry and the largest of all meetings on return.
template <class Real>
void set_allowances(World<Real>& world, std::size_t tile, const TileMeetings& meetings,
                    std::vector<float>& speed);

// The same of all polyhedra, and how far their points may turn: as far, without that limit, and the
// way that their spin carries them in the window.
template <class Real>
void set_body_allowances(World<Real>& world, const std::vector<float>& speed);

// Drops the pairs that stay apart even if both leave their lines by what they may.
void drop_apart(const Column<float>& allowance, std::vector<CandidatePair>& pairs);

}  // namespace quern
