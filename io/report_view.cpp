#include "io/report_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>

#include "io/frames.h"
#include "io/hdf5_file.h"
#include "io/packed.h"
#include "io/report_walls.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

constexpr std::uint16_t kSphere = 0xffff;
constexpr std::size_t kSphereBytes = 8, kPolyhedronBytes = 16;  // of a frame
constexpr double kPackedShare = 1.2;  // base64 adds a third, gzip takes a tenth

template <class T>
std::vector<T> read_column(const Hdf5File& file, const std::string& name,
                           std::size_t components = 1) {
  const ArrayLayout found = file.layout(name);
  if (found.components != components || found.type != element_type_of<T>()) {
    file.fail("read dataset '" + name + "'", "holds " + describe(found));
  }
  std::vector<T> values(found.rows * components);
  file.read(name, found, values.data());
  return values;
}

// One moment as the files have it: the spheres, then the polyhedra.
struct Rows {
  std::vector<std::uint32_t> id;
  std::vector<double> position;
  std::vector<float> radius, speed, spin;
  std::vector<std::uint16_t> species, size_class, shape;
  std::vector<double> orientation;  // of the polyhedra
  std::size_t spheres = 0;
};

std::vector<float> lengths(const std::vector<float>& vectors) {
  std::vector<float> result(vectors.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::hypot(vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]);
  }
  return result;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& values) {
  to.insert(to.end(), values.begin(), values.end());
}

void read_polyhedra(const std::string& path, Rows& rows) {
  const Hdf5File file("frame", path, FileMode::kRead);
  append(rows.id, read_column<std::uint32_t>(file, "polyhedra/id"));
  append(rows.position, read_column<double>(file, "polyhedra/position", 3));
  append(rows.radius, read_column<float>(file, "polyhedra/equivalent_radius"));
  append(rows.species, read_column<std::uint16_t>(file, "polyhedra/species"));
  append(rows.size_class, read_column<std::uint16_t>(file, "polyhedra/class"));
  append(rows.speed, lengths(read_column<float>(file, "polyhedra/velocity", 3)));
  append(rows.spin, lengths(read_column<float>(file, "polyhedra/spin", 3)));
  rows.orientation = read_column<double>(file, "polyhedra/orientation", 4);
  for (const std::uint32_t shape : read_column<std::uint32_t>(file, "polyhedra/shape")) {
    rows.shape.push_back(static_cast<std::uint16_t>(shape));
  }
}

Rows read_rows(const std::string& frames, int number) {
  Rows rows;
  const Hdf5File file("frame", frame_path(frames, "particles", number), FileMode::kRead);
  rows.id = read_column<std::uint32_t>(file, "VTKHDF/PointData/id");
  rows.position = read_column<double>(file, "VTKHDF/Points", 3);
  rows.radius = read_column<float>(file, "VTKHDF/PointData/radius");
  rows.speed = read_column<float>(file, "VTKHDF/PointData/speed");
  rows.spin = lengths(read_column<float>(file, "VTKHDF/PointData/spin", 3));
  rows.species = read_column<std::uint16_t>(file, "VTKHDF/PointData/species");
  rows.size_class = read_column<std::uint16_t>(file, "VTKHDF/PointData/class");
  rows.spheres = rows.id.size();
  rows.shape.assign(rows.spheres, kSphere);
  const std::string bodies = frame_path(frames, "polyhedra", number);
  if (fs::exists(bodies)) read_polyhedra(bodies, rows);
  return rows;
}

// A shape in its body frame over the equivalent radius, from a body that has it: the frames of a
// run that was killed tell it, run.h5 only at the end.
std::string shape_json(const std::string& path, const Rows& rows, std::uint16_t shape) {
  const auto at = std::find(rows.shape.begin(), rows.shape.end(), shape);
  const auto row = static_cast<std::size_t>(at - rows.shape.begin());
  const double* q = rows.orientation.data() + 4 * (row - rows.spheres);
  const Quat turn(q[0], q[1], q[2], q[3]);
  const Vec3 centre(rows.position.data() + 3 * row);
  const Hdf5File file("frame", path, FileMode::kRead);
  const auto ids = read_column<std::uint32_t>(file, "VTKHDF/CellData/id");
  const auto corners = read_column<std::int64_t>(file, "VTKHDF/Connectivity");
  const auto points = read_column<float>(file, "VTKHDF/Points", 3);
  std::string json;
  for (std::size_t t = 0; t < ids.size(); ++t) {
    if (ids[t] != rows.id[row]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const float* p = points.data() + 3 * corners[3 * t + k];
      const Vec3 x = turn.conjugate() * (Vec3(p[0], p[1], p[2]) - centre) / rows.radius[row];
      json += fmt::format("{}{:.5g},{:.5g},{:.5g}", json.empty() ? "" : ",", x[0], x[1], x[2]);
    }
  }
  return "[" + json + "]";
}

