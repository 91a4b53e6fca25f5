#include "scheduler/pair_layout.h"

#include <algorithm>
#include <bit>
#include <span>

namespace quern {

namespace {

// A big ball has hundreds of small partners in other tiles: it takes several lanes.
constexpr Index kLongestImport = 12;

// A pair's gap and partner as one number that sorts as (gap, partner).
std::uint64_t key_of(float gap, Index partner) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(gap);
  const std::uint32_t rising = (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
  return std::uint64_t{rising} << 32 | partner;
}

// Stable, most partners first.
void sort_by_count(std::vector<BlockPlan::Lane>& lanes) {
  Index most = 0;
  for (const auto& lane : lanes) most = std::max(most, lane.count);
  std::vector<Index> begin(most + 2, 0);
  for (const auto& lane : lanes) ++begin[most - lane.count + 1];
  for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  std::vector<BlockPlan::Lane> sorted(lanes.size());
  for (const auto& lane : lanes) sorted[begin[most - lane.count]++] = lane;
  lanes.swap(sorted);
}

// Groups pairs by their owner: partners nearest first, owners of many partners first: few lanes are
// empty, and the last rows of a block touch in none. Drops pairs that stay apart even if both leave
// their lines by what they may.
template <bool kOwn>
void arrange(const Column<float>& allowance, Index first, Index size,
             const std::vector<CandidatePair>& pairs, BlockPlan& plan) {
  plan.partners.clear();
  plan.lanes.clear();
  const auto owner_of = [](const CandidatePair& p) { return kOwn ? p.i : p.j; };
  const auto apart = [&](const CandidatePair& p) {
    return static_cast<double>(p.gap) >
           static_cast<double>(allowance[p.i]) + static_cast<double>(allowance[p.j]);
  };
  std::vector<Index> begin(size + 1, 0);
  std::vector<std::pair<Index, std::uint64_t>> kept;
  kept.reserve(pairs.size());
  for (const CandidatePair& p : pairs) {
    if (apart(p)) continue;
    kept.emplace_back(owner_of(p) - first, key_of(p.gap, kOwn ? p.j : p.i));
    ++begin[kept.back().first + 1];
  }
  for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  std::vector<std::uint64_t> partner(kept.size());
  std::vector<Index> end(begin);
  for (const auto& [owner, key] : kept) partner[end[owner]++] = key;
  for (Index k = 0; k < size; ++k) {
    std::sort(partner.begin() + begin[k], partner.begin() + begin[k + 1]);
    const Index most = kOwn ? kNoIndex : kLongestImport;
    for (Index from = begin[k]; from < begin[k + 1];) {
      const Index count = std::min(begin[k + 1] - from, most);
      plan.lanes.push_back({first + k, from, count});
      from += count;
    }
  }
  plan.partners.reserve(partner.size());
  for (const std::uint64_t key : partner) plan.partners.push_back(static_cast<Index>(key));
  sort_by_count(plan.lanes);
}

// Slot of the pair (i, j) in the old batch, or kNoIndex; an owner's slots are kPairPad apart.
template <class Real>
Index old_slot(const PairBatch<Real>& old, Index first, Index count, Index partner) {
  for (Index k = 0; k < count; ++k) {
    const Index slot = first + k * static_cast<Index>(kPairPad);
    if (old.partner[slot] == partner) return slot;
  }
  return kNoIndex;
}

// What a tile needs to fill its blocks.
template <class Real>
struct Filler {
  const PairBatch<Real>& old;
  const PairLayout<Real>& layout;
  const std::vector<Index>& old_of_new;
  PairBatch<Real>& fresh;
  Particles<Real>& particles;

  // An open contact of the old batch.
  struct Old {
    std::size_t tile;
    Index contact;
  };

  // Owners and partners.
  template <bool kOwn>
  void place(const BlockPlan& plan, Index block) const {
    for (std::size_t at = 0; at < plan.lanes.size(); at += kPairPad, ++block) {
      const std::size_t first_row = fresh.row_begin[block], rows = plan.lanes[at].count;
      for (std::size_t lane = 0; lane < kPairPad; ++lane) {
        const bool empty = at + lane >= plan.lanes.size();
        const BlockPlan::Lane from = plan.lanes[empty ? at : at + lane];
        const std::size_t slot = first_row * kPairPad + lane, count = empty ? 0 : from.count;
        fresh.owner[block * kPairPad + lane] = from.owner;
        if (kOwn && !empty) {
          particles.pair_first[from.owner] = static_cast<Index>(slot);
          particles.pair_count[from.owner] = from.count;
        }
        for (std::size_t row = 0; row < rows; ++row) {
          fresh.partner[slot + row * kPairPad] =
              row < count ? plan.partners[from.begin + row] : from.owner;
        }
      }
    }
  }

  // The contacts that were open, in the order of rows.
  template <bool kOwn>
  void find_open(Index first_block, Index last_block, std::vector<Old>& contacts) const {
    for (Index block = first_block; block < last_block; ++block) {
      for (Index row = fresh.row_begin[block]; row < fresh.row_begin[block + 1]; ++row) {
        fresh.first_contact[row] = static_cast<Index>(contacts.size());
        fresh.open[row] = 0;
        for (std::size_t lane = 0; lane < kPairPad; ++lane) {
          const Index owner = fresh.owner[block * kPairPad + lane];
          const Index partner = fresh.partner[row * kPairPad + lane];
          if (owner == partner) continue;
          const Index i = kOwn ? owner : partner, j = kOwn ? partner : owner;
          const Index was = old_slot(old, layout.old_first[i], layout.old_count[i], old_of_new[j]);
          if (was == kNoIndex || !old.is_open(was)) continue;
          fresh.open[row] |= static_cast<std::uint16_t>(1u << lane);
          contacts.push_back({old.tile_of(was), old.contact_of(was)});
        }
      }
    }
  }

