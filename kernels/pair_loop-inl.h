// What the contact loops of all pair types share: loading partners into lanes, writing history back,
// adding up tallies. Lanes are contacts; a lane's result depends on its two partners alone, never on
// its neighbours or its place, so that the two copies of a cross-tile contact have the same bits.
#if defined(QUERN_PAIR_LOOP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_PAIR_LOOP_INL_H_
#undef QUERN_PAIR_LOOP_INL_H_
#else
#define QUERN_PAIR_LOOP_INL_H_
#endif

#include "kernels/laws/linear_spring_dashpot-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// As many partners as an f64 vector has lanes.
template <class Real>
struct PartnerV {
  Vec3V<hn::Vec<D64>> place, velocity;
  Vec3V<hn::Vec<HalfLanes<Real>>> spin;
  hn::Vec<HalfLanes<Real>> radius, inverse_mass, contacts;
  hn::Vec<hn::RebindToSigned<HalfLanes<Real>>> material;
};

// u32 lanes as the signed integer lanes that go with Real.
template <class Real, class V>
HWY_INLINE auto to_index(V v) {
  if constexpr (sizeof(Real) == sizeof(double)) {
    return hn::PromoteTo(D64I(), hn::BitCast(D32I(), v));
  } else {
    return hn::BitCast(D32I(), v);
  }
}

#if QUERN_ROWS_IN_REGISTERS
// Eight 64-byte records turned in registers: a third of the cost of ten gathers. The last two columns
// hold (wx, wy) and (wz, radius) as pairs of f32.
HWY_INLINE void load_columns(const Record<float>* record, const Index* lane, V64 (&c)[8]) {
  // Halves of two records are loaded into one register, in the order that leaves the lanes sorted
  // after two rounds of shuffles instead of three.
  const auto pair = [&](int low, int high, int half) HWY_ATTR {
    const double* a = reinterpret_cast<const double*>(record + lane[low]) + 4 * half;
    const double* b = reinterpret_cast<const double*>(record + lane[high]) + 4 * half;
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(a)), _mm256_load_pd(b), 1);
  };
  const auto turn = [&](int half, V64* to) HWY_ATTR {
    const __m512d r02 = pair(0, 2, half), r13 = pair(1, 3, half);
    const __m512d r46 = pair(4, 6, half), r57 = pair(5, 7, half);
    const __m512d even_a = _mm512_unpacklo_pd(r02, r13), odd_a = _mm512_unpackhi_pd(r02, r13);
    const __m512d even_b = _mm512_unpacklo_pd(r46, r57), odd_b = _mm512_unpackhi_pd(r46, r57);
    to[0] = V64{_mm512_shuffle_f64x2(even_a, even_b, 0x88)};
    to[1] = V64{_mm512_shuffle_f64x2(odd_a, odd_b, 0x88)};
    to[2] = V64{_mm512_shuffle_f64x2(even_a, even_b, 0xdd)};
    to[3] = V64{_mm512_shuffle_f64x2(odd_a, odd_b, 0xdd)};
  };
  turn(0, c);
  turn(1, c + 4);
}
HWY_INLINE void load_rows(const ParticleView<float>& p, const Index* lane, PartnerV<float>& out) {
  V64 c[8];
  load_columns(p.record, lane, c);
  out.place = {c[0], c[1], c[2]};
  out.velocity = {c[3], c[4], c[5]};
  const __m512i low = _mm512_castpd_si512(c[6].raw), high = _mm512_castpd_si512(c[7].raw);
  const auto even = [](__m512i v) {
    return hn::Vec<HalfLanes<float>>{_mm256_castsi256_ps(_mm512_cvtepi64_epi32(v))};
  };
  out.spin = {even(low), even(_mm512_srli_epi64(low, 32)), even(high)};
  out.radius = even(_mm512_srli_epi64(high, 32));
}
#endif

