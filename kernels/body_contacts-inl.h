// Law and sums of contacts with polyhedra, over f64 lanes; see body_contacts.h.
#if defined(QUERN_BODY_CONTACTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_BODY_CONTACTS_INL_H_
#undef QUERN_BODY_CONTACTS_INL_H_
#else
#define QUERN_BODY_CONTACTS_INL_H_
#endif

#include "kernels/body_contacts.h"
#include "kernels/pairs/sphere_sphere-inl.h"
#include "soa/polyhedra.h"

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
template <class Springs, class V>
HWY_INLINE void set_elastic(const CoefficientsV<V>& table, double cap, BodyTouchV<V>& t) {
  const hn::DFromV<V> d;
  const V pressed = cap > 0 ? hn::Min(t.overlap, hn::Set(d, cap)) : t.overlap;
  const V stiffness = Springs::at(table, hn::Max(pressed, hn::Zero(d)), t.reduced_radius).kn;
  t.elastic_force = hn::Mul(stiffness, pressed);
  // s k p^2 + k p (overlap - p)
  t.stored =
      hn::Mul(t.elastic_force, hn::NegMulAdd(hn::Set(d, 1 - Springs::kStored), pressed, t.overlap));
}

// What one vector of contacts needs: the sphere is i, the polyhedron is j.
template <class Real>
struct NearTouchV {
  using V = hn::Vec<D64>;
  BodyTouchV<V> touch;
  Vec3V<V> point;  // of the contact, from the polyhedron's place
  V arm;           // centre of the sphere to the contact point
};

// History of a slot in f64 lanes: spring, force, normal and overlap of the last step, contact
// point, episode.
constexpr int kNearHistory = 16;
static_assert(kNearHistory == PolyhedronSphereBatch<float>::kHistoryStride);

template <class Real>
HWY_INLINE void load_history(Real* const* history, hn::Vec<D64> (&h)[kNearHistory]) {
  hn::Vec<D64> c[8];
  if constexpr (sizeof(Real) == sizeof(double)) {
    for (int half = 0; half < 2; ++half) {
      load_rows([&](std::size_t lane) { return history[lane] + 8 * half; }, c);
      for (int k = 0; k < 8; ++k) h[8 * half + k] = c[k];
    }
  } else {
    load_rows([&](std::size_t lane) { return history[lane]; }, c);
    for (int k = 0; k < 8; ++k) {  // pairs of f32
      const auto bits = hn::BitCast(D64U(), c[k]);
      h[2 * k] = to_f64(hn::BitCast(HalfLanes<Real>(), hn::TruncateTo(D32U(), bits)));
      h[2 * k + 1] =
          to_f64(hn::BitCast(HalfLanes<Real>(), hn::TruncateTo(D32U(), hn::ShiftRight<32>(bits))));
    }
  }
}
template <class Real>
HWY_INLINE void store_history(const hn::Vec<D64> (&h)[kNearHistory], Real* const* history) {
  hn::Vec<D64> c[8];
  if constexpr (sizeof(Real) == sizeof(double)) {
    for (int half = 0; half < 2; ++half) {
      for (int k = 0; k < 8; ++k) c[k] = h[8 * half + k];
      store_rows(c, [&](std::size_t lane) { return history[lane] + 8 * half; });
    }
  } else {
    const auto bits = [](hn::Vec<D64> v) HWY_ATTR {
      return hn::PromoteTo(D64U(), hn::BitCast(D32U(), to_real<Real>(v)));
    };
    for (int k = 0; k < 8; ++k) {
      c[k] = hn::BitCast(D64(), hn::Or(bits(h[2 * k]), hn::ShiftLeft<32>(bits(h[2 * k + 1]))));
    }
    store_rows(c, [&](std::size_t lane) { return history[lane]; });
  }
}

