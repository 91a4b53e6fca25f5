// Snapshots: a World as the plain arrays that files are made of, in order of identity.
#pragma once

#include "soa/output.h"
#include "soa/world.h"

namespace quern {

template <class Real>
ParticleFrame particle_frame(const World<Real>& world);

// All walls at their pose now, in the world frame.
template <class Real>
WallFrame wall_frame(const World<Real>& world);

}  // namespace quern
