// Search over the grid. Cells hold about one entry each, so a particle's own surroundings would
// fill few lanes: the surroundings of a few neighbours of one size level are fetched once, and
// lanes are their entries, f32 with a safety margin. What survives is tested in f64 against the
// predicted gap.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/candidates.cpp"
#include <hwy/foreach_target.h>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "kernels/candidates.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Those entries of a block of cells that come nearer to a box than reach + their own reach. `near`
// has room for all of the block and a vector more.
void collect_block(const GridLevel& level, const CellBlock& block, const MiddleBox& box,
                   float reach, NearEntries& near) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const std::size_t lanes = hn::Lanes(d);
  const auto zero = hn::Zero(d), r = hn::Set(d, reach);
  const auto beyond = [&](auto x, std::size_t a) {
    const auto low = hn::Sub(hn::Set(d, box.low[a]), x);
    return hn::Max(hn::Max(low, hn::Sub(x, hn::Set(d, box.high[a]))), zero);
  };
  near.count = 0;
  for (int z = block.low[2]; z <= block.high[2]; ++z) {
    for (int y = block.low[1]; y <= block.high[1]; ++y) {
      const std::size_t row = level.row(y, z);
      const std::size_t end = level.begin[row + static_cast<std::size_t>(block.high[0]) + 1];
      for (std::size_t at = level.begin[row + static_cast<std::size_t>(block.low[0])]; at < end;
           at += lanes) {
        const auto ex = hn::LoadU(d, level.x.data() + at), ey = hn::LoadU(d, level.y.data() + at),
                   ez = hn::LoadU(d, level.z.data() + at);
        const auto own = hn::LoadU(d, level.reach_of.data() + at), sum = hn::Add(own, r);
        const auto dx = beyond(ex, 0), dy = beyond(ey, 1), dz = beyond(ez, 2);
        const auto d2 = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
        const auto close = hn::And(hn::FirstN(d, end - at), hn::Lt(d2, hn::Mul(sum, sum)));
        // Packed in a register: packing on the way to memory is slow on some processors.
        const auto put = [&](auto v, std::vector<float>& to) {
          hn::StoreU(hn::Compress(v, close), d, to.data() + near.count);
        };
        put(ex, near.x);
        put(ey, near.y);
        put(ez, near.z);
        put(own, near.reach);
        put(hn::LoadU(d, level.radius.data() + at), near.radius);
        hn::StoreU(
            hn::Compress(hn::LoadU(du, level.particle.data() + at), hn::RebindMask(du, close)), du,
            near.particle.data() + near.count);
        near.count += hn::CountTrue(d, close);
      }
    }
  }
}

// The particles among the entries that are no smaller than `radius` and nearer than reach + their
// own reach. `found` has room for all entries and a vector more.
std::size_t choose_near(const NearEntries& near, const float* centre, float radius, float reach,
                        Index* found) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const std::size_t lanes = hn::Lanes(d);
  const auto cx = hn::Set(d, centre[0]), cy = hn::Set(d, centre[1]), cz = hn::Set(d, centre[2]);
  const auto r = hn::Set(d, reach), smallest = hn::Set(d, radius);
  std::size_t n = 0;
  for (std::size_t at = 0; at < near.count; at += lanes) {
    const auto dx = hn::Sub(hn::LoadU(d, near.x.data() + at), cx);
    const auto dy = hn::Sub(hn::LoadU(d, near.y.data() + at), cy);
    const auto dz = hn::Sub(hn::LoadU(d, near.z.data() + at), cz);
    const auto sum = hn::Add(hn::LoadU(d, near.reach.data() + at), r);
    const auto d2 = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
    const auto larger = hn::Ge(hn::LoadU(d, near.radius.data() + at), smallest);
    const auto close =
        hn::And(hn::And(hn::FirstN(d, near.count - at), larger), hn::Lt(d2, hn::Mul(sum, sum)));
    if (hn::AllFalse(d, close)) continue;
    const auto particle = hn::LoadU(du, near.particle.data() + at);
    hn::StoreU(hn::Compress(particle, hn::RebindMask(du, close)), du, found + n);
    n += hn::CountTrue(d, close);
  }
  return n;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(collect_block);
HWY_EXPORT(choose_near);

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

// The particle in the middle of the window and its images across periodic faces nearer than
// `reach`.
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
                      static_cast<float>(at[2] + shift[2][kz] - low[2]), static_cast<float>(own),
                      static_cast<float>(point.radius)});
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
  // Rounding takes d2 below zero where two meet head on.
  const double gap = std::sqrt(std::max(d2, 0.0)) - touch;
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

