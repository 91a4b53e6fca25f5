// What the liner feels around the shell: one call for each contact with it in each step fills the
// histogram that head and impact toe are read off (find_liner_angles in charge_map.h).
//
// Angles are those of the contact point about the mill's axis, in mill coordinates. A hit is a
// contact that began with an approach faster than 0.2 omega R; it stays one until it opens.
#pragma once

#include <cmath>

#include "soa/charge_shape.h"

namespace quern {

enum class LinerTouch { kSlow, kHit };

// How fast (m/s) an approach makes a hit, in a shell of `radius` that turns at `rate` (rad/s).
inline double hit_speed(double rate, double radius) noexcept {
  return 0.2 * std::abs(rate) * radius;
}

// A contact at `angle` (rad, any turn) over a step of `dt` (s) that lost `normal_dissipation` (J)
// to damping along the normal. The histogram is made by make_liner_histogram().
inline void add_to_liner(double angle, double dt, double normal_dissipation, LinerTouch touch,
                         LinerHistogram& liner) noexcept {
  const double turns = angle / (2 * kPi);
  const std::size_t bins = liner.contact_time.size();
  // Just below a full turn the product may round up to it.
  const std::size_t bin =
      static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(bins)) % bins;
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
