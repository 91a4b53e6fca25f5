// The walls as wear cells, for frames: one triangle a cell, with what it has worn so far.
#pragma once

#include "soa/output.h"
#include "soa/world.h"

namespace quern {

// The world's wear is asked for; the scene gives the models' constants.
template <class Real>
WallFrame wear_frame(const World<Real>& world, const Scene& scene);

}  // namespace quern
