// Linear spring-dashpot with tangential history and Coulomb friction, over SIMD lanes: force only.
//
//   F_n = kn' delta - w c_n' v_n              (clamped: never pulls)
//   T   = -kt' xi_t - c_t' v_t,  |F_t| <= mu |F_n|
//   M   = -w_r/|w_r| min(mu_r R* F_n, I* |w_r| / (dt max(2, Z_i + Z_j)))      rolling friction
//
// Equations 3-7 of Xie, Ma, Song, Zhao, Powder Technology 386 (2021) 154-165, with the implicit
// damping of kernels/README.md: kn', kt' make an isolated pair the implicit midpoint rule; c_n', c_t'
// are bounded by the contacts Z that the partners had in the last step, which keeps dense packings
// stable down to 4 steps per contact; w is the share of the step in which a fresh contact touched.
// Rolling: Zhou et al. 1999; Ai et al. 2011, model A. c = 2 zeta sqrt(m k) with zeta from
// Schwager & Poeschel 2007 (clamped) or the plain damped oscillator (unclamped), see materials.h.
#if defined(QUERN_LINEAR_SPRING_DASHPOT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_LINEAR_SPRING_DASHPOT_INL_H_
#undef QUERN_LINEAR_SPRING_DASHPOT_INL_H_
#else
#define QUERN_LINEAR_SPRING_DASHPOT_INL_H_
#endif

#include <type_traits>

#include "kernels/contact.h"
#include "kernels/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// Coefficients of each lane's pair of materials.
template <class V>
struct CoefficientsV {
  V kn, kt, an, at, mu, mur;
};

template <class Real>
HWY_INLINE CoefficientsV<hn::Vec<Lanes<Real>>> load_coefficients(
    const LawTable<Real>& law, hn::Vec<hn::RebindToSigned<Lanes<Real>>> row) {
  const Lanes<Real> d;
  if (law.materials == 1) {
    return {hn::Set(d, law.normal_stiffness[0]), hn::Set(d, law.tangential_stiffness[0]),
            hn::Set(d, law.normal_damping[0]),   hn::Set(d, law.tangential_damping[0]),
            hn::Set(d, law.sliding_friction[0]), hn::Set(d, law.rolling_friction[0])};
  }
  return {hn::GatherIndex(d, law.normal_stiffness, row),
          hn::GatherIndex(d, law.tangential_stiffness, row),
          hn::GatherIndex(d, law.normal_damping, row),
          hn::GatherIndex(d, law.tangential_damping, row),
          hn::GatherIndex(d, law.sliding_friction, row),
          hn::GatherIndex(d, law.rolling_friction, row)};
}

// What a pair type knows of its contacts; a wall is j with inverse mass 0 and the velocity of its
// contact point.
template <class V>
struct TouchV {
  Vec3V<V> normal, normal_old;       // unit, from j to i
  V overlap, overlap_old;            // m
  V normal_velocity;                 // m/s, < 0 on approach
  Vec3V<V> at_point, at_old;         // m/s, of i - of j at the contact point; with the arms of a step ago
  Vec3V<V> spin_i, spin_j;           // rad/s
  V inverse_mass;                    // 1/m_e
  V count_rate;                      // Z_i/m_i + Z_j/m_j
  V contacts;                        // Z_i + Z_j
  V rolling_radius;                  // R*
  V inverse_inertia;                 // 1/I*
};

template <class V>
struct HistoryV {
  Vec3V<V> spring, force, moment;
};

// What bodies that are no spheres have besides: their tangential mobility is not 3.5/m, and the
// spring force need not be stiffness times overlap.
template <class V>
struct BodyTouchV : TouchV<V> {
  V tangential_inverse;     // 1/m_t = sum of 1/m + r^2/I
  V tangential_count_rate;  // sum of Z (1/m + r^2/I)
  V elastic_force;          // N, at full stiffness
  V stored;                 // J, of that force
};

// Everything a contact did in this step; masked lanes are zero.
template <class V>
struct ResponseV {
  Vec3V<V> force, tangential, moment, spring;
  V work, elastic, slide, tangential_damping, numerical_loss;
  V reduction;  // kn' / kn
};

