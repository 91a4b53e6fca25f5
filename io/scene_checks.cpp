// Checks between keys: run, materials, contact, mill, domain and fill. Walls and particles are in
// their own files, scene_walls.cpp and scene_particles.cpp.
#include "io/scene_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "io/scene_checks_parts.h"
#include "soa/groups.h"
#include "soa/record.h"

namespace quern {

void SceneCheck::error(const std::string& path, const std::string& text) const {
  context.error(path, context.trace.place(path), text);
}

std::vector<std::string> SceneCheck::material_names() const {
  std::vector<std::string> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  return names;
}

void SceneCheck::material(const std::string& path, const std::string& name) const {
  if (name.empty() || context.trace.spoiled(path)) return;
  const std::vector<std::string> names = material_names();
  for (const std::string& known : names)
    if (known == name) return;
  const std::string list = names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
  error(path, fmt::format("'{}': no material '{}'{} ({})", path.substr(path.rfind('.') + 1), name,
                          did_you_mean(name, names), list));
}

void SceneCheck::name(const std::string& path, const std::string& name,
                      std::vector<std::string>& taken) const {
  bool plain = true;
  for (const char c : name)
    plain = plain && (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-');
  if (!plain)
    error(path, fmt::format("name '{}' may hold letters, digits, _ and - only", name));
  else if (std::find(taken.begin(), taken.end(), name) != taken.end())
    error(path, fmt::format("the name '{}' is taken", name));
  taken.push_back(name);
}

void SceneCheck::file(const std::string& path, const std::string& file) const {
  if (file.empty() || context.trace.spoiled(path)) return;
  std::error_code ignored;
  const std::filesystem::path full = std::filesystem::path(scene.folder) / file;
  // A run's folder stands for the checkpoint in it.
  if (!std::filesystem::is_regular_file(full, ignored) &&
      !std::filesystem::is_regular_file(full / "checkpoint.h5", ignored))
    error(path, fmt::format("'{}': there is no file '{}' in {}", path.substr(path.rfind('.') + 1),
                            file, scene.folder));
}

void SceneCheck::corners(const std::string& table, const std::optional<Vec3>& low,
                         const std::optional<Vec3>& high) const {
  if (low.has_value() != high.has_value() && good({table + ".low", table + ".high"}))
    error(table + (low ? ".low" : ".high"), "'low' and 'high' must be given together");
  if (!low || !high) return;
  for (int k = 0; k < 3; ++k)
    if ((*low)[k] >= (*high)[k])
      return error(table + ".high",
                   fmt::format("'high': {} = {} m is not above that of 'low' ({} m)", "xyz"[k],
                               format_number((*high)[k]), format_number((*low)[k])));
}

namespace {

// Length of the run in seconds where it is known before the run.
std::optional<double> run_time(const Scene& scene) {
  if (scene.run.duration) return scene.run.duration;
  if (!scene.run.revolutions || !scene.mill || scene.mill->rotation.points.size() != 1)
    return std::nullopt;
  const double rate = std::abs(scene.mill->rotation.points[0].value);
  if (rate == 0) return std::nullopt;
  return *scene.run.revolutions * 2 * kPi / rate;
}

bool mill_turns(const Scene& scene) {
  if (!scene.mill) return false;
  for (const Schedule::Point& point : scene.mill->rotation.points)
    if (point.value != 0) return true;
  return false;
}

void check_record(const SceneCheck& check) {
  const RunSpec& run = check.scene.run;
  if (run.record_from && run.record_from_revolution)
    return check.error("run.record_from_revolution",
                       "give 'record_from' or 'record_from_revolution', not both");
  if (run.record_from_revolution && run.revolutions &&
      *run.record_from_revolution >= *run.revolutions)
    return check.error("run.record_from_revolution",
                       fmt::format("'record_from_revolution': {} is not before the end of the run "
                                   "({} revolutions)",
                                   *run.record_from_revolution, *run.revolutions));
  const std::optional<double> end = run_time(check.scene);
  double begin = run.record_from.value_or(0);
  if (run.record_from_revolution && mill_turns(check.scene) &&
      check.scene.mill->rotation.points.size() == 1)
    begin = *run.record_from_revolution * 2 * kPi /
            std::abs(check.scene.mill->rotation.points[0].value);
  if (!end || begin < *end) return;
  const char* key = run.record_from ? "record_from" : "record_from_revolution";
  check.error(
      std::string("run.") + key,
      fmt::format("'{}': {:.6g} s is not before the end of the run ({:.6g} s)", key, begin, *end));
}

void check_run(const SceneCheck& check) {
  const RunSpec& run = check.scene.run;
  const bool clean = check.good({"run", "run.duration", "run.revolutions"});
  if (run.duration && run.revolutions)
    check.error("run.revolutions", "give 'duration' or 'revolutions', not both");
  else if (!run.duration && !run.revolutions && clean)
    check.error("run", "[run] needs 'duration' or 'revolutions'");
  for (const char* key : {"revolutions", "record_from_revolution"}) {
    const std::string path = std::string("run.") + key;
    if (check.context.trace.given(path) && !mill_turns(check.scene) &&
        check.good({path, "mill", "mill.rotation"}))
      check.error(path, fmt::format("'{}' needs a [mill] with a rotation", key));
  }
  if (check.good({"run.duration", "run.revolutions", "run.record_from",
                  "run.record_from_revolution", "mill.rotation"}))
    check_record(check);
  if (run.start == StartKind::kFile && run.start_file.empty() && check.good({"run.start_file"}))
    check.error("run.start", "'start': \"file\" needs 'start_file'");
  if (run.start != StartKind::kFile && !run.start_file.empty() && check.good({"run.start"}))
    check.error("run.start_file", "'start_file' needs start = \"file\"");
  if (check.draft.start_file == StartFile::kNeeded) check.file("run.start_file", run.start_file);
  if (run.relax && run.start == StartKind::kFill && check.scene.fill.method == FillMethod::kRain &&
      check.good({"run.start", "run.relax", "fill.method"}))
    check.error("run.relax", "'relax' is for particles that are there from the start: not with rain");
  if (run.overlap_cap && !run.relax && check.good({"run.relax"}))
    check.error("run.overlap_cap", "'overlap_cap' needs 'relax'");
}

void check_pairs(const SceneCheck& check) {
  const std::vector<PairCoefficients>& pairs = check.scene.contact.pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string path = fmt::format("contact.pair[{}].between", i);
    check.material(path, pairs[i].a);
    check.material(path, pairs[i].b);
    for (std::size_t j = 0; j < i && !pairs[i].a.empty(); ++j) {
      const bool same = (pairs[i].a == pairs[j].a && pairs[i].b == pairs[j].b) ||
                        (pairs[i].a == pairs[j].b && pairs[i].b == pairs[j].a);
      if (!same) continue;
      const Place first = check.context.trace.place(fmt::format("contact.pair[{}].between", j));
      check.error(path, fmt::format("the pair {}-{} was given before, in line {}", pairs[i].a,
                                    pairs[i].b, first.line));
    }
  }
}

const PairCoefficients* find_pair(const Scene& scene, const std::string& a, const std::string& b) {
  for (const PairCoefficients& pair : scene.contact.pairs)
    if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)) return &pair;
  return nullptr;
}

