// The angles of the charge, read off the map of solid fraction and off what the liner felt.
//
// Definitions are in charge_map.h. The bulk is connected through the sides of cells, around the
// full turn and across the axis. So each side of the bulk is a crossing of the cut, and its place
// between the middles of the two cells follows from their solid fractions.
#include <algorithm>
#include <cmath>

#include "kernels/charge_map.h"

namespace quern {
namespace {

constexpr double kTurn = 2 * kPi;

double turned(double angle) { return angle - kTurn * std::floor(angle / kTurn); }

int around(const PolarGrid& grid, int angle) {
  return (angle % grid.angles + grid.angles) % grid.angles;
}

double percentile_of_filled(const std::vector<double>& fraction, double share) {
  std::vector<double> filled;
  for (const double f : fraction)
    if (f > 0) filled.push_back(f);
  if (filled.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(filled.size() - 1));
  std::nth_element(filled.begin(), filled.begin() + at, filled.end());
  return filled[static_cast<std::size_t>(at)];
}

// Of the 9 cells around each, 6 beside the axis and the shell.
std::vector<double> median_3x3(const PolarGrid& grid, const std::vector<double>& fraction) {
  std::vector<double> smooth(fraction.size()), near;
  for (int ring = 0; ring < grid.rings; ++ring) {
    for (int a = 0; a < grid.angles; ++a) {
      near.clear();
      for (int k = std::max(ring - 1, 0); k <= std::min(ring + 1, grid.rings - 1); ++k)
        for (int b = a - 1; b <= a + 1; ++b)
          near.push_back(fraction[grid.cell(k, around(grid, b))]);
      std::sort(near.begin(), near.end());
      smooth[grid.cell(ring, a)] = 0.5 * (near[(near.size() - 1) / 2] + near[near.size() / 2]);
    }
  }
  return smooth;
}

// A cell by ring and angle; ring = rings: beyond the shell.
struct Cell {
  int ring, angle;
};

// The neighbour on side 0 ... 3: clockwise, counterclockwise, inwards, outwards.
Cell beside(const PolarGrid& grid, const Cell& cell, int side) {
  if (side == 0) return {cell.ring, around(grid, cell.angle - 1)};
  if (side == 1) return {cell.ring, around(grid, cell.angle + 1)};
  if (side == 3) return {cell.ring + 1, cell.angle};
  if (cell.ring > 0) return {cell.ring - 1, cell.angle};
  return {0, around(grid, cell.angle + grid.angles / 2)};
}

// Gives the cells connected to `start` its label and returns their area.
double flood(const PolarGrid& grid, const std::vector<double>& smooth, double cut,
             const Cell& start, std::vector<int>& label) {
  const int mark = label[grid.cell(start.ring, start.angle)];
  std::vector<Cell> open = {start};
  double area = 0;
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    area += grid.area(cell.ring);
    for (int side = 0; side < 4; ++side) {
      const Cell next = beside(grid, cell, side);
      if (next.ring == grid.rings) continue;
      const std::size_t at = grid.cell(next.ring, next.angle);
      if (label[at] != 0 || smooth[at] < cut) continue;
      label[at] = mark;
      open.push_back(next);
    }
  }
  return area;
}

std::vector<std::uint8_t> largest_set(const PolarGrid& grid, const std::vector<double>& smooth,
                                      double cut) {
  std::vector<int> label(smooth.size(), 0);
  int labels = 0, best = -1;
  double best_area = 0;
  for (int ring = 0; ring < grid.rings; ++ring) {
    for (int a = 0; a < grid.angles; ++a) {
      const std::size_t at = grid.cell(ring, a);
      if (label[at] != 0 || smooth[at] < cut) continue;
      label[at] = ++labels;
      const double area = flood(grid, smooth, cut, {ring, a}, label);
      if (area <= best_area) continue;
      best_area = area;
      best = labels;
    }
  }
  std::vector<std::uint8_t> set(smooth.size());
  for (std::size_t k = 0; k < set.size(); ++k) set[k] = label[k] == best ? 1 : 0;
  return set;
}

struct HighPoint {
  bool found = false;
  double angle = 0, radius = 0;
};

// The highest crossing of the cut on the bulk's sides.
HighPoint highest_point(const PolarGrid& grid, const std::vector<double>& smooth, double cut,
                        const std::vector<std::uint8_t>& bulk, double up) {
  HighPoint best;
  double highest = -2 * grid.radius;
  for (int ring = 0; ring < grid.rings; ++ring) {
    for (int a = 0; a < grid.angles; ++a) {
      const std::size_t at = grid.cell(ring, a);
      if (bulk[at] == 0) continue;
      for (int side = 0; side < 4; ++side) {
        const Cell next = beside(grid, {ring, a}, side);
        if (next.ring == grid.rings || (side == 2 && ring == 0)) continue;
        const std::size_t other = grid.cell(next.ring, next.angle);
        if (bulk[other] != 0) continue;
        const double t = (smooth[at] - cut) / (smooth[at] - smooth[other]);
        const double steps = side == 0 ? -t : side == 1 ? t : 0;
        const double rings = side == 2 ? -t : side == 3 ? t : 0;
        const double angle = grid.middle_angle(a) + steps * grid.angle_step();
        const double radius = grid.middle_radius(ring) + rings * grid.ring_width();
        const double height = radius * std::cos(angle - up);
        if (height <= highest) continue;
        highest = height;
        best = {true, principal_angle(angle), radius};
      }
    }
  }
  return best;
}

// Share of each ring of cells that lies in the ring of the toe.
std::vector<double> toe_ring(const PolarGrid& grid, const ChargeQuery& query) {
  const double high = grid.radius - query.lifter_height, low = high - 2 * query.particle_size;
  std::vector<double> share(static_cast<std::size_t>(grid.rings), 0);
  for (int ring = 0; ring < grid.rings; ++ring) {
    const double from = std::max(low, ring * grid.ring_width());
    const double to = std::min(high, (ring + 1) * grid.ring_width());
    if (to > from) share[static_cast<std::size_t>(ring)] = (to - from) / grid.ring_width();
  }
  return share;
}

// The angle cell in which the bulk's area is centred.
int middle_of_bulk(const PolarGrid& grid, const ChargeShape& shape) {
  double x = 0, y = 0;
  for (int ring = 0; ring < grid.rings; ++ring) {
    for (int a = 0; a < grid.angles; ++a) {
      if (shape.bulk[grid.cell(ring, a)] == 0) continue;
      const double weight = grid.area(ring) * grid.middle_radius(ring);
      x += weight * std::cos(grid.middle_angle(a));
      y += weight * std::sin(grid.middle_angle(a));
    }
  }
  return around(grid, static_cast<int>(turned(std::atan2(y, x)) / grid.angle_step()));
}

// Upstream from the middle of the bulk as long as the ring holds some of it: the last crossing.
void find_toe(const PolarGrid& grid, double cut, const ChargeQuery& query, ChargeShape& shape) {
  const std::vector<double> share = toe_ring(grid, query);
  const auto count = static_cast<std::size_t>(grid.angles);
  std::vector<std::uint8_t> holds_bulk(count, 0);
  shape.ring_fraction.assign(count, 0);
  double area = 0;
  for (int ring = 0; ring < grid.rings; ++ring) {
    const double weight = share[static_cast<std::size_t>(ring)] * grid.area(ring);
    if (weight <= 0) continue;
    area += weight;
    for (std::size_t a = 0; a < count; ++a) {
      const std::size_t at = grid.cell(ring, static_cast<int>(a));
      shape.ring_fraction[a] += weight * shape.fraction[at];
      holds_bulk[a] |= shape.bulk[at];
    }
  }
  if (area <= 0) return;
  for (double& f : shape.ring_fraction) f /= area;
  const int step = query.direction > 0 ? -1 : 1, start = middle_of_bulk(grid, shape);
  for (int k = 0; k < grid.angles; ++k) {
    const auto a = static_cast<std::size_t>(around(grid, start + k * step));
    if (holds_bulk[a] == 0) return;
    const auto b = static_cast<std::size_t>(around(grid, start + (k + 1) * step));
    const double here = shape.ring_fraction[a], next = shape.ring_fraction[b];
    if (here < cut || next >= cut) continue;
    const double t = (here - cut) / (here - next);
    shape.bulk_toe =
        principal_angle(grid.middle_angle(static_cast<int>(a)) + t * step * grid.angle_step());
    shape.toe_found = true;
  }
  shape.toe_found = false;  // the bulk goes all around
}

}  // namespace

