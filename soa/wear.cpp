#include "soa/wear.h"

#include <algorithm>
#include <cmath>

namespace quern {

namespace {

constexpr std::size_t kEntriesAhead = 8;

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
    facet_strip_.push_back(static_cast<Index>(strip_cell_.size()));
    const Sides s = sides(facets, t);
    const double bb = s.b.squaredNorm(), bc = s.b.dot(s.c), cc = s.c.squaredNorm();
    const double determinant = bb * cc - bc * bc;
    axes_.push_back(
        {s.apex, (cc * s.b - bc * s.c) / determinant, (bb * s.c - bc * s.b) / determinant});
    const double width = (s.c - s.b).norm(), count = pieces(std::max(s.b.norm(), s.c.norm()), size);
    for (double k = 0; k < count && cell < kMostWearCells; ++k) {
      strip_cell_.push_back(static_cast<Index>(cell));
      cell += (k == 0 ? 1 : 2) * pieces(width * (k + 1) / count, size);
    }
    if (cell >= kMostWearCells) {
      throw UserError("wear.cell_size: the walls have more than 2e7 cells; choose a larger one");
    }
  }
  facet_strip_.push_back(static_cast<Index>(strip_cell_.size()));
  strip_cell_.push_back(static_cast<Index>(cell));
}

Index WearGrid::cell_at(Index facet, const Vec3& x) const noexcept {
  const Axes& axes = axes_[facet];
  const Vec3 d = x - axes.apex;
  const double along_b = d.dot(axes.to_b), along_c = d.dot(axes.to_c);
  const double down = std::clamp(along_b + along_c, 0.0, 1.0);
  const double across = down > 0 ? std::clamp(along_c / down, 0.0, 1.0) : 0.0;
  const Index count = strips(facet);
  const Index k = std::min(static_cast<Index>(down * count), count - 1);
  const Index strip = facet_strip_[facet] + k, first = strip_cell_[strip];
  const Index cells = strip_cell_[strip + 1] - first, columns = k == 0 ? cells : cells / 2;
  const Index column = std::min(static_cast<Index>(across * columns), columns - 1);
  if (k == 0) return first + column;
  // The diagonal of the column from its corner near the apex and b to the far one near c.
  const double u0 = double(k) / count, u1 = double(k + 1) / count;
  const double w0 = u0 * column / columns, w1 = u1 * (column + 1) / columns;
  const bool beyond = (down - u0) * (w1 - w0) < (down * across - w0) * (u1 - u0);
  return first + 2 * column + (beyond ? 1 : 0);
}

void WearGrid::append_cells(const Facets& facets, Index body, std::vector<WearCell>& out) const {
  for (Index t = 0; t < facets.triangles(); ++t) {
    const Sides s = sides(facets, t);
    const Index count = strips(t);
    for (Index k = 0; k < count; ++k) {
      const Index strip = facet_strip_[t] + k;
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
  const auto add_to = [](double* row, const WearRow& sum) {
    for (std::size_t k = 0; k < kWearSums; ++k) row[k] += sum[k];
  };
  for (std::size_t e = 0; e < entries.size(); ++e) {
    if (e + kEntriesAhead < entries.size()) {
      __builtin_prefetch(cells.data() + std::size_t{entries[e + kEntriesAhead].cell} * kWearSums);
    }
    const WearEntry& entry = entries[e];
    add_to(cells.data() + std::size_t{entry.cell} * kWearSums, entry.sum);
    add_to(walls.data() + std::size_t{entry.wall} * kWearSums, entry.sum);
    add_to(species.data() + std::size_t{entry.species} * kWearSums, entry.sum);
  }
}

WearRow Wear::total_of(const Column<double>& rows, std::size_t row) const {
  WearRow sum;
  std::copy_n(rows.data() + row * kWearSums, std::size_t{kWearSums}, sum.begin());
  return sum;
}

}  // namespace quern