// Geometry, now and a step ago.
template <class Real>
HWY_INLINE void set_near_geometry(const PartnerV<Real>& a, const NearContacts<Real>& c,
                                  std::size_t at, const hn::Vec<D64> (&old)[kNearHistory],
                                  NearTouchV<Real>& g) {
  const D64 d;
  using V = hn::Vec<D64>;
  V found[8], body[8];
  load_rows([&](std::size_t lane) { return c.touch[at + lane].normal; }, found);
  load_rows([&](std::size_t lane) { return c.motion[at + lane]; }, body);
  BodyTouchV<V>& t = g.touch;
  const V half = hn::Set(d, 0.5), radius = to_f64(a.radius);
  t.normal = {found[0], found[1], found[2]};
  t.overlap = found[3];
  g.point = {found[4], found[5], found[6]};
  t.normal_old = {old[6], old[7], old[8]};
  t.overlap_old = old[9];
  const Vec3V<V> point_old = {old[10], old[11], old[12]};
  t.spin_i = {to_f64(a.spin.x), to_f64(a.spin.y), to_f64(a.spin.z)};
  t.spin_j = {body[3], body[4], body[5]};
  const Vec3V<V> velocity = a.velocity - Vec3V<V>{body[0], body[1], body[2]};
  g.arm = hn::NegMulAdd(half, t.overlap, radius);
  const V arm_old = hn::NegMulAdd(half, t.overlap_old, radius);
  t.at_point = velocity - cross(scale(g.arm, t.spin_i), t.normal) - cross(t.spin_j, g.point);
  t.at_old = velocity - cross(scale(arm_old, t.spin_i), t.normal_old) - cross(t.spin_j, point_old);
  t.normal_velocity = dot(t.normal, t.at_point);
  const V inverse_i = to_f64(a.inverse_mass), inverse_j = body[6];
  const V z_i = to_f64(a.contacts), z_j = found[7];
  t.inverse_mass = hn::Add(inverse_i, inverse_j);
  t.count_rate = hn::MulAdd(z_i, inverse_i, hn::Mul(z_j, inverse_j));
  const V turning_i = hn::Mul(hn::Set(d, 3.5), inverse_i);
  const V turning_j = hn::MulAdd(dot(g.point, g.point), body[7], inverse_j);
  t.tangential_inverse = hn::Add(turning_i, turning_j);
  t.tangential_count_rate = hn::MulAdd(z_i, turning_i, hn::Mul(z_j, turning_j));
  t.contacts = hn::Add(z_i, z_j);
  t.inverse_inertia = hn::Zero(d);
  const V radius_j = hn::LoadU(d, c.radius + at);
  t.reduced_radius = hn::Div(hn::Mul(radius, radius_j), hn::Add(radius, radius_j));
}

