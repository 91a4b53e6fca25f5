// Levels, cells and periodic axes of the set-up grid; the query itself is in the header.
#include "scheduler/sphere_grid.h"

#include <algorithm>
#include <bit>

namespace quern {
namespace {

constexpr std::size_t kMostLevels = 24;
constexpr std::size_t kSmallestTable = 64;

std::size_t level_for(double radius, double largest) {
  std::size_t level = 0;
  for (double r = 0.5 * largest; radius <= r && level + 1 < kMostLevels; r *= 0.5) ++level;
  return level;
}

// std::floor is a call where the baseline instruction set has no rounding.
std::int64_t floor_cell(double x) {
  const auto cell = static_cast<std::int64_t>(x);
  return cell - (x < static_cast<double>(cell) ? 1 : 0);
}

}  // namespace

PeriodicAxes periodic_axes(const Scene& scene) {
  PeriodicAxes axes;
  const DomainSpec& domain = scene.domain;
  for (int a = 0; a < 3; ++a) {
    if (!domain.periodic[a]) continue;
    const bool from_mill = a == 2 && scene.mill && scene.mill->ends == EndKind::kPeriodic;
    if (from_mill) continue;
    if (!domain.low || !domain.high || !((*domain.high)[a] > (*domain.low)[a])) {
      throw UserError("domain: a periodic axis needs low and high, low below high");
    }
    axes.on[static_cast<std::size_t>(a)] = true;
    axes.low[a] = (*domain.low)[a];
    axes.length[a] = (*domain.high)[a] - (*domain.low)[a];
  }
  if (scene.mill && scene.mill->ends == EndKind::kPeriodic) {
    axes.on[2] = true;
    axes.low[2] = 0;
    axes.length[2] = scene.mill->length;
  }
  return axes;
}

SphereGrid::SphereGrid(const PeriodicAxes& periodic, std::span<const double> radii)
    : periodic_(periodic) {
  if (radii.empty()) return;
  const double largest = *std::max_element(radii.begin(), radii.end());
  QUERN_CHECK(largest > 0);
  std::vector<std::size_t> count(kMostLevels, 0);
  for (const double r : radii) ++count[level_for(r, largest)];
  while (count.back() == 0) count.pop_back();
  for (std::size_t l = 0; l < count.size(); ++l) {
    Level level;
    level.max_radius = std::ldexp(largest, -static_cast<int>(l));
    level.inverse_cell.setConstant(0.5 / level.max_radius);
    for (std::size_t a = 0; a < 3; ++a) {
      if (!periodic_.on[a]) continue;
      const double length = periodic_.length[static_cast<int>(a)];
      level.around[a] = std::max<std::int64_t>(
          1, static_cast<std::int64_t>(std::floor(length * 0.5 / level.max_radius)));
      level.inverse_cell[static_cast<int>(a)] = static_cast<double>(level.around[a]) / length;
    }
    level.bucket.assign(std::bit_ceil(std::max(kSmallestTable, 2 * count[l])), kNoIndex);
    levels_.push_back(std::move(level));
  }
  entries_.reserve(radii.size());
}

std::size_t SphereGrid::level_of(double radius) const {
  QUERN_CHECK(!levels_.empty() && radius <= levels_.front().max_radius);
  return std::min(level_for(radius, levels_.front().max_radius), levels_.size() - 1);
}

SphereGrid::CellRange SphereGrid::cells_within(const Level& level, const Vec3& x,
                                               double reach) const {
  CellRange range;
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    const double origin = periodic_.on[a] ? periodic_.low[axis] : 0.0;
    const double scale = level.inverse_cell[axis];
    range.from[a] = floor_cell((x[axis] - reach - origin) * scale);
    range.to[a] = floor_cell((x[axis] + reach - origin) * scale);
    const std::int64_t n = level.around[a];
    if (n > 0 &&
        (range.to[a] - range.from[a] + 1 >= n || range.from[a] < -n || range.to[a] >= 2 * n)) {
      range.from[a] = 0;
      range.to[a] = n - 1;
    }
  }
  return range;
}

void SphereGrid::insert(const Vec3& position, double radius, Index tag) {
  const Vec3 x = periodic_.wrapped(position);
  Level& level = levels_[level_of(radius)];
  const CellRange cell = cells_within(level, x, 0);
  std::uint64_t hash = 0;
  for (std::size_t a = 0; a < 3; ++a) hash ^= hash_axis(level, a, cell.from[a]);
  Index& head = level.bucket[hash & (level.bucket.size() - 1)];
  entries_.push_back({x, radius, tag, head});
  head = static_cast<Index>(entries_.size() - 1);
  ++level.count;
}

}  // namespace quern
