#include "kernels/tile_pairs.h"

#include <cmath>

namespace quern {

namespace {

// Many short columns, which the law will read after a pass that does not.
template <class Real>
void prefetch(const ContactHistory<Real>& contacts, std::size_t history) {
  constexpr std::size_t kInLine = 64 / sizeof(Real);
  for (std::size_t k = 0; k < history; ++k) {
    const Real* numbers = contacts.numbers.data() + k * contacts.stride;
    for (std::size_t c = 0; c < contacts.count; c += kInLine) {
      __builtin_prefetch(numbers + c, 0, 2);
    }
  }
}

// Room for what the contacts of a tile may tell.
template <class Real>
PairCollisions<Real> make_room(std::size_t contacts, std::size_t kinds,
                               PairScratch<Real>& scratch) {
  scratch.energies.assign(kinds, ContactEnergies());
  for (Column<Real>* c : {&scratch.dissipated, &scratch.approach, &scratch.impact}) {
    c->reset(contacts + kPairPad);
  }
  for (Column<Index>* c : {&scratch.ended_kind, &scratch.begun_kind}) c->reset(contacts + kPairPad);
  return {&scratch.energies.data()->work, scratch.dissipated.data(), scratch.approach.data(),
          scratch.ended_kind.data(),      scratch.impact.data(),     scratch.begun_kind.data()};
}

// To the kinds of the scene, which has walls as well.
template <class Real>
void hand_over(const PairCollisions<Real>& found, const PairScratch<Real>& scratch,
               CollisionTally& collisions) {
  const Groups& groups = collisions.groups();
  std::size_t kind_of[kMostPairKinds];
  const std::size_t among = groups.of_particles();
  for (std::size_t a = 0; a < among; ++a) {
    for (std::size_t b = a; b < among; ++b) {
      const std::size_t kind = pair_kind(among, a, b);
      kind_of[kind] = groups.kind(a, b);
      collisions.add(kind_of[kind], scratch.energies[kind]);
    }
  }
  for (std::size_t k = 0; k < found.ended; ++k) {
    collisions.end_episode(kind_of[found.ended_kind[k]], static_cast<double>(found.dissipated[k]),
                           static_cast<double>(found.approach[k]));
  }
  for (std::size_t k = 0; k < found.begun; ++k) {
    collisions.begin_episode(kind_of[found.begun_kind[k]], static_cast<double>(found.impact[k]));
  }
}

}  // namespace

template <class Real>
void push_tile_pairs(const Kernels<Real>& kernels, const StepConstants<Real>& step,
                     const ParticleView<Real>& particles, PairBatch<Real>& pairs, std::size_t tile,
                     const TileRows& rows, PairScratch<Real>& scratch, ContactTally& tally,
                     CollisionTally* collisions) {
  const std::size_t begin = pairs.begin[tile], end = pairs.begin[tile + 1];
  const PairView<Real> view = {pairs.owner.data() + begin * kPairPad,
                               pairs.row_begin.data() + begin,
                               pairs.partner.data(),
                               pairs.open.data(),
                               pairs.first_contact.data(),
                               pairs.own_end[tile] - begin,
                               end - begin};
  const std::size_t rows_here = pairs.row_begin[end] - pairs.row_begin[begin];
  for (Column<Index>* c : {&scratch.i, &scratch.j, &scratch.state}) {
    c->reset((rows_here + 1) * kPairPad);
  }
  ContactHistory<Real>& old = pairs.contacts[tile];
  prefetch(old, pairs.history());
  FoundPairs& found = scratch.found;
  found = {scratch.i.data(), scratch.j.data(), scratch.state.data()};
  kernels.find_pairs(step, particles, view, found);
  if (collisions == nullptr) {
    scratch.spare.reset(found.touching, pairs.history());
    kernels.push_pairs(step, particles, found, old.view(), scratch.spare.view(), rows, tally,
                       nullptr);
  } else {
    scratch.spare.reset(found.touching, pairs.law_history() + kEpisodeHistory);
    const std::size_t among = collisions->groups().of_particles();
    PairCollisions<Real> told = make_room(found.own, pair_kinds_among(among), scratch);
    kernels.push_pairs(step, particles, found, old.view(), scratch.spare.view(), rows, tally,
                       &told);
    hand_over(told, scratch, *collisions);
  }
  std::swap(old, scratch.spare);
}

template <class Real>
std::optional<std::pair<Index, Index>> find_odd_history(const PairScratch<Real>& scratch,
                                                        std::size_t law_history) {
  const FoundPairs& found = scratch.found;
  const ContactHistory<Real>& old = scratch.spare;
  std::size_t contact = 0;
  for (const auto& [first, count] :
       {std::pair(std::size_t{0}, found.own), std::pair(found.imported_begin(), found.imported)}) {
    for (std::size_t k = first; k < first + count; ++k) {
      if ((found.state[k] & kDidTouch) == 0) continue;
      for (std::size_t n = 0; n < law_history; ++n) {
        if (!std::isfinite(old.number(contact, n))) return std::pair(found.i[k], found.j[k]);
      }
      ++contact;
    }
  }
  return std::nullopt;
}

template std::optional<std::pair<Index, Index>> find_odd_history(const PairScratch<float>&,
                                                                 std::size_t);
template std::optional<std::pair<Index, Index>> find_odd_history(const PairScratch<double>&,
                                                                 std::size_t);
template void push_tile_pairs(const Kernels<float>&, const StepConstants<float>&,
                              const ParticleView<float>&, PairBatch<float>&, std::size_t,
                              const TileRows&, PairScratch<float>&, ContactTally&, CollisionTally*);
template void push_tile_pairs(const Kernels<double>&, const StepConstants<double>&,
                              const ParticleView<double>&, PairBatch<double>&, std::size_t,
                              const TileRows&, PairScratch<double>&, ContactTally&,
                              CollisionTally*);

}  // namespace quern
