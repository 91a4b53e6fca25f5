// Strays: spheres that have left the straight line which the lists were made for by more than they
// may. One of a hundred thousand is hit hard in every other step; the lists are good for all
// others.
//
// A stray is given a new line, from where it is with the velocity it has, and the largest allowance
// with which no pair and no facet that the lists lack comes within reach while they live. Only
// where that leaves hardly any room have all lists to be built anew. What is found is a function of
// the lines, the allowances and the lists, all of which are saved; the boxes only spare looking.
#pragma once

#include <vector>

#include "soa/world.h"

namespace quern {

template <class Real>
class Relister {
 public:
  // The spheres of these tiles that strayed; places are those after the step, whose clock has moved
  // on. Returns whether the lists are complete again.
  bool relist(World<Real>& world, const std::vector<std::size_t>& tiles);
  void forget() { groups_.clear(); }  // the lists are new

 private:
  // Neighbours along the curve: where their lines begin, how fast they go, how far they reach.
  struct Group {
    Vec3 low, high;
    double speed, reach;
  };
  struct Line {
    Index particle;
    Vec3 place, velocity;  // of now, the velocity rounded to f32
    double radius, allowance;
  };

  void enclose(const World<Real>& world, std::size_t group);
  double room_among_spheres(const World<Real>& world, const Line& stray) const;
  bool relist_one(World<Real>& world, std::size_t k);

  std::vector<Group> groups_;
  double elapsed_ = 0, remaining_ = 0;  // s
};

}  // namespace quern
