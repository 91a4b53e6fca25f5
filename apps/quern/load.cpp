#include "apps/quern/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/log.h"
#include "io/mesh_reader.h"
#include "io/scene_reader.h"

namespace quern {

namespace {

LoadedScene finish(SceneResult result) {
  for (const std::string& line : result.warnings) log_warn(line);
  LoadedScene loaded;
  loaded.scene = std::move(result.scene);
  std::vector<std::string> errors = std::move(result.errors);
  for (MeshWallSpec& mesh : loaded.scene.meshes) {
    const std::filesystem::path path = std::filesystem::path(loaded.scene.folder) / mesh.path;
    mesh.path = std::filesystem::absolute(path).lexically_normal().string();
    MeshResult read = read_stl(mesh.path, mesh.scale);
    errors.insert(errors.end(), read.errors.begin(), read.errors.end());
    loaded.meshes.push_back(std::move(read.triangles));
  }
  if (!errors.empty()) throw InputErrors{errors};
  loaded.seeds = draw_sizes(loaded.scene);
  loaded.dt = choose_time_step(loaded.scene, loaded.seeds);
  loaded.scene.run.time_step = loaded.dt;
  return loaded;
}

}  // namespace

LoadedScene load_scene(const std::string& path, const std::vector<std::string>& overrides) {
  return finish(read_scene(path, overrides));
}

LoadedScene load_scene_text(const std::string& text, const std::string& name,
                            const std::string& folder) {
  return finish(parse_scene(text, name, folder));
}

Shape read_shape(const std::string& path, const ShapeOptions& options, ShapeReport& report) {
  const MeshResult mesh = read_stl(path, 1);
  if (!mesh.errors.empty()) throw InputErrors{mesh.errors};
  return build_shape(mesh.triangles, path, options, report);
}

void judge_time_step(const LoadedScene& loaded) {
  const std::vector<StepAdvice> all = advise_steps(loaded.scene, loaded.seeds, loaded.dt);
  const auto worst = std::min_element(
      all.begin(), all.end(),
      [](const StepAdvice& a, const StepAdvice& b) { return a.steps_normal < b.steps_normal; });
  if (worst == all.end() || worst->steps_normal >= kWarnedSteps) return;
  const std::string what =
      fmt::format("'run.time_step' {:.3g} s gives {:.1f} steps per contact of {} and {}", loaded.dt,
                  worst->steps_normal, worst->a, worst->b);
  if (worst->steps_normal < kRefusedSteps) {
    throw InputErrors{
        {fmt::format("error: {}; at least {:g} are needed ({:.3g} s), {:g} advised", what,
                     kRefusedSteps, worst->contact_time / kRefusedSteps, kAdvisedSteps)}};
  }
  log_warn(fmt::format("{}; {:g} are advised for accuracy", what, kAdvisedSteps));
}

}  // namespace quern
