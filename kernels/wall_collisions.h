// What contacts of spheres with walls tell of their collisions, see soa/collisions.h.
#pragma once

#include "kernels/collision_tally.h"
#include "kernels/wall_contacts.h"

namespace quern {

// What a contact with a wall did in this step.
struct WallTold {
  ContactEnergies energies;
  Vec3 point = Vec3::Zero();  // m, of the contact
  Index wall = 0;
  bool touches = false;
  double inverse_mass = 0;  // 1/kg, of the particle
};
// One that came, if it is new: 1/2 m v_n^2 and 1/2 m v^2 at the contact point.
struct Arrival {
  double approach, impact;  // J
};

// Takes a step of a contact to its episode, which is one of now on return, and tells it. `before`:
// of a step ago, null of a new one, which has an `arrival`. Also of polyhedra.
template <class Real>
Episode follow_wall_contact(const World<Real>& world, std::size_t kind, const WallTold& told,
                            const Episode* before, const Arrival& arrival, CollisionTally& tally);

// Between the law and return_wall_contacts(), while the tile's springs are those of a step ago: to
// the tally, and the episodes of the contacts that go on to the tile, in the order in which their
// springs will be.
template <class Real>
void record_wall_contacts(const World<Real>& world, const WallContacts& contacts, WallLanes& lanes,
                          TileWalls& tile, CollisionTally& tally);

}  // namespace quern
