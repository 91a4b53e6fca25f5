// The contacts of a tile's spheres with polyhedra, packed for the law.
//
// Of a group of spheres near one polyhedron few touch: lanes of a group would be idle. add() takes
// what touches, or did a step ago, out of one group after another, with what the narrow phase found
// and where its history and the sums of its group are; view() shows the lanes to push_spheres.
// Nothing is read of a sphere that neither touches nor did.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "kernels/body_contacts.h"
#include "kernels/collision_tally.h"
#include "soa/polyhedra.h"

namespace quern {

// Scratch of a worker.
template <class Real>
class NearLanes {
 public:
  // Room for all slots of the groups [first, last).
  void clear(const PolyhedronSphereBatch<Real>& batch, Index first, Index last);
  // Finds what touches in a group: `spheres` are its first slots, as gathered. `body` and `batch`
  // are to stay where they are. Asks for the histories: they lie scattered, and the law would wait.
  void add(const PolyhedronSphereKernel& narrow, PolyhedronSphereBatch<Real>& batch, Index group,
           const BodyState& body, const ShapePose& pose, const GroupLanes& spheres);
  bool empty() const { return count_ == 0; }
  // After the law: a contact whose energies are not finite, as rows of the sphere and of the
  // polyhedron.
  std::optional<std::pair<Index, Index>> odd(const PolyhedronSphereBatch<Real>& batch) const;
  // Padded with lanes of the particle `idle`.
  NearContacts<Real> view(Index idle, double overlap_cap, Recording recording);
  // After the law, while collisions are recorded: what the lanes tell, and the episodes in their
  // histories.
  void record(const ParticleView<Real>& spheres, Recording recording, CollisionTally& tally);

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};
  void set(std::size_t lane, Index sphere, const BodyState& body, Real* history, double* sums);

  std::size_t count_ = 0;
  std::size_t odd_ = kNone;
  std::vector<NearTouch> touch_;
  std::vector<Index> slot_, sphere_;
  std::vector<const double*> motion_;
  std::vector<std::uint32_t> material_;
  std::vector<std::uint8_t> group_;
  std::vector<NearTold> told_;
  std::vector<double> radius_;
  std::vector<Real*> history_;
  std::vector<double*> sums_;
  // Of padding.
  BodyState idle_body_;
  alignas(kAlignment) Real idle_history_[PolyhedronSphereBatch<Real>::kHistoryStride] = {};
  alignas(kAlignment) double idle_sums_[PolyhedronSphereBatch<Real>::kSums] = {};
};

}  // namespace quern
