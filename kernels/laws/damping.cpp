#include "kernels/laws/damping.h"

#include <cmath>

namespace quern {

double clamped_restitution(double zeta) {
  if (zeta < 1) {
    const double w = std::sqrt(1 - zeta * zeta);
    // Phase at which the force k x + c v returns to zero.
    const double phase = kPi - std::atan2(2 * zeta * w, 1 - 2 * zeta * zeta);
    return std::exp(-zeta * phase / w);
  }
  if (zeta == 1) return std::exp(-2.0);
  const double w = std::sqrt(zeta * zeta - 1);
  return std::exp(-zeta / w * std::log((zeta + w) / (zeta - w)));
}

double damping_ratio(double restitution, NormalForce normal_force) {
  QUERN_CHECK(restitution > 0 && restitution <= 1);
  if (restitution == 1) return 0;
  if (normal_force == NormalForce::kUnclamped) {
    const double l = std::log(restitution);
    return -l / std::sqrt(kPi * kPi + l * l);
  }
  if (restitution <= kLeastClampedRestitution) return 1;
  double low = 0, high = 1;
  while (high - low > 1e-15) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (clamped_restitution(middle) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double contact_time(double reduced_mass, double stiffness) {
  return kPi * std::sqrt(reduced_mass / stiffness);
}

}  // namespace quern
