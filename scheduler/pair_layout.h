// From the pairs that a search found to the blocks of the pair batch, with the history of their
// contacts.
//
//   own pairs of tiles -> import pairs of other tiles -> allowances -> drop who stays apart, group
//   by owner -> fill slots with springs from the old slots
#pragma once

#include <vector>

#include "kernels/candidates.h"
#include "scheduler/graph.h"
#include "soa/world.h"

namespace quern {

// The blocks of one part of a tile before they are laid out: lanes in order, 16 to a block.
struct BlockPlan {
  struct Lane {
    Index owner, begin, count;  // its partners: partners[begin .. begin + count)
  };
  std::vector<Index> partners;
  std::vector<Lane> lanes;
};

// The pairs of a tile on their way into the lists.
struct TilePairs {
  // own[leaving[begin .. end)] go from one tile to another as well.
  struct Run {
    Index tile, begin, end;
  };
  std::vector<CandidatePair> own, imported;
  std::vector<Index> leaving;  // rows of `own`, by the partner's tile
  std::vector<Run> to, from;
  BlockPlan own_plan, imported_plan;
  std::size_t last_own = 0;  // how many `own` there were last time
};

// Empties a tile for the next search. Vectors double as they grow: there will be about as many
// pairs as last time.
void make_room(TilePairs& pairs);

// Sorts out which of a tile's own pairs have their partner in another tile.
void find_leaving(std::size_t tile, std::size_t tiles, Index tile_size, TilePairs& pairs);

// Tells each tile which runs of others' pairs are for it, in order of tiles.
void address_runs(std::vector<TilePairs>& tiles);

void import_pairs(std::vector<TilePairs>& tiles, std::size_t tile);

// Drops the pairs of a tile that its spheres' allowances keep apart, and plans the blocks of the
// others. What was found is given back: only the plan is needed from here on.
void plan_blocks(const Column<float>& allowance, Index first, Index size, TilePairs& pairs);

// Working memory, kept from rebuild to rebuild.
template <class Real>
struct PairLayout {
  Column<Index> old_first, old_count;  // pair_first and pair_count of the old batch
};

// Fills the batch from the tiles' plans and carries histories over. pair_first and pair_count of
// the particles are still those of the old batch, which counts particles as old_of_new says.
template <class Real>
void lay_out_pairs(World<Real>& world, Graph& graph, const std::vector<TilePairs>& tiles,
                   const std::vector<Index>& old_of_new, PairLayout<Real>& layout);

}  // namespace quern
