// Lines, fields and what can be wrong with them.
#include "io/particle_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "io/quantity.h"
#include "io/toml_reader.h"

namespace quern {
namespace {

constexpr std::size_t kMostErrors = 20;
const std::vector<std::string> kColumns = {"x",  "y",  "z",  "diameter", "vx",   "vy",
                                           "vz", "wx", "wy", "wz",       "class"};
constexpr std::size_t kNeeded = 4;  // the first of them
constexpr std::size_t kClass = 10;  // the others are numbers

std::vector<std::string> split_line(const std::string& line) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = line.find(',', begin);
    std::string field = line.substr(begin, end - begin);
    const std::size_t first = field.find_first_not_of(" \t");
    field = first == std::string::npos
                ? ""
                : field.substr(first, field.find_last_not_of(" \t") - first + 1);
    fields.push_back(field);
    if (end == std::string::npos) return fields;
    begin = end + 1;
  }
}

class CsvReader {
 public:
  CsvReader(const std::string& path, const std::string& own,
            const std::vector<std::string>& sharing)
      : path_(path), own_(own), sharing_(sharing) {}

  ParticleCsv read() {
    std::ifstream file(path_);
    std::string line;
    if (!file || file.peek() == std::ifstream::traits_type::eof()) {
      const bool opened = static_cast<bool>(file.is_open());
      result_.errors.push_back(
          fmt::format("{}: error: {}", path_, opened ? "the file is empty" : std::strerror(errno)));
      return result_;
    }
    while (std::getline(file, line)) {
      ++line_;
      if (line.ends_with('\r')) line.pop_back();
      if (line.find_first_not_of(" \t") == std::string::npos || line.starts_with('#')) continue;
      if (!columns_.empty())
        read_row(split_line(line));
      else if (!read_header(split_line(line)))
        break;
    }
    if (columns_.empty() && result_.errors.empty()) fail("there is no header line");
    if (count_ > kMostErrors)
      result_.errors.push_back(
          fmt::format("{}: error: ... and {} more", path_, count_ - kMostErrors));
    return result_;
  }

 private:
  void fail(const std::string& what) {
    if (++count_ <= kMostErrors)
      result_.errors.push_back(fmt::format("{}:{}: error: {}", path_, line_, what));
  }

  bool has_column(std::size_t column) const {
    return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
  }

  bool read_header(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const auto found = std::find(kColumns.begin(), kColumns.end(), name);
      const auto index = static_cast<std::size_t>(found - kColumns.begin());
      if (found == kColumns.end())
        fail(fmt::format("'{}' is no column{} ({})", name, did_you_mean(name, kColumns),
                         fmt::join(kColumns, ", ")));
      else if (has_column(index))
        fail(fmt::format("column '{}' is there twice", name));
      columns_.push_back(index);
    }
    for (std::size_t k = 0; k < kNeeded; ++k)
      if (!has_column(k)) fail(fmt::format("the header needs a column '{}'", kColumns[k]));
    if (sharing_.size() > 1 && !has_column(kClass))
      fail(fmt::format("the header needs a column 'class': several particles take this file ({})",
                       fmt::join(sharing_, ", ")));
    return count_ == 0;
  }

  void read_row(const std::vector<std::string>& row) {
    if (row.size() != columns_.size())
      return fail(fmt::format("{} values, the header has {} columns", row.size(), columns_.size()));
    double value[kClass] = {};
    bool wanted = true;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (columns_[k] == kClass) {
        if (std::find(sharing_.begin(), sharing_.end(), row[k]) == sharing_.end())
          return fail(fmt::format("class: no particles '{}' take this file{} ({})", row[k],
                                  did_you_mean(row[k], sharing_), fmt::join(sharing_, ", ")));
        wanted = row[k] == own_;
      } else if (!parse_number(row[k], value[columns_[k]])) {
        return fail(fmt::format("{}: '{}' is no number", kColumns[columns_[k]], row[k]));
      }
    }
    if (value[3] <= 0) return fail("diameter: must be greater than 0");
    if (!wanted) return;
    ExplicitParticle particle;
    particle.position = {value[0], value[1], value[2]};
    particle.velocity = {value[4], value[5], value[6]};
    particle.spin = {value[7], value[8], value[9]};
    particle.diameter = value[3];
    result_.particles.push_back(particle);
  }

  const std::string &path_, &own_;
  const std::vector<std::string>& sharing_;
  ParticleCsv result_;
  std::vector<std::size_t> columns_;  // of the file, as rows of kColumns
  std::size_t line_ = 0, count_ = 0;
};

}  // namespace

ParticleCsv read_particle_csv(const std::string& path, const std::string& own,
                              const std::vector<std::string>& sharing) {
  return CsvReader(path, own, sharing).read();
}

}  // namespace quern
