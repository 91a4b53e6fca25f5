#include "apps/quern/window_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/quern/mill_query.h"
#include "io/log.h"
#include "io/statistics.h"
#include "io/steadiness.h"
#include "kernels/charge_map.h"
#include "kernels/mill_power.h"

namespace quern {

namespace {

constexpr double kDegree = kPi / 180;

std::vector<double> recorded(const SeriesWriter& series, const std::string& name,
                             const RecordedWindow& window) {
  std::vector<double> all = series.read(name);
  const std::size_t first = std::min(window.first_row, all.size());
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(first));
  return all;
}

struct WatchedSeries {
  std::vector<Watched> quantities;
  std::vector<std::string> keys;  // what they are called in the series
};

// Power and kinetic energy against their means, the centre of mass against the mill's radius; what
// is zero throughout is not watched.
WatchedSeries watched_of(const Scene& scene, const RecordedWindow& window,
                         const SeriesWriter& series) {
  WatchedSeries all;
  const auto watch = [&](const char* name, const std::string& quantity, double scale) {
    std::vector<double> samples = recorded(series, quantity, window);
    if (scale <= 0) scale = samples.empty() ? 0 : std::abs(block_mean(samples).mean);
    if (scale == 0) return;
    all.quantities.push_back({name, std::move(samples), scale});
    all.keys.push_back(quantity);
  };
  watch("power", "power", 0);
  watch("kinetic energy", "kinetic_energy", 0);
  if (scene.mill) {
    watch("centre of mass x", "center_of_mass_x", 0.5 * scene.mill->diameter);
    watch("centre of mass y", "center_of_mass_y", 0.5 * scene.mill->diameter);
  }
  return all;
}

std::string report_steadiness(const Scene& scene, const RecordedWindow& window,
                              const SeriesWriter& series, Summary& summary) {
  const WatchedSeries watched = watched_of(scene, window, series);
  const Steadiness result = judge_steadiness(watched.quantities);
  summary.set("steady", result.verdict == Verdict::kSteady);
  summary.set("steady_statement", result.statement);
  for (std::size_t k = 0; k < result.trends.size(); ++k) {
    const Trend& trend = result.trends[k];
    const std::string& key = watched.keys[k];
    const double scale = watched.quantities[k].scale;
    summary.set_mean(key + "_drift_share", trend.drift.value / scale,
                     trend.drift.standard_error / scale);
    summary.set_mean(key + "_step_share", trend.step.value / scale,
                     trend.step.standard_error / scale);
  }
  return result.statement;
}

void report_dynamic_angle(const Scene& scene, const RecordedWindow& window,
                          const SeriesWriter& series, Summary& summary) {
  const ChargeQuery query = mill_query(scene, window.from, window.to, 0);
  const std::vector<double> x = recorded(series, "center_of_mass_x", window),
                            y = recorded(series, "center_of_mass_y", window);
  std::vector<double> angle;
  for (std::size_t k = 0; k < x.size(); ++k) {
    angle.push_back(dynamic_angle(x[k], y[k], query) / kDegree);
  }
  summary.set_mean("dynamic_angle_deg", block_mean(angle));
}

MillLoad load_of(const Scene& scene, const RecordedWindow& window, const ParticleFrame& frame,
                 double mass) {
  constexpr double kBulkFraction = 0.6;
  const MillSpec& mill = *scene.mill;
  double solid = 0;
  for (const float radius : frame.radius) {
    solid += 4.0 / 3.0 * kPi * std::pow(static_cast<double>(radius), 3);
  }
  const double volume = 0.25 * kPi * mill.diameter * mill.diameter * mill.length;
  const double time = window.to - window.from;
  const double turn = turn_of(mill, window.from, window.to);
  return {mill.diameter, mill.length, solid / kBulkFraction / volume, mass,
          time > 0 ? turn / time : 0};
}

void write_formulas(const std::vector<PowerFormula>& formulas, SeriesWriter& series) {
  std::vector<double> low, high;
  std::string name, source, valid;
  for (const PowerFormula& formula : formulas) {
    low.push_back(formula.low);
    high.push_back(formula.high);
    name += formula.name + "\n";
    source += formula.source + "\n";
    valid += formula.valid + "\n";
  }
  const TableColumn columns[] = {table_column<double>({"low", "W", "least power"}, low),
                                 table_column<double>({"high", "W", "largest power"}, high)};
  series.write_table("formulas", columns);
  series.text("formulas/name", name);
  series.text("formulas/source", source);
  series.text("formulas/valid", valid);
}

void report_formulas(const MillLoad& load, double power, SeriesWriter& series, Summary& summary,
                     WindowLines& lines) {
  const std::vector<PowerFormula> formulas = power_formulas(load);
  if (formulas.empty()) {
    summary.set("power_formulas", "not of this mill: " + why_no_formula(load));
    return;
  }
  write_formulas(formulas, series);
  double low = formulas[0].low, high = formulas[0].high;
  for (const PowerFormula& formula : formulas) {
    low = std::min(low, formula.low);
    high = std::max(high, formula.high);
    lines.formulas += fmt::format("{}{} {}", lines.formulas.empty() ? "" : ", ", formula.name,
                                  format_power(formula.low));
    if (formula.high > formula.low) lines.formulas += " to " + format_power(formula.high);
  }
  summary.set("power_formula_low_W", low);
  summary.set("power_formula_high_W", high);
  if (!std::isfinite(power)) return;
  const bool within = power >= low && power <= high;
  summary.set("power_within_formulas", within);
  if (!within) {
    lines.warning =
        fmt::format("the power of {} is outside {} to {}, which formulas of mill design span",
                    format_power(power), format_power(low), format_power(high));
  }
}

}  // namespace

WindowLines report_window(const Scene& scene, const RecordedWindow& window,
                          const ParticleFrame& frame, double mass, SeriesWriter& series,
                          Summary& summary) {
  WindowLines lines;
  lines.steady = report_steadiness(scene, window, series, summary);
  if (!scene.mill) return lines;
  report_dynamic_angle(scene, window, series, summary);
  const double power = block_mean(recorded(series, "power", window)).mean;
  report_formulas(load_of(scene, window, frame, mass), power, series, summary, lines);
  return lines;
}

}  // namespace quern
