#include "io/report_walls.h"

#include <fmt/format.h>

#include <array>

#include "io/frames.h"
#include "io/packed.h"
#include "io/report_tables.h"
#include "soa/motion.h"

namespace quern {

namespace {

constexpr std::size_t kMostTriangles = 200000;  // of all walls, and cells of one

struct Surface {
  std::vector<float> vertex;
  std::vector<std::int64_t> corner;
  std::vector<std::uint16_t> wall;
};

template <class T>
std::vector<T> read_column(const Hdf5File& file, const std::string& name) {
  const ArrayLayout found = file.layout(name);
  if (found.type != element_type_of<T>()) file.fail("read dataset '" + name + "'", describe(found));
  std::vector<T> values(found.rows * found.components);
  file.read(name, found, values.data());
  return values;
}

Surface read_surface(const std::string& path) {
  const Hdf5File file("frame", path, FileMode::kRead);
  return {read_column<float>(file, "VTKHDF/Points"),
          read_column<std::int64_t>(file, "VTKHDF/Connectivity"),
          read_column<std::uint16_t>(file, "VTKHDF/CellData/wall")};
}

// Corners of a wall's triangles at t = 0.
std::vector<float> corners_of(const Surface& surface, std::size_t wall, const Pose& pose) {
  std::vector<float> corners;
  for (std::size_t t = 0; t < surface.wall.size(); ++t) {
    if (surface.wall[t] != wall) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const float* p = surface.vertex.data() + 3 * surface.corner[3 * t + k];
      const Vec3 x = pose.rotation.transpose() * (Vec3(p[0], p[1], p[2]) - pose.shift);
      for (int a = 0; a < 3; ++a) corners.push_back(static_cast<float>(x[a]));
    }
  }
  return corners;
}

std::string pack_floats(const std::vector<float>& values) {
  return packed({reinterpret_cast<const std::uint8_t*>(values.data()), 4 * values.size()});
}

// [w, x, y, z, shift x, y, z] of each time.
std::string poses_json(const Motion& motion, const std::vector<double>& times) {
  std::string json;
  for (const double time : times) {
    const Pose pose = pose_at(motion, time);
    const Quat q(pose.rotation);
    json +=
        fmt::format("{}[{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}]", json.empty() ? "" : ",",
                    q.w(), q.x(), q.y(), q.z(), pose.shift[0], pose.shift[1], pose.shift[2]);
  }
  return "[" + json + "]";
}

constexpr std::array<const char*, 6> kWearFields = {"depth_rate_siem",    "depth_rate_sliding",
                                                    "depth_rate_archard", "depth_rate_finnie",
                                                    "pressure",           "shear"};

// The wear cells of a wall with what is told of each; "null" if there are none.
std::string wear_json(const Hdf5File& results, const std::string& wall, std::size_t blob,
                      WallsOfView& out) {
  const std::string table = "wear/" + wall;
  if (!results.exists(table + "/corner")) return "null";
  const ArrayLayout corner = results.layout(table + "/corner");
  if (corner.components != 9 || corner.rows == 0) return "null";
  if (corner.rows > kMostTriangles) {
    out.notes.push_back(
        fmt::format("The {} wear cells of {} are too many to be drawn here", corner.rows, wall));
    return "null";
  }
  const auto as_floats = [&](const std::string& name) {
    if (results.layout(name).type == ElementType::kF32) return read_column<float>(results, name);
    const auto values = read_column<double>(results, name);
    return std::vector<float>(values.begin(), values.end());
  };
  std::vector<float> all = as_floats(table + "/corner");
  std::string fields;
  for (const char* field : kWearFields) {
    const std::string name = fmt::format("{}/{}", table, field);
    if (!results.exists(name) || results.layout(name).rows != corner.rows) continue;
    const std::vector<float> values = as_floats(name);
    all.insert(all.end(), values.begin(), values.end());
    const std::string unit =
        results.has_attribute(name, "unit") ? results.text_attribute(name, "unit") : "";
    fields += fmt::format("{}{{\"name\":\"{}\",\"unit\":{}}}", fields.empty() ? "" : ",", field,
                          json_string(unit));
  }
  out.packed.push_back(pack_floats(all));
  return fmt::format("{{\"blob\":{},\"cells\":{},\"fields\":[{}]}}", blob, corner.rows, fields);
}

WallsOfView worn_walls(const WallQuery& query, const std::vector<NamedMotion>& walls,
                       const Surface& surface, double time, const Hdf5File& results) {
  WallsOfView out;
  std::string json;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const auto& [name, motion] = walls[k];
    const std::vector<float> corners = corners_of(surface, k, pose_at(motion, time));
    const std::size_t blob = query.first_blob + out.packed.size();
    out.packed.push_back(pack_floats(corners));
    const std::string wear = wear_json(results, name, query.first_blob + out.packed.size(), out);
    json += fmt::format("{}{{\"name\":{},\"blob\":{},\"triangles\":{},\"wear\":{},\"poses\":{}}}",
                        json.empty() ? "" : ",", json_string(name), blob, corners.size() / 9, wear,
                        poses_json(motion, query.times));
  }
  out.json = "[" + json + "]";
  return out;
}

}  // namespace

std::vector<NamedMotion> walls_of(const Scene& scene) {
  std::vector<NamedMotion> walls;
  if (scene.mill) {
    Motion motion;
    motion.kind = MotionKind::kRotation;
    motion.rate = scene.mill->rotation;
    walls.push_back({"liner", motion});
    if (scene.mill->ends == EndKind::kWalls) walls.push_back({"ends", motion});
  }
  for (const MeshWallSpec& mesh : scene.meshes) walls.push_back({mesh.name, mesh.motion});
  for (const BoxSpec& box : scene.boxes) walls.push_back({box.name, box.motion});
  for (const PlaneSpec& plane : scene.planes) walls.push_back({plane.name, plane.motion});
  return walls;
}

WallsOfView read_walls(const WallQuery& query, const Scene& scene) {
  WallsOfView out;
  const std::vector<FrameEntry> listed = read_frame_list(query.frames, "liner");
  if (listed.empty()) return out;
  const Surface surface = read_surface(frame_path(query.frames, "liner", listed.back().number));
  if (surface.wall.size() > kMostTriangles) {
    out.notes.push_back(
        fmt::format("The walls' {} triangles are too many to be drawn here", surface.wall.size()));
    return out;
  }
  const auto read = [&](const Hdf5File& results) {
    out = worn_walls(query, walls_of(scene), surface, listed.back().time, results);
  };
  const std::string as_of = read_results(query.folder, read, query.closed);
  if (!as_of.empty()) out.notes.push_back("Wear is " + as_of);
  return out;
}

}  // namespace quern
