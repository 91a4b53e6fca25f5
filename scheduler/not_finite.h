// Who brought in a number that is not finite.
//
// Within a step such a number spreads to all that a particle touches. Where it came from is told by
// what was there before the step: first particles, then what contacts remember, then what is read
// at the end of the step only. A look at everything, for the message of a run that stops.
#pragma once

#include "kernels/polyhedron_contacts.h"
#include "soa/world.h"

namespace quern {

template <class Real>
struct BeforeStep {
  const Column<Record<Real>>* records;  // in the order of now
  const Column<Traits<Real>>* traits;
  const BodyTable* bodies = nullptr;  // null: none, or not known
  Offender contact;                   // whose history was not finite, or whose forces are not
};

// Lowest identities first; kNoIndex: all is finite, or it was what a contact forgot in this step.
template <class Real>
Offender find_not_finite(const World<Real>& world, const BeforeStep<Real>& before);

// Whether the lists can be built: places and velocities.
template <class Real>
bool is_listable(const World<Real>& world);

}  // namespace quern
