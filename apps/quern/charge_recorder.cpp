#include "apps/quern/charge_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/file_commit.h"
#include "kernels/charge_map.h"
#include "soa/facets.h"
#include "soa/motion.h"

namespace quern {

namespace {

constexpr double kDegree = kPi / 180;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string snapshot_name(std::uint64_t number) {
  return fmt::format("charge_snapshots/{:06}", number);
}

ArrayLayout layout_of(const PolarGrid& grid) {
  return {ElementType::kF32, static_cast<std::size_t>(grid.rings),
          static_cast<std::size_t>(grid.angles)};
}

// The angles that were found, on the turn nearest to `value`.
std::vector<double> found_near(double value, const std::vector<double>& angles) {
  std::vector<double> found;
  for (const double angle : angles)
    if (std::isfinite(angle)) found.push_back(angle_near(angle, value));
  return found;
}

// Error of an angle from its values in blocks.
double error_of(double value, const std::vector<double>& blocks) {
  const std::vector<double> found = found_near(value, blocks);
  return found.size() < 2 ? kUnknown : block_mean(found).standard_error;
}

// Standard deviation of an angle over the snapshots.
double spread_of(double value, const std::vector<double>& snapshots) {
  const std::vector<double> found = found_near(value, snapshots);
  if (found.size() < 2) return kUnknown;
  const int count = static_cast<int>(found.size());
  return std::sqrt(count) * block_mean(found, count).standard_error;
}

std::vector<double> in_degrees(std::vector<double> angles) {
  for (double& angle : angles) angle /= kDegree;
  return angles;
}

}  // namespace

ChargeRecorder::ChargeRecorder(const Scene& scene, double dt, std::uint64_t first_step,
                               std::uint64_t last_step)
    : scene_(scene), dt_(dt), first_step_(first_step) {
  constexpr std::uint64_t kSnapshots = 100;
  const double every = scene.record.snapshots_every;
  const std::uint64_t window = last_step > first_step ? last_step - first_step : 1;
  every_ = every > 0 ? static_cast<std::uint64_t>(std::llround(every / dt)) : window / kSnapshots;
  every_ = std::max<std::uint64_t>(every_, 1);
}

ChargeMap ChargeRecorder::empty_map(const ParticleFrame& frame) const {
  const MillSpec& mill = *scene_.mill;
  const PolarGrid grid = choose_polar_grid(0.5 * mill.diameter, median_diameter(frame.radius),
                                           scene_.record.cell_angle, scene_.record.cell_width);
  return make_charge_map(grid, mill.length);
}

void ChargeRecorder::take(std::uint64_t step, const ParticleFrame& frame,
                          SeriesWriter& series) const {
  ChargeMap map = empty_map(frame);
  deposit(frame.position, frame.radius, map);
  const std::vector<float> volume(map.volume.begin(), map.volume.end());
  const TableColumn columns[] = {
      {{"volume", "m^3", "solid volume in each cell, rings x angles"},
       layout_of(map.grid),
       volume.data()},
      table_column<double>({"time", "s", "of the snapshot"}, std::span(&frame.time, 1))};
  series.write_table(snapshot_name((step - first_step_) / every_), columns);
}

void ChargeRecorder::Found::add(const ChargeShape& shape) {
  shoulder.push_back(shape.found ? shape.shoulder : kUnknown);
  toe.push_back(shape.toe_found ? shape.bulk_toe : kUnknown);
}

std::vector<ChargeMap> ChargeRecorder::read_blocks(std::uint64_t step, const ChargeMap& empty,
                                                   const ChargeQuery& query,
                                                   const SeriesWriter& series) {
  constexpr std::size_t kBlocks = 10;
  std::vector<std::string> names;
  const std::uint64_t last = step > first_step_ ? (step - first_step_) / every_ : 0;
  for (std::uint64_t k = 1; k <= last; ++k)
    if (series.has(snapshot_name(k))) names.push_back(snapshot_name(k));
  std::vector<ChargeMap> blocks(std::min(kBlocks, names.size()), empty);
  ChargeMap one = empty;
  one.snapshots = 1;
  std::vector<float> volume(empty.volume.size());
  in_snapshots_ = Found();
  for (std::size_t k = 0; k < names.size(); ++k) {
    series.read_column(names[k] + "/volume", layout_of(empty.grid), volume.data());
    std::copy(volume.begin(), volume.end(), one.volume.begin());
    add_snapshots(one, blocks[k * blocks.size() / names.size()]);
    in_snapshots_.add(find_charge_shape(one, query));
  }
  return blocks;
}

ChargeQuery ChargeRecorder::query(double particle_size, double time) const {
  const MillSpec& mill = *scene_.mill;
  const double start = static_cast<double>(first_step_) * dt_;
  const double turned =
      schedule_integral(mill.rotation, time) - schedule_integral(mill.rotation, start);
  ChargeQuery query;
  query.direction = turned < 0 ? -1 : 1;
  query.lifter_height = mill.lifters ? mill.lifters->height : 0;
  query.particle_size = particle_size;
  const Vec3& g = scene_.run.gravity;
  if (std::hypot(g.x(), g.y()) > 0) query.up = std::atan2(-g.y(), -g.x());
  return query;
}

void ChargeRecorder::find_angles(const ChargeMap& all, const std::vector<ChargeMap>& blocks,
                                 const ChargeQuery& query) {
  in_blocks_ = Found();
  for (const ChargeMap& block : blocks) in_blocks_.add(find_charge_shape(block, query));
  picture_.shape = find_charge_shape(all, query);
  const ChargeShape& shape = picture_.shape;
  const auto angle = [](bool found, double value, const std::vector<double>& in_blocks,
                        const std::vector<double>& in_snapshots) {
    return found ? Angle{value, error_of(value, in_blocks), spread_of(value, in_snapshots)}
                 : Angle{kUnknown, kUnknown, kUnknown};
  };
  shoulder_ = angle(shape.found, shape.shoulder, in_blocks_.shoulder, in_snapshots_.shoulder);
  toe_ = angle(shape.toe_found, shape.bulk_toe, in_blocks_.toe, in_snapshots_.toe);
}

void ChargeRecorder::finish(std::uint64_t step, const ParticleFrame& frame, SeriesWriter& series,
                            Summary& summary) {
  ChargeMap all = empty_map(frame);
  const double time = static_cast<double>(step) * dt_;
  const ChargeQuery asked = query(median_diameter(frame.radius), time);
  const std::vector<ChargeMap> blocks = read_blocks(step, all, asked, series);
  for (const ChargeMap& block : blocks) add_snapshots(block, all);
  snapshots_ = all.snapshots;
  find_angles(all, blocks, asked);
  report(all, asked, summary);
  if (blocks.empty()) return;

  describe(all.grid, time, asked.direction);
  write_tables(series);
}

void ChargeRecorder::describe(const PolarGrid& grid, double time, double direction) {
  const ChargeShape& shape = picture_.shape;
  picture_.title = scene_.run.title.empty() ? "Shape of the charge" : scene_.run.title;
  picture_.grid = grid;
  picture_.direction = direction;
  const Eigen::Rotation2Dd turn(schedule_integral(scene_.mill->rotation, time));
  picture_.profile = mill_profile(*scene_.mill);
  for (Eigen::Vector2d& corner : picture_.profile) corner = turn * corner;
  picture_.notes = {
      fmt::format("Mean of {:g} snapshots, {:.4g} ... {:.4g} s; lifters as at the end.", snapshots_,
                  static_cast<double>(first_step_ + every_) * dt_, time),
      fmt::format("Bulk (orange): above half the bed's solid fraction of {:.3f}.",
                  shape.bed_fraction)};
  picture_.rays.clear();
  if (shape.found) {
    picture_.rays.push_back({"shoulder", shoulder_.value, shoulder_.error, shape.shoulder_radius});
  }
  if (shape.toe_found) picture_.rays.push_back({"toe", toe_.value, toe_.error, 0});
}

void ChargeRecorder::report(const ChargeMap& all, const ChargeQuery& asked,
                            Summary& summary) const {
  summary.set("charge_snapshots", snapshots_);
  summary.set("bed_solid_fraction", picture_.shape.bed_fraction);
  summary.set_mean("shoulder_deg", shoulder_.value / kDegree, shoulder_.error / kDegree);
  summary.set_mean("toe_deg", toe_.value / kDegree, toe_.error / kDegree);
  summary.set("shoulder_deg_spread", shoulder_.spread / kDegree);
  summary.set("toe_deg_spread", toe_.spread / kDegree);
  for (const double cut : {0.4, 0.6}) {
    ChargeQuery other = asked;
    other.cut = cut;
    const ChargeShape shape = find_charge_shape(all, other);
    summary.set(fmt::format("shoulder_deg_at_{}", cut),
                shape.found ? shape.shoulder / kDegree : kUnknown);
    summary.set(fmt::format("toe_deg_at_{}", cut),
                shape.toe_found ? shape.bulk_toe / kDegree : kUnknown);
  }
}

void ChargeRecorder::write_tables(SeriesWriter& series) const {
  const PolarGrid& grid = picture_.grid;
  const ChargeShape& shape = picture_.shape;
  const auto angles = static_cast<std::size_t>(grid.angles);
  std::vector<double> radius, angle;
  for (int k = 0; k < grid.rings; ++k) radius.push_back(grid.middle_radius(k));
  for (int a = 0; a < grid.angles; ++a) angle.push_back(grid.middle_angle(a) / kDegree);
  std::vector<double> ring = shape.ring_fraction;
  ring.resize(angles, 0);
  const std::vector<TableColumn> map = {
      table_column<double>({"solid_fraction", "1", "mean, rings x angles"}, shape.fraction, angles),
      table_column<std::uint8_t>({"bulk", "1", "1: of the bulk, rings x angles"}, shape.bulk,
                                 angles),
      table_column<double>({"radius", "m", "middle of each ring of cells"}, radius),
      table_column<double>({"angle", "deg", "middle of each cell, counterclockwise from +x"},
                           angle),
      table_column<double>({"ring_fraction", "1", "solid fraction inside the lifters' tops"},
                           ring)};
  series.write_table("charge_map", map);
  const std::vector<double> shoulder = in_degrees(in_blocks_.shoulder),
                            toe = in_degrees(in_blocks_.toe);
  const std::vector<TableColumn> blocks = {
      table_column<double>({"shoulder", "deg", "of each block of snapshots"}, shoulder),
      table_column<double>({"toe", "deg", "of each block of snapshots"}, toe)};
  series.write_table("charge_blocks", blocks);
}

void ChargeRecorder::write_picture(const std::string& path) const {
  if (snapshots_ <= 0) return;
  write_text_file("picture", path, charge_svg(picture_), Durability::kKill);
}

std::string ChargeRecorder::line() const {
  if (!std::isfinite(shoulder_.value)) return "no snapshot of a bulk yet";
  const auto text = [](const Angle& angle) {
    return fmt::format("{:.1f} +- {:.1f} deg", angle.value / kDegree, angle.error / kDegree);
  };
  return fmt::format("shoulder {}, toe {} (charge_shape.svg)", text(shoulder_),
                     std::isfinite(toe_.value) ? text(toe_) : "none");
}

}  // namespace quern
