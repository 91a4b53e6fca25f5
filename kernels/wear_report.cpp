#include "kernels/wear_report.h"

#include <algorithm>

namespace quern {

namespace {

WearRow times(const WearRow& row, const WearRow& factor) {
  WearRow out;
  for (std::size_t k = 0; k < kWearSums; ++k) out[k] = row[k] * factor[k];
  return out;
}

const Material& material_of(const Scene& scene, const std::string& name) {
  for (const Material& m : scene.materials) {
    if (m.name == name) return m;
  }
  throw InvariantError("a species of no material: " + name);
}

}  // namespace

std::vector<double> WallWear::over_area(WearSum sum, double factor) const {
  std::vector<double> out;
  for (std::size_t k = 0; k < cells.size(); ++k) out.push_back(factor * made[k][sum] / area[k]);
  return out;
}

std::vector<double> WallWear::depth(WearSum sum) const { return over_area(sum, 1); }

std::vector<double> WallWear::depth_rate(WearSum sum) const {
  return over_area(sum, kMmPer1000Hours * per_time());
}

std::vector<double> WallWear::pressure() const { return over_area(kNormalImpulse, per_time()); }

std::vector<double> WallWear::shear() const { return over_area(kShearImpulse, per_time()); }

WearRow WallWear::total() const {
  WearRow sum{};
  for (const WearRow& row : made) {
    for (std::size_t k = 0; k < kWearSums; ++k) sum[k] += row[k];
  }
  return sum;
}

template <class Real>
WallWear wall_wear(const World<Real>& world, const Scene& scene, Index wall) {
  const Index on = world.walls[wall].body;
  const Facets& facets = world.bodies[on].facets;
  const WearGrid& grid = world.wear.grids[on];
  const WearRow factors = wear_factors(*scene.wear, scene.materials[world.walls[wall].material]);
  WallWear out;
  out.time = world.wear.time[0];
  std::vector<WearCell> all;
  all.reserve(grid.end_cell() - grid.first_cell());
  grid.append_cells(facets, on, all);
  const auto of_wall = [&](const WearCell& cell) { return facets.wall[cell.facet] == wall; };
  const auto count = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), of_wall));
  out.cells.reserve(count);
  out.energy.reserve(count);
  out.area.reserve(count);
  out.made.reserve(count);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!of_wall(all[k])) continue;
    const WearRow sums = world.wear.total_of(world.wear.cells, grid.first_cell() + k);
    out.cells.push_back(all[k]);
    out.energy.push_back(sums[kSiemEnergy]);
    out.area.push_back(all[k].area());
    out.made.push_back(times(sums, factors));
  }
  return out;
}

template <class Real>
std::vector<WearRow> species_wear(const World<Real>& world, const Scene& scene) {
  std::vector<WearRow> out;
  WearSpec wear = *scene.wear;
  wear.flow_pressure.reset();  // it is that of the walls
  for (std::size_t k = 0; k < scene.particles.size(); ++k) {
    out.push_back(times(world.wear.total_of(world.wear.species, k),
                        wear_factors(wear, material_of(scene, scene.particles[k].material))));
  }
  return out;
}

template WallWear wall_wear(const World<float>&, const Scene&, Index);
template WallWear wall_wear(const World<double>&, const Scene&, Index);
template std::vector<WearRow> species_wear(const World<float>&, const Scene&);
template std::vector<WearRow> species_wear(const World<double>&, const Scene&);

}  // namespace quern
