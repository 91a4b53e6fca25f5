#include "apps/quern/charge_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/quern/mill_query.h"
#include "io/file_commit.h"
#include "kernels/charge_angles.h"
#include "kernels/charge_map.h"
#include "soa/facets.h"
#include "soa/motion.h"

namespace quern {

namespace {

constexpr double kDegree = kPi / 180;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::vector<double> in_degrees(std::vector<double> angles) {
  for (double& angle : angles) angle /= kDegree;
  return angles;
}

std::vector<double> in_blocks(const ChargeAngles& angles, double FoundAngles::*angle) {
  std::vector<double> all;
  for (const FoundAngles& block : angles.blocks) all.push_back(block.*angle / kDegree);
  return all;
}

}  // namespace

ChargeRecorder::ChargeRecorder(const Scene& scene, const SnapshotClock& clock)
    : scene_(scene), clock_(clock), snapshots_(scene) {}

// Sums the snapshots into blocks, and looks at each on the way.
std::vector<ChargeMap> ChargeRecorder::read_blocks(std::uint64_t step, const ChargeMap& empty,
                                                   const ChargeQuery& query,
                                                   const SeriesWriter& series) {
  seen_ = Seen();
  const std::uint64_t last = clock_.number(step);
  const std::size_t blocks = std::min<std::size_t>(kBlocks, last);
  std::vector<ChargeMap> maps(blocks, empty);
  ChargeMap one = empty;
  double time = 0;
  for (std::uint64_t k = 1; k <= last; ++k) {
    if (!snapshots_.read(k, series, one, time)) continue;
    add_snapshots(one, maps[(k - 1) * blocks / last]);
    const ChargeShape shape = find_charge_shape(one, query);
    seen_.time.push_back(time);
    seen_.shoulder.push_back(shape.found ? shape.shoulder : kUnknown);
    seen_.toe.push_back(shape.toe_found ? shape.bulk_toe : kUnknown);
  }
  std::erase_if(maps, [](const ChargeMap& map) { return map.snapshots <= 0; });
  return maps;
}

void ChargeRecorder::finish(std::uint64_t step, const ParticleFrame& frame, SeriesWriter& series,
                            Summary& summary) {
  const ChargeMap empty = snapshots_.empty_map(frame);
  const double time = clock_.time(step);
  const ChargeQuery asked = mill_query(scene_, clock_.start(), time, median_diameter(frame.radius));
  std::vector<ChargeMap> blocks = read_blocks(step, empty, asked, series);
  const bool any = !blocks.empty();
  if (!any) blocks.push_back(empty);
  angles_ = find_charge_angles(blocks, liner_, asked);
  ChargeMap all = empty;
  for (const ChargeMap& block : blocks) add_snapshots(block, all);
  count_ = all.snapshots;
  picture_.shape = angles_.shape;
  report(summary);
  if (!any) return;

  describe(all.grid, time, asked.direction);
  write_tables(all, series);
  write_angles(series);
}

void ChargeRecorder::describe(const PolarGrid& grid, double time, double direction) {
  picture_.title = scene_.run.title.empty() ? "Shape of the charge" : scene_.run.title;
  picture_.grid = grid;
  picture_.direction = direction;
  const Eigen::Rotation2Dd turn(schedule_integral(scene_.mill->rotation, time));
  picture_.profile = mill_profile(*scene_.mill);
  for (Eigen::Vector2d& corner : picture_.profile) corner = turn * corner;
  picture_.notes = {
      fmt::format("Mean of {:g} snapshots, {:.4g} ... {:.4g} s; lifters as at the end.", count_,
                  clock_.first_time(), time),
      fmt::format("Bulk (orange): above half the bed's solid fraction of {:.3f}.",
                  angles_.shape.bed_fraction)};
  picture_.rays.clear();
  const auto ray = [&](const char* name, const AngleFigure& angle, double radius) {
    if (std::isfinite(angle.value)) {
      picture_.rays.push_back({name, angle.value, angle.error, radius});
    }
  };
  ray("shoulder", angles_.shoulder, angles_.shape.shoulder_radius);
  ray("toe", angles_.toe, 0);
  ray("head", angles_.head, 0);
  if (angles_.impacts_found) {
    ray("impact toe", angles_.impact_toe, 0);
  } else if (angles_.liner_known) {
    picture_.notes.push_back("No hits on the bare liner: the impact toe is the toe.");
  }
}

void ChargeRecorder::report(Summary& summary) const {
  summary.set("charge_snapshots", count_);
  summary.set("bed_solid_fraction", angles_.shape.bed_fraction);
  const auto angle = [&](const char* name, const AngleFigure& figure) {
    summary.set_mean(name, figure.value / kDegree, figure.error / kDegree);
    summary.set(fmt::format("{}_at_0.4", name), figure.at_low / kDegree);
    summary.set(fmt::format("{}_at_0.6", name), figure.at_high / kDegree);
  };
  angle("shoulder_deg", angles_.shoulder);
  angle("toe_deg", angles_.toe);
  summary.set("shoulder_deg_spread",
              angle_spread(angles_.shoulder.value, seen_.shoulder) / kDegree);
  summary.set("toe_deg_spread", angle_spread(angles_.toe.value, seen_.toe) / kDegree);
  if (!angles_.liner_known) return;
  angle("head_deg", angles_.head);
  angle("impact_toe_deg", angles_.impact_toe);
  summary.set("impact_toe_found", angles_.impacts_found);
}

void ChargeRecorder::write_tables(const ChargeMap& all, SeriesWriter& series) const {
  const PolarGrid& grid = picture_.grid;
  const ChargeShape& shape = angles_.shape;
  const auto angles = static_cast<std::size_t>(grid.angles);
  std::vector<double> radius, angle;
  for (int k = 0; k < grid.rings; ++k) radius.push_back(grid.middle_radius(k));
  for (int a = 0; a < grid.angles; ++a) angle.push_back(grid.middle_angle(a) / kDegree);
  std::vector<double> ring = shape.ring_fraction;
  ring.resize(angles, 0);
  std::vector<TableColumn> map = {
      table_column<double>({"solid_fraction", "1", "mean, rings x angles"}, shape.fraction, angles),
      table_column<std::uint8_t>({"bulk", "1", "1: of the bulk, rings x angles"}, shape.bulk,
                                 angles),
      table_column<double>({"radius", "m", "middle of each ring of cells"}, radius),
      table_column<double>({"angle", "deg", "middle of each cell, counterclockwise from +x"},
                           angle),
      table_column<double>({"ring_fraction", "1", "solid fraction inside the lifters' tops"},
                           ring)};
  const ChargeSnapshots::Means means = snapshots_.means(all);
  for (std::size_t k = 0; k < means.data.size(); ++k) {
    map.push_back(table_column<double>(means.quantities[k], means.data[k], angles));
  }
  series.write_table("charge_map", map);
}

void ChargeRecorder::write_angles(SeriesWriter& series) const {
  const std::vector<double> shoulder = in_blocks(angles_, &FoundAngles::shoulder),
                            toe = in_blocks(angles_, &FoundAngles::toe),
                            head = in_blocks(angles_, &FoundAngles::head),
                            impact_toe = in_blocks(angles_, &FoundAngles::impact_toe);
  std::vector<TableColumn> blocks = {
      table_column<double>({"shoulder", "deg", "of each block of snapshots"}, shoulder),
      table_column<double>({"toe", "deg", "of each block of snapshots"}, toe)};
  if (angles_.liner_known) {
    blocks.push_back(table_column<double>({"head", "deg", "of each block of time"}, head));
    blocks.push_back(
        table_column<double>({"impact_toe", "deg", "of each block of time"}, impact_toe));
  }
  series.write_table("charge_blocks", blocks);
  const std::vector<double> seen_shoulder = in_degrees(seen_.shoulder),
                            seen_toe = in_degrees(seen_.toe);
  const TableColumn seen[] = {
      table_column<double>({"time", "s", "of the snapshot"}, seen_.time),
      table_column<double>({"shoulder", "deg", "NaN: not found"}, seen_shoulder),
      table_column<double>({"toe", "deg", "NaN: not found"}, seen_toe)};
  series.write_table("series_of_charge", seen);
}

void ChargeRecorder::write_picture(const std::string& path) const {
  if (count_ <= 0) return;
  write_text_file("picture", path, charge_svg(picture_), Durability::kKill);
}

std::string ChargeRecorder::line() const {
  if (!std::isfinite(angles_.shoulder.value)) return "no snapshot of a bulk yet";
  const auto text = [](const AngleFigure& angle) {
    if (!std::isfinite(angle.value)) return std::string("none");
    const std::string value = fmt::format("{:.1f}", angle.value / kDegree);
    if (!std::isfinite(angle.error)) return value + " deg";
    return fmt::format("{} +- {:.1f} deg", value, angle.error / kDegree);
  };
  std::string line = fmt::format("shoulder {}, toe {}", text(angles_.shoulder), text(angles_.toe));
  if (angles_.liner_known) {
    line += fmt::format(", head {}, impact toe {}", text(angles_.head),
                        angles_.impacts_found ? text(angles_.impact_toe) : "at the toe");
  }
  return line + " (charge_shape.svg)";
}

}  // namespace quern