ChargeShape find_charge_shape(const ChargeMap& map, const ChargeQuery& query) {
  constexpr double kBedShare = 0.9;
  ChargeShape shape;
  shape.fraction = solid_fraction(map);
  shape.bed_fraction = percentile_of_filled(shape.fraction, kBedShare);
  shape.bulk.assign(shape.fraction.size(), 0);
  if (shape.bed_fraction <= 0) return shape;
  const double cut = query.cut * shape.bed_fraction;
  const std::vector<double> smooth = median_3x3(map.grid, shape.fraction);
  shape.bulk = largest_set(map.grid, smooth, cut);
  const HighPoint top = highest_point(map.grid, smooth, cut, shape.bulk, query.up);
  shape.found = top.found;
  shape.shoulder = top.angle;
  shape.shoulder_radius = top.radius;
  if (!shape.found) return shape;
  find_toe(map.grid, cut, query, shape);
  return shape;
}

namespace {

// Bins of the liner seen from the bulk toe; distances in rad.
struct BareLiner {
  int bins;
  double step, direction, toe;
  double length;  // from the shoulder downstream to the toe

  double angle(int bin) const { return (bin + 0.5) * step; }
  double downstream(int bin) const { return turned(direction * (angle(bin) - toe)); }
};

void find_head(const std::vector<double>& time, const BareLiner& bare, LinerAngles& found) {
  constexpr double kLeast = 0.02;
  const double cut = kLeast * *std::max_element(time.begin(), time.end());
  if (cut <= 0) return;
  const double last = kTurn - 0.5 * bare.length;
  double farthest = -1;
  for (int bin = 0; bin < bare.bins; ++bin) {
    const double here = time[static_cast<std::size_t>(bin)], way = bare.downstream(bin);
    if (here < cut || way > last || way <= farthest) continue;
    farthest = way;
    const int next_bin = (bin + (bare.direction > 0 ? 1 : bare.bins - 1)) % bare.bins;
    const double next = time[static_cast<std::size_t>(next_bin)];
    const double t = next < cut ? (here - cut) / (here - next) : 0.5;
    found.head = bare.angle(bin) + bare.direction * t * bare.step;
    found.head_found = true;
  }
  found.head = principal_angle(found.head);
}

void find_impact_toe(const std::vector<double>& hits, const BareLiner& bare, LinerAngles& found) {
  constexpr double kShare = 0.95;
  const auto upstream = [&](int bin) { return kTurn - bare.downstream(bin); };
  int first = 0;  // the bin next to the toe
  double all = 0;
  for (int bin = 0; bin < bare.bins; ++bin) {
    if (upstream(bin) < upstream(first)) first = bin;
    if (upstream(bin) <= bare.length) all += hits[static_cast<std::size_t>(bin)];
  }
  found.impact_toe = bare.toe;
  if (all <= 0) return;
  double below = 0;
  for (int k = 0; k < bare.bins; ++k) {
    const int bin = ((bare.direction > 0 ? first - k : first + k) + bare.bins) % bare.bins;
    const double here = hits[static_cast<std::size_t>(bin)];
    if (here <= 0 || upstream(bin) > bare.length) continue;
    if (below + here >= kShare * all) {
      const double way = upstream(bin) + ((kShare * all - below) / here - 0.5) * bare.step;
      found.impact_toe = principal_angle(bare.toe - bare.direction * std::max(way, 0.0));
      found.impacts_found = true;
      return;
    }
    below += here;
  }
}

}  // namespace

LinerAngles find_liner_angles(const LinerHistogram& liner, const ChargeShape& shape,
                              const ChargeQuery& query) {
  LinerAngles found;
  if (!shape.found || !shape.toe_found || liner.contact_time.empty()) return found;
  QUERN_CHECK(liner.contact_time.size() == liner.hit_dissipation.size());
  BareLiner bare{};
  bare.bins = static_cast<int>(liner.contact_time.size());
  bare.step = kTurn / bare.bins;
  bare.direction = query.direction > 0 ? 1 : -1;
  bare.toe = shape.bulk_toe;
  bare.length = turned(bare.direction * (shape.bulk_toe - shape.shoulder));
  find_head(liner.contact_time, bare, found);
  find_impact_toe(liner.hit_dissipation, bare, found);
  return found;
}

}  // namespace quern
