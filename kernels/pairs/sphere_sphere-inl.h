// Sphere against sphere: the contact loop of the batch that dominates most scenes.
//
// Overlap is (R^2 - d^2) / (R + d) with R^2 - d^2 in f64, so that a static overlap of 1e-9 m at 5 m
// from the origin is right to 1e-7 of itself although the rest of the force is f32 in `mixed`. The
// old normal and overlap are recomputed from the positions before the last step, x - dt v, instead
// of being stored. i is the partner with the smaller radius (ties: lower identity) for life.
#if defined(QUERN_SPHERE_SPHERE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_SPHERE_SPHERE_INL_H_
#undef QUERN_SPHERE_SPHERE_INL_H_
#else
#define QUERN_SPHERE_SPHERE_INL_H_
#endif

#include "kernels/pair_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

HWY_INLINE hn::Vec<D64> nearest_image(hn::Vec<D64> dx, double period, double inverse_period) {
  const D64 d;
  const auto turns = hn::Round(hn::Mul(dx, hn::Set(d, inverse_period)));
  return hn::NegMulAdd(turns, hn::Set(d, period), dx);
}

// Where i is from j, f64. An image is nearer only where some pair lies further apart than half a period:
// next to never, so that lanes are asked together.
template <class Real>
HWY_INLINE Vec3V<hn::Vec<D64>> apart(const StepConstants<Real>& step, const PlaceV<Real>& i,
                                     const PlaceV<Real>& j, hn::Vec<D64>& d2) {
  const D64 d;
  Vec3V<hn::Vec<D64>> dx = i.place - j.place;
  d2 = dot(dx, dx);
  if (HWY_LIKELY(hn::AllFalse(d, hn::Gt(d2, hn::Set(d, step.nearest2))))) return dx;
  if (step.period[0] > 0) dx.x = nearest_image(dx.x, step.period[0], step.inverse_period[0]);
  if (step.period[1] > 0) dx.y = nearest_image(dx.y, step.period[1], step.inverse_period[1]);
  if (step.period[2] > 0) dx.z = nearest_image(dx.z, step.period[2], step.inverse_period[2]);
  d2 = dot(dx, dx);
  return dx;
}
template <class Real, std::size_t half, class V>
HWY_INLINE auto gap2_of(hn::Vec<D64> radius_i, V radius_j, hn::Vec<D64> d2) {
  const auto reach = hn::Add(radius_i, half_f64<Real, half>(radius_j));
  return to_real<Real>(hn::MulSub(reach, reach, d2));
}

// A full vector of pairs, i from j, rounded after the differences.
template <class V>
struct SeparationV {
  Vec3V<V> place, velocity;
  V d2, gap2;  // d^2, R^2 - d^2
};

// Unit vectors and overlaps (R^2 - d^2) / (R + d), now and a step ago, by two divisions. A step ago
// the squares were smaller by dt v.(2 x - dt v): a small difference, right to a rounding of itself.
template <class V>
HWY_INLINE void set_geometry(const SeparationV<V>& s, V reach, V dt, TouchV<V>& t) {
  const hn::DFromV<V> d;
  const V one = hn::Set(d, 1), tiny = hn::Set(d, hn::TFromV<V>(1e-25));
  const Vec3V<V> place_old = add_scaled(s.place, hn::Neg(dt), s.velocity);
  const V came = hn::Mul(dt, dot(s.velocity, s.place + place_old));
  const V gap2_old = hn::Add(s.gap2, came);
  const V now = hn::Sqrt(hn::Max(s.d2, tiny)), old = hn::Sqrt(hn::Max(hn::Sub(s.d2, came), tiny));
  const V inverse = hn::Div(one, hn::Mul(now, old));
  t.normal = scale(hn::Mul(inverse, old), s.place);
  t.normal_old = scale(hn::Mul(inverse, now), place_old);
  const V sum_now = hn::Add(reach, now), sum_old = hn::Add(reach, old);
  const V inverse_sums = hn::Div(one, hn::Mul(sum_now, sum_old));
  t.overlap = hn::Mul(s.gap2, hn::Mul(inverse_sums, sum_old));
  t.overlap_old = hn::Mul(gap2_old, hn::Mul(inverse_sums, sum_now));
}

