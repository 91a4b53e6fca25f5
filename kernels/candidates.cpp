// Search over the grid: lanes are the entries of a run of cells, f32 with a safety margin; what
// survives is tested in f64 against the predicted gap.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/candidates.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "kernels/candidates.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Entries of [begin, end) nearer than reach + their own reach, as positions in the level. `found` has
// room for end - begin + a vector.
std::size_t near_entries(const GridLevel& level, Index begin, Index end, const float* centre,
                         float reach, std::int32_t* found) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const std::size_t lanes = hn::Lanes(d);
  const auto cx = hn::Set(d, centre[0]), cy = hn::Set(d, centre[1]), cz = hn::Set(d, centre[2]);
  const auto r = hn::Set(d, reach);
  std::size_t n = 0;
  for (std::size_t at = begin; at < end; at += lanes) {
    const auto dx = hn::Sub(hn::LoadU(d, level.x.data() + at), cx);
    const auto dy = hn::Sub(hn::LoadU(d, level.y.data() + at), cy);
    const auto dz = hn::Sub(hn::LoadU(d, level.z.data() + at), cz);
    const auto sum = hn::Add(hn::LoadU(d, level.reach_of.data() + at), r);
    const auto d2 = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
    const auto live = hn::FirstN(d, end - at);
    const auto near = hn::And(live, hn::Lt(d2, hn::Mul(sum, sum)));
    if (hn::AllFalse(d, near)) continue;
    const auto index = hn::Iota(di, static_cast<std::int32_t>(at));
    n += hn::CompressStore(index, hn::RebindMask(di, near), di, found + n);
  }
  return n;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(near_entries);

namespace {

constexpr int kMaxLevels = 16;

double half_path(const SearchInput& in, std::size_t p) {
  const double v2 = in.v[0][p] * in.v[0][p] + in.v[1][p] * in.v[1][p] + in.v[2][p] * in.v[2][p];
  return 0.5 * in.window * std::sqrt(v2);
}

int level_of(double radius, double smallest) {
  const int level = static_cast<int>(std::floor(std::log2(radius / smallest) + 1e-9));
  return std::clamp(level, 0, kMaxLevels - 1);
}

struct Entry {
  Index particle;
  float x, y, z, reach;
};

// The particle in the middle of the window and its images across periodic faces nearer than `reach`.
void append_entries(const SearchInput& in, std::size_t p, double reach,
                    const std::array<double, 3>& low, std::vector<Entry>& to) {
  double shift[3][3];
  int shifts[3];
  double at[3];
  for (int a = 0; a < 3; ++a) {
    at[a] = in.x[a][p] + 0.5 * in.window * in.v[a][p];
    shift[a][0] = 0;
    shifts[a] = 1;
    const double period = in.box.period[static_cast<std::size_t>(a)];
    if (period <= 0) continue;
    const double from_low = at[a] - in.box.low[static_cast<std::size_t>(a)];
    if (from_low < reach) shift[a][shifts[a]++] = period;
    if (period - from_low < reach) shift[a][shifts[a]++] = -period;
  }
  const double own = in.radius[p] + half_path(in, p);
  for (int kx = 0; kx < shifts[0]; ++kx) {
    for (int ky = 0; ky < shifts[1]; ++ky) {
      for (int kz = 0; kz < shifts[2]; ++kz) {
        to.push_back({static_cast<Index>(p), static_cast<float>(at[0] + shift[0][kx] - low[0]),
                      static_cast<float>(at[1] + shift[1][ky] - low[1]),
                      static_cast<float>(at[2] + shift[2][kz] - low[2]),
                      static_cast<float>(own)});
      }
    }
  }
}

int cell_along(const GridLevel& level, int axis, double offset) {
  const int c = static_cast<int>(std::floor(offset / level.cell));
  return std::clamp(c, 0, level.count[static_cast<std::size_t>(axis)] - 1);
}

// Counting sort of the entries into cells.
void sort_into_cells(const std::vector<Entry>& entries, GridLevel& level) {
  const std::size_t cells = static_cast<std::size_t>(level.count[0]) *
                            static_cast<std::size_t>(level.count[1]) *
                            static_cast<std::size_t>(level.count[2]);
  level.begin.reset(cells + 1);
  level.begin.fill(0);
  std::vector<Index> cell(entries.size());
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const std::size_t cx = static_cast<std::size_t>(cell_along(level, 0, entries[e].x));
    const std::size_t cy = static_cast<std::size_t>(cell_along(level, 1, entries[e].y));
    const std::size_t cz = static_cast<std::size_t>(cell_along(level, 2, entries[e].z));
    cell[e] = static_cast<Index>((cz * static_cast<std::size_t>(level.count[1]) + cy) *
                                     static_cast<std::size_t>(level.count[0]) +
                                 cx);
    ++level.begin[cell[e] + 1];
  }
  for (std::size_t c = 0; c < cells; ++c) level.begin[c + 1] += level.begin[c];
  level.particle.reset(entries.size());
  for (Column<float>* c : {&level.x, &level.y, &level.z, &level.reach_of}) c->reset(entries.size());
  for (std::size_t e = entries.size(); e-- > 0;) {
    // Backwards, moving each cell's end down to its begin: entries keep their order in a cell.
    const Index at = --level.begin[cell[e] + 1];
    level.particle[at] = entries[e].particle;
    level.x[at] = entries[e].x;
    level.y[at] = entries[e].y;
    level.z[at] = entries[e].z;
    level.reach_of[at] = entries[e].reach;
  }
  // begin[c + 1] now holds the begin of cell c.
  for (std::size_t c = 0; c < cells; ++c) level.begin[c] = level.begin[c + 1];
  level.begin[cells] = static_cast<Index>(entries.size());
  // Lanes beyond the last entry are masked but loaded.
  for (std::size_t k = 0; k < 16; ++k) {
    level.x[entries.size() + k] = level.y[entries.size() + k] = level.z[entries.size() + k] = 0;
    level.reach_of[entries.size() + k] = 0;
  }
}