std::vector<std::string> wall_materials(const SceneDraft& draft) {
  std::vector<std::string> names;
  if (draft.scene.mill) {
    const MillSpec& mill = *draft.scene.mill;
    names.push_back(mill.material);
    if (mill.ends == EndKind::kWalls && !mill.end_material.empty())
      names.push_back(mill.end_material);
  }
  for (const WallSpec& wall : draft.walls) names.push_back(wall.material);
  return names;
}

// The pairs of known materials that can touch: particles with particles and with walls.
std::vector<std::pair<std::string, std::string>> meeting_pairs(const SceneDraft& draft) {
  const std::vector<std::string> walls = wall_materials(draft);
  std::vector<std::pair<std::string, std::string>> pairs;
  const auto known = [&](const std::string& name) {
    return std::any_of(draft.scene.materials.begin(), draft.scene.materials.end(),
                       [&](const Material& material) { return material.name == name; });
  };
  const auto add = [&](const std::string& a, const std::string& b) {
    if (!known(a) || !known(b)) return;
    for (const auto& [c, d] : pairs)
      if ((a == c && b == d) || (a == d && b == c)) return;
    pairs.emplace_back(a, b);
  };
  for (const ParticleSpec& species : draft.scene.particles) {
    for (const ParticleSpec& other : draft.scene.particles) add(species.material, other.material);
    for (const std::string& wall : walls) add(species.material, wall);
  }
  return pairs;
}