// Both partners of a full vector of pairs as the law sees them.
template <class Real, bool kRolling, class V = hn::Vec<Lanes<Real>>>
HWY_INLINE TouchV<V> touch_of(const StepConstants<Real>& step, const BodyV<Real>& a, V radius_i,
                              const BodyV<Real>& b, V radius_j, const SeparationV<V>& s, V& arm_i,
                              V& arm_j) {
  const Lanes<Real> d;
  TouchV<V> t;
  const V reach = hn::Add(radius_i, radius_j);
  set_geometry(s, reach, hn::Set(d, static_cast<Real>(step.dt)), t);
  t.normal_velocity = dot(t.normal, s.velocity);
  t.spin_i = a.spin;
  t.spin_j = b.spin;
  const V half = hn::Set(d, Real(0.5));
  arm_i = hn::NegMulAdd(half, t.overlap, radius_i);
  arm_j = hn::NegMulAdd(half, t.overlap, radius_j);
  const Vec3V<V> rim = add_scaled(scale(arm_i, a.spin), arm_j, b.spin);
  // Both arms were longer by half of what the overlap has grown.
  const V grown = hn::Mul(half, hn::Sub(t.overlap, t.overlap_old));
  const Vec3V<V> rim_old = add_scaled(rim, grown, a.spin + b.spin);
  t.at_point = s.velocity - cross(rim, t.normal);
  t.at_old = s.velocity - cross(rim_old, t.normal_old);
  t.inverse_mass = hn::Add(a.inverse_mass, b.inverse_mass);
  t.count_rate = hn::MulAdd(a.contacts, a.inverse_mass, hn::Mul(b.contacts, b.inverse_mass));
  t.contacts = hn::Add(a.contacts, b.contacts);
  if constexpr (kRolling) {
    t.rolling_radius = hn::Div(hn::Mul(radius_i, radius_j), reach);
    t.inverse_inertia = hn::Mul(hn::Set(d, Real(2.5)),
                                hn::Add(hn::Div(a.inverse_mass, hn::Mul(radius_i, radius_i)),
                                        hn::Div(b.inverse_mass, hn::Mul(radius_j, radius_j))));
  } else {
    t.rolling_radius = t.inverse_inertia = hn::Zero(d);
  }
  return t;
}

// Sums of the owners of a block over its rows: fx fy fz tx ty tz contacts, f64.
template <class Real>
struct OwnerSums {
  hn::Vec<D64> sum[kHalves<Real>][7];
};
template <class Real, std::size_t half, class V>
HWY_INLINE void add_to_owner(const Vec3V<V>& force, const Vec3V<V>& torque, V one,
                             OwnerSums<Real>& to) {
  auto& sum = to.sum[half];
  const V from[7] = {force.x, force.y, force.z, torque.x, torque.y, torque.z, one};
  for (int k = 0; k < 7; ++k) sum[k] = hn::Add(sum[k], half_f64<Real, half>(from[k]));
}

// Row of each particle in the tile's accumulator; other tiles' particles take the last row.
HWY_INLINE void find_rows(const TileRows& tile, const Index* particle, Index (&rows)[16]) {
  const auto first = hn::Set(D32U(), tile.first), size = hn::Set(D32U(), tile.size);
  hn::StoreU(hn::Min(hn::Sub(hn::LoadU(D32U(), particle), first), size), D32U(), rows);
}
template <class Real, std::size_t half, class V>
HWY_INLINE void add_to_partners(const Vec3V<V>& force, const Vec3V<V>& torque, V one,
                                const Index* partner, const TileRows& tile) {
  const auto f64 = [](V v) HWY_ATTR { return half_f64<Real, half>(v); };
  const hn::Vec<D64> c[8] = {f64(force.x),  f64(force.y),  f64(force.z), f64(torque.x),
                             f64(torque.y), f64(torque.z), f64(one),     hn::Zero(D64())};
  HWY_ALIGN Index rows[16];
  find_rows(tile, partner, rows);
  add_to_rows(c, rows, tile.rows);
}

