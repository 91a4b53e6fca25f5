// Snapshots: a World as the plain arrays that files are made of, in order of identity.
#pragma once

#include <optional>

#include "soa/output.h"
#include "soa/world.h"

namespace quern {

// A place, wrapped into the domain where it is periodic.
template <class Real>
Vec3 wrapped(const World<Real>& world, Vec3 x);

template <class Real>
ParticleFrame particle_frame(const World<Real>& world);

template <class Real>
EnergyFrame energy_frame(const World<Real>& world);

// Nothing for a scene without polyhedra.
template <class Real>
std::optional<PolyhedronFrame> polyhedron_frame(const World<Real>& world);

// A shape in its body frame, in units of its equivalent radius.
SurfaceFrame shape_surface(const Shape& shape);

// All walls at their pose now, in the world frame.
template <class Real>
WallFrame wall_frame(const World<Real>& world);

}  // namespace quern
