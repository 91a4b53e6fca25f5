// What the contact loops of all pair types share: loading partners into lanes, writing history back,
// adding up tallies. Lanes are contacts; a lane's result depends on its two partners alone, never on
// its neighbours or its place, so that the two copies of a cross-tile contact have the same bits.
#if defined(QUERN_PAIR_LOOP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_PAIR_LOOP_INL_H_
#undef QUERN_PAIR_LOOP_INL_H_
#else
#define QUERN_PAIR_LOOP_INL_H_
#endif

#include "kernels/laws/spring_dashpot-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// u32 lanes as the signed integer lanes that go with Real.
template <class Real, class V>
HWY_INLINE auto to_index(V v) {
  if constexpr (sizeof(Real) == sizeof(double)) {
    return hn::PromoteTo(D64I(), hn::BitCast(D32I(), v));
  } else {
    return hn::BitCast(D32I(), v);
  }
}

// Pairs of 32-bit numbers in f64 lanes: the first or the second of each, as f32 lanes.
template <class V>
HWY_INLINE hn::Vec<HalfLanes<float>> first_f32(V pairs) {
  return hn::BitCast(HalfLanes<float>(), hn::TruncateTo(D32U(), hn::BitCast(D64U(), pairs)));
}
template <class V>
HWY_INLINE hn::Vec<HalfLanes<float>> second_f32(V pairs) {
  return hn::BitCast(HalfLanes<float>(),
                     hn::TruncateTo(D32U(), hn::ShiftRight<32>(hn::BitCast(D64U(), pairs))));
}
// The same of two halves, as full vectors.
template <class V>
HWY_INLINE hn::Vec<Lanes<float>> first_f32(V low, [[maybe_unused]] V high) {
#if HWY_TARGET == HWY_SCALAR
  return first_f32(low);
#else
  const Lanes<float> d;
  return hn::ConcatEven(d, hn::BitCast(d, high), hn::BitCast(d, low));
#endif
}
template <class V>
HWY_INLINE hn::Vec<Lanes<float>> second_f32(V low, [[maybe_unused]] V high) {
#if HWY_TARGET == HWY_SCALAR
  return second_f32(low);
#else
  const Lanes<float> d;
  return hn::ConcatOdd(d, hn::BitCast(d, high), hn::BitCast(d, low));
#endif
}

// Records as lanes, as many as an f64 vector has, in the two halves of their lines. What is no f64
// comes as it lies there, pairs of f32 in `mixed`.
template <class Real>
struct PlaceV {
  Vec3V<hn::Vec<D64>> place;
  hn::Vec<D64> rest;  // (radius, wx); f64: radius
};
template <class Real>
struct MotionV {
  Vec3V<hn::Vec<D64>> velocity;
  hn::Vec<D64> rest;           // (wy, wz); f64: wx
  hn::Vec<D64> more[2];        // f64: wy, wz
  hn::Vec<D64> traits[2];      // (inverse mass, tag); f64: inverse mass, bits of the tag
};

// Eight bytes a lane, from anywhere.
template <std::size_t kCount, class From>
HWY_INLINE auto load_each(const From& from, std::size_t lane = 0) {
  const hn::FixedTag<double, kCount> d;
  if constexpr (kCount == 1) {
    double one;
    std::memcpy(&one, from(lane), sizeof one);
    return hn::Set(d, one);
  }
#if HWY_TARGET != HWY_SCALAR
  if constexpr (kCount > 1) {
    const auto low = load_each<kCount / 2>(from, lane);
    return hn::Combine(d, load_each<kCount / 2>(from, lane + kCount / 2), low);
  }
#endif
}

