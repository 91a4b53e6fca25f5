// JSON by hand: a flat object of a few dozen entries needs no library.
#include "io/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/file_commit.h"
#include "io/statistics.h"

namespace quern {

std::string Summary::number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string Summary::quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        result += "\\\"";
        break;
      case '\\':
        result += "\\\\";
        break;
      case '\n':
        result += "\\n";
        break;
      case '\t':
        result += "\\t";
        break;
      case '\r':
        result += "\\r";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
          result += c;
        }
    }
  }
  return result + '"';
}

void Summary::put(const std::string& name, std::string json) {
  const auto same = [&](const auto& entry) { return entry.first == name; };
  const auto found = std::find_if(entries_.begin(), entries_.end(), same);
  if (found != entries_.end()) {
    found->second = std::move(json);
  } else {
    entries_.emplace_back(name, std::move(json));
  }
}

void Summary::set_mean(const std::string& name, double mean, double standard_error) {
  put(name, number(mean));
  put(name + "_standard_error", number(standard_error));
}

void Summary::set_mean(const std::string& name, const Mean& mean) {
  set_mean(name, mean.mean, mean.standard_error);
}

void Summary::set_array(const std::string& name, const std::vector<double>& values) {
  std::string json;
  for (const double v : values) json += (json.empty() ? "[" : ", ") + number(v);
  put(name, json.empty() ? "[]" : json + "]");
}

std::string Summary::text() const {
  std::string result = "{";
  for (const auto& [name, json] : entries_) {
    result += fmt::format("{}\n  {}: {}", &name == &entries_.front().first ? "" : ",", quoted(name),
                          json);
  }
  return result + (entries_.empty() ? "}\n" : "\n}\n");
}

void Summary::write(const std::string& path) const {
  write_text_file("summary", path, text(), Durability::kPowerCut);
}

}  // namespace quern
