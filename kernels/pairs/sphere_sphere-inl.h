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

// Unit vector and overlap for centres dx apart; `gap2` = R^2 - d^2.
template <class Real>
HWY_INLINE void normal_and_overlap(const Vec3V<hn::Vec<D64>>& dx, hn::Vec<D64> d2,
                                   hn::Vec<D64> gap2, hn::Vec<Lanes<Real>> reach,
                                   Vec3V<hn::Vec<Lanes<Real>>>& normal,
                                   hn::Vec<Lanes<Real>>& overlap) {
  const Lanes<Real> d;
  const auto distance = hn::Sqrt(hn::Max(to_real<Real>(d2), hn::Set(d, Real(1e-25))));
  normal = scale(hn::Div(hn::Set(d, 1), distance), to_real<Real>(dx));
  overlap = hn::Div(to_real<Real>(gap2), hn::Add(reach, distance));
}

template <class Real, bool kTally>
HWY_INLINE void sphere_sphere_range(const StepConstants<Real>& step, const ParticleView<Real>& p,
                                    const PairView<Real>& pairs, std::size_t begin, std::size_t end,
                                    const TileRows& tile, ContactTally& tally) {
  const D64 d;
  const Lanes<Real> dr;
  using V = hn::Vec<Lanes<Real>>;
  const std::size_t lanes = hn::Lanes(d);
  const auto dt64 = hn::Set(d, step.dt);
  TallyV sum = zero_tally();
  HWY_ALIGN Index rows[2][16];
  for (std::size_t at = begin; at < end; at += lanes) {
    if (at + 2 * lanes < end) {
      for (std::size_t k = 0; k < lanes; ++k) hwy::Prefetch(p.record + pairs.j[at + 2 * lanes + k]);
    }
    const PartnerV<Real> a = load_partner(p, pairs.i + at);
    const PartnerV<Real> b = load_partner(p, pairs.j + at);
    Vec3V<hn::Vec<D64>> dx = a.place - b.place;
    if (step.periodic) {
      dx.x = nearest_image(dx.x, step.period[0], step.inverse_period[0]);
      dx.y = nearest_image(dx.y, step.period[1], step.inverse_period[1]);
      dx.z = nearest_image(dx.z, step.period[2], step.inverse_period[2]);
    }
    const Vec3V<hn::Vec<D64>> dv = a.velocity - b.velocity;
    const auto reach = hn::Add(to_f64(a.radius), to_f64(b.radius));
    const auto d2 = dot(dx, dx);
    const auto gap2 = hn::NegMulAdd(reach, reach, d2);  // d^2 - R^2
    const auto listed_i = hn::LoadU(D32U(), pairs.i + at), listed_j = hn::LoadU(D32U(), pairs.j + at);
    HistoryV<V> old;
    old.spring = load3<V>(pairs.spring, at);
    old.force = load3<V>(pairs.force, at);
    const V any_force =
        hn::Add(hn::Abs(old.force.x), hn::Add(hn::Abs(old.force.y), hn::Abs(old.force.z)));
    const V gap = to_real<Real>(hn::Neg(gap2));
    // Padding pairs a particle with itself: gap = R^2 there, so ask for two distinct partners.
    const auto distinct = hn::Ne(to_index<Real>(listed_i), to_index<Real>(listed_j));
    const auto touching = hn::And(hn::RebindMask(dr, distinct), hn::Gt(gap, hn::Zero(dr)));
    if (hn::AllFalse(dr, hn::Or(touching, hn::Gt(any_force, hn::Zero(dr))))) continue;

    TouchV<V> t;
    const V reach_real = to_real<Real>(reach);
    normal_and_overlap<Real>(dx, d2, hn::Neg(gap2), reach_real, t.normal, t.overlap);
    const Vec3V<hn::Vec<D64>> dx_old = add_scaled(dx, hn::Neg(dt64), dv);
    const auto d2_old = dot(dx_old, dx_old);
    normal_and_overlap<Real>(dx_old, d2_old, hn::Sub(hn::Mul(reach, reach), d2_old), reach_real,
                             t.normal_old, t.overlap_old);
    const V half = hn::Set(dr, Real(0.5));
    t.velocity = to_real<Real>(dv);
    t.spin_i = a.spin;
    t.spin_j = b.spin;
    t.arm_i = hn::NegMulAdd(half, t.overlap, a.radius);
    t.arm_j = hn::NegMulAdd(half, t.overlap, b.radius);
    t.arm_i_old = hn::NegMulAdd(half, t.overlap_old, a.radius);
    t.arm_j_old = hn::NegMulAdd(half, t.overlap_old, b.radius);
    t.inverse_mass = hn::Add(a.inverse_mass, b.inverse_mass);
    t.count_rate = hn::MulAdd(a.contacts, a.inverse_mass, hn::Mul(b.contacts, b.inverse_mass));
    t.contacts = hn::Add(a.contacts, b.contacts);
    old.moment = {hn::Zero(dr), hn::Zero(dr), hn::Zero(dr)};
    if (step.rolling) {
      old.moment = load3<V>(pairs.moment, at);
      t.rolling_radius = hn::Div(hn::Mul(a.radius, b.radius), hn::Add(a.radius, b.radius));
      const V two_and_half = hn::Set(dr, Real(2.5));
      t.inverse_inertia =
          hn::Mul(two_and_half, hn::Add(hn::Div(a.inverse_mass, hn::Mul(a.radius, a.radius)),
                                        hn::Div(b.inverse_mass, hn::Mul(b.radius, b.radius))));
    } else {
      t.rolling_radius = t.inverse_inertia = hn::Zero(dr);
    }
    const auto row = hn::Add(
        hn::Mul(a.material, hn::Set(hn::DFromV<decltype(a.material)>(),
                                    static_cast<hn::TFromV<decltype(a.material)>>(step.law.materials))),
        b.material);
    const ResponseV<V> r = respond<Real>(step, load_coefficients<Real>(step.law, row), t, old, touching);
    store3(r.spring, pairs.spring, at);
    store3(r.force, pairs.force, at);
    if (step.rolling) store3(r.moment, pairs.moment, at);
    if constexpr (kTally) count_response(r, touching, hn::Div(t.overlap, a.radius), sum);

    // Equal and opposite, added in f64 to the rows of this tile; other tiles' partners to the last.
    const Vec3V<V> twist = cross(r.tangential, t.normal);  // = -n x F_t
    const Vec3V<V> ti = add_scaled(r.moment, t.arm_i, twist);
    const Vec3V<V> tj = scale(t.arm_j, twist) - r.moment;
    const auto first = hn::Set(D32U(), tile.first), size = hn::Set(D32U(), tile.size);
    hn::StoreU(hn::Min(hn::Sub(listed_i, first), size), D32U(), rows[0]);
    hn::StoreU(hn::Min(hn::Sub(listed_j, first), size), D32U(), rows[1]);
    const auto one = to_f64(hn::IfThenElseZero(touching, hn::Set(dr, 1)));
    const auto fx = to_f64(r.force.x), fy = to_f64(r.force.y), fz = to_f64(r.force.z);
    const hn::Vec<D64> on_i[8] = {fx, fy, fz, to_f64(ti.x), to_f64(ti.y), to_f64(ti.z), one, hn::Zero(d)};
    add_to_rows(on_i, rows[0], tile.rows);
    const hn::Vec<D64> on_j[8] = {hn::Neg(fx),  hn::Neg(fy),  hn::Neg(fz), to_f64(tj.x),
                                  to_f64(tj.y), to_f64(tj.z), one,         hn::Zero(d)};
    add_to_rows(on_j, rows[1], tile.rows);
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
