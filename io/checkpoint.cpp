// Writing and reading are two visitors of the same enumeration; see checkpoint.h for the layout.
#include "io/checkpoint.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <vector>

#include "io/file_commit.h"
#include "io/hdf5_file.h"
#include "io/seal.h"

namespace quern {
namespace {

constexpr const char* kWhat = "checkpoint";
const std::string kState = "state";  // NOLINT(cert-err58-cpp): a short string cannot throw
const std::string kSceneText = "header/scene_text";

// Words of 8 bytes, each mixed in by an odd multiplication and a shift; the tail padded with zeros.
std::uint64_t hash_bytes(const void* data, std::size_t bytes) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15u;
  std::uint64_t hash = kOdd ^ bytes;
  for (std::size_t i = 0; i < bytes; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, static_cast<const char*>(data) + i, std::min<std::size_t>(8, bytes - i));
    hash = (hash ^ word) * kOdd;
    hash ^= hash >> 32;
  }
  return hash;
}

// Records that are no plain number are rows of bytes.
std::size_t row_components(ElementType type, std::size_t bytes, std::size_t components) {
  return type == ElementType::kU8 ? components * bytes : components;
}

class Writer final : public StateVisitor {
 public:
  explicit Writer(Hdf5File& file) : file_(file) {}

  void column(const char* name, const char* unit, ColumnBase& column,
              std::size_t components) override {
    QUERN_CHECK(components > 0 && column.size() % components == 0);
    const ArrayLayout layout = {column.type(), column.size() / components,
                                row_components(column.type(), column.element_bytes(), components)};
    put(name, unit, layout, column.raw());
  }

  void values(const char* name, const char* unit, ElementType type, void* data,
              std::size_t count) override {
    put(name, unit, {type, count, 1}, data);
  }

 private:
  void put(const char* name, const char* unit, const ArrayLayout& layout, const void* data) {
    const std::string path = kState + "/" + name;
    if (file_.exists(path)) throw InvariantError("state named twice: " + path);
    file_.write(path, layout, data);
    file_.set_attribute(path, "unit", unit);
    file_.set_attribute(path, "hash", hash_bytes(data, layout.bytes()));
  }

  Hdf5File& file_;
};

void check_hash(const Hdf5File& file, const std::string& path, const void* data,
                std::size_t bytes) {
  if (file.u64_attribute(path, "hash") != hash_bytes(data, bytes)) {
    file.fail("read dataset '" + path + "'", "its contents are damaged (wrong hash)");
  }
}

class Reader final : public StateVisitor {
 public:
  explicit Reader(const Hdf5File& file) : file_(file) {}

  void column(const char* name, const char*, ColumnBase& column, std::size_t components) override {
    const std::string path = path_of(name);
    const ArrayLayout layout = {column.type(), file_.layout(path).rows,
                                row_components(column.type(), column.element_bytes(), components)};
    if (file_.layout(path) == layout) column.reset(layout.rows * components);
    get(path, layout, column.raw());
  }

  void values(const char* name, const char*, ElementType type, void* data,
              std::size_t count) override {
    get(path_of(name), {type, count, 1}, data);
  }

  void later_values(const char* name, const char* unit, ElementType type, void* data,
                    std::size_t count) override {
    if (file_.exists(kState + "/" + name)) values(name, unit, type, data, count);
  }

  void later_column(const char* name, const char* unit, ColumnBase& all,
                    std::size_t components) override {
    if (file_.exists(kState + "/" + name)) column(name, unit, all, components);
  }

  // Everything in the file must have been asked for.
  void finish() const {
    for (const std::string& name : file_.datasets(kState)) {
      if (!seen_.contains(kState + "/" + name)) {
        file_.fail("read dataset '" + kState + "/" + name + "'",
                   "this scene has no such state: the checkpoint is of another scene or version");
      }
    }
  }

 private:
  std::string path_of(const char* name) const {
    const std::string path = kState + "/" + name;
    if (!file_.exists(path)) {
      file_.fail("read dataset '" + path + "'",
                 "missing: the checkpoint is of another scene or version");
    }
    return path;
  }
  void get(const std::string& path, const ArrayLayout& layout, void* data) {
    seen_.insert(path);
    if (const ArrayLayout found = file_.layout(path); !(found == layout)) {
      file_.fail("read dataset '" + path + "'",
                 fmt::format("holds {}, expected {}: the checkpoint is of another scene or version",
                             describe(found), describe(layout)));
    }
    file_.read(path, layout, data);
    check_hash(file_, path, data, layout.bytes());
  }

