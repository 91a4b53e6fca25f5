// Spring-dashpot contact with tangential history and Coulomb friction, over SIMD lanes: force only.
//
//   F_n = kn' delta - w c_n' v_n              (clamped: never pulls)
//   T   = -kt' xi_t - c_t' v_t,  |F_t| <= mu |F_n|
//   M   = -w_r/|w_r| min(mu_r R* F_n, I* |w_r| / (dt max(2, Z_i + Z_j)))      rolling friction
//
// What all laws share: the implicit damping of kernels/README.md (kn', kt' make an isolated pair
// the implicit midpoint rule; c_n', c_t' are bounded by the contacts Z that the partners had in the
// last step, which keeps dense packings stable down to 4 steps per contact; w is the share of the
// step in which a fresh contact touched), friction, rolling (Zhou et al. 1999; Ai et al. 2011,
// model A) and the ledger. A law (laws/linear_spring_dashpot-inl.h, laws/hertz_mindlin-inl.h) says
// what stiffnesses and dashpots are at an overlap and what the normal spring stores.
#if defined(QUERN_SPRING_DASHPOT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_SPRING_DASHPOT_INL_H_
#undef QUERN_SPRING_DASHPOT_INL_H_
#else
#define QUERN_SPRING_DASHPOT_INL_H_
#endif

#include <type_traits>

#include "kernels/contact.h"
#include "kernels/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// Coefficients of each lane: those of its pair of materials, or what a law makes of them.
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
  Vec3V<V> normal, normal_old;  // unit, from j to i
  V overlap, overlap_old;       // m
  V normal_velocity;            // m/s, < 0 on approach
  Vec3V<V> at_point, at_old;  // m/s, of i - of j at the contact point; with the arms of a step ago
  Vec3V<V> spin_i, spin_j;    // rad/s
  V inverse_mass;             // 1/m_e
  V count_rate;               // Z_i/m_i + Z_j/m_j
  V contacts;                 // Z_i + Z_j
  V reduced_radius;           // R*; where the law asks for it
  V inverse_inertia;          // 1/I*
};

// `rest` is what rounding has left of the spring in earlier steps: without it a bed at rest, which
// slips by less than a last place of its springs a step, would creep.
template <class V>
struct HistoryV {
  Vec3V<V> spring, force, rest, moment;
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
  Vec3V<V> force, tangential, moment, spring, rest;
  V work, elastic, slide, tangential_damping, numerical_loss;
  V model_work;  // J, put into the tangential spring by a stiffness that changed; kChanging only
  V reduction;   // kn' / kn
};

// What a law leaves out where a scene has none of it: a contact pays for what it models. Springs is
//   static constexpr bool kChanging;   whether stiffnesses change with the overlap
//   static constexpr double kStored;   energy of the normal spring over its force times the overlap
//   static CoefficientsV<V> at(const CoefficientsV<V>&, V overlap, V reduced_radius)
template <class Springs>
struct RollingLaw : Springs {
  static constexpr bool kDamped = true, kRolling = true, kRecorded = false;
};
template <class Springs>
struct DampedLaw : Springs {  // tangential damping, no rolling friction
  static constexpr bool kDamped = true, kRolling = false, kRecorded = false;
};
template <class Springs>
struct PlainLaw : Springs {
  static constexpr bool kDamped = false, kRolling = false, kRecorded = false;
};
template <class Law>
struct Recorded : Law {  // collisions are recorded
  static constexpr bool kRecorded = true;
};

// What turning the tangential spring with the contact adds to it: the rotation that takes the old
// normal to the new one (length kept), then by the partners' mean spin about the normal. `inverse`
// is that of 1 + n.n_old.
template <class V>
HWY_INLINE Vec3V<V> turning_of(const Vec3V<V>& spring, const TouchV<V>& t, V half_dt, V inverse) {
  const hn::DFromV<V> d;
  const Vec3V<V>& n = t.normal;
  const V turn = hn::Mul(dot(spring, n), hn::Neg(inverse));
  const Vec3V<V> across = scale(turn, n + t.normal_old), carried = spring + across;
  const V angle = hn::Mul(half_dt, dot(t.spin_i + t.spin_j, n));
  const V shorter = hn::Mul(hn::Mul(hn::Set(d, hn::TFromV<V>(-0.5)), angle), angle);
  return add_scaled(add_scaled(across, shorter, carried), angle, cross(n, carried));
}