using Coefficient = std::optional<double> PairCoefficients::*;
using DefaultCoefficient = std::optional<double> ContactSpec::*;

void check_coefficient(const SceneCheck& check, const char* name, Coefficient of_pair,
                       DefaultCoefficient fallback) {
  if (check.scene.contact.*fallback || !check.good({"contact", std::string("contact.") + name}))
    return;
  for (std::size_t i = 0; i < check.scene.contact.pairs.size(); ++i)
    if (!check.good({fmt::format("contact.pair[{}].between", i),
                     fmt::format("contact.pair[{}].{}", i, name)}))
      return;  // a pair that cannot be told hides what is missing
  std::string list;
  for (const auto& [a, b] : meeting_pairs(check.draft)) {
    const PairCoefficients* pair = find_pair(check.scene, a, b);
    if (!pair || !(pair->*of_pair)) list += (list.empty() ? "" : ", ") + a + "-" + b;
  }
  if (!list.empty())
    check.error("contact", fmt::format("[contact] has no '{}' for {}: give it here or in a "
                                       "[[contact.pair]]",
                                       name, list));
}

void warn_restitution(const SceneCheck& check, const std::string& path,
                      const std::optional<double>& restitution) {
  constexpr double kLeastClamped = 0.135;  // of critical damping, the most that is used
  if (check.scene.contact.normal_force == NormalForce::kClamped && restitution &&
      *restitution < kLeastClamped)
    check.context.messages.warning(
        check.context.trace.place(path),
        fmt::format("'restitution': {} is not reached with normal_force = \"clamped\": damping "
                    "ends at critical, which delivers {}",
                    *restitution, kLeastClamped));
}

void warn_unused(const SceneCheck& check, const std::string& path, const char* needed) {
  if (!check.context.trace.given(path)) return;
  const std::string key = path.substr(path.rfind('.') + 1);
  check.context.messages.warning(check.context.trace.place(path),
                                 fmt::format("'{}' is not used: it needs {}", key, needed));
}

// Moduli of all materials that can touch, in place of stiffnesses.
void check_hertz_mindlin(const SceneCheck& check) {
  std::vector<std::string> touching = wall_materials(check.draft);
  for (const ParticleSpec& species : check.scene.particles) touching.push_back(species.material);
  for (const Material& material : check.scene.materials) {
    if (std::find(touching.begin(), touching.end(), material.name) == touching.end()) continue;
    const auto need = [&](const char* key, const std::optional<double>& value) {
      const std::string path = fmt::format("materials.{}.{}", material.name, key);
      if (!value && check.good({path}))
        check.error("materials." + material.name,
                    fmt::format("material '{}' needs a '{}': law = \"hertz-mindlin\" asks for it",
                                material.name, key));
    };
    need("young_modulus", material.young_modulus);
    need("poisson_ratio", material.poisson_ratio);
  }
  if (check.scene.contact.normal_model == NormalModel::kVolume &&
      check.good({"contact.normal_model"}))
    check.error("contact.normal_model",
                "'normal_model': \"volume\" is no Hertz contact: it needs law = "
                "\"linear-spring-dashpot\"");
  const char* const needed = "law = \"linear-spring-dashpot\"";
  for (const char* key : {"normal_stiffness", "tangential_stiffness"}) {
    warn_unused(check, fmt::format("contact.{}", key), needed);
    for (std::size_t i = 0; i < check.scene.contact.pairs.size(); ++i)
      warn_unused(check, fmt::format("contact.pair[{}].{}", i, key), needed);
  }
}