  void fill(std::size_t tile, const TilePairs& pairs) const {
    place<true>(pairs.own_plan, fresh.begin[tile]);
    place<false>(pairs.imported_plan, fresh.own_end[tile]);
    std::vector<Old> open;
    find_open<true>(fresh.begin[tile], fresh.own_end[tile], open);
    const std::size_t own = open.size();
    find_open<false>(fresh.own_end[tile], fresh.begin[tile + 1], open);
    ContactHistory<Real>& to = fresh.contacts[tile];
    to.reset(open.size(), fresh.history());
    for (std::size_t c = 0; c < open.size(); ++c) {
      const ContactHistory<Real>& from = old.contacts[open[c].tile];
      const std::size_t numbers = c < own ? fresh.history() : fresh.law_history();
      for (std::size_t k = 0; k < numbers; ++k) {
        to.number(c, k) = from.number(open[c].contact, k);
      }
    }
  }
};

}  // namespace

void make_room(TilePairs& pairs) {
  pairs.own.clear();
  pairs.own.reserve(pairs.last_own + pairs.last_own / 8);
}

void find_leaving(std::size_t tile, std::size_t tiles, Index tile_size, TilePairs& pairs) {
  std::vector<Index> begin(tiles + 1, 0);
  for (const CandidatePair& p : pairs.own) ++begin[p.j / tile_size + 1];
  begin[tile + 1] = 0;
  pairs.to.clear();
  for (std::size_t t = 0; t < tiles; ++t) {
    begin[t + 1] += begin[t];
    if (begin[t + 1] > begin[t]) {
      pairs.to.push_back({static_cast<Index>(t), begin[t], begin[t + 1]});
    }
  }
  pairs.leaving.resize(begin[tiles]);
  for (std::size_t k = 0; k < pairs.own.size(); ++k) {
    const std::size_t other = pairs.own[k].j / tile_size;
    if (other != tile) pairs.leaving[begin[other]++] = static_cast<Index>(k);
  }
}

void address_runs(std::vector<TilePairs>& tiles) {
  for (TilePairs& tile : tiles) tile.from.clear();
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    for (const TilePairs::Run& run : tiles[tile].to) {
      tiles[run.tile].from.push_back({static_cast<Index>(tile), run.begin, run.end});
    }
  }
}

void import_pairs(std::vector<TilePairs>& tiles, std::size_t tile) {
  TilePairs& pairs = tiles[tile];
  std::size_t count = 0;
  for (const TilePairs::Run& run : pairs.from) count += run.end - run.begin;
  pairs.imported.reserve(count);
  for (const TilePairs::Run& run : pairs.from) {
    const TilePairs& other = tiles[run.tile];
    for (Index k = run.begin; k < run.end; ++k) {
      pairs.imported.push_back(other.own[other.leaving[k]]);
    }
  }
}

void plan_blocks(const Column<float>& allowance, Index first, Index size, TilePairs& pairs) {
  arrange<true>(allowance, first, size, pairs.own, pairs.own_plan);
  arrange<false>(allowance, first, size, pairs.imported, pairs.imported_plan);
  pairs.last_own = pairs.own.size();
  std::vector<CandidatePair>().swap(pairs.own);
  std::vector<CandidatePair>().swap(pairs.imported);
}

template <class Real>
void lay_out_pairs(World<Real>& world, Graph& graph, const std::vector<TilePairs>& tiles,
                   const std::vector<Index>& old_of_new, PairLayout<Real>& layout) {
  PairBatch<Real> fresh;
  fresh.rolling = world.rolling;
  fresh.episodes = world.pairs.episodes;
  fresh.begin.reset(tiles.size() + 1);
  fresh.own_end.reset(tiles.size());
  std::vector<Index> row_begin;
  std::size_t rows = 0;
  const auto add_blocks = [&](const BlockPlan& plan) {
    for (std::size_t at = 0; at < plan.lanes.size(); at += kPairPad) {
      row_begin.push_back(static_cast<Index>(rows));
      rows += plan.lanes[at].count;
    }
  };
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    fresh.begin[tile] = static_cast<Index>(row_begin.size());
    add_blocks(tiles[tile].own_plan);
    fresh.own_end[tile] = static_cast<Index>(row_begin.size());
    add_blocks(tiles[tile].imported_plan);
  }
  QUERN_CHECK(rows * kPairPad < kNoIndex);
  fresh.begin[tiles.size()] = static_cast<Index>(row_begin.size());
  fresh.reset(row_begin.size(), rows);
  row_begin.push_back(static_cast<Index>(rows));
  std::copy(row_begin.begin(), row_begin.end(), fresh.row_begin.begin());
  Particles<Real>& p = world.particles;
  std::swap(layout.old_first, p.pair_first);
  std::swap(layout.old_count, p.pair_count);
  for (Column<Index>* c : {&p.pair_first, &p.pair_count}) {
    c->reset(p.size());
    c->fill(0);
  }
  fresh.contacts.resize(tiles.size());
  const Filler<Real> filler = {world.pairs, layout, old_of_new, fresh, p};
  graph.for_each(tiles.size(), [&](std::size_t tile, int) { filler.fill(tile, tiles[tile]); });
  world.pairs = std::move(fresh);
}

template void lay_out_pairs(World<float>&, Graph&, const std::vector<TilePairs>&,
                            const std::vector<Index>&, PairLayout<float>&);
template void lay_out_pairs(World<double>&, Graph&, const std::vector<TilePairs>&,
                            const std::vector<Index>&, PairLayout<double>&);

}  // namespace quern