// What is shown, in the order of the page: spheres first, then shape by shape.
struct Cast {
  std::vector<std::uint32_t> id;
  std::vector<std::size_t> place_of_id;  // SIZE_MAX: not shown
  std::size_t spheres = 0;
};

Cast make_cast(const Rows& rows, std::vector<std::size_t> shown) {
  std::stable_sort(shown.begin(), shown.end(), [&](std::size_t a, std::size_t b) {
    const int shape_a = rows.shape[a] == kSphere ? -1 : rows.shape[a];
    const int shape_b = rows.shape[b] == kSphere ? -1 : rows.shape[b];
    return shape_a < shape_b;
  });
  Cast cast;
  const std::uint32_t most = *std::max_element(rows.id.begin(), rows.id.end());
  cast.place_of_id.assign(std::size_t{most} + 1, SIZE_MAX);
  for (const std::size_t row : shown) {
    cast.place_of_id[rows.id[row]] = cast.id.size();
    cast.id.push_back(rows.id[row]);
    if (rows.shape[row] == kSphere) ++cast.spheres;
  }
  return cast;
}

std::size_t place_of(const Cast& cast, std::uint32_t id) {
  return id < cast.place_of_id.size() ? cast.place_of_id[id] : SIZE_MAX;
}

// One moment of the cast; who is not there has a speed of NaN.
struct Moment {
  double time = 0;
  std::vector<float> position, speed, spin, orientation;
};

Moment moment_of(const Rows& rows, const Cast& cast, double time) {
  const std::size_t n = cast.id.size();
  Moment m;
  m.time = time;
  m.position.assign(3 * n, 0);
  m.speed.assign(n, std::numeric_limits<float>::quiet_NaN());
  m.spin.assign(n, 0);
  m.orientation.assign(4 * (n - cast.spheres), 0);
  for (std::size_t row = 0; row < rows.id.size(); ++row) {
    const std::size_t at = place_of(cast, rows.id[row]);
    if (at == SIZE_MAX) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      m.position[3 * at + k] = static_cast<float>(rows.position[3 * row + k]);
    }
    m.speed[at] = rows.speed[row];
    m.spin[at] = rows.spin[row];
    if (at < cast.spheres || row < rows.spheres) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      m.orientation[4 * (at - cast.spheres) + k] =
          static_cast<float>(rows.orientation[4 * (row - rows.spheres) + k]);
    }
  }
  return m;
}

struct Scale {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low;
  double speed = 0, spin = 0;  // the largest
};

Scale scale_of(const std::vector<Moment>& moments) {
  Scale scale;
  for (const Moment& m : moments) {
    for (std::size_t i = 0; i < m.speed.size(); ++i) {
      if (std::isnan(m.speed[i])) continue;
      for (int k = 0; k < 3; ++k) {
        const double x = m.position[3 * i + static_cast<std::size_t>(k)];
        scale.low[k] = std::min(scale.low[k], x);
        scale.high[k] = std::max(scale.high[k], x);
      }
      scale.speed = std::max<double>(scale.speed, m.speed[i]);
      scale.spin = std::max<double>(scale.spin, m.spin[i]);
    }
  }
  return scale;
}

// High bytes, then low bytes: what changes little lies together and packs better.
template <class Value>
void put_plane(std::size_t count, Value value, std::vector<std::uint8_t>& out) {
  const std::size_t at = out.size();
  out.resize(at + 2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto q = static_cast<std::uint32_t>(std::lround(std::clamp<double>(value(i), 0, 65535)));
    out[at + i] = static_cast<std::uint8_t>(q >> 8);
    out[at + count + i] = static_cast<std::uint8_t>(q);
  }
}

