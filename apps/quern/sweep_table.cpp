#include "apps/quern/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "apps/quern/child_run.h"
#include "io/file_commit.h"
#include "io/hdf5_file.h"
#include "io/log.h"
#include "io/quantity.h"
#include "io/summary.h"
#include "io/toml_reader.h"

namespace quern {

namespace {

constexpr const char* kError = "_standard_error";

// The usual responses, in this order, then wear and power by kind of collision.
constexpr const char* kUsual[] = {"power_W", "shoulder_deg", "toe_deg", "impact_toe_deg"};

std::vector<std::string> usual_names(const std::set<std::string>& there) {
  std::vector<std::string> names;
  for (const char* name : kUsual) {
    if (there.contains(name)) names.emplace_back(name);
  }
  for (const std::string& name : there) {
    const bool wear = name.starts_with("wear_") && name.ends_with("_m3");
    const bool kind =
        name.starts_with("power_") && name.ends_with("_W") && name.find('-') != std::string::npos;
    if (wear || kind) names.push_back(name);
  }
  return names;
}

SweepColumn column_of(const SweepPlan& plan, std::size_t f) {
  SweepColumn column;
  column.key = plan.spec.factors[f].keys.front();
  column.unit = "1";
  bool numbers = true, first = true;
  for (const SweepRun& run : plan.cases) {
    const std::string& text = run.place.values[f];
    column.texts.push_back(text);
    double number = 0;
    std::string unit;
    numbers = numbers && split_quantity(text, number, unit) && (first || unit == column.unit);
    column.unit = unit;
    column.numbers.push_back(number);
    first = false;
  }
  if (!numbers) column.numbers.clear();
  if (!numbers || column.unit.empty()) column.unit = "1";
  return column;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_number(double value) { return std::isfinite(value) ? format_number(value) : ""; }

std::string head_of(const SweepColumn& column) {
  return column.unit == "1" ? column.key : fmt::format("{} [{}]", column.key, column.unit);
}

std::string csv_text(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "case,status,seed";
  for (const SweepColumn& column : table.factors) text += "," + csv_field(head_of(column));
  for (const SweepResponse& r : table.responses) text += "," + r.name + "," + r.name + kError;
  text += "\n";
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    const SweepCase& place = plan.cases[k].place;
    text += fmt::format("{},{},{}", csv_field(place.name), csv_field(table.status[k]), place.seed);
    for (const SweepColumn& column : table.factors) {
      text += "," +
              (column.numbers.empty() ? csv_field(column.texts[k]) : csv_number(column.numbers[k]));
    }
    for (const SweepResponse& r : table.responses) {
      text += "," + csv_number(r.value[k]) + "," + csv_number(r.error[k]);
    }
    text += "\n";
  }
  return text;
}

std::string lines_of(const std::vector<std::string>& texts) {
  return fmt::format("{}", fmt::join(texts, "\n"));
}

void write_h5(const SweepPlan& plan, const SweepTable& table) {
  PendingFile pending("table", plan.out + "/sweep.h5");
  Hdf5File file("table", pending.temporary(), FileMode::kCreate);
  std::vector<std::string> names;
  std::vector<double> seeds, points;
  for (const SweepRun& run : plan.cases) {
    names.push_back(run.place.name);
    seeds.push_back(static_cast<double>(run.place.seed));
    points.push_back(static_cast<double>(run.place.point));
  }
  const auto write = [&](const std::string& name, const std::vector<double>& values,
                         const std::string& unit) {
    file.write(name, {ElementType::kF64, values.size(), 1}, values.data());
    file.set_attribute(name, "unit", unit);
  };
  file.write_text("case", lines_of(names));
  file.write_text("status", lines_of(table.status));
  write("seed", seeds, "1");
  write("point", points, "1");
  for (const SweepColumn& column : table.factors) {
    const std::string name = "factors/" + column.key;
    if (column.numbers.empty()) {
      file.write_text(name, lines_of(column.texts));
    } else {
      write(name, column.numbers, column.unit);
    }
  }
  for (const SweepResponse& r : table.responses) {
    write("responses/" + r.name, r.value, r.unit);
    write("responses/" + r.name + kError, r.error, r.unit);
  }
  file.close();
  pending.commit(Durability::kKill);
}

// "": it has not failed.
std::string failure_of(const RunOutcome& outcome, const std::string& folder) {
  if (outcome.state == RunState::kFailed) return outcome.reason;
  const std::string mark = failed_file(folder);
  return std::filesystem::exists(mark) ? read_text_file("mark", mark) : "";
}

std::string status_of(const SweepPlan& plan, const SweepRun& run) {
  const RunOutcome outcome = outcome_of(run);
  if (outcome.state == RunState::kFinished) return "finished";
  if (is_locked(run.folder)) return "running";
  const std::string failure = failure_of(outcome, run.folder);
  if (!failure.empty()) return "failed: " + failure;
  if (holds_scene(run.folder, run.scene)) return "stopped";
  if (run.filling < 0) return "missing";
  const SweepFilling& filling = plan.fillings[static_cast<std::size_t>(run.filling)];
  const RunOutcome there = outcome_of(filling);
  const bool open = there.state != RunState::kFinished && !is_locked(filling.folder);
  const std::string why = open ? failure_of(there, filling.folder) : "";
  return why.empty() ? "missing" : "failed: its filling: " + why;
}

}  // namespace

std::string unit_of_response(const std::string& name) {
  constexpr std::pair<const char*, const char*> kUnits[] = {
      {"_W", "W"},    {"_deg", "deg"}, {"_m3", "m^3"}, {"_J", "J"},
      {"_Nm", "N m"}, {"_kg", "kg"},   {"_m", "m"},    {"_s", "s"}};
  for (const auto& [end, unit] : kUnits) {
    if (name.ends_with(end)) return unit;
  }
  return "1";
}

SweepTable table_of(const SweepPlan& plan) {
  SweepTable table;
  for (std::size_t f = 0; f < plan.spec.factors.size(); ++f)
    table.factors.push_back(column_of(plan, f));
  std::vector<SummaryFile> summaries;
  std::set<std::string> there;
  for (const SweepRun& run : plan.cases) {
    table.status.push_back(status_of(plan, run));
    const bool finished = table.status.back() == "finished";
    summaries.push_back(finished ? SummaryFile(run.folder + "/summary.json") : SummaryFile());
    for (const std::string& name : summaries.back().names()) {
      if (std::isfinite(summaries.back().number(name))) there.insert(name);
    }
  }
  const bool asked = !plan.spec.responses.empty();
  for (const std::string& name : asked ? plan.spec.responses : usual_names(there)) {
    if (!there.empty() && !there.contains(name)) {
      log_warn(fmt::format("no finished case has the response '{}'{}", name,
                           did_you_mean(name, {there.begin(), there.end()})));
    }
    SweepResponse& response = table.responses.emplace_back();
    response.name = name;
    response.unit = unit_of_response(name);
    for (const SummaryFile& summary : summaries) {
      response.value.push_back(summary.number(name));
      response.error.push_back(summary.number(name + kError));
    }
  }
  return table;
}

void write_results(const SweepPlan& plan, const SweepTable& table) {
  write_text_file("table", plan.out + "/sweep.csv", csv_text(plan, table), Durability::kKill);
  write_h5(plan, table);
  write_sweep_page(plan, table);
}

}  // namespace quern