// What one row of a block needs beside its partners: the owners.
template <class Real>
struct BlockV {
  PlaceV<Real> low, high;
  MotionV<Real> low_motion, high_motion;
  BodyV<Real> owner;
  hn::Vec<Lanes<Real>> radius, inverse_radius;
  hn::Vec<D64> low_radius, high_radius;
  hn::Vec<hn::RebindToSigned<Lanes<Real>>> index;
  OwnerSums<Real> sums;
  TallyV<hn::Vec<Lanes<Real>>> tally;
};

// One row: the owners of a block with one partner each. Own rows give the partner its share and are
// tallied; in imported rows the owner is j.
template <class Real, class Law, bool kOwn>
HWY_INLINE void sphere_sphere_row(const StepConstants<Real>& step, const ParticleView<Real>& p,
                                  const Index* partner, Real* numbers, const TileRows& tile,
                                  BlockV<Real>& block) {
  const Lanes<Real> d;
  using V = hn::Vec<Lanes<Real>>;
  constexpr std::size_t kHalf = hn::MaxLanes(D64());
  constexpr std::size_t kHigh = kHalves<Real> - 1;
  const V zero = hn::Zero(d);
  hn::Vec<D64> low_d2, high_d2;
  const PlaceV<Real> low = load_places(p, partner);
  const auto low_place = to_real<Real>(kOwn ? apart(step, block.low, low, low_d2)
                                            : apart(step, low, block.low, low_d2));
  const PlaceV<Real> high = load_places(p, partner + kHigh * kHalf);
  const auto high_place = to_real<Real>(kOwn ? apart(step, block.high, high, high_d2)
                                             : apart(step, high, block.high, high_d2));
  const V radius = join_radius(low, high);
  SeparationV<V> s;
  s.gap2 = join<Real>(gap2_of<Real, 0>(block.low_radius, radius, low_d2),
                      gap2_of<Real, kHigh>(block.high_radius, radius, high_d2));
  HistoryV<V> old;
  old.force = load3<V>(numbers + 3 * kPairPad, kPairPad);
  const V any_force =
      hn::Add(hn::Abs(old.force.x), hn::Add(hn::Abs(old.force.y), hn::Abs(old.force.z)));
  // An empty lane pairs a particle with itself: gap = R^2 there, so ask for two distinct partners.
  const auto distinct = hn::RebindMask(d, hn::Ne(block.index, load_index<Real>(partner)));
  const auto touching = hn::And(distinct, hn::Gt(s.gap2, zero));
  if (hn::AllFalse(d, hn::Or(touching, hn::Gt(any_force, zero)))) return;

  s.place = join<Real>(low_place, high_place);
  s.d2 = join<Real>(to_real<Real>(low_d2), to_real<Real>(high_d2));
  const MotionV<Real> low_motion = load_motions(p, partner);
  const MotionV<Real> high_motion = load_motions(p, partner + kHigh * kHalf);
  const auto relative = [&](const MotionV<Real>& mine, const MotionV<Real>& theirs) HWY_ATTR {
    return to_real<Real>(kOwn ? mine.velocity - theirs.velocity : theirs.velocity - mine.velocity);
  };
  s.velocity = join<Real>(relative(block.low_motion, low_motion),
                          relative(block.high_motion, high_motion));
  const BodyV<Real> other = join_bodies(low, high, low_motion, high_motion);
  const BodyV<Real>&a = kOwn ? block.owner : other, &b = kOwn ? other : block.owner;
  V arm_i, arm_j;
  const TouchV<V> t =
      kOwn ? touch_of<Real, Law::kRolling>(step, a, block.radius, b, radius, s, arm_i, arm_j)
           : touch_of<Real, Law::kRolling>(step, a, radius, b, block.radius, s, arm_i, arm_j);
  old.spring = load3<V>(numbers, kPairPad);
  old.moment = {zero, zero, zero};
  if constexpr (Law::kRolling) old.moment = load3<V>(numbers + 6 * kPairPad, kPairPad);
  using Row = hn::RebindToSigned<Lanes<Real>>;
  const auto row = hn::Add(
      hn::Mul(a.material, hn::Set(Row(), static_cast<hn::TFromD<Row>>(step.law.materials))),
      b.material);
  const ResponseV<V> r =
      respond<Real, Law>(step, load_coefficients<Real>(step.law, row), t, old, touching);
  store3(r.spring, numbers, kPairPad);
  store3(r.force, numbers + 3 * kPairPad, kPairPad);
  if constexpr (Law::kRolling) store3(r.moment, numbers + 6 * kPairPad, kPairPad);
  if constexpr (kOwn) {
    count_response<Real>(r, touching, hn::Mul(t.overlap, block.inverse_radius), block.tally);
  }

  const Vec3V<V> twist = cross(r.tangential, t.normal);  // = -n x F_t
  Vec3V<V> torque_j = scale(arm_j, twist);
  if constexpr (Law::kRolling) torque_j = torque_j - r.moment;
  const Vec3V<V> on_j = {hn::Neg(r.force.x), hn::Neg(r.force.y), hn::Neg(r.force.z)};
  const V one = hn::IfThenElseZero(touching, hn::Set(d, 1));
  if constexpr (kOwn) {
    Vec3V<V> torque_i = scale(arm_i, twist);
    if constexpr (Law::kRolling) torque_i = torque_i + r.moment;
    add_to_owner<Real, 0>(r.force, torque_i, one, block.sums);
    add_to_partners<Real, 0>(on_j, torque_j, one, partner, tile);
    if constexpr (kHalves<Real> == 2) {
      add_to_owner<Real, 1>(r.force, torque_i, one, block.sums);
      add_to_partners<Real, 1>(on_j, torque_j, one, partner + kHalf, tile);
    }
  } else {
    add_to_owner<Real, 0>(on_j, torque_j, one, block.sums);
    if constexpr (kHalves<Real> == 2) add_to_owner<Real, 1>(on_j, torque_j, one, block.sums);
  }
}

