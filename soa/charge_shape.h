// The shape of the charge in a mill's cross-section: the map of its solid fraction, the angles read
// off it, and what the liner felt around the shell. Plain records between kernels/charge_map, which
// computes them, and io/charge_picture, which draws them.
//
// Mill coordinates: the mill's axis is +z through the origin, at rest while the shell turns. Angles
// are counterclockwise from +x as seen from +z, whichever way the mill turns. A cell (ring, angle)
// is at [ring * angles + angle], rings from the axis outwards, angles from +x:
//
//   ring k from k * ring_width to (k + 1) * ring_width, the last one ends at the shell
//   angle a from a * 2 pi / angles to (a + 1) * 2 pi / angles
#pragma once

#include <vector>

#include "soa/base.h"

namespace quern {

struct PolarGrid {
  int angles = 0, rings = 0;  // angles is even: beyond the axis lies the cell angles / 2 further
  double radius = 0;          // m, of the shell

  double ring_width() const { return radius / rings; }
  double angle_step() const { return 2 * kPi / angles; }
  double cell_area() const { return 0.5 * angle_step() * ring_width() * ring_width(); }
  double area(int ring) const { return cell_area() * (2 * ring + 1); }
  double middle_radius(int ring) const { return (ring + 0.5) * ring_width(); }
  double middle_angle(int angle) const { return (angle + 0.5) * angle_step(); }
  std::size_t cells() const {
    return static_cast<std::size_t>(angles) * static_cast<std::size_t>(rings);
  }
  std::size_t cell(int ring, int angle) const {
    return static_cast<std::size_t>(ring) * static_cast<std::size_t>(angles) +
           static_cast<std::size_t>(angle);
  }
  bool operator==(const PolarGrid&) const = default;
};

// Solid volume seen in each cell, summed over snapshots, and what that volume carries: amounts that
// each particle has, as its velocity, or 1 for those of a group and 0 for all others.
struct ChargeMap {
  PolarGrid grid;
  double length = 0;  // m, of the mill along its axis
  double snapshots = 0;
  std::vector<double> volume;   // m^3 per cell
  std::size_t amounts = 0;      // of a particle
  std::vector<double> carried;  // cells x amounts, row-major: volume times amount
};

// What the finder needs to know of the mill.
struct ChargeQuery {
  double direction = 1;      // 1: the mill turns counterclockwise, -1: clockwise
  double lifter_height = 0;  // m
  double particle_size = 0;  // m, the median diameter d50 by volume
  double up = kPi / 2;       // rad, the angle against gravity
  double cut = 0.5;          // of the bed's solid fraction: where the bulk ends
};

// Angles in rad. Nothing was found where the map holds no bulk.
struct ChargeShape {
  bool found = false;      // a bulk with a highest point
  bool toe_found = false;  // and an end in the ring of the toe
  double shoulder = 0, bulk_toe = 0;
  double shoulder_radius = 0;         // m, of the highest point
  double bed_fraction = 0;            // phi_bed
  std::vector<double> fraction;       // per cell, solid fraction
  std::vector<std::uint8_t> bulk;     // per cell, 1: of the bulk
  std::vector<double> ring_fraction;  // per angle, in the ring inside the lifters' tops
};

// What the liner felt, by the angle of the contact point in mill coordinates; bins as the angles of
// a PolarGrid.
struct LinerHistogram {
  std::vector<double> contact_time;  // s, summed over contacts
  // J, by normal damping in contacts that began with an approach faster than 0.2 omega R
  std::vector<double> hit_dissipation;

  bool empty() const { return contact_time.empty(); }
};

// One degree: a shell that turns by much more than a bin smooths what its lifters do.
inline constexpr std::size_t kLinerBins = 360;

inline LinerHistogram make_liner_histogram(std::size_t bins = kLinerBins) {
  return {std::vector<double>(bins, 0), std::vector<double>(bins, 0)};
}

struct LinerAngles {
  bool head_found = false;
  bool impacts_found = false;       // else impact_toe is the bulk toe
  double head = 0, impact_toe = 0;  // rad
};

// An angle of the charge with what is known of its accuracy; rad, NaN where unknown. The value is
// that of the whole window.
struct AngleFigure {
  double value, error;    // standard error, from blocks of the window
  double at_low, at_high;  // with the bulk cut at 0.4 and 0.6 of the bed's solid fraction
};

// The angles that one block or one snapshot shows; rad, NaN where not found.
struct FoundAngles {
  double shoulder, toe, head, impact_toe;
};

struct ChargeAngles {
  ChargeShape shape;  // of the whole window
  AngleFigure shoulder, toe, head, impact_toe;
  bool liner_known = false;    // else head and impact toe were not looked for
  bool impacts_found = false;  // else the impact toe is the (bulk) toe
  std::vector<FoundAngles> blocks;
};

}  // namespace quern
