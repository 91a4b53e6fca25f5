// Rebuild: when the lists are stale, sort particles along a space-filling curve, cut tiles, search
// candidates, carry the history of every contact over. Nothing of the physics changes by it.
//
//   wrap -> curve order -> permute columns -> grid -> own pairs per tile -> import pairs of other
//   tiles -> fill slots with springs from the old slots -> candidates for walls
#pragma once

#include <vector>

#include "kernels/candidates.h"
#include "scheduler/graph.h"
#include "soa/world.h"

namespace quern {

// Buffers kept between rebuilds.
template <class Real>
struct RebuildScratch {
  std::vector<std::pair<std::uint64_t, Index>> keys;
  std::vector<Index> old_of_new, new_of_old;
  std::array<std::vector<double>, 3> x, v;
  std::vector<double> radius;
  SearchGrid grid;
  std::vector<std::vector<CandidatePair>> own;       // per tile
  std::vector<std::vector<CandidatePair>> imported;  // per tile
  Particles<Real> sorted;
  PairBatch<Real> pairs;
};

// Throws InvariantError if a position is not finite.
template <class Real>
void rebuild(World<Real>& world, Graph& graph, RebuildScratch<Real>& scratch);

// Chooses the next window from how the last one ended; a function of the state alone.
void adapt_window(Clock& clock, bool expired);

}  // namespace quern
