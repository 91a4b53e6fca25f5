// Vectors of three over SIMD lanes, fused multiply-add in one place, and 8-wide row transposes.
//
// Included once per Highway target. Contacts are handled in full vectors of Real: in `mixed` that
// is twice as many lanes as an f64 vector has, so what needs f64 is done in two halves and joined.
// The long chains of the law (divisions, roots) then serve twice the contacts.
#if defined(QUERN_KERNELS_SIMD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_KERNELS_SIMD_INL_H_
#undef QUERN_KERNELS_SIMD_INL_H_
#else
#define QUERN_KERNELS_SIMD_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D64 = hn::ScalableTag<double>;
using D64I = hn::RebindToSigned<D64>;
using D64U = hn::RebindToUnsigned<D64>;
using D32I = hn::Rebind<std::int32_t, D64>;
using D32U = hn::Rebind<std::uint32_t, D64>;
// As many Real lanes as f64 lanes, and a full vector of Real lanes.
template <class Real>
using HalfLanes = hn::Rebind<Real, D64>;
template <class Real>
using Lanes = hn::ScalableTag<Real>;
template <class Real>
constexpr std::size_t kHalves = hn::MaxLanes(Lanes<Real>()) / hn::MaxLanes(D64());

template <class V>
struct Vec3V {
  V x, y, z;
};

