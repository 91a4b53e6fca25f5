// Summary: OUT/summary.json, the figures of a run for scripts, in the order they were set.
//
// Flat JSON: one name, one value. Doubles are printed with the fewest digits that read back as the
// same bits; NaN and infinity, which JSON lacks, become null. Setting a name again replaces it.
#pragma once

#include <concepts>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quern {

struct Mean;

class Summary {
 public:
  template <std::floating_point T>
  void set(const std::string& name, T value) {
    put(name, number(static_cast<double>(value)));
  }
  template <std::integral T>
  requires(!std::same_as<T, bool>) void set(const std::string& name, T value) {
    put(name, std::to_string(value));
  }
  template <std::same_as<bool> T>
  void set(const std::string& name, T value) {
    put(name, value ? "true" : "false");
  }
  void set(const std::string& name, std::string_view value) { put(name, quoted(value)); }

  // "name": mean, "name_standard_error": standard error
  void set_mean(const std::string& name, double mean, double standard_error);
  void set_mean(const std::string& name, const Mean& mean);
  void set_array(const std::string& name, const std::vector<double>& values);

  std::string text() const;
  void write(const std::string& path) const;  // by renaming; SystemError

 private:
  static std::string number(double value);
  static std::string quoted(std::string_view text);
  void put(const std::string& name, std::string json);

  std::vector<std::pair<std::string, std::string>> entries_;  // name, value as JSON
};

// A summary read back, of a run that has one: what Summary writes, and no other JSON.
class SummaryFile {
 public:
  SummaryFile() = default;                        // none
  explicit SummaryFile(const std::string& path);  // SystemError where it is no summary

  double number(const std::string& name) const;     // NaN: absent or unknown
  bool flag(const std::string& name) const;         // false: absent
  std::string text(const std::string& name) const;  // empty: absent
  bool empty() const { return entries_.empty(); }
  std::vector<std::string> names() const;  // sorted

 private:
  std::map<std::string, std::string> entries_;  // name, value as JSON
};

}  // namespace quern
