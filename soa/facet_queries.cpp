// The uniform grid over the triangles of a wall, and what is asked of it.
//
// A triangle is listed in every cell it may meet (its bounding box, thinned by its distance from
// the middle of the cell), so a cell tells all triangles near any of its points. Distances are
// searched in rings of cells around the point, out to the first ring that can't be nearer than what
// was found: far from all walls that costs a few empty cells.
#include <algorithm>
#include <cmath>
#include <limits>

#include "soa/facet_closest.h"
#include "soa/facets.h"

namespace quern {
namespace {

constexpr double kMaxCells = 1 << 22;

std::array<int, 3> cell_of(const Facets& f, const Vec3& x) {
  std::array<int, 3> c;
  for (int k = 0; k < 3; ++k) {
    const double at = std::floor((x[k] - f.grid_low[k]) / f.grid_cell);
    c[std::size_t(k)] = static_cast<int>(std::clamp(at, -1e9, 1e9));
  }
  return c;
}

std::array<int, 3> cell_inside(const Facets& f, const Vec3& x) {
  auto c = cell_of(f, x);
  for (std::size_t k = 0; k < 3; ++k) c[k] = std::clamp(c[k], 0, f.grid_count[k] - 1);
  return c;
}

std::size_t cell_index(const Facets& f, int i, int j, int k) {
  const auto nx = std::size_t(f.grid_count[0]), ny = std::size_t(f.grid_count[1]);
  return (std::size_t(k) * ny + std::size_t(j)) * nx + std::size_t(i);
}

// Calls visit(cell index) for the cells from a to b (both inside the grid, inclusive).
template <class Visit>
void for_cells(const Facets& f, const std::array<int, 3>& a, const std::array<int, 3>& b,
               Visit&& visit) {
  for (int k = a[2]; k <= b[2]; ++k)
    for (int j = a[1]; j <= b[1]; ++j)
      for (int i = a[0]; i <= b[0]; ++i) visit(cell_index(f, i, j, k));
}

// Calls visit(cell index) for every cell that triangle t may meet.
template <class Visit>
void for_cells_of(const Facets& f, Index t, Visit&& visit) {
  const FacetRecord& r = f.record[t];
  Vec3 low = r.corner[0].cwiseMin(r.corner[1]).cwiseMin(r.corner[2]);
  Vec3 high = r.corner[0].cwiseMax(r.corner[1]).cwiseMax(r.corner[2]);
  // A point on the border of two cells belongs to both, whatever side rounding put it.
  const double margin = 1e-9 * f.grid_cell;
  low.array() -= margin;
  high.array() += margin;
  const auto a = cell_inside(f, low), b = cell_inside(f, high);
  const double reach = 0.5 * std::sqrt(3.0) * f.grid_cell + margin;
  for (int k = a[2]; k <= b[2]; ++k)
    for (int j = a[1]; j <= b[1]; ++j)
      for (int i = a[0]; i <= b[0]; ++i) {
        const Vec3 middle = f.grid_low + f.grid_cell * Vec3(i + 0.5, j + 0.5, k + 0.5);
        if (std::abs(r.normal.dot(middle - r.corner[0])) > reach) continue;
        if (closest_on_facet(r, middle).distance2 > reach * reach) continue;
        visit(cell_index(f, i, j, k));
      }
}

void size_grid(Facets& f, double cell) {
  Eigen::AlignedBox3d box;
  for (const auto& v : f.vertex) box.extend(v);
  const Vec3 size = box.diagonal();
  const double longest = size.maxCoeff();
  f.grid_cell = cell > 0 ? cell : std::max(longest / 32, 1e-9);
  const double most = std::min(kMaxCells, std::max(65536.0, 64.0 * f.triangles()));
  const auto cells = [&] { return ((size / f.grid_cell).array().floor() + 1).prod(); };
  while (cells() > most) f.grid_cell *= 1.25;
  f.grid_low = box.min();
  for (int k = 0; k < 3; ++k) {
    f.grid_count[std::size_t(k)] = static_cast<int>(std::floor(size[k] / f.grid_cell)) + 1;
  }
}

// Least squared distance from the point to a triangle of the cell, if below `best`.
double nearest_in_cell(const Facets& f, std::size_t cell, const Vec3& x, double best) {
  for (Index at = f.cell_begin[cell]; at < f.cell_begin[cell + 1]; ++at) {
    const FacetRecord& r = f.record[f.cell_triangle[at]];
    const double height = r.normal.dot(x - r.corner[0]);
    if (height * height >= best) continue;
    best = std::min(best, closest_on_facet(r, x).distance2);
  }
  return best;
}

// The same over the cells of the grid at Chebyshev distance `ring` from cell c.
double nearest_in_ring(const Facets& f, const std::array<int, 3>& c, int ring, const Vec3& x,
                       double best) {
  std::array<int, 3> low, high;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::max(c[k] - ring, 0);
    high[k] = std::min(c[k] + ring, f.grid_count[k] - 1);
  }
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      const bool whole_row = std::abs(k - c[2]) == ring || std::abs(j - c[1]) == ring;
      const int step = whole_row || ring == 0 ? 1 : 2 * ring;
      for (int i = whole_row ? low[0] : c[0] - ring; i <= high[0]; i += step) {
        if (i >= 0) best = nearest_in_cell(f, cell_index(f, i, j, k), x, best);
      }
    }
  }
  return best;
}

