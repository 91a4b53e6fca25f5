// Other programs' narrow phases behind one interface, to be timed beside ours on the same pairs.
//
// A pair is two bodies with their poses; a body without a shape is a ball of radius `scale`. load()
// makes whatever a library keeps for a shape, once, untimed. touch() is what a step would pay: it
// sets both poses and asks for hit, depth and normal. Poses arrive in f64; what a library stores in
// less (Bullet: f32) shows as its error. All of them answer with the least translation that
// separates, so depths compare with ours for balls exactly and for polyhedra near a single touch.
#pragma once

#include <memory>
#include <vector>

#include "soa/shapes.h"

namespace quern::peers {

struct BodyPair {
  ShapePose a, b;
};

struct Hit {
  bool hit = false;
  double depth = 0;            // m, > 0 when they overlap
  Vec3 normal = Vec3::Zero();  // unit, from a to b
};

class Peer {
 public:
  virtual ~Peer() = default;
  virtual const char* name() const = 0;
  virtual void load(const std::vector<BodyPair>& pairs) = 0;
  virtual Hit touch(std::size_t pair) = 0;
};

// libccd GJK/EPA, libccd MPR, FCL with its libccd solver, FCL with its own, Bullet GJK/EPA. A
// pair's shapes must outlive the peer.
std::vector<std::unique_ptr<Peer>> all_peers();

}  // namespace quern::peers
