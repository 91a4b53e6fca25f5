// What the liner feels around the shell: contacts with it fill the histogram that head and impact
// toe are read off (find_liner_angles in charge_map.h). What hits dissipate is counted in each
// step; the time in contact, which passes slowly, in one step of kLinerSteps.
//
// Bins are of the contact point's angle about the mill's axis, in mill coordinates. A hit is a
// contact that began with an approach faster than 0.2 omega R; it stays one until it opens.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "soa/charge_shape.h"

namespace quern {

inline constexpr std::uint64_t kLinerSteps = 8;

// s, that each contact counts in a step.
inline double liner_time(std::uint64_t step, double dt) noexcept {
  return step % kLinerSteps == 0 ? static_cast<double>(kLinerSteps) * dt : 0;
}

enum class LinerTouch { kSlow, kHit };

// The square of how fast (m/s) an approach makes a hit, in a shell of `radius` that turns at a rate
// of which `rate2` (1/s^2) is the square.
inline double hit_speed2(double rate2, double radius) noexcept {
  return 0.2 * 0.2 * rate2 * radius * radius;
}

// Of kLinerBins, the one of a point at (x, y) from the axis; without its angle, which takes longer.
std::size_t liner_bin(double x, double y) noexcept;

// A contact in a bin that counts `time` (s) in this step and lost `normal_dissipation` (J) to
// damping along the normal. The histogram is made by make_liner_histogram().
inline void add_to_liner(std::size_t bin, double time, double normal_dissipation, LinerTouch touch,
                         LinerHistogram& liner) noexcept {
  liner.contact_time[bin] += time;
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
