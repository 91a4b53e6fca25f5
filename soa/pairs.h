// PairBatch: the listed pairs of one pair type, tile by tile, with their spring history.
//
// A block is kPairPad owners, one a lane; a row of a block is one partner of each. Owners with equally
// many partners stand together, so that few lanes are empty; an empty lane has its owner as partner.
//
//   tile t:  blocks [begin[t] .. own_end[t])   own: the owner is i, the partner is j
//            blocks [own_end[t] .. begin[t+1]) imported: the owner is j, i is in another tile; the
//                                              contact is evaluated here too, from the same bits
//   block b: owner[16 b .. 16 b + 16), rows [row_begin[b] .. row_begin[b+1])
//   row r:   partner[16 r .. 16 r + 16), history of kHistory (rolling: kRollingHistory) x 16 numbers:
//            tangential spring x y z, force on i in the last step x y z, rolling moment x y z
//
// A slot is 16 r + lane; the slots of an owner are kPairPad apart. i is the partner with the smaller
// radius, ties by lower identity, for life. What a step reads of slots is one stream, and the owner's
// side of a row costs nothing but additions in registers.
#pragma once

#include <algorithm>
#include <vector>

#include "soa/column.h"
#include "soa/state.h"

namespace quern {

inline constexpr std::size_t kPairPad = 16;  // the widest vector of f32
inline constexpr std::size_t kHistory = 6, kRollingHistory = 9;  // numbers a slot

template <class Real>
struct PairBatch {
  Column<Index> owner, row_begin, partner;
  Column<Real> numbers;
  Column<Index> begin, own_end;
  bool rolling = false;

  std::size_t history() const { return rolling ? kRollingHistory : kHistory; }
  std::size_t slots() const { return partner.size(); }
  std::size_t blocks() const { return owner.size() / kPairPad; }
  // Number k of a slot's history, k as in the drawing.
  Real& number(std::size_t slot, std::size_t k) { return numbers[place_of(slot, k)]; }
  Real number(std::size_t slot, std::size_t k) const { return numbers[place_of(slot, k)]; }
  bool is_open(std::size_t slot) const {
    for (std::size_t k = 0; k < kHistory; ++k) {
      if (number(slot, k) != 0) return true;
    }
    return false;
  }
  // Rows without any history.
  void clear_rows(std::size_t first, std::size_t rows) {
    std::fill_n(numbers.data() + first * kPairPad * history(), rows * kPairPad * history(),
                Real(0));
  }
  // f(slot, i, j) for every pair that a tile lists, of its own part or of its imported one.
  enum class Part { kOwn, kImported };
  template <class F>
  void for_each(std::size_t tile, Part part, const F& f) const {
    const bool own = part == Part::kOwn;
    const Index last = own ? own_end[tile] : begin[tile + 1];
    for (Index block = own ? begin[tile] : own_end[tile]; block < last; ++block) {
      for (std::size_t row = row_begin[block]; row < row_begin[block + 1]; ++row) {
        for (std::size_t lane = 0; lane < kPairPad; ++lane) {
          const Index here = owner[block * kPairPad + lane], other = partner[row * kPairPad + lane];
          if (here != other) f(row * kPairPad + lane, own ? here : other, own ? other : here);
        }
      }
    }
  }

  void reset(std::size_t blocks, std::size_t rows) {
    owner.reset(blocks * kPairPad);
    row_begin.reset(blocks + 1);
    partner.reset(rows * kPairPad);
    numbers.reset(rows * kPairPad * history());
  }
  void visit(StateVisitor& v) {
    v.column("pairs/owner", "1", owner, 1);
    v.column("pairs/row_begin", "1", row_begin, 1);
    v.column("pairs/partner", "1", partner, 1);
    v.column("pairs/history", "m, N, N m", numbers, kPairPad);
    v.column("pairs/begin", "1", begin, 1);
    v.column("pairs/own_end", "1", own_end, 1);
  }

 private:
  std::size_t place_of(std::size_t slot, std::size_t k) const {
    return (slot / kPairPad * history() + k) * kPairPad + slot % kPairPad;
  }
};

}  // namespace quern
