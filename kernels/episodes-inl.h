// What the contacts of a vector tell of their collisions, see soa/collisions.h and PairCollisions.
#if defined(QUERN_EPISODES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_EPISODES_INL_H_
#undef QUERN_EPISODES_INL_H_
#else
#define QUERN_EPISODES_INL_H_
#endif

#include "kernels/pair_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// Lanes whose bit is set, side by side at the front. Up to eight lanes by a table of their numbers.
template <class D>
HWY_INLINE hn::Vec<D> to_front(D d, hn::Vec<D> v, std::uint32_t bits) {
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  if constexpr (kLanes == 1) return v;
  if constexpr (kLanes == 16) {
    const std::uint16_t word = static_cast<std::uint16_t>(bits);
    alignas(8) std::uint8_t bytes[8];
    std::memcpy(bytes, &word, sizeof word);
    return hn::Compress(v, hn::LoadMaskBits(d, bytes));
  }
  const hn::Rebind<std::uint8_t, D> bytes;
  const auto lanes = hn::PromoteTo(d, hn::LoadU(bytes, kSetBits.lane[bits & 0xff]));
  return hn::TableLookupLanes(v, hn::IndicesFromVec(d, lanes));
}
// The same of numbers, in whatever way is cheap.
template <class V>
HWY_INLINE V numbers_to_front(V v, std::uint32_t bits) {
  const hn::DFromV<V> d;
  if constexpr (sizeof(hn::TFromV<V>) == sizeof(float)) {
    const hn::RebindToUnsigned<decltype(d)> du;
    return hn::BitCast(d, to_front(du, hn::BitCast(du, v), bits));
  } else {
    std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits)};
    return hn::Compress(v, hn::LoadMaskBits(d, bytes));
  }
}
template <class D, class M>
HWY_INLINE std::uint32_t bits_of(D d, M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

// The episode of each lane in its history: a sum, what its rounding has left, energy of approach.
template <class V>
using EpisodeV = V[kEpisodeHistory];

// ContactEnergies by kind: in Real over a few contacts, in f64 over all of a tile.
template <class V>
struct KindsV {
  V few[kMostPairKinds][4];
  hn::Vec<D64> sums[kMostPairKinds][4];
};
template <class V>
HWY_INLINE void clear_few(std::size_t kinds, KindsV<V>& k) {
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (V& v : k.few[kind]) v = hn::Zero(hn::DFromV<V>());
  }
}
template <class V>
HWY_INLINE void clear_sums(std::size_t kinds, KindsV<V>& k) {
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (auto& v : k.sums[kind]) v = hn::Zero(D64());
  }
}
template <class Real, class V>
HWY_INLINE void add_few(std::size_t kinds, KindsV<V>& k) {
  for (std::size_t kind = 1; kind < kinds; ++kind) {
    for (std::size_t n = 0; n < 4; ++n) {
      k.sums[kind][n] = hn::Add(k.sums[kind][n], folded_f64<Real>(k.few[kind][n]));
    }
  }
}
template <class V>
HWY_INLINE void add_sums(std::size_t kinds, const KindsV<V>& k, const TallySumV& all,
                         double* energies) {
  const hn::Vec<D64> of_all[4] = {all.work, all.elastic, all.slide, all.tangential_damping};
  for (std::size_t n = 0; n < 4; ++n) {
    double left = sum_lanes(of_all[n]);
    for (std::size_t kind = 1; kind < kinds; ++kind) {
      const double sum = sum_lanes(k.sums[kind][n]);
      energies[4 * kind + n] += sum;
      left -= sum;
    }
    energies[n] += left;
  }
}

// Of each lane's pair of groups, as a number in Real.
template <class Real, class I>
HWY_INLINE hn::Vec<Lanes<Real>> pair_kinds(Index groups, I a, I b) {
  using D = hn::RebindToSigned<Lanes<Real>>;
  const D di;
  const I low = hn::Min(a, b), high = hn::Max(a, b);
  // pair_kind(), with the triangle by a shift.
  const I all = hn::Set(di, static_cast<hn::TFromD<D>>(groups)), one = hn::Set(di, 1);
  const I triangle = hn::ShiftRight<1>(hn::Mul(low, hn::Add(low, one)));
  return hn::ConvertTo(Lanes<Real>(), hn::Add(hn::Sub(hn::Mul(low, all), triangle), high));
}

