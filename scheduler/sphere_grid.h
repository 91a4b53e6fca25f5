// SphereGrid: the spheres placed so far, for "does this one overlap any of them?" at set-up.
//
// Radii may differ a hundredfold, so spheres are kept in levels by halves of the largest radius,
// each with its own grid of cells as wide as its largest sphere. Cells are hashed into a table as
// long as the level needs: memory follows the number of spheres, not the volume, and a collision
// only costs a comparison. A query looks at 8 to 27 cells a level when it comes no larger than the
// spheres in the grid (largest first). Periodic axes are wrapped and distances are to the nearest
// image.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "soa/scene.h"

namespace quern {

struct PeriodicAxes {
  std::array<bool, 3> on = {false, false, false};
  Vec3 low = Vec3::Zero();
  Vec3 length = Vec3::Ones();  // used where `on`

  bool any() const { return on[0] || on[1] || on[2]; }

  Vec3 wrapped(Vec3 x) const {
    for (int a = 0; a < 3; ++a) {
      if (on[static_cast<std::size_t>(a)]) {
        x[a] -= length[a] * std::floor((x[a] - low[a]) / length[a]);
      }
    }
    return x;
  }

  // Of the difference of two wrapped positions.
  Vec3 nearest_image(Vec3 difference) const {
    for (int a = 0; a < 3; ++a) {
      if (!on[static_cast<std::size_t>(a)]) continue;
      if (difference[a] > 0.5 * length[a]) difference[a] -= length[a];
      if (difference[a] < -0.5 * length[a]) difference[a] += length[a];
    }
    return difference;
  }
};

// Periodic axes of the domain, and z of a mill with periodic ends. Throws UserError for a periodic
// axis without bounds.
PeriodicAxes periodic_axes(const Scene& scene);

class SphereGrid {
 public:
  // `radii`: those of all the spheres that will be inserted.
  SphereGrid(const PeriodicAxes& periodic, std::span<const double> radii);

  void insert(const Vec3& position, double radius, Index tag);

  // No inserted sphere overlaps this one (touching is free).
  bool is_free(const Vec3& position, double radius) const {
    return !visit(position, radius, [](Index, double) { return true; });
  }

  // Calls on_overlap(tag, overlap in m) for the inserted spheres that overlap this one, until it
  // returns true; returns whether it did.
  template <class OnOverlap>
  bool visit(const Vec3& position, double radius, OnOverlap&& on_overlap) const {
    const Vec3 x = periodic_.wrapped(position);
    for (const Level& level : levels_) {
      if (level.count > 0 && visit_level(level, x, radius, on_overlap)) return true;
    }
    return false;
  }

 private:
  struct Entry {
    Vec3 position;
    double radius;
    Index tag;
    Index next;  // in the same bucket
  };
  struct Level {
    double max_radius = 0;
    Vec3 inverse_cell = Vec3::Zero();                // 1/m
    std::array<std::int64_t, 3> around = {0, 0, 0};  // cells in a period; 0: not periodic
    std::vector<Index> bucket;                       // first entry, length a power of two
    std::size_t count = 0;
  };
  struct CellRange {
    std::array<std::int64_t, 3> from, to;
  };

  std::size_t level_of(double radius) const;
  CellRange cells_within(const Level& level, const Vec3& x, double reach) const;

  static std::uint64_t hash_axis(const Level& level, std::size_t axis, std::int64_t cell) {
    constexpr std::array<std::uint64_t, 3> kPrime = {73856093u, 19349663u, 83492791u};
    const std::int64_t n = level.around[axis];
    if (n > 0) cell = cell < 0 ? cell + n : (cell >= n ? cell - n : cell);
    return static_cast<std::uint64_t>(cell) * kPrime[axis];
  }

  template <class OnOverlap>
  bool visit_bucket(Index head, const Vec3& x, double radius, OnOverlap&& on_overlap) const {
    for (Index k = head; k != kNoIndex; k = entries_[k].next) {
      const Entry& e = entries_[k];
      const double reach = radius + e.radius;
      const double distance2 = periodic_.nearest_image(x - e.position).squaredNorm();
      if (distance2 < reach * reach && on_overlap(e.tag, reach - std::sqrt(distance2))) return true;
    }
    return false;
  }

  template <class OnOverlap>
  bool visit_level(const Level& level, const Vec3& x, double radius, OnOverlap&& on_overlap) const {
    const auto [from, to] = cells_within(level, x, radius + level.max_radius);
    const std::uint64_t mask = level.bucket.size() - 1;
    for (std::int64_t k = from[2]; k <= to[2]; ++k) {
      const std::uint64_t hz = hash_axis(level, 2, k);
      for (std::int64_t j = from[1]; j <= to[1]; ++j) {
        const std::uint64_t hyz = hz ^ hash_axis(level, 1, j);
        for (std::int64_t i = from[0]; i <= to[0]; ++i) {
          const Index head = level.bucket[(hyz ^ hash_axis(level, 0, i)) & mask];
          if (visit_bucket(head, x, radius, on_overlap)) return true;
        }
      }
    }
    return false;
  }

  PeriodicAxes periodic_;
  std::vector<Level> levels_;  // coarse to fine; each half the one before
  std::vector<Entry> entries_;
};

}  // namespace quern
