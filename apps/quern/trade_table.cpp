#include "apps/quern/trade_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/packed.h"

namespace quern {

namespace {

const TradeError* error_named(const TradeResult& result, const std::string& name) {
  for (const TradeError& error : result.errors) {
    if (error.name == name) return &error;
  }
  return nullptr;
}

const char* state_name(SteadyState state) {
  switch (state) {
    case SteadyState::kShared:
      return "shared";
    case SteadyState::kOwnShapes:
      return "own shapes";
    default:
      return "own charge";
  }
}

std::string cost_text(const TradeResult& r) {
  return fmt::format("{:.3g} ({:.3g}-{:.3g})", r.cost.ratio, r.cost.low, r.cost.high);
}

// Columns of texts, the first three to the left. A row that ends early ends in words, which are as
// wide as they like.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> width;
  for (const auto& row : rows) {
    width.resize(std::max(width.size(), row.size()), 0);
    const std::size_t count = row.size() < rows[0].size() ? row.size() - 1 : row.size();
    for (std::size_t k = 0; k < count; ++k) width[k] = std::max(width[k], row[k].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      line += k < 3 ? fmt::format("{:<{}}  ", row[k], width[k])
                    : fmt::format("{:>{}}  ", row[k], width[k]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

using ErrorNames = std::vector<std::string>;

// One part of the table: the same rows, errors of some figures.
std::string part_text(const TradeTable& table, const ErrorNames& names) {
  std::vector<std::vector<std::string>> rows = {{"dial", "value", "against", "cost"}};
  for (const std::string& name : names) {
    for (const TradeResult& r : table.rows) {
      const TradeError* error = error_named(r, name);
      if (error == nullptr) continue;
      rows[0].push_back(fmt::format("{}, {}", error->label, error->unit));
      break;
    }
  }
  for (const TradeResult& r : table.rows) {
    rows.push_back({r.row.dial, r.row.value + (r.front ? " *" : "")});
    if (!r.status.empty()) {
      rows.back().push_back(r.status);
      continue;
    }
    rows.back().insert(rows.back().end(), {r.against, cost_text(r)});
    for (const std::string& name : names) {
      const TradeError* error = error_named(r, name);
      if (rows.back().size() < rows[0].size()) {
        rows.back().push_back(error != nullptr ? error_text(*error) : "-");
      }
    }
  }
  return aligned(rows);
}

std::string numerics_text(const TradeTable& table) {
  std::vector<std::vector<std::string>> rows = {
      {"dial", "value", "state", "cost", "time step, s", "steps a contact", "impact overlap",
       "restitution asked", "delivered", "scatter", "ledger error", "numerical loss"}};
  for (const TradeResult& r : table.rows) {
    if (!r.status.empty()) continue;
    rows.push_back({r.row.dial, r.row.value, state_name(r.row.setting.state), cost_text(r)});
    const TradeFigures& f = r.figures;
    for (std::string text :
         {fmt::format("{:.3g}", f.time_step), fmt::format("{:.3g}", f.steps_per_contact),
          fmt::format("{:.2g} r", f.impact_overlap), fmt::format("{:.3g}", f.restitution_asked),
          fmt::format("{:+.4f}", f.restitution_delivered - f.restitution_asked),
          fmt::format("{:.4f}", f.restitution_scatter), fmt::format("{:.1e}", f.ledger_error),
          fmt::format("{:.1e}", f.numerical_loss)}) {
      rows.back().push_back(std::move(text));
    }
  }
  return aligned(rows);
}

ErrorNames names_starting(const TradeTable& table, const std::vector<std::string>& starts) {
  ErrorNames names;
  for (const TradeResult& r : table.rows) {
    for (const TradeError& e : r.errors) {
      const bool wanted = std::any_of(starts.begin(), starts.end(), [&](const std::string& start) {
        return e.name.starts_with(start);
      });
      if (wanted && std::find(names.begin(), names.end(), e.name) == names.end()) {
        names.push_back(e.name);
      }
    }
  }
  return names;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "";
}

std::string errors_json(const TradeResult& r) {
  std::string json;
  for (const TradeError& e : r.errors) {
    json += fmt::format(
        "{}{{\"name\":{},\"label\":{},\"unit\":{},\"value\":{},\"standard_error\":{},"
        "\"below\":{}}}",
        json.empty() ? "" : ",", json_string(e.name), json_string(e.label), json_string(e.unit),
        json_number(e.value), json_number(e.standard_error), e.below());
  }
  return json;
}

std::string row_json(const TradeResult& r) {
  const TradeFigures& f = r.figures;
  return fmt::format(
      "{{\"dial\":{},\"value\":{},\"setting\":{},\"set\":{},\"state\":{},\"against\":{},"
      "\"status\":{},\"front\":{},\"cost\":{},\"cost_low\":{},\"cost_high\":{},\"wall_s_per_s\":{},"
      "\"precision\":{},\"time_step\":{},\"steps_per_contact\":{},\"impact_overlap\":{},"
      "\"restitution_asked\":{},\"restitution_delivered\":{},\"restitution_scatter\":{},"
      "\"ledger_error\":{},\"numerical_loss\":{},\"errors\":[{}]}}",
      json_string(r.row.dial), json_string(r.row.value), json_string(r.row.setting.name),
      json_string(fmt::format("{}", fmt::join(r.row.setting.set, "\n"))),
      json_string(state_name(r.row.setting.state)), json_string(r.against), json_string(r.status),
      r.front, json_number(r.cost.ratio), json_number(r.cost.low), json_number(r.cost.high),
      json_number(r.cost.seconds), json_string(r.precision), json_number(f.time_step),
      json_number(f.steps_per_contact), json_number(f.impact_overlap),
      json_number(f.restitution_asked), json_number(f.restitution_delivered),
      json_number(f.restitution_scatter), json_number(f.ledger_error),
      json_number(f.numerical_loss), errors_json(r));
}

}  // namespace

void mark_front(TradeTable& table) {
  const auto known = [](const TradeResult& r) {
    const TradeError* power = error_named(r, "power_W");
    return r.status.empty() && power != nullptr && power->known();
  };
  for (TradeResult& r : table.rows) {
    r.front = known(r);
    for (const TradeResult& other : table.rows) {
      if (!r.front || !known(other) || other.against != r.against) continue;
      const double own = error_named(r, "power_W")->bound(),
                   its = error_named(other, "power_W")->bound();
      const bool no_worse = other.cost.ratio <= r.cost.ratio && its <= own;
      if (no_worse && (other.cost.ratio < r.cost.ratio || its < own)) r.front = false;
    }
  }
}

namespace {

// To so many digits, never as a power of ten where it is large.
std::string rounded(double value, int digits) {
  return std::abs(value) < std::pow(10, digits) ? fmt::format("{:.{}g}", value, digits)
                                                : fmt::format("{:.0f}", value);
}

}  // namespace

std::string error_text(const TradeError& error) {
  if (!error.known()) return "-";
  if (error.value == 0 && error.standard_error == 0) return "0";
  if (error.below()) return "< " + rounded(2 * error.standard_error, 2);
  return fmt::format("{}{} +- {}", error.value > 0 ? "+" : "", rounded(error.value, 2),
                     rounded(error.standard_error, 1));
}

std::string terminal_text(const TradeTable& table) {
  std::string text = fmt::format(
      "{}\nquern {}, {}, {} threads; {:g} turns recorded after {:g}\n"
      "cost: time for a second of the mill over the default's, median (quartiles) of turns in "
      "which both run;\nerrors against the setting named, +- standard error; <: below two standard "
      "errors;\n*: none measured against the same is both cheaper and nearer in power\n",
      table.command, table.commit, table.machine, table.threads, table.revolutions, table.lead);
  text += "\npower and height of the charge's centre of mass\n" +
          part_text(table, names_starting(table, {"power_", "height"}));
  text += "\nshoulder, toe; spectrum of collisions (decades of energy); wear of the liner\n" +
          part_text(table, names_starting(table, {"shoulder", "toe", "spectrum", "wear"}));
  text += "\nnumerics\n" + numerics_text(table);
  return text;
}

std::string csv_text(const TradeTable& table) {
  const ErrorNames names = names_starting(table, {""});
  std::string csv =
      "dial,value,setting,state,against,status,front,cost,cost_low,cost_high,precision,time_step_s,"
      "steps_per_contact,impact_overlap,restitution_asked,restitution_delivered,"
      "restitution_scatter,ledger_error,numerical_loss";
  for (const std::string& name : names) csv += fmt::format(",{0}_error,{0}_standard_error", name);
  csv += "\n";
  for (const TradeResult& r : table.rows) {
    const TradeFigures& f = r.figures;
    csv += fmt::format("{},{},{},{},{},{},{:d}", csv_field(r.row.dial), csv_field(r.row.value),
                       csv_field(r.row.setting.name), state_name(r.row.setting.state),
                       csv_field(r.against), csv_field(r.status), r.front);
    const bool told = r.status.empty();
    for (const double value : {r.cost.ratio, r.cost.low, r.cost.high}) {
      csv += fmt::format(",{}", told ? csv_number(value) : "");
    }
    csv += fmt::format(",{}", r.precision);
    for (const double value :
         {f.time_step, f.steps_per_contact, f.impact_overlap, f.restitution_asked,
          f.restitution_delivered, f.restitution_scatter, f.ledger_error, f.numerical_loss}) {
      csv += fmt::format(",{}", told ? csv_number(value) : "");
    }
    for (const std::string& name : names) {
      const TradeError* error = error_named(r, name);
      csv += error != nullptr ? fmt::format(",{},{}", csv_number(error->value),
                                            csv_number(error->standard_error))
                              : ",,";
    }
    csv += "\n";
  }
  return csv;
}

std::string json_text(const TradeTable& table) {
  std::string rows;
  for (const TradeResult& r : table.rows) rows += (rows.empty() ? "" : ",\n") + row_json(r);
  return fmt::format(
      "{{\"scene\":{},\"title\":{},\"command\":{},\"machine\":{},\"commit\":{},\"threads\":{},"
      "\"lead\":{},\"revolutions\":{},\"rows\":[\n{}\n]}}\n",
      json_string(table.scene), json_string(table.title), json_string(table.command),
      json_string(table.machine), json_string(table.commit), table.threads, json_number(table.lead),
      json_number(table.revolutions), rows);
}

}  // namespace quern
