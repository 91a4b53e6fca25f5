// The sphere-sphere contacts of one tile in one step: who touches, then the law over all that do.
#pragma once

#include <optional>
#include <utility>

#include "kernels/collision_tally.h"
#include "kernels/contact.h"
#include "soa/pairs.h"

namespace quern {

// Memory of a worker, kept from tile to tile.
template <class Real>
struct PairScratch {
  Column<Index> i, j, state;   // of FoundPairs
  FoundPairs found;            // in them, of the last tile
  ContactHistory<Real> spare;  // takes the new histories, and is then the old ones of that tile
  // Of PairCollisions:
  std::vector<ContactEnergies> energies;
  Column<Real> dissipated, approach, impact;
  Column<Index> ended_kind, begun_kind;
};

// Adds forces to the rows and to `tally`; the tile's open slots and histories become those of now.
// `collisions`: null unless they are recorded; histories then hold episodes.
template <class Real>
void push_tile_pairs(const Kernels<Real>& kernels, const StepConstants<Real>& step,
                     const ParticleView<Real>& particles, PairBatch<Real>& pairs, std::size_t tile,
                     const TileRows& rows, PairScratch<Real>& scratch, ContactTally& tally,
                     CollisionTally* collisions = nullptr);

// After it, of the same tile: the first contact that did not remember finite numbers, as rows of
// particles.
template <class Real>
std::optional<std::pair<Index, Index>> find_odd_history(const PairScratch<Real>& scratch,
                                                        std::size_t law_history);

}  // namespace quern
