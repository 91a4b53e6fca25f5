// Rotation of rigid bodies: leapfrog of the angular momentum, free rotation by splitting.
//
// State of a body: unit quaternion q (body to world, stored w x y z) and angular momentum L in the
// world frame at half steps. One step is L += torque * kick and then the free motion over dt, for
// which the kinetic energy L.I^-1 L / 2 is split along the principal axes: turns about x, y, z, y,
// x by theta = L_k dt / I_k (x and y in two halves), each exact. Dullweber, Leimkuhler, McLachlan,
// J. Chem. Phys. 107 (1997) 5840; second order, time-reversible, no drift of energy, and L, being
// kept in the world frame, changes by torques alone. A moment of inertia of zero (a rod about its
// own axis) has inverse 0 and does not turn. Spheres need no orientation and do not come here.
#pragma once

#include "soa/base.h"

namespace quern {

// Inverse principal moments; a moment below 1e-12 of the largest counts as zero and gives 0.
Vec3 inverse_inertia_of(const Vec3& inertia) noexcept;

// Orientation after the free rotation over dt. The plain scalar code, for set-up and as the oracle
// of rotate_bodies().
Quat rotate_freely(const Quat& q, const Vec3& momentum, const Vec3& inverse_inertia,
                   double dt) noexcept;

// Angular velocity in the world frame, rad/s.
Vec3 spin_of(const Quat& q, const Vec3& momentum, const Vec3& inverse_inertia) noexcept;

// Columns of bodies 0 ... count - 1, padded to a vector as Column is; padding is read, not written.
struct RotationView {
  double* orientation[4];            // w x y z
  double* momentum[3];               // kg m^2/s, world frame, half step
  double* spin[3];                   // rad/s, world frame: of the new L in the new orientation
  const double* torque[3];           // N m, world frame
  const double* inverse_inertia[3];  // 1/(kg m^2), principal
  std::size_t count;
};

// One step: L += torque * kick (s; dt, or dt/2 on the first step), then the rotation over dt (s).
void rotate_bodies(const RotationView& bodies, double kick, double dt) noexcept;

}  // namespace quern
