// Peak arithmetic for every SIMD target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/peak.cpp"
#include "kernels/peak.h"

#include <hwy/foreach_target.h>

#include "kernels/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// Twelve chains cover the latency of two units and leave registers for the constants, of sixteen
// too; from different starts, or they were one. x -> x / 2 + 1/2 stays between 0 and 1.
template <class Real>
PeakRun multiply_adds(std::size_t rounds) {
  const Lanes<Real> d;
  using V = hn::Vec<Lanes<Real>>;
  const V half = hn::Set(d, Real(0.5));
  const auto start = [&](int chain) HWY_ATTR { return hn::Set(d, Real(0.01) * Real(chain)); };
  V a = start(0), b = start(1), c = start(2), e = start(3), f = start(4), g = start(5);
  V h = start(6), i = start(7), j = start(8), k = start(9), l = start(10), m = start(11);
  for (std::size_t round = 0; round < rounds; ++round) {
    a = hn::MulAdd(a, half, half);
    b = hn::MulAdd(b, half, half);
    c = hn::MulAdd(c, half, half);
    e = hn::MulAdd(e, half, half);
    f = hn::MulAdd(f, half, half);
    g = hn::MulAdd(g, half, half);
    h = hn::MulAdd(h, half, half);
    i = hn::MulAdd(i, half, half);
    j = hn::MulAdd(j, half, half);
    k = hn::MulAdd(k, half, half);
    l = hn::MulAdd(l, half, half);
    m = hn::MulAdd(m, half, half);
  }
  const V sum = hn::Add(
      hn::Add(hn::Add(a, b), hn::Add(c, e)),
      hn::Add(hn::Add(hn::Add(f, g), hn::Add(h, i)), hn::Add(hn::Add(j, k), hn::Add(l, m))));
  return {24.0 * static_cast<double>(rounds) * static_cast<double>(hn::Lanes(d)),
          static_cast<double>(hn::GetLane(hn::SumOfLanes(d, sum)))};
}

PeakRun multiply_adds_f32(std::size_t rounds) { return multiply_adds<float>(rounds); }
PeakRun multiply_adds_f64(std::size_t rounds) { return multiply_adds<double>(rounds); }

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(multiply_adds_f32);
HWY_EXPORT(multiply_adds_f64);

template <>
PeakRun run_multiply_adds<float>(std::size_t rounds) {
  return HWY_DYNAMIC_DISPATCH(multiply_adds_f32)(rounds);
}
template <>
PeakRun run_multiply_adds<double>(std::size_t rounds) {
  return HWY_DYNAMIC_DISPATCH(multiply_adds_f64)(rounds);
}

}  // namespace quern
#endif
