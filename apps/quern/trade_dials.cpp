#include "apps/quern/trade_dials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <set>

namespace quern {

namespace {

using Rows = std::vector<TradeRow>;
using Keys = std::vector<std::string>;

constexpr double kSteps[] = {4, 6, 10, 15, 20, 30, 50};
constexpr double kSoftened[] = {3, 10, 30, 100};
constexpr double kSlack[] = {0.1, 0.3, 1};  // of the smallest diameter
constexpr double kLengths[] = {0.6, 2};     // of the scene's
constexpr int kFacets[] = {6, 20, 40};

Keys operator+(Keys a, const Keys& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string mm(double metres) { return fmt::format("{:g}", 1e3 * metres); }

// A step a hair shorter than asked for: rounding must not make it too long to be allowed.
Keys step_key(double seconds) {
  return {fmt::format("run.time_step={:.12g}", seconds * (1 - 1e-9))};
}

double contact_time_of(const LoadedScene& loaded) {
  return fewest_steps_per_contact(loaded) * loaded.dt;
}

// Hertz' contact time goes with E^-2/5, that of a linear spring with k^-1/2.
double slower(const Scene& scene, double times) {
  return std::pow(times, scene.contact.law == ForceLaw::kHertzMindlin ? 0.4 : 0.5);
}

// All stiffnesses of the scene divided by `times`.
Keys soft_keys(const Scene& scene, double times) {
  Keys keys;
  const auto add = [&](const std::string& key, const std::optional<double>& value) {
    if (value) keys.push_back(fmt::format("{}={:.12g}", key, *value / times));
  };
  for (const Material& m : scene.materials) {
    add(fmt::format("materials.{}.young_modulus", m.name), m.young_modulus);
  }
  const ContactSpec& c = scene.contact;
  add("contact.normal_stiffness", c.normal_stiffness);
  add("contact.tangential_stiffness", c.tangential_stiffness);
  add("contact.volume_stiffness", c.volume_stiffness);
  for (const PairCoefficients& p : c.pairs) {
    const std::string pair = fmt::format("contact.{}-{}.", p.a, p.b);
    add(pair + "normal_stiffness", p.normal_stiffness);
    add(pair + "tangential_stiffness", p.tangential_stiffness);
  }
  return keys;
}

Keys softened(const LoadedScene& loaded, double times) {
  return soft_keys(loaded.scene, times) + step_key(loaded.dt * slower(loaded.scene, times));
}

std::string sizes_key(const ParticleSpec& species, const std::vector<SizeClass>& sizes) {
  std::string rows;
  for (const SizeClass& size : sizes) {
    const std::string amount = size.count ? fmt::format("count = {}", *size.count)
                                          : fmt::format("mass_share = {:.12g}", *size.mass_share);
    const bool polyhedron = shape_of(species, size) == ShapeKind::kPolyhedron;
    rows += fmt::format("{}{{ from = {:.12g}, to = {:.12g}, {}, shape = \"{}\" }}",
                        rows.empty() ? "" : ", ", size.from, size.to, amount,
                        polyhedron ? "polyhedron" : "sphere");
  }
  return fmt::format("particles.{}.sizes=[{}]", species.name, rows);
}

// Shapes by size: polyhedra from a diameter on, where the species has meshes.
Keys shape_keys(const Scene& scene, double polyhedra_from) {
  Keys keys;
  for (const ParticleSpec& species : scene.particles) {
    if (species.meshes.empty()) continue;
    std::string meshes;
    for (const std::string& mesh : species.meshes) {
      meshes += fmt::format("{}\"{}\"", meshes.empty() ? "" : ", ", mesh);
    }
    keys.push_back(fmt::format("particles.{}.polyhedron_mesh=[{}]", species.name, meshes));
    if (species.sizes.empty()) {
      const double d = species.diameter.value_or(0);
      const bool body = d >= polyhedra_from;
      keys.push_back(
          fmt::format("particles.{}.shape={}", species.name, body ? "polyhedron" : "sphere"));
      if (species.diameter) {
        keys.push_back(fmt::format("particles.{}.{}={:.12g}", species.name,
                                   body ? "equivalent_diameter" : "diameter", d));
      }
      continue;
    }
    std::vector<SizeClass> sizes = species.sizes;
    for (SizeClass& size : sizes) {
      size.shape =
          size.from >= polyhedra_from * (1 - 1e-9) ? ShapeKind::kPolyhedron : ShapeKind::kSphere;
    }
    keys.push_back(sizes_key(species, sizes));
  }
  return keys;
}

bool any_polyhedra(const Scene& scene) {
  return std::any_of(scene.particles.begin(), scene.particles.end(), has_polyhedra);
}

void add_precision(const LoadedScene& loaded, Rows& rows) {
  const Precision own = loaded.scene.run.precision;
  for (const Precision precision : {Precision::kSingle, Precision::kMixed, Precision::kDouble}) {
    if (precision == own) continue;
    const char* name = word_of(precision);
    rows.push_back({"precision",
                    name,
                    {fmt::format("precision_{}", name),
                     {fmt::format("run.precision={}", name)},
                     SteadyState::kOwnCharge},
                    kFinestSetting});
  }
}

void add_steps(const LoadedScene& loaded, Rows& rows) {
  for (const double steps : kSteps) {
    rows.push_back({kStepsDial,
                    fmt::format("{:g}", steps),
                    {fmt::format("steps_{:g}", steps), step_key(contact_time_of(loaded) / steps)},
                    kFinestSetting});
  }
}

void add_softness(const LoadedScene& loaded, Rows& rows) {
  for (const double times : kSoftened) {
    rows.push_back({"softened",
                    fmt::format("{:g} x", times),
                    {fmt::format("soft_{:g}", times), softened(loaded, times)},
                    kFinestSetting});
  }
}

void add_pairs_of_dials(const LoadedScene& loaded, Rows& rows) {
  const auto soft_and_steps = [&](double times, double steps) {
    const double dt = contact_time_of(loaded) * slower(loaded.scene, times) / steps;
    rows.push_back({"softened, steps",
                    fmt::format("{:g} x, {:g}", times, steps),
                    {fmt::format("soft_{:g}_steps_{:g}", times, steps),
                     soft_keys(loaded.scene, times) + step_key(dt)},
                    kFinestSetting});
  };
  soft_and_steps(10, 6);
  soft_and_steps(10, 20);
  if (!any_polyhedra(loaded.scene)) return;
  rows.push_back(
      {"softened, polyhedra",
       "10 x, none",
       {"soft_10_polyhedra_none", softened(loaded, 10) + shape_keys(loaded.scene, HUGE_VAL),
        SteadyState::kOwnShapes},
       kFinestSetting});
}

void add_finest(const LoadedScene& loaded, Rows& rows) {
  const bool is_double = loaded.scene.run.precision == Precision::kDouble;
  Keys keys = step_key(contact_time_of(loaded) / 50);
  if (!is_double) keys.push_back("run.precision=double");
  rows.push_back(
      {"finest",
       "double, 50 steps",
       {kFinestSetting, keys, is_double ? SteadyState::kShared : SteadyState::kOwnCharge},
       kFinestSetting});
}

// Values of the dial are the lower ends of the size classes.
void add_polyhedra(const LoadedScene& loaded, Rows& rows) {
  const Scene& scene = loaded.scene;
  std::set<double> from;
  double own = HUGE_VAL;
  for (const ParticleSpec& species : scene.particles) {
    if (species.meshes.empty()) continue;
    for (const SizeClass& size : species.sizes) {
      from.insert(size.from);
      if (shape_of(species, size) == ShapeKind::kPolyhedron) own = std::min(own, size.from);
    }
    if (species.sizes.empty() && has_polyhedra(species)) own = species.diameter.value_or(0);
  }
  if (!any_polyhedra(scene)) return;
  from.insert(own);
  const std::string finest =
      *from.begin() == own ? kDefaultSetting : fmt::format("polyhedra_{}mm", mm(*from.begin()));
  constexpr const char* kDial = "polyhedra from";
  for (const double d : from) {
    const std::string value = mm(d) + " mm";
    if (d == own) {
      rows.push_back({kDial, value, {kDefaultSetting, {}}, finest});
    } else {
      rows.push_back(
          {kDial,
           value,
           {fmt::format("polyhedra_{}mm", mm(d)), shape_keys(scene, d), SteadyState::kOwnShapes},
           finest});
    }
  }
  rows.push_back({kDial,
                  "none",
                  {"polyhedra_none", shape_keys(scene, HUGE_VAL), SteadyState::kOwnShapes},
                  finest});
}

// Shapes oreN.stl beside the mesh of a species stand for the same rock with N faces.
void add_facets(const LoadedScene& loaded, Rows& rows) {
  namespace fs = std::filesystem;
  if (!any_polyhedra(loaded.scene)) return;
  const auto keys_of = [&](int facets) {
    Keys keys;
    for (const ParticleSpec& species : loaded.scene.particles) {
      if (!has_polyhedra(species)) continue;
      const fs::path mesh =
          fs::path(species.meshes.front()).parent_path() / fmt::format("ore{}.stl", facets);
      if (!fs::exists(mesh)) return Keys();
      keys.push_back(
          fmt::format("particles.{}.polyhedron_mesh=\"{}\"", species.name, mesh.string()));
    }
    return keys;
  };
  constexpr const char* kDial = "facets";
  std::size_t own = 0;
  for (const Shape& shape : loaded.shapes) own = std::max<std::size_t>(own, shape.faces);
  Rows found;
  bool own_placed = false;
  for (const int facets : kFacets) {
    const Keys keys = keys_of(facets);
    if (!own_placed && own <= static_cast<std::size_t>(facets)) {
      found.push_back({kDial, fmt::format("{}", own), {kDefaultSetting, {}}, ""});
      own_placed = true;
    }
    if (keys.empty() || own == static_cast<std::size_t>(facets)) continue;
    found.push_back({kDial,
                     fmt::format("{}", facets),
                     {fmt::format("facets_{}", facets), keys, SteadyState::kOwnShapes},
                     ""});
  }
  if (found.size() < 2) return;
  for (TradeRow& row : found) row.against = found.back().setting.name;
  rows.insert(rows.end(), found.begin(), found.end());
}

double mean_volume(const SizeClass& size) {  // over pi/6; diameters are uniform in [from, to]
  if (size.to <= size.from) return std::pow(size.from, 3);
  return (std::pow(size.to, 4) - std::pow(size.from, 4)) / (4 * (size.to - size.from));
}

// Classes below `least` are left out, their mass goes to those that stay.
std::optional<std::vector<SizeClass>> kept_sizes(const ParticleSpec& species, double least) {
  std::vector<SizeClass> kept;
  double all = 0, left = 0;
  const auto amount = [](const SizeClass& s) {
    return s.count ? static_cast<double>(*s.count) * mean_volume(s) : *s.mass_share;
  };
  for (const SizeClass& size : species.sizes) {
    all += amount(size);
    if (size.from < least * (1 - 1e-9)) continue;
    kept.push_back(size);
    left += amount(size);
  }
  if (kept.empty() || kept.size() == species.sizes.size()) return std::nullopt;
  for (SizeClass& size : kept) {
    if (size.count) size.count = std::lround(static_cast<double>(*size.count) * all / left);
    if (size.mass_share) size.mass_share = *size.mass_share * all / left;
  }
  return kept;
}

void add_smallest(const LoadedScene& loaded, Rows& rows) {
  std::set<double> from;
  for (const ParticleSpec& species : loaded.scene.particles) {
    for (const SizeClass& size : species.sizes) from.insert(size.from);
  }
  if (from.size() < 2) return;
  constexpr const char* kDial = "smallest size";
  rows.push_back({kDial, mm(*from.begin()) + " mm", {kDefaultSetting, {}}, kDefaultSetting});
  for (auto d = std::next(from.begin()); d != from.end(); ++d) {
    Keys keys;
    for (const ParticleSpec& species : loaded.scene.particles) {
      if (const auto kept = kept_sizes(species, *d)) keys.push_back(sizes_key(species, *kept));
    }
    if (keys.empty()) continue;
    rows.push_back({kDial,
                    mm(*d) + " mm",
                    {fmt::format("smallest_{}mm", mm(*d)), keys, SteadyState::kOwnCharge},
                    kDefaultSetting});
  }
}

void add_overlap(const LoadedScene& loaded, Rows& rows) {
  if (!any_polyhedra(loaded.scene)) return;
  const bool chord = loaded.scene.contact.overlap == OverlapMeasure::kChord;
  const std::string other = chord ? "width" : "chord";
  rows.push_back(
      {"overlap", other, {"overlap_" + other, {"contact.overlap=" + other}}, kFinestSetting});
}

// Of slices only: between ends that are walls the length is the mill's own.
void add_lengths(const LoadedScene& loaded, Rows& rows) {
  const Scene& scene = loaded.scene;
  if (!scene.mill || scene.mill->ends != EndKind::kPeriodic) return;
  const auto scaled = [](long count, double times) {
    return std::max(1L, std::lround(static_cast<double>(count) * times));
  };
  constexpr const char* kDial = "slice length";
  const double length = scene.mill->length;
  const auto name = [&](double times) { return fmt::format("length_{:g}m", times * length); };
  const std::string finest = name(*std::max_element(std::begin(kLengths), std::end(kLengths)));
  rows.push_back({kDial, fmt::format("{:g} m", length), {kDefaultSetting, {}}, finest});
  for (const double times : kLengths) {
    Keys keys = {fmt::format("mill.length={:.12g}", times * length)};
    for (const ParticleSpec& species : scene.particles) {
      const auto set = [&](const char* key, double value) {
        keys.push_back(fmt::format("particles.{}.{}={:.12g}", species.name, key, value));
      };
      if (species.count) set("count", static_cast<double>(scaled(*species.count, times)));
      if (species.mass) set("mass", *species.mass * times);
      std::vector<SizeClass> sizes = species.sizes;
      bool counted = false;
      for (SizeClass& size : sizes) {
        if (!size.count) continue;
        size.count = scaled(*size.count, times);
        counted = true;
      }
      if (counted) keys.push_back(sizes_key(species, sizes));
    }
    rows.push_back({kDial,
                    fmt::format("{:g} m", times * length),
                    {name(times), keys, SteadyState::kOwnCharge},
                    finest});
  }
}

void add_slack(const LoadedScene& loaded, Rows& rows) {
  double smallest = HUGE_VAL;
  for (const ParticleSeed& p : loaded.seeds) smallest = std::min(smallest, 2 * p.radius);
  for (const double share : kSlack) {
    rows.push_back({"list slack",
                    fmt::format("{:g} d", share),
                    {fmt::format("slack_{:g}", share),
                     {fmt::format("run.list_slack={:.6g}", share * smallest)}},
                    kFinestSetting});
  }
}

}  // namespace

std::vector<TradeRow> trade_rows(const LoadedScene& loaded) {
  Rows rows;
  rows.push_back({"default",
                  fmt::format("{:.3g} steps", fewest_steps_per_contact(loaded)),
                  {kDefaultSetting, {}},
                  kFinestSetting});
  constexpr void (*kDials[])(const LoadedScene&, Rows&) = {
      add_finest, add_precision, add_steps,   add_softness, add_pairs_of_dials, add_polyhedra,
      add_facets, add_smallest,  add_overlap, add_lengths,  add_slack};
  for (const auto& add : kDials) add(loaded, rows);
  return rows;
}

std::vector<std::string> as_spheres(const Scene& scene) { return shape_keys(scene, HUGE_VAL); }

}  // namespace quern
