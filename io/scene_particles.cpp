// [[particles]]: sizes and amounts said exactly once, materials with a density, CSV files read.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "io/particle_csv.h"
#include "io/scene_checks_parts.h"

namespace quern {
namespace {

constexpr double kMostParticles = 4e9;

std::vector<std::string> given_of(const SceneCheck& check, const std::string& path,
                                  std::initializer_list<const char*> keys) {
  std::vector<std::string> given;
  for (const char* key : keys)
    if (check.context.trace.given(path + "." + key)) given.emplace_back(key);
  return given;
}

bool any_spoiled(const SceneCheck& check, const std::string& path,
                 std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (check.context.trace.spoiled(path + "." + key)) return true;
  return false;
}

void check_classes(const SceneCheck& check, const std::string& path, const ParticleSpec& species) {
  double shares = 0;
  bool counts = false, by_mass = false, clean = true;
  for (std::size_t k = 0; k < species.sizes.size(); ++k) {
    const SizeClass& size = species.sizes[k];
    const std::string row = fmt::format("{}.sizes[{}]", path, k);
    if (size.from > size.to && check.good({row + ".from", row + ".to"}))
      check.error(row + ".from", fmt::format("'from': {} m is above 'to' ({} m)",
                                             format_number(size.from), format_number(size.to)));
    clean = clean && check.good({row + ".count", row + ".mass_share"});
    if (size.count && size.mass_share)
      check.error(row, "give 'count' or 'mass_share', not both");
    else if (!size.count && !size.mass_share && clean)
      check.error(row, "a size class needs 'count' or 'mass_share'");
    counts = counts || size.count;
    by_mass = by_mass || size.mass_share;
    shares += size.mass_share.value_or(0);
  }
  if (!clean) return;
  if (counts && by_mass)
    check.error(path + ".sizes",
                "'sizes': give 'count' in every class, or 'mass_share' in every "
                "class");
  else if (by_mass && std::abs(shares - 1) > 1e-3)
    check.error(
        path + ".sizes",
        fmt::format("'sizes': the mass shares add up to {:.4g}, they must add up to 1", shares));
}

void check_distribution(const SceneCheck& check, const std::string& path,
                        const SizeDistribution& sizes) {
  if (any_spoiled(check, path, {"distribution", "distribution.table"})) return;
  const std::string at = path + ".distribution";
  if (!check.context.trace.given(at)) return;
  const std::vector<std::string> given = given_of(check, at, {"table", "rosin_rammler"});
  if (given.size() != 1)
    return check.error(at, "'distribution' needs one of 'table', 'rosin_rammler'");
  if (sizes.kind == DistributionKind::kRosinRammler) {
    if (sizes.from > sizes.to && check.good({at + ".rosin_rammler.from", at + ".rosin_rammler.to"}))
      check.error(at + ".rosin_rammler.from",
                  fmt::format("'from': {} m is above 'to' ({} m)", format_number(sizes.from),
                              format_number(sizes.to)));
  } else if (sizes.passing.size() < 2 || sizes.passing.back().second != 1) {
    check.error(at + ".table", "'table' needs two rows at least, the last with a share of 1");
  }
}

// How much of the species there is: exactly one way to say it.
void check_amount(const SceneCheck& check, const std::string& path, const ParticleSpec& species,
                  const std::vector<std::string>& size_keys) {
  if (any_spoiled(check, path, {"count", "mass", "filling_level", "sizes", "csv", "entries"}))
    return;
  std::vector<std::string> given = given_of(check, path, {"count", "mass", "filling_level"});
  bool counted = false;
  for (const SizeClass& size : species.sizes) counted = counted || size.count;
  for (const std::string& key : size_keys)
    if (key == "csv" || key == "entries") given.push_back(key);
  if (counted) given.emplace_back("sizes.count");
  if (given.size() > 1)
    check.error(path + "." + given[given[1] == "sizes.count" ? 0 : 1],
                fmt::format("'{}' and '{}' both say how many; give one", given[0], given[1]));
  else if (given.empty())
    check.error(
        path, fmt::format("particles '{}' need 'count', 'mass' or 'filling_level'", species.name));
  if (species.filling_level && !check.scene.mill && check.good({"mill"}))
    check.error(path + ".filling_level", "'filling_level' needs a [mill]");
}

void check_sizes(const SceneCheck& check, const std::string& path, ParticleSpec& species) {
  if (!check.good({path + ".shape"})) return;  // another shape has other sizes
  std::vector<std::string> keys = given_of(
      check, path, {"diameter", "equivalent_diameter", "sizes", "distribution", "csv", "entries"});
  const bool entries = !species.explicit_particles.empty();
  if (keys.size() == 2 && keys[0].ends_with("diameter") && keys[1] == "entries") {
    for (ExplicitParticle& particle : species.explicit_particles)
      if (particle.diameter == 0) particle.diameter = species.diameter.value_or(0);
    species.diameter.reset();
    keys.erase(keys.begin());
  }
  check_amount(check, path, species, keys);
  if (any_spoiled(check, path,
                  {"diameter", "equivalent_diameter", "sizes", "distribution", "csv", "entries"}))
    return;
  if (keys.size() > 1)
    check.error(path + "." + keys[1],
                fmt::format("'{}' and '{}' both say the sizes; give one", keys[0], keys[1]));
  else if (keys.empty())
    check.error(path, fmt::format("particles '{}' need 'diameter', 'sizes', 'distribution', "
                                  "'entries' or 'csv'",
                                  species.name));
  for (std::size_t k = 0; entries && k < species.explicit_particles.size(); ++k) {
    const std::string row = fmt::format("{}.entries[{}]", path, k);
    if (species.explicit_particles[k].diameter == 0 && check.good({row, row + ".diameter"}))
      check.error(row, "an entry needs 'diameter', or the species does");
  }
}

void check_material(const SceneCheck& check, const std::string& path, const ParticleSpec& species) {
  check.material(path + ".material", species.material);
  for (const Material& material : check.scene.materials) {
    const std::string density = "materials." + material.name + ".density";
    if (material.name == species.material && material.density == 0 &&
        check.good({density, "materials." + material.name}))
      check.error(density, fmt::format("material '{}' is used by particles and needs a 'density' "
                                       "greater than 0",
                                       material.name));
  }
}

// Polyhedra need their mesh; a mesh without them is legal, so that shapes can be set to spheres
// (`mesh` warns, `polyhedron_mesh` is for that).
void check_shape(const SceneCheck& check, const std::string& path, const ParticleSpec& species) {
  const std::vector<std::string> given = given_of(check, path, {"mesh", "polyhedron_mesh"});
  std::vector<std::string>& places = check.draft.shape_mesh_places.emplace_back();
  for (std::size_t k = 0; k < species.meshes.size(); ++k) {
    places.push_back(
        check.place(fmt::format("{}.{}[{}]", path, given.empty() ? "mesh" : given[0], k)));
  }
  if (given.size() == 2)
    return check.error(path + ".polyhedron_mesh",
                       "'mesh' and 'polyhedron_mesh' are the same; give one");
  if (given == std::vector<std::string>{"mesh"} && !has_polyhedra(species)) {
    check.context.messages.warning(check.context.trace.place(path + ".mesh"),
                                   "'mesh' is not used: these particles are spheres; shape = "
                                   "\"polyhedron\" makes them bodies");
  }
  if (given.size() == 1)
    for (const std::string& mesh : species.meshes) check.file(path + "." + given[0], mesh);
  else if (has_polyhedra(species) && check.good({path + ".shape"}))
    check.error(path, fmt::format("particles '{}' need 'mesh', the STL file of their polyhedra",
                                  species.name));
}

void check_entries(const SceneCheck& check, const std::string& path, ParticleSpec& species) {
  for (std::size_t k = 0; k < species.explicit_particles.size(); ++k) {
    std::optional<Turn>& turn = species.explicit_particles[k].orientation;
    const std::string axis = fmt::format("{}.entries[{}].orientation.axis", path, k);
    if (turn && !normalize(turn->axis) && check.good({axis}))
      check.error(axis, "'axis' must not be zero");
  }
}

void load_csv(const SceneCheck& check, const std::string& path, ParticleSpec& species) {
  check.file(path + ".csv", species.csv);
  if (species.csv.empty() || !check.good({path + ".csv"})) return;
  const auto full = [&](const std::string& file) {
    return (std::filesystem::path(check.scene.folder) / file).lexically_normal().string();
  };
  std::vector<std::string> sharing;
  for (const ParticleSpec& other : check.scene.particles)
    if (full(other.csv) == full(species.csv)) sharing.push_back(other.name);
  ParticleCsv csv = read_particle_csv(full(species.csv), species.name, sharing);
  for (const std::string& line : csv.errors) check.context.messages.other_file(line);
  if (csv.errors.empty() && csv.particles.empty())
    check.error(path + ".csv",
                fmt::format("'csv': '{}' has no particles{}", species.csv,
                            sharing.size() > 1 ? fmt::format(" of class '{}'", species.name) : ""));
  species.explicit_particles = std::move(csv.particles);
}

double count_of(const ParticleSpec& species) {
  double count = static_cast<double>(species.count.value_or(0));
  for (const SizeClass& size : species.sizes) count += static_cast<double>(size.count.value_or(0));
  return count + static_cast<double>(species.explicit_particles.size());
}

}  // namespace

void check_particles(const SceneCheck& check) {
  std::vector<std::string> names;
  std::vector<ParticleSpec>& all = check.scene.particles;
  double total = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string path = fmt::format("particles[{}]", i);
    check.name(path + ".name", all[i].name, names);
    check_material(check, path, all[i]);
    check_shape(check, path, all[i]);
    check_sizes(check, path, all[i]);
    check_classes(check, path, all[i]);
    check_distribution(check, path, all[i].distribution);
    check_entries(check, path, all[i]);
    load_csv(check, path, all[i]);
    total += count_of(all[i]);
  }
  if (total > kMostParticles)
    check.error("particles", fmt::format("{:.3g} particles are too many (at most {:.0e})", total,
                                         kMostParticles));
  if (all.empty() && check.scene.run.start == StartKind::kFill && check.good({"particles"}))
    check.error("", "there are no [[particles]]");
}

}  // namespace quern