// Constants of a contact with what the step's length takes off them, see kernels/README.md.
template <class V>
struct ReducedV {
  V kn, kt, cn, ct;  // kn', kt', c_n', c_t'
  V reduction;       // kn' / kn
  V turn;            // 1 / (1 + n.n_old), for the spring
};

// With s = sqrt(1/m_e) and h = dt/2, of the normal and likewise of the tangential direction,
//   kn' = kn / (1 + h a s)      c_n' = a / (s + h a max(1/m_e, Z_i/m_i + Z_j/m_j))
// which is the text's form multiplied by s. All quotients come from one division.
template <bool kDamped, class Touch, class V>
HWY_INLINE ReducedV<V> reduce(const CoefficientsV<V>& k, const Touch& t, V half_dt) {
  constexpr bool kBodies = std::is_same_v<Touch, BodyTouchV<V>>;
  using T = hn::TFromV<V>;
  const hn::DFromV<V> d;
  const V one = hn::Set(d, 1), half = hn::Set(d, T(0.5));
  const V root = hn::Sqrt(t.inverse_mass), an = hn::Mul(half_dt, k.an);
  const V pair_n = hn::MulAdd(an, root, one);
  const V crowd_n = hn::MulAdd(an, hn::Max(t.inverse_mass, t.count_rate), root);
  // 1 + n.n_old is near 2; lanes without a contact may hold anything and must not divide by zero.
  const V turned = hn::Max(hn::Add(one, dot(t.normal, t.normal_old)), half);
  const V normals = hn::Mul(pair_n, crowd_n);
  ReducedV<V> r;
  if constexpr (kDamped) {
    // m_e / m_t of spheres is 7/2; a_t holds the root of its inverse.
    const V ratio = hn::Set(d, T(3.5)), root_ratio = hn::Set(d, T(1.8708286933869707));
    V inverse_t = hn::Mul(ratio, t.inverse_mass), root_t = hn::Mul(root_ratio, root);
    V count_rate_t = hn::Mul(ratio, t.count_rate);
    if constexpr (kBodies) {
      inverse_t = t.tangential_inverse;
      root_t = hn::Sqrt(inverse_t);
      count_rate_t = t.tangential_count_rate;
    }
    const V at = hn::Mul(root_ratio, k.at), hat = hn::Mul(half_dt, at);
    const V pair_t = hn::MulAdd(hat, root_t, one);
    const V crowd_t = hn::MulAdd(hat, hn::Max(inverse_t, count_rate_t), root_t);
    const V tangents = hn::Mul(pair_t, crowd_t), all = hn::Mul(normals, tangents);
    const V inverse = hn::Div(one, hn::Mul(all, turned));
    const V inverse_all = hn::Mul(inverse, turned);
    const V inverse_n = hn::Mul(inverse_all, tangents), inverse_ts = hn::Mul(inverse_all, normals);
    r.reduction = hn::Mul(inverse_n, crowd_n);
    r.cn = hn::Mul(k.an, hn::Mul(inverse_n, pair_n));
    r.kt = hn::Mul(k.kt, hn::Mul(inverse_ts, crowd_t));
    r.ct = hn::Mul(at, hn::Mul(inverse_ts, pair_t));
    r.turn = hn::Mul(inverse, all);
  } else {
    const V inverse = hn::Div(one, hn::Mul(normals, turned));
    const V inverse_n = hn::Mul(inverse, turned);
    r.reduction = hn::Mul(inverse_n, crowd_n);
    r.cn = hn::Mul(k.an, hn::Mul(inverse_n, pair_n));
    r.kt = k.kt;
    r.ct = hn::Zero(d);
    r.turn = hn::Mul(inverse, normals);
  }
  r.kn = hn::Mul(k.kn, r.reduction);
  return r;
}

// Touch is TouchV for spheres (I = 2/5 m r^2 on both sides) and walls, BodyTouchV for other bodies.
// `table` is of the pair of materials.
template <class Real, class Law, class Touch, class V = hn::Vec<Lanes<Real>>,
          class M = hn::Mask<Lanes<Real>>>
