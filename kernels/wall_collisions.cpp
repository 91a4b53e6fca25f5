#include "kernels/wall_collisions.h"

namespace quern {

namespace {

// 1/2 m v_n^2 and 1/2 m |v|^2 of a sphere that comes to a wall, v at the contact point.
struct Arrival {
  double approach, impact;  // J
};
template <class Real>
Arrival arrival(const Particles<Real>& p, const WallContacts& c, std::size_t k) {
  const auto geometry = [&](int row) {
    return Vec3(c.geometry[row][k], c.geometry[row + 1][k], c.geometry[row + 2][k]);
  };
  const Record<Real>& r = p.record[c.particle[k]];
  const double mass = 1 / static_cast<double>(p.traits[c.particle[k]].inverse_mass);
  const Vec3 normal = geometry(0), spin(r.wx, r.wy, r.wz);
  const double arm = static_cast<double>(r.radius) - 0.5 * c.geometry[3][k];
  const Vec3 v = Vec3(r.vx, r.vy, r.vz) - geometry(8) - arm * spin.cross(normal);
  const double along = v.dot(normal);
  return {0.5 * mass * along * along, 0.5 * mass * v.squaredNorm()};
}

}  // namespace

template <class Real>
void record_wall_contacts(const World<Real>& world, const WallContacts& contacts,
                          const WallLanes& lanes, TileWalls& tile, CollisionTally& tally) {
  const bool opening = world.collisions.recording == Recording::kOpening;
  std::vector<Episode> now;
  now.reserve(lanes.size());
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const Index particle = contacts.particle[k];
    const std::size_t kind = world.groups.kind(tag_group(world.particles.traits[particle].tag),
                                               world.walls[lanes.wall(k)].group);
    const ContactEnergies energies = {contacts.energies[0][k], contacts.energies[1][k],
                                      contacts.energies[2][k], contacts.energies[3][k]};
    tally.add(kind, energies);
    if (opening) {
      if (lanes.is_open(k)) now.push_back({energies.elastic, 0});
      continue;
    }
    Episode episode;
    if (const WallSpring* old = lanes.old(k)) {
      episode = tile.episodes[static_cast<std::size_t>(old - tile.springs.data())];
    } else {
      const Arrival came = arrival(world.particles, contacts, k);
      episode.approach = came.approach;
      tally.begin_episode(kind, came.impact);
    }
    episode.energy -= energies.work;
    if (lanes.is_open(k)) {
      now.push_back(episode);
    } else {
      tally.end_episode(kind, episode.energy, episode.approach);
    }
  }
  tile.episodes = std::move(now);
}

template void record_wall_contacts(const World<float>&, const WallContacts&, const WallLanes&,
                                   TileWalls&, CollisionTally&);
template void record_wall_contacts(const World<double>&, const WallContacts&, const WallLanes&,
                                   TileWalls&, CollisionTally&);

}  // namespace quern
