#include "kernels/tile_pairs.h"

#include <utility>

namespace quern {

template <class Real>
void push_tile_pairs(const Kernels<Real>& kernels, const StepConstants<Real>& step,
                     const ParticleView<Real>& particles, PairBatch<Real>& pairs, std::size_t tile,
                     const TileRows& rows, PairScratch<Real>& scratch, ContactTally& tally) {
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
  FoundPairs found = {scratch.i.data(), scratch.j.data(), scratch.state.data()};
  kernels.find_pairs(step, particles, view, found);
  ContactHistory<Real>& old = pairs.contacts[tile];
  scratch.spare.reset(found.touching, pairs.history());
  kernels.push_pairs(step, particles, found, old.view(), scratch.spare.view(), rows, tally);
  std::swap(old, scratch.spare);
}

template void push_tile_pairs(const Kernels<float>&, const StepConstants<float>&,
                              const ParticleView<float>&, PairBatch<float>&, std::size_t,
                              const TileRows&, PairScratch<float>&, ContactTally&);
template void push_tile_pairs(const Kernels<double>&, const StepConstants<double>&,
                              const ParticleView<double>&, PairBatch<double>&, std::size_t,
                              const TileRows&, PairScratch<double>&, ContactTally&);

}  // namespace quern
