// Loading: from a scene file to everything a run starts from; used by run, resume and check.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/log.h"
#include "kernels/hull.h"
#include "scheduler/fill.h"
#include "scheduler/setup.h"

namespace quern {

// The user's input has mistakes; each line is complete. Exit code 2.
struct InputErrors {
  std::vector<std::string> lines;
};

struct LoadedScene {
  Scene scene;
  std::vector<std::vector<Triangle>> meshes;
  std::vector<Shape> shapes;                       // every mesh of polyhedra once
  std::vector<std::vector<Index>> species_shapes;  // mesh k of a species -> row of shapes
  std::vector<ParticleSeed> seeds;                 // drawn, not placed; they point into shapes
  double dt = 0;                                   // s
};

// What a run of the scene will take at its peak (B), records and report page included. Mills and
// beds of 10 thousand to 400 thousand particles took 0.8 to 1.0 of what is for particles.
double expected_memory(const Scene& scene);

using Say = void (*)(std::string_view);  // where news go
inline void say_nothing(std::string_view) {}

// Reads the scene and its meshes and draws the particles. Tells warnings to `warn`; throws
// InputErrors, and SystemError before anything large is made if the machine has too little memory
// for the scene.
LoadedScene load_scene(const std::string& path, const std::vector<std::string>& overrides,
                       Say warn = log_warn);
LoadedScene load_scene_text(const std::string& text, const std::string& name,
                            const std::string& folder);

// The shape in an STL file; lengths in the file's units. Throws InputErrors or UserError.
Shape read_shape(const std::string& path, const ShapeOptions& options, ShapeReport& report);

// Steps per contact of the pair that has the fewest; NaN where nothing can touch.
double fewest_steps_per_contact(const LoadedScene& loaded);

// Refuses a step with fewer than kRefusedSteps per contact, warns below kWarnedSteps.
void judge_time_step(const LoadedScene& loaded, Say warn = log_warn);

}  // namespace quern
