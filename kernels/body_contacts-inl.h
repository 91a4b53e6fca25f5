// Law and sums of contacts with polyhedra, over f64 lanes; see body_contacts.h.
#if defined(QUERN_BODY_CONTACTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_BODY_CONTACTS_INL_H_
#undef QUERN_BODY_CONTACTS_INL_H_
#else
#define QUERN_BODY_CONTACTS_INL_H_
#endif

#include "kernels/body_contacts.h"
#include "kernels/pairs/sphere_sphere-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

HWY_INLINE Vec3V<hn::Vec<D64>> set3(const Vec3& v) {
  const D64 d;
  return {hn::Set(d, v.x()), hn::Set(d, v.y()), hn::Set(d, v.z())};
}
HWY_INLINE Vec3V<hn::Vec<D64>> load3_of(double* const (&from)[3], std::size_t at) {
  return load3<hn::Vec<D64>>(from, at);
}

// Centres and radii of `count` spheres, as seen from `place`.
template <class Real>
void gather_spheres(const StepConstants<double>& step, const ParticleView<Real>& p,
                    const Vec3& from, const Index* sphere, std::size_t count,
                    const GroupLanes& lanes) {
  const D64 d;
  const Vec3V<hn::Vec<D64>> place = set3(from);
  for (std::size_t at = 0; at < count; at += hn::Lanes(d)) {
    const PartnerV<Real> a = load_partner(p, sphere + at);
    Vec3V<hn::Vec<D64>> dx = a.place - place;
    if (step.period[0] > 0) dx.x = nearest_image(dx.x, step.period[0], step.inverse_period[0]);
    if (step.period[1] > 0) dx.y = nearest_image(dx.y, step.period[1], step.inverse_period[1]);
    if (step.period[2] > 0) dx.z = nearest_image(dx.z, step.period[2], step.inverse_period[2]);
    store3(dx, lanes.center, at);
    hn::StoreU(to_f64(a.radius), d, lanes.radius + at);
  }
}

// The elastic side of a normal spring whose overlap may be capped.
template <class V>
HWY_INLINE void set_elastic(V stiffness, double cap, BodyTouchV<V>& t) {
  const hn::DFromV<V> d;
  const V pressed = cap > 0 ? hn::Min(t.overlap, hn::Set(d, cap)) : t.overlap;
  t.elastic_force = hn::Mul(stiffness, pressed);
  // 1/2 k p^2 + k p (overlap - p)
  t.stored = hn::Mul(t.elastic_force, hn::NegMulAdd(hn::Set(d, 0.5), pressed, t.overlap));
}

// What one vector of contacts needs: the sphere is i, the polyhedron is j.
template <class Real>
struct NearTouchV {
  using V = hn::Vec<D64>;
  BodyTouchV<V> touch;
  Vec3V<V> point;  // of the contact, from the polyhedron's place
  V arm;           // centre of the sphere to the contact point
};

// Geometry, now and a step ago. `old` points to normal, overlap and contact point of then.
template <class Real>
HWY_INLINE void set_near_geometry(const PartnerV<Real>& a, const NearContacts<Real>& c,
                                  std::size_t at, const Real* old, NearTouchV<Real>& g) {
  const D64 d;
  using V = hn::Vec<D64>;
  using C = NearContacts<Real>;
  const HalfLanes<Real> dr;
  const auto history = [&](std::size_t k) HWY_ATTR {
    return to_f64(hn::LoadU(dr, old + k * c.stride));
  };
  const auto load = [&](int k) HWY_ATTR { return hn::LoadU(d, c.row(k) + at); };
  const auto vector = [&](int k) HWY_ATTR { return Vec3V<V>{load(k), load(k + 1), load(k + 2)}; };
  BodyTouchV<V>& t = g.touch;
  const V half = hn::Set(d, 0.5), radius = to_f64(a.radius);
  t.normal = vector(C::kNormal);
  t.overlap = load(C::kOverlap);
  g.point = vector(C::kPoint);
  t.normal_old = {history(0), history(1), history(2)};
  t.overlap_old = history(3);
  const Vec3V<V> point_old = {history(4), history(5), history(6)};
  t.spin_i = {to_f64(a.spin.x), to_f64(a.spin.y), to_f64(a.spin.z)};
  t.spin_j = vector(C::kSpin);
  const Vec3V<V> velocity = a.velocity - vector(C::kVelocity);
  g.arm = hn::NegMulAdd(half, t.overlap, radius);
  const V arm_old = hn::NegMulAdd(half, t.overlap_old, radius);
  t.at_point = velocity - cross(scale(g.arm, t.spin_i), t.normal) - cross(t.spin_j, g.point);
  t.at_old = velocity - cross(scale(arm_old, t.spin_i), t.normal_old) - cross(t.spin_j, point_old);
  t.normal_velocity = dot(t.normal, t.at_point);
  const V inverse_i = to_f64(a.inverse_mass), inverse_j = load(C::kInverseMass);
  const V z_i = to_f64(a.contacts), z_j = load(C::kContacts);
  t.inverse_mass = hn::Add(inverse_i, inverse_j);
  t.count_rate = hn::MulAdd(z_i, inverse_i, hn::Mul(z_j, inverse_j));
  const V turning_i = hn::Mul(hn::Set(d, 3.5), inverse_i);
  const V turning_j = hn::MulAdd(dot(g.point, g.point), load(C::kMobility), inverse_j);
  t.tangential_inverse = hn::Add(turning_i, turning_j);
  t.tangential_count_rate = hn::MulAdd(z_i, turning_i, hn::Mul(z_j, turning_j));
  t.contacts = hn::Add(z_i, z_j);
  t.rolling_radius = t.inverse_inertia = hn::Zero(d);
}

