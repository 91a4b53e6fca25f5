// VTKHDF 1.0 by the letter of its specification; the arrays come from soa/output.h as they are.
#include "io/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <span>

#include "io/file_commit.h"
#include "io/hdf5_file.h"

namespace quern {
namespace {

constexpr const char* kWhat = "frame";
constexpr std::uint8_t kVtkVertex = 1, kVtkTriangle = 5;

class VtkFile {
 public:
  VtkFile(const std::string& path, double time)
      : pending_(kWhat, path), file_(kWhat, pending_.temporary(), FileMode::kCreate) {
    file_.make_group("VTKHDF");
    const std::array<std::int64_t, 2> version = {1, 0};
    file_.set_attribute("VTKHDF", "Version", version);
    file_.set_attribute("VTKHDF", "Type", "UnstructuredGrid");
    file_.set_attribute("/", "time", time);
    file_.set_attribute("/", "time_unit", "s");
  }

  // A dataset for the viewer: below VTKHDF.
  template <class Values>
  void array(const std::string& name, const Values& values, const char* unit,
             std::size_t components = 1) {
    state("VTKHDF/" + name, values, unit, components);
  }

  // A dataset for scripts, anywhere.
  template <class Values>
  void state(const std::string& path, const Values& values, const char* unit,
             std::size_t components = 1) {
    QUERN_CHECK(values.size() % components == 0);
    file_.write(
        path,
        {element_type_of<typename Values::value_type>(), values.size() / components, components},
        values.data());
    file_.set_attribute(path, "unit", unit);
  }

  // A cell for each of so many points.
  void vertices(std::size_t points) {
    std::vector<std::int64_t> all(points);
    std::iota(all.begin(), all.end(), 0);
    cells(kVtkVertex, points, all, 1);
  }

  // Cells of `corners` points each.
  void cells(std::uint8_t type, std::size_t points, const std::vector<std::int64_t>& connectivity,
             std::int64_t corners) {
    const std::size_t count = connectivity.size() / static_cast<std::size_t>(corners);
    std::vector<std::int64_t> offsets(count + 1);
    for (std::size_t i = 0; i <= count; ++i) offsets[i] = static_cast<std::int64_t>(i) * corners;
    array("NumberOfPoints", std::vector<std::int64_t>{static_cast<std::int64_t>(points)}, "1");
    array("NumberOfCells", std::vector<std::int64_t>{static_cast<std::int64_t>(count)}, "1");
    array("NumberOfConnectivityIds",
          std::vector<std::int64_t>{static_cast<std::int64_t>(connectivity.size())}, "1");
    array("Types", std::vector<std::uint8_t>(count, type), "1");
    array("Offsets", offsets, "1");
    array("Connectivity", connectivity, "1");
  }

  void finish() {
    file_.close();
    pending_.commit(Durability::kKill);
  }