std::uint8_t root_scaled(double value, double most) {
  return most > 0 ? static_cast<std::uint8_t>(std::lround(254 * std::sqrt(value / most))) : 0;
}

std::string pack_moment(const Moment& m, const Scale& scale) {
  const std::size_t n = m.speed.size(), bodies = m.orientation.size() / 4;
  std::vector<std::uint8_t> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = scale.low[static_cast<Eigen::Index>(k)];
    const double span = std::max(scale.high[static_cast<Eigen::Index>(k)] - low, 1e-30);
    put_plane(
        n, [&](std::size_t i) { return 65535 * (m.position[3 * i + k] - low) / span; }, out);
  }
  for (const float v : m.speed) out.push_back(std::isnan(v) ? 255 : root_scaled(v, scale.speed));
  for (const float v : m.spin) out.push_back(root_scaled(v, scale.spin));
  for (std::size_t k = 0; k < 4; ++k) {
    put_plane(
        bodies, [&](std::size_t i) { return 32767 + 32767 * m.orientation[4 * i + k]; }, out);
  }
  return packed(out);
}

template <class T>
void put_raw(const std::vector<T>& values, std::vector<std::uint8_t>& out) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
  out.insert(out.end(), bytes, bytes + values.size() * sizeof(T));
}

std::string pack_statics(const Rows& rows, const Cast& cast) {
  const std::size_t n = cast.id.size();
  std::vector<float> radius(n);
  std::vector<std::uint16_t> species(n), size_class(n), shape(n);
  for (std::size_t row = 0; row < rows.id.size(); ++row) {
    const std::size_t at = place_of(cast, rows.id[row]);
    if (at == SIZE_MAX) continue;
    radius[at] = rows.radius[row];
    species[at] = rows.species[row];
    size_class[at] = rows.size_class[row];
    shape[at] = rows.shape[row];
  }
  std::vector<std::uint8_t> out;
  put_raw(cast.id, out);
  put_raw(radius, out);
  put_raw(species, out);
  put_raw(size_class, out);
  put_raw(shape, out);
  return packed(out);
}

// How many particles and frames the budget has room for.
struct Choice {
  std::size_t particles = 0, frames = 0;
};

Choice choose(const Rows& rows, std::size_t frames, const ViewBudget& budget) {
  const std::size_t all = rows.id.size(), bodies = all - rows.spheres;
  const double each = kPackedShare *
                      static_cast<double>(kSphereBytes * rows.spheres + kPolyhedronBytes * bodies) /
                      static_cast<double>(all);
  const auto room = static_cast<std::size_t>(static_cast<double>(budget.bytes) / each);
  Choice c;
  c.particles = std::min({all, budget.most_particles,
                          std::max<std::size_t>(1, room / std::min(frames, budget.wanted_frames))});
  c.frames = std::min({frames, budget.most_frames, std::max<std::size_t>(2, room / c.particles)});
  return c;
}

std::string sampled_note(const Rows& rows, const Choice& choice, std::size_t frames) {
  const std::size_t all = rows.id.size();
  std::string note;
  if (choice.particles < all) {
    note =
        fmt::format("Shown are {} of {} particles: the {} largest and an even sample of the rest",
                    choice.particles, all, (choice.particles + 1) / 2);
  }
  if (choice.frames < frames) {
    note += fmt::format("{} {} of {} frames", note.empty() ? "Shown are" : ", in", choice.frames,
                        frames);
  }
  return note.empty() ? note
                      : note + ", so that this page stays small. Plots and tables are of all.";
}

std::string shapes_json(const std::string& frames, int number, const Rows& rows) {
  std::vector<std::uint16_t> shapes(rows.shape.begin() + static_cast<std::ptrdiff_t>(rows.spheres),
                                    rows.shape.end());
  std::sort(shapes.begin(), shapes.end());
  shapes.erase(std::unique(shapes.begin(), shapes.end()), shapes.end());
  std::string json;
  for (const std::uint16_t shape : shapes) {
    json += fmt::format("{}\"{}\":{}", json.empty() ? "" : ",", shape,
                        shape_json(frame_path(frames, "polyhedra", number), rows, shape));
  }
  return "{" + json + "}";
}