template <class Real>
HWY_INLINE void gather_rows(const ParticleView<Real>& p, const Index* lane, PartnerV<Real>& out) {
  const HalfLanes<Real> dr;
  constexpr int kF64PerRecord = sizeof(Record<Real>) / sizeof(double);
  constexpr int kRealPerRecord = sizeof(Record<Real>) / sizeof(Real);
  const auto index = hn::LoadU(D32U(), lane);
  const auto wide = hn::PromoteTo(D64I(), hn::BitCast(D32I(), index));
  const auto at = hn::Mul(wide, hn::Set(D64I(), kF64PerRecord));
  const double* base = &p.record->x;
  const auto f64 = [&](int field) HWY_ATTR { return hn::GatherIndex(D64(), base + field, at); };
  out.place = {f64(0), f64(1), f64(2)};
  out.velocity = {f64(3), f64(4), f64(5)};
  const hn::RebindToSigned<HalfLanes<Real>> di;
  const auto at_real =
      hn::Mul(to_index<Real>(index), hn::Set(di, static_cast<hn::TFromD<decltype(di)>>(kRealPerRecord)));
  const Real* reals = &p.record->wx;
  const auto real = [&](int field) HWY_ATTR { return hn::GatherIndex(dr, reals + field, at_real); };
  out.spin = {real(0), real(1), real(2)};
  out.radius = real(3);
}

// A tag as lanes: material and number of contacts.
template <class Real, class V>
HWY_INLINE void set_tag(V tag, PartnerV<Real>& out) {
  const hn::DFromV<V> d;
  out.material = hn::And(tag, hn::Set(d, 0xffff));
  out.contacts = hn::ConvertTo(HalfLanes<Real>(), hn::ShiftRight<16>(tag));
}
HWY_INLINE void load_traits(const Traits<double>* traits, const Index* lane, PartnerV<double>& out) {
  const D64I d;
  const auto index = hn::PromoteTo(d, hn::BitCast(D32I(), hn::LoadU(D32U(), lane)));
  const auto at = hn::Add(index, index);
  out.inverse_mass = hn::GatherIndex(D64(), &traits->inverse_mass, at);
  set_tag(hn::GatherIndex(d, reinterpret_cast<const std::int64_t*>(&traits->tag), at), out);
}
#if QUERN_ROWS_IN_REGISTERS
// Mass and tag of eight particles as eight f64 lanes.
HWY_INLINE V64 load_traits_bits(const Traits<float>* traits, const Index* lane) {
  const auto two = [&](int low) HWY_ATTR {
    const double* a = reinterpret_cast<const double*>(traits + lane[low]);
    const double* b = reinterpret_cast<const double*>(traits + lane[low + 1]);
    return _mm_loadh_pd(_mm_load_sd(a), b);
  };
  const __m256d low = _mm256_insertf128_pd(_mm256_castpd128_pd256(two(0)), two(2), 1);
  const __m256d high = _mm256_insertf128_pd(_mm256_castpd128_pd256(two(4)), two(6), 1);
  return V64{_mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1)};
}
#endif
HWY_INLINE void load_traits(const Traits<float>* traits, const Index* lane, PartnerV<float>& out) {
#if QUERN_ROWS_IN_REGISTERS
  const auto both = load_traits_bits(traits, lane);
#else
  const auto both = hn::GatherIndex(
      D64I(), reinterpret_cast<const std::int64_t*>(traits),
      hn::PromoteTo(D64I(), hn::BitCast(D32I(), hn::LoadU(D32U(), lane))));
#endif
  // The low half of each lane is the inverse mass, the high half is the tag.
  const auto bits = hn::BitCast(hn::RebindToUnsigned<D64>(), both);
  out.inverse_mass = hn::BitCast(HalfLanes<float>(), hn::TruncateTo(D32U(), bits));
  set_tag(hn::BitCast(D32I(), hn::TruncateTo(D32U(), hn::ShiftRight<32>(bits))), out);
}

template <class Real>
HWY_INLINE PartnerV<Real> load_partner(const ParticleView<Real>& p, const Index* lane) {
  PartnerV<Real> out;
#if QUERN_ROWS_IN_REGISTERS
  if constexpr (sizeof(Real) == sizeof(float)) {
    load_rows(p, lane, out);
  } else {
    gather_rows(p, lane, out);
  }
#else
  gather_rows(p, lane, out);
#endif
  load_traits(p.traits, lane, out);
  return out;
}

