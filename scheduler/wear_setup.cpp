#include "scheduler/wear_setup.h"

#include <cmath>

namespace quern {

namespace {

constexpr double kCellsByDefault = 2e5;

// The scene's size; else a fifth of a lifter's top; else what makes so many cells of all walls.
double cell_size(const Scene& scene, const std::vector<Body>& bodies) {
  if (scene.wear->cell_size > 0) return scene.wear->cell_size;
  if (scene.mill && scene.mill->lifters) return scene.mill->lifters->top_width / 5;
  double area = 0;
  for (const Body& body : bodies) {
    for (const FacetRecord& f : body.facets.record) {
      area += 0.5 * (f.corner[1] - f.corner[0]).cross(f.corner[2] - f.corner[0]).norm();
    }
  }
  return std::sqrt(2 * area / kCellsByDefault);
}

}  // namespace

template <class Real>
void set_wear(World<Real>& world, const Scene& scene) {
  world.wear = Wear();
  if (!scene.wear || world.bodies.empty()) return;
  world.wear.velocity = scene.wear->velocity;
  world.wear.finnie_force_ratio = scene.wear->finnie_force_ratio;
  world.wear.cell_size = cell_size(scene, world.bodies);
  for (const Body& body : world.bodies) {
    world.wear.grids.emplace_back(body.facets, world.wear.cell_size,
                                  static_cast<Index>(world.wear.cell_count()));
  }
  world.wear.clear(world.walls.size(), scene.particles.size());
}

template void set_wear(World<float>&, const Scene&);
template void set_wear(World<double>&, const Scene&);

}  // namespace quern
