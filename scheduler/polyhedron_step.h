// What polyhedra add to a step; nothing of it exists in a scene without them.
//
//   before             stretches: what contacts need of the bodies, in one place
//   beside the tiles   stretches of kStretch bodies: pairs and walls { narrow phase, law }
//   in each tile       groups of spheres near a polyhedron { gather, narrow phase, law, sums }
//   after the tiles    stretches: { add up forces in fixed order, move, rotate }
//
// A stretch writes its pairs, its own list of wall contacts and its sums; bodies move only after
// all forces are known. The result does not depend on which thread does what.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "kernels/near_lanes.h"
#include "kernels/pairs/polyhedron_sphere.h"
#include "kernels/polyhedron_contacts.h"
#include "scheduler/stage_times.h"

namespace quern {

inline constexpr std::size_t kStretch = 32;  // bodies

template <class Real>
class BodyStepper {
 public:
  BodyStepper(World<Real>& world, const Kernels<Real>& kernels, int threads);

  std::size_t stretches() const { return (world_.polyhedra.size() + kStretch - 1) / kStretch; }
  // Constants of this step; lists have been rebuilt or not.
  void prepare(const StepConstants<double>& walls, bool rebuilt);
  // Before any contact: bodies of now.
  void place_stretch(std::size_t stretch);

  // Contacts among bodies and with walls.
  void run_stretch(std::size_t stretch, int worker, BusyTimes& times);
  // Spheres of a tile against bodies.
  void run_tile(std::size_t tile, int worker, const TileRows& rows, ContactTally& tally,
                CollisionTally* collisions);
  // Before the bodies move: wall contacts of all stretches in order, who has which groups and
  // pairs.
  void gather();
  void move_stretch(std::size_t stretch);

  // In order of stretches.
  void add_to(ContactTally& pairs, ContactTally& walls, double& model_work, MoveTally& move,
              std::vector<WallTotal>& totals) const;
  void add_collisions(Collisions& all) const;  // while they are recorded, likewise
  Fallbacks fallbacks() const;                 // of this step
  // Of this step: the bodies before it, and a contact of theirs whose energies are not finite.
  const BodyTable& table() const { return table_; }
  Offender odd_contact() const;
  void add_wear();                             // what the stretches have listed, likewise

 private:
  using OddPair = std::optional<std::pair<Index, Index>>;
  struct Worker {
    PolyhedronContacts<Real> contacts;
    std::vector<double> lanes;  // of a group
    NearLanes<Real> near;
  };
  struct Stretch {
    std::vector<PolyhedronWall> walls;
    std::vector<WallTotal> totals;
    PolyhedronTally tally;
    PolyhedronCollisions collisions;
    MoveTally move;
    WearList wear;
  };
  GroupLanes lanes_for(std::size_t count, Worker& worker) const;
  void sum_forces(std::size_t body, Vec3& force, Vec3& torque, double& contacts) const;
  void prefetch_forces(std::size_t body) const;
  void move_body(std::size_t body, const Vec3& force, Stretch& stretch);
  void rotate_stretch(std::size_t first, std::size_t count, Stretch& stretch);
  void index_lists();

  World<Real>& world_;
  Kernels<Real> kernels_;
  PolyhedronSphereKernel narrow_;
  StepConstants<double> constants_{};
  std::vector<Worker> workers_;
  std::vector<Stretch> stretches_;
  std::vector<OddPair> odd_;  // of each tile: sphere and polyhedron
  BodyTable table_;
  Lists lists_ = Lists::kFresh;
  // Of each body: pairs as i, groups; the first pair as j, the first wall contact (one more at the
  // end).
  std::vector<Index> pair_begin_, pair_of_, group_begin_, group_of_, first_pair_, first_wall_;
  Column<double> torque_[3];
};

}  // namespace quern
