// Depositing on the polar map. The angles are found in charge_shape.cpp.
//
// The shadow of a sphere holds volume in proportion to its chords: within radius s of the middle
// lies the share 1 - (1 - s^2/r^2)^(3/2). Patch k of n sits at the share (k + 1/2) / n, turned from
// the last by the golden angle, which spreads any number of patches evenly (Vogel 1979). A patch is
// as wide as a square of the n-th part of the shadow.
#include "kernels/charge_map.h"

#include <algorithm>
#include <cmath>

namespace quern {
namespace {

constexpr double kTurn = 2 * kPi;
constexpr double kGoldenAngle = 2.39996322972865332;  // 2 pi (1 - 1 / golden ratio)

double volume_of(double radius) { return 4.0 / 3.0 * kPi * radius * radius * radius; }

// Where a patch lies and what it carries.
struct Patch {
  double radius, angle;  // of its middle, about the mill's axis
  double width;          // m, in both directions
  double volume;
  const float* amount;  // of its sphere, as many as the map counts
};

// The part of a row of cells that a patch covers, in units of cells.
struct Span {
  double low, high;
};

void share_ring(const Span& around, double volume, const float* amount, int ring,
                ChargeMap& map) noexcept {
  const int angles = map.grid.angles;
  const double scale = volume / (around.high - around.low);
  const int first = static_cast<int>(std::floor(around.low));
  const int end = static_cast<int>(std::ceil(around.high));
  for (int at = first; at < end; ++at) {
    const double part = std::min(at + 1.0, around.high) - std::max(double(at), around.low);
    const std::size_t cell = map.grid.cell(ring, ((at % angles) + angles) % angles);
    map.volume[cell] += part * scale;
    for (std::size_t k = 0; k < map.amounts; ++k) {
      map.carried[cell * map.amounts + k] += part * scale * static_cast<double>(amount[k]);
    }
  }
}

void share(const Patch& patch, ChargeMap& map) noexcept {
  const PolarGrid& grid = map.grid;
  const double half = 0.5 * patch.width, most = 0.5 * grid.angles;
  const double turned = patch.radius * kPi > half ? half / patch.radius / grid.angle_step() : most;
  const double middle = patch.angle / grid.angle_step();
  const Span around = {middle - turned, middle + turned};
  const double high = std::min(patch.radius + half, grid.radius) / grid.ring_width();
  const double low = std::max(patch.radius - half, 0.0) / grid.ring_width();
  if (low >= high) return share_ring(around, patch.volume, patch.amount, grid.rings - 1, map);
  const double scale = patch.volume / (high * high - low * low);  // by area
  const int last = std::min(static_cast<int>(high), grid.rings - 1);
  for (int ring = std::min(static_cast<int>(low), last); ring <= last; ++ring) {
    const double from = std::max(low, double(ring));
    const double to = ring == last ? high : std::min(high, ring + 1.0);
    if (to > from) share_ring(around, (to * to - from * from) * scale, patch.amount, ring, map);
  }
}

// So many that a patch is narrower than half a cell along the radius, and no sphere is coarse.
int patches_of(double radius, double ring_width) {
  constexpr double kFewest = 16, kMost = 4096;
  const double cells = 2 * radius / ring_width;
  return static_cast<int>(std::clamp(4 * cells * cells, kFewest, kMost));
}

}  // namespace

double median_diameter(std::span<const float> radius) {
  if (radius.empty()) return 0;
  std::vector<float> sorted(radius.begin(), radius.end());
  std::sort(sorted.begin(), sorted.end());
  double all = 0, below = 0;
  for (const float r : sorted) all += volume_of(r);
  for (const float r : sorted) {
    below += volume_of(r);
    if (below >= 0.5 * all) return 2 * static_cast<double>(r);
  }
  return 2 * static_cast<double>(sorted.back());
}

PolarGrid choose_polar_grid(double shell_radius, double d50, double cell_angle, double cell_width) {
  QUERN_CHECK(shell_radius > 0 && (d50 > 0 || (cell_angle > 0 && cell_width > 0)));
  constexpr double kChoices[] = {1, 2, 4, 6, 10};
  constexpr double kDegree = kPi / 180;
  const double width = cell_width > 0 ? cell_width : 0.5 * d50;
  if (cell_angle <= 0) {
    const auto fits = [&](double choice) { return shell_radius * choice * kDegree >= width; };
    const auto* found = std::find_if(std::begin(kChoices), std::end(kChoices) - 1, fits);
    cell_angle = *found * kDegree;
  }
  PolarGrid grid;
  grid.angles = std::max(4, 2 * static_cast<int>(std::lround(kPi / cell_angle)));
  grid.rings = std::max(2, static_cast<int>(std::lround(shell_radius / width)));
  grid.radius = shell_radius;
  return grid;
}

ChargeMap make_charge_map(const PolarGrid& grid, double length, std::size_t amounts) {
  QUERN_CHECK(grid.angles >= 4 && grid.angles % 2 == 0 && grid.rings >= 2 && length > 0);
  ChargeMap map;
  map.grid = grid;
  map.length = length;
  map.volume.assign(grid.cells(), 0);
  map.amounts = amounts;
  map.carried.assign(grid.cells() * amounts, 0);
  return map;
}

void deposit(std::span<const double> position, std::span<const float> radius,
             std::span<const float> amount, ChargeMap& map) noexcept {
  const double ring_width = map.grid.ring_width();
  const double c = std::cos(kGoldenAngle), s = std::sin(kGoldenAngle);
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double r = radius[i];
    const int n = patches_of(r, ring_width);
    Patch patch{0, 0, r * std::sqrt(kPi / n), volume_of(r) / n, amount.data() + i * map.amounts};
    double x = 1, y = 0;
    for (int k = 0; k < n; ++k) {
      const double rest = std::cbrt(1 - (k + 0.5) / n);
      const double out = r * std::sqrt(1 - rest * rest);
      const double px = position[3 * i] + out * x, py = position[3 * i + 1] + out * y;
      patch.radius = std::hypot(px, py);
      patch.angle = std::atan2(py, px);
      share(patch, map);
      const double turned = c * x - s * y;
      y = s * x + c * y;
      x = turned;
    }
  }
  map.snapshots += 1;
}

