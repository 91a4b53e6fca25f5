// FillRegion: where a fill may put spheres, and how much of it lies below a level.
//
//   with a mill    inside its polygon with lifters, cut by fill.low/high where they are given
//   else           fill.low/high; or the first box; or the bounds of the meshes; or the domain
//   always         within the domain where it is given; on the side of the normal of every plane;
//                  with meshes, of the nearest facet
//
// A sphere has to lie inside as a whole, except that its centre may be anywhere along an axis whose
// full period the region covers. Two questions are kept apart because their prices differ: admits()
// is arithmetic on the scene's numbers and is asked for every draw; clear_of_walls() measures the
// distance to facets and is asked only for a sphere that overlaps no other. Walls are at t = 0.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "scheduler/sphere_grid.h"
#include "soa/facets.h"

namespace quern {

// The cross-section of a mill with its lifters, its sides binned by angle: contains() looks at a
// few sides only, where profile_contains() looks at all.
class MillSection {
 public:
  explicit MillSection(const MillSpec& mill);

  // Within `clear_radius` of the axis there is no wall; beyond `outer_radius` no charge.
  double clear_radius() const { return clear_radius_; }
  double outer_radius() const { return outer_radius_; }
  bool contains(double x, double y) const;

 private:
  struct Side {
    double ax, ay, bx, by;
  };
  std::size_t bin_of(double x, double y) const;

  double clear_radius_ = 0, outer_radius_ = 0;
  std::vector<std::vector<Side>> bins_;  // by angle about the axis
};

class FillRegion {
 public:
  // Throws UserError where the scene gives no region. `walls` outlive the region.
  FillRegion(const Scene& scene, std::span<const Facets* const> walls);

  const Vec3& low() const { return low_; }
  const Vec3& high() const { return high_; }
  const PeriodicAxes& periodic() const { return periodic_; }

  // Height against gravity; 0 everywhere without gravity.
  double height(const Vec3& x) const { return up_.dot(x); }
  const Vec3& up() const { return up_; }

  // Bounds for the centre of a sphere along the axes.
  Vec3 low_for(double radius) const { return low_ + radius * inset_; }
  Vec3 high_for(double radius) const { return high_ - radius * inset_; }

  bool admits(const Vec3& x, double radius) const;
  bool clear_of_walls(const Vec3& x, double radius) const;

  // A column of this height on top of an open box, with the box or instead of it; never beyond the
  // domain.
  void extend_above_box(double height);
  void move_above_box(double height);
  // For insertion from above where nothing is open.
  void keep_upper_half();

 private:
  struct HalfSpace {
    Vec3 normal;
    double offset;  // normal . x >= offset inside
  };

  void choose_bounds(const Scene& scene);
  bool bound_by_walls_only(const Scene& scene);
  void intersect(const Vec3& low, const Vec3& high);
  bool on_inner_side(const Vec3& x) const;
  int main_axis() const;

  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
  Vec3 domain_low_, domain_high_;  // infinite where not given
  Vec3 inset_ = Vec3::Ones();      // 0 along a full period
  Vec3 up_ = Vec3::Zero();
  PeriodicAxes periodic_;
  std::optional<MillSection> mill_;
  bool only_mill_ = false;  // no wall but the mill
  bool sided_ = false;      // meshes: ask for the side of the nearest facet
  std::vector<HalfSpace> half_spaces_;
  std::vector<const Facets*> walls_;
};

// The region is that of a box open at its top, so particles can fall in from above it.
bool is_open_box(const Scene& scene);

// Height of the column over the box's cross-section with this volume.
double column_height(const FillRegion& box, double volume);

// Volume of the region below a height, by a fixed low-discrepancy set of points.
class LevelTable {
 public:
  explicit LevelTable(const FillRegion& region);
  double volume() const { return volume_; }
  // The height below which lies this volume; the top for the whole volume or more.
  double level_for(double volume) const;

 private:
  double volume_ = 0, top_ = 0;
  std::vector<double> heights_;  // ascending, of equal shares of the volume
};

}  // namespace quern