 private:
  PendingFile pending_;
  Hdf5File file_;
};

std::vector<float> lengths(std::span<const float> vectors) {
  std::vector<float> result(vectors.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::hypot(vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]);
  }
  return result;
}

template <class T>
using Rows = std::span<const T>;

// The first `count` rows of an array with `components` numbers a row, and the rows behind them.
template <class T>
Rows<T> first_rows(const std::vector<T>& values, std::size_t count, std::size_t components = 1) {
  return Rows<T>(values).first(count * components);
}
template <class T>
Rows<T> rows_from(const std::vector<T>& values, std::size_t first, std::size_t components = 1) {
  return Rows<T>(values).subspan(first * components);
}

void check_sizes(const ParticleFrame& frame) {
  const std::size_t n = frame.id.size();
  QUERN_CHECK(frame.spheres <= n && frame.position.size() == 3 * n &&
              frame.velocity.size() == 3 * n && frame.spin.size() == 3 * n &&
              frame.radius.size() == n && frame.species.size() == n &&
              frame.size_class.size() == n && frame.contacts.size() == n);
}

void write_particles(const std::string& path, const ParticleFrame& frame) {
  const std::size_t n = frame.spheres;
  VtkFile file(path, frame.time);
  file.array("Points", first_rows(frame.position, n, 3), "m", 3);
  file.vertices(n);
  file.array("PointData/radius", first_rows(frame.radius, n), "m");
  file.array("PointData/velocity", first_rows(frame.velocity, n, 3), "m/s", 3);
  file.array("PointData/speed", lengths(first_rows(frame.velocity, n, 3)), "m/s");
  file.array("PointData/spin", first_rows(frame.spin, n, 3), "rad/s", 3);
  file.array("PointData/id", first_rows(frame.id, n), "1");
  file.array("PointData/species", first_rows(frame.species, n), "1");
  file.array("PointData/class", first_rows(frame.size_class, n), "1");
  file.array("PointData/contacts", first_rows(frame.contacts, n), "1");
  file.finish();
}

// One value a triangle from one value a body.
template <class Values>
auto of_triangles(const Values& values, const std::vector<std::uint32_t>& body) {
  std::vector<typename Values::value_type> result;
  result.reserve(body.size());
  for (const std::uint32_t k : body) result.push_back(values[k]);
  return result;
}

void write_polyhedra(const std::string& path, const ParticleFrame& all,
                     const PolyhedronFrame& frame) {
  const std::size_t n = frame.shape.size(), k = frame.body.size(), first = all.spheres;
  QUERN_CHECK(all.id.size() == first + n && frame.orientation.size() == 4 * n &&
              frame.triangle.size() == 3 * k);
  const Rows<float> velocity = rows_from(all.velocity, first, 3);
  const Rows<float> spin = rows_from(all.spin, first, 3);
  VtkFile file(path, all.time);
  const std::vector<std::int64_t> corners(frame.triangle.begin(), frame.triangle.end());
  file.array("Points", frame.vertex, "m", 3);
  file.cells(kVtkTriangle, frame.vertex.size() / 3, corners, 3);
  file.array("CellData/id", of_triangles(rows_from(all.id, first), frame.body), "1");
  file.array("CellData/species", of_triangles(rows_from(all.species, first), frame.body), "1");
  file.array("CellData/class", of_triangles(rows_from(all.size_class, first), frame.body), "1");
  file.array("CellData/contacts", of_triangles(rows_from(all.contacts, first), frame.body), "1");
  file.array("CellData/speed", of_triangles(lengths(velocity), frame.body), "m/s");
  file.array("CellData/spin_magnitude", of_triangles(lengths(spin), frame.body), "rad/s");

  file.state("polyhedra/id", rows_from(all.id, first), "1");
  file.state("polyhedra/species", rows_from(all.species, first), "1");
  file.state("polyhedra/class", rows_from(all.size_class, first), "1");
  file.state("polyhedra/shape", frame.shape, "1");
  file.state("polyhedra/equivalent_radius", rows_from(all.radius, first), "m");
  file.state("polyhedra/position", rows_from(all.position, first, 3), "m", 3);
  file.state("polyhedra/orientation", frame.orientation, "1", 4);
  file.state("polyhedra/velocity", velocity, "m/s", 3);
  file.state("polyhedra/spin", spin, "rad/s", 3);
  file.state("polyhedra/contacts", rows_from(all.contacts, first), "1");
  file.finish();
}

void write_liner(const std::string& path, const WallFrame& frame, double time) {
  const std::size_t k = frame.wall.size();
  QUERN_CHECK(frame.triangle.size() == 3 * k && frame.speed.size() == k);
  VtkFile file(path, time);
  const std::vector<std::int64_t> corners(frame.triangle.begin(), frame.triangle.end());
  file.array("Points", frame.vertex, "m", 3);
  file.cells(kVtkTriangle, frame.vertex.size() / 3, corners, 3);
  file.array("CellData/wall", frame.wall, "1");
  file.array("CellData/speed", frame.speed, "m/s");
  for (const WallFrame::Field& field : frame.fields) {
    QUERN_CHECK(field.value.size() == k);
    file.array("CellData/" + field.name, field.value, field.unit.c_str());
  }
  file.finish();
}

void write_contacts(const std::string& path, const ContactFrame& frame, double time) {
  const std::size_t n = frame.first.size();
  QUERN_CHECK(frame.point.size() == 3 * n && frame.force.size() == 3 * n &&
              frame.normal.size() == 3 * n && frame.overlap.size() == n &&
              frame.normal_force.size() == n && frame.tangential_force.size() == n &&
              frame.second.size() == n && frame.wall.size() == n && frame.kind.size() == n);
  VtkFile file(path, time);
  file.array("Points", frame.point, "m", 3);
  file.vertices(n);
  file.array("PointData/force", frame.force, "N", 3);
  file.array("PointData/normal", frame.normal, "1", 3);
  file.array("PointData/overlap", frame.overlap, "m");
  file.array("PointData/normal_force", frame.normal_force, "N");
  file.array("PointData/tangential_force", frame.tangential_force, "N");
  file.array("PointData/first", frame.first, "1");
  file.array("PointData/second", frame.second, "1");
  file.array("PointData/wall", frame.wall, "1");
  file.array("PointData/kind", frame.kind, "1");
  file.finish();
}

// Value after `key` in one line of a series file as this file writes it.
template <class T>
bool parse_after(std::string_view line, std::string_view key, T& value) {
  const std::size_t at = line.find(key);
  if (at == std::string_view::npos) return false;
  const char* const begin = line.data() + at + key.size();
  return std::from_chars(begin, line.data() + line.size(), value).ec == std::errc();
}

}  // namespace