// Cells between c and the grid: rings below this are empty.
int first_ring(const Facets& f, const std::array<int, 3>& c) {
  int ring = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    ring = std::max({ring, -c[k], c[k] - (f.grid_count[k] - 1)});
  }
  return ring;
}

int last_ring(const Facets& f, const std::array<int, 3>& c) {
  int ring = 0;
  for (std::size_t k = 0; k < 3; ++k) ring = std::max({ring, c[k], f.grid_count[k] - 1 - c[k]});
  return ring;
}

// Distance from x to the border of its own cell: ring r is at least (r - 1) cells and this away.
double inner_margin(const Facets& f, const std::array<int, 3>& c, const Vec3& x) {
  double margin = f.grid_cell;
  for (int k = 0; k < 3; ++k) {
    const double in = x[k] - f.grid_low[k] - f.grid_cell * c[std::size_t(k)];
    margin = std::min({margin, in, f.grid_cell - in});
  }
  return std::max(0.0, margin - 1e-9 * f.grid_cell);
}

}  // namespace

void build_facet_grid(Facets& f, double cell) {
  f.grid_count = {0, 0, 0};
  f.cell_begin.assign(1, 0);
  f.cell_triangle.clear();
  if (f.triangles() == 0) return;
  size_grid(f, cell);
  const auto cells = cell_index(f, 0, 0, f.grid_count[2]);
  f.cell_begin.assign(cells + 1, 0);
  for (Index t = 0; t < f.triangles(); ++t) {
    for_cells_of(f, t, [&](std::size_t c) { ++f.cell_begin[c + 1]; });
  }
  std::size_t entries = 0;
  for (Index& begin : f.cell_begin) {
    entries += begin;
    QUERN_CHECK(entries < kNoIndex);
    begin = static_cast<Index>(entries);
  }
  f.cell_triangle.resize(entries);
  std::vector<Index> fill(f.cell_begin.begin(), f.cell_begin.end() - 1);
  for (Index t = 0; t < f.triangles(); ++t) {
    for_cells_of(f, t, [&](std::size_t c) { f.cell_triangle[fill[c]++] = t; });
  }
}

void find_facets(const Facets& f, const Vec3& x, double reach, std::vector<Index>& out) {
  if (f.triangles() == 0) return;
  const Vec3 box = Vec3::Constant(reach);
  const Vec3 grid_high =
      f.grid_low + f.grid_cell * Vec3(f.grid_count[0], f.grid_count[1], f.grid_count[2]);
  if (((x + box).array() < f.grid_low.array()).any()) return;
  if (((x - box).array() > grid_high.array()).any()) return;
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  for_cells(f, cell_inside(f, x - box), cell_inside(f, x + box), [&](std::size_t c) {
    for (Index at = f.cell_begin[c]; at < f.cell_begin[c + 1]; ++at) {
      const Index t = f.cell_triangle[at];
      const FacetRecord& r = f.record[t];
      if (std::abs(r.normal.dot(x - r.corner[0])) <= reach) out.push_back(t);
    }
  });
  std::sort(out.begin() + first, out.end());
  out.erase(std::unique(out.begin() + first, out.end()), out.end());
  const auto is_far = [&](Index t) {
    return closest_on_facet(f.record[t], x).distance2 > reach * reach;
  };
  out.erase(std::remove_if(out.begin() + first, out.end(), is_far), out.end());
}

double distance_to_facets(const Facets& f, const Vec3& x, double limit) {
  if (f.triangles() == 0 || limit <= 0) return limit;
  const auto c = cell_of(f, x);
  const double margin = inner_margin(f, c, x);
  const int end = last_ring(f, c);
  double best = limit * limit;
  for (int ring = first_ring(f, c); ring <= end; ++ring) {
    const double least = (ring - 1) * f.grid_cell + margin;
    if (ring > 0 && least > 0 && least * least >= best) break;
    best = nearest_in_ring(f, c, ring, x, best);
  }
  return best < limit * limit ? std::sqrt(best) : limit;
}

Vec3 closest_point(const Facets& f, Index t, const Vec3& x) {
  return x + closest_on_facet(f.record[t], x).offset;
}

}  // namespace quern
