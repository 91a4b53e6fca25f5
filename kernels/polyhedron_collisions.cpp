// What contacts of polyhedra among themselves and with walls tell of their collisions, see
// soa/collisions.h.
#include "kernels/polyhedron_contacts.h"

namespace quern {

template <class Real>
Arrival PolyhedronContacts<Real>::arrival(std::size_t k) const {
  using B = BodyContacts;
  const Vec3 velocity = get3(B::kAtPoint, k);
  const double half_mass = 0.5 / get(B::kInverseMass, k);
  const double along = velocity.dot(get3(B::kNormal, k));
  return {half_mass * along * along, half_mass * velocity.squaredNorm()};
}

template <class Real>
void PolyhedronContacts<Real>::record_pair(World<Real>& world, std::size_t k,
                                           const ContactEnergies& energies,
                                           CollisionTally& tally) const {
  const Lane& lane = lanes_[k];
  Polyhedra<Real>& p = world.polyhedra;
  const std::size_t kind = world.groups.kind(world.groups.of_species(p.species[lane.pair->i]),
                                             world.groups.of_species(p.species[lane.pair->j]));
  tally.add(kind, energies);
  Episode& episode = p.pair_episodes[static_cast<std::size_t>(lane.pair - p.pairs.data())];
  if (world.collisions.recording == Recording::kOpening) {
    episode = {energies.elastic, 0, energies.elastic};
    return;
  }
  if (lane.pair->touching == 0) {
    const Arrival came = arrival(k);
    episode = {0, came.approach, 0};
    tally.begin_episode(kind, came.impact);
  }
  episode.energy -= energies.work;
  episode.elastic = energies.elastic;
  if (!lane.touching) tally.end_episode(kind, episode.energy, episode.approach);
}

template <class Real>
void PolyhedronContacts<Real>::record_wall(World<Real>& world, std::size_t k,
                                           const ContactEnergies& energies,
                                           PolyhedronCollisions& collisions) const {
  const Lane& lane = lanes_[k];
  const Polyhedra<Real>& p = world.polyhedra;
  WallTold told;
  told.energies = energies;
  told.point = lane.wall.point;
  told.wall = lane.wall.wall;
  told.touches = lane.touching;
  told.inverse_mass = p.inverse_mass[lane.wall.particle];
  const bool known = lane.old_wall != nullptr && !p.wall_episodes.empty();
  const Episode* before =
      known ? &p.wall_episodes[static_cast<std::size_t>(lane.old_wall - p.walls.data())] : nullptr;
  const Arrival came = lane.old_wall == nullptr ? arrival(k) : Arrival{0, 0};
  const std::size_t kind = world.groups.kind(world.groups.of_species(p.species[lane.wall.particle]),
                                             world.walls[lane.wall.wall].group);
  const Episode episode = follow_wall_contact(world, kind, told, before, came, collisions.tally);
  if (lane.touching) collisions.wall_episodes.push_back(episode);
}

template <class Real>
void PolyhedronContacts<Real>::record(World<Real>& world, std::size_t k,
                                      const ContactTally& energies,
                                      PolyhedronCollisions& collisions) const {
  const ContactEnergies told = {energies.work, energies.elastic, energies.slide,
                                energies.tangential_damping};
  if (lanes_[k].pair == nullptr) {
    record_wall(world, k, told, collisions);
  } else if (world.collisions_asked.kinds) {
    record_pair(world, k, told, collisions.tally);
  }
}

template void PolyhedronContacts<float>::record(World<float>&, std::size_t, const ContactTally&,
                                                PolyhedronCollisions&) const;
template void PolyhedronContacts<double>::record(World<double>&, std::size_t, const ContactTally&,
                                                 PolyhedronCollisions&) const;

}  // namespace quern
