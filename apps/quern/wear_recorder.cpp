#include "apps/quern/wear_recorder.h"

#include <fmt/format.h>

#include "kernels/wear_profile.h"

namespace quern {

namespace {

// Columns whose values live as long as the table.
class Table {
 public:
  void add(const Quantity& quantity, std::vector<double> values, std::size_t components = 1) {
    quantities_.push_back({quantity, components});
    values_.push_back(std::move(values));
  }
  void write(const std::string& name, SeriesWriter& series) const {
    std::vector<TableColumn> columns;
    for (std::size_t k = 0; k < values_.size(); ++k) {
      columns.push_back(
          table_column<double>(quantities_[k].first, std::span(values_[k]), quantities_[k].second));
    }
    series.write_table(name, columns);
  }

 private:
  std::vector<std::pair<Quantity, std::size_t>> quantities_;
  std::vector<std::vector<double>> values_;
};

std::vector<double> column_of(const std::vector<WearRow>& rows, WearSum sum) {
  std::vector<double> out;
  for (const WearRow& row : rows) out.push_back(row[sum]);
  return out;
}

// Those of which the scene gives what they need.
std::vector<WearModel> models_of(const WearSpec& wear) {
  std::vector<WearModel> out;
  for (const WearModel& model : kWearModels) {
    if (model.sum != kArchardWork || wear.archard_coefficient > 0) out.push_back(model);
  }
  return out;
}

void write_wall(const std::string& name, const WallWear& wall, const std::vector<WearModel>& models,
                SeriesWriter& series) {
  std::vector<double> corners;
  corners.reserve(9 * wall.cells.size());
  for (const WearCell& cell : wall.cells) {
    for (const Vec3& c : cell.corner) corners.insert(corners.end(), {c.x(), c.y(), c.z()});
  }
  Table table;
  table.add({"corner", "m", "three corners of each cell, in the frame of the wall at t = 0"},
            std::move(corners), 9);
  table.add({"area", "m^2", "of the cell"}, wall.area);
  table.add({"energy_siem", "J", "of friction that wears, by the rules of shear impact energy"},
            wall.energy);
  for (const WearModel& m : models) {
    table.add({fmt::format("volume_{}", m.name), "m^3",
               fmt::format("worn off in the recorded time {}", m.doc)},
              column_of(wall.made, m.sum));
    table.add({fmt::format("depth_rate_{}", m.name), "mm/1000h",
               fmt::format("worn off per time {}", m.doc)},
              wall.depth_rate(m.sum));
  }
  table.add({"pressure", "Pa", "mean normal force on the area"}, wall.pressure());
  table.add({"shear", "Pa", "mean size of friction on the area"}, wall.shear());
  table.write("wear/" + name, series);
}

void write_profile(const MillSpec& mill, const WallWear& liner, double cell_size,
                   const std::vector<WearModel>& models, SeriesWriter& series) {
  const WearProfile p = wear_profile(mill, liner, cell_size);
  Table table;
  table.add({"arc", "m", "along the section, from the middle of the shell before a lifter"}, p.arc);
  table.add({"x", "m", "of the section at lifter 0 and t = 0"}, p.x);
  table.add({"y", "m", "likewise"}, p.y);
  const auto both = [&](const std::string& name, const char* unit, const std::string& doc,
                        WearSum sum) {
    table.add({name, unit, doc + ", mean of the lifters"}, column_of(p.mean, sum));
    table.add({name + "_spread", unit, "its standard deviation between the lifters"},
              column_of(p.spread, sum));
  };
  for (const WearModel& m : models) {
    both(m.name, "mm/1000h", fmt::format("worn off per time {}", m.doc), m.sum);
  }
  both("pressure", "Pa", "mean normal force on the area", kNormalImpulse);
  both("shear", "Pa", "mean size of friction on the area", kShearImpulse);
  table.write("wear_profile", series);
}

template <class Real>
void write_groups(const World<Real>& world, const Scene& scene,
                  const std::vector<WearModel>& models, SeriesWriter& series) {
  const std::vector<WearRow> species = species_wear(world, scene);
  std::vector<WearRow> groups(world.groups.of_particles(), WearRow{});
  std::string names;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    names += (g > 0 ? "\n" : "") + world.groups.names()[g];
  }
  for (std::size_t s = 0; s < species.size(); ++s) {
    for (std::size_t k = 0; k < kWearSums; ++k)
      groups[world.groups.of_species(s)][k] += species[s][k];
  }
  Table table;
  for (const WearModel& m : models) {
    table.add({fmt::format("volume_{}", m.name), "m^3",
               fmt::format("worn off the group's particles by the walls in the recorded time {}; "
                           "NaN: a material has no hardness",
                           m.doc)},
              column_of(groups, m.sum));
  }
  table.write("wear_of_groups", series);
  series.text("wear_of_groups/group", names);
}

double factor_of(const WearSpec& wear, WearSum sum) {
  if (sum == kArchardWork) return wear.archard_factor;
  return sum == kFinnieEnergy ? wear.finnie_factor : wear.siem_factor;
}

}  // namespace

template <class Real>
std::string write_wear(const World<Real>& world, const Scene& scene, SeriesWriter& series,
                       Summary& summary) {
  const WearSpec& wear = *scene.wear;
  const std::vector<WearModel> models = models_of(wear);
  WearRow total{};
  for (Index w = 0; w < world.walls.size(); ++w) {
    const WallWear wall = wall_wear(world, scene, w);
    write_wall(world.walls[w].name, wall, models, series);
    const WearRow of_wall = wall.total();
    for (const WearModel& m : models) total[m.sum] += of_wall[m.sum];
    // The mill's shell is the first wall of all.
    if (w == 0 && scene.mill && scene.mill->lifters) {
      write_profile(*scene.mill, wall, world.wear.cell_size, models, series);
    }
  }
  write_groups(world, scene, models, series);
  summary.set("wear_recorded_s", world.wear.time[0]);
  summary.set("wear_cells", world.wear.cell_count());
  summary.set("wear_cell_size_m", world.wear.cell_size);
  std::string line;
  for (const WearModel& m : models) {
    summary.set(fmt::format("wear_{}_m3", m.name), total[m.sum]);
    line += fmt::format("{}{} {:.3g} mm^3 (factor {:g})", line.empty() ? "" : ", ", m.name,
                        1e9 * total[m.sum], factor_of(wear, m.sum));
  }
  summary.set("wear_siem_factor", wear.siem_factor);
  summary.set("wear_finnie_factor", wear.finnie_factor);
  if (wear.archard_coefficient > 0) {
    summary.set("wear_archard_factor", wear.archard_factor);
    summary.set("wear_archard_coefficient", wear.archard_coefficient);
  }
  return fmt::format("{} in {:.4g} s on {} cells", line, world.wear.time[0],
                     world.wear.cell_count());
}

template std::string write_wear(const World<float>&, const Scene&, SeriesWriter&, Summary&);
template std::string write_wear(const World<double>&, const Scene&, SeriesWriter&, Summary&);

}  // namespace quern
