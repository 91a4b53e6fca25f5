// PairBatch: the listed pairs of one pair type, tile by tile, and the histories of those that
// touch.
//
// A block is kPairPad owners, one a lane; a row of a block is one partner of each. Owners with
// equally many partners stand together, so that few lanes are empty; an empty lane has its owner as
// partner.
//
//   tile t:  blocks [begin[t] .. own_end[t])   own: the owner is i, the partner is j
//            blocks [own_end[t] .. begin[t+1]) imported: the owner is j, i is in another tile; the
//                                              contact is evaluated here too, from the same bits
//   block b: owner[16 b .. 16 b + 16), rows [row_begin[b] .. row_begin[b+1])
//   row r:   partner[16 r .. 16 r + 16)
//            open[r]: a bit for each lane that touched in the last step
//
// A slot is 16 r + lane; the slots of an owner are kPairPad apart. i is the partner with the
// smaller radius, ties by lower identity, for life. Most slots do not touch: only contacts have a
// history, in the order of rows and lanes, and first_contact[r] says how many come before row r in
// its tile.
#pragma once

#include <algorithm>
#include <vector>

#include "soa/column.h"
#include "soa/state.h"

namespace quern {

inline constexpr std::size_t kPairPad = 16;                       // the widest vector of f32
inline constexpr std::size_t kHistory = 9, kRollingHistory = 12;  // numbers a contact
// And of own ones while collisions are recorded: energy of its episode (see soa/collisions.h) as a
// sum and what its rounding has left, energy of approach.
inline constexpr std::size_t kEpisodeHistory = 3;

// Number k of contact c is numbers[k * stride + c]; vectors may be loaded and stored past the end.
template <class Real>
struct HistoryView {
  Real* numbers;
  std::size_t stride;
};

// What the contacts of a tile remember: tangential spring x y z, force on i in the last step x y z,
// what rounding has left of the spring x y z, rolling moment x y z, episode.
template <class Real>
struct ContactHistory {
  Column<Real> numbers;
  std::size_t count = 0, stride = 0;
  // Room for so many contacts of so many numbers; what was there is lost.
  void reset(std::size_t contacts, std::size_t history) {
    count = contacts;
    stride = (contacts + 2 * kPairPad - 1) / kPairPad * kPairPad;
    // Contacts come and go: with some room to spare it need not grow in every other step.
    const std::size_t needed = history * stride;
    if (numbers.size() < needed) numbers.reset(needed + needed / 8);
  }
  HistoryView<Real> view() { return {numbers.data(), stride}; }
  Real& number(std::size_t contact, std::size_t k) { return numbers[k * stride + contact]; }
  Real number(std::size_t contact, std::size_t k) const { return numbers[k * stride + contact]; }
};

template <class Real>
struct PairBatch {
  Column<Index> owner, row_begin, partner;
  Column<std::uint16_t> open;
  Column<Index> first_contact;                 // not saved
  std::vector<ContactHistory<Real>> contacts;  // of each tile
  Column<Index> begin, own_end;
  bool rolling = false;
  bool episodes = false;  // contacts have one

  std::size_t law_history() const { return rolling ? kRollingHistory : kHistory; }
  std::size_t history() const { return law_history() + (episodes ? kEpisodeHistory : 0); }
  std::size_t slots() const { return partner.size(); }
  std::size_t blocks() const { return owner.size() / kPairPad; }
  std::size_t tiles() const { return own_end.size(); }
  bool is_open(std::size_t slot) const {
    return (open[slot / kPairPad] >> slot % kPairPad & 1) != 0;
  }
  std::size_t tile_of(std::size_t slot) const {
    const auto after = [&](std::size_t row, Index block) { return row < row_begin[block]; };
    return static_cast<std::size_t>(
        std::upper_bound(begin.begin() + 1, begin.end(), slot / kPairPad, after) - begin.begin() -
        1);
  }
  // Of an open slot: which of its tile's contacts it is.
  Index contact_of(std::size_t slot) const {
    const std::uint32_t before = open[slot / kPairPad] & ((1u << slot % kPairPad) - 1);
    return first_contact[slot / kPairPad] + static_cast<Index>(__builtin_popcount(before));
  }
  Real& number(std::size_t tile, std::size_t slot, std::size_t k) {
    return contacts[tile].number(contact_of(slot), k);
  }
  // 0 if it is not open.
  Real number(std::size_t tile, std::size_t slot, std::size_t k) const {
    return is_open(slot) ? contacts[tile].number(contact_of(slot), k) : Real(0);
  }
  // Sets first_contact from the open slots; returns the contacts of each tile.
  std::vector<Index> count_contacts() {
    std::vector<Index> of_tile;
    first_contact.reset(open.size());
    for (std::size_t tile = 0; tile < tiles(); ++tile) {
      Index count = 0;
      for (std::size_t row = row_begin[begin[tile]]; row < row_begin[begin[tile + 1]]; ++row) {
        first_contact[row] = count;
        count += static_cast<Index>(__builtin_popcount(open[row]));
      }
      of_tile.push_back(count);
    }
    return of_tile;
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
    open.reset(rows);
    first_contact.reset(rows);
  }
  void visit(StateVisitor& v) {
    v.column("pairs/owner", "1", owner, 1);
    v.column("pairs/row_begin", "1", row_begin, 1);
    v.column("pairs/partner", "1", partner, 1);
    v.column("pairs/open", "1", open, 1);
    Column<Real> numbers = gathered();
    v.column("pairs/history", "m, N, N m", numbers, history());
    v.column("pairs/begin", "1", begin, 1);
    v.column("pairs/own_end", "1", own_end, 1);
    scatter(numbers);
  }

 private:
  // Of a tile; they come first.
  std::size_t own_contacts(std::size_t tile) const {
    const Index row = row_begin[own_end[tile]];
    return row < row_begin[begin[tile + 1]] ? first_contact[row] : contacts[tile].count;
  }
  // Histories of all tiles, contact after contact; zeros for the episodes of imported ones.
  Column<Real> gathered() const {
    Column<Real> all;
    std::size_t contacts_of_all = 0, at = 0;
    for (const auto& tile : contacts) contacts_of_all += tile.count;
    all.reset(contacts_of_all * history());
    for (std::size_t tile = 0; tile < contacts.size(); ++tile) {
      const std::size_t own = own_contacts(tile);
      for (std::size_t c = 0; c < contacts[tile].count; ++c) {
        const std::size_t numbers = c < own ? history() : law_history();
        for (std::size_t k = 0; k < history(); ++k) {
          all[at++] = k < numbers ? contacts[tile].number(c, k) : Real(0);
        }
      }
    }
    return all;
  }
  void scatter(const Column<Real>& all) {
    const std::vector<Index> of_tile = count_contacts();
    std::size_t at = 0;
    contacts.resize(of_tile.size());
    for (std::size_t tile = 0; tile < of_tile.size(); ++tile) {
      contacts[tile].reset(of_tile[tile], history());
      QUERN_CHECK(at + of_tile[tile] * history() <= all.size());
      for (std::size_t c = 0; c < of_tile[tile]; ++c) {
        for (std::size_t k = 0; k < history(); ++k) contacts[tile].number(c, k) = all[at++];
      }
    }
  }
};

}  // namespace quern
