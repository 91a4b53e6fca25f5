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

// Geometry of one f64 vector of pairs: what needs more than f32.
template <class Real>
struct SeparationV {
  Vec3V<hn::Vec<D64>> velocity;
  Vec3V<hn::Vec<HalfLanes<Real>>> place, place_old;   // of i from j, rounded after the difference
  hn::Vec<HalfLanes<Real>> reach, d2, d2_old, gap2, gap2_old;  // R, d^2, R^2 - d^2
};

template <class Real>
HWY_INLINE SeparationV<Real> separate(const StepConstants<Real>& step, const PartnerV<Real>& a,
                                      const PartnerV<Real>& b) {
  using V64 = hn::Vec<D64>;
  const V64 dt = hn::Set(D64(), step.dt);
  Vec3V<V64> dx = a.place - b.place;
  if (step.periodic) {
    dx.x = nearest_image(dx.x, step.period[0], step.inverse_period[0]);
    dx.y = nearest_image(dx.y, step.period[1], step.inverse_period[1]);
    dx.z = nearest_image(dx.z, step.period[2], step.inverse_period[2]);
  }
  SeparationV<Real> s;
  s.velocity = a.velocity - b.velocity;
  const Vec3V<V64> dx_old = add_scaled(dx, hn::Neg(dt), s.velocity);
  const V64 reach = hn::Add(to_f64(a.radius), to_f64(b.radius));
  const V64 d2 = dot(dx, dx), d2_old = dot(dx_old, dx_old);
  s.place = to_real<Real>(dx);
  s.place_old = to_real<Real>(dx_old);
  s.reach = to_real<Real>(reach);
  s.d2 = to_real<Real>(d2);
  s.d2_old = to_real<Real>(d2_old);
  s.gap2 = to_real<Real>(hn::MulSub(reach, reach, d2));
  s.gap2_old = to_real<Real>(hn::MulSub(reach, reach, d2_old));
  return s;
}

// Unit vectors and overlaps (R^2 - d^2) / (R + d), now and a step ago, by two divisions.
template <class Real, class V = hn::Vec<Lanes<Real>>>
HWY_INLINE void set_geometry(const SeparationV<Real> (&s)[2], TouchV<V>& t, V& reach) {
  const Lanes<Real> d;
  const V one = hn::Set(d, 1), tiny = hn::Set(d, Real(1e-25));
  const auto both = [&](const auto& pick) HWY_ATTR { return join<Real>(pick(0), pick(1)); };
  reach = both([&](int h) HWY_ATTR { return s[h].reach; });
  const V now = hn::Sqrt(hn::Max(both([&](int h) HWY_ATTR { return s[h].d2; }), tiny));
  const V old = hn::Sqrt(hn::Max(both([&](int h) HWY_ATTR { return s[h].d2_old; }), tiny));
  const V inverse = hn::Div(one, hn::Mul(now, old));
  t.normal = scale(hn::Mul(inverse, old), both([&](int h) HWY_ATTR { return s[h].place; }));
  t.normal_old = scale(hn::Mul(inverse, now), both([&](int h) HWY_ATTR { return s[h].place_old; }));
  const V sum_now = hn::Add(reach, now), sum_old = hn::Add(reach, old);
  const V inverse_sums = hn::Div(one, hn::Mul(sum_now, sum_old));
  t.overlap = hn::Mul(both([&](int h) HWY_ATTR { return s[h].gap2; }),
                      hn::Mul(inverse_sums, sum_old));
  t.overlap_old = hn::Mul(both([&](int h) HWY_ATTR { return s[h].gap2_old; }),
                          hn::Mul(inverse_sums, sum_now));
}