template <class V>
HWY_INLINE Vec3V<V> operator+(const Vec3V<V>& a, const Vec3V<V>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class V>
HWY_INLINE Vec3V<V> operator-(const Vec3V<V>& a, const Vec3V<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class V>
HWY_INLINE Vec3V<V> scale(V s, const Vec3V<V>& a) {
  return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
// a + s b
template <class V>
HWY_INLINE Vec3V<V> add_scaled(const Vec3V<V>& a, V s, const Vec3V<V>& b) {
  return {hn::MulAdd(s, b.x, a.x), hn::MulAdd(s, b.y, a.y), hn::MulAdd(s, b.z, a.z)};
}
template <class V>
HWY_INLINE V dot(const Vec3V<V>& a, const Vec3V<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
template <class V>
HWY_INLINE Vec3V<V> cross(const Vec3V<V>& a, const Vec3V<V>& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
template <class V, class M>
HWY_INLINE Vec3V<V> keep_if(M mask, const Vec3V<V>& a) {
  return {hn::IfThenElseZero(mask, a.x), hn::IfThenElseZero(mask, a.y),
          hn::IfThenElseZero(mask, a.z)};
}

// f64 lanes to Real lanes and back; the identity in `double`.
template <class Real, class V>
HWY_INLINE auto to_real(V v) {
  if constexpr (sizeof(Real) == sizeof(double)) {
    return v;
  } else {
    return hn::DemoteTo(HalfLanes<Real>(), v);
  }
}
template <class V>
HWY_INLINE auto to_f64(V v) {
  if constexpr (sizeof(hn::TFromV<V>) == sizeof(double)) {
    return v;
  } else {
    return hn::PromoteTo(D64(), v);
  }
}
template <class Real, class V>
HWY_INLINE Vec3V<hn::Vec<HalfLanes<Real>>> to_real(const Vec3V<V>& a) {
  return {to_real<Real>(a.x), to_real<Real>(a.y), to_real<Real>(a.z)};
}

#undef QUERN_AVX512
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
#define QUERN_AVX512 1
#else
#define QUERN_AVX512 0
#endif

// Halves to a full vector of Real lanes and back (one half: the same thing).
template <class Real, class V>
HWY_INLINE auto join(const V& low, [[maybe_unused]] const V& high) {
#if HWY_TARGET == HWY_SCALAR
  return low;
#else
  if constexpr (kHalves<Real> == 1) {
    return low;
  } else {
    return hn::Combine(hn::Rebind<hn::TFromV<V>, Lanes<Real>>(), high, low);
  }
#endif
}
template <class Real, class V>
HWY_INLINE Vec3V<hn::Vec<Lanes<Real>>> join(const Vec3V<V>& low, const Vec3V<V>& high) {
  return {join<Real>(low.x, high.x), join<Real>(low.y, high.y), join<Real>(low.z, high.z)};
}
template <class Real, std::size_t half>
HWY_INLINE hn::Vec<D64> half_f64(hn::Vec<Lanes<Real>> v) {
#if HWY_TARGET == HWY_SCALAR
  return to_f64(v);
#else
  if constexpr (kHalves<Real> == 1) {
    return to_f64(v);
  } else if constexpr (half == 0) {
    return hn::PromoteTo(D64(), hn::LowerHalf(HalfLanes<Real>(), v));
  } else {
    return hn::PromoteTo(D64(), hn::UpperHalf(HalfLanes<Real>(), v));
  }
#endif
}
// Lane sum of both halves in f64.
template <class Real>
HWY_INLINE hn::Vec<D64> folded_f64(hn::Vec<Lanes<Real>> v) {
  if constexpr (kHalves<Real> == 1) {
    return to_f64(v);
  } else {
    return hn::Add(half_f64<Real, 0>(v), half_f64<Real, 1>(v));
  }
}

#if HWY_TARGET != HWY_SCALAR
// Four numbers of each lane, which lie together, as four columns; and back: the same exchange.
template <class V>
HWY_INLINE void turn_quads(V (&c)[4]) {
  const hn::DFromV<V> d;
  const V a = hn::InterleaveLower(d, c[0], c[1]), b = hn::InterleaveUpper(d, c[0], c[1]);
  const V e = hn::InterleaveLower(d, c[2], c[3]), f = hn::InterleaveUpper(d, c[2], c[3]);
  c[0] = hn::ConcatLowerLower(d, e, a);
  c[1] = hn::ConcatLowerLower(d, f, b);
  c[2] = hn::ConcatUpperUpper(d, e, a);
  c[3] = hn::ConcatUpperUpper(d, f, b);
}
#endif

// quad(lane) points to four f64 that may hold other things of 32 bytes: bits are moved, never read.
template <class Quad, class V>
HWY_INLINE void load_quads(const Quad& quad, V (&c)[4]) {
  [[maybe_unused]] const D64 d;
#if QUERN_AVX512
  // Halves of two rows are loaded into one register, in the order that leaves the lanes sorted after
  // two rounds of shuffles instead of three.
  const auto pair = [&](std::size_t low, std::size_t high) HWY_ATTR {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(quad(low))),
                              _mm256_loadu_pd(quad(high)), 1);
  };
  const __m512d r02 = pair(0, 2), r13 = pair(1, 3), r46 = pair(4, 6), r57 = pair(5, 7);
  const __m512d even_a = _mm512_unpacklo_pd(r02, r13), odd_a = _mm512_unpackhi_pd(r02, r13);
  const __m512d even_b = _mm512_unpacklo_pd(r46, r57), odd_b = _mm512_unpackhi_pd(r46, r57);
  c[0] = V{_mm512_shuffle_f64x2(even_a, even_b, 0x88)};
  c[1] = V{_mm512_shuffle_f64x2(odd_a, odd_b, 0x88)};
  c[2] = V{_mm512_shuffle_f64x2(even_a, even_b, 0xdd)};
  c[3] = V{_mm512_shuffle_f64x2(odd_a, odd_b, 0xdd)};
#elif HWY_TARGET == HWY_SCALAR
  for (std::size_t k = 0; k < 4; ++k) {
    double one;
    std::memcpy(&one, quad(0) + k, sizeof one);
    c[k] = hn::Set(d, one);
  }
#else
  if constexpr (hn::MaxLanes(d) == 4) {
    for (std::size_t k = 0; k < 4; ++k) c[k] = hn::LoadU(d, quad(k));
    turn_quads(c);
  } else {
    for (std::size_t k = 0; k < 4; k += 2) {
      const V a = hn::LoadU(d, quad(0) + k), b = hn::LoadU(d, quad(1) + k);
      c[k] = hn::InterleaveLower(d, a, b);
      c[k + 1] = hn::InterleaveUpper(d, a, b);
    }
  }
#endif
}

// Rows of eight f64, one a lane, that lie anywhere: row(lane) points to the first number. As above.
template <class Row, class V>
HWY_INLINE void load_rows(const Row& row, V (&c)[8]) {
  V low[4], high[4];
  load_quads([&](std::size_t lane) HWY_ATTR { return reinterpret_cast<const double*>(row(lane)); },
             low);
  load_quads(
      [&](std::size_t lane) HWY_ATTR { return reinterpret_cast<const double*>(row(lane)) + 4; },
      high);
  for (int k = 0; k < 4; ++k) {
    c[k] = low[k];
    c[4 + k] = high[k];
  }
}

#if QUERN_AVX512
using V64 = hn::Vec<D64>;
HWY_INLINE void transpose8(V64* c) {
  const D64 d;
  V64 a[8], b[8];
  for (int k = 0; k < 8; k += 2) {
    a[k] = hn::InterleaveLower(d, c[k], c[k + 1]);
    a[k + 1] = hn::InterleaveUpper(d, c[k], c[k + 1]);
  }
  // 128-bit blocks now hold two neighbours of a row; turn the 4 x 4 arrangement of blocks.
  for (int k = 0; k < 2; ++k) {
    const V64 p = a[k], q = a[k + 2], r = a[k + 4], s = a[k + 6];
    const V64 pq_even{_mm512_shuffle_f64x2(p.raw, q.raw, 0x88)};
    const V64 pq_odd{_mm512_shuffle_f64x2(p.raw, q.raw, 0xdd)};
    const V64 rs_even{_mm512_shuffle_f64x2(r.raw, s.raw, 0x88)};
    const V64 rs_odd{_mm512_shuffle_f64x2(r.raw, s.raw, 0xdd)};
    b[k + 0] = V64{_mm512_shuffle_f64x2(pq_even.raw, rs_even.raw, 0x88)};
    b[k + 4] = V64{_mm512_shuffle_f64x2(pq_even.raw, rs_even.raw, 0xdd)};
    b[k + 2] = V64{_mm512_shuffle_f64x2(pq_odd.raw, rs_odd.raw, 0x88)};
    b[k + 6] = V64{_mm512_shuffle_f64x2(pq_odd.raw, rs_odd.raw, 0xdd)};
  }
  for (int k = 0; k < 8; ++k) c[k] = b[k];
}
#endif

// Lanes of eight columns as rows: put(lane, at, v) takes numbers at ... of a lane's row, as many as
// a vector has.
template <class V, class Put>
HWY_INLINE void turn_to_rows(const V (&c)[8], const Put& put) {
  [[maybe_unused]] const D64 d;
#if QUERN_AVX512
  V64 t[8] = {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
  transpose8(t);
  for (std::size_t lane = 0; lane < 8; ++lane) put(lane, 0, t[lane]);
#elif HWY_TARGET == HWY_SCALAR
  for (std::size_t at = 0; at < 8; ++at) put(0, at, c[at]);
#else
  if constexpr (hn::MaxLanes(d) == 4) {
    for (std::size_t at = 0; at < 8; at += 4) {
      V q[4] = {c[at], c[at + 1], c[at + 2], c[at + 3]};
      turn_quads(q);
      for (std::size_t lane = 0; lane < 4; ++lane) put(lane, at, q[lane]);
    }
  } else {
    for (std::size_t at = 0; at < 8; at += 2) {
      put(0, at, hn::InterleaveLower(d, c[at], c[at + 1]));
      put(1, at, hn::InterleaveUpper(d, c[at], c[at + 1]));
    }
  }
#endif
}
template <class Row, class V>
HWY_INLINE void store_rows(const V (&c)[8], const Row& row) {
  turn_to_rows(c, [&](std::size_t lane, std::size_t at, V v) HWY_ATTR {
    double* to = reinterpret_cast<double*>(row(lane)) + at;
#if HWY_TARGET == HWY_SCALAR
    const double one = hn::GetLane(v);
    std::memcpy(to, &one, sizeof one);
#else
    hn::StoreU(v, D64(), to);
#endif
  });
}
// Adds to the rows, lane after lane: lanes may share a row.
template <class Row, class V>
HWY_INLINE void add_rows(const V (&c)[8], const Row& row) {
  turn_to_rows(c, [&](std::size_t lane, std::size_t at, V v) HWY_ATTR {
    const D64 d;
    double* to = row(lane) + at;
    hn::Store(hn::Add(hn::Load(d, to), v), d, to);
  });
}

// rows[index[lane]] += c[.][lane]
template <class V>
HWY_INLINE void add_to_rows(const V (&c)[8], const Index* HWY_RESTRICT index,
                            double* HWY_RESTRICT rows) {
  add_rows(c, [&](std::size_t lane) { return rows + 8 * static_cast<std::size_t>(index[lane]); });
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
