// Search over the grid: lanes are the entries of a run of cells, f32 with a safety margin; what
// survives is tested in f64 against the predicted gap.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/candidates.cpp"
#include <hwy/foreach_target.h>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "kernels/candidates.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Entries of a block of cells no smaller than `radius` and nearer than reach + their own reach, as
// positions in the level. `found` has room for all entries of the level and a vector more.
std::size_t near_entries(const GridLevel& level, const CellBlock& block, const float* centre,
                         float radius, float reach, std::int32_t* found) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const std::size_t lanes = hn::Lanes(d);
  const auto cx = hn::Set(d, centre[0]), cy = hn::Set(d, centre[1]), cz = hn::Set(d, centre[2]);
  const auto r = hn::Set(d, reach), smallest = hn::Set(d, radius);
  const auto iota = hn::Iota(di, 0);
  std::size_t n = 0;
  for (int z = block.low[2]; z <= block.high[2]; ++z) {
    for (int y = block.low[1]; y <= block.high[1]; ++y) {
      const std::size_t row = level.row(y, z);
      const std::size_t end = level.begin[row + static_cast<std::size_t>(block.high[0]) + 1];
      for (std::size_t at = level.begin[row + static_cast<std::size_t>(block.low[0])]; at < end;
           at += lanes) {
        const auto dx = hn::Sub(hn::LoadU(d, level.x.data() + at), cx);
        const auto dy = hn::Sub(hn::LoadU(d, level.y.data() + at), cy);
        const auto dz = hn::Sub(hn::LoadU(d, level.z.data() + at), cz);
        const auto sum = hn::Add(hn::LoadU(d, level.reach_of.data() + at), r);
        const auto d2 = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
        const auto larger = hn::Ge(hn::LoadU(d, level.radius.data() + at), smallest);
        const auto near = hn::And(hn::And(hn::FirstN(d, end - at), larger),
                                  hn::Lt(d2, hn::Mul(sum, sum)));
        // Packed in a register: packing on the way to memory is slow on some processors.
        const auto index = hn::Add(iota, hn::Set(di, static_cast<std::int32_t>(at)));
        hn::StoreU(hn::Compress(index, hn::RebindMask(di, near)), di, found + n);
        n += hn::CountTrue(d, near);
      }
    }
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

int level_of(double radius, double smallest) {
  int level = 0;
  for (double end = 2 * smallest; radius >= end && level < kMaxLevels - 1; end *= 2) ++level;
  return level;
}

double reach_of(const SearchPoint& p) { return p.radius + static_cast<double>(p.half_path); }

struct Entry {
  Index particle;
  float x, y, z, reach, radius;
};

// The particle in the middle of the window and its images across periodic faces nearer than `reach`.
void append_entries(const SearchInput& in, std::size_t p, double reach,
                    const std::array<double, 3>& low, std::vector<Entry>& to) {
  const SearchPoint& point = in.point[p];
  double shift[3][3];
  int shifts[3];
  double at[3];
  for (std::size_t a = 0; a < 3; ++a) {
    at[a] = point.x[a] + 0.5 * in.window * static_cast<double>(point.v[a]);
    shift[a][0] = 0;
    shifts[a] = 1;
    const double period = in.box.period[a];
    if (period <= 0) continue;
    const double from_low = at[a] - in.box.low[a];
    if (from_low < reach) shift[a][shifts[a]++] = period;
    if (period - from_low < reach) shift[a][shifts[a]++] = -period;
  }
  const double own = reach_of(point);
  for (int kx = 0; kx < shifts[0]; ++kx) {
    for (int ky = 0; ky < shifts[1]; ++ky) {
      for (int kz = 0; kz < shifts[2]; ++kz) {
        to.push_back({static_cast<Index>(p), static_cast<float>(at[0] + shift[0][kx] - low[0]),
                      static_cast<float>(at[1] + shift[1][ky] - low[1]),
                      static_cast<float>(at[2] + shift[2][kz] - low[2]),
                      static_cast<float>(own), static_cast<float>(point.radius)});
      }
    }
  }
}

int cell_along(const GridLevel& level, int axis, double offset) {
  const double last = level.count[static_cast<std::size_t>(axis)] - 1;
  return static_cast<int>(std::clamp(offset * level.inverse_cell, 0.0, last));
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
  for (Column<float>* c : {&level.x, &level.y, &level.z, &level.reach_of, &level.radius}) {
    c->reset(entries.size());
  }
  for (std::size_t e = entries.size(); e-- > 0;) {
    // Backwards, moving each cell's end down to its begin: entries keep their order in a cell.
    const Index at = --level.begin[cell[e] + 1];
    level.particle[at] = entries[e].particle;
    level.x[at] = entries[e].x;
    level.y[at] = entries[e].y;
    level.z[at] = entries[e].z;
    level.reach_of[at] = entries[e].reach;
    level.radius[at] = entries[e].radius;
  }
  // begin[c + 1] now holds the begin of cell c.
  for (std::size_t c = 0; c < cells; ++c) level.begin[c] = level.begin[c + 1];
  level.begin[cells] = static_cast<Index>(entries.size());
  // Lanes beyond the last entry are masked but loaded.
  for (std::size_t k = 0; k < 16; ++k) {
    level.x[entries.size() + k] = level.y[entries.size() + k] = level.z[entries.size() + k] = 0;
    level.reach_of[entries.size() + k] = level.radius[entries.size() + k] = 0;
  }
}

void size_cells(const SearchInput& in, std::size_t entries, double largest, double reach,
                GridLevel& level) {
  level.cell = std::max(2 * largest + in.slack, 1e-12);
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
    level.inverse_cell = 1 / level.cell;
    if (cells <= most) return;
    level.cell *= 1.26;
  }
}

