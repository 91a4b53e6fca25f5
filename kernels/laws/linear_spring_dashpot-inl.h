// Linear springs: stiffnesses of the pair of materials, whatever the overlap.
//
//   F_n = k_n delta - c_n v_n,  F_t = -k_t xi - c_t v_t,  c = 2 zeta sqrt(m k)
//
// Equations 3-7 of Xie, Ma, Song, Zhao, Powder Technology 386 (2021) 154-165. zeta from the
// restitution: Schwager & Poeschel 2007 (clamped) or the plain damped oscillator (unclamped), see
// laws/damping.h. Tables: kn, kt (N/m), a_n = 2 zeta sqrt(kn), a_t = 2 zeta sqrt(2/7 kt).
#if defined(QUERN_LINEAR_SPRING_DASHPOT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_LINEAR_SPRING_DASHPOT_INL_H_
#undef QUERN_LINEAR_SPRING_DASHPOT_INL_H_
#else
#define QUERN_LINEAR_SPRING_DASHPOT_INL_H_
#endif

#include "kernels/laws/spring_dashpot-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

struct LinearSprings {
  static constexpr bool kChanging = false;
  static constexpr double kStored = 0.5;
  template <class V>
  static HWY_INLINE CoefficientsV<V> at(const CoefficientsV<V>& table, V, V) {
    return table;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