template <class Real>
HWY_INLINE PlaceV<Real> load_places(const ParticleView<Real>& p, const Index* lane) {
  hn::Vec<D64> c[4];
  load_quads([&](std::size_t k) HWY_ATTR { return &p.record[lane[k]].x; }, c);
  return {{c[0], c[1], c[2]}, c[3]};
}
template <class Real>
HWY_INLINE MotionV<Real> load_motions(const ParticleView<Real>& p, const Index* lane) {
  constexpr std::size_t kLanes = hn::MaxLanes(D64());
  MotionV<Real> m;
  hn::Vec<D64> c[4];
  if constexpr (sizeof(Real) == sizeof(float)) {
    load_quads([&](std::size_t k) HWY_ATTR { return &p.record[lane[k]].vx; }, c);
    m.velocity = {c[0], c[1], c[2]};
    m.rest = c[3];
    m.traits[0] = load_each<kLanes>([&](std::size_t k) HWY_ATTR { return p.traits + lane[k]; });
  } else {
    load_quads([&](std::size_t k) HWY_ATTR { return &p.record[lane[k]].wx; }, c);
    m.velocity = {c[1], c[2], c[3]};
    m.rest = c[0];
    const auto each = [&](auto field) HWY_ATTR {
      return load_each<kLanes>([&](std::size_t k) HWY_ATTR { return field(lane[k]); });
    };
    m.more[0] = each([&](Index k) HWY_ATTR { return &p.record[k].wy; });
    m.more[1] = each([&](Index k) HWY_ATTR { return &p.record[k].wz; });
    m.traits[0] = each([&](Index k) HWY_ATTR { return &p.traits[k].inverse_mass; });
    m.traits[1] = each([&](Index k) HWY_ATTR { return &p.traits[k].tag; });
  }
  return m;
}

// A full vector of partners is loaded in halves, so that the f64 places of one half are used up before
// the next one needs the registers; the rest is joined to vectors of Real lanes.
template <class Real>
HWY_INLINE hn::Vec<Lanes<Real>> join_radius(const PlaceV<Real>& low, const PlaceV<Real>& high) {
  if constexpr (sizeof(Real) == sizeof(float)) {
    return first_f32(low.rest, high.rest);
  } else {
    return low.rest;
  }
}
template <class Real>
struct BodyV {
  using V = hn::Vec<Lanes<Real>>;
  Vec3V<V> spin;
  V inverse_mass, contacts;
  hn::Vec<hn::RebindToSigned<Lanes<Real>>> material, group;
};
template <class Real>
HWY_INLINE BodyV<Real> join_bodies(const PlaceV<Real>& low, const PlaceV<Real>& high,
                                   const MotionV<Real>& low_motion,
                                   const MotionV<Real>& high_motion) {
  const hn::RebindToSigned<Lanes<Real>> di;
  BodyV<Real> b;
  hn::Vec<decltype(di)> tag;
  if constexpr (sizeof(Real) == sizeof(float)) {
    b.spin = {second_f32(low.rest, high.rest), first_f32(low_motion.rest, high_motion.rest),
              second_f32(low_motion.rest, high_motion.rest)};
    b.inverse_mass = first_f32(low_motion.traits[0], high_motion.traits[0]);
    tag = hn::BitCast(di, second_f32(low_motion.traits[0], high_motion.traits[0]));
  } else {
    b.spin = {low_motion.rest, low_motion.more[0], low_motion.more[1]};
    b.inverse_mass = low_motion.traits[0];
    tag = hn::BitCast(di, low_motion.traits[1]);
  }
  // A tag is a material, a group and a number of contacts.
  b.contacts = hn::ConvertTo(Lanes<Real>(), hn::ShiftRight<16>(tag));
  b.material = hn::And(tag, hn::Set(di, 0xff));
  b.group = hn::And(hn::ShiftRight<8>(tag), hn::Set(di, 0xff));
  return b;
}

