// Contacts of bodies that are no sphere: what the kernels of law and sums read and write.
//
// A polyhedron's contacts come as lanes whose geometry the narrow phase has found. Spheres near one
// polyhedron are a group: their records are gathered, polyhedron_sphere finds normals and overlaps.
// Few of a group touch: those of all groups of a tile are packed (near_lanes.h), push_spheres
// applies the law, adds to the rows of the spheres and to the sums of the groups. Contacts among
// polyhedra and with walls are few: push_bodies is the law alone, energies a contact.
#pragma once

#include "kernels/contact.h"
#include "kernels/pairs/polyhedron_sphere.h"
#include "soa/shapes.h"

namespace quern {

// A polyhedron as its contacts see it; vectors in the world frame.
struct BodyState {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();
  double inverse_mass = 0;  // 1/kg
  double mobility = 0;      // 1/(kg m^2), the largest inverse principal moment of inertia
  double contacts = 0;      // of the last step
  double radius = 1;        // m, of the sphere of equal volume
  std::uint32_t material = 0, group = 0;
  // Velocity, spin, inverse mass, mobility: eight numbers.
  const double* motion() const { return velocity.data(); }
};
static_assert(sizeof(BodyState) == 112, "motion() is one row");

// Columns of one group in kShapePad lanes each; scratch of a worker.
struct GroupLanes {
  double* center[3];  // m, of the spheres from the polyhedron's place, nearest image
  double* radius;
};

// What a contact of a sphere with a polyhedron tells while collisions are recorded.
struct alignas(kAlignment) NearTold {
  double work, elastic, slide, tangential_damping;  // J
  double overlap_old;                               // m; > 0: it touched a step ago
  double approach, impact;                          // J, 1/2 m_e v_n^2 and 1/2 m_e v^2 of now
  double unused;
};

// Contacts of spheres with polyhedra, one lane each, padded to kShapePad with lanes that do
// nothing. What a lane reads and writes besides its sphere lies scattered, in rows of 64 bytes (128
// in f64).
template <class Real>
struct NearContacts {
  const NearTouch* touch;
  const Index* sphere;
  const double* const* motion;    // BodyState::motion() of the polyhedron
  const std::uint32_t* material;  // of the polyhedron
  const double* radius;           // m, likewise, of the sphere of equal volume
  Real* const* history;           // a slot of PolyhedronSphereBatch; in and out
  double* const* sums;  // of its group: force and torque on the polyhedron, contacts; added to
  std::size_t count;    // padded
  double overlap_cap;   // m; 0: none
  NearTold* told;       // out; null: not asked for
  std::size_t* odd;     // out: a lane whose energies are not finite, if there is one
};

// Rows of `count` numbers, one lane a contact, padded to kShapePad.
struct BodyContacts {
  enum Row {
    kNormal = 0,     // 3, from j to i
    kNormalOld = 3,  // 3
    kOverlap = 6,    // m; <= 0 closes a contact
    kOverlapOld,
    kAtPoint,                   // 3, m/s, velocity of i from j at the contact point
    kAtOld = kAtPoint + 3,      // 3, at the contact point of a step ago
    kSpinI = kAtOld + 3,        // 3, rad/s
    kSpinJ = kSpinI + 3,        // 3
    kInverseMass = kSpinJ + 3,  // 1/m_i + 1/m_j
    kTangentialInverse,         // sum of 1/m + r^2/I
    kCountRate,                 // sum of Z/m
    kTangentialCountRate,       // sum of Z (1/m + r^2/I)
    kElasticForce,              // N, of the normal spring
    kStored,                    // J
    kReducedRadius,             // m, R* of equivalent radii
    kSpring,                    // 3, m, in and out
    kForce = kSpring + 3,       // 3, N on i, in and out
    kWork = kForce + 3,         // J, out, as are the following
    kElastic,
    kSlide,
    kTangentialDamping,
    kNumericalLoss,
    kModelWork,    // of the tangential spring
    kReduction,    // of the spring by the implicit damping
    kNormalForce,  // N
    kRows
  };
  double* numbers;  // kRows rows, `stride` apart
  std::size_t stride;
  const Index* law_row;  // of the table of materials
  std::size_t count;     // padded
  double* row(int k) const { return numbers + static_cast<std::size_t>(k) * stride; }
};

}  // namespace quern