// What a row some rows ahead will need; past the end of a tile's rows it is the next tile's.
constexpr std::size_t kRowsAhead = 4;
template <class Real>
HWY_INLINE void prefetch_row(const ParticleView<Real>& p, const Index* partner, const Real* numbers,
                             std::size_t width) {
  for (std::size_t k = 0; k < hn::MaxLanes(Lanes<Real>()); ++k) {
    hwy::Prefetch(p.record + partner[k]);
  }
  for (std::size_t k = 0; k < width; k += kPairPad) hwy::Prefetch(numbers + k);
}

// The owners of the next block, and with each own block as many particles of the next tile.
template <class Real>
HWY_INLINE void prefetch_next_block(const ParticleView<Real>& p, const PairView<Real>& pairs,
                                    std::size_t block, const TileRows& tile) {
  if (block + 1 < pairs.all) {
    const Index* owner = pairs.owner + (block + 1) * kPairPad;
    for (std::size_t k = 0; k < kPairPad; ++k) {
      hwy::Prefetch(p.record + owner[k]);
      hwy::Prefetch(p.traits + owner[k]);
    }
  }
  if (block >= pairs.own) return;
  const std::size_t next = tile.first + tile.size + block * kPairPad;
  constexpr std::size_t kTraitsInLine = 64 / sizeof(Traits<Real>);
  for (std::size_t k = 0; k < kPairPad; ++k) hwy::Prefetch(p.record + next + k);
  for (std::size_t k = 0; k < kPairPad; k += kTraitsInLine) hwy::Prefetch(p.traits + next + k);
}