// Whether the pair's gap falls below the slack within the window on straight lines, nearest image;
// sets gap and speed if it does.
bool meets(const SearchInput& in, const SearchPoint& i, const SearchPoint& j, CandidatePair& pair) {
  double xv = 0, vv = 0, xx = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    double dx = i.x[a] - j.x[a];
    const double period = in.box.period[a];
    if (period > 0) dx = nearest_image(dx, period);
    const double dv = static_cast<double>(i.v[a]) - static_cast<double>(j.v[a]);
    xv += dx * dv;
    vv += dv * dv;
    xx += dx * dx;
  }
  double time = 0;
  if (xv < 0) time = vv * in.window > -xv ? -xv / vv : in.window;
  const double d2 = xx + time * (2 * xv + time * vv);
  const double touch = i.radius + j.radius, reach = touch + in.slack;
  if (d2 >= reach * reach) return false;
  const double gap = std::sqrt(d2) - touch;
  pair.gap = static_cast<float>(gap - 1e-7 * std::abs(gap));
  pair.speed = static_cast<float>(std::sqrt(vv));
  return true;
}

}  // namespace

void build_grid(const SearchInput& in, SearchGrid& grid) {
  double smallest = in.count > 0 ? in.point[0].radius : 1, largest = smallest;
  for (std::size_t p = 0; p < in.count; ++p) {
    SearchPoint& point = in.point[p];
    smallest = std::min(smallest, point.radius);
    largest = std::max(largest, point.radius);
    const double v2 = static_cast<double>(point.v[0] * point.v[0] + point.v[1] * point.v[1] +
                                          point.v[2] * point.v[2]);
    // Rounded up: the f32 reject has to be conservative.
    point.half_path = static_cast<float>(0.500001 * in.window * std::sqrt(v2));
  }
  grid.smallest_radius = smallest;
  const std::size_t levels = static_cast<std::size_t>(level_of(largest, smallest)) + 1;
  grid.levels.resize(levels);
  std::vector<double> level_reach(levels, 0), level_radius(levels, 0);
  std::vector<std::size_t> members(levels, 0);
  std::vector<std::uint8_t> level(in.count);
  for (std::size_t p = 0; p < in.count; ++p) {
    const std::size_t l = static_cast<std::size_t>(level_of(in.point[p].radius, smallest));
    level[p] = static_cast<std::uint8_t>(l);
    level_reach[l] = std::max(level_reach[l], reach_of(in.point[p]));
    level_radius[l] = std::max(level_radius[l], in.point[p].radius);
    ++members[l];
  }
  double extent = 0, searcher = 0;
  for (std::size_t a = 0; a < 3; ++a) extent = std::max(extent, in.box.high[a] - in.box.low[a]);
  grid.margin = 0;
  for (std::size_t l = 0; l < levels; ++l) {
    searcher = std::max(searcher, level_reach[l]);
    const double reach = searcher + level_reach[l] + in.slack;
    size_cells(in, members[l], level_radius[l], reach, grid.levels[l]);
    grid.levels[l].reach = level_reach[l];
    grid.margin = std::max(grid.margin, 4e-7 * (extent + 8 * reach));
  }
  std::vector<std::vector<Entry>> entries(levels);
  for (std::size_t l = 0; l < levels; ++l) entries[l].reserve(members[l] + members[l] / 8);
  std::vector<double> image_reach(levels);
  searcher = 0;
  for (std::size_t l = 0; l < levels; ++l) {
    searcher = std::max(searcher, level_reach[l]);
    image_reach[l] = searcher + in.slack + 2 * grid.margin;
  }
  for (std::size_t p = 0; p < in.count; ++p) {
    const std::size_t l = level[p];
    // Searchers are binned by their middle place, which may lie a half path beyond the face.
    const double reach = reach_of(in.point[p]) + image_reach[l] + level_reach[l];
    append_entries(in, p, reach, grid.levels[l].low, entries[l]);
  }
  for (std::size_t l = 0; l < levels; ++l) sort_into_cells(entries[l], grid.levels[l]);
}

