// Contacts of polyhedra among themselves and with walls, for one stretch of bodies.
//
// collect: the narrow phase of every listed pair and wall candidate writes what touches, or did a
// step ago, into lanes. push: the law (kernels/body_contacts). finish: patch moments, energies in
// order, springs back into World. A pair belongs to the stretch of its lower body and is evaluated
// once; other stretches read its force afterwards. Scalar f64 but for the law: such contacts are few.
#pragma once

#include <span>
#include <vector>

#include "kernels/body_contacts.h"
#include "soa/world.h"

namespace quern {

// Sums of a stretch beyond those of all contacts.
struct PolyhedronTally {
  ContactTally contacts[2];  // pairs, walls
  double model_work = 0;     // J, of normal forces, beyond what their potential accounts for
  void add(const PolyhedronTally& o) {
    contacts[0].add(o.contacts[0]);
    contacts[1].add(o.contacts[1]);
    model_work += o.model_work;
  }
};

template <class Real>
BodyState body_state(const World<Real>& world, std::size_t body);
template <class Real>
ShapePose shape_pose(const World<Real>& world, std::size_t body);
// x_i - x_j, nearest image.
template <class Real>
Vec3 separation(const World<Real>& world, const Vec3& dx);

// Scratch of a worker.
template <class Real>
class PolyhedronContacts {
 public:
  // Pairs whose lower body is in [first, last), and walls of these bodies. `walls` receives their new
  // open contacts, by body.
  void collect(World<Real>& world, std::size_t first, std::size_t last);
  BodyContacts view();
  void finish(World<Real>& world, const StepConstants<double>& step,
              std::vector<PolyhedronWall>& walls, std::span<WallTotal> totals,
              PolyhedronTally& tally);

 private:
  // What a lane is, and what the law does not need of it.
  struct Lane {
    PolyhedronPair* pair;  // null: a wall
    PolyhedronWall wall;
    bool touching;
    Vec3 arm_i, arm_j, wall_velocity;
    double area, mobility, inverse_tangential, stored_old, elastic_force_old;
    Vec3 couple, couple_old, moment_old;
    double smaller;  // m, equivalent radius of the smaller body
  };
  struct Side {  // of a contact
    BodyState state;
    Vec3 arm = Vec3::Zero();
  };
  void collect_pair(World<Real>& world, PolyhedronPair& pair);
  void collect_walls(World<Real>& world, std::size_t body);
  void collect_wall(World<Real>& world, std::size_t body, Index wall_body,
                    std::span<const Index> facets, std::span<const PolyhedronWall> old);
  void push(const World<Real>& world, const Lane& lane, const Side& i, const Side& j,
            const Vec3& at_old, Index law_row);
  void set_elastic(const World<Real>& world, double overlap, double area, double volume,
                   const Vec3& moment, double smaller, Index law_row, double& force, double& stored,
                   Vec3& couple) const;
  Vec3 moment_of(const World<Real>& world, const StepConstants<double>& step, std::size_t k) const;
  void put(int row, const Vec3& v);
  void put(int row, double v) { numbers_[static_cast<std::size_t>(row) * stride_ + count_] = v; }
  double get(int row, std::size_t k) const {
    return numbers_[static_cast<std::size_t>(row) * stride_ + k];
  }
  Vec3 get3(int row, std::size_t k) const {
    return {get(row, k), get(row + 1, k), get(row + 2, k)};
  }
  void reserve(std::size_t n);

  std::vector<double> numbers_;
  std::vector<Index> law_row_;
  std::vector<Lane> lanes_;
  std::size_t stride_ = 0, count_ = 0;
};

}  // namespace quern
