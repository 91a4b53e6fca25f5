// Sums of tiles and of stretches of polyhedra into those of the step, always in the same order.
#pragma once

#include <algorithm>

#include "kernels/contact.h"
#include "soa/world.h"

namespace quern {

// `to` is a MoveTally or the StepTotals, which name these sums alike; `fast` is for the caller.
template <class To>
void add_move(const MoveTally& from, To& to) {
  to.translational += from.translational;
  to.rotational += from.rotational;
  to.drag_loss += from.drag_loss;
  to.bad += from.bad;
  to.strays += from.strays;
  to.max_deviation2 = std::max(to.max_deviation2, from.max_deviation2);
  for (std::size_t a = 0; a < 3; ++a) {
    to.momentum[a] += from.momentum[a];
    to.moment_of_mass[a] += from.moment_of_mass[a];
  }
}

inline void add_wall(const WallTotal& from, WallTotal& to) {
  for (std::size_t a = 0; a < 3; ++a) {
    to.force[a] += from.force[a];
    to.torque[a] += from.torque[a];
  }
  to.work += from.work;
}

}  // namespace quern
