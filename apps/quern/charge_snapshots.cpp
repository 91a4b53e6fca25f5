#include "apps/quern/charge_snapshots.h"

#include <algorithm>
#include <cmath>

#include "apps/quern/snapshot_clock.h"
#include "kernels/charge_map.h"
#include "soa/groups.h"

namespace quern {

namespace {

constexpr const char* kTable = "charge_snapshots";

// Amounts of a particle; after them 1 or 0 for each group, if there are two or more.
enum Amount : std::size_t { kVelocityX, kVelocityY, kSpeed, kFirstGroup };

ArrayLayout layout_of(const PolarGrid& grid) {
  return {ElementType::kF32, static_cast<std::size_t>(grid.rings),
          static_cast<std::size_t>(grid.angles)};
}

// One amount of all cells, as it is kept.
std::vector<float> column_of(const ChargeMap& map, std::size_t amount) {
  std::vector<float> column(map.grid.cells());
  for (std::size_t cell = 0; cell < column.size(); ++cell) {
    column[cell] = static_cast<float>(map.carried[cell * map.amounts + amount]);
  }
  return column;
}

}  // namespace

ChargeSnapshots::ChargeSnapshots(const Scene& scene) : scene_(scene) {
  const Groups groups(scene);
  groups_.assign(groups.names().begin(),
                 groups.names().begin() + static_cast<std::ptrdiff_t>(groups.of_particles()));
  for (std::size_t k = 0; k < scene.particles.size(); ++k) {
    group_of_.push_back(groups.of_species(k));
  }
  columns_ = {{"volume_velocity_x", "m^4/s", "volume times velocity, rings x angles"},
              {"volume_velocity_y", "m^4/s", "volume times velocity, rings x angles"},
              {"volume_speed", "m^4/s", "volume times speed, rings x angles"}};
  for (const std::string& group : groups_) {
    if (groups_.size() < 2) break;
    columns_.push_back({"volume_of_" + group, "m^3", "of one group, rings x angles"});
  }
}

ChargeMap ChargeSnapshots::empty_map(const ParticleFrame& frame) const {
  const MillSpec& mill = *scene_.mill;
  const PolarGrid grid = choose_polar_grid(0.5 * mill.diameter, median_diameter(frame.radius),
                                           scene_.record.cell_angle, scene_.record.cell_width);
  return make_charge_map(grid, mill.length, amounts());
}

std::vector<float> ChargeSnapshots::amounts_of(const ParticleFrame& frame) const {
  const std::size_t n = frame.radius.size(), width = amounts();
  std::vector<float> all(n * width, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const float* v = &frame.velocity[3 * i];
    float* row = &all[i * width];
    row[kVelocityX] = v[0];
    row[kVelocityY] = v[1];
    row[kSpeed] = std::hypot(v[0], v[1], v[2]);
    const std::size_t species = frame.species[i];
    if (width > kFirstGroup && species < group_of_.size())
      row[kFirstGroup + group_of_[species]] = 1;
  }
  return all;
}

void ChargeSnapshots::write(std::uint64_t number, const ParticleFrame& frame,
                            SeriesWriter& series) const {
  ChargeMap map = empty_map(frame);
  deposit(frame.position, frame.radius, amounts_of(frame), map);
  const std::vector<float> volume(map.volume.begin(), map.volume.end());
  std::vector<std::vector<float>> kept;
  for (std::size_t k = 0; k < amounts(); ++k) kept.push_back(column_of(map, k));
  std::vector<TableColumn> columns = {
      {{"volume", "m^3", "solid volume in each cell, rings x angles"},
       layout_of(map.grid),
       volume.data()},
      table_column<double>({"time", "s", "of the snapshot"}, std::span(&frame.time, 1))};
  for (std::size_t k = 0; k < amounts(); ++k) {
    columns.push_back({columns_[k], layout_of(map.grid), kept[k].data()});
  }
  series.write_table(SnapshotClock::name(kTable, number), columns);
}

bool ChargeSnapshots::read(std::uint64_t number, const SeriesWriter& series, ChargeMap& map,
                           double& time) const {
  const std::string name = SnapshotClock::name(kTable, number);
  if (!series.has(name)) return false;
  const ArrayLayout layout = layout_of(map.grid);
  std::vector<float> column(map.grid.cells());
  series.read_column(name + "/volume", layout, column.data());
  std::copy(column.begin(), column.end(), map.volume.begin());
  for (std::size_t k = 0; k < amounts(); ++k) {
    series.read_column(name + "/" + columns_[k].name, layout, column.data());
    for (std::size_t cell = 0; cell < column.size(); ++cell) {
      map.carried[cell * map.amounts + k] = column[cell];
    }
  }
  series.read_column(name + "/time", {ElementType::kF64, 1, 1}, &time);
  map.snapshots = 1;
  return true;
}

ChargeSnapshots::Means ChargeSnapshots::means(const ChargeMap& map) const {
  Means means;
  const auto add = [&](Quantity quantity, std::vector<double> data) {
    means.quantities.push_back(std::move(quantity));
    means.data.push_back(std::move(data));
  };
  const std::string of = ", mean over the volume seen (0 where none was), rings x angles";
  add({"velocity_x", "m/s", "half-step velocity" + of}, mean_amount(map, kVelocityX));
  add({"velocity_y", "m/s", "half-step velocity" + of}, mean_amount(map, kVelocityY));
  add({"speed", "m/s", "speed in all three directions" + of}, mean_amount(map, kSpeed));
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    add({"solid_fraction_" + groups_[g], "1", "of one group of particles, mean, rings x angles"},
        groups_.size() < 2 ? solid_fraction(map) : solid_fraction_carrying(map, kFirstGroup + g));
  }
  return means;
}

}  // namespace quern
