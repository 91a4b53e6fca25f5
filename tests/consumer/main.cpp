// quern as a library, in ten lines: a scene from text, its world, one second of it.
#include <cstdio>

#include "io/scene_reader.h"
#include "scheduler/fill.h"
#include "scheduler/setup.h"
#include "scheduler/step.h"

constexpr const char* kScene = R"(
format = 1
[run]
duration = "1 s"
time_step = "1e-5 s"
[domain]
low = ["-1 m", "-1 m", "-1 m"]
high = ["1 m", "1 m", "1 m"]
[materials.ore]
density = "4500 kg/m^3"
[contact]
normal_stiffness = "1e6 N/m"
tangential_stiffness = "4e5 N/m"
restitution = 0.3
sliding_friction = 0.5
[[walls]]
material = "ore"
point = ["0 m", "0 m", "0 m"]
normal = [0, 1, 0]
[[particles]]
material = "ore"
diameter = "20 mm"
entries = [{ position = ["0 m", "0.1 m", "0 m"] }]
)";

int main() {
  using namespace quern;
  const SceneResult read = parse_scene(kScene, "drop.toml", ".");
  for (const std::string& error : read.errors) std::puts(error.c_str());
  std::vector<ParticleSeed> particles = draw_sizes(read.scene);
  SceneGeometry geometry = build_geometry(read.scene, {}, particles);
  place_particles(read.scene, geometry.facets(), particles);
  World<float> world = make_world<float>(read.scene, std::move(geometry), particles, particles);
  Stepper<float> stepper(world, 1);
  while (world.time() < 1) stepper.step();
  const double height = world.particles.record[0].y;
  std::printf("after %g s the sphere lies at %.4f mm\n", world.time(), 1e3 * height);
  return height > 0.0099 && height < 0.0101 ? 0 : 1;
}
