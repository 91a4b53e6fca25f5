// Charge map: particles deposited on a polar map of the mill's cross-section, and the angles of the
// charge read off it: shoulder, bulk toe, head, impact toe.
//
// Deposit. A sphere is cut into patches of equal volume, spread over its shadow on the
// cross-section as its chords say. Each patch is a small polar box that is shared exactly between
// the cells it covers. So volume is conserved, a cell smaller than a particle gets its due share,
// and the map is a continuous function of the places: small cells do not alias.
//
// Angles. phi_bed is the 90th percentile of the cells that hold anything. The bulk is the largest
// connected set of cells with phi >= cut phi_bed after a 3 x 3 median. Its end upstream in the ring
// of two d50 inside the lifters' tops is the bulk toe, the angle of its highest point the shoulder.
// Crossings are interpolated between the middles of cells. All is periodic in angle, and a mill
// that turns clockwise gives the mirror image.
#pragma once

#include <span>

#include "soa/charge_shape.h"

namespace quern {

// Median diameter by volume, m; 0 for none.
double median_diameter(std::span<const float> radius);

// Cells of half a d50 along the radius; around, of 1, 2, 4, 6, 10 degrees the first whose arc at
// the shell is no shorter: an industrial mill has 1 degree, a laboratory mill of 300 mm 4 degrees.
// `cell_angle` (rad) and `cell_width` (m) replace the choice where they are not 0; either is
// changed a little so that whole cells fill the shell.
PolarGrid choose_polar_grid(double shell_radius, double d50, double cell_angle = 0,
                            double cell_width = 0);

ChargeMap make_charge_map(const PolarGrid& grid, double length, std::size_t amounts = 0);

// One snapshot: `position` n x 3 in mill coordinates, `radius` n, of the sphere of equal volume,
// `amount` n x map.amounts.
void deposit(std::span<const double> position, std::span<const float> radius,
             std::span<const float> amount, ChargeMap& map) noexcept;
inline void deposit(std::span<const double> position, std::span<const float> radius,
                    ChargeMap& map) noexcept {
  deposit(position, radius, {}, map);
}

// Adds the volumes, what they carry, and the snapshots of a map on the same grid.
void add_snapshots(const ChargeMap& from, ChargeMap& to) noexcept;

// Mean solid fraction of each cell.
std::vector<double> solid_fraction(const ChargeMap& map);
// The part of it that carries an amount: the solid fraction of a group, where the amount is 1 for
// its particles and 0 for all others.
std::vector<double> solid_fraction_carrying(const ChargeMap& map, std::size_t amount);
// Mean of an amount over the volume seen in each cell, 0 where there was none.
std::vector<double> mean_amount(const ChargeMap& map, std::size_t amount);

ChargeShape find_charge_shape(const ChargeMap& map, const ChargeQuery& query);

// Head: the last angle downstream of the bulk's toe, and before the middle of the bare liner, where
// the contact time is at least 2 % of its maximum. Impact toe: going upstream from the bulk toe
// over the bare liner, the angle within which 95 % of the dissipation of hits there lies.
LinerAngles find_liner_angles(const LinerHistogram& liner, const ChargeShape& shape,
                              const ChargeQuery& query);

// From straight below the axis to the line to a place (m, mill coordinates), positive the way the
// mill turns; of the charge's centre of mass it is the dynamic angle. In (-180, 180] degrees, rad.
double dynamic_angle(double x, double y, const ChargeQuery& query) noexcept;

// The angle in [-90, 270) degrees, in rad: a mill's angles, mirrored ones too, lie inside.
double principal_angle(double angle) noexcept;

// The angle that differs from it by whole turns and is nearest to `reference`.
double angle_near(double angle, double reference) noexcept;

}  // namespace quern
