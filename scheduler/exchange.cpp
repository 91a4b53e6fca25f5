// The charge in the old order with the exchanged particles taken out; the next rebuild sorts it.
//
// Slots of pairs stay where they are, since springs are looked up by the slots of their owner: a
// slot that lost a partner becomes an empty lane, which has its owner as partner.
#include "scheduler/exchange.h"

#include <algorithm>
#include <cstdio>

#include "scheduler/setup.h"

namespace quern {

namespace {

// New row of each row, kNoIndex for an exchanged particle.
using RowMap = std::vector<Index>;

template <class Real>
void check_same_charge(const Particles<Real>& p, const Scene& scene,
                       std::span<const ParticleSeed> seeds) {
  if (p.size() != seeds.size()) {
    throw UserError("start_file holds " + std::to_string(p.size()) + " particles, the scene " +
                    std::to_string(seeds.size()) + ": spheres cannot become polyhedra");
  }
  for (std::size_t k = 0; k < p.size(); ++k) {
    const ParticleSeed& seed = seeds[p.id[k]];
    const double radius = static_cast<double>(p.record[k].radius);
    if (p.species[k] == seed.species && p.record[k].radius == static_cast<Real>(seed.radius))
      continue;
    char text[200];
    std::snprintf(text, sizeof text,
                  "particle %u of start_file has a diameter of %g mm, in the scene "
                  "it is one of %s with %g mm: spheres become polyhedra of the same charge only",
                  p.id[k], 2e3 * radius, species_label(scene, seed.species).c_str(),
                  2e3 * seed.radius);
    throw UserError(text);
  }
}

// The polyhedra of the scene, in the state of their spheres.
template <class Real>
std::vector<ParticleSeed> exchanged(const Particles<Real>& p, std::span<const ParticleSeed> seeds) {
  std::vector<Index> row(seeds.size(), kNoIndex);
  for (std::size_t k = 0; k < p.size(); ++k) row[p.id[k]] = static_cast<Index>(k);
  std::vector<ParticleSeed> all;
  for (std::size_t id = 0; id < seeds.size(); ++id) {
    if (seeds[id].is_sphere()) continue;
    const Index k = row[id];
    QUERN_CHECK(k != kNoIndex);
    ParticleSeed& seed = all.emplace_back(seeds[id]);
    const Record<Real>& r = p.record[k];
    seed.position = Vec3(r.x, r.y, r.z);
    seed.velocity = Vec3(r.vx, r.vy, r.vz);
    seed.spin = Vec3(p.spin_x[k], p.spin_y[k], p.spin_z[k]);
  }
  return all;
}

// Takes the exchanged particles out and gives the others their new identities.
template <class Real>
RowMap keep_spheres(Particles<Real>& p, std::span<const ParticleSeed> seeds) {
  std::vector<Index> new_id(seeds.size(), kNoIndex);
  Index spheres = 0;
  for (std::size_t id = 0; id < seeds.size(); ++id) {
    if (seeds[id].is_sphere()) new_id[id] = spheres++;
  }
  RowMap map(p.size(), kNoIndex);
  Index to = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Index id = new_id[p.id[k]];
    if (id == kNoIndex) continue;
#define QUERN_MOVE(type, name, unit, doc) p.name[to] = p.name[k];
    QUERN_PARTICLE_FIELDS(QUERN_MOVE)
#undef QUERN_MOVE
    p.id[to] = id;
    map[k] = to++;
  }
  p.resize(to);
  return map;
}

// Slots whose owner or partner is taken out become empty, and their contacts are forgotten.
template <class Real>
void keep_pairs(PairBatch<Real>& pairs, const RowMap& map) {
  for (std::size_t tile = 0; tile < pairs.tiles(); ++tile) {
    ContactHistory<Real>& contacts = pairs.contacts[tile];
    Index contact = 0, kept_contacts = 0;
    for (Index block = pairs.begin[tile]; block < pairs.begin[tile + 1]; ++block) {
      for (std::size_t row = pairs.row_begin[block]; row < pairs.row_begin[block + 1]; ++row) {
        pairs.first_contact[row] = kept_contacts;
        for (std::size_t lane = 0; lane < kPairPad; ++lane) {
          const std::size_t slot = row * kPairPad + lane;
          const Index owner = map[pairs.owner[block * kPairPad + lane]];
          const Index partner = map[pairs.partner[slot]];
          const bool empty = owner == kNoIndex || partner == kNoIndex;
          pairs.partner[slot] = !empty ? partner : owner == kNoIndex ? 0 : owner;
          if (!pairs.is_open(slot)) continue;
          if (empty) {
            pairs.open[row] &= static_cast<std::uint16_t>(~(1u << lane));
          } else {
            for (std::size_t k = 0; k < pairs.history(); ++k) {
              contacts.number(kept_contacts, k) = contacts.number(contact, k);
            }
            ++kept_contacts;
          }
          ++contact;
        }
      }
      for (std::size_t lane = 0; lane < kPairPad; ++lane) {
        Index& owner = pairs.owner[block * kPairPad + lane];
        owner = map[owner] == kNoIndex ? 0 : map[owner];
      }
    }
    contacts.count = kept_contacts;
  }
}

void keep_wall_springs(std::vector<TileWalls>& tiles, const RowMap& map) {
  for (TileWalls& t : tiles) {
    for (WallSpring& spring : t.springs) spring.particle = map[spring.particle];
    std::erase_if(t.springs, [](const WallSpring& s) { return s.particle == kNoIndex; });
    t.candidates = WallCandidates();
    t.candidates.first.push_back(0);
  }
}

}  // namespace

template <class Real>
World<Real> exchange_shapes(World<Real>&& settled, const Scene& scene,
                            std::span<const ParticleSeed> seeds, std::vector<Shape> shapes) {
  World<Real> world = std::move(settled);
  check_same_charge(world.particles, scene, seeds);
  const std::vector<ParticleSeed> polyhedra = exchanged(world.particles, seeds);
  const RowMap map = keep_spheres(world.particles, seeds);
  keep_pairs(world.pairs, map);
  keep_wall_springs(world.tile_walls, map);
  world.shapes = std::move(shapes);
  world.polyhedra = Polyhedra<Real>();
  world.polyhedra.first_id = static_cast<Index>(world.particles.size());
  world.total_mass = 0;
  for (const Traits<Real>& traits : world.particles.traits) {
    world.total_mass += 1 / static_cast<double>(traits.inverse_mass);
  }
  world.ledger = Ledger();
  append_particles(world, scene, polyhedra);
  return world;
}

template World<float> exchange_shapes(World<float>&&, const Scene&, std::span<const ParticleSeed>,
                                      std::vector<Shape>);
template World<double> exchange_shapes(World<double>&&, const Scene&, std::span<const ParticleSeed>,
                                       std::vector<Shape>);

}  // namespace quern
