#include "apps/quern/class_recorder.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "io/statistics.h"

namespace quern {

namespace {

constexpr const char* kTable = "class_snapshots";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// The sums of a snapshot, by name.
struct Kept {
  const char* name;
  const char* unit;
  const char* doc;
  std::vector<double> ClassSums::*values;
};

constexpr Kept kKept[] = {{"count", "1", "particles, classes x (all, zones)", &ClassSums::count},
                          {"spin", "rad/s", "sum of angular speeds", &ClassSums::spin},
                          {"kinetic_energy", "J", "translational", &ClassSums::kinetic_energy},
                          {"rotational_energy", "J", "", &ClassSums::rotational_energy}};
constexpr std::size_t kSums = std::size(kKept);
enum Sum : std::size_t { kCount, kSpin, kKinetic, kRotational };

// Mean of `sum` over that of `count`: of a ratio the rest sum - ratio * count carries the error.
Mean ratio_of(const std::vector<double>& sum, const std::vector<double>& count) {
  const double number = block_mean(count).mean;
  if (!(number > 0)) return {kUnknown, kUnknown};
  const double ratio = block_mean(sum).mean / number;
  std::vector<double> rest;
  for (std::size_t k = 0; k < sum.size(); ++k) rest.push_back(sum[k] - ratio * count[k]);
  return {ratio, block_mean(rest).standard_error / number};
}

// A column of means and one of their errors.
struct Columns {
  std::vector<Quantity> quantities;
  std::vector<std::vector<double>> data;

  void add(const Quantity& quantity, const std::vector<Mean>& means) {
    quantities.push_back(quantity);
    quantities.push_back({quantity.name + "_standard_error", quantity.unit, "of the mean"});
    data.emplace_back();
    data.emplace_back();
    for (const Mean& mean : means) {
      data[data.size() - 2].push_back(mean.mean);
      data.back().push_back(mean.standard_error);
    }
  }
  void write(const std::string& name, SeriesWriter& series) const {
    std::vector<TableColumn> columns;
    for (std::size_t k = 0; k < data.size(); ++k) {
      columns.push_back(table_column<double>(quantities[k], data[k]));
    }
    series.write_table(name, columns);
  }
};

}  // namespace

// Over time, of each class in the whole mill (column 0) and in each zone.
struct ClassRecorder::Sums {
  std::size_t columns = 1;
  std::vector<std::vector<double>> series[kSums];  // [class * columns + column], over snapshots

  const std::vector<double>& of(Sum sum, std::size_t row, std::size_t column) const {
    return series[sum][row * columns + column];
  }
};

ClassRecorder::ClassRecorder(const Scene& scene, const SnapshotClock& clock)
    : scene_(scene), clock_(clock), classes_(scene) {}

void ClassRecorder::take(std::uint64_t step, const ParticleFrame& frame, const EnergyFrame& energy,
                         SeriesWriter& series) const {
  const std::size_t rows = classes_.rows().size(), width = 1 + scene_.record.zones.size();
  std::vector<double> data[kSums];
  for (std::vector<double>& column : data) column.resize(rows * width);
  for (std::size_t column = 0; column < width; ++column) {
    const ZoneSpec* zone = column == 0 ? nullptr : &scene_.record.zones[column - 1];
    const ClassSums sums = sum_classes(frame, energy, rows, zone);
    for (std::size_t k = 0; k < kSums; ++k)
      for (std::size_t row = 0; row < rows; ++row)
        data[k][row * width + column] = (sums.*kKept[k].values)[row];
  }
  std::vector<TableColumn> columns = {
      table_column<double>({"time", "s", "of the snapshot"}, std::span(&frame.time, 1))};
  for (std::size_t k = 0; k < kSums; ++k) {
    columns.push_back(
        table_column<double>({kKept[k].name, kKept[k].unit, kKept[k].doc}, data[k], width));
  }
  series.write_table(SnapshotClock::name(kTable, clock_.number(step)), columns);
}

ClassRecorder::Sums ClassRecorder::read(std::uint64_t step, const SeriesWriter& series) const {
  const std::size_t rows = classes_.rows().size();
  Sums sums;
  sums.columns = 1 + scene_.record.zones.size();
  for (auto& all : sums.series) all.resize(rows * sums.columns);
  std::vector<double> one(rows * sums.columns);
  for (std::uint64_t number = 1; number <= clock_.number(step); ++number) {
    const std::string name = SnapshotClock::name(kTable, number);
    if (!series.has(name)) continue;
    for (std::size_t k = 0; k < kSums; ++k) {
      series.read_column(name + "/" + kKept[k].name, {ElementType::kF64, rows, sums.columns},
                         one.data());
      for (std::size_t at = 0; at < one.size(); ++at) sums.series[k][at].push_back(one[at]);
    }
  }
  return sums;
}

void ClassRecorder::finish(std::uint64_t step, SeriesWriter& series) const {
  const Sums sums = read(step, series);
  if (classes_.rows().empty() || sums.of(kCount, 0, 0).empty()) return;
  write_classes(sums, series);
  std::string names;
  for (const SizeClasses::Row& row : classes_.rows()) names += row.name + "\n";
  series.text("classes/name", names);
  for (std::size_t k = 0; k < scene_.record.zones.size(); ++k) write_zone(sums, k, series);
}

void ClassRecorder::write_classes(const Sums& sums, SeriesWriter& series) const {
  std::vector<double> from, to;
  std::vector<Mean> count, spin, kinetic, rotational;
  for (std::size_t row = 0; row < classes_.rows().size(); ++row) {
    from.push_back(classes_.rows()[row].from);
    to.push_back(classes_.rows()[row].to);
    count.push_back(block_mean(sums.of(kCount, row, 0)));
    spin.push_back(ratio_of(sums.of(kSpin, row, 0), sums.of(kCount, row, 0)));
    kinetic.push_back(block_mean(sums.of(kKinetic, row, 0)));
    rotational.push_back(block_mean(sums.of(kRotational, row, 0)));
  }
  Columns columns;
  columns.quantities = {{"from", "m", "least diameter of the class"},
                        {"to", "m", "largest diameter of the class"}};
  columns.data = {from, to};
  columns.add({"count", "1", "particles, mean"}, count);
  columns.add({"angular_speed", "rad/s", "mean over particles and time"}, spin);
  columns.add({"kinetic_energy", "J", "translational, of all of the class, mean"}, kinetic);
  columns.add({"rotational_energy", "J", "of all of the class, mean"}, rotational);
  columns.write("classes", series);
}

void ClassRecorder::write_zone(const Sums& sums, std::size_t zone, SeriesWriter& series) const {
  std::vector<Mean> count, kinetic, rotational, of_one;
  for (std::size_t row = 0; row < classes_.rows().size(); ++row) {
    const std::vector<double>& number = sums.of(kCount, row, zone + 1);
    count.push_back(block_mean(number));
    kinetic.push_back(block_mean(sums.of(kKinetic, row, zone + 1)));
    rotational.push_back(block_mean(sums.of(kRotational, row, zone + 1)));
    of_one.push_back(ratio_of(sums.of(kKinetic, row, zone + 1), number));
  }
  Columns columns;
  columns.add({"count", "1", "particles inside, mean; a row for each of /classes"}, count);
  columns.add({"kinetic_energy", "J", "translational, of those inside, mean"}, kinetic);
  columns.add({"rotational_energy", "J", "of those inside, mean"}, rotational);
  columns.add({"kinetic_energy_of_one", "J", "translational, of a particle inside, mean"}, of_one);
  const std::string name = "zones/" + scene_.record.zones[zone].name;
  columns.write(name, series);
}

}  // namespace quern
