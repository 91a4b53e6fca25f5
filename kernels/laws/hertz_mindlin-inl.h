// Hertz-Mindlin with Tsuji's damping: stiffnesses grow with the contact's radius a = sqrt(R* delta).
//
//   F_n = 4/3 E* a delta - c_n v_n,   c_n = 2 zeta sqrt(5/6 m_e 2 E* a)
//   F_t = -8 G* a xi - c_t v_t,       c_t = 2 zeta sqrt(5/6 m_e 8 G* a)
//   1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j      1/G* = (2 - nu_i)/G_i + (2 - nu_j)/G_j
//   G = E / (2 (1 + nu))                            1/R* = 1/R_i + 1/R_j
//
// Hertz, J. reine angew. Math. 92 (1882) 156; Mindlin, J. Appl. Mech. 16 (1949) 259, without slip;
// Tsuji, Tanaka, Ishida, Powder Technology 71 (1992) 239: a dashpot that goes as delta^(1/4)
// delivers one restitution at all speeds. In delta^(5/4) the impact is that of linear springs with
// the same zeta (Antypov & Elliott, EPL 94 (2011) 50004), where the force turns around too, so that
// zeta is that of laws/damping.h, clamped and unclamped. Smooth elastic bodies, overlaps well below
// R*.
//
// xi is carried and cut to the cone as with linear springs. F_t is k_t of now times all of xi: a
// stiffness that grows stretches nothing and stores energy from nowhere, one that falls loses it;
// the ledger books that as model work. Tables: 4/3 E*, 8 G* (Pa), a_n = 2 zeta sqrt(5/4 4/3 E*),
// a_t = 2 zeta sqrt(5/6 8 G*).
#if defined(QUERN_HERTZ_MINDLIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_HERTZ_MINDLIN_INL_H_
#undef QUERN_HERTZ_MINDLIN_INL_H_
#else
#define QUERN_HERTZ_MINDLIN_INL_H_
#endif

#include "kernels/laws/spring_dashpot-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

struct HertzMindlin {
  static constexpr bool kChanging = true;
  static constexpr double kStored = 0.4;
  template <class V>
  static HWY_INLINE CoefficientsV<V> at(const CoefficientsV<V>& table, V overlap,
                                        V reduced_radius) {
    const V a = hn::Sqrt(hn::Mul(reduced_radius, overlap)), root = hn::Sqrt(a);
    return {hn::Mul(table.kn, a),
            hn::Mul(table.kt, a),
            hn::Mul(table.an, root),
            hn::Mul(table.at, root),
            table.mu,
            table.mur};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