void size_cells(const SearchInput& in, std::size_t entries, double largest, double reach,
                GridLevel& level) {
  level.cell = std::max(largest * 1.5, 1e-12);
  level.reach = reach;
  const double most = 4.0 * static_cast<double>(entries) + 4096;
  for (;;) {
    double cells = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      level.low[a] = in.box.low[a] - (in.box.period[a] > 0 ? 2 * reach : 0);
      const double span = in.box.high[a] - level.low[a] + (in.box.period[a] > 0 ? 2 * reach : 0);
      const double n = std::floor(span / level.cell) + 1;
      level.count[a] = static_cast<int>(std::min(n, 1e6));
      cells *= n;
    }
    if (cells <= most) return;
    level.cell *= 1.26;
  }
}

// Whether the pair's gap falls below the slack within the window on straight lines, nearest image.
bool meets(const SearchInput& in, Index i, Index j) {
  double dx[3], dv[3], xv = 0, vv = 0, xx = 0;
  for (int a = 0; a < 3; ++a) {
    dx[a] = in.x[a][i] - in.x[a][j];
    const double period = in.box.period[static_cast<std::size_t>(a)];
    if (period > 0) dx[a] -= period * std::nearbyint(dx[a] / period);
    dv[a] = in.v[a][i] - in.v[a][j];
    xv += dx[a] * dv[a];
    vv += dv[a] * dv[a];
    xx += dx[a] * dx[a];
  }
  double time = 0;
  if (xv < 0) time = vv * in.window > -xv ? -xv / vv : in.window;
  const double d2 = xx + time * (2 * xv + time * vv);
  const double reach = in.radius[i] + in.radius[j] + in.slack;
  return d2 < reach * reach;
}

}  // namespace

