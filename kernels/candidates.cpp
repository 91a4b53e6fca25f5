// Search over the grid. Cells hold about one entry each, so a particle's own surroundings would
// fill few lanes: the surroundings of a few neighbours of one size level are fetched once, and
// lanes are their entries, f32 with a safety margin. What survives is tested in f64 against the
// predicted gap.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/candidates.cpp"
#include "kernels/candidates.h"

#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// AVX2 packs eight lanes by a table of eight kilobytes, four by one of 256 bytes.
constexpr std::size_t kSearchLanes = HWY_TARGET == HWY_AVX2 ? 4 : 16;
using SearchLanes = hn::CappedTag<float, kSearchLanes>;

// Those entries of a block of cells that come nearer to a box than reach + their own reach. `near`
// has room for all of the block and a vector more.
void collect_block(const GridLevel& level, const CellBlock& block, const MiddleBox& box,
                   float reach, NearEntries& near) {
  const SearchLanes d;
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
        put(hn::LoadU(d, level.vx.data() + at), near.vx);
        put(hn::LoadU(d, level.vy.data() + at), near.vy);
        put(hn::LoadU(d, level.vz.data() + at), near.vz);
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

// The particles among the entries that are no smaller than the searcher and whose straight line
// comes nearer to its than the sum of radii and `slack`. `found` has room for all entries and a
// vector more.
std::size_t choose_near(const NearEntries& near, const Searcher& mine, float half_window,
                        float slack, Index* found) {
  const SearchLanes d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const std::size_t lanes = hn::Lanes(d);
  const auto cx = hn::Set(d, mine.x[0]), cy = hn::Set(d, mine.x[1]), cz = hn::Set(d, mine.x[2]);
  const auto reach = hn::Set(d, mine.reach + slack), radius = hn::Set(d, mine.radius);
  const auto dot = [](auto ax, auto ay, auto az, auto bx, auto by, auto bz)
                       HWY_ATTR { return hn::MulAdd(ax, bx, hn::MulAdd(ay, by, hn::Mul(az, bz))); };
  std::size_t n = 0;
  for (std::size_t at = 0; at < near.count; at += lanes) {
    const auto dx = hn::Sub(hn::LoadU(d, near.x.data() + at), cx);
    const auto dy = hn::Sub(hn::LoadU(d, near.y.data() + at), cy);
    const auto dz = hn::Sub(hn::LoadU(d, near.z.data() + at), cz);
    const auto sum = hn::Add(hn::LoadU(d, near.reach.data() + at), reach);
    const auto other = hn::LoadU(d, near.radius.data() + at);
    auto close = hn::And(hn::And(hn::FirstN(d, near.count - at), hn::Ge(other, radius)),
                         hn::Lt(dot(dx, dy, dz, dx, dy, dz), hn::Mul(sum, sum)));
    if (hn::AllFalse(d, close)) continue;
    const auto vx = hn::Sub(hn::LoadU(d, near.vx.data() + at), hn::Set(d, mine.v[0]));
    const auto vy = hn::Sub(hn::LoadU(d, near.vy.data() + at), hn::Set(d, mine.v[1]));
    const auto vz = hn::Sub(hn::LoadU(d, near.vz.data() + at), hn::Set(d, mine.v[2]));
    const auto last = hn::Set(d, half_window);
    const auto v2 = hn::Max(dot(vx, vy, vz, vx, vy, vz), hn::Set(d, 1e-30f));
    const auto nearest = hn::Div(dot(dx, dy, dz, vx, vy, vz), v2);
    const auto time = hn::Max(hn::Min(nearest, last), hn::Neg(last));
    const auto px = hn::NegMulAdd(time, vx, dx), py = hn::NegMulAdd(time, vy, dy),
               pz = hn::NegMulAdd(time, vz, dz);
    const auto most = hn::Add(other, hn::Set(d, mine.radius + slack));
    close = hn::And(close, hn::Lt(dot(px, py, pz, px, py, pz), hn::Mul(most, most)));
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

using Numbers3 = std::array<double, 3>;

// Square of the least distance on a straight line within the window.
double least_distance2(const Numbers3& x, const Numbers3& v, double window) {
  double xv = 0, vv = 0, xx = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    xv += x[a] * v[a];
    vv += v[a] * v[a];
    xx += x[a] * x[a];
  }
  double time = 0;
  if (xv < 0) time = vv * window > -xv ? -xv / vv : window;
  return xx + time * (2 * xv + time * vv);
}

// The least of all images that are the nearest one at some time in the window: `x` is the nearest
// at its start, `turns` tells along each axis how many periods from it that of the end is.
double least_of_images(const SearchBox& box, const Numbers3& x, const Numbers3& v, double window,
                       const Numbers3& turns) {
  double least = HUGE_VAL;
  Numbers3 image;
  const auto along = [&](auto&& self, std::size_t a) -> void {
    if (a == 3) {
      least = std::min(least, least_distance2(image, v, window));
      return;
    }
    for (double k = std::min(0.0, turns[a]); k <= std::max(0.0, turns[a]); ++k) {
      image[a] = x[a] - k * box.period[a];
      self(self, a + 1);
    }
  };
  along(along, 0);
  return least;
}

// Whether the pair's gap falls below the slack within the window on straight lines, by its nearest
// image of every moment; sets gap and speed if it does.
bool meets(const SearchInput& in, const SearchPoint& i, const SearchPoint& j, CandidatePair& pair) {
  Numbers3 x, v, turns{};
  double vv = 0;
  bool changes = false;
  for (std::size_t a = 0; a < 3; ++a) {
    x[a] = i.x[a] - j.x[a];
    v[a] = static_cast<double>(i.v[a]) - static_cast<double>(j.v[a]);
    vv += v[a] * v[a];
    const double period = in.box.period[a];
    if (period <= 0) continue;
    x[a] = nearest_image(x[a], period);
    turns[a] = std::nearbyint((x[a] + in.window * v[a]) / period);
    changes = changes || turns[a] != 0;
  }
  const double d2 =
      changes ? least_of_images(in.box, x, v, in.window, turns) : least_distance2(x, v, in.window);
  const double touch = i.radius + j.radius, reach = touch + in.slack;
  if (d2 >= reach * reach) return false;
  // Rounding takes d2 below zero where two meet head on.
  const double gap = std::sqrt(std::max(d2, 0.0)) - touch;
  pair.gap = static_cast<float>(gap - 1e-7 * std::abs(gap));
  pair.speed = static_cast<float>(std::sqrt(vv));
  return true;
}

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
  for (auto* c : {&s.near.x, &s.near.y, &s.near.z, &s.near.vx, &s.near.vy, &s.near.vz,
                  &s.near.reach, &s.near.radius}) {
    c->resize(room);
  }
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

Searcher searcher_of(const SearchInput& in, const GridLevel& level, Index i) {
  const SearchPoint& p = in.point[i];
  return {{static_cast<float>(middle_of(in, level, i, 0)),
           static_cast<float>(middle_of(in, level, i, 1)),
           static_cast<float>(middle_of(in, level, i, 2))},
          p.v,
          static_cast<float>(p.radius),
          static_cast<float>(reach_of(p))};
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
    block.low[a] = cell_along(level, a, static_cast<double>(box.low[a]) - way);
    block.high[a] = cell_along(level, a, static_cast<double>(box.high[a]) + way);
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
    const std::size_t n = HWY_DYNAMIC_DISPATCH(choose_near)(
        s.near, searcher_of(in, level, i), static_cast<float>(0.5 * in.window),
        static_cast<float>(in.slack + grid.margin), s.found.data());
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
    if (to - from > 1) {
      std::sort(from, to, [](const CandidatePair& a, const CandidatePair& b) { return a.j < b.j; });
    }
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
    members[level_of(in.point[i].radius, grid.smallest_radius)].push_back(i);
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
