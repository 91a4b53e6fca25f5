#include "scheduler/grid_places.h"

#include <algorithm>

namespace quern {

template <class Real>
void place_on_grid(const World<Real>& world, const PlaceGrid& grid, Graph& graph,
                   Column<GridPlace>& places) {
  const Particles<Real>& p = world.particles;
  places.reset(p.size());
  graph.for_each(world.tiles(), [&](std::size_t tile, int) {
    const std::size_t first = tile * world.tile_size;
    const std::size_t last = std::min<std::size_t>(p.size(), first + world.tile_size);
    for (std::size_t k = first; k < last; ++k) {
      const Record<Real>& r = p.record[k];
      places[k] = grid.at(r.x, r.y, r.z, static_cast<float>(r.radius));
    }
  });
}

template void place_on_grid(const World<float>&, const PlaceGrid&, Graph&, Column<GridPlace>&);
template void place_on_grid(const World<double>&, const PlaceGrid&, Graph&, Column<GridPlace>&);

}  // namespace quern
