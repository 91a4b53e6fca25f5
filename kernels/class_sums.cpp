#include "kernels/class_sums.h"

#include <cmath>

namespace quern {
namespace {

// Squared length of row i of n x 3.
double squared(const std::vector<float>& vectors, std::size_t i) noexcept {
  double sum = 0;
  for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
    sum += static_cast<double>(vectors[k]) * static_cast<double>(vectors[k]);
  }
  return sum;
}

}  // namespace

bool inside(const ZoneSpec& zone, double x, double y) noexcept {
  constexpr double kTurn = 2 * kPi, kRounding = 1e-12;
  const double radius = std::hypot(x, y);
  if (radius < zone.radius_from || (zone.radius_to && radius >= *zone.radius_to)) return false;
  double span = zone.angle_to - zone.angle_from;
  if (std::abs(span) >= kTurn * (1 - kRounding)) return true;
  if (span < 0) span += kTurn;
  const double way = (std::atan2(y, x) - zone.angle_from) / kTurn;
  return (way - std::floor(way)) * kTurn < span;
}

ClassSums sum_classes(const ParticleFrame& frame, const EnergyFrame& energy, std::size_t classes,
                      const ZoneSpec* zone) {
  const std::vector<double> none(classes, 0);
  ClassSums sums{none, none, none, none};
  for (std::size_t i = 0; i < frame.radius.size(); ++i) {
    const std::size_t row = frame.size_class[i];
    if (row >= classes) continue;
    if (zone && !inside(*zone, frame.position[3 * i], frame.position[3 * i + 1])) continue;
    sums.count[row] += 1;
    sums.spin[row] += std::sqrt(squared(frame.spin, i));
    sums.kinetic_energy[row] += 0.5 * energy.mass[i] * squared(frame.velocity, i);
    sums.rotational_energy[row] += energy.rotational_energy[i];
  }
  return sums;
}

}  // namespace quern