// A full vector of partners is loaded in halves, so that the f64 places and velocities of one half are
// used up before the next one needs the registers; the rest is joined to vectors of Real lanes.
#if QUERN_ROWS_IN_REGISTERS
struct PackedRestV {
  V64 low, high, traits;  // pairs of f32: (wx, wy), (wz, radius), (inverse mass, tag)
};
#endif
template <class Real>
struct HalfPartnersV {
  Vec3V<hn::Vec<D64>> place, velocity;
#if QUERN_ROWS_IN_REGISTERS
  std::conditional_t<sizeof(Real) == sizeof(float), PackedRestV, PartnerV<Real>> rest;
#else
  PartnerV<Real> rest;
#endif
};
template <class Real>
struct PartnersV {
  using V = hn::Vec<Lanes<Real>>;
  Vec3V<V> spin;
  V radius, inverse_mass, contacts;
  hn::Vec<hn::RebindToSigned<Lanes<Real>>> material;
};

template <class Real>
HWY_INLINE HalfPartnersV<Real> load_half(const ParticleView<Real>& p, const Index* lane) {
#if QUERN_ROWS_IN_REGISTERS
  if constexpr (sizeof(Real) == sizeof(float)) {
    V64 c[8];
    load_columns(p.record, lane, c);
    return {{c[0], c[1], c[2]},
            {c[3], c[4], c[5]},
            {c[6], c[7], load_traits_bits(p.traits, lane)}};
  } else {
    const PartnerV<Real> all = load_partner(p, lane);
    return {all.place, all.velocity, all};
  }
#else
  const PartnerV<Real> all = load_partner(p, lane);
  return {all.place, all.velocity, all};
#endif
}

#if QUERN_ROWS_IN_REGISTERS
HWY_INLINE PartnersV<float> join_partners(const HalfPartnersV<float>& low,
                                          const HalfPartnersV<float>& high) {
  const Lanes<float> d;
  const auto even = [&](V64 l, V64 h) HWY_ATTR {
    return hn::ConcatEven(d, hn::BitCast(d, h), hn::BitCast(d, l));
  };
  const auto odd = [&](V64 l, V64 h) HWY_ATTR {
    return hn::ConcatOdd(d, hn::BitCast(d, h), hn::BitCast(d, l));
  };
  const PackedRestV &l = low.rest, &h = high.rest;
  const auto tag = hn::BitCast(hn::RebindToSigned<Lanes<float>>(), odd(l.traits, h.traits));
  return {{even(l.low, h.low), odd(l.low, h.low), even(l.high, h.high)},
          odd(l.high, h.high),
          even(l.traits, h.traits),
          hn::ConvertTo(d, hn::ShiftRight<16>(tag)),
          hn::And(tag, hn::Set(hn::DFromV<decltype(tag)>(), 0xffff))};
}
HWY_INLINE PartnersV<double> join_partners(const HalfPartnersV<double>& low,
                                           const HalfPartnersV<double>&) {
  const PartnerV<double>& l = low.rest;
  return {l.spin, l.radius, l.inverse_mass, l.contacts, l.material};
}
#else
template <class Real>
HWY_INLINE PartnersV<Real> join_partners(const HalfPartnersV<Real>& low,
                                         const HalfPartnersV<Real>& high) {
  const PartnerV<Real> &l = low.rest, &h = high.rest;
  return {join<Real>(l.spin, h.spin), join<Real>(l.radius, h.radius),
          join<Real>(l.inverse_mass, h.inverse_mass), join<Real>(l.contacts, h.contacts),
          join<Real>(l.material, h.material)};
}
#endif

// Vectors of three: as three columns, or as three runs `stride` numbers apart.
template <class V>
HWY_INLINE Vec3V<V> load3(hn::TFromV<V>* const (&from)[3], std::size_t at) {
  const hn::DFromV<V> d;
  return {hn::LoadU(d, from[0] + at), hn::LoadU(d, from[1] + at), hn::LoadU(d, from[2] + at)};
}
template <class V>
HWY_INLINE void store3(const Vec3V<V>& v, hn::TFromV<V>* const (&to)[3], std::size_t at) {
  const hn::DFromV<V> d;
  hn::StoreU(v.x, d, to[0] + at);
  hn::StoreU(v.y, d, to[1] + at);
  hn::StoreU(v.z, d, to[2] + at);
}
template <class V>
HWY_INLINE Vec3V<V> load3(const hn::TFromV<V>* from, std::size_t stride) {
  const hn::DFromV<V> d;
  return {hn::LoadU(d, from), hn::LoadU(d, from + stride), hn::LoadU(d, from + 2 * stride)};
}
template <class V>
HWY_INLINE void store3(const Vec3V<V>& v, hn::TFromV<V>* to, std::size_t stride) {
  const hn::DFromV<V> d;
  hn::StoreU(v.x, d, to);
  hn::StoreU(v.y, d, to + stride);
  hn::StoreU(v.z, d, to + 2 * stride);
}

