// What the liner feels around the shell: one call for each contact with it in each step fills the
// histogram that head and impact toe are read off (find_liner_angles in charge_map.h).
//
// Bins are of the contact point's angle about the mill's axis, in mill coordinates. A hit is a
// contact that began with an approach faster than 0.2 omega R; it stays one until it opens.
#pragma once

#include <cmath>
#include <cstddef>

#include "soa/charge_shape.h"

namespace quern {

enum class LinerTouch { kSlow, kHit };

// The square of how fast (m/s) an approach makes a hit, in a shell of `radius` that turns at a rate
// of which `rate2` (1/s^2) is the square.
inline double hit_speed2(double rate2, double radius) noexcept {
  return 0.2 * 0.2 * rate2 * radius * radius;
}

// Of kLinerBins, the one of a point at (x, y) from the axis; without its angle, which takes longer.
std::size_t liner_bin(double x, double y) noexcept;

// A contact in a bin over a step of `dt` (s) that lost `normal_dissipation` (J) to damping along
// the normal. The histogram is made by make_liner_histogram().
inline void add_to_liner(std::size_t bin, double dt, double normal_dissipation, LinerTouch touch,
                         LinerHistogram& liner) noexcept {
  liner.contact_time[bin] += dt;
  if (touch == LinerTouch::kHit) liner.hit_dissipation[bin] += normal_dissipation;
}

// Adds a part of the window, or of a step, with the same bins.
inline void add_liner(const LinerHistogram& from, LinerHistogram& to) noexcept {
  for (std::size_t k = 0; k < to.contact_time.size(); ++k) {
    to.contact_time[k] += from.contact_time[k];
    to.hit_dissipation[k] += from.hit_dissipation[k];
  }
}

}  // namespace quern