void check_contact(const SceneCheck& check) {
  using P = PairCoefficients;
  using C = ContactSpec;
  check_pairs(check);
  if (check.scene.contact.law == ForceLaw::kHertzMindlin) {
    check_hertz_mindlin(check);
  } else {
    check_coefficient(check, "normal_stiffness", &P::normal_stiffness, &C::normal_stiffness);
    check_coefficient(check, "tangential_stiffness", &P::tangential_stiffness,
                      &C::tangential_stiffness);
  }
  check_coefficient(check, "restitution", &P::restitution, &C::restitution);
  check_coefficient(check, "sliding_friction", &P::sliding_friction, &C::sliding_friction);
  if (check.scene.contact.normal_model != NormalModel::kVolume)
    warn_unused(check, "contact.volume_stiffness", "normal_model = \"volume\"");
  warn_restitution(check, "contact.restitution", check.scene.contact.restitution);
  for (std::size_t i = 0; i < check.scene.contact.pairs.size(); ++i)
    warn_restitution(check, fmt::format("contact.pair[{}].restitution", i),
                     check.scene.contact.pairs[i].restitution);
}

void check_lifters(const SceneCheck& check, const MillSpec& mill, const LifterSpec& lifters) {
  const std::string at = "mill.lifters.";
  if (!check.good(
          {at + "count", at + "height", at + "top_width", at + "face_angle", "mill.diameter"}) ||
      mill.diameter <= 0 || lifters.count <= 0)
    return;
  const double radius = mill.diameter / 2;
  if (lifters.height >= radius)
    return check.error(at + "height",
                       fmt::format("'height': {} m is not less than the mill's radius ({} m)",
                                   format_number(lifters.height), format_number(radius)));
  const double base = lifters.top_width + 2 * lifters.height * std::tan(lifters.face_angle);
  const double half_angle = kPi / lifters.count;
  const double base_pitch = lifters.count == 1 ? mill.diameter : 2 * radius * std::sin(half_angle);
  const double top_pitch =
      lifters.count == 1 ? mill.diameter : 2 * (radius - lifters.height) * std::sin(half_angle);
  if (base >= base_pitch)
    check.error(at + "top_width",
                fmt::format("'top_width': the base of a lifter ({:.4g} m) is wider than the pitch "
                            "of {} lifters ({:.4g} m)",
                            base, lifters.count, base_pitch));
  else if (lifters.top_width >= top_pitch)
    check.error(at + "top_width",
                fmt::format("'top_width': {:.4g} m is wider than the pitch of {} lifters at their "
                            "tops ({:.4g} m)",
                            lifters.top_width, lifters.count, top_pitch));
}

void check_mill(const SceneCheck& check) {
  if (!check.scene.mill) return;
  const MillSpec& mill = *check.scene.mill;
  check.material("mill.material", mill.material);
  check.material("mill.end_material", mill.end_material);
  if (mill.lifters) check_lifters(check, mill, *mill.lifters);
}

