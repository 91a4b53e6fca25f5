#include "io/report_tables.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <thread>

#include "io/hdf5_file.h"
#include "io/packed.h"
#include "io/summary.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRows = 20000;     // of a series
constexpr std::size_t kMostValues = 400000;  // of any other array

bool starts_with_any(std::string_view name, std::span<const std::string_view> starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](std::string_view start) { return name.starts_with(start); });
}

bool is_shown(std::string_view name) {
  constexpr std::array<std::string_view, 6> kLeftOut = {
      "charge_snapshots/", "final_particles/", "final_polyhedra/",
      "shapes/",           "sum_blocks/",      "wear/"};
  if (starts_with_any(name, kLeftOut)) return false;
  return !(name.starts_with("series/walls/") &&
           (name.find("/force_") != std::string_view::npos || name.ends_with("/torque_x") ||
            name.ends_with("/torque_y")));
}

template <class T>
std::vector<double> read_as(const Hdf5File& file, const std::string& name,
                            const ArrayLayout& layout) {
  std::vector<T> raw(layout.rows * layout.components);
  file.read(name, layout, raw.data());
  return {raw.begin(), raw.end()};
}

std::vector<double> read_values(const Hdf5File& file, const std::string& name,
                                const ArrayLayout& layout) {
  switch (layout.type) {
    case ElementType::kF64:
      return read_as<double>(file, name, layout);
    case ElementType::kF32:
      return read_as<float>(file, name, layout);
    case ElementType::kU64:
      return read_as<std::uint64_t>(file, name, layout);
    case ElementType::kU32:
      return read_as<std::uint32_t>(file, name, layout);
    case ElementType::kU16:
      return read_as<std::uint16_t>(file, name, layout);
    case ElementType::kU8:
      return read_as<std::uint8_t>(file, name, layout);
    default:
      return read_as<std::int64_t>(file, name, layout);
  }
}

std::string attribute(const Hdf5File& file, const std::string& name, const char* key) {
  return file.has_attribute(name, key) ? file.text_attribute(name, key) : std::string();
}

// Rows of series as of a run that is being written: the shortest of them, less a torn last row.
std::size_t whole_rows(const Hdf5File& file, const std::vector<std::string>& names) {
  std::size_t rows = SIZE_MAX;
  for (const std::string& name : names) {
    if (name.starts_with("series/")) rows = std::min(rows, file.layout(name).rows);
  }
  return rows;
}

std::string array_json(const Hdf5File& file, const std::string& name, std::size_t series_rows) {
  const ArrayLayout layout = file.layout(name);
  const bool series = name.starts_with("series/");
  const std::size_t rows = series ? std::min(layout.rows, series_rows) : layout.rows;
  const std::size_t every = series ? (rows + kMostRows - 1) / kMostRows : 1;
  const std::vector<double> values = read_values(file, name, layout);
  std::string data;
  std::size_t kept = 0;
  // Of every `every` rows the last: a series of sums then ends where it ends.
  for (std::size_t row = every > 1 ? (rows - 1) % every : 0; row < rows;
       row += std::max<std::size_t>(every, 1)) {
    for (std::size_t k = 0; k < layout.components; ++k) {
      if (!data.empty()) data += ',';
      data += json_number(values[row * layout.components + k]);
    }
    ++kept;
  }
  return fmt::format(
      "{{\"unit\":{},\"doc\":{},\"rows\":{},\"columns\":{},\"every\":{},\"data\":[{}]}}",
      json_string(attribute(file, name, "unit")), json_string(attribute(file, name, "doc")), kept,
      layout.components, std::max<std::size_t>(every, 1), data);
}

std::string object(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string json;
  for (const auto& [name, value] : entries) {
    json += fmt::format("{}{}:{}", json.empty() ? "" : ",", json_string(name), value);
  }
  return "{" + json + "}";
}

std::string provenance_json(const Hdf5File& file) {
  std::vector<std::pair<std::string, std::string>> entries;
  for (const char* key : {"version", "commit", "machine", "threads", "simd_target", "precision"}) {
    if (file.exists("provenance") && file.has_attribute("provenance", key)) {
      entries.emplace_back(key, json_string(file.text_attribute("provenance", key)));
    }
  }
  return object(entries);
}

bool is_finished(const std::string& folder) {
  try {
    return SummaryFile((fs::path(folder) / "summary.json").string()).flag("finished");
  } catch (const SystemError&) {  // none yet, or no summary of ours
    return false;
  }
}

// HDF5 crashes on some files that a kill has torn: a child meets that first.
void try_to_read(const std::string& path, const ReadResults& read) {
  const pid_t child = fork();
  if (child == 0) {
    constexpr rlimit kNoCore = {0, 0};
    setrlimit(RLIMIT_CORE, &kNoCore);
    try {
      read(Hdf5File("results", path, FileMode::kRead));
    } catch (const std::exception&) {  // which is for the parent to find
    }
    _exit(0);
  }
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (status != 0) {
    throw SystemError(
        fmt::format("cannot read results '{}': it is damaged, reading it crashes", path));
  }
}

RunTables read_tables(const Hdf5File& file) {
  RunTables tables;
  std::vector<std::pair<std::string, std::string>> arrays, texts;
  const std::vector<std::string> names = file.datasets("/");
  const std::size_t series_rows = whole_rows(file, names);
  for (const std::string& name : names) {
    if (!is_shown(name)) continue;
    if (file.is_text(name)) {
      texts.emplace_back(name, json_string(file.read_text(name)));
      continue;
    }
    const ArrayLayout layout = file.layout(name);
    if (!name.starts_with("series/") && layout.rows * layout.components > kMostValues) {
      tables.notes.push_back(
          fmt::format("{} ({}) is too large for this page", name, describe(layout)));
      continue;
    }
    arrays.emplace_back(name, array_json(file, name, series_rows));
  }
  tables.arrays = object(arrays);
  tables.texts = object(texts);
  tables.provenance = provenance_json(file);
  if (file.exists("scene")) tables.scene = file.read_text("scene");
  return tables;
}

}  // namespace

std::string read_results(const std::string& folder, const ReadResults& read, bool closed) {
  const std::string path = (fs::path(folder) / "run.h5").string();
  const std::string kept = (fs::path(folder) / "run.previous.h5").string();
  closed = closed || is_finished(folder);
  constexpr int kTries = 5;
  for (int k = 1;; ++k) {
    try {
      if (!closed) try_to_read(path, read);
      read(Hdf5File("results", path, FileMode::kRead));
      return {};
    } catch (const SystemError& error) {
      if (k < kTries) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        continue;
      }
      if (!fs::exists(kept)) throw;
      read(Hdf5File("results", kept, FileMode::kRead));
      return fmt::format("as of the last checkpoint (run.previous.h5): {}", error.what());
    }
  }
}

RunTables read_run_tables(const std::string& folder, bool closed) {
  if (!fs::is_directory(folder)) {
    throw SystemError(fmt::format("cannot read results '{}': there is no such folder", folder));
  }
  if (!fs::exists(fs::path(folder) / "run.h5")) {
    throw SystemError(fmt::format(
        "cannot read results '{}': it holds no run.h5, so it is not the folder of a run", folder));
  }
  RunTables tables;
  const std::string as_of = read_results(
      folder, [&](const Hdf5File& file) { tables = read_tables(file); }, closed);
  if (!as_of.empty()) tables.notes.push_back("Series and tables are " + as_of);
  return tables;
}

}  // namespace quern
