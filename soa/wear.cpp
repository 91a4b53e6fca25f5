#include "soa/wear.h"

#include <algorithm>
#include <cmath>

namespace quern {

namespace {

// Pieces of at most `size`; a length that is a multiple of it to rounding is that many.
double pieces(double length, double size) {
  return std::max(1.0, std::ceil(length / size * (1 - 1e-9)));
}

Vec3 corner_of(const Facets& facets, Index facet, Index k) {
  return facets.vertex[facets.corner[3 * facet + k % 3]];
}

std::uint8_t apex_of(const Facets& facets, Index facet) {
  std::uint8_t apex = 0;
  double shortest = HUGE_VAL;
  for (std::uint8_t k = 0; k < 3; ++k) {
    const double side =
        (corner_of(facets, facet, k + 1u) - corner_of(facets, facet, k + 2u)).norm();
    if (side < shortest * (1 - 1e-9)) {
      shortest = side;
      apex = k;
    }
  }
  return apex;
}

}  // namespace

WearGrid::Sides WearGrid::sides(const Facets& facets, Index facet) const {
  const Index k = apex_[facet];
  const Vec3 a = corner_of(facets, facet, k);
  return {a, corner_of(facets, facet, k + 1) - a, corner_of(facets, facet, k + 2) - a};
}

WearGrid::WearGrid(const Facets& facets, double size, Index first_cell) {
  double cell = first_cell;
  for (Index t = 0; t < facets.triangles(); ++t) {
    apex_.push_back(apex_of(facets, t));
    const Sides s = sides(facets, t);
    const double bb = s.b.squaredNorm(), bc = s.b.dot(s.c), cc = s.c.squaredNorm();
    const double determinant = bb * cc - bc * bc;
    const double width = (s.c - s.b).norm(), count = pieces(std::max(s.b.norm(), s.c.norm()), size);
    const Index first = static_cast<Index>(strip_cell_.size());
    for (double k = 0; k < count && cell < kMostWearCells; ++k) {
      strip_cell_.push_back(static_cast<Index>(cell));
      cell += (k == 0 ? 1 : 2) * pieces(width * (k + 1) / count, size);
    }
    if (cell >= kMostWearCells) {
      throw UserError("wear.cell_size: the walls have more than 2e7 cells; choose a larger one");
    }
    cuts_.push_back({s.apex, (cc * s.b - bc * s.c) / determinant,
                     (bb * s.c - bc * s.b) / determinant, first,
                     static_cast<Index>(strip_cell_.size()) - first});
  }
  strip_cell_.push_back(static_cast<Index>(cell));
}

WearGrid::Spot WearGrid::spot_at(const Cut& cut, const Vec3& x) const noexcept {
  const Vec3 d = x - cut.apex;
  const double along_b = d.dot(cut.to_b), along_c = d.dot(cut.to_c);
  Spot at;
  at.down = std::clamp(along_b + along_c, 0.0, 1.0);
  at.across = at.down > 0 ? std::clamp(along_c / at.down, 0.0, 1.0) : 0.0;
  at.strips = cut.strips;
  at.row = std::min(static_cast<Index>(at.down * cut.strips), cut.strips - 1);
  const Index strip = cut.first_strip + at.row;
  at.first = strip_cell_[strip];
  const Index cells = strip_cell_[strip + 1] - at.first;
  at.columns = at.row == 0 ? cells : cells / 2;
  at.column = std::min(static_cast<Index>(at.across * at.columns), at.columns - 1);
  return at;
}

double WearGrid::room_around(const Cut& cut, const Spot& at) const noexcept {
  if (!(at.down > 0 && at.down < 1 && at.across > 0 && at.across < 1)) return 0;
  const Vec3 to_down = cut.to_b + cut.to_c;
  const double along_c = at.down * at.across, upper = at.upper(), lower = at.lower();
  const double left = double(at.column) / at.columns, right = double(at.column + 1) / at.columns;
  double room = std::min(at.down - upper, lower - at.down) / to_down.norm();
  room = std::min(room, (along_c - left * at.down) / (cut.to_c - left * to_down).norm());
  room = std::min(room, (right * at.down - along_c) / (cut.to_c - right * to_down).norm());
  if (at.row > 0) {
    const Vec3 across = (at.end() - at.begin()) * to_down - (lower - upper) * cut.to_c;
    room = std::min(room, std::abs(at.beyond_diagonal()) / across.norm());
  }
  return std::max(0.0, room * (1 - 1e-9));
}

Index WearGrid::cell_at(Index facet, const Vec3& x) const noexcept {
  return spot_at(cuts_[facet], x).cell();
}

Index WearGrid::cell_at(Index facet, const Vec3& x, double& room) const noexcept {
  const Spot at = spot_at(cuts_[facet], x);
  room = room_around(cuts_[facet], at);
  return at.cell();
}

void WearGrid::append_cells(const Facets& facets, Index body, std::vector<WearCell>& out) const {
  for (Index t = 0; t < facets.triangles(); ++t) {
    const Sides s = sides(facets, t);
    const Index count = cuts_[t].strips;
    for (Index k = 0; k < count; ++k) {
      const Index strip = cuts_[t].first_strip + k;
      const Index cells = strip_cell_[strip + 1] - strip_cell_[strip];
      const Index columns = k == 0 ? cells : cells / 2;
      const auto at = [&](Index row, Index column) {
        const double u = double(row) / count, v = double(column) / columns;
        return Vec3(s.apex + u * ((1 - v) * s.b + v * s.c));
      };
      for (Index c = 0; c < columns; ++c) {
        out.push_back({{at(k, c), at(k + 1, c), at(k + 1, c + 1)}, t, body});
        if (k > 0) out.push_back({{at(k, c), at(k + 1, c + 1), at(k, c + 1)}, t, body});
      }
    }
  }
}

void Wear::clear(std::size_t walls_of_scene, std::size_t species_of_scene) {
  if (!asked()) {  // what another run has left goes
    for (Column<double>* rows : {&cells, &walls, &species, &time}) rows->release();
    return;
  }
  cells.reset(cell_count() * kWearSums);
  walls.reset(walls_of_scene * kWearSums);
  species.reset(species_of_scene * kWearSums);
  time.reset(1);
  for (Column<double>* rows : {&cells, &walls, &species, &time}) rows->fill(0);
}

void Wear::add(std::span<const WearEntry> entries) {
  using Row = Eigen::Array<double, kWearSums, 1>;
  for (const WearEntry& entry : entries) {
    const Row sum = Eigen::Map<const Row>(entry.sum.data());
    const auto add_to = [&](Column<double>& rows, std::size_t row) {
      Eigen::Map<Row>(rows.data() + row * kWearSums) += sum;
    };
    add_to(cells, entry.cell);
    add_to(walls, entry.wall);
    add_to(species, entry.species);
  }
}

void Wear::prefetch(std::span<const WearEntry> entries) const {
  for (const WearEntry& entry : entries) {
    const double* row = cells.data() + std::size_t{entry.cell} * kWearSums;
    __builtin_prefetch(row, 1);
    __builtin_prefetch(row + kWearSums - 1, 1);
  }
}

WearRow Wear::total_of(const Column<double>& rows, std::size_t row) const {
  WearRow sum;
  std::copy_n(rows.data() + row * kWearSums, std::size_t{kWearSums}, sum.begin());
  return sum;
}

}  // namespace quern
