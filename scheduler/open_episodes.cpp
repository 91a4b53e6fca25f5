#include "scheduler/open_episodes.h"

namespace quern {

namespace {

template <class Real>
void add_sphere_pairs(const World<Real>& world, std::vector<OpenEpisodes>& all) {
  const PairBatch<Real>& pairs = world.pairs;
  const std::size_t at = pairs.law_history();
  const auto group = [&](Index k) { return tag_group(world.particles.traits[k].tag); };
  for (std::size_t tile = 0; tile < pairs.tiles(); ++tile) {
    pairs.for_each(tile, PairBatch<Real>::Part::kOwn, [&](std::size_t slot, Index i, Index j) {
      if (!pairs.is_open(slot)) return;
      OpenEpisodes& kind = all[world.groups.kind(group(i), group(j))];
      kind.count += 1;
      kind.dissipated += static_cast<double>(pairs.number(tile, slot, at)) +
                         static_cast<double>(pairs.number(tile, slot, at + 1));
    });
  }
}

template <class Real>
void add_sphere_walls(const World<Real>& world, std::vector<OpenEpisodes>& all) {
  for (const TileWalls& tile : world.tile_walls) {
    for (std::size_t k = 0; k < tile.episodes.size(); ++k) {
      const WallSpring& spring = tile.springs[k];
      const std::size_t group = tag_group(world.particles.traits[spring.particle].tag);
      OpenEpisodes& kind = all[world.groups.kind(group, world.walls[spring.wall].group)];
      kind.count += 1;
      kind.dissipated += tile.episodes[k].energy;
    }
  }
}

template <class Real>
void add_polyhedra(const World<Real>& world, std::vector<OpenEpisodes>& all) {
  const Polyhedra<Real>& p = world.polyhedra;
  const auto group = [&](Index body) { return world.groups.of_species(p.species[body]); };
  const auto add = [&](std::size_t a, std::size_t b, double energy) {
    OpenEpisodes& kind = all[world.groups.kind(a, b)];
    kind.count += 1;
    kind.dissipated += energy;
  };
  for (std::size_t k = 0; k < p.pairs.size(); ++k) {
    if (p.pairs[k].touching == 0) continue;
    add(group(p.pairs[k].j), group(p.pairs[k].i), p.pair_episodes[k].energy);
  }
  for (std::size_t k = 0; k < p.walls.size(); ++k) {
    add(group(p.walls[k].particle), world.walls[p.walls[k].wall].group, p.wall_episodes[k].energy);
  }
  const PolyhedronSphereBatch<Real>& near = p.spheres;
  for (std::size_t g = 0; g < near.polyhedron.size(); ++g) {
    for (Index slot = near.begin[g]; slot < near.begin[g] + near.count[g]; ++slot) {
      if (!near.is_open(slot)) continue;
      add(tag_group(world.particles.traits[near.sphere[slot]].tag), group(near.polyhedron[g]),
          static_cast<double>(near.number(slot, near.kEpisode)) +
              static_cast<double>(near.number(slot, near.kEpisode + 1)));
    }
  }
}

}  // namespace

// Histories hold what is dissipated and what is stored.
template <class Real>
std::vector<OpenEpisodes> open_episodes(const World<Real>& world) {
  std::vector<OpenEpisodes> all(world.groups.kinds());
  if (world.collisions.recording != Recording::kOn) return all;
  add_sphere_pairs(world, all);
  add_sphere_walls(world, all);
  if (!world.polyhedra.empty()) add_polyhedra(world, all);
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].dissipated -= world.collisions.kinds[k].elastic;
  }
  return all;
}

template std::vector<OpenEpisodes> open_episodes(const World<float>&);
template std::vector<OpenEpisodes> open_episodes(const World<double>&);

}  // namespace quern
