// Contacts of bodies that are no sphere: what the kernels of law and sums read and write.
//
// A polyhedron's contacts come as lanes whose geometry the narrow phase has found. Spheres near one
// polyhedron are a group: their records are gathered, polyhedron_sphere finds normals and overlaps.
// Few of a group touch: those of all groups of a tile are packed (near_lanes.h), push_spheres applies
// the law, adds to the rows of the spheres and tells what each does to its polyhedron. Contacts among
// polyhedra and with walls are few: push_bodies is the law alone, energies a contact.
#pragma once

#include "kernels/contact.h"
#include "soa/shapes.h"

namespace quern {

// A polyhedron as its contacts see it; vectors in the world frame.
struct BodyState {
  Vec3 place, velocity, spin;
  double inverse_mass = 0;  // 1/kg
  double mobility = 0;      // 1/(kg m^2), the largest inverse principal moment of inertia
  double contacts = 0;      // of the last step
  std::uint32_t material = 0;
};

// Columns of one group in kShapePad lanes each; scratch of a worker.
struct GroupLanes {
  double* center[3];  // m, of the spheres from the polyhedron's place, nearest image
  double* radius;
  double* normal[3];
  double* overlap;
  double* point[3];
};

// Contacts of spheres with polyhedra, one lane each: rows of `count` numbers, padded to kShapePad with
// lanes that do nothing.
template <class Real>
struct NearContacts {
  enum Row {
    kNormal = 0,                // 3, from the polyhedron to the sphere
    kOverlap = kNormal + 3,     // m; <= 0 closes a contact
    kPoint,                     // 3, m, contact point from the polyhedron's place
    kVelocity = kPoint + 3,     // 3, of the polyhedron, as are the following
    kSpin = kVelocity + 3,      // 3
    kInverseMass = kSpin + 3,
    kMobility,
    kContacts,
    kForce,                     // 3, N on the polyhedron, out
    kTorque = kForce + 3,       // 3, N m, out
    kRows = kTorque + 3
  };
  double* numbers;      // kRows rows, `stride` apart
  Real* history;        // as a slot of PolyhedronSphereBatch, `stride` apart; in and out
  std::size_t stride;
  const Index* sphere;
  const std::uint32_t* material;  // of the polyhedron
  std::size_t count;    // padded
  double overlap_cap;   // m; 0: none
  double* row(int k) const { return numbers + static_cast<std::size_t>(k) * stride; }
};

// Rows of `count` numbers, one lane a contact, padded to kShapePad.
struct BodyContacts {
  enum Row {
    kNormal = 0,          // 3, from j to i
    kNormalOld = 3,       // 3
    kOverlap = 6,         // m; <= 0 closes a contact
    kOverlapOld,
    kAtPoint,             // 3, m/s, velocity of i from j at the contact point
    kAtOld = kAtPoint + 3,      // 3, at the contact point of a step ago
    kSpinI = kAtOld + 3,        // 3, rad/s
    kSpinJ = kSpinI + 3,        // 3
    kInverseMass = kSpinJ + 3,  // 1/m_i + 1/m_j
    kTangentialInverse,         // sum of 1/m + r^2/I
    kCountRate,                 // sum of Z/m
    kTangentialCountRate,       // sum of Z (1/m + r^2/I)
    kElasticForce,              // N, of the normal spring
    kStored,                    // J
    kSpring,                    // 3, m, in and out
    kForce = kSpring + 3,       // 3, N on i, in and out
    kWork = kForce + 3,         // J, out, as are the following
    kElastic,
    kSlide,
    kTangentialDamping,
    kNumericalLoss,
    kReduction,                 // of the spring by the implicit damping
    kNormalForce,               // N
    kRows
  };
  double* numbers;        // kRows rows, `stride` apart
  std::size_t stride;
  const Index* law_row;   // of the table of materials
  std::size_t count;      // padded
  double* row(int k) const { return numbers + static_cast<std::size_t>(k) * stride; }
};

}  // namespace quern
