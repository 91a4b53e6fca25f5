#include "kernels/wall_collisions.h"

#include <cmath>
#include <utility>

namespace quern {

namespace {

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

// In this step; D = -W - (U - U_old).
double normal_dissipation(const ContactEnergies& e, double elastic_before) {
  return -e.work - (e.elastic - elastic_before) - e.slide - e.tangential_damping;
}

// follow_wall_contact(), inline.
template <class Real>
inline Episode follow(const World<Real>& world, std::size_t kind, const WallTold& told,
                      const Episode* before, const Arrival& arrival, CollisionTally& tally) {
  const CollisionsAsked& asked = world.collisions_asked;
  const ContactEnergies& e = told.energies;
  if (asked.kinds) tally.add(kind, e);
  if (world.collisions.recording == Recording::kOpening) return {e.elastic, 0, e.elastic};
  Episode now;
  if (before != nullptr) {
    now = *before;
  } else {
    now.approach = arrival.approach;
    if (asked.kinds) tally.begin_episode(kind, arrival.impact);
  }
  if (told.wall == asked.liner) {
    const Body& body = world.bodies[world.walls[told.wall].body];
    const double fast2 = hit_speed2(body.velocity.spin.squaredNorm(), asked.mill_radius);
    const bool hit = now.approach * told.inverse_mass > 0.5 * fast2;
    if (hit || tally.samples_liner()) {
      tally.touch_liner(told.point.x(), told.point.y(), normal_dissipation(e, now.elastic),
                        hit ? LinerTouch::kHit : LinerTouch::kSlow);
    }
  }
  now.energy -= e.work;
  now.elastic = e.elastic;
  if (!told.touches && asked.kinds) tally.end_episode(kind, now.energy, now.approach);
  return now;
}

}  // namespace

template <class Real>
Episode follow_wall_contact(const World<Real>& world, std::size_t kind, const WallTold& told,
                            const Episode* before, const Arrival& arrival, CollisionTally& tally) {
  return follow(world, kind, told, before, arrival, tally);
}

template <class Real>
void record_wall_contacts(const World<Real>& world, const WallContacts& contacts, WallLanes& lanes,
                          TileWalls& tile, CollisionTally& tally) {
  const Particles<Real>& p = world.particles;
  std::vector<Episode>& now = lanes.episodes();
  now.clear();
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const Index particle = contacts.particle[k];
    const std::size_t kind =
        world.groups.kind(tag_group(p.traits[particle].tag), world.walls[lanes.wall(k)].group);
    WallTold told;
    told.energies = {contacts.energies[0][k], contacts.energies[1][k], contacts.energies[2][k],
                     contacts.energies[3][k]};
    told.point = lanes.point(k);
    told.wall = lanes.wall(k);
    told.touches = lanes.is_open(k);
    told.inverse_mass = static_cast<double>(p.traits[particle].inverse_mass);
    const WallSpring* old = lanes.old(k);
    // The opening step has no episodes yet.
    const bool known = old != nullptr && !tile.episodes.empty();
    const Episode* before =
        known ? &tile.episodes[static_cast<std::size_t>(old - tile.springs.data())] : nullptr;
    const Arrival came = old == nullptr ? arrival(p, contacts, k) : Arrival{0, 0};
    const Episode episode = follow(world, kind, told, before, came, tally);
    if (told.touches) now.push_back(episode);
  }
  std::swap(tile.episodes, now);
}

template Episode follow_wall_contact(const World<float>&, std::size_t, const WallTold&,
                                     const Episode*, const Arrival&, CollisionTally&);
template Episode follow_wall_contact(const World<double>&, std::size_t, const WallTold&,
                                     const Episode*, const Arrival&, CollisionTally&);
template void record_wall_contacts(const World<float>&, const WallContacts&, WallLanes&, TileWalls&,
                                   CollisionTally&);
template void record_wall_contacts(const World<double>&, const WallContacts&, WallLanes&,
                                   TileWalls&, CollisionTally&);

}  // namespace quern
