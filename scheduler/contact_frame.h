// All contacts of a World as the plain arrays that files are made of: who, where, how hard.
//
// For any moment between two steps; what it tells is of the step before, see soa/output.h. Read off
// the histories that contacts keep anyway, so that a step costs nothing more. Only the geometry of
// two spheres is worked out anew, from their places before they moved, x - dt v. The order follows
// identities and not tiles or lists: the arrays are the same for any number of threads.
#pragma once

#include "soa/output.h"
#include "soa/world.h"

namespace quern {

template <class Real>
ContactFrame contact_frame(const World<Real>& world);

}  // namespace quern
