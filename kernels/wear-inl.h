// What contacts of spheres with walls wear off in a step, over SIMD lanes: the terms of wear.h, whose
// wear_of() is the twin of this. Plain f64 in every precision.
#if defined(QUERN_WEAR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_WEAR_INL_H_
#undef QUERN_WEAR_INL_H_
#else
#define QUERN_WEAR_INL_H_
#endif

#include "kernels/simd-inl.h"
#include "kernels/wear.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// As WearContact in wear.h.
struct WearContactV {
  using V = hn::Vec<D64>;
  Vec3V<V> normal, force, velocity, at_point, braked;
  V slide, friction, mass;
  hn::Mask<D64> touching, first_touch;
};

// m v^2 times Finnie's function of the angle, of the velocity's two parts.
HWY_INLINE hn::Vec<D64> finnie_energy(hn::Vec<D64> mass, hn::Vec<D64> in, hn::Vec<D64> along,
                                      double force_ratio) {
  const D64 d;
  const auto flat = hn::Mul(in, hn::Sub(hn::Add(along, along),
                                        hn::Mul(hn::Set(d, 6 / force_ratio), in)));
  const auto steep = hn::Mul(hn::Set(d, force_ratio / 6), hn::Mul(along, along));
  const auto is_flat =
      hn::Lt(hn::Mul(hn::Set(d, 6), in), hn::Mul(hn::Set(d, force_ratio), along));
  return hn::Mul(mass, hn::IfThenElse(is_flat, flat, steep));
}

HWY_INLINE void store_wear(const WearContactV& c, double dt, double force_ratio,
                           double* const (&rows)[kWearSums], std::size_t at) {
  const D64 d;
  using V = hn::Vec<D64>;
  const V zero = hn::Zero(d), time = hn::Set(d, dt);
  const auto along_wall = [&](const Vec3V<V>& v, V out)
                              HWY_ATTR { return v - scale(out, c.normal); };
  const V push = dot(c.normal, c.force), out = dot(c.normal, c.velocity);
  const Vec3V<V> friction = along_wall(c.force, push);
  const Vec3V<V> along = along_wall(c.at_point, dot(c.normal, c.at_point));
  const V power = dot(friction, along), size = hn::Sqrt(dot(friction, friction));
  const auto put = [&](WearSum sum, hn::Mask<D64> counts, V value) HWY_ATTR {
    hn::StoreU(hn::IfThenElseZero(hn::And(c.touching, counts), value), d, rows[sum] + at);
  };
  const auto loses = hn::Lt(power, zero), brakes = hn::Lt(dot(friction, c.braked), zero);
  put(kSiemEnergy, hn::And(loses, brakes), hn::Neg(hn::Mul(time, power)));
  hn::StoreU(c.slide, d, rows[kSlidingEnergy] + at);
  const V cone = hn::Mul(hn::Set(d, kAtTheCone), hn::Mul(c.friction, push));
  const auto slides = hn::And(hn::Gt(push, zero), hn::Ge(size, cone));
  put(kArchardWork, slides, hn::Mul(hn::Mul(push, hn::Sqrt(dot(along, along))), time));
  const Vec3V<V> flat = along_wall(c.velocity, out);
  put(kFinnieEnergy, hn::And(c.first_touch, hn::Lt(out, zero)),
      finnie_energy(c.mass, hn::Neg(out), hn::Sqrt(dot(flat, flat)), force_ratio));
  put(kNormalImpulse, c.touching, hn::Mul(push, time));
  put(kShearImpulse, c.touching, hn::Mul(size, time));
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