  const Hdf5File& file_;
  std::set<std::string> seen_;
};

void write_header(Hdf5File& file, const CheckpointHeader& header) {
  file.set_attribute("/", "format", kCheckpointFormat);
  file.set_attribute("/", "scene_name", header.scene_name);
  file.set_attribute("/", "simd_target", header.simd_target);
  file.set_attribute("/", "precision", header.precision);
  file.set_attribute("/", "version", header.version);
  file.set_attribute("/", "time", header.time);
  file.set_attribute("/", "step", header.step);
  file.write_text(kSceneText, header.scene_text);
  file.set_attribute(kSceneText, "hash",
                     hash_bytes(header.scene_text.data(), header.scene_text.size()));
}

Hdf5File open_sealed(const std::string& path) {
  check_seal(kWhat, path);
  return Hdf5File(kWhat, path, FileMode::kRead);
}

CheckpointHeader read_header(const Hdf5File& file) {
  const std::uint64_t format = file.u64_attribute("/", "format");
  if (format != kCheckpointFormat) {
    file.fail("read header", fmt::format("it has format {}, this program reads format {}", format,
                                         kCheckpointFormat));
  }
  CheckpointHeader header;
  header.scene_name = file.text_attribute("/", "scene_name");
  header.simd_target = file.text_attribute("/", "simd_target");
  header.precision = file.text_attribute("/", "precision");
  header.version = file.text_attribute("/", "version");
  header.time = file.f64_attribute("/", "time");
  header.step = file.u64_attribute("/", "step");
  header.scene_text = file.read_text(kSceneText);
  check_hash(file, kSceneText, header.scene_text.data(), header.scene_text.size());
  return header;
}

std::string current_path(const std::string& folder) { return folder + "/checkpoint.h5"; }
std::string previous_path(const std::string& folder) { return folder + "/checkpoint.previous.h5"; }

// Empty if the checkpoint verifies.
std::string complaint(const std::string& path) {
  try {
    verify_checkpoint(path);
    return {};
  } catch (const SystemError& error) {
    return error.what();
  }
}

}  // namespace

void write_checkpoint(const std::string& folder, const CheckpointHeader& header,
                      const VisitState& visit_state) {
  make_folder(kWhat, folder);
  PendingFile pending(kWhat, current_path(folder));
  Hdf5File file(kWhat, pending.temporary(), FileMode::kCreate);
  write_header(file, header);
  file.make_group(kState);
  Writer writer(file);
  visit_state(writer);
  file.close();
  seal_file(kWhat, pending.temporary());
  pending.commit(Durability::kPowerCut, previous_path(folder));
}

CheckpointHeader read_checkpoint_header(const std::string& path) {
  return read_header(open_sealed(path));
}

void read_checkpoint(const std::string& path, const VisitState& visit_state) {
  const Hdf5File file = open_sealed(path);
  read_header(file);
  Reader reader(file);
  visit_state(reader);
  reader.finish();
}

void verify_checkpoint(const std::string& path) {
  const Hdf5File file = open_sealed(path);
  read_header(file);
  std::vector<std::byte> data;
  for (const std::string& name : file.datasets(kState)) {
    const std::string dataset = kState + "/" + name;
    const ArrayLayout layout = file.layout(dataset);
    data.resize(layout.bytes());
    file.read(dataset, layout, data.data());
    check_hash(file, dataset, data.data(), data.size());
  }
}

bool has_checkpoint(const std::string& folder) {
  return std::filesystem::exists(current_path(folder)) ||
         std::filesystem::exists(previous_path(folder));
}

std::string usable_checkpoint(const std::string& folder, std::string* warning) {
  if (warning != nullptr) warning->clear();
  const std::string current = current_path(folder), previous = previous_path(folder);
  const std::string first = complaint(current);
  if (first.empty()) return current;
  const std::string second = complaint(previous);
  if (!second.empty()) {
    throw SystemError(fmt::format("no usable checkpoint in '{}': {}; {}", folder, first, second));
  }
  if (warning != nullptr) {
    *warning = fmt::format("using the previous checkpoint '{}', because: {}", previous, first);
  }
  return previous;
}

}  // namespace quern
