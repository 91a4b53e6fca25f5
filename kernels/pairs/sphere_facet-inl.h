// Sphere against wall: force of the contacts that the narrow phase (sphere_facet.cpp) has found.
//
// Lanes are contacts, f64 in every precision: wall contacts are few, and a spring that rides on a
// rotating wall for ten thousand turns must not lose a bit a step. The wall is partner j with
// inverse mass 0 and the velocity of the contact point, so that its motion enters the law.
#if defined(QUERN_SPHERE_FACET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_SPHERE_FACET_INL_H_
#undef QUERN_SPHERE_FACET_INL_H_
#else
#define QUERN_SPHERE_FACET_INL_H_
#endif

#include "kernels/pair_loop-inl.h"
#include "kernels/wear-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

template <class Real, class Springs>
void sphere_facet(const StepConstants<double>& step, const ParticleView<Real>& p,
                  const WallContacts& walls, const TileRows& tile, ContactTally& tally) {
  const D64 d;
  using V = hn::Vec<D64>;
  using Law = RollingLaw<Springs>;
  const std::size_t lanes = hn::Lanes(d);
  const V zero = hn::Zero(d), half = hn::Set(d, 0.5);
  TallySumV sum = zero_tally_sum();
  HWY_ALIGN Index rows[16];
  for (std::size_t at = 0; at < walls.count; at += lanes) {
    const PartnerV<Real> a = load_partner(p, walls.particle + at);
    const V radius = to_f64(a.radius), inverse_mass = to_f64(a.inverse_mass);
    const V contacts = to_f64(a.contacts);
    const auto geometry = [&](int k) HWY_ATTR { return hn::LoadU(d, walls.geometry[k] + at); };
    TouchV<V> t;
    t.normal = {geometry(0), geometry(1), geometry(2)};
    t.overlap = geometry(3);
    t.normal_old = {geometry(4), geometry(5), geometry(6)};
    t.overlap_old = geometry(7);
    const Vec3V<V> wall_velocity = {geometry(8), geometry(9), geometry(10)};
    const Vec3V<V> wall_velocity_old = {geometry(14), geometry(15), geometry(16)};
    const Vec3V<V> velocity = a.velocity - wall_velocity;
    t.normal_velocity = dot(t.normal, velocity);
    t.spin_i = {to_f64(a.spin.x), to_f64(a.spin.y), to_f64(a.spin.z)};
    t.spin_j = {geometry(11), geometry(12), geometry(13)};
    const V arm = hn::NegMulAdd(half, t.overlap, radius);
    const V arm_old = hn::NegMulAdd(half, t.overlap_old, radius);
    t.at_point = velocity - cross(scale(arm, t.spin_i), t.normal);
    t.at_old = a.velocity - wall_velocity_old - cross(scale(arm_old, t.spin_i), t.normal_old);
    t.inverse_mass = inverse_mass;
    t.count_rate = hn::Mul(contacts, inverse_mass);
    t.contacts = contacts;
    t.reduced_radius = radius;
    t.inverse_inertia = hn::Div(hn::Mul(hn::Set(d, 2.5), inverse_mass), hn::Mul(radius, radius));
    HistoryV<V> old;
    old.spring = load3<V>(walls.spring, at);
    old.force = load3<V>(walls.force, at);
    old.rest = {zero, zero, zero};
    old.moment = load3<V>(walls.moment, at);
    const auto touching = hn::Gt(t.overlap, zero);
    const auto wall_material =
        hn::PromoteTo(D64I(), hn::BitCast(D32I(), hn::LoadU(D32U(), walls.material + at)));
    hn::Vec<D64I> material;
    if constexpr (sizeof(Real) == sizeof(double)) {
      material = a.material;
    } else {
      material = hn::PromoteTo(D64I(), a.material);
    }
    const auto row = hn::Add(hn::Mul(material, hn::Set(D64I(), step.law.materials)), wall_material);
    const CoefficientsV<V> coefficients = load_coefficients<double>(step.law, row);
    const ResponseV<V> r = respond<double, Law>(step, coefficients, t, old, touching);
    const V half_dt = hn::Set(d, 0.5 * step.dt);
    const V pushed = hn::Add(dot(old.force, wall_velocity_old), dot(r.force, wall_velocity));
    const V turned = step.rolling ? dot(old.moment + r.moment, t.spin_j) : zero;
    hn::StoreU(hn::Mul(half_dt, hn::Add(pushed, turned)), d, walls.wall_work + at);
    const V energies[4] = {r.work, r.elastic, r.slide, r.tangential_damping};
    for (int k = 0; k < 4; ++k) hn::StoreU(energies[k], d, walls.energies[k] + at);
    if (step.wears) {
      const WearContactV c = {t.normal,
                              r.force,
                              velocity,
                              t.at_point,
                              step.wear_absolute ? a.velocity : velocity,
                              r.slide,
                              coefficients.mu,
                              hn::Div(hn::Set(d, 1), inverse_mass),
                              touching,
                              hn::AndNot(hn::Gt(t.overlap_old, zero), touching)};
      store_wear(c, step.dt, step.finnie_force_ratio, walls.wear, at);
    }
    store3(r.spring, walls.spring, at);
    store3(r.force, walls.force, at);
    store3(r.moment, walls.moment, at);
    count_response<double, Law>(r, touching, hn::Div(t.overlap, radius), radius, step.overlap_cap,
                                sum);

    const Vec3V<V> torque = add_scaled(r.moment, arm, cross(r.tangential, t.normal));
    const auto index = hn::Sub(hn::LoadU(D32U(), walls.particle + at), hn::Set(D32U(), tile.first));
    hn::StoreU(index, D32U(), rows);
    const V one = hn::IfThenElseZero(touching, hn::Set(d, 1));
    const V on_i[8] = {r.force.x, r.force.y, r.force.z, torque.x, torque.y, torque.z, one, zero};
    add_to_rows(on_i, rows, tile.rows);
  }
  add_tally(sum, tally);
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
