// Places of spheres on the grid that `single` searches, see soa/grid_place.h.
#pragma once

#include "scheduler/graph.h"
#include "soa/grid_place.h"
#include "soa/world.h"

namespace quern {

// Those of all records, in their order.
template <class Real>
void place_on_grid(const World<Real>& world, const PlaceGrid& grid, Graph& graph,
                   Column<GridPlace>& places);

}  // namespace quern
