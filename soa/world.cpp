// Enumeration of a World's state: columns as they are, tile walls packed into columns for the time
// of the visit. Visiting to write and visiting to read are the same code.
#include "soa/world.h"

#include <algorithm>
#include <cstring>

namespace quern {

template <class Real>
typename World<Real>::PackedWalls World<Real>::pack_walls() const {
  PackedWalls p;
  std::size_t springs = 0, entries = 0, facets = 0;
  for (const TileWalls& t : tile_walls) {
    springs += t.springs.size();
    entries += t.candidates.particle.size();
    facets += t.candidates.facet.size();
  }
  p.spring_bytes.reset(springs * sizeof(WallSpring));
  p.spring_tile.reset(springs);
  for (Column<Index>* c : {&p.entry_tile, &p.entry_particle, &p.entry_body, &p.entry_facets}) {
    c->reset(entries);
  }
  p.facet.reset(facets);
  std::size_t s = 0, e = 0, f = 0;
  for (std::size_t tile = 0; tile < tile_walls.size(); ++tile) {
    const TileWalls& t = tile_walls[tile];
    p.episodes.insert(p.episodes.end(), t.episodes.begin(), t.episodes.end());
    for (const WallSpring& spring : t.springs) {
      std::memcpy(p.spring_bytes.data() + s * sizeof(WallSpring), &spring, sizeof(WallSpring));
      p.spring_tile[s++] = static_cast<Index>(tile);
    }
    const WallCandidates& c = t.candidates;
    for (std::size_t k = 0; k < c.particle.size(); ++k) {
      p.entry_tile[e] = static_cast<Index>(tile);
      p.entry_particle[e] = c.particle[k];
      p.entry_body[e] = c.body[k];
      p.entry_facets[e++] = c.first[k + 1] - c.first[k];
    }
    for (Index facet : c.facet) p.facet[f++] = facet;
  }
  return p;
}

template <class Real>
void World<Real>::unpack_walls(const PackedWalls& p) {
  // Another run may start from this state with other tiles; its first rebuild sorts the springs in.
  std::size_t saved = tiles();
  for (const Index tile : p.spring_tile) saved = std::max<std::size_t>(saved, tile + 1u);
  for (const Index tile : p.entry_tile) saved = std::max<std::size_t>(saved, tile + 1u);
  tile_walls.assign(saved, TileWalls());
  for (TileWalls& t : tile_walls) t.candidates.first.push_back(0);
  for (std::size_t s = 0; s < p.spring_tile.size(); ++s) {
    WallSpring spring;
    std::memcpy(static_cast<void*>(&spring), p.spring_bytes.data() + s * sizeof(WallSpring),
                sizeof(WallSpring));
    TileWalls& tile = tile_walls.at(p.spring_tile[s]);
    tile.springs.push_back(spring);
    if (!p.episodes.empty()) tile.episodes.push_back(p.episodes[s]);
  }
  std::size_t f = 0;
  for (std::size_t e = 0; e < p.entry_tile.size(); ++e) {
    WallCandidates& c = tile_walls.at(p.entry_tile[e]).candidates;
    c.particle.push_back(p.entry_particle[e]);
    c.body.push_back(p.entry_body[e]);
    for (Index k = 0; k < p.entry_facets[e]; ++k) c.facet.push_back(p.facet[f++]);
    c.first.push_back(static_cast<Index>(c.facet.size()));
  }
}

template <class Real>
void World<Real>::visit(StateVisitor& v) {
  particles.visit(v);
  collisions.visit(v);
  pairs.episodes = collisions.recording == Recording::kOn && collisions_asked.kinds;
  pairs.visit(v);
  if (!shapes.empty()) polyhedra.visit(v, collisions.recording == Recording::kOn);
  PackedWalls packed = pack_walls();
  v.column("walls/springs", "m, N, N m", packed.spring_bytes, sizeof(WallSpring));
  if (collisions.recording == Recording::kOn) visit_rows(v, "walls/episodes", "J", packed.episodes);
  v.column("walls/spring_tile", "1", packed.spring_tile, 1);
  v.column("walls/entry_tile", "1", packed.entry_tile, 1);
  v.column("walls/entry_particle", "1", packed.entry_particle, 1);
  v.column("walls/entry_body", "1", packed.entry_body, 1);
  v.column("walls/entry_facets", "1", packed.entry_facets, 1);
  v.column("walls/facet", "1", packed.facet, 1);
  unpack_walls(packed);
  const auto block = [&](const char* name, const char* unit, auto& data, ElementType type) {
    v.values(name, unit, type, &data, sizeof(data) / 8);
  };
  block("clock", "1, s", clock, ElementType::kU64);
  block("domain/low", "m", low, ElementType::kF64);
  block("domain/high", "m", high, ElementType::kF64);
  block("ledger", "J", ledger, ElementType::kF64);
  block("window", "sums over steps", window, ElementType::kF64);
  block("totals", "sums over the scene", totals, ElementType::kF64);
  v.later_values("capped_contacts", "1", ElementType::kU64, &capped_contacts, 1);
  visit_rows(v, "walls/totals", "N, N m, J", wall_totals);
  v.later_column("wear/cells", "J, N m, N s", wear.cells, kWearSums);
  v.later_column("wear/walls", "J, N m, N s", wear.walls, kWearSums);
  v.later_column("wear/species", "J, N m, N s", wear.species, kWearSums);
  v.later_column("wear/time", "s", wear.time, 1);
  v.later_values("total_mass", "kg", ElementType::kF64, &total_mass, 1);
}

template struct World<float>;
template struct World<double>;

}  // namespace quern