void build_grid(const SearchInput& in, SearchGrid& grid) {
  double smallest = in.count > 0 ? in.radius[0] : 1, largest = smallest;
  for (std::size_t p = 0; p < in.count; ++p) {
    smallest = std::min(smallest, in.radius[p]);
    largest = std::max(largest, in.radius[p]);
  }
  grid.smallest_radius = smallest;
  const std::size_t levels = static_cast<std::size_t>(level_of(largest, smallest)) + 1;
  grid.levels.resize(levels);
  std::vector<double> level_reach(levels, 0), level_radius(levels, 0);
  std::vector<std::size_t> members(levels, 0);
  for (std::size_t p = 0; p < in.count; ++p) {
    const std::size_t l = static_cast<std::size_t>(level_of(in.radius[p], smallest));
    level_reach[l] = std::max(level_reach[l], in.radius[p] + half_path(in, p));
    level_radius[l] = std::max(level_radius[l], in.radius[p]);
    ++members[l];
  }
  double extent = 0, finer_reach = 0;
  for (std::size_t a = 0; a < 3; ++a) extent = std::max(extent, in.box.high[a] - in.box.low[a]);
  for (std::size_t l = 0; l < levels; ++l) {
    finer_reach = std::max(finer_reach, level_reach[l]);
    size_cells(in, members[l], level_radius[l], finer_reach + level_reach[l] + in.slack,
               grid.levels[l]);
    grid.levels[l].reach = level_reach[l];
    extent = std::max(extent, 4 * (level_reach[l] + finer_reach + in.slack) + extent);
  }
  grid.margin = 4e-7 * extent;
  std::vector<std::vector<Entry>> entries(levels);
  for (std::size_t l = 0; l < levels; ++l) entries[l].reserve(members[l] + members[l] / 8);
  double searcher = 0;
  std::vector<double> image_reach(levels);
  for (std::size_t l = 0; l < levels; ++l) {
    searcher = std::max(searcher, level_reach[l]);
    image_reach[l] = searcher + in.slack + grid.margin;
  }
  for (std::size_t p = 0; p < in.count; ++p) {
    const std::size_t l = static_cast<std::size_t>(level_of(in.radius[p], smallest));
    const double reach = in.radius[p] + half_path(in, p) + image_reach[l] + level_reach[l];
    append_entries(in, p, reach, grid.levels[l].low, entries[l]);
  }
  for (std::size_t l = 0; l < levels; ++l) sort_into_cells(entries[l], grid.levels[l]);
}

void find_candidates(const SearchInput& in, const SearchGrid& grid, Index first, Index last,
                     std::vector<CandidatePair>& out) {
  std::vector<std::int32_t> found;
  for (Index i = first; i < last; ++i) {
    const std::size_t begin = out.size();
    const double own = in.radius[i] + half_path(in, i) + in.slack + grid.margin;
    const std::size_t l0 =
        static_cast<std::size_t>(level_of(in.radius[i], grid.smallest_radius));
    for (std::size_t l = l0; l < grid.levels.size(); ++l) {
      const GridLevel& level = grid.levels[l];
      if (level.particle.empty()) continue;
      float centre[3];
      int low[3], high[3];
      const double reach = own + level.reach;
      for (int a = 0; a < 3; ++a) {
        const double at =
            in.x[a][i] + 0.5 * in.window * in.v[a][i] - level.low[static_cast<std::size_t>(a)];
        centre[a] = static_cast<float>(at);
        low[a] = cell_along(level, a, at - reach);
        high[a] = cell_along(level, a, at + reach);
      }
      for (int cz = low[2]; cz <= high[2]; ++cz) {
        for (int cy = low[1]; cy <= high[1]; ++cy) {
          const std::size_t row = (static_cast<std::size_t>(cz) *
                                       static_cast<std::size_t>(level.count[1]) +
                                   static_cast<std::size_t>(cy)) *
                                  static_cast<std::size_t>(level.count[0]);
          const Index from = level.begin[row + static_cast<std::size_t>(low[0])];
          const Index to = level.begin[row + static_cast<std::size_t>(high[0]) + 1];
          if (from == to) continue;
          if (found.size() < to - from + 32u) found.resize(2 * (to - from) + 64u);
          const std::size_t n =
              HWY_DYNAMIC_DISPATCH(near_entries)(level, from, to, centre, static_cast<float>(own), found.data());
          for (std::size_t k = 0; k < n; ++k) {
            const Index j = level.particle[static_cast<std::size_t>(found[k])];
            const bool larger = in.radius[j] > in.radius[i] ||
                                (in.radius[j] == in.radius[i] && in.id[j] > in.id[i]);
            if (larger && meets(in, i, j)) out.push_back({i, j});
          }
        }
      }
    }
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
              [](const CandidatePair& a, const CandidatePair& b) { return a.j < b.j; });
    // A small periodic box can show the same partner twice.
    out.erase(std::unique(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
                          [](const CandidatePair& a, const CandidatePair& b) { return a.j == b.j; }),
              out.end());
  }
}

}  // namespace quern
#endif