// Both partners of a full vector of pairs as the law sees them.
template <class Real, class V = hn::Vec<Lanes<Real>>>
HWY_INLINE TouchV<V> touch_of(bool rolling, const PartnerV<Real> (&a)[2],
                              const PartnerV<Real> (&b)[2], const SeparationV<Real> (&s)[2],
                              V& radius_i) {
  const Lanes<Real> d;
  const auto both = [&](const auto& pick) HWY_ATTR { return join<Real>(pick(0), pick(1)); };
  TouchV<V> t;
  V reach;
  set_geometry<Real>(s, t, reach);
  t.velocity = both([&](int h) HWY_ATTR { return to_real<Real>(s[h].velocity); });
  t.spin_i = both([&](int h) HWY_ATTR { return a[h].spin; });
  t.spin_j = both([&](int h) HWY_ATTR { return b[h].spin; });
  const V half = hn::Set(d, Real(0.5));
  radius_i = both([&](int h) HWY_ATTR { return a[h].radius; });
  const V radius_j = both([&](int h) HWY_ATTR { return b[h].radius; });
  t.arm_i = hn::NegMulAdd(half, t.overlap, radius_i);
  t.arm_j = hn::NegMulAdd(half, t.overlap, radius_j);
  t.arm_i_old = hn::NegMulAdd(half, t.overlap_old, radius_i);
  t.arm_j_old = hn::NegMulAdd(half, t.overlap_old, radius_j);
  const V mass_i = both([&](int h) HWY_ATTR { return a[h].inverse_mass; });
  const V mass_j = both([&](int h) HWY_ATTR { return b[h].inverse_mass; });
  const V count_i = both([&](int h) HWY_ATTR { return a[h].contacts; });
  const V count_j = both([&](int h) HWY_ATTR { return b[h].contacts; });
  t.inverse_mass = hn::Add(mass_i, mass_j);
  t.count_rate = hn::MulAdd(count_i, mass_i, hn::Mul(count_j, mass_j));
  t.contacts = hn::Add(count_i, count_j);
  t.rolling_radius = t.inverse_inertia = hn::Zero(d);
  if (!rolling) return t;
  t.rolling_radius = hn::Div(hn::Mul(radius_i, radius_j), reach);
  t.inverse_inertia = hn::Mul(hn::Set(d, Real(2.5)),
                              hn::Add(hn::Div(mass_i, hn::Mul(radius_i, radius_i)),
                                      hn::Div(mass_j, hn::Mul(radius_j, radius_j))));
  return t;
}

// Equal and opposite, added in f64 to the rows of this tile; other tiles' partners to the last row.
template <class Real, std::size_t half, class V>
HWY_INLINE void add_pair_rows(const ResponseV<V>& r, const Vec3V<V>& torque_i,
                              const Vec3V<V>& torque_j, V one, const Index* i, const Index* j,
                              const TileRows& tile) {
  const D64 d;
  const auto f64 = [](V v) HWY_ATTR { return half_f64<Real, half>(v); };
  const auto first = hn::Set(D32U(), tile.first), size = hn::Set(D32U(), tile.size);
  HWY_ALIGN Index rows[2][16];
  hn::StoreU(hn::Min(hn::Sub(hn::LoadU(D32U(), i), first), size), D32U(), rows[0]);
  hn::StoreU(hn::Min(hn::Sub(hn::LoadU(D32U(), j), first), size), D32U(), rows[1]);
  const auto fx = f64(r.force.x), fy = f64(r.force.y), fz = f64(r.force.z), count = f64(one);
  const hn::Vec<D64> on_i[8] = {fx,
                                fy,
                                fz,
                                f64(torque_i.x),
                                f64(torque_i.y),
                                f64(torque_i.z),
                                count,
                                hn::Zero(d)};
  add_to_rows(on_i, rows[0], tile.rows);
  const hn::Vec<D64> on_j[8] = {hn::Neg(fx),
                                hn::Neg(fy),
                                hn::Neg(fz),
                                f64(torque_j.x),
                                f64(torque_j.y),
                                f64(torque_j.z),
                                count,
                                hn::Zero(d)};
  add_to_rows(on_j, rows[1], tile.rows);
}

// The slots are eight streams, more than the hardware follows: they are asked for in time. What lies
// past the end is the next tile's.
constexpr std::size_t kSlotsAhead = 160;
template <class Real>
HWY_INLINE void prefetch_slots(const PairView<Real>& pairs, std::size_t at) {
  hwy::Prefetch(pairs.i + at);
  hwy::Prefetch(pairs.j + at);
  for (int a = 0; a < 3; ++a) {
    hwy::Prefetch(pairs.spring[a] + at);
    hwy::Prefetch(pairs.force[a] + at);
  }
}

