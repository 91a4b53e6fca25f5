// [[walls]]: which kind each is, what that kind needs, and its motion.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "io/scene_checks_parts.h"

namespace quern {

bool normalize(Vec3& v) {
  const double length = v.norm();
  if (!(length > 0)) return false;
  if (std::abs(length - 1) > 4 * std::numeric_limits<double>::epsilon()) v /= length;
  return true;
}
namespace {

struct WallKeys {
  WallKind kind;
  const char* name;
  std::vector<const char*> needed, allowed;
};

const WallKeys kWallKeys[] = {
    {WallKind::kMesh, "mesh", {"mesh"}, {"mesh", "scale"}},
    {WallKind::kPlane, "plane", {"point", "normal"}, {"point", "normal"}},
    {WallKind::kBox, "box", {"low", "high"}, {"low", "high", "open_top"}},
};

std::optional<WallKind> infer_kind(const WallSpec& wall) {
  if (wall.kind) return wall.kind;
  if (!wall.mesh.empty()) return WallKind::kMesh;
  if (wall.point || wall.normal) return WallKind::kPlane;
  if (wall.low || wall.high) return WallKind::kBox;
  return std::nullopt;
}

void check_keys(const SceneCheck& check, const std::string& path, const WallKeys& kind) {
  for (const char* key : kind.needed)
    if (!check.context.trace.given(path + "." + key) && check.good({path + "." + key}))
      check.error(path, fmt::format("a {} needs '{}'", kind.name, key));
  for (const WallKeys& other : kWallKeys)
    for (const char* key : other.allowed) {
      const std::string at = path + "." + key;
      if (other.kind != kind.kind && check.context.trace.given(at))
        check.error(
            at, fmt::format("'{}' belongs to a {}, this wall is a {}", key, other.name, kind.name));
    }
}

void check_motion(const SceneCheck& check, const std::string& path, Motion& motion) {
  const Trace& trace = check.context.trace;
  if (!trace.given(path) || !check.good({path, path + ".kind"})) return;
  if (!normalize(motion.axis) && check.good({path + ".axis"}))
    check.error(path + ".axis", "'axis' must not be zero");
  const auto need = [&](const char* key, const char* kind) {
    const std::string at = path + "." + key;
    if (!trace.given(at) && check.good({at}))
      check.error(path, fmt::format("a motion of kind \"{}\" needs '{}'", kind, key));
  };
  const auto refuse = [&](const char* key, const char* kind) {
    const std::string at = path + "." + key;
    // Written scenes give every key: a zero says nothing.
    const bool zero = (std::string_view(key) == "amplitude" && motion.amplitude == 0) ||
                      (std::string_view(key) == "frequency" && motion.frequency == 0) ||
                      (std::string_view(key) == "rate" && motion.rate.points.size() == 1 &&
                       motion.rate.points[0].value == 0);
    if (trace.given(at) && !zero && check.good({at}))
      check.error(at, fmt::format("'{}' does not belong to a motion of kind \"{}\"", key, kind));
  };
  switch (motion.kind) {
    case MotionKind::kFixed:
      if (!trace.given(path + ".kind"))
        check.error(path, "a motion needs 'kind' (fixed, rotation, translation, oscillation)");
      break;
    case MotionKind::kRotation:
      need("rate", "rotation");
      refuse("amplitude", "rotation");
      refuse("frequency", "rotation");
      break;
    case MotionKind::kTranslation:
      need("rate", "translation");
      refuse("amplitude", "translation");
      refuse("frequency", "translation");
      break;
    case MotionKind::kOscillation:
      need("amplitude", "oscillation");
      need("frequency", "oscillation");
      refuse("rate", "oscillation");
      break;
  }
}

void sort_wall(const SceneCheck& check, const std::string& path, const WallSpec& wall,
               WallKind kind) {
  const Vec3 zero = Vec3::Zero();
  if (kind == WallKind::kMesh) {
    check.file(path + ".mesh", wall.mesh);
    check.draft.wall_mesh_places.push_back(check.place(path + ".mesh"));
    check.scene.meshes.push_back(
        {wall.name, wall.mesh, wall.material, wall.scale.value_or(1), wall.motion, wall.group});
  } else if (kind == WallKind::kPlane) {
    Vec3 normal = wall.normal.value_or(Vec3::UnitZ());
    if (!normalize(normal)) check.error(path + ".normal", "'normal' must not be zero");
    check.scene.planes.push_back(
        {wall.name, wall.material, wall.point.value_or(zero), normal, wall.motion, wall.group});
  } else {
    check.corners(path, wall.low, wall.high);
    check.scene.boxes.push_back({wall.name, wall.material, wall.low.value_or(zero),
                                 wall.high.value_or(zero), wall.open_top.value_or(false),
                                 wall.motion, wall.group});
  }
}

}  // namespace

void check_walls(const SceneCheck& check) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < check.draft.walls.size(); ++i) {
    WallSpec& wall = check.draft.walls[i];
    const std::string path = fmt::format("walls[{}]", i);
    check.name(path + ".name", wall.name, names);
    check.material(path + ".material", wall.material);
    check_motion(check, path + ".motion", wall.motion);
    const std::optional<WallKind> kind = infer_kind(wall);
    if (kind) {
      const WallKeys& keys = kWallKeys[static_cast<std::size_t>(*kind)];
      check_keys(check, path, keys);
      sort_wall(check, path, wall, *kind);
    } else if (check.good({path + ".kind", path + ".mesh", path + ".point", path + ".normal",
                           path + ".low", path + ".high"})) {
      check.error(path, "a wall needs 'mesh', or 'point' and 'normal', or 'low' and 'high'");
    }
  }
}

}  // namespace quern
