// Free rotation of rigid bodies over SIMD lanes; see rotate.h.
//
// Each turn about a principal axis needs sine and cosine of the half angle, which turn q; their
// double-angle values turn the body-frame momentum along. Half angles of a run are about 1e-4: up
// to 1/8 polynomials are exact to rounding, lanes beyond take the library's functions. q is brought
// back to unit length by one Newton step, which divides by nothing and leaves padding at zero.
#if defined(QUERN_ROTATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_ROTATE_INL_H_
#undef QUERN_ROTATE_INL_H_
#else
#define QUERN_ROTATE_INL_H_
#endif

#include <cmath>

#include "kernels/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

template <class V>
struct QuatV {
  V w, x, y, z;
};

template <class V>
struct SineCosineV {
  V sine, cosine;
};

// Taylor to x^9 and x^10: for |x| <= 1/8 the first term left out is below 1e-17 of the value.
template <class V>
HWY_INLINE SineCosineV<V> sine_cosine(V x) {
  const hn::DFromV<V> d;
  const auto set = [&](double v) { return hn::Set(d, v); };
  const V x2 = hn::Mul(x, x);
  V s = hn::MulAdd(x2, set(1.0 / 362880), set(-1.0 / 5040));
  s = hn::MulAdd(x2, s, set(1.0 / 120));
  s = hn::MulAdd(x2, s, set(-1.0 / 6));
  s = hn::MulAdd(hn::Mul(x2, x), s, x);
  V c = hn::MulAdd(x2, set(-1.0 / 3628800), set(1.0 / 40320));
  c = hn::MulAdd(x2, c, set(-1.0 / 720));
  c = hn::MulAdd(x2, c, set(1.0 / 24));
  c = hn::MulAdd(x2, c, set(-0.5));
  c = hn::MulAdd(x2, c, set(1.0));
  const auto large = hn::Gt(hn::Abs(x), set(0.125));
  if (HWY_UNLIKELY(!hn::AllFalse(d, large))) {
    HWY_ALIGN double angle[hn::MaxLanes(d)], sine[hn::MaxLanes(d)], cosine[hn::MaxLanes(d)];
    hn::Store(x, d, angle);
    for (std::size_t k = 0; k < hn::Lanes(d); ++k) {
      sine[k] = std::sin(angle[k]);
      cosine[k] = std::cos(angle[k]);
    }
    s = hn::IfThenElse(large, hn::Load(d, sine), s);
    c = hn::IfThenElse(large, hn::Load(d, cosine), c);
  }
  return {s, c};
}

// v in the body frame (turn back by q) and in the world frame: v + 2 w u x v + 2 u x (u x v).
template <class V>
HWY_INLINE Vec3V<V> turn(const QuatV<V>& q, V twice_w, const Vec3V<V>& v) {
  const Vec3V<V> u = {q.x, q.y, q.z};
  const Vec3V<V> t = cross(u, v);
  return add_scaled(add_scaled(v, twice_w, t), hn::Set(hn::DFromV<V>(), 2.0), cross(u, t));
}
template <class V>
HWY_INLINE Vec3V<V> to_body(const QuatV<V>& q, const Vec3V<V>& v) {
  return turn(q, hn::Mul(hn::Set(hn::DFromV<V>(), -2.0), q.w), v);
}
template <class V>
HWY_INLINE Vec3V<V> to_world(const QuatV<V>& q, const Vec3V<V>& v) {
  return turn(q, hn::Add(q.w, q.w), v);
}

// Turns q about its own axis a by theta = rate * p.a, and the momentum p (body frame) with it; b, c
// are the axes that follow a. `qa` ... name the parts of q along them.
template <class V>
HWY_INLINE void turn_about(V rate, V pa, V& pb, V& pc, V& qw, V& qa, V& qb, V& qc) {
  const SineCosineV<V> half = sine_cosine(hn::Mul(rate, pa));
  const V s = half.sine, c = half.cosine;
  const V sine = hn::Mul(hn::Add(s, s), c);
  const V versine = hn::Mul(hn::Add(s, s), s);
  const V b = hn::NegMulAdd(versine, pb, hn::MulAdd(sine, pc, pb));
  pc = hn::NegMulAdd(versine, pc, hn::NegMulAdd(sine, pb, pc));
  pb = b;
  const V w = hn::MulSub(qw, c, hn::Mul(qa, s));
  qa = hn::MulAdd(qw, s, hn::Mul(qa, c));
  const V next = hn::MulAdd(qb, c, hn::Mul(qc, s));
  qc = hn::MulSub(qc, c, hn::Mul(qb, s));
  qb = next;
  qw = w;
}

template <class V>
HWY_INLINE QuatV<V> rotate_freely(QuatV<V> q, const Vec3V<V>& momentum,
                                  const Vec3V<V>& inverse_inertia, V dt) {
  const hn::DFromV<V> d;
  Vec3V<V> p = to_body(q, momentum);
  const V half = hn::Mul(hn::Set(d, 0.5), dt), quarter = hn::Mul(hn::Set(d, 0.25), dt);
  const V x = hn::Mul(quarter, inverse_inertia.x), y = hn::Mul(quarter, inverse_inertia.y);
  turn_about(x, p.x, p.y, p.z, q.w, q.x, q.y, q.z);
  turn_about(y, p.y, p.z, p.x, q.w, q.y, q.z, q.x);
  turn_about(hn::Mul(half, inverse_inertia.z), p.z, p.x, p.y, q.w, q.z, q.x, q.y);
  turn_about(y, p.y, p.z, p.x, q.w, q.y, q.z, q.x);
  turn_about(x, p.x, p.y, p.z, q.w, q.x, q.y, q.z);
  const V norm2 =
      hn::MulAdd(q.w, q.w, hn::MulAdd(q.x, q.x, hn::MulAdd(q.y, q.y, hn::Mul(q.z, q.z))));
  const V fix = hn::NegMulAdd(hn::Set(d, 0.5), norm2, hn::Set(d, 1.5));
  return {hn::Mul(q.w, fix), hn::Mul(q.x, fix), hn::Mul(q.y, fix), hn::Mul(q.z, fix)};
}

template <class V>
HWY_INLINE Vec3V<V> spin_of(const QuatV<V>& q, const Vec3V<V>& momentum,
                            const Vec3V<V>& inverse_inertia) {
  const Vec3V<V> p = to_body(q, momentum);
  return to_world(q, Vec3V<V>{hn::Mul(p.x, inverse_inertia.x), hn::Mul(p.y, inverse_inertia.y),
                              hn::Mul(p.z, inverse_inertia.z)});
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
