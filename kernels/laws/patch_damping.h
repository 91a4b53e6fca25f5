// Rocking and drilling damping of a contact patch between polyhedra, or a polyhedron and a wall.
//
//   M_rock  = -c_n A / (4 pi) (w - n (n.w)),   |M_rock|  <= 1/2 F_n sqrt(A / pi)
//   M_drill = -c_t A / (2 pi) (n.w),           |M_drill| <= 2/3 mu F_n sqrt(A / pi)
//
// A patch has one spring and one dashpot, in its centroid. While a whole face rests on a wall the
// centroid hardly moves when the body rocks, so the dashpot sees nothing and the body rocks for
// ever. These are the moments of the same dashpots spread over a disc of the patch's area A,
// bounded by what the normal force and friction on that disc can give; they vanish with the patch,
// and where an unclamped contact pulls.
// w is the spin of i relative to j, n the normal, c_n and c_t the dashpots of the contact.
//
// They are taken from the spin half a step ago. As the dashpots of the force they are therefore
// reduced: c' = c / (1 + dt/2 c max(1/I_i + 1/I_j, Z_i/I_i + Z_j/I_j)), with I the least principal
// moment and Z the number of contacts in the last step (kernels/README.md); a wall's 1/I is 0. All
// contacts of a body together then change its spin by at most twice its size, however stiff they
// are: it never grows. Scalar f64: such contacts are few.
#pragma once

#include <algorithm>
#include <cmath>

#include "soa/base.h"

namespace quern {

struct PatchDashpot {
  double normal_damping = 0;      // c_n, N s/m
  double tangential_damping = 0;  // c_t, N s/m
  double sliding_friction = 0;    // mu
  double mobility = 0;            // max(1/I_i + 1/I_j, Z_i/I_i + Z_j/I_j), 1/(kg m^2)
  double dt = 0;                  // s
};

inline double patch_mobility(double inverse_inertia_i, double contacts_i, double inverse_inertia_j,
                             double contacts_j) noexcept {
  return std::max(inverse_inertia_i + inverse_inertia_j,
                  contacts_i * inverse_inertia_i + contacts_j * inverse_inertia_j);
}

// Moment on i, N m; -moment acts on j. `spin` = w_i - w_j (rad/s), area (m^2), normal_force (N).
inline Vec3 patch_moment(const PatchDashpot& dashpot, const Vec3& normal, const Vec3& spin,
                         double area, double normal_force) noexcept {
  const auto damped = [&](double c, double most, const Vec3& w) {
    const double bounded = c / (1 + 0.5 * dashpot.dt * c * dashpot.mobility);
    const double size = bounded * w.norm();
    return Vec3((size > most ? -bounded * most / size : -bounded) * w);
  };
  const double radius = std::sqrt(area / kPi), pressed = std::max(0.0, normal_force);
  const Vec3 drilling = normal.dot(spin) * normal;
  return damped(dashpot.normal_damping * area / (4 * kPi), 0.5 * pressed * radius,
                spin - drilling) +
         damped(dashpot.tangential_damping * area / (2 * kPi),
                2.0 / 3.0 * dashpot.sliding_friction * pressed * radius, drilling);
}

}  // namespace quern
