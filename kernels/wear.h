// What contacts with walls wear off: the terms of four models, one contact and step at a time.
//
//   SIEM      -dt F_t.v_t where F_t.v_t < 0 (the spring gives nothing back) and F_t.u < 0 (friction
//             brakes the particle, its spin does not drive it); the worn volume is that / (4 p)
//   sliding   what the contact law dissipates by sliding, as volume likewise: a contact that sticks
//             and swings wears nothing
//   Archard   F_n |v_t| dt while the contact slides; the volume is k times that / H
//   Finnie    at first touch m v^2 (sin 2a - 6/K sin^2 a) for tan a < K/6, else m v^2 K cos^2 a /
//   6;
//             the volume is that / (p psi K)
//
// F_t, v_t: friction on the particle, and its surface's velocity along the wall; u: velocity of its
// centre; both from the wall's point. a: angle between the way in and the wall. Sources and what
// the constants are: kernels/README.md. Sums are of these terms, so that constants can be set after
// a run. Plain f64.
#pragma once

#include <vector>

#include "kernels/wall_contacts.h"

namespace quern {

inline constexpr double kAtTheCone = 1 - 1e-9;  // of the cone: a contact that slides is on it

struct WearContact {
  Vec3 normal;      // unit, from the wall to the particle
  Vec3 force;       // N, on the particle
  Vec3 velocity;    // m/s, of the centre from the wall's point
  Vec3 at_point;    // m/s, of the particle's surface from the wall's point
  Vec3 braked;      // m/s, the velocity that SIEM's second rule asks about
  double slide;     // J
  double friction;  // coefficient
  double mass;      // kg
  bool touching, first_touch;
};
WearRow wear_of(const WearContact& contact, double dt, double force_ratio) noexcept;

// Factors that make volumes (m^3) of a wall's sums, and leave its impulses as they are. An entry
// that cannot be known is NaN: no hardness, no coefficient.
WearRow wear_factors(const WearSpec& wear, const Material& material);
inline constexpr double kVickers = 9.80665e6;                             // Pa a kgf/mm^2
double flow_pressure_of(const WearSpec& wear, const Material& material);  // NaN: unknown

// What a tile or a stretch of polyhedra wears off in one step.
struct WearList {
  std::vector<WearEntry> entries;
  std::vector<Index> near;  // scratch
};

// Appends an entry with its cell, on the nearest facet of the wall within `reach` of the point (m,
// world frame); without one nothing is added.
template <class Real>
void add_wear(const World<Real>& world, const WearContact& contact, Index wall, const Vec3& point,
              double reach, std::uint16_t species, WearList& list);

// All contacts of spheres of a tile, with the sums that the force kernel wrote (wear-inl.h).
template <class Real>
void list_wear(const World<Real>& world, const WallContacts& contacts, const WallLanes& lanes,
               WearList& list);

}  // namespace quern
