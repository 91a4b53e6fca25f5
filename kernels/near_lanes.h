// The contacts of a tile's spheres with polyhedra, packed for the law.
//
// Of a group of spheres near one polyhedron one or two touch: lanes of a group would be idle. add()
// takes what touches, or did a step ago, out of one group after another, with what the narrow phase
// found and where its history and the sums of its group are; view() shows the lanes to
// push_spheres. Nothing is read of a sphere that neither touches nor did.
#pragma once

#include <vector>

#include "kernels/body_contacts.h"
#include "soa/polyhedra.h"

namespace quern {

// Scratch of a worker.
template <class Real>
class NearLanes {
 public:
  // Asks for the histories that the groups [first, last) will need: they lie scattered, and would
  // be waited for one by one.
  void clear(const PolyhedronSphereBatch<Real>& batch, Index first, Index last);
  // The first `count` slots of a group, whose narrow phase is in `found`. `body` and `batch` are to
  // stay where they are.
  void add(PolyhedronSphereBatch<Real>& batch, Index group, std::size_t count,
           const BodyState& body, const GroupLanes& found);
  bool empty() const { return sphere_.empty(); }
  // Padded with lanes of the particle `idle`.
  NearContacts<Real> view(Index idle, double overlap_cap);

 private:
  void push(const NearTouch& touch, Index sphere, const BodyState& body, Real* history,
            double* sums);

  std::vector<NearTouch> touch_;
  std::vector<Index> sphere_;
  std::vector<const double*> motion_;
  std::vector<std::uint32_t> material_;
  std::vector<double> radius_;
  std::vector<Real*> history_;
  std::vector<double*> sums_;
  // Of padding.
  BodyState idle_body_;
  alignas(kAlignment) Real idle_history_[PolyhedronSphereBatch<Real>::kHistoryStride] = {};
  alignas(kAlignment) double idle_sums_[PolyhedronSphereBatch<Real>::kSums] = {};
};

}  // namespace quern
