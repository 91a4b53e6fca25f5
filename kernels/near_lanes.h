// The contacts of a tile's spheres with polyhedra, packed for the law.
//
// Of a group of spheres near one polyhedron one or two touch: lanes of a group would be idle. add()
// takes what touches, or did a step ago, out of one group after another, with its history and what the
// law needs of the polyhedron; view() shows the lanes to push_spheres; give_back() stores histories
// and adds up, in order, what each group does to its polyhedron. Nothing is read of a sphere that
// neither touches nor did.
#pragma once

#include <vector>

#include "kernels/body_contacts.h"
#include "soa/polyhedra.h"

namespace quern {

// Scratch of a worker.
template <class Real>
class NearLanes {
 public:
  // Asks for the histories that the groups [first, last) will need: they lie scattered, and would be
  // waited for one by one.
  void clear(const PolyhedronSphereBatch<Real>& batch, Index first, Index last);
  // The first `count` slots of a group, whose narrow phase is in `found`.
  void add(PolyhedronSphereBatch<Real>& batch, Index group, std::size_t count,
           const BodyState& body, const GroupLanes& found);
  bool empty() const { return lanes_.empty(); }
  // Padded with lanes of the particle `idle`.
  NearContacts<Real> view(Index idle, double overlap_cap);
  void give_back(PolyhedronSphereBatch<Real>& batch) const;

 private:
  struct Lane {
    Index slot, group;
  };
  void reserve(std::size_t n);

  std::vector<Lane> lanes_;
  std::vector<double> numbers_;
  std::vector<Real> history_;
  std::vector<Index> sphere_;
  std::vector<std::uint32_t> material_;
  std::size_t stride_ = 0;
};

}  // namespace quern
