// What contacts of spheres with walls tell of their collisions, see soa/collisions.h.
#pragma once

#include "kernels/collision_tally.h"
#include "kernels/wall_contacts.h"

namespace quern {

// Between the law and return_wall_contacts(), while the tile's springs are those of a step ago: to
// the tally, and the episodes of the contacts that go on to the tile, in the order in which their
// springs will be.
template <class Real>
void record_wall_contacts(const World<Real>& world, const WallContacts& contacts,
                          const WallLanes& lanes, TileWalls& tile, CollisionTally& tally);

}  // namespace quern
