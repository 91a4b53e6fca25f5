// WallSpring: what an open contact of a particle with a wall remembers from the last step.
//
// Plain data, saved as bytes; vectors in the world frame.
#pragma once

#include "soa/base.h"

namespace quern {

struct WallSpring {
  Index wall = 0, feature = 0;
  Vec3 spring = Vec3::Zero();  // tangential spring xi, m
  Vec3 force = Vec3::Zero();   // on the particle, N
  Vec3 normal = Vec3::Zero();  // unit, to the particle
  Vec3 point = Vec3::Zero();   // contact point, m
  Vec3 moment = Vec3::Zero();  // rolling, on the particle, N m
  double overlap = 0;          // m
  Index particle = kNoIndex;   // in the current order
  Index reserved = 0;          // keeps the saved bytes defined
};
static_assert(sizeof(WallSpring) == 16 * 8 + 16, "saved as bytes: no hidden padding");

}  // namespace quern
