#include "kernels/charge_angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/charge_map.h"
#include "kernels/liner_histogram.h"

namespace quern {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kLowCut = 0.4, kHighCut = 0.6;

struct Scatter {
  double count = 0, deviation = kUnknown;
};

Scatter scatter_of(double value, std::span<const double> found) {
  if (!std::isfinite(value)) return {};
  double count = 0, sum = 0, squares = 0;
  for (const double angle : found) {
    if (!std::isfinite(angle)) continue;
    const double from_value = angle_near(angle, value) - value;
    count += 1;
    sum += from_value;
    squares += from_value * from_value;
  }
  if (count < 2) return {count, kUnknown};
  return {count, std::sqrt(std::max(squares - sum * sum / count, 0.0) / (count - 1))};
}

FoundAngles found_in(const ChargeShape& shape, const LinerHistogram& liner,
                     const ChargeQuery& query) {
  FoundAngles found{kUnknown, kUnknown, kUnknown, kUnknown};
  if (shape.found) found.shoulder = shape.shoulder;
  if (shape.toe_found) found.toe = shape.bulk_toe;
  if (liner.empty() || !shape.toe_found) return found;
  const LinerAngles angles = find_liner_angles(liner, shape, query);
  if (angles.head_found) found.head = angles.head;
  found.impact_toe = angles.impact_toe;
  return found;
}

ChargeMap sum_of(std::span<const ChargeMap> maps) {
  ChargeMap all = maps[0];
  for (const ChargeMap& map : maps.subspan(1)) add_snapshots(map, all);
  return all;
}

LinerHistogram sum_of(std::span<const LinerHistogram> liner) {
  if (liner.empty()) return {};
  LinerHistogram all = liner[0];
  for (const LinerHistogram& block : liner.subspan(1)) add_liner(block, all);
  return all;
}

bool felt_something(const LinerHistogram& liner) {
  return std::any_of(liner.contact_time.begin(), liner.contact_time.end(),
                     [](double time) { return time > 0; });
}

// What each block shows.
std::vector<FoundAngles> blocks_of(std::span<const ChargeMap> maps,
                                   std::span<const LinerHistogram> liner, const ChargeShape& whole,
                                   const ChargeQuery& query) {
  const bool same =
      maps.size() == liner.size() && std::all_of(liner.begin(), liner.end(), felt_something);
  std::vector<FoundAngles> blocks(std::max(maps.size(), liner.size()),
                                  FoundAngles{kUnknown, kUnknown, kUnknown, kUnknown});
  for (std::size_t k = 0; k < maps.size(); ++k) {
    blocks[k] =
        found_in(find_charge_shape(maps[k], query), same ? liner[k] : LinerHistogram(), query);
  }
  for (std::size_t k = 0; k < liner.size() && !same; ++k) {
    if (!felt_something(liner[k])) continue;
    const FoundAngles found = found_in(whole, liner[k], query);
    blocks[k].head = found.head;
    blocks[k].impact_toe = found.impact_toe;
  }
  return blocks;
}

AngleFigure figure(double FoundAngles::*angle, const FoundAngles& whole, const FoundAngles& low,
                   const FoundAngles& high, const std::vector<FoundAngles>& blocks) {
  if (!std::isfinite(whole.*angle)) return {kUnknown, kUnknown, kUnknown, kUnknown};
  std::vector<double> found;
  for (const FoundAngles& block : blocks) found.push_back(block.*angle);
  return {whole.*angle, angle_error(whole.*angle, found), low.*angle, high.*angle};
}

}  // namespace

double angle_spread(double value, std::span<const double> found) {
  return scatter_of(value, found).deviation;
}

double angle_error(double value, std::span<const double> found) {
  const Scatter scatter = scatter_of(value, found);
  return scatter.deviation / std::sqrt(scatter.count);
}

ChargeAngles find_charge_angles(std::span<const ChargeMap> maps,
                                std::span<const LinerHistogram> liner, const ChargeQuery& query) {
  QUERN_CHECK(!maps.empty());
  const ChargeMap all = sum_of(maps);
  const LinerHistogram felt = sum_of(liner);
  ChargeAngles angles;
  angles.shape = find_charge_shape(all, query);
  angles.liner_known = felt_something(felt);
  if (angles.liner_known) {
    angles.impacts_found = find_liner_angles(felt, angles.shape, query).impacts_found;
  } else {
    liner = {};
  }
  angles.blocks = blocks_of(maps, liner, angles.shape, query);
  const auto cut_at = [&](double cut) {
    ChargeQuery other = query;
    other.cut = cut;
    return found_in(find_charge_shape(all, other), angles.liner_known ? felt : LinerHistogram(),
                    other);
  };
  const FoundAngles low = cut_at(kLowCut), high = cut_at(kHighCut);
  const FoundAngles whole =
      found_in(angles.shape, angles.liner_known ? felt : LinerHistogram(), query);
  angles.shoulder = figure(&FoundAngles::shoulder, whole, low, high, angles.blocks);
  angles.toe = figure(&FoundAngles::toe, whole, low, high, angles.blocks);
  angles.head = figure(&FoundAngles::head, whole, low, high, angles.blocks);
  angles.impact_toe = figure(&FoundAngles::impact_toe, whole, low, high, angles.blocks);
  if (angles.liner_known && !angles.impacts_found) angles.impact_toe = angles.toe;
  return angles;
}

}  // namespace quern
