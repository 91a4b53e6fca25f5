// Strays: spheres and polyhedra that have left the straight line which the lists were made for by
// more than they may, or turned by more. One of a hundred thousand is hit hard in every other step;
// the lists are good for all others.
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
  // The spheres of these tiles, and the polyhedra, that strayed; places are those after the step,
  // whose clock has moved on. Returns whether the lists are complete again.
  bool relist(World<Real>& world, const std::vector<std::size_t>& tiles);
  void forget() { groups_.clear(); }  // the lists are new

 private:
  // Neighbours along the curve: where their lines begin, how fast they go, how far they reach.
  struct Group {
    Vec3 low, high;
    double speed, reach;
  };
  struct Line {
    Index particle;        // or polyhedron
    Vec3 place, velocity;  // of now, the velocity rounded to f32
    double radius;         // or reach of a polyhedron about its place
    double allowance;
  };
  // How near two lines come while the lists live, at least, whichever images are taken.
  struct Meeting {
    Vec3 apart;  // now, nearest image
    double distance;
    bool nearest_only;  // no other image comes as near
  };

  void find_strays(const World<Real>& world, const std::vector<std::size_t>& tiles);
  void enclose(const World<Real>& world, std::size_t group);
  template <class Columns>
  Line line_of(const Columns& p, std::size_t k, double radius) const;
  Line line_of_sphere(const World<Real>& world, std::size_t k) const;
  Line line_of_body(const World<Real>& world, std::size_t k) const;
  Meeting meet(const World<Real>& world, const Line& a, const Line& b) const;
  double plane_gap(const World<Real>& world, Index body, const Line& sphere, const Line& line,
                   const Meeting& meeting, double turn) const;
  template <class Visit>
  void for_spheres_near(const World<Real>& world, const Line& stray, const Visit& visit) const;
  double room_among_spheres(const World<Real>& world, const Line& stray) const;
  double room_among_bodies(const World<Real>& world, const Line& stray) const;
  bool relist_sphere(World<Real>& world, std::size_t k);
  bool relist_body(World<Real>& world, std::size_t k);

  std::vector<Group> groups_;
  std::vector<std::size_t> spheres_, bodies_;  // strays
  double elapsed_ = 0, remaining_ = 0;         // s
};

}  // namespace quern