// Turns the tangential spring with the contact: the rotation that takes the old normal to the new
// one (length kept), then by the partners' mean spin about the normal.
template <class V>
HWY_INLINE Vec3V<V> carry_spring(const Vec3V<V>& spring, const TouchV<V>& t, V dt) {
  const hn::DFromV<V> d;
  const V one = hn::Set(d, 1);
  const V half = hn::Set(d, hn::TFromV<V>(0.5));
  const Vec3V<V>& n = t.normal;
  const V along = dot(spring, n);
  // 1 + n.n_old is near 2; lanes without a contact may hold anything and must not divide by zero.
  const V turn = hn::Neg(hn::Div(along, hn::Max(hn::Add(one, dot(n, t.normal_old)), half)));
  const Vec3V<V> carried = add_scaled(spring, turn, n + t.normal_old);
  const V angle = hn::Mul(hn::Mul(half, dt), dot(t.spin_i + t.spin_j, n));
  const V shorten = hn::NegMulAdd(hn::Mul(half, angle), angle, one);
  return add_scaled(scale(shorten, carried), angle, cross(n, carried));
}

// Touch is TouchV for spheres (I = 2/5 m r^2 on both sides) and walls, BodyTouchV for other bodies.
template <class Real, class Touch, class V = hn::Vec<Lanes<Real>>, class M = hn::Mask<Lanes<Real>>>
HWY_INLINE ResponseV<V> respond(const StepConstants<Real>& step, const CoefficientsV<V>& k,
                                const Touch& t, const HistoryV<V>& old, M touching) {
  constexpr bool kBodies = std::is_same_v<Touch, BodyTouchV<V>>;
  const Lanes<Real> d;
  const V zero = hn::Zero(d), one = hn::Set(d, 1), half = hn::Set(d, Real(0.5));
  const V dt = hn::Set(d, static_cast<Real>(step.dt));
  const V half_dt = hn::Mul(half, dt);
  const V tiny = hn::Set(d, Real(1e-15));
  const V spheres = hn::Set(d, Real(3.5));  // m_e / m_t of spheres

  // Rates of the dashpots and the effective constants.
  const V root_mass = hn::Div(one, hn::Sqrt(t.inverse_mass));
  const V cn = hn::Mul(k.an, root_mass);
  const V rate_n = hn::Mul(half_dt, hn::Mul(cn, t.inverse_mass));
  const V crowd = hn::Max(one, hn::Mul(t.count_rate, hn::Mul(root_mass, root_mass)));
  V ct = hn::Mul(k.at, root_mass), inverse_mt = hn::Mul(t.inverse_mass, spheres), crowd_of_t = crowd;
  if constexpr (kBodies) {
    inverse_mt = t.tangential_inverse;
    const V mt = hn::Div(one, inverse_mt);
    ct = hn::Mul(k.at, hn::Sqrt(hn::Mul(spheres, mt)));
    crowd_of_t = hn::Max(one, hn::Mul(t.tangential_count_rate, mt));
  }
  const V rate_t = hn::Mul(half_dt, hn::Mul(ct, inverse_mt));
  // Four quotients by one division: all divisors are of order one.
  const V pair_n = hn::Add(one, rate_n), pair_t = hn::Add(one, rate_t);
  const V crowd_n = hn::MulAdd(rate_n, crowd, one), crowd_t = hn::MulAdd(rate_t, crowd_of_t, one);
  const V pairs = hn::Mul(pair_n, pair_t), crowds = hn::Mul(crowd_n, crowd_t);
  const V inverse = hn::Div(one, hn::Mul(pairs, crowds));
  const V inverse_pairs = hn::Mul(inverse, crowds), inverse_crowds = hn::Mul(inverse, pairs);
  ResponseV<V> r;
  r.reduction = hn::Mul(inverse_pairs, pair_t);
  const V kn = hn::Mul(k.kn, r.reduction);
  const V kt = hn::Mul(k.kt, hn::Mul(inverse_pairs, pair_n));
  const V cn_bound = hn::Mul(cn, hn::Mul(inverse_crowds, crowd_t));
  const V ct_bound = hn::Mul(ct, hn::Mul(inverse_crowds, crowd_n));

  const Vec3V<V>& n = t.normal;
  const V vn = t.normal_velocity;
  const Vec3V<V> vt = add_scaled(t.at_point, hn::Neg(dot(n, t.at_point)), n);

  // Normal force.
  const V closing = hn::Neg(hn::Mul(vn, dt));
  const M fresh = hn::And(touching, hn::And(hn::Lt(vn, zero), hn::Lt(t.overlap, closing)));
  V weight = one;
  if (step.clamped) {
    weight = hn::IfThenElse(fresh, hn::Add(half, hn::Div(t.overlap, hn::Max(closing, tiny))), one);
  }
  V spring_n = hn::Mul(kn, t.overlap);
  if constexpr (kBodies) spring_n = hn::Mul(r.reduction, t.elastic_force);
  V fn = hn::NegMulAdd(hn::Mul(weight, cn_bound), vn, spring_n);
  if (step.clamped) fn = hn::Max(zero, fn);
  fn = hn::IfThenElseZero(touching, fn);

  // Tangential force: trial, then Coulomb's cap on spring and dashpot together.
  const Vec3V<V> spring_old = keep_if(touching, carry_spring(old.spring, t, dt));
  const Vec3V<V> spring_trial = add_scaled(spring_old, hn::IfThenElseZero(touching, dt), vt);
  const V ct_here = hn::IfThenElseZero(touching, ct_bound);
  const Vec3V<V> trial = scale(hn::Neg(kt), spring_trial) + scale(hn::Neg(ct_here), vt);
  const V cap = hn::Mul(k.mu, hn::Abs(fn));
  const V trial_size = hn::Sqrt(dot(trial, trial));
  const M slides = hn::Gt(trial_size, cap);
  const V spring_force = hn::Mul(kt, hn::Sqrt(dot(spring_trial, spring_trial)));
  const V size_a = hn::Max(trial_size, tiny), size_b = hn::Max(spring_force, tiny);
  const V cap_over_both = hn::Div(cap, hn::Mul(size_a, size_b));
  const V cut = hn::IfThenElse(slides, hn::Mul(cap_over_both, size_b), one);
  const V spring_cut = hn::IfThenElse(hn::And(slides, hn::Gt(spring_force, cap)),
                                      hn::Mul(cap_over_both, size_a), one);
  r.tangential = scale(cut, trial);
  r.spring = scale(spring_cut, spring_trial);
  r.force = add_scaled(r.tangential, fn, n);
  r.moment = {zero, zero, zero};
  const Vec3V<V> spin = t.spin_i - t.spin_j;
  if (step.rolling) {
    const Vec3V<V> roll = add_scaled(spin, hn::Neg(dot(spin, n)), n);
    const V size = hn::Sqrt(dot(roll, roll));
    const V most = hn::Mul(hn::Mul(k.mur, t.rolling_radius), fn);
    const V stop = hn::Div(size, hn::Mul(hn::Mul(t.inverse_inertia, dt),
                                         hn::Max(hn::Set(d, 2), t.contacts)));
    r.moment = scale(hn::Neg(hn::Div(hn::Min(hn::Max(most, zero), stop), hn::Max(size, tiny))), roll);
  }

  // Ledger: exact work of old and new force over the step, see scheduler/README.md.
  r.work =
      hn::MulAdd(half_dt, dot(old.force, t.at_old), hn::Mul(half_dt, dot(r.force, t.at_point)));
  if (step.rolling) {
    r.work = hn::MulAdd(half_dt, dot(old.moment + r.moment, spin), r.work);
  }
  V pressed = hn::Mul(hn::Mul(kn, half), hn::Mul(t.overlap, t.overlap));
  if constexpr (kBodies) pressed = hn::Mul(r.reduction, t.stored);
  const V stored = hn::MulAdd(hn::Mul(kt, half), dot(r.spring, r.spring), pressed);
  r.elastic = hn::IfThenElseZero(touching, stored);
  // A lost contact gives its whole spring to sliding: trial = old spring, kept = 0.
  const Vec3V<V> given = spring_trial - r.spring;
  const V lost_spring = hn::IfThenZeroElse(touching, dot(old.spring, old.spring));
  r.slide = hn::Mul(hn::Mul(half, kt),
                    hn::Add(dot(spring_old + r.spring, given), lost_spring));
  const V fn_old = dot(old.force, t.normal_old);
  r.tangential_damping = zero;
  if (step.damped) {
    const Vec3V<V> dashpot_old =
        add_scaled(add_scaled(old.force, hn::Neg(fn_old), t.normal_old), kt, old.spring);
    const Vec3V<V> dashpot = add_scaled(r.tangential, kt, r.spring);
    r.tangential_damping =
        hn::Neg(hn::Mul(half_dt, dot(dashpot_old + keep_if(touching, dashpot), vt)));
  }
  const V entry = hn::Neg(hn::Mul(hn::Mul(half, hn::Mul(kn, t.overlap)),
                                  hn::MulAdd(dt, vn, t.overlap)));
  const M lost = hn::And(hn::Not(touching), hn::Gt(fn_old, zero));
  const V exit = hn::Mul(hn::Mul(half, hn::Mul(kn, t.overlap_old)),
                         hn::NegMulAdd(dt, vn, t.overlap_old));
  r.numerical_loss = hn::Add(hn::IfThenElseZero(fresh, entry), hn::IfThenElseZero(lost, exit));
  return r;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