// Adds those lanes of `v` that are in `mask`.
template <class V, class M>
HWY_INLINE V add_masked(V sum, M mask, V v) {
#if QUERN_AVX512
  if constexpr (sizeof(hn::TFromV<V>) == sizeof(float)) {
    return V{_mm512_mask_add_ps(sum.raw, mask.raw, sum.raw, v.raw)};
  } else {
    return V{_mm512_mask_add_pd(sum.raw, mask.raw, sum.raw, v.raw)};
  }
#else
  return hn::Add(sum, hn::IfThenElseZero(mask, v));
#endif
}

// Of contacts that begin or end: in a step few do.
struct Changes {
  std::uint32_t begun, ended;  // a bit a lane
};
template <class D, class M>
HWY_INLINE Changes changes_of(D d, M touching, M open) {
  const std::uint32_t now = bits_of(d, touching), before = bits_of(d, open);
  return {now & ~before, before & ~now};
}
template <class V>
HWY_INLINE V energy_of(V speed2, V inverse_mass) {
  return hn::Div(hn::Mul(hn::Set(hn::DFromV<V>(), hn::TFromV<V>(0.5)), speed2), inverse_mass);
}

// What the force kernel tells of a vector of contacts.
template <class V>
struct ToldV {
  V energies[4];  // as ContactEnergies
  V kind;
};
template <class V>
HWY_INLINE void tell(const ResponseV<V>& r, V kind, ToldV<V>& to) {
  to = {{r.work, r.elastic, r.slide, r.tangential_damping}, kind};
}

// The step of a vector of contacts: W taken from the sums of their episodes.
template <class Real, class V>
HWY_INLINE void follow_episodes(Recording recording, const ToldV<V>& told, EpisodeV<V>& e) {
  const Lanes<Real> d;
  const V work = told.energies[0];
  if (HWY_UNLIKELY(recording == Recording::kOpening)) {
    e[0] = told.energies[1];
    e[1] = e[2] = hn::Zero(d);
    return;
  }
  // Sum and rounding error of it (Knuth 1969): right whichever is larger.
  const V sum = hn::Sub(e[0], work), taken = hn::Sub(sum, e[0]);
  const V error = hn::Sub(hn::Sub(e[0], hn::Sub(sum, taken)), hn::Add(work, taken));
  e[0] = sum;
  e[1] = hn::Add(e[1], error);
}

// Energies by kind; those of the first kind are what the others leave of all.
template <class Real, class V>
HWY_INLINE void add_to_kinds(std::size_t kinds, const ToldV<V>* told, std::size_t vectors,
                             KindsV<V>& to) {
  for (std::size_t k = 1; k < kinds; ++k) {
    const V this_kind = hn::Set(Lanes<Real>(), static_cast<Real>(k));
    V sum[4] = {to.few[k][0], to.few[k][1], to.few[k][2], to.few[k][3]};
    for (std::size_t v = 0; v < vectors; ++v) {
      const auto mine = hn::Eq(told[v].kind, this_kind);
      for (std::size_t n = 0; n < 4; ++n) sum[n] = add_masked(sum[n], mine, told[v].energies[n]);
    }
    for (std::size_t n = 0; n < 4; ++n) to.few[k][n] = sum[n];
  }
}

// Episodes of own contacts that began or ended. Vectors come by value: an address would have them
// all written to memory for the few contacts that change.
template <class Real, class V>
HWY_NOINLINE void tell_changes(Changes changes, V kind, V dissipated, V approach, V impact,
                               PairCollisions<Real>& to) {
  const Lanes<Real> d;
  const hn::RebindToSigned<Lanes<Real>> di;
  const auto store_kinds = [&](std::uint32_t bits, Index* at) HWY_ATTR {
    HWY_ALIGN hn::TFromD<decltype(di)> lane[hn::MaxLanes(di)];
    hn::Store(hn::ConvertTo(di, numbers_to_front(kind, bits)), di, lane);
    for (int k = 0; k < __builtin_popcount(bits); ++k) at[k] = static_cast<Index>(lane[k]);
  };
  if (const std::uint32_t ended = changes.ended; ended != 0) {
    hn::StoreU(numbers_to_front(dissipated, ended), d, to.dissipated + to.ended);
    hn::StoreU(numbers_to_front(approach, ended), d, to.approach + to.ended);
    store_kinds(ended, to.ended_kind + to.ended);
    to.ended += static_cast<std::size_t>(__builtin_popcount(ended));
  }
  if (const std::uint32_t begun = changes.begun; begun != 0) {
    hn::StoreU(numbers_to_front(impact, begun), d, to.impact + to.begun);
    store_kinds(begun, to.begun_kind + to.begun);
    to.begun += static_cast<std::size_t>(__builtin_popcount(begun));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