std::string frame_path(const std::string& folder, const std::string& name, int number) {
  return fmt::format("{}/{}_{:06}.hdf", folder, name, number);
}

std::vector<FrameEntry> read_frame_list(const std::string& folder, const std::string& name) {
  const std::string path = fmt::format("{}/{}.hdf.series", folder, name);
  std::vector<FrameEntry> entries;
  if (!std::filesystem::exists(path)) return entries;
  const std::string text = read_text_file("frame series", path);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line(text.data() + begin, end - begin);
    begin = end + 1;
    if (line.find(".hdf") == std::string_view::npos) continue;
    FrameEntry entry;
    if (!parse_after(line, name + "_", entry.number) ||
        !parse_after(line, "\"time\": ", entry.time)) {
      throw SystemError(fmt::format("cannot read frame series '{}': line '{}'", path, line));
    }
    entries.push_back(entry);
  }
  return entries;
}

FrameWriter::FrameWriter(std::string folder) : folder_(std::move(folder)) {
  make_folder(kWhat, folder_);
  for (FileSeries* series : {&particles_, &polyhedra_, &liner_, &contacts_}) {
    series->entries = read_frame_list(folder_, series->name);
  }
}

// The list first: a kill in between leaves files that nothing names, not names without files.
void FrameWriter::drop_from(FileSeries& series, int number) const {
  const auto first = std::find_if(series.entries.begin(), series.entries.end(),
                                  [&](const FrameEntry& entry) { return entry.number >= number; });
  const std::vector<FrameEntry> dropped(first, series.entries.end());
  if (dropped.empty()) return;
  series.entries.erase(first, series.entries.end());
  list(series);
  for (const FrameEntry& entry : dropped) {
    std::error_code ignored;  // it may be gone already
    std::filesystem::remove(frame_path(folder_, series.name, entry.number), ignored);
  }
}

void FrameWriter::list(const FileSeries& series) const {
  std::string text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n";
  for (const FrameEntry& entry : series.entries) {
    text += fmt::format("    {{\"name\": \"{}_{:06}.hdf\", \"time\": {}}}{}\n", series.name,
                        entry.number, entry.time, &entry == &series.entries.back() ? "" : ",");
  }
  text += "  ]\n}\n";
  write_text_file("frame series", fmt::format("{}/{}.hdf.series", folder_, series.name), text,
                  Durability::kKill);
}

void FrameWriter::write(int number, const ParticleFrame& particles, const WallFrame& walls,
                        const std::optional<PolyhedronFrame>& polyhedra,
                        const std::optional<ContactFrame>& contacts) {
  QUERN_CHECK(number >= 0);
  check_sizes(particles);
  for (FileSeries* series : {&particles_, &polyhedra_, &liner_, &contacts_}) {
    drop_from(*series, number);
  }
  const auto add = [&](FileSeries& series) {
    series.entries.push_back({number, particles.time});
    list(series);
  };
  write_particles(frame_path(folder_, particles_.name, number), particles);
  add(particles_);
  if (polyhedra) {
    write_polyhedra(frame_path(folder_, polyhedra_.name, number), particles, *polyhedra);
    add(polyhedra_);
  }
  if (contacts) {
    write_contacts(frame_path(folder_, contacts_.name, number), *contacts, particles.time);
    add(contacts_);
  }
  if (walls.wall.empty()) return;
  write_liner(frame_path(folder_, liner_.name, number), walls, particles.time);
  add(liner_);
}

void write_surface(const std::string& path, const SurfaceFrame& frame) {
  QUERN_CHECK(frame.triangle.size() == 3 * frame.face.size());
  VtkFile file(path, 0);
  const std::vector<std::int64_t> corners(frame.triangle.begin(), frame.triangle.end());
  file.array("Points", frame.vertex, "1", 3);
  file.cells(kVtkTriangle, frame.vertex.size() / 3, corners, 3);
  file.array("CellData/face", frame.face, "1");
  file.finish();
}

}  // namespace quern
