// A polyhedron as soa/shapes.h lays it out: body frame, unit equivalent radius, padded columns.
//
// This is the last part of build_shape(), without its refusals: a body may be as thin as it likes.
#pragma once

#include "kernels/polyhedron.h"
#include "soa/shapes.h"

namespace quern {

inline constexpr std::size_t kMostCorners = 65535;  // of all faces: twice the edges

// `body` is as convex_hull() gives it, with volume and at most kMostCorners corners.
Shape lay_out_shape(const Polyhedron& body, const std::string& name);

}  // namespace quern