// All of as many partners as an f64 vector has lanes.
template <class Real>
struct PartnerV {
  Vec3V<hn::Vec<D64>> place, velocity;
  Vec3V<hn::Vec<HalfLanes<Real>>> spin;
  hn::Vec<HalfLanes<Real>> radius, inverse_mass, contacts;
  hn::Vec<hn::RebindToSigned<HalfLanes<Real>>> material;
};
template <class Real>
HWY_INLINE PartnerV<Real> load_partner(const ParticleView<Real>& p, const Index* lane) {
  const hn::RebindToSigned<HalfLanes<Real>> di;
  const PlaceV<Real> place = load_places(p, lane);
  const MotionV<Real> motion = load_motions(p, lane);
  PartnerV<Real> out;
  out.place = place.place;
  out.velocity = motion.velocity;
  hn::Vec<decltype(di)> tag;
  if constexpr (sizeof(Real) == sizeof(float)) {
    out.radius = first_f32(place.rest);
    out.spin = {second_f32(place.rest), first_f32(motion.rest), second_f32(motion.rest)};
    out.inverse_mass = first_f32(motion.traits[0]);
    tag = hn::BitCast(di, second_f32(motion.traits[0]));
  } else {
    out.radius = place.rest;
    out.spin = {motion.rest, motion.more[0], motion.more[1]};
    out.inverse_mass = motion.traits[0];
    tag = hn::BitCast(di, motion.traits[1]);
  }
  out.contacts = hn::ConvertTo(HalfLanes<Real>(), hn::ShiftRight<16>(tag));
  out.material = hn::And(tag, hn::Set(di, 0xff));
  return out;
}

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

// Lane sums of a tally: in Real over a few contacts, in f64 over all of a tile.
template <class V>
struct TallyV {
  V work, elastic, slide, tangential_damping, numerical_loss, model_work, deepest;
  std::size_t contacts, warnings;
};
using TallySumV = TallyV<hn::Vec<D64>>;
template <class Real>
HWY_INLINE TallyV<hn::Vec<Lanes<Real>>> zero_tally() {
  const auto z = hn::Zero(Lanes<Real>());
  return {z, z, z, z, z, z, z, 0, 0};
}
HWY_INLINE TallySumV zero_tally_sum() { return zero_tally<double>(); }
template <class Real, class Law, class V, class M>
HWY_INLINE void count_response(const ResponseV<V>& r, M touching, V relative_overlap, V radius,
                               double overlap_cap, TallyV<V>& sum) {
  const Lanes<Real> d;
  sum.work = hn::Add(sum.work, r.work);
  sum.elastic = hn::Add(sum.elastic, r.elastic);
  sum.slide = hn::Add(sum.slide, r.slide);
  sum.tangential_damping = hn::Add(sum.tangential_damping, r.tangential_damping);
  sum.numerical_loss = hn::Add(sum.numerical_loss, r.numerical_loss);
  if constexpr (Law::kChanging) sum.model_work = hn::Add(sum.model_work, r.model_work);
  const V deep = hn::IfThenElseZero(touching, relative_overlap);
  sum.contacts += hn::CountTrue(d, touching);
  V limit = hn::Set(d, Real(0.5));
  if (HWY_UNLIKELY(overlap_cap > 0)) {
    limit = hn::Div(hn::Set(d, static_cast<Real>(overlap_cap)), radius);
  }
  sum.warnings += hn::CountTrue(d, hn::Gt(deep, limit));
  sum.deepest = hn::Max(sum.deepest, deep);
}
template <class Real>
HWY_INLINE void add_few(const TallyV<hn::Vec<Lanes<Real>>>& few, TallySumV& sum) {
  sum.work = hn::Add(sum.work, folded_f64<Real>(few.work));
  sum.elastic = hn::Add(sum.elastic, folded_f64<Real>(few.elastic));
  sum.slide = hn::Add(sum.slide, folded_f64<Real>(few.slide));
  sum.tangential_damping =
      hn::Add(sum.tangential_damping, folded_f64<Real>(few.tangential_damping));
  sum.numerical_loss = hn::Add(sum.numerical_loss, folded_f64<Real>(few.numerical_loss));
  sum.model_work = hn::Add(sum.model_work, folded_f64<Real>(few.model_work));
  sum.contacts += few.contacts;
  sum.warnings += few.warnings;
  sum.deepest = hn::Max(sum.deepest, hn::Max(half_f64<Real, 0>(few.deepest),
                                             half_f64<Real, 1>(few.deepest)));
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
  t.model_work = sum_lanes(v.model_work);
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
