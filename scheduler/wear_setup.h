// What the scene says of wear, in the World: the cells of its walls, all sums at zero.
#pragma once

#include "soa/world.h"

namespace quern {

// Nothing where the scene has no [wear]. Throws UserError where the cells would be too many.
template <class Real>
void set_wear(World<Real>& world, const Scene& scene);

}  // namespace quern