// Law, rows of the spheres, sums of the groups. `step` has no rolling friction.
template <class Real, class Springs>
void push_spheres(const StepConstants<double>& step, const ParticleView<Real>& p,
                  const NearContacts<Real>& c, const TileRows& tile, ContactTally& tally) {
  const D64 d;
  using V = hn::Vec<D64>;
  const V zero = hn::Zero(d);
  TallySumV sum = zero_tally_sum();
  for (std::size_t at = 0; at < c.count; at += hn::Lanes(d)) {
    V h[kNearHistory];
    load_history(c.history + at, h);
    HistoryV<V> old;
    old.spring = {h[0], h[1], h[2]};
    old.force = {h[3], h[4], h[5]};
    old.rest = old.moment = {zero, zero, zero};
    const PartnerV<Real> a = load_partner(p, c.sphere + at);
    NearTouchV<Real> g;
    set_near_geometry(a, c, at, h, g);
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
    set_elastic<Springs>(k, c.overlap_cap, t);
    const ResponseV<V> r = respond<double, DampedLaw<Springs>>(step, k, t, old, touching);
    if (HWY_UNLIKELY(!hn::AllTrue(d, hn::IsFinite(hn::Add(r.work, r.elastic))))) {
      *c.odd = at + static_cast<std::size_t>(
                        hn::FindFirstTrue(d, hn::Not(hn::IsFinite(hn::Add(r.work, r.elastic)))));
    }
    const Vec3V<V> normal = keep_if(touching, t.normal), point = keep_if(touching, g.point);
    const V now[kNearHistory] = {
        r.spring.x, r.spring.y, r.spring.z, r.force.x, r.force.y,
        r.force.z,  normal.x,   normal.y,   normal.z,  hn::IfThenElseZero(touching, t.overlap),
        point.x,    point.y,    point.z,    h[13],     h[14],
        h[15]};
    store_history(now, c.history + at);
    if (c.told != nullptr) {
      const V half_mass = hn::Div(hn::Set(d, 0.5), t.inverse_mass);
      const V told[8] = {r.work,
                         r.elastic,
                         r.slide,
                         r.tangential_damping,
                         t.overlap_old,
                         hn::Mul(half_mass, hn::Mul(t.normal_velocity, t.normal_velocity)),
                         hn::Mul(half_mass, dot(t.at_point, t.at_point)),
                         zero};
      store_rows(told, [&](std::size_t lane) { return &c.told[at + lane].work; });
    }
    const V smaller = hn::Min(to_f64(a.radius), hn::LoadU(d, c.radius + at));
    count_response<double, DampedLaw<Springs>>(r, touching, hn::Div(t.overlap, smaller), smaller,
                                               c.overlap_cap, sum);
    const V one = hn::IfThenElseZero(touching, hn::Set(d, 1));
    const Vec3V<V> torque_i = scale(g.arm, cross(r.tangential, t.normal));
    add_to_particles<double, 0>(r.force, torque_i, one, c.sphere + at, tile);
    const Vec3V<V> torque_j = cross(r.force, g.point);
    V on_j[8] = {hn::Neg(r.force.x),
                 hn::Neg(r.force.y),
                 hn::Neg(r.force.z),
                 torque_j.x,
                 torque_j.y,
                 torque_j.z,
                 one,
                 zero};
    add_rows(on_j, [&](std::size_t lane) { return c.sums[at + lane]; });
  }
  add_tally(sum, tally);
}

// The law for contacts of polyhedra among themselves and with walls.
template <class Springs>
void push_bodies(const StepConstants<double>& step, const BodyContacts& c) {
  const D64 d;
  using V = hn::Vec<D64>;
  for (std::size_t at = 0; at < c.count; at += hn::Lanes(d)) {
    const auto load = [&](int k) HWY_ATTR { return hn::LoadU(d, c.row(k) + at); };
    const auto vector = [&](int k) HWY_ATTR { return Vec3V<V>{load(k), load(k + 1), load(k + 2)}; };
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
    t.reduced_radius = load(B::kReducedRadius);
    t.contacts = t.inverse_inertia = hn::Zero(d);
    const V zero = hn::Zero(d);
    const Vec3V<V> none = {zero, zero, zero};
    const HistoryV<V> old = {vector(B::kSpring), vector(B::kForce), none, none};
    const auto row = hn::PromoteTo(D64I(), hn::BitCast(D32I(), hn::LoadU(D32U(), c.law_row + at)));
    const ResponseV<V> r = respond<double, DampedLaw<Springs>>(
        step, load_coefficients<double>(step.law, row), t, old, hn::Gt(t.overlap, zero));
    const auto store = [&](int k, V v) HWY_ATTR { hn::StoreU(v, d, c.row(k) + at); };
    store3(r.spring, c.row(B::kSpring) + at, c.stride);
    store3(r.force, c.row(B::kForce) + at, c.stride);
    store(B::kWork, r.work);
    store(B::kElastic, r.elastic);
    store(B::kSlide, r.slide);
    store(B::kTangentialDamping, r.tangential_damping);
    store(B::kNumericalLoss, r.numerical_loss);
    store(B::kModelWork, r.model_work);
    store(B::kReduction, r.reduction);
    store(B::kNormalForce, dot(r.force, t.normal));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
