// Worlds for tests: a scene from TOML text or built by hand, set up as the program does it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/mesh_reader.h"
#include "io/scene_reader.h"
#include "kernels/hull.h"
#include "scheduler/fill.h"
#include "scheduler/phases.h"
#include "scheduler/setup.h"
#include "scheduler/step.h"

namespace quern {

inline Scene scene_of(const std::string& toml, const std::vector<std::string>& overrides = {}) {
  SceneResult result = parse_scene(toml, "test.toml", ".", overrides);
  for (const std::string& error : result.errors) ADD_FAILURE() << error;
  return result.scene;
}

inline Scene shipped_scene(const std::string& name, const std::vector<std::string>& overrides = {}) {
  SceneResult result = read_scene(std::string(QUERN_SOURCE_DIR "/apps/scenes/") + name + ".toml",
                                  overrides);
  for (const std::string& error : result.errors) ADD_FAILURE() << error;
  return result.scene;
}

// What a scene's polyhedra look like and its particles, as the program loads them.
struct DrawnScene {
  std::vector<Shape> shapes;
  std::vector<ParticleSeed> seeds;  // they point into shapes
};
inline DrawnScene drawn(const Scene& scene) {
  DrawnScene all;
  std::vector<std::vector<Index>> rows;
  for (const ParticleSpec& species : scene.particles) {
    rows.emplace_back();
    if (!has_polyhedra(species)) continue;
    for (const std::string& mesh : species.meshes) {
      const std::string path = scene.folder.empty() ? mesh : scene.folder + "/" + mesh;
      const MeshResult read = read_stl(path, 1);
      for (const std::string& error : read.errors) ADD_FAILURE() << error;
      ShapeReport report;
      rows.back().push_back(static_cast<Index>(all.shapes.size()));
      all.shapes.push_back(build_shape(read.triangles, mesh, {species.hull}, report));
    }
  }
  all.seeds = draw_sizes(scene);
  assign_shapes(all.shapes, rows, all.seeds);
  return all;
}

// World of a scene with its particles placed; the clock is at the start of the run phase.
template <class Real>
World<Real> world_of(const Scene& scene, const std::vector<std::vector<Triangle>>& meshes = {}) {
  auto [shapes, seeds] = drawn(scene);
  SceneGeometry geometry = build_geometry(scene, meshes, seeds);
  place_particles(scene, geometry.facets(), seeds);
  World<Real> world =
      make_world<Real>(scene, std::move(geometry), seeds, seeds, std::move(shapes));
  world.moving_walls = true;
  return world;
}

// Steps until `time`; every step must be free of fatal bits.
template <class Real>
void run_until(World<Real>& world, Stepper<Real>& stepper, double time) {
  while (world.time() < time - 0.5 * world.clock.dt) {
    const StepReport report = stepper.step();
    ASSERT_EQ(report.bits & kFatalBits, 0u) << "at t = " << world.time() << ", particle "
                                            << report.first.id;
  }
}

// Row of the particle with this identity.
template <class Real>
std::size_t row_of(const World<Real>& world, Index id) {
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    if (world.particles.id[k] == id) return k;
  }
  ADD_FAILURE() << "no particle " << id;
  return 0;
}

template <class Real>
Vec3 velocity_of(const World<Real>& world, Index id) {
  const Record<Real>& r = world.particles.record[row_of(world, id)];
  return {r.vx, r.vy, r.vz};
}
template <class Real>
Vec3 place_of(const World<Real>& world, Index id) {
  const Record<Real>& r = world.particles.record[row_of(world, id)];
  return {r.x, r.y, r.z};
}
template <class Real>
Vec3 spin_of(const World<Real>& world, Index id) {
  const std::size_t k = row_of(world, id);
  return {world.particles.spin_x[k], world.particles.spin_y[k], world.particles.spin_z[k]};
}

}  // namespace quern
