// What contacts of polyhedra among themselves and with walls tell of their collisions, see
// soa/collisions.h.
#include "kernels/polyhedron_contacts.h"

namespace quern {

template <class Real>
void PolyhedronContacts<Real>::record(World<Real>& world, std::size_t k,
                                      const ContactTally& energies,
                                      PolyhedronCollisions& collisions) const {
  using B = BodyContacts;
  const Lane& lane = lanes_[k];
  Polyhedra<Real>& p = world.polyhedra;
  const auto group = [&](Index body) { return world.groups.of_species(p.species[body]); };
  const std::size_t kind =
      lane.pair ? world.groups.kind(group(lane.pair->i), group(lane.pair->j))
                : world.groups.kind(group(lane.wall.particle), world.walls[lane.wall.wall].group);
  CollisionTally& tally = collisions.tally;
  tally.add(kind, {energies.work, energies.elastic, energies.slide, energies.tangential_damping});
  Episode episode;
  if (world.collisions.recording == Recording::kOpening) {
    episode.energy = energies.elastic;
  } else {
    const Episode* before = nullptr;
    if (lane.pair && lane.pair->touching != 0) {
      before = &p.pair_episodes[static_cast<std::size_t>(lane.pair - p.pairs.data())];
    } else if (lane.old_wall) {
      before = &p.wall_episodes[static_cast<std::size_t>(lane.old_wall - p.walls.data())];
    }
    if (before != nullptr) {
      episode = *before;
    } else {
      const Vec3 velocity = get3(B::kAtPoint, k);
      const double half_mass = 0.5 / get(B::kInverseMass, k);
      const double along = velocity.dot(get3(B::kNormal, k));
      episode.approach = half_mass * along * along;
      tally.begin_episode(kind, half_mass * velocity.squaredNorm());
    }
    episode.energy -= energies.work;
    if (!lane.touching) tally.end_episode(kind, episode.energy, episode.approach);
  }
  if (lane.pair) {
    p.pair_episodes[static_cast<std::size_t>(lane.pair - p.pairs.data())] = episode;
  } else if (lane.touching) {
    collisions.wall_episodes.push_back(episode);
  }
}

template void PolyhedronContacts<float>::record(World<float>&, std::size_t, const ContactTally&,
                                                PolyhedronCollisions&) const;
template void PolyhedronContacts<double>::record(World<double>&, std::size_t, const ContactTally&,
                                                 PolyhedronCollisions&) const;

}  // namespace quern
