// The grid of the search, built by tasks that share no write: counts of entries by chunk of points
// and by slab of cells say where each chunk puts its entries of a slab; then each slab sorts its
// own into cells. Entries of a cell keep the order of points: neither tasks nor threads show in the
// result.
#include <cmath>

#include "kernels/candidates.h"

namespace quern {

namespace {

constexpr std::size_t kChunk = 4096;    // points a task
constexpr std::size_t kMostSlabs = 64;  // of a level

struct LevelSizes {
  double reach = 0, radius = 0;
  std::size_t members = 0;
};

struct ChunkSizes {
  double smallest = HUGE_VAL, largest = 0;
  std::array<LevelSizes, kMaxLevels> level;
};

// What the entries of a point need to know of its level.
struct LevelPlan {
  // m: a point nearer to a periodic face than this and its own reach shows twice.
  double image_reach = 0;
  std::size_t cells = 0, cells_a_slab = 1, first_slab = 0;
};

double middle(const SearchInput& in, const SearchPoint& p, std::size_t axis) {
  return p.x[axis] + 0.5 * in.window * static_cast<double>(p.v[axis]);
}

// Images are numbered kx + 3 ky + 9 kz; along an axis 0 stays, 1 goes up a period, 2 down.
double image_shift(double period, std::uint32_t image) {
  return image == 0 ? 0 : image == 1 ? period : -period;
}

// Place of a point's image in the middle of the window, relative to the low corner of a level.
std::array<float, 3> place_of(const SearchInput& in, const GridLevel& level, const SearchPoint& p,
                              std::uint32_t image) {
  std::array<float, 3> at;
  for (std::size_t a = 0; a < 3; ++a, image /= 3) {
    at[a] = static_cast<float>(middle(in, p, a) + image_shift(in.box.period[a], image % 3) -
                               level.low[a]);
  }
  return at;
}

Index cell_of(const GridLevel& level, const std::array<float, 3>& at) {
  const auto along = [&](std::size_t a) {
    return cell_along(level, a, static_cast<double>(at[a]));
  };
  return static_cast<Index>(level.row(along(1), along(2)) + static_cast<std::size_t>(along(0)));
}

// f(image) for the point itself and its images across periodic faces nearer than `reach`.
template <class F>
void for_images(const SearchInput& in, const SearchPoint& p, double reach, const F& f) {
  std::uint32_t image[3][3];
  int images[3];
  for (std::size_t a = 0; a < 3; ++a) {
    image[a][0] = 0;
    images[a] = 1;
    const double period = in.box.period[a];
    if (period <= 0) continue;
    const double from_low = middle(in, p, a) - in.box.low[a];
    if (from_low < reach) image[a][images[a]++] = 1;
    if (period - from_low < reach) image[a][images[a]++] = 2;
  }
  for (int x = 0; x < images[0]; ++x) {
    for (int y = 0; y < images[1]; ++y) {
      for (int z = 0; z < images[2]; ++z) f(image[0][x] + 3 * image[1][y] + 9 * image[2][z]);
    }
  }
}

void size_cells(const SearchInput& in, std::size_t entries, double largest, double reach,
                GridLevel& level) {
  level.cell = std::max(2 * largest + in.slack, 1e-12);
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

struct Chunks {
  std::size_t points;
  std::size_t count() const { return (points + kChunk - 1) / kChunk; }
  template <class F>
  void each(std::size_t chunk, const F& f) const {
    for (std::size_t p = chunk * kChunk; p < std::min(points, (chunk + 1) * kChunk); ++p) f(p);
  }
};

// Sizes of all points and by level; sets half paths.
ChunkSizes measure(const SearchInput& in, const Chunks& chunks, const RunTasks& run) {
  std::vector<ChunkSizes> part(chunks.count());
  ChunkSizes all;
  run(chunks.count(), [&](std::size_t chunk) {
    chunks.each(chunk, [&](std::size_t p) {
      SearchPoint& point = in.point[p];
      part[chunk].smallest = std::min(part[chunk].smallest, point.radius);
      part[chunk].largest = std::max(part[chunk].largest, point.radius);
      const double v2 = static_cast<double>(point.v[0] * point.v[0] + point.v[1] * point.v[1] +
                                            point.v[2] * point.v[2]);
      // Rounded up: the f32 reject has to be conservative.
      point.half_path = static_cast<float>(0.500001 * in.window * std::sqrt(v2));
    });
  });
  for (const ChunkSizes& c : part) {
    all.smallest = std::min(all.smallest, c.smallest);
    all.largest = std::max(all.largest, c.largest);
  }
  if (in.count == 0) all.smallest = all.largest = 1;
  run(chunks.count(), [&](std::size_t chunk) {
    chunks.each(chunk, [&](std::size_t p) {
      const SearchPoint& point = in.point[p];
      LevelSizes& level = part[chunk].level[level_of(point.radius, all.smallest)];
      level.reach = std::max(level.reach, reach_of(point));
      level.radius = std::max(level.radius, point.radius);
      ++level.members;
    });
  });
  for (const ChunkSizes& c : part) {
    for (std::size_t l = 0; l < kMaxLevels; ++l) {
      all.level[l].reach = std::max(all.level[l].reach, c.level[l].reach);
      all.level[l].radius = std::max(all.level[l].radius, c.level[l].radius);
      all.level[l].members += c.level[l].members;
    }
  }
  return all;
}

std::vector<LevelPlan> plan_levels(const SearchInput& in, const ChunkSizes& sizes,
                                   SearchGrid& grid) {
  grid.smallest_radius = sizes.smallest;
  const std::size_t levels = level_of(sizes.largest, sizes.smallest) + 1;
  grid.levels.resize(levels);
  double extent = 0, searcher = 0;
  for (std::size_t a = 0; a < 3; ++a) extent = std::max(extent, in.box.high[a] - in.box.low[a]);
  grid.margin = 0;
  std::vector<LevelPlan> plan(levels);
  std::size_t slabs = 0;
  for (std::size_t l = 0; l < levels; ++l) {
    const LevelSizes& size = sizes.level[l];
    GridLevel& level = grid.levels[l];
    searcher = std::max(searcher, size.reach);
    const double reach = searcher + size.reach + in.slack;
    size_cells(in, size.members, size.radius, reach, level);
    level.reach = size.reach;
    grid.margin = std::max(grid.margin, 4e-7 * (extent + 8 * reach));
    plan[l].image_reach = reach;
    plan[l].cells = level.row(0, level.count[2]);
    plan[l].cells_a_slab = (plan[l].cells + kMostSlabs - 1) / kMostSlabs;
    plan[l].first_slab = slabs;
    slabs += (plan[l].cells + plan[l].cells_a_slab - 1) / plan[l].cells_a_slab;
  }
  // Searchers are binned by their middle place, which may lie a half path beyond the face.
  for (LevelPlan& p : plan) p.image_reach += 2 * grid.margin;
  return plan;
}

// Sorts the staged entries of a slab into its cells.
void fill_slab(const SearchInput& in, const LevelPlan& plan, std::size_t slab,
               const StagedEntry* staged, std::size_t count, Index first, GridLevel& level) {
  const std::size_t low = slab * plan.cells_a_slab;
  const std::size_t high = std::min(plan.cells, low + plan.cells_a_slab);
  Index* begin = level.begin.data();
  std::fill(begin + low, begin + high, 0);
  for (std::size_t e = 0; e < count; ++e) ++begin[staged[e].cell];
  Index end = first;
  for (std::size_t c = low; c < high; ++c) begin[c] = end += begin[c];
  for (std::size_t e = count; e-- > 0;) {
    // Backwards, moving each cell's end down to its begin: entries keep their order in a cell.
    const StagedEntry& from = staged[e];
    const Index at = --begin[from.cell];
    const SearchPoint& p = in.point[from.point];
    const std::array<float, 3> place = place_of(in, level, p, from.image);
    level.particle[at] = from.point;
    level.x[at] = place[0];
    level.y[at] = place[1];
    level.z[at] = place[2];
    level.vx[at] = p.v[0];
    level.vy[at] = p.v[1];
    level.vz[at] = p.v[2];
    level.reach_of[at] = static_cast<float>(reach_of(p));
    level.radius[at] = static_cast<float>(p.radius);
  }
}

}  // namespace

void build_grid(const SearchInput& in, SearchGrid& grid, const RunTasks& run) {
  const Chunks chunks = {in.count};
  const std::vector<LevelPlan> plan = plan_levels(in, measure(in, chunks, run), grid);
  const std::size_t levels = plan.size(), parts = chunks.count();
  const std::size_t slabs =
      plan.back().first_slab +
      (plan.back().cells + plan.back().cells_a_slab - 1) / plan.back().cells_a_slab;
  // Where the entries of each slab begin, chunk by chunk.
  std::vector<Index>& begin = grid.begin;
  begin.assign(slabs * parts + 1, 0);
  const auto for_entries = [&](std::size_t chunk, const auto& f) {
    chunks.each(chunk, [&](std::size_t p) {
      const SearchPoint& point = in.point[p];
      const std::size_t l = level_of(point.radius, grid.smallest_radius);
      for_images(in, point, reach_of(point) + plan[l].image_reach, [&](std::uint32_t image) {
        const Index cell = cell_of(grid.levels[l], place_of(in, grid.levels[l], point, image));
        const std::size_t slab = plan[l].first_slab + cell / plan[l].cells_a_slab;
        f(slab * parts + chunk, StagedEntry{static_cast<Index>(p), cell, image});
      });
    });
  };
  run(parts, [&](std::size_t chunk) {
    for_entries(chunk, [&](std::size_t at, const StagedEntry&) { ++begin[at + 1]; });
  });
  for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  Column<StagedEntry> staged;
  staged.reset(begin.back());
  run(parts, [&](std::size_t chunk) {
    std::vector<Index> to(slabs);
    for (std::size_t slab = 0; slab < slabs; ++slab) to[slab] = begin[slab * parts + chunk];
    for_entries(
        chunk, [&](std::size_t at, const StagedEntry& entry) { staged[to[at / parts]++] = entry; });
  });
  std::vector<std::size_t> level_of_slab(slabs, levels - 1);
  for (std::size_t l = 0; l < levels; ++l) {
    GridLevel& level = grid.levels[l];
    const std::size_t last = l + 1 < levels ? plan[l + 1].first_slab : slabs;
    const Index entries = begin[last * parts] - begin[plan[l].first_slab * parts];
    level.begin.reset(plan[l].cells + 1);
    level.begin[plan[l].cells] = entries;
    level.particle.reset(entries);
    for (Column<float>* c : {&level.x, &level.y, &level.z, &level.vx, &level.vy, &level.vz,
                             &level.reach_of, &level.radius}) {
      c->reset(entries);
    }
    std::fill(level_of_slab.begin() + static_cast<std::ptrdiff_t>(plan[l].first_slab),
              level_of_slab.begin() + static_cast<std::ptrdiff_t>(last), l);
  }
  run(slabs, [&](std::size_t slab) {
    const std::size_t l = level_of_slab[slab];
    const Index first = begin[slab * parts];
    fill_slab(in, plan[l], slab - plan[l].first_slab, staged.data() + first,
              begin[(slab + 1) * parts] - first, first - begin[plan[l].first_slab * parts],
              grid.levels[l]);
  });
}

}  // namespace quern