// Law, rows of the spheres, forces on the polyhedra. `step` has no rolling friction.
template <class Real>
void push_spheres(const StepConstants<double>& step, const ParticleView<Real>& p,
                  const NearContacts<Real>& c, const TileRows& tile, ContactTally& tally) {
  const D64 d;
  const HalfLanes<Real> dr;
  using V = hn::Vec<D64>;
  using C = NearContacts<Real>;
  const V zero = hn::Zero(d);
  TallySumV sum = zero_tally_sum();
  for (std::size_t at = 0; at < c.count; at += hn::Lanes(d)) {
    Real* history = c.history + at;
    const auto load = [&](std::size_t k) HWY_ATTR {
      return to_f64(hn::LoadU(dr, history + k * c.stride));
    };
    const auto store = [&](std::size_t k, const Vec3V<V>& v) HWY_ATTR {
      store3(to_real<Real>(v), history + k * c.stride, c.stride);
    };
    HistoryV<V> old;
    old.spring = {load(0), load(1), load(2)};
    old.force = {load(3), load(4), load(5)};
    old.moment = {zero, zero, zero};
    const PartnerV<Real> a = load_partner(p, c.sphere + at);
    NearTouchV<Real> g;
    set_near_geometry(a, c, at, history + 6 * c.stride, g);
    BodyTouchV<V>& t = g.touch;
    const auto touching = hn::Gt(t.overlap, zero);
    hn::Vec<D64I> row;
    if constexpr (sizeof(Real) == sizeof(double)) {
      row = a.material;
    } else {
      row = hn::PromoteTo(D64I(), a.material);
    }
    const auto of_body =
        hn::PromoteTo(D64I(), hn::BitCast(D32I(), hn::LoadU(D32U(), c.material + at)));
    row = hn::Add(hn::Mul(row, hn::Set(D64I(), step.law.materials)), of_body);
    const auto k = load_coefficients<double>(step.law, row);
    set_elastic(k.kn, c.overlap_cap, t);
    const ResponseV<V> r = respond<double>(step, k, t, old, touching);
    store(0, r.spring);
    store(3, r.force);
    store(6, keep_if(touching, t.normal));
    hn::StoreU(to_real<Real>(hn::IfThenElseZero(touching, t.overlap)), dr, history + 9 * c.stride);
    store(10, keep_if(touching, g.point));
    count_response<double>(r, touching, hn::Div(t.overlap, to_f64(a.radius)), sum);
    const V one = hn::IfThenElseZero(touching, hn::Set(d, 1));
    const Vec3V<V> torque_i = scale(g.arm, cross(r.tangential, t.normal));
    add_to_partners<double, 0>(r.force, torque_i, one, c.sphere + at, tile);
    const Vec3V<V> on_j = {hn::Neg(r.force.x), hn::Neg(r.force.y), hn::Neg(r.force.z)};
    store3(on_j, c.row(C::kForce) + at, c.stride);
    store3(cross(r.force, g.point), c.row(C::kTorque) + at, c.stride);
  }
  add_tally(sum, tally);
}

// The law for contacts of polyhedra among themselves and with walls.
inline void push_bodies(const StepConstants<double>& step, const BodyContacts& c) {
  const D64 d;
  using V = hn::Vec<D64>;
  for (std::size_t at = 0; at < c.count; at += hn::Lanes(d)) {
    const auto load = [&](int k) HWY_ATTR { return hn::LoadU(d, c.row(k) + at); };
    const auto vector = [&](int k) HWY_ATTR {
      return Vec3V<V>{load(k), load(k + 1), load(k + 2)};
    };
    using B = BodyContacts;
    BodyTouchV<V> t;
    t.normal = vector(B::kNormal);
    t.normal_old = vector(B::kNormalOld);
    t.overlap = load(B::kOverlap);
    t.overlap_old = load(B::kOverlapOld);
    t.at_point = vector(B::kAtPoint);
    t.at_old = vector(B::kAtOld);
    t.normal_velocity = dot(t.normal, t.at_point);
    t.spin_i = vector(B::kSpinI);
    t.spin_j = vector(B::kSpinJ);
    t.inverse_mass = load(B::kInverseMass);
    t.tangential_inverse = load(B::kTangentialInverse);
    t.count_rate = load(B::kCountRate);
    t.tangential_count_rate = load(B::kTangentialCountRate);
    t.elastic_force = load(B::kElasticForce);
    t.stored = load(B::kStored);
    t.contacts = t.rolling_radius = t.inverse_inertia = hn::Zero(d);
    const V zero = hn::Zero(d);
    const HistoryV<V> old = {vector(B::kSpring), vector(B::kForce), {zero, zero, zero}};
    const auto row = hn::PromoteTo(D64I(), hn::BitCast(D32I(), hn::LoadU(D32U(), c.law_row + at)));
    const ResponseV<V> r = respond<double>(step, load_coefficients<double>(step.law, row), t, old,
                                           hn::Gt(t.overlap, zero));
    const auto store = [&](int k, V v) HWY_ATTR { hn::StoreU(v, d, c.row(k) + at); };
    store3(r.spring, c.row(B::kSpring) + at, c.stride);
    store3(r.force, c.row(B::kForce) + at, c.stride);
    store(B::kWork, r.work);
    store(B::kElastic, r.elastic);
    store(B::kSlide, r.slide);
    store(B::kTangentialDamping, r.tangential_damping);
    store(B::kNumericalLoss, r.numerical_loss);
    store(B::kReduction, r.reduction);
    store(B::kNormalForce, dot(r.force, t.normal));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
