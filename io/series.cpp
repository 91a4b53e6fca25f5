// Appending means: extend each dataset by one, write, flush. Handles stay open, so that a row of
// some sixty quantities costs about a millisecond.
#include "io/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/file_commit.h"
#include "io/log.h"

namespace quern {
namespace {

const std::string kSeries = "series";  // NOLINT(cert-err58-cpp): a short string cannot throw
const std::string kProvenance = "provenance";

FileMode file_mode(const std::string& path, SeriesMode mode) {
  return mode == SeriesMode::kAppend && std::filesystem::exists(path) ? FileMode::kUpdate
                                                                      : FileMode::kCreateGrowing;
}

std::string kept_beside(const std::string& path) {
  return std::filesystem::path(path).replace_extension("previous.h5").string();
}

// Throws if anything cannot be read: a full disk leaves a file that opens and lacks its end.
void read_everything(const std::string& path) {
  const Hdf5File file("series", path, FileMode::kRead);
  std::vector<std::byte> data;
  for (const std::string& name : file.datasets("/")) {
    if (file.is_text(name)) {
      file.read_text(name);
      continue;
    }
    const ArrayLayout layout = file.layout(name);
    data.resize(layout.bytes());
    file.read(name, layout, data.data());
  }
}

// The path, after the kept copy has taken the file's place: what a killed run has written since may
// be torn so that HDF5 crashes on it, and is written again anyway.
const std::string& restore(const std::string& path, SeriesMode mode) {
  const std::string kept = kept_beside(path);
  if (mode != SeriesMode::kAppend || !std::filesystem::exists(kept)) return path;
  try {
    read_everything(kept);
  } catch (const SystemError& error) {
    log_warn(fmt::format("going on with '{}' as it is, because: {}", path, error.what()));
    return path;
  }
  copy_file("series", kept, path);
  return path;
}

}  // namespace

SeriesWriter::SeriesWriter(const std::string& path, const std::vector<Quantity>& quantities,
                           SeriesMode mode)
    : path_(path), file_("series", restore(path, mode), file_mode(path, mode)) {
  for (const Quantity& quantity : quantities) names_.push_back(quantity.name);
  const auto time = std::find(names_.begin(), names_.end(), "time");
  QUERN_CHECK(time != names_.end());
  time_ = static_cast<std::size_t>(time - names_.begin());
  if (file_.exists(kSeries)) {
    open(quantities);
  } else {
    create(quantities);
  }
  file_.flush();
}

void SeriesWriter::create(const std::vector<Quantity>& quantities) {
  file_.make_group(kSeries);
  for (const Quantity& quantity : quantities) {
    QUERN_CHECK(!quantity.name.empty() && !quantity.unit.empty());
    const std::string path = kSeries + "/" + quantity.name;
    file_.create_series(path);
    file_.set_attribute(path, "unit", quantity.unit);
    file_.set_attribute(path, "doc", quantity.doc);
  }
}

void SeriesWriter::open(const std::vector<Quantity>& quantities) {
  for (const std::string& name : file_.datasets(kSeries)) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) {
      file_.fail("continue", "it records '" + name + "', this run does not");
    }
  }
  std::size_t shortest = SIZE_MAX;
  for (const Quantity& quantity : quantities) {
    const std::string path = kSeries + "/" + quantity.name;
    const std::size_t handle = file_.open_series(path);
    const std::string unit = file_.text_attribute(path, "unit");
    if (unit != quantity.unit) {
      file_.fail("continue", fmt::format("'{}' is in '{}', this run records it in '{}'",
                                         quantity.name, unit, quantity.unit));
    }
    shortest = std::min(shortest, file_.series_rows(handle));
  }
  const std::vector<double> times = file_.read_series(time_);
  while (shortest > 0 && std::isnan(times[shortest - 1])) --shortest;
  cut(shortest);
}

void SeriesWriter::cut(std::size_t rows) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (file_.series_rows(i) != rows) file_.resize_series(i, rows);
  }
  rows_ = rows;
}

void SeriesWriter::keep() const { copy_file("series", path_, kept_beside(path_)); }

void SeriesWriter::append(std::span<const double> row) {
  QUERN_CHECK(row.size() == names_.size());
  for (std::size_t i = 0; i < row.size(); ++i) file_.append_series(i, row[i]);
  ++rows_;
  file_.flush();
}

void SeriesWriter::truncate_after(double time) {
  const std::vector<double> times = file_.read_series(time_);
  const auto later =
      std::find_if(times.begin(), times.end(), [&](double t) { return !(t <= time); });
  cut(static_cast<std::size_t>(later - times.begin()));
  file_.flush();
}

std::vector<double> SeriesWriter::read(const std::string& name) const {
  const auto at = std::find(names_.begin(), names_.end(), name);
  QUERN_CHECK(at != names_.end());
  return file_.read_series(static_cast<std::size_t>(at - names_.begin()));
}

void SeriesWriter::text(const std::string& name, const std::string& text) {
  if (file_.exists(name)) file_.remove(name);
  file_.write_text(name, text);
  file_.flush();
}

void SeriesWriter::provenance(const std::string& name, const std::string& value) {
  if (!file_.exists(kProvenance)) file_.make_group(kProvenance);
  file_.set_attribute(kProvenance, name, value);
  file_.flush();
}

void SeriesWriter::write_table(const std::string& name, std::span<const TableColumn> columns) {
  if (file_.exists(name)) file_.remove(name);
  file_.make_group(name);
  for (const TableColumn& column : columns) {
    const Quantity& quantity = column.quantity;
    QUERN_CHECK(!quantity.name.empty() && !quantity.unit.empty());
    const std::string path = name + "/" + quantity.name;
    file_.write(path, column.layout, column.data);
    file_.set_attribute(path, "unit", quantity.unit);
    file_.set_attribute(path, "doc", quantity.doc);
  }
  file_.flush();
}

void SeriesWriter::close() { file_.close(); }

}  // namespace quern