void check_domain(const SceneCheck& check) {
  DomainSpec& domain = check.scene.domain;
  check.corners("domain", domain.low, domain.high);
  const bool clean = check.good({"domain.low", "domain.high", "domain.periodic"});
  const bool periodic = domain.periodic[0] || domain.periodic[1] || domain.periodic[2];
  if (periodic && !domain.low && !domain.high && clean && !check.scene.mill)
    check.error("domain.periodic", "'periodic' needs 'low' and 'high'");
  if (!check.scene.mill || check.scene.mill->ends != EndKind::kPeriodic) return;
  const MillSpec& mill = *check.scene.mill;
  domain.periodic[2] = true;
  if (!domain.low && !domain.high) {
    const double radius = mill.diameter / 2;
    domain.low = Vec3(-radius, -radius, 0);
    domain.high = Vec3(radius, radius, mill.length);
  } else if (domain.low && domain.high && clean &&
             (domain.low->z() != 0 || domain.high->z() != mill.length)) {
    check.error("domain.low",
                fmt::format("a mill with ends = \"periodic\" needs z from 0 to its length ({} m) "
                            "in 'low' and 'high'",
                            format_number(mill.length)));
  }
}

void check_fill(const SceneCheck& check) {
  FillSpec& fill = check.scene.fill;
  check.corners("fill", fill.low, fill.high);
  bool placed = false;
  for (const ParticleSpec& species : check.scene.particles)
    placed = placed || species.explicit_particles.empty();
  const bool given = check.context.trace.given("fill.method");
  if (fill.method == FillMethod::kSegment && !check.scene.mill && check.good({"mill"})) {
    if (!given)
      fill.method = FillMethod::kRandom;
    else if (placed && check.good({"fill.method"}))
      check.error("fill.method", "'method': \"segment\" needs a [mill] (random, rain)");
  }
}

// Groups of particles and of walls are told apart by name; a pair of them is written with a dash.
void check_groups(const SceneCheck& check) {
  std::vector<std::string> of_walls;
  if (check.scene.mill) of_walls.push_back(check.scene.mill->group);
  for (const WallSpec& wall : check.draft.walls) of_walls.push_back(wall.group);
  const auto plain = [&](const std::string& path, const std::string& group) {
    std::vector<std::string> none;
    if (check.good({path})) check.name(path, group, none);
    if (group.find('-') != std::string::npos)
      check.error(path, fmt::format("'group': '{}' may not hold -", group));
  };
  if (check.scene.mill) plain("mill.group", check.scene.mill->group);
  for (std::size_t i = 0; i < check.draft.walls.size(); ++i)
    plain(fmt::format("walls[{}].group", i), check.draft.walls[i].group);
  for (std::size_t i = 0; i < check.scene.particles.size(); ++i) {
    const ParticleSpec& species = check.scene.particles[i];
    const std::string path = fmt::format("particles[{}].group", i);
    if (!species.group.empty()) plain(path, species.group);
    if (std::find(of_walls.begin(), of_walls.end(), group_of(species)) != of_walls.end())
      check.error(check.context.trace.given(path) ? path : fmt::format("particles[{}].name", i),
                  fmt::format("'{}' is a group of walls already", group_of(species)));
  }
}

// Settings of what is not recorded.
void check_record_settings(const SceneCheck& check) {
  const RecordSpec& record = check.scene.record;
  const auto needs = [&](const char* key, bool given, const char* what) {
    if (given) check.error(std::string("record.") + key, fmt::format("'{}' needs {}", key, what));
  };
  const bool map = record.charge_shape || !check.good({"record.charge_shape"});
  const bool any = map || record.classes || !record.zones.empty() ||
                   !check.good({"record.classes", "record.zones"});
  needs("snapshots_every", !any && record.snapshots_every > 0,
        "charge_shape = true, classes = true or [[record.zones]]");
  needs("cell_angle", !map && record.cell_angle > 0, "charge_shape = true");
  needs("cell_width", !map && record.cell_width > 0, "charge_shape = true");
}

void check_output(const SceneCheck& check) {
  const OutputSpec& output = check.scene.output;
  if (output.contacts && output.frames_every == 0 &&
      check.good({"output.contacts", "output.frames_every"}))
    check.error("output.contacts", "'contacts' needs frames_every");
}

