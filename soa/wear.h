// Wear: the facets of walls cut into cells, and what contacts have done to each since recording
// began.
//
//            A            A facet is cut from its apex A, the corner opposite its shortest side,
//            into
//           /_\           strips of equal height, and each strip by rays from A into columns about
//           as
//          /_|_\          wide as a cell is to be. A column of a strip is two cells, of the strip
//          at
//         /_/|\_\         the apex one. Cells are triangles, counterclockwise like their facet.
//        B       C
//
// (Cutting all sides alike would make the long facets of a mill a hundred slivers wide.) Where a
// point lies is found in constant time. Cells are in the frame of the body, so that what is summed
// turns with the wall. The cut follows from the scene; the sums are state, present only where the
// scene asks for wear. Order of the cells: bodies, their facets, strips from the apex, columns.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "soa/column.h"
#include "soa/facets.h"
#include "soa/scene.h"

namespace quern {

// What is summed, a row of these a cell, a wall, a species. What volume that makes, kernels/wear.h.
enum WearSum : std::size_t {
  kSiemEnergy,     // J, of friction, by the rules of SIEM
  kSlidingEnergy,  // J, dissipated by sliding
  kArchardWork,    // N m, normal force times sliding distance
  kFinnieEnergy,   // J, m v^2 times a function of the angle, of first touches
  kNormalImpulse,  // N s
  kShearImpulse,   // N s, of the friction's size
  kWearSums
};
inline constexpr double kMostWearCells = 2e7;
using WearRow = std::array<double, kWearSums>;

// What one contact adds in one step; listed by tiles, then added in their order.
struct WearEntry {
  Index cell;
  std::uint16_t wall, species;
  WearRow sum;
};

struct WearCell {
  std::array<Vec3, 3> corner;  // body frame
  Index facet, body;
  double area() const { return 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm(); }
};

// The cut of one body's facets.
class WearGrid {
 public:
  // Cells about `size` (m) long and wide; they are counted from `first_cell` on.
  WearGrid(const Facets& facets, double size, Index first_cell);
  Index first_cell() const { return strip_cell_.front(); }
  Index end_cell() const { return strip_cell_.back(); }
  // The cell of the point of the facet nearest to x (body frame), near enough for points beside it.
  Index cell_at(Index facet, const Vec3& x) const noexcept;
  // The same, and how far (m) the point may go in any direction without leaving the cell; 0 of one
  // beside the facet.
  Index cell_at(Index facet, const Vec3& x, double& room) const noexcept;
  // Appends all cells in their order.
  void append_cells(const Facets& facets, Index body, std::vector<WearCell>& out) const;

 private:
  struct Sides {  // from the apex
    Vec3 apex, b, c;
  };
  Sides sides(const Facets& facets, Index facet) const;

  // A point beside the apex is at its products with to_b and to_c along b and c: `down` is their
  // sum, 1 at the shortest side, and `along_c` the second.
  struct Cut {
    Vec3 apex, to_b, to_c;
    Index first_strip, strips;
  };
  struct Spot {                                 // in the column of a strip that a point is in
    double down, across;                        // across: from b to c, 0 ... 1
    Index first, row, strips, column, columns;  // first cell of the strip
    double upper() const { return double(row) / strips; }
    double lower() const { return double(row + 1) / strips; }
    // along_c where the diagonal begins, near the apex and b, and ends.
    double begin() const { return upper() * column / columns; }
    double end() const { return lower() * (column + 1) / columns; }
    double beyond_diagonal() const {  // > 0: the cell near b
      return (down - upper()) * (end() - begin()) - (down * across - begin()) * (lower() - upper());
    }
    Index cell() const {
      if (row == 0) return first + column;
      return first + 2 * column + (beyond_diagonal() < 0 ? 1 : 0);
    }
  };
  Spot spot_at(const Cut& cut, const Vec3& x) const noexcept;
  double room_around(const Cut& cut, const Spot& spot) const noexcept;

  std::vector<std::uint8_t> apex_;  // corner of each facet
  std::vector<Cut> cuts_;           // of each facet
  std::vector<Index> strip_cell_;   // first cell of each strip, and the end
};

struct Wear {
  // From the scene; constant. No grids: wear is not asked for.
  std::vector<WearGrid> grids;  // of each body
  WearVelocity velocity = WearVelocity::kLiner;
  double finnie_force_ratio = 2;
  double cell_size = 0;  // m

  // State.
  Column<double> cells, walls, species;  // rows of kWearSums
  Column<double> time;                   // one: s, recorded

  bool recording = false;  // contacts of the next step count; a function of the clock, not saved

  bool asked() const { return !grids.empty(); }
  bool records() const { return recording && asked(); }
  std::size_t cell_count() const { return grids.empty() ? 0 : grids.back().end_cell(); }
  // All sums at zero.
  void clear(std::size_t walls_of_scene, std::size_t species_of_scene);
  bool fits() const { return cells.size() == cell_count() * kWearSums; }
  void add(std::span<const WearEntry> entries);
  void prefetch(std::span<const WearEntry> entries) const;  // soon to be added
  WearRow total_of(const Column<double>& rows, std::size_t row) const;
};

}  // namespace quern
