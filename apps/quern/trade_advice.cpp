#include "apps/quern/trade_advice.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "apps/quern/trade_table.h"

namespace quern {

namespace {

using Row = std::map<std::string, std::string>;

// Fields of the line at `at`, which moves behind it; quotes as csv_text() sets them.
std::vector<std::string> next_line(std::string_view csv, std::size_t& at) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (; at < csv.size(); ++at) {
    const char c = csv[at];
    if (c == '"') {
      if (quoted && at + 1 < csv.size() && csv[at + 1] == '"') {
        fields.back() += csv[++at];
      } else {
        quoted = !quoted;
      }
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else if (c == '\n' && !quoted) {
      ++at;
      break;
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

// Rows that have figures.
std::vector<Row> rows_of(std::string_view csv) {
  std::size_t at = 0;
  const std::vector<std::string> names = next_line(csv, at);
  std::vector<Row> rows;
  while (at < csv.size()) {
    const std::vector<std::string> fields = next_line(csv, at);
    Row row;
    for (std::size_t k = 0; k < std::min(names.size(), fields.size()); ++k) {
      row[names[k]] = fields[k];
    }
    if (row["status"].empty()) rows.push_back(std::move(row));
  }
  return rows;
}

double number(const Row& row, const std::string& name) {
  const auto found = row.find(name);
  if (found == row.end() || found->second.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::strtod(found->second.c_str(), nullptr);
}

std::string errors_text(const Row& row) {
  std::string text;
  const auto add = [&](const char* label, const std::string& name, const char* unit) {
    const TradeError error{name, label, unit, number(row, name + "_error"),
                           number(row, name + "_standard_error")};
    if (!error.known() || error_text(error) == "0") return;
    text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", label, error_text(error), unit);
  };
  add("power", "power_W", "%");
  add("shoulder", "shoulder_deg", "deg");
  add("toe", "toe_deg", "deg");
  add("spectrum's mean", "spectrum_count_mean", "decades");
  add("wear", "wear_siem_m3_per_s", "%");
  return text.empty() ? "it is what the others are measured against" : text;
}

// Of rows of the dial, and the default's, the one nearest on the side of `coarser`; the coarsest of
// all where there is none. `coarse` grows with the error.
std::optional<Row> nearest_coarser(const std::vector<Row>& rows, const std::string& dial,
                                   double own, const std::function<double(const Row&)>& coarse) {
  const Row *nearest = nullptr, *coarsest = nullptr;
  for (const Row& row : rows) {
    if (row.at("dial") != dial && row.at("dial") != "default") continue;
    const double value = coarse(row);
    if (coarsest == nullptr || value > coarse(*coarsest)) coarsest = &row;
    if (value < own * (1 - 0.01)) continue;
    if (nearest == nullptr || value < coarse(*nearest)) nearest = &row;
  }
  if (coarsest == nullptr) return std::nullopt;
  return nearest != nullptr ? *nearest : *coarsest;
}

}  // namespace

std::vector<std::string> expected_accuracy(const JudgedScene& scene,
                                           const std::vector<ShippedTable>& tables) {
  const double steps = scene.steps_per_contact, overlap = scene.impact_overlap;
  std::vector<std::string> lines;
  const auto add = [&](const std::string& own, std::string_view table, const std::string& measured,
                       const Row& row) {
    lines.push_back(fmt::format("  {:<24} {} {}: {}", own, table, measured, errors_text(row)));
  };
  for (const ShippedTable& table : tables) {
    const std::vector<Row> rows = rows_of(table.csv);
    const auto of_steps = nearest_coarser(rows, "steps per contact", 1 / steps, [](const Row& r) {
      return 1 / number(r, "steps_per_contact");
    });
    if (of_steps) {
      add(fmt::format("{:.3g} steps a contact", steps), table.scene,
          fmt::format("at {:.3g}", number(*of_steps, "steps_per_contact")), *of_steps);
    }
    const auto of_softness = nearest_coarser(
        rows, "softened", overlap, [](const Row& r) { return number(r, "impact_overlap"); });
    if (of_softness) {
      add(fmt::format("impact overlap {:.2g} r", overlap), table.scene,
          fmt::format("at {:.2g} r", number(*of_softness, "impact_overlap")), *of_softness);
    }
    for (const Row& row : rows) {
      const bool of_dial = row.at("dial") == "precision" || row.at("dial") == "default";
      if (!of_dial || row.at("precision") != scene.precision) continue;
      add("precision " + scene.precision, table.scene, "in " + scene.precision, row);
      break;
    }
  }
  return lines;
}

}  // namespace quern