void check_zones(const SceneCheck& check) {
  constexpr double kTurn = 2 * kPi;
  constexpr double kDegree = kPi / 180;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < check.scene.record.zones.size(); ++k) {
    const ZoneSpec& zone = check.scene.record.zones[k];
    const std::string path = fmt::format("record.zones[{}].", k);
    check.name(path + "name", zone.name, names);
    if (zone.radius_to && *zone.radius_to <= zone.radius_from &&
        check.good({path + "radius_from", path + "radius_to"}))
      check.error(path + "radius_to",
                  fmt::format("'radius_to': {} m is not above 'radius_from' ({} m)",
                              format_number(*zone.radius_to), format_number(zone.radius_from)));
    if (check.scene.mill && zone.radius_from >= check.scene.mill->diameter / 2 &&
        check.good({path + "radius_from", "mill", "mill.diameter"}))
      check.error(path + "radius_from",
                  fmt::format("'radius_from': {} m is not inside the mill's radius ({} m)",
                              format_number(zone.radius_from),
                              format_number(check.scene.mill->diameter / 2)));
    if (!check.good({path + "angle_from", path + "angle_to"})) continue;
    const double span = zone.angle_to - zone.angle_from;
    // A full turn in degrees is one in radians to rounding.
    if (span == 0 || std::abs(span) > kTurn * (1 + 1e-12))
      check.error(path + "angle_to", fmt::format("'angle_to': from {:.6g} to {:.6g} degrees is {}",
                                                 zone.angle_from / kDegree, zone.angle_to / kDegree,
                                                 span == 0 ? "nothing" : "more than a full turn"));
  }
}

void check_record_table(const SceneCheck& check) {
  const RecordSpec& record = check.scene.record;
  if (record.charge_shape && !check.scene.mill && check.good({"mill", "record.charge_shape"}))
    check.error("record.charge_shape", "'charge_shape' needs a [mill]");
  check_record_settings(check);
  check_zones(check);
  if (!check.scene.mill || record.cell_width <= check.scene.mill->diameter / 4 ||
      !check.good({"record.cell_width", "mill.diameter"}))
    return;
  check.error("record.cell_width",
              fmt::format("'cell_width': {} m leaves fewer than two cells along the mill's radius",
                          format_number(record.cell_width)));
}

// A flow pressure for each wall.
void check_wear(const SceneCheck& check) {
  const Scene& scene = check.scene;
  if (!scene.wear || scene.wear->flow_pressure || !check.good({"wear", "wear.flow_pressure"}))
    return;
  std::vector<std::string> told;
  for (const std::string& name : wall_materials(check.draft)) {
    if (std::find(told.begin(), told.end(), name) != told.end()) continue;
    told.push_back(name);
    for (const Material& material : scene.materials)
      if (material.name == name && material.hardness <= 0 &&
          check.good({"materials." + name + ".hardness"}))
        check.error("wear", fmt::format("[wear] needs the hardness of the walls: give "
                                        "materials.{}.hardness, or 'flow_pressure' here",
                                        name));
  }
}

}  // namespace

void check_scene(SceneDraft& draft, ReadContext& context) {
  SceneCheck check{draft, draft.scene, context};
  if (draft.format != 1 && check.good({"format"}))
    check.error("format", fmt::format("'format': {} is not known (1)", draft.format));
  std::vector<std::string> names;
  for (const Material& material : draft.scene.materials)
    check.name("materials." + material.name, material.name, names);
  if (names.size() > kMostMaterials)
    check.error("materials", fmt::format("{} materials are too many (at most {})", names.size(),
                                         kMostMaterials));
  check_walls(check);
  check_particles(check);
  check_run(check);
  check_contact(check);
  check_mill(check);
  check_domain(check);
  check_fill(check);
  check_groups(check);
  check_output(check);
  check_record_table(check);
  check_wear(check);
}

}  // namespace quern