// Blocks of one part. Vectors narrower than a block take it in pieces.
template <class Real, class Law, bool kOwn>
HWY_INLINE void sphere_sphere_blocks(const StepConstants<Real>& step, const ParticleView<Real>& p,
                                     const PairView<Real>& pairs, const TileRows& tile,
                                     ContactTally& tally) {
  constexpr std::size_t kLanes = hn::MaxLanes(Lanes<Real>()), kHalf = hn::MaxLanes(D64());
  constexpr std::size_t width = (Law::kRolling ? kRollingHistory : kHistory) * kPairPad;
  const std::size_t first = kOwn ? 0 : pairs.own, last = kOwn ? pairs.own : pairs.all;
  const std::size_t end = pairs.row_begin[last];
  TallySumV sum = zero_tally_sum();
  for (std::size_t at = first; at < last; ++at) {
    for (std::size_t piece = 0; piece < kPairPad; piece += kLanes) {
      const Index* owner = pairs.owner + at * kPairPad + piece;
      BlockV<Real> block;
      block.index = load_index<Real>(owner);
      block.tally = zero_tally<Real>();
      const Index* high = owner + (kHalves<Real> - 1) * kHalf;
      block.low = load_places(p, owner);
      block.high = load_places(p, high);
      block.low_motion = load_motions(p, owner);
      block.high_motion = load_motions(p, high);
      block.owner = join_bodies(block.low, block.high, block.low_motion, block.high_motion);
      block.radius = join_radius(block.low, block.high);
      block.low_radius = half_f64<Real, 0>(block.radius);
      block.high_radius = half_f64<Real, kHalves<Real> - 1>(block.radius);
      block.inverse_radius = hn::Div(hn::Set(Lanes<Real>(), 1), block.radius);
      for (auto& half : block.sums.sum) {
        for (auto& v : half) v = hn::Zero(D64());
      }
      if (piece == 0) prefetch_next_block(p, pairs, at, tile);
      for (std::size_t row = pairs.row_begin[at]; row < pairs.row_begin[at + 1]; ++row) {
        const Index* partner = pairs.partner + row * kPairPad + piece;
        Real* numbers = pairs.numbers + row * width + piece;
        if (row + kRowsAhead < end) {
          prefetch_row(p, partner + kRowsAhead * kPairPad, numbers + kRowsAhead * width, width);
        }
        sphere_sphere_row<Real, Law, kOwn>(step, p, partner, numbers, tile, block);
      }
      for (std::size_t h = 0; h < kHalves<Real>; ++h) {
        const auto& s = block.sums.sum[h];
        const hn::Vec<D64> c[8] = {s[0], s[1], s[2], s[3], s[4], s[5], s[6], hn::Zero(D64())};
        HWY_ALIGN Index rows[16];
        find_rows(tile, owner + h * kHalf, rows);
        add_to_rows(c, rows, tile.rows);
      }
      if constexpr (kOwn) add_block<Real>(block.tally, sum);
    }
  }
  if constexpr (kOwn) add_tally(sum, tally);
}

template <class Real, class Law>
void sphere_sphere_parts(const StepConstants<Real>& step, const ParticleView<Real>& p,
                         const PairView<Real>& pairs, const TileRows& tile, ContactTally& tally) {
  sphere_sphere_blocks<Real, Law, true>(step, p, pairs, tile, tally);
  sphere_sphere_blocks<Real, Law, false>(step, p, pairs, tile, tally);
}

template <class Real>
void sphere_sphere(const StepConstants<Real>& step, const ParticleView<Real>& p,
                   const PairView<Real>& pairs, const TileRows& tile, ContactTally& tally) {
  if (step.rolling) {
    sphere_sphere_parts<Real, RollingLaw>(step, p, pairs, tile, tally);
  } else if (step.damped) {
    sphere_sphere_parts<Real, DampedLaw>(step, p, pairs, tile, tally);
  } else {
    sphere_sphere_parts<Real, PlainLaw>(step, p, pairs, tile, tally);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
