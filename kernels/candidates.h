// Neighbour search: grids by size level, and the pairs that may touch before the lists go stale.
//
// A pair is listed if the straight-line relative motion of its partners (known velocities) brings
// their gap below the slack at any moment of the coming window. Such a list is complete as long as
// no particle has left its own straight line by more than half the slack, however fast the bed as a
// whole travels. Particles are binned where they will be in the middle of the window.
//
// Sizes are sorted into levels of a factor of two. Each particle searches its own level and all
// coarser ones, and keeps partners that are larger (ties: of higher identity): every pair is found
// exactly once, by its owner. Copies of particles near a periodic face stand in for their images.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "soa/column.h"
#include "soa/record.h"

namespace quern {

struct SearchBox {
  std::array<double, 3> low{}, high{};  // bounds of all centres, m
  std::array<double, 3> period{};       // 0: not periodic
};

// Cells low ... high, both included.
struct CellBlock {
  std::array<int, 3> low{}, high{};

  std::size_t cells() const {
    std::size_t n = 1;
    for (std::size_t a = 0; a < 3; ++a) n *= static_cast<std::size_t>(high[a] - low[a] + 1);
    return n;
  }
};

// One level: entries sorted by cell, cells x-fastest. Positions are those in the middle of the
// window, f32 relative to `low`: used for a conservative reject only.
struct GridLevel {
  double cell = 0;          // m
  double inverse_cell = 0;  // 1/m
  double reach = 0;         // m, largest radius + half path + slack of an entry
  std::array<double, 3> low{};
  std::array<int, 3> count{};
  Column<Index> begin;     // cells + 1
  Column<Index> particle;  // index in the current order
  Column<float> x, y, z, vx, vy, vz;
  Column<float> reach_of, radius;  // reach of each entry: radius + half path

  std::size_t row(int y_cell, int z_cell) const {
    return (static_cast<std::size_t>(z_cell) * static_cast<std::size_t>(count[1]) +
            static_cast<std::size_t>(y_cell)) *
           static_cast<std::size_t>(count[0]);
  }
};

// One of those that search: its place in the middle of the window, its velocity, radius, and radius
// plus half path.
struct Searcher {
  std::array<float, 3> x, v;
  float radius, reach;
};

// Around the middles of searchers, relative to the low corner of a level, m.
struct MiddleBox {
  std::array<float, 3> low{}, high{};
};

// Entries of some cells, one after the other.
struct NearEntries {
  std::vector<float> x, y, z, vx, vy, vz, reach, radius;
  std::vector<Index> particle;
  std::size_t count = 0;
};

// A point or one of its images on the way to its cell.
struct StagedEntry {
  Index point, cell;
  std::uint32_t image;
};

struct SearchGrid {
  std::vector<GridLevel> levels;
  double smallest_radius = 0;
  double margin = 0;         // m, rounding of the f32 positions
  std::vector<Index> begin;  // working memory of build_grid()
};

// What the search looks at of a random partner, in one cache line.
struct alignas(64) SearchPoint {
  std::array<double, 3> x;  // place, m
  double radius;            // m
  std::array<float, 3> v;   // velocity, m/s
  float half_path;          // |v| window / 2, m; set by build_grid()
  Index id;
};

struct SearchInput {
  SearchPoint* point;
  std::size_t count;
  SearchBox box;
  double window;  // s
  double slack;   // m
};

// Difference of two places inside a period, as the nearest image has it.
inline double nearest_image(double dx, double period) {
  if (dx > 0.5 * period) return dx - period;
  return dx < -0.5 * period ? dx + period : dx;
}

inline double reach_of(const SearchPoint& p) { return p.radius + static_cast<double>(p.half_path); }

inline constexpr std::size_t kMaxLevels = 16;

inline std::size_t level_of(double radius, double smallest) {
  std::size_t level = 0;
  for (double end = 2 * smallest; radius >= end && level < kMaxLevels - 1; end *= 2) ++level;
  return level;
}

inline int cell_along(const GridLevel& level, std::size_t axis, double offset) {
  const double last = level.count[axis] - 1;
  return static_cast<int>(std::clamp(offset * level.inverse_cell, 0.0, last));
}

struct CandidatePair {
  Index i, j;
  float gap;    // m, the smallest on straight lines in the window, rounded down
  float speed;  // m/s, of one relative to the other
};

// Runs task(k) for k = 0 ... count - 1, in any order and on any number of threads.
using RunTasks = std::function<void(std::size_t, const std::function<void(std::size_t)>&)>;

// Builds the levels. May allocate.
void build_grid(const SearchInput& in, SearchGrid& grid, const RunTasks& run);

// Appends the own pairs of particles first ... last-1, sorted by (i, j).
void find_candidates(const SearchInput& in, const SearchGrid& grid, Index first, Index last,
                     std::vector<CandidatePair>& out);

}  // namespace quern
