#include "apps/quern/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "apps/quern/machine.h"
#include "io/log.h"
#include "io/mesh_reader.h"
#include "io/scene_reader.h"

namespace quern {

namespace {

std::string absolute_path(const Scene& scene, const std::string& file) {
  const std::filesystem::path path = std::filesystem::path(scene.folder) / file;
  return std::filesystem::absolute(path).lexically_normal().string();
}

// What a mesh says of itself, behind the place where the scene names it.
std::string placed(const std::string& place, std::string line) {
  constexpr std::string_view kWord = "error: ";
  const std::size_t at = line.find(kWord);
  if (at != std::string::npos) line.erase(at, kWord.size());
  return fmt::format("{}: error: 'mesh': {}", place, line);
}

struct MeshOfShape {
  std::string path, place;
  ShapeOptions options;
};

// Row of the shape; kNoIndex, and lines in `errors`, where the file gives none.
Index add_shape(const MeshOfShape& mesh, std::vector<Shape>& shapes,
                std::vector<std::string>& errors, Say warn) {
  try {
    ShapeReport report;
    shapes.push_back(read_shape(mesh.path, mesh.options, report));
    for (const std::string& line : report.warnings) warn(line);
    return static_cast<Index>(shapes.size() - 1);
  } catch (const InputErrors& problems) {
    for (const std::string& line : problems.lines) errors.push_back(placed(mesh.place, line));
  } catch (const UserError& problem) {
    errors.push_back(placed(mesh.place, problem.what()));
  }
  return kNoIndex;
}

// A file that serves several species is read once for each of its two options.
void load_shapes(const std::vector<std::vector<std::string>>& places, LoadedScene& loaded,
                 std::vector<std::string>& errors, Say warn) {
  std::map<std::pair<std::string, bool>, Index> known;
  for (std::size_t s = 0; s < loaded.scene.particles.size(); ++s) {
    ParticleSpec& species = loaded.scene.particles[s];
    std::vector<Index>& rows = loaded.species_shapes.emplace_back();
    if (!has_polyhedra(species)) continue;
    for (std::size_t k = 0; k < species.meshes.size(); ++k) {
      std::string& mesh = species.meshes[k];
      mesh = absolute_path(loaded.scene, mesh);
      const auto [at, fresh] = known.try_emplace({mesh, species.hull}, kNoIndex);
      if (fresh) {
        at->second = add_shape({mesh, places[s][k], {species.hull}}, loaded.shapes, errors, warn);
      }
      rows.push_back(at->second);
    }
  }
}

void refuse_too_large(const Scene& scene) {
  const double expected = expected_memory(scene), available = available_memory();
  if (expected <= available) return;
  const ParticleCount count = count_particles(scene);
  throw SystemError(fmt::format(
      "the scene is too large for this machine: its {:.3g} spheres and {:.3g} polyhedra need about "
      "{:.3g} GB of memory, {:.3g} GB are available",
      count.spheres, count.polyhedra, expected * 1e-9, available * 1e-9));
}

LoadedScene finish(SceneResult result, Say warn) {
  for (const std::string& line : result.warnings) warn(line);
  LoadedScene loaded;
  loaded.scene = std::move(result.scene);
  std::vector<std::string> errors = std::move(result.errors);
  for (std::size_t w = 0; w < loaded.scene.meshes.size(); ++w) {
    MeshWallSpec& mesh = loaded.scene.meshes[w];
    mesh.path = absolute_path(loaded.scene, mesh.path);
    MeshResult read = read_stl(mesh.path, mesh.scale);
    for (const std::string& line : read.errors) {
      errors.push_back(placed(result.wall_mesh_places[w], line));
    }
    loaded.meshes.push_back(std::move(read.triangles));
  }
  load_shapes(result.shape_mesh_places, loaded, errors, warn);
  if (!errors.empty()) throw InputErrors{errors};
  refuse_too_large(loaded.scene);
  loaded.seeds = draw_sizes(loaded.scene);
  assign_shapes(loaded.shapes, loaded.species_shapes, loaded.seeds);
  loaded.dt = choose_time_step(loaded.scene, loaded.seeds);
  loaded.scene.run.time_step = loaded.dt;
  return loaded;
}

}  // namespace

double expected_memory(const Scene& scene) {
  constexpr double kProgram = 150e6, kOfPolyhedron = 8000;  // B
  const double of_sphere = scene.run.precision == Precision::kDouble ? 1400 : 1100;
  const ParticleCount count = count_particles(scene);
  return kProgram + of_sphere * count.spheres + kOfPolyhedron * count.polyhedra;
}

LoadedScene load_scene(const std::string& path, const std::vector<std::string>& overrides,
                       Say warn) {
  return finish(read_scene(path, overrides), warn);
}

LoadedScene load_scene_text(const std::string& text, const std::string& name,
                            const std::string& folder) {
  return finish(parse_scene(text, name, folder, {}, StartFile::kReadBefore), log_warn);
}

Shape read_shape(const std::string& path, const ShapeOptions& options, ShapeReport& report) {
  const MeshResult mesh = read_stl(path, 1);
  if (!mesh.errors.empty()) throw InputErrors{mesh.errors};
  return build_shape(mesh.triangles, path, options, report);
}

double fewest_steps_per_contact(const LoadedScene& loaded) {
  double fewest = std::numeric_limits<double>::quiet_NaN();
  for (const StepAdvice& pair : advise_steps(loaded.scene, loaded.seeds, loaded.dt)) {
    fewest = std::fmin(fewest, pair.steps_normal);
  }
  return fewest;
}

namespace {

void judge_rayleigh(const LoadedScene& loaded, const std::vector<StepAdvice>& all, Say warn) {
  const auto least = std::min_element(
      all.begin(), all.end(),
      [](const StepAdvice& a, const StepAdvice& b) { return a.rayleigh_time < b.rayleigh_time; });
  if (least == all.end() || least->rayleigh_time == 0) return;
  const double share = loaded.dt / least->rayleigh_time;
  if (share <= kWarnedRayleigh) return;
  const std::string what =
      fmt::format("'run.time_step' {:.3g} s is {:.2g} of the Rayleigh time of {} ({:.3g} s)",
                  loaded.dt, share, least->a, least->rayleigh_time);
  if (share > kRefusedRayleigh) {
    throw InputErrors{
        {fmt::format("error: {}; {:g} of it is allowed ({:.3g} s), {:g} advised", what,
                     kRefusedRayleigh, kRefusedRayleigh * least->rayleigh_time, kAdvisedRayleigh)}};
  }
  warn(fmt::format("{}; {:g} is advised for accuracy", what, kAdvisedRayleigh));
}

}  // namespace

void judge_time_step(const LoadedScene& loaded, Say warn) {
  const double toss = flat_face_toss(loaded.scene, loaded.seeds, loaded.dt);
  if (toss > kWarnedToss) {
    warn(fmt::format(
        "normal_model = \"volume\": the push of one step on a flat face throws a polyhedron up by "
        "{:.2g} of its diameter, energy from nowhere; below {:g} it hardly shows: take a smaller "
        "'contact.volume_stiffness' or 'run.time_step'",
        toss, kWarnedToss));
  }
  const std::vector<StepAdvice> all = advise_steps(loaded.scene, loaded.seeds, loaded.dt);
  judge_rayleigh(loaded, all, warn);
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
  warn(fmt::format("{}; {:g} are advised for accuracy", what, kAdvisedSteps));
}

}  // namespace quern