void add_snapshots(const ChargeMap& from, ChargeMap& to) noexcept {
  for (std::size_t k = 0; k < to.volume.size(); ++k) to.volume[k] += from.volume[k];
  for (std::size_t k = 0; k < to.carried.size(); ++k) to.carried[k] += from.carried[k];
  to.snapshots += from.snapshots;
}

namespace {

// `value(cell)` is a volume summed over snapshots.
template <class Value>
std::vector<double> over_space(const ChargeMap& map, const Value& value) {
  std::vector<double> fraction(map.volume.size(), 0);
  if (map.snapshots <= 0) return fraction;
  const PolarGrid& grid = map.grid;
  for (int ring = 0; ring < grid.rings; ++ring) {
    const double scale = 1 / (grid.area(ring) * map.length * map.snapshots);
    for (int a = 0; a < grid.angles; ++a) {
      fraction[grid.cell(ring, a)] = value(grid.cell(ring, a)) * scale;
    }
  }
  return fraction;
}

}  // namespace

std::vector<double> solid_fraction(const ChargeMap& map) {
  return over_space(map, [&](std::size_t cell) { return map.volume[cell]; });
}

std::vector<double> solid_fraction_carrying(const ChargeMap& map, std::size_t amount) {
  QUERN_CHECK(amount < map.amounts);
  return over_space(map,
                    [&](std::size_t cell) { return map.carried[cell * map.amounts + amount]; });
}

std::vector<double> mean_amount(const ChargeMap& map, std::size_t amount) {
  QUERN_CHECK(amount < map.amounts);
  std::vector<double> mean(map.volume.size(), 0);
  for (std::size_t cell = 0; cell < mean.size(); ++cell) {
    if (map.volume[cell] > 0) {
      mean[cell] = map.carried[cell * map.amounts + amount] / map.volume[cell];
    }
  }
  return mean;
}

double dynamic_angle(double x, double y, const ChargeQuery& query) noexcept {
  return angle_near(query.direction * (std::atan2(y, x) - query.up - kPi), 0);
}

double principal_angle(double angle) noexcept {
  return angle - kTurn * std::floor((angle + 0.5 * kPi) / kTurn);
}

double angle_near(double angle, double reference) noexcept {
  return angle - kTurn * std::round((angle - reference) / kTurn);
}

}  // namespace quern
