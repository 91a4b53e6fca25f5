// State hash: 64 bits over everything that decides a run's future, in order of identity.
//
// Places, velocities and spins as stored; springs by (i, j) identity or wall key; contact counts;
// clock; ledger sums. Of polyhedra the same, with orientation and angular momentum. Lists, caches
// (a pair's axis, the spin that follows from the momentum) and the order of records are left out, so
// that two runs that differ in them alone have the same hash. FNV-1a over 64-bit words with a final
// mix.
#pragma once

#include "soa/world.h"

namespace quern {

template <class Real>
std::uint64_t state_hash(const World<Real>& world);

}  // namespace quern
