// Scenes: TOML text to soa/scene.h and back.
//
// All mistakes of a file are collected in one pass, each as `file:line:column: error: ...` (or
// `--set key=value: error: ...` for the command line); a scene with errors must not be run. Values
// are converted to SI here and nowhere else. Relative paths inside a scene start at its folder.
#pragma once

#include <string>
#include <vector>

#include "soa/scene.h"

namespace quern {

// Whether run.start_file must exist: a run that goes on from its own checkpoint has read it before.
enum class StartFile { kNeeded, kReadBefore };

struct SceneResult {
  Scene scene;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
  // Where the scene names its STL files, as a message begins ("mill.toml:12:8"): of scene.meshes,
  // and of the meshes of each of scene.particles.
  std::vector<std::string> wall_mesh_places;
  std::vector<std::vector<std::string>> shape_mesh_places;
};

// `overrides` are "key=value" as given to --set: dotted keys, entries of arrays addressed by name
// (particles.ball.count=2000, contact.ore-steel.restitution=0.4, walls.belt.scale=1), values as in
// TOML or bare text, numbers without a unit in SI. Setting one of several ways to say a thing
// (duration or revolutions; count, mass or filling_level) drops the others.
SceneResult read_scene(const std::string& path, const std::vector<std::string>& overrides = {});

// The same from a text. `display_name` stands in messages; relative paths start at `folder`.
SceneResult parse_scene(const std::string& text, const std::string& display_name,
                        const std::string& folder, const std::vector<std::string>& overrides = {},
                        StartFile start_file = StartFile::kNeeded);

// The scene with every default filled in, in SI units; reads back to an equal scene.
std::string scene_to_toml(const Scene& scene);

struct SceneKey {
  std::string path;      // as in --set: "mill.lifters.count", "particles.NAME.count"
  std::string type;      // "length > 0", "integer", "mixed | double"
  std::string fallback;  // the default; empty: required, or automatic (see doc)
  std::string doc;       // one line
  bool required = false;
};

// Every key of a scene, in the order in which scene_to_toml() writes them.
std::vector<SceneKey> scene_keys();

}  // namespace quern
