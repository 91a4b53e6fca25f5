// JSON by hand: a flat object of a few dozen entries needs no library.
#include "io/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "io/file_commit.h"
#include "io/statistics.h"
#include "soa/base.h"

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

namespace {

// A name or text without its quotes and escapes.
std::string unquoted(std::string_view quoted) {
  std::string text;
  for (std::size_t k = 1; k + 1 < quoted.size(); ++k) {
    if (quoted[k] != '\\') {
      text += quoted[k];
      continue;
    }
    const char c = quoted[++k];
    if (c == 'u' && k + 4 < quoted.size()) {
      text +=
          static_cast<char>(std::strtol(std::string(quoted.substr(k + 1, 4)).c_str(), nullptr, 16));
      k += 4;
    } else {
      text += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
    }
  }
  return text;
}

}  // namespace

// Summary puts each entry on a line of its own, and no line break into any.
SummaryFile::SummaryFile(const std::string& path) {
  const std::string all = read_text_file("summary", path);
  std::size_t begin = 0;
  while (begin < all.size()) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    std::string_view line(all.data() + begin, end - begin);
    begin = end + 1;
    if (line.empty() || line == "{" || line == "}" || line == "{}") continue;
    const std::size_t colon = line.find("\": ");
    if (!line.starts_with("  \"") || colon == std::string_view::npos) {
      throw SystemError("cannot read summary '" + path + "': it is none that quern wrote");
    }
    if (line.ends_with(',')) line.remove_suffix(1);
    entries_[unquoted(line.substr(2, colon - 1))] = std::string(line.substr(colon + 3));
  }
}

double SummaryFile::number(const std::string& name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return std::numeric_limits<double>::quiet_NaN();
  char* end = nullptr;
  const double value = std::strtod(found->second.c_str(), &end);
  return *end == '\0' && end != found->second.c_str() ? value
                                                      : std::numeric_limits<double>::quiet_NaN();
}

bool SummaryFile::flag(const std::string& name) const {
  const auto found = entries_.find(name);
  return found != entries_.end() && found->second == "true";
}

std::string SummaryFile::text(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() || !found->second.starts_with('"') ? "" : unquoted(found->second);
}

std::vector<std::string> SummaryFile::names() const {
  std::vector<std::string> all;
  for (const auto& [name, json] : entries_) all.push_back(name);
  return all;
}

}  // namespace quern