void find_candidates(const SearchInput& in, const SearchGrid& grid, Index first, Index last,
                     std::vector<CandidatePair>& out) {
  std::size_t most = 0;
  for (const GridLevel& level : grid.levels) most = std::max(most, level.particle.size());
  // Only what is found is ever touched.
  const auto found = std::make_unique_for_overwrite<std::int32_t[]>(most + 64);
  for (Index i = first; i < last; ++i) {
    const SearchPoint& mine = in.point[i];
    const std::size_t begin = out.size();
    const double own = reach_of(mine) + in.slack + grid.margin;
    const std::size_t l0 = static_cast<std::size_t>(level_of(mine.radius, grid.smallest_radius));
    for (std::size_t l = l0; l < grid.levels.size(); ++l) {
      const GridLevel& level = grid.levels[l];
      if (level.particle.empty()) continue;
      CellBlock block;
      float centre[3];
      const double reach = own + level.reach;
      for (std::size_t a = 0; a < 3; ++a) {
        const double at =
            mine.x[a] + 0.5 * in.window * static_cast<double>(mine.v[a]) - level.low[a];
        centre[a] = static_cast<float>(at);
        block.low[a] = cell_along(level, static_cast<int>(a), at - reach);
        block.high[a] = cell_along(level, static_cast<int>(a), at + reach);
      }
      const std::size_t n = HWY_DYNAMIC_DISPATCH(near_entries)(
          level, block, centre, static_cast<float>(mine.radius), static_cast<float>(own),
          found.get());
      for (std::size_t k = 0; k < n; ++k) {
        hwy::Prefetch(in.point + level.particle[static_cast<std::size_t>(found[k])]);
      }
      for (std::size_t k = 0; k < n; ++k) {
        const Index j = level.particle[static_cast<std::size_t>(found[k])];
        const SearchPoint& other = in.point[j];
        const bool larger = other.radius > mine.radius ||
                            (other.radius == mine.radius && other.id > mine.id);
        CandidatePair pair = {i, j, 0, 0};
        if (larger && meets(in, mine, other, pair)) out.push_back(pair);
      }
    }
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
              [](const CandidatePair& a, const CandidatePair& b) { return a.j < b.j; });
    // A short periodic box can show the same partner twice.
    out.erase(std::unique(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
                          [](const CandidatePair& a, const CandidatePair& b) { return a.j == b.j; }),
              out.end());
  }
}

}  // namespace quern
#endif