HWY_INLINE ResponseV<V> respond(const StepConstants<Real>& step, const CoefficientsV<V>& table,
                                const Touch& t, const HistoryV<V>& old, M touching) {
  constexpr bool kBodies = std::is_same_v<Touch, BodyTouchV<V>>;
  const Lanes<Real> d;
  const V zero = hn::Zero(d), one = hn::Set(d, 1), half = hn::Set(d, Real(0.5));
  const V dt = hn::Set(d, static_cast<Real>(step.dt));
  const V half_dt = hn::Set(d, static_cast<Real>(0.5 * step.dt));
  const V tiny = hn::Set(d, Real(1e-15));
  // As deep as the springs take it; those of bodies have been capped before.
  V pressed = t.overlap, depth_old = hn::Max(t.overlap_old, zero);
  const bool capped = !kBodies && step.overlap_cap > 0;
  if (HWY_UNLIKELY(capped)) {
    const V most = hn::Set(d, static_cast<Real>(step.overlap_cap));
    pressed = hn::Min(pressed, most);
    depth_old = hn::Min(depth_old, most);
  }
  // A lost contact gives back what it was a step ago.
  const CoefficientsV<V> k =
      Law::at(table, hn::IfThenElse(touching, pressed, depth_old), t.reduced_radius);
  const ReducedV<V> c = reduce<Law::kDamped>(k, t, half_dt);
  V kt_old = c.kt;
  if constexpr (Law::kChanging) {
    kt_old = reduce<Law::kDamped>(Law::at(table, depth_old, t.reduced_radius), t, half_dt).kt;
  }
  const Vec3V<V>& n = t.normal;
  const V vn = t.normal_velocity;
  ResponseV<V> r;
  r.reduction = c.reduction;

  // Normal force. w v_n of a first touch is v_n/2 - overlap/dt.
  const V closing = hn::Neg(hn::Mul(vn, dt));
  const M fresh = hn::And(touching, hn::Lt(t.overlap, closing));
  V damped_velocity = vn;
  if (step.clamped) {
    const V rate = hn::Set(d, static_cast<Real>(1 / step.dt));
    damped_velocity = hn::IfThenElse(fresh, hn::NegMulAdd(rate, t.overlap, hn::Mul(half, vn)), vn);
  }
  V spring_n = hn::Mul(c.kn, pressed);
  if constexpr (kBodies) spring_n = hn::Mul(c.reduction, t.elastic_force);
  V fn = hn::NegMulAdd(c.cn, damped_velocity, spring_n);
  if (step.clamped) fn = hn::Max(zero, fn);
  fn = hn::IfThenElseZero(touching, fn);

  // Tangential force: trial, then Coulomb's cap on spring and dashpot together.
  const Vec3V<V> vt = add_scaled(t.at_point, hn::Neg(dot(n, t.at_point)), n);
  const Vec3V<V> turning = turning_of(old.spring, t, half_dt, c.turn);
  const Vec3V<V> stretch = add_scaled(old.rest + turning, dt, vt);
  const Vec3V<V> spring_old = keep_if(touching, old.spring + turning);
  const Vec3V<V> spring_trial = keep_if(touching, old.spring + stretch);
  const V cap = hn::Mul(k.mu, hn::Abs(fn));
  const V trial2 = dot(spring_trial, spring_trial);
  const V spring_force = hn::Mul(c.kt, hn::Sqrt(trial2));
  V spring_cut;
  if constexpr (Law::kDamped) {
    const V ct_here = hn::IfThenElseZero(touching, c.ct);
    const Vec3V<V> trial = scale(hn::Neg(c.kt), spring_trial) + scale(hn::Neg(ct_here), vt);
    const V trial_size = hn::Sqrt(dot(trial, trial));
    const V size_a = hn::Max(trial_size, tiny), size_b = hn::Max(spring_force, tiny);
    const V cap_over_both = hn::Div(cap, hn::Mul(size_a, size_b));
    const M slides = hn::Gt(trial_size, cap);
    r.tangential = scale(hn::IfThenElse(slides, hn::Mul(cap_over_both, size_b), one), trial);
    spring_cut = hn::IfThenElse(hn::And(slides, hn::Gt(spring_force, cap)),
                                hn::Mul(cap_over_both, size_a), one);
    r.spring = scale(spring_cut, spring_trial);
  } else {
    spring_cut =
        hn::IfThenElse(hn::Gt(spring_force, cap), hn::Div(cap, hn::Max(spring_force, tiny)), one);
    r.spring = scale(spring_cut, spring_trial);
    r.tangential = scale(hn::Neg(c.kt), r.spring);
  }
  // A spring that is cut starts anew.
  r.rest =
      keep_if(hn::And(touching, hn::Eq(spring_cut, one)), stretch - (spring_trial - old.spring));
  r.force = add_scaled(r.tangential, fn, n);
  r.moment = {zero, zero, zero};
  const Vec3V<V> spin = t.spin_i - t.spin_j;
  if (Law::kRolling && step.rolling) {
    const Vec3V<V> roll = add_scaled(spin, hn::Neg(dot(spin, n)), n);
    const V size = hn::Sqrt(dot(roll, roll));
    const V most = hn::Mul(hn::Mul(k.mur, t.reduced_radius), fn);
    const V stop =
        hn::Div(size, hn::Mul(hn::Mul(t.inverse_inertia, dt), hn::Max(hn::Set(d, 2), t.contacts)));
    r.moment =
        scale(hn::Neg(hn::Div(hn::Min(hn::Max(most, zero), stop), hn::Max(size, tiny))), roll);
  }

  // Ledger: exact work of old and new force over the step, see scheduler/README.md.
  r.work = hn::Mul(half_dt, hn::Add(dot(old.force, t.at_old), dot(r.force, t.at_point)));
  if (Law::kRolling && step.rolling) {
    r.work = hn::MulAdd(half_dt, dot(old.moment + r.moment, spin), r.work);
  }
  V stored = hn::Mul(hn::Set(d, Real(Law::kStored)), hn::Mul(c.kn, hn::Mul(t.overlap, t.overlap)));
  if (HWY_UNLIKELY(capped)) {
    // s k p^2 + k p (overlap - p)
    const V beyond = hn::NegMulAdd(hn::Set(d, Real(1 - Law::kStored)), pressed, t.overlap);
    stored = hn::Mul(spring_n, beyond);
  }
  if constexpr (kBodies) stored = hn::Mul(c.reduction, t.stored);
  const V half_kt = hn::Mul(half, c.kt);
  const V kept2 = hn::Mul(hn::Mul(spring_cut, spring_cut), trial2);
  r.elastic = hn::IfThenElseZero(touching, hn::MulAdd(half_kt, kept2, stored));
  // 1/2 (kt'_old xi_old + kt' xi) . (xi_t - xi) with xi = cut xi_t. A lost contact gives its whole
  // spring to sliding: trial = old spring, kept = 0.
  const V met = dot(spring_old, spring_trial);
  const V given = hn::Mul(hn::Sub(one, spring_cut), hn::MulAdd(spring_cut, trial2, met));
  const V lost_spring = hn::IfThenZeroElse(touching, dot(old.spring, old.spring));
  r.slide = hn::Mul(half_kt, hn::Add(given, lost_spring));
  r.model_work = zero;
  if constexpr (Law::kChanging) {
    // 1/2 (kt' - kt'_old) xi_old . xi: nobody does this work.
    const V grown = hn::Mul(hn::Mul(half, hn::Sub(c.kt, kt_old)), met);
    r.slide = hn::NegMulAdd(hn::Sub(one, spring_cut), grown, r.slide);
    r.model_work = hn::Mul(spring_cut, grown);
  }
  const V fn_old = dot(old.force, t.normal_old);
  r.tangential_damping = zero;
  if (Law::kDamped && step.damped) {
    // -dt/2 (dashpot_old + dashpot) . v_t, a dashpot being the tangential force + kt' xi.
    Vec3V<V> sum = add_scaled(old.force + r.tangential, c.kt, old.spring + r.spring);
    if constexpr (Law::kChanging) sum = add_scaled(sum, hn::Sub(kt_old, c.kt), old.spring);
    const V both = hn::NegMulAdd(fn_old, dot(t.normal_old, vt), dot(sum, vt));
    r.tangential_damping = hn::Neg(hn::Mul(half_dt, both));
  }
  // With s = kStored, at first touch -kn' d (s d + dt v_n / 2), at loss of contact
  // kn' d_old (s d_old - dt v_n / 2).
  const M lost = hn::And(hn::Not(touching), hn::Gt(fn_old, zero));
  const V changed = hn::IfThenElse(fresh, t.overlap, hn::IfThenElseZero(lost, t.overlap_old));
  const V twice = hn::Set(d, Real(2 * Law::kStored));
  const V short_of = hn::IfThenElse(fresh, hn::NegMulAdd(twice, t.overlap, closing),
                                    hn::MulAdd(twice, t.overlap_old, closing));
  r.numerical_loss = hn::Mul(hn::Mul(half, c.kn), hn::Mul(changed, short_of));
  return r;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
