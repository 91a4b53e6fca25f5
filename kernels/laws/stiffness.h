// What a law's springs are at an overlap, in scalar f64: for contacts of polyhedra and for advice.
#pragma once

#include <cmath>

#include "soa/force_law.h"

namespace quern {

// By what the stiffnesses of the law's table are multiplied; its dashpots by the root of it.
inline double stiffness_factor(ForceLaw law, double overlap, double reduced_radius) {
  return law == ForceLaw::kHertzMindlin ? std::sqrt(reduced_radius * overlap) : 1;
}

// Energy of the normal spring over its force times the overlap.
inline double stored_share(ForceLaw law) { return law == ForceLaw::kHertzMindlin ? 0.4 : 0.5; }

// Of two radii, both of them finite; a wall has none, and leaves the particle's.
inline double reduced_radius(double a, double b) { return a * b / (a + b); }

}  // namespace quern