namespace {

constexpr std::size_t kSearchers = 16;   // neighbours along the curve that search together
constexpr std::size_t kMostCells = 512;  // that they may have around them
constexpr std::size_t kVectorPad = 16;   // f32 lanes of the widest vector

struct SearchScratch {
  NearEntries near;
  std::vector<Index> found;
  std::vector<CandidatePair> pairs;
};

void make_room(std::size_t entries, SearchScratch& s) {
  if (s.found.size() >= entries + kVectorPad) return;
  const std::size_t room = 2 * entries + kVectorPad;
  for (auto* c : {&s.near.x, &s.near.y, &s.near.z, &s.near.reach, &s.near.radius}) c->resize(room);
  s.near.particle.resize(room);
  s.found.resize(room);
}

std::size_t entries_in(const GridLevel& level, const CellBlock& block) {
  std::size_t n = 0;
  for (int z = block.low[2]; z <= block.high[2]; ++z) {
    for (int y = block.low[1]; y <= block.high[1]; ++y) {
      const Index* begin = level.begin.data() + level.row(y, z);
      n += begin[block.high[0] + 1] - begin[block.low[0]];
    }
  }
  return n;
}

// The middle of the window, relative to the low corner of a level.
double middle_of(const SearchInput& in, const GridLevel& level, Index particle, std::size_t axis) {
  const SearchPoint& p = in.point[particle];
  return p.x[axis] + 0.5 * in.window * static_cast<double>(p.v[axis]) - level.low[axis];
}

double own_reach(const SearchInput& in, const SearchGrid& grid, const SearchPoint& p) {
  return reach_of(p) + in.slack + grid.margin;
}

// Around the middles of the searchers, relative to the low corner of a level.
MiddleBox box_of(const SearchInput& in, const GridLevel& level, std::span<const Index> searchers) {
  MiddleBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Index i : searchers) {
      const double at = middle_of(in, level, i, a);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    box.low[a] = static_cast<float>(low);
    box.high[a] = static_cast<float>(high);
  }
  return box;
}

// Own partners of the searchers in a level.
void search_level(const SearchInput& in, const SearchGrid& grid, const GridLevel& level,
                  std::span<const Index> searchers, SearchScratch& s) {
  const MiddleBox box = box_of(in, level, searchers);
  double reach = 0;
  for (const Index i : searchers) reach = std::max(reach, own_reach(in, grid, in.point[i]));
  CellBlock block;
  for (std::size_t a = 0; a < 3; ++a) {
    const double way = reach + level.reach;
    block.low[a] = cell_along(level, static_cast<int>(a), static_cast<double>(box.low[a]) - way);
    block.high[a] = cell_along(level, static_cast<int>(a), static_cast<double>(box.high[a]) + way);
  }
  // The curve jumps: what lies far apart searches in halves.
  if (searchers.size() > 1 && block.cells() > kMostCells) {
    const std::size_t half = searchers.size() / 2;
    search_level(in, grid, level, searchers.first(half), s);
    search_level(in, grid, level, searchers.subspan(half), s);
    return;
  }
  make_room(entries_in(level, block), s);
  HWY_DYNAMIC_DISPATCH(collect_block)(level, block, box, static_cast<float>(reach), s.near);
  if (s.near.count == 0) return;
  for (const Index i : searchers) {
    const SearchPoint& mine = in.point[i];
    const float centre[3] = {static_cast<float>(middle_of(in, level, i, 0)),
                             static_cast<float>(middle_of(in, level, i, 1)),
                             static_cast<float>(middle_of(in, level, i, 2))};
    const std::size_t n = HWY_DYNAMIC_DISPATCH(choose_near)(
        s.near, centre, static_cast<float>(mine.radius),
        static_cast<float>(own_reach(in, grid, mine)), s.found.data());
    for (std::size_t k = 0; k < n; ++k) hwy::Prefetch(in.point + s.found[k]);
    for (std::size_t k = 0; k < n; ++k) {
      const SearchPoint& other = in.point[s.found[k]];
      const bool larger =
          other.radius > mine.radius || (other.radius == mine.radius && other.id > mine.id);
      CandidatePair pair = {i, s.found[k], 0, 0};
      if (larger && meets(in, mine, other, pair)) s.pairs.push_back(pair);
    }
  }
}

// From groups of searchers to the order of particles, partners ascending.
void sort_pairs(std::vector<CandidatePair>& pairs, Index first, Index last,
                std::vector<CandidatePair>& out) {
  std::vector<Index> begin(last - first + 1, 0);
  for (const CandidatePair& pair : pairs) ++begin[pair.i - first + 1];
  for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  std::vector<CandidatePair> sorted(pairs.size());
  std::vector<Index> at(begin);
  for (const CandidatePair& pair : pairs) sorted[at[pair.i - first]++] = pair;
  for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
    const auto from = sorted.begin() + begin[k], to = sorted.begin() + begin[k + 1];
    std::sort(from, to, [](const CandidatePair& a, const CandidatePair& b) { return a.j < b.j; });
    // A short periodic box can show the same partner twice.
    std::unique_copy(from, to, std::back_inserter(out),
                     [](const CandidatePair& a, const CandidatePair& b) { return a.j == b.j; });
  }
}

}  // namespace

void find_candidates(const SearchInput& in, const SearchGrid& grid, Index first, Index last,
                     std::vector<CandidatePair>& out) {
  SearchScratch s;
  std::vector<std::vector<Index>> members(grid.levels.size());
  for (Index i = first; i < last; ++i) {
    members[static_cast<std::size_t>(level_of(in.point[i].radius, grid.smallest_radius))].push_back(
        i);
  }
  for (std::size_t own = 0; own < members.size(); ++own) {
    for (std::size_t at = 0; at < members[own].size(); at += kSearchers) {
      const std::span<const Index> searchers(members[own].data() + at,
                                             std::min(kSearchers, members[own].size() - at));
      for (std::size_t l = own; l < grid.levels.size(); ++l) {
        if (grid.levels[l].particle.empty()) continue;
        search_level(in, grid, grid.levels[l], searchers, s);
      }
    }
  }
  sort_pairs(s.pairs, first, last, out);
}

}  // namespace quern
#endif
