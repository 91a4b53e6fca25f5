// Record: the one cache line a contact needs of a random partner.
//
// Structure of arrays is the rule; this is its one measured exception: a lane that meets a random
// partner fetches one line instead of ten. Positions and velocities are f64, so that differences of
// neighbours are exact to 1e-15 m and 1e-15 m/s wherever the mill stands and however fast its bed
// travels; spin and radius have the precision of the force law (Real).
//
//   bytes (mixed)   0      24      28  32     56   64
//                   x y z  radius  wx  v v v  w w
//
// The first half says whether two touch; most listed pairs do not, and their second half stays unread.
// Two copies exist, now and next: tiles read now (their own and their halo's) and write next.
#pragma once

#include <type_traits>

#include "soa/base.h"

namespace quern {

template <class Real>
struct alignas(16) Record {
  double x, y, z;     // m
  Real radius;        // m
  Real wx;            // rad/s, spin at the half step before
  double vx, vy, vz;  // m/s, at the half step before
  Real wy, wz;        // rad/s
};
static_assert(sizeof(Record<float>) == 64);
static_assert(sizeof(Record<double>) == 80);

// What else a contact needs of a partner, in one load. Two copies exist as well.
template <class Real>
struct Traits {
  Real inverse_mass;  // 1/kg; 0 for nothing that moves
  std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t> tag;
};
static_assert(sizeof(Traits<float>) == 8);
static_assert(sizeof(Traits<double>) == 16);

inline constexpr std::size_t kMostMaterials = 256;  // what a tag has room for

// tag: material and group in the lowest bytes, number of contacts of the last step in the high half.
inline std::uint32_t make_tag(std::uint32_t material, std::uint32_t contacts,
                              std::uint32_t group = 0) {
  return material | (group << 8) | (contacts << 16);
}
inline std::uint32_t tag_material(std::uint64_t tag) { return tag & 0xffu; }
inline std::uint32_t tag_group(std::uint64_t tag) { return tag >> 8 & 0xffu; }
inline std::uint32_t tag_contacts(std::uint64_t tag) { return static_cast<std::uint32_t>(tag >> 16); }

}  // namespace quern