std::uint32_t hashed(std::uint32_t x) {  // a permutation of 32 bits (Mueller's)
  x = (x >> 16 ^ x) * 0x45d9f3bu;
  x = (x >> 16 ^ x) * 0x45d9f3bu;
  return x >> 16 ^ x;
}

std::string vector_json(const Vec3& v) {
  return fmt::format("[{:.9g},{:.9g},{:.9g}]", v[0], v[1], v[2]);
}

}  // namespace

std::vector<std::size_t> choose_particles(const std::vector<float>& radii,
                                          const std::vector<std::uint32_t>& ids,
                                          std::size_t places) {
  std::vector<std::size_t> rows(radii.size());
  std::iota(rows.begin(), rows.end(), 0);
  if (places >= rows.size()) return rows;
  const auto middle = rows.begin() + static_cast<std::ptrdiff_t>((places + 1) / 2);
  const auto end = rows.begin() + static_cast<std::ptrdiff_t>(places);
  std::nth_element(rows.begin(), middle, rows.end(), [&](std::size_t a, std::size_t b) {
    return radii[a] != radii[b] ? radii[a] > radii[b] : hashed(ids[a]) < hashed(ids[b]);
  });
  std::nth_element(middle, end, rows.end(),
                   [&](std::size_t a, std::size_t b) { return hashed(ids[a]) < hashed(ids[b]); });
  rows.erase(end, rows.end());
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<std::size_t> choose_evenly(std::size_t count, std::size_t places) {
  std::vector<std::size_t> chosen;
  if (count == 0 || places == 0) return chosen;
  places = std::min(places, count);
  for (std::size_t k = 0; k < places; ++k) {
    chosen.push_back(places == 1 ? count - 1 : (k * (count - 1) + (places - 1) / 2) / (places - 1));
  }
  return chosen;
}

RunView read_run_view(const std::string& folder, const Scene& scene, const ViewBudget& budget,
                      std::size_t first_blob, bool closed) {
  RunView view;
  view.json = "null";
  const std::string frames = (fs::path(folder) / "frames").string();
  const std::vector<FrameEntry> listed = read_frame_list(frames, "particles");
  if (listed.empty()) return view;
  const Rows last = read_rows(frames, listed.back().number);
  if (last.id.empty()) return view;
  const Choice choice = choose(last, listed.size(), budget);
  const Cast cast = make_cast(last, choose_particles(last.radius, last.id, choice.particles));
  std::vector<Moment> moments;
  for (const std::size_t k : choose_evenly(listed.size(), choice.frames)) {
    moments.push_back(moment_of(read_rows(frames, listed[k].number), cast, listed[k].time));
  }
  const Scale scale = scale_of(moments);
  std::string times;
  std::vector<double> time;
  view.packed.push_back(pack_statics(last, cast));
  for (const Moment& m : moments) {
    view.packed.push_back(pack_moment(m, scale));
    times += fmt::format("{}{:.7g}", times.empty() ? "" : ",", m.time);
    time.push_back(m.time);
  }
  const WallsOfView walls =
      read_walls({folder, frames, time, first_blob + view.packed.size(), closed}, scene);
  for (const std::string& blob : walls.packed) view.packed.push_back(blob);
  for (const std::string& note : walls.notes) view.notes.push_back(note);
  const std::string note = sampled_note(last, choice, listed.size());
  if (!note.empty()) view.notes.push_back(note);
  view.json = fmt::format(
      "{{\"particles\":{},\"all_particles\":{},\"spheres\":{},\"all_frames\":{},\"low\":{},"
      "\"high\":{},\"speed\":{:.6g},\"spin\":{:.6g},\"statics\":{},\"frames\":{},\"times\":[{}],"
      "\"shapes\":{},\"walls\":{},\"note\":{}}}",
      cast.id.size(), last.id.size(), cast.spheres, listed.size(), vector_json(scale.low),
      vector_json(scale.high), scale.speed, scale.spin, first_blob, first_blob + 1, times,
      shapes_json(frames, listed.back().number, last), walls.json, json_string(note));
  return view;
}

}  // namespace quern
