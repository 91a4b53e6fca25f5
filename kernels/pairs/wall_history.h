// Springs of wall contacts handed from one step to the next.
//
// A contact is known by its wall and feature. When a sphere passes from one feature to another (a
// face to its convex edge, one piece of the shell to the next) the new contact inherits the spring
// of the one that vanished, if both are clearly the same touch: normals with a cosine over 0.9,
// contact points less than 0.2 R apart. Everything is in the world frame. A contact that matches
// nothing starts at zero.
#pragma once

#include <span>

#include "soa/wall_spring.h"

namespace quern {

// The new contacts of one particle, as four arrays of equal length.
struct NewWallContacts {
  std::span<const Index> wall, feature;
  std::span<const Vec3> normal, point;
};

// old_of_new[k] becomes the old contact that new contact k continues, or -1; it has room for all
// new contacts. Both lists are ordered by (wall, feature), without repeats. First equal (wall,
// feature); then each new contact left over takes the first old one left over of its wall that is
// close enough.
void match_wall_springs(std::span<const WallSpring> old, const NewWallContacts& now, double radius,
                        int* old_of_new) noexcept;

}  // namespace quern