template <class Real, bool kTally>
HWY_INLINE void sphere_sphere_range(const StepConstants<Real>& step, const ParticleView<Real>& p,
                                    const PairView<Real>& pairs, std::size_t begin, std::size_t end,
                                    const TileRows& tile, ContactTally& tally) {
  const Lanes<Real> d;
  using V = hn::Vec<Lanes<Real>>;
  const std::size_t lanes = hn::Lanes(d), half = hn::Lanes(D64());
  const V zero = hn::Zero(d);
  TallyV sum = zero_tally();
  for (std::size_t at = begin; at < end; at += lanes) {
    if (at + 3 * lanes < end) {
      for (std::size_t k = 0; k < lanes; ++k) hwy::Prefetch(p.record + pairs.j[at + 3 * lanes + k]);
    }
    prefetch_slots(pairs, at + kSlotsAhead);
    PartnerV<Real> a[2], b[2];
    SeparationV<Real> s[2];
    for (std::size_t h = 0; h < kHalves<Real>; ++h) {
      a[h] = load_partner(p, pairs.i + at + h * half);
      b[h] = load_partner(p, pairs.j + at + h * half);
      s[h] = separate(step, a[h], b[h]);
    }
    const V gap2 = join<Real>(s[0].gap2, s[1].gap2);
    HistoryV<V> old;
    old.spring = load3<V>(pairs.spring, at);
    old.force = load3<V>(pairs.force, at);
    const V any_force =
        hn::Add(hn::Abs(old.force.x), hn::Add(hn::Abs(old.force.y), hn::Abs(old.force.z)));
    // Padding pairs a particle with itself: gap = R^2 there, so ask for two distinct partners.
    const auto distinct = hn::RebindMask(
        d, hn::Ne(load_index<Real>(pairs.i + at), load_index<Real>(pairs.j + at)));
    const auto touching = hn::And(distinct, hn::Gt(gap2, zero));
    if (hn::AllFalse(d, hn::Or(touching, hn::Gt(any_force, zero)))) continue;

    V radius_i;
    const TouchV<V> t = touch_of<Real>(step.rolling, a, b, s, radius_i);
    old.moment = {zero, zero, zero};
    if (step.rolling) old.moment = load3<V>(pairs.moment, at);
    const auto material_i = join<Real>(a[0].material, a[1].material);
    const auto material_j = join<Real>(b[0].material, b[1].material);
    using Row = hn::RebindToSigned<Lanes<Real>>;
    const auto row = hn::Add(
        hn::Mul(material_i, hn::Set(Row(), static_cast<hn::TFromD<Row>>(step.law.materials))),
        material_j);
    const ResponseV<V> r =
        respond<Real>(step, load_coefficients<Real>(step.law, row), t, old, touching);
    store3(r.spring, pairs.spring, at);
    store3(r.force, pairs.force, at);
    if (step.rolling) store3(r.moment, pairs.moment, at);
    if constexpr (kTally) count_response<Real>(r, touching, hn::Div(t.overlap, radius_i), sum);

    const Vec3V<V> twist = cross(r.tangential, t.normal);  // = -n x F_t
    const Vec3V<V> torque_i = add_scaled(r.moment, t.arm_i, twist);
    const Vec3V<V> torque_j = scale(t.arm_j, twist) - r.moment;
    const V one = hn::IfThenElseZero(touching, hn::Set(d, 1));
    add_pair_rows<Real, 0>(r, torque_i, torque_j, one, pairs.i + at, pairs.j + at, tile);
    if constexpr (kHalves<Real> == 2) {
      add_pair_rows<Real, 1>(r, torque_i, torque_j, one, pairs.i + at + half, pairs.j + at + half,
                             tile);
    }
  }
  if constexpr (kTally) add_tally(sum, tally);
}

template <class Real>
void sphere_sphere(const StepConstants<Real>& step, const ParticleView<Real>& p,
                   const PairView<Real>& pairs, const TileRows& tile, ContactTally& tally) {
  sphere_sphere_range<Real, true>(step, p, pairs, 0, pairs.own, tile, tally);
  sphere_sphere_range<Real, false>(step, p, pairs, pairs.own, pairs.all, tile, tally);
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