// Indices as signed lanes that go with full vectors of Real.
template <class Real>
HWY_INLINE hn::Vec<hn::RebindToSigned<Lanes<Real>>> load_index(const Index* from) {
  if constexpr (sizeof(Real) == sizeof(double)) {
    return hn::PromoteTo(D64I(), hn::BitCast(D32I(), hn::LoadU(D32U(), from)));
  } else {
    const hn::RebindToUnsigned<Lanes<Real>> d;
    return hn::BitCast(hn::RebindToSigned<Lanes<Real>>(), hn::LoadU(d, from));
  }
}

// Lane sums of a tally: in Real over the few contacts of a block, in f64 over the blocks of a tile.
template <class V>
struct TallyV {
  V work, elastic, slide, tangential_damping, numerical_loss, deepest;
  std::size_t contacts, warnings;
};
using TallySumV = TallyV<hn::Vec<D64>>;
template <class Real>
HWY_INLINE TallyV<hn::Vec<Lanes<Real>>> zero_tally() {
  const auto z = hn::Zero(Lanes<Real>());
  return {z, z, z, z, z, z, 0, 0};
}
HWY_INLINE TallySumV zero_tally_sum() { return zero_tally<double>(); }
template <class Real, class V, class M>
HWY_INLINE void count_response(const ResponseV<V>& r, M touching, V relative_overlap,
                               TallyV<V>& sum) {
  const Lanes<Real> d;
  sum.work = hn::Add(sum.work, r.work);
  sum.elastic = hn::Add(sum.elastic, r.elastic);
  sum.slide = hn::Add(sum.slide, r.slide);
  sum.tangential_damping = hn::Add(sum.tangential_damping, r.tangential_damping);
  sum.numerical_loss = hn::Add(sum.numerical_loss, r.numerical_loss);
  const V deep = hn::IfThenElseZero(touching, relative_overlap);
  sum.contacts += hn::CountTrue(d, touching);
  sum.warnings += hn::CountTrue(d, hn::Gt(deep, hn::Set(d, Real(0.5))));
  sum.deepest = hn::Max(sum.deepest, deep);
}
template <class Real>
HWY_INLINE void add_block(const TallyV<hn::Vec<Lanes<Real>>>& block, TallySumV& sum) {
  sum.work = hn::Add(sum.work, folded_f64<Real>(block.work));
  sum.elastic = hn::Add(sum.elastic, folded_f64<Real>(block.elastic));
  sum.slide = hn::Add(sum.slide, folded_f64<Real>(block.slide));
  sum.tangential_damping =
      hn::Add(sum.tangential_damping, folded_f64<Real>(block.tangential_damping));
  sum.numerical_loss = hn::Add(sum.numerical_loss, folded_f64<Real>(block.numerical_loss));
  sum.contacts += block.contacts;
  sum.warnings += block.warnings;
  sum.deepest = hn::Max(sum.deepest, hn::Max(half_f64<Real, 0>(block.deepest),
                                             half_f64<Real, 1>(block.deepest)));
}
inline double sum_lanes(hn::Vec<D64> v) {
  HWY_ALIGN double lane[hn::MaxLanes(D64())];
  hn::Store(v, D64(), lane);
  double s = 0;
  for (std::size_t k = 0; k < hn::Lanes(D64()); ++k) s += lane[k];
  return s;
}
inline void add_tally(const TallySumV& v, ContactTally& to) {
  ContactTally t;
  t.work = sum_lanes(v.work);
  t.elastic = sum_lanes(v.elastic);
  t.slide = sum_lanes(v.slide);
  t.tangential_damping = sum_lanes(v.tangential_damping);
  t.numerical_loss = sum_lanes(v.numerical_loss);
  t.contacts = static_cast<double>(v.contacts);
  t.warnings = static_cast<double>(v.warnings);
  HWY_ALIGN double lane[hn::MaxLanes(D64())];
  hn::Store(v.deepest, D64(), lane);
  for (std::size_t k = 0; k < hn::Lanes(D64()); ++k) {
    t.max_overlap = lane[k] > t.max_overlap ? lane[k] : t.max_overlap;
  }
  to.add(t);
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
