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

}  // namespace

// Histories hold what is dissipated and what is stored.
template <class Real>
std::vector<OpenEpisodes> open_episodes(const World<Real>& world) {
  std::vector<OpenEpisodes> all(world.groups.kinds());
  if (world.collisions.recording != Recording::kOn) return all;
  add_sphere_pairs(world, all);
  add_sphere_walls(world, all);
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].dissipated -= world.collisions.kinds[k].elastic;
  }
  return all;
}

template std::vector<OpenEpisodes> open_episodes(const World<float>&);
template std::vector<OpenEpisodes> open_episodes(const World<double>&);

}  // namespace quern
