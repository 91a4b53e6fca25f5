#include "apps/quern/trade_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

#include "apps/quern/trade_spectra.h"
#include "io/hdf5_file.h"
#include "io/summary.h"
#include "scheduler/impact_trial.h"

namespace quern {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::vector<double> numbers(const Hdf5File& file, const std::string& name) {
  if (!file.exists(name)) return {};
  const ArrayLayout layout = file.layout(name);
  std::vector<double> values(layout.rows * layout.components);
  file.read(name, {ElementType::kF64, layout.rows, layout.components}, values.data());
  return values;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

// What collisions and wear had come to at the end of each block.
struct SumBlocks {
  std::vector<std::vector<double>> count, energy, wear;
};

SumBlocks read_blocks(const Hdf5File& file) {
  SumBlocks blocks;
  for (int k = 1;; ++k) {
    const std::string name = fmt::format("sum_blocks/{:06}", k);
    if (!file.exists(name)) return blocks;
    blocks.count.push_back(numbers(file, name + "/count"));
    blocks.energy.push_back(numbers(file, name + "/energy"));
    blocks.wear.push_back(numbers(file, name + "/wear"));
  }
}

// Standard error, over its value, of a sum that grew to these.
double share_of_error(const std::vector<std::vector<double>>& grown, std::size_t column) {
  if (grown.size() < 2) return kUnknown;
  std::vector<double> parts;
  double before = 0;
  for (const std::vector<double>& row : grown) {
    if (column >= row.size()) return kUnknown;
    parts.push_back(row[column] - before);
    before = row[column];
  }
  const auto n = static_cast<double>(parts.size());
  const double mean = std::accumulate(parts.begin(), parts.end(), 0.0) / n;
  double squares = 0;
  for (const double part : parts) squares += (part - mean) * (part - mean);
  return mean > 0 ? std::sqrt(squares / n / (n - 1)) / mean : kUnknown;
}

class Reader {
 public:
  Reader(const std::string& folder, const Scene& scene, double length)
      : scene_(scene),
        per_length_(length / scene.mill->length),
        summary_(folder + "/summary.json"),
        file_("results", folder + "/run.h5", FileMode::kRead),
        blocks_(read_blocks(file_)) {}

  TradeFigures read() {
    add_power();
    add("shoulder_deg", "shoulder", "deg", false, 1);
    add("toe_deg", "toe", "deg", false, 1);
    add_spectra();
    add_wear();
    add_height();
    add_profile();
    out_.ledger_error = summary_.number("ledger_error");
    out_.numerical_loss = summary_.number("numerical_loss");
    return std::move(out_);
  }

 private:
  // A mean of the summary.
  void add(const std::string& name, const std::string& label, const char* unit, bool relative,
           double times) {
    out_.figures.push_back({name, label, unit, relative, times * summary_.number(name),
                            times * summary_.number(name + "_standard_error")});
  }

  void add_power() {
    add("power_W", "power", "W", true, per_length_);
    if (!file_.exists("power_by_kind/kind")) return;
    for (const std::string& kind : lines(file_.read_text("power_by_kind/kind"))) {
      add(fmt::format("power_{}_W", kind), kind, "W", true, per_length_);
    }
  }

  void add_spectra() {
    const std::vector<SpectrumFigure> all = spectrum_figures(blocks_.count, blocks_.energy);
    for (const SpectrumFigure& f : all) {
      out_.figures.push_back({f.name, f.label, "decades", false, f.value, f.standard_error});
    }
  }

  void add_wear() {
    for (const auto& [name, label, column] : {std::tuple{"siem", "wear SIEM", kSiemEnergy},
                                              {"sliding", "by sliding", kSlidingEnergy},
                                              {"finnie", "Finnie", kFinnieEnergy}}) {
      const double time = summary_.number("wear_recorded_s");
      if (!std::isgreater(time, 0.0)) continue;
      const double rate = per_length_ * summary_.number(fmt::format("wear_{}_m3", name)) / time;
      out_.figures.push_back({fmt::format("wear_{}_m3_per_s", name), label, "m^3/s", true, rate,
                              rate * share_of_error(blocks_.wear, column)});
    }
  }

  // Of the turning charge: how high its centre of mass is above the mill's lowest point.
  void add_height() {
    add("center_of_mass_y_m", "height", "m", true, 1);
    TradeFigure& height = out_.figures.back();
    height.name = "height_m";
    height.value += 0.5 * scene_.mill->diameter;
  }

  void add_profile() {
    if (!scene_.mill->lifters || !file_.exists("wear_profile/siem")) return;
    out_.profile.arc = numbers(file_, "wear_profile/arc");
    out_.profile.depth = numbers(file_, "wear_profile/siem");
    out_.profile.error = numbers(file_, "wear_profile/siem_spread");
    for (double& error : out_.profile.error) error /= std::sqrt(scene_.mill->lifters->count);
  }

  const Scene& scene_;
  double per_length_;
  SummaryFile summary_;
  Hdf5File file_;
  SumBlocks blocks_;
  TradeFigures out_;
};

}  // namespace

TradeFigures read_figures(const std::string& folder, const LoadedScene& loaded, double length) {
  TradeFigures all = Reader(folder, loaded.scene, length).read();
  all.time_step = loaded.dt;
  all.steps_per_contact = fewest_steps_per_contact(loaded);
  all.impact_overlap = impact_overlap(loaded.scene, loaded.seeds);
  const DeliveredRestitution found = measure_restitution(loaded.scene, loaded.seeds, loaded.dt);
  all.restitution_asked = found.asked;
  all.restitution_delivered = found.mean;
  all.restitution_scatter = found.scatter;
  return all;
}

}  // namespace quern
