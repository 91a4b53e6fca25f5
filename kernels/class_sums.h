// What each size class does at one moment, in the whole mill or in a zone of its cross-section:
// sums over its particles, from which means over time follow.
#pragma once

#include <vector>

#include "soa/output.h"
#include "soa/scene.h"

namespace quern {

// One value a class; energies from half-step velocities and spins.
struct ClassSums {
  std::vector<double> count;
  std::vector<double> spin;               // rad/s, sum of |w|
  std::vector<double> kinetic_energy;     // J, translational
  std::vector<double> rotational_energy;  // J
};

// Whether a place (m, mill coordinates) lies in the zone: its lower bounds do, its upper ones not.
bool inside(const ZoneSpec& zone, double x, double y) noexcept;

// `zone` null: all particles. Particles of no class are left out; sums are in order of identity.
ClassSums sum_classes(const ParticleFrame& frame, const EnergyFrame& energy, std::size_t classes,
                      const ZoneSpec* zone);

}  // namespace quern
