// Trials: short runs that measure what a formula only estimates.
#pragma once

#include <vector>

#include "soa/scene.h"

namespace quern {

// A dense packing of a scene's finest class on a wall, with fewer and fewer steps per contact: does
// it come to rest?
struct StabilityPoint {
  double steps_per_contact = 0;
  double energy = 0;    // median kinetic energy of a particle, J
  bool stable = false;  // came to rest: energy below 1e-9 m g d
};
struct StabilityTrial {
  double limit = 0;  // fewest steps per contact with which the packing came to rest; 0: none
  std::vector<StabilityPoint> points;
};

// `particles` spheres with diameters uniform in [from, to], periodic sideways, on a floor of
// `wall_material`; all with the law of the scene. Runs a few seconds on one thread.
struct TrialSpec {
  std::size_t particles = 160;
  double from = 0, to = 0;  // m
  std::string material, wall_material;
  std::vector<double> steps_per_contact = {8, 6.5, 5.2, 4.4, 4.0, 3.6, 3.2, 2.8, 2.5, 2.2};
  double patience = 5;  // s, for a packing to come to rest: a soft one swings for long
};
StabilityTrial measure_stability(const Scene& scene, const TrialSpec& spec);

// The finest class of the scene against its first wall.
TrialSpec finest_class_trial(const Scene& scene);

}  // namespace quern
