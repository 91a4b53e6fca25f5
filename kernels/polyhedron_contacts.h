// Contacts of polyhedra among themselves and with walls, for one stretch of bodies.
//
// collect: the narrow phase of every listed pair and wall candidate writes what touches, or did a
// step ago, into lanes. A pair or wall found apart is not looked at again until the distance found
// may have been used up, see Apart. push: the law (kernels/body_contacts). finish: patch moments,
// energies in order, springs back into World. A pair belongs to the stretch of its lower body and
// is evaluated once; other stretches read its force afterwards. Scalar f64 but for the law: such
// contacts are few.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "kernels/body_contacts.h"
#include "kernels/collision_tally.h"
#include "kernels/pairs/polyhedron_facet.h"
#include "kernels/wall_collisions.h"
#include "kernels/wear.h"
#include "soa/world.h"

namespace quern {

// Sums of a stretch beyond those of all contacts.
struct PolyhedronTally {
  ContactTally contacts[2];  // pairs, walls
  double model_work = 0;     // J, of normal forces, beyond what their potential accounts for
  Fallbacks fallbacks;
  Offender odd;  // the first contact whose energies are not finite
  void add(const PolyhedronTally& o) {
    contacts[0].add(o.contacts[0]);
    contacts[1].add(o.contacts[1]);
    model_work += o.model_work;
    fallbacks.add(o.fallbacks);
  }
};

// What the contacts of a stretch tell of their collisions, and the episodes of its walls' contacts.
struct PolyhedronCollisions {
  CollisionTally tally;
  std::vector<Episode> wall_episodes;
};

// Where two bodies were when they were last found apart, and by how much at least: they are apart
// still while neither the change of their places nor their turning can have closed the gap. Derived
// from the state and never saved; whether it is known changes no result.
struct Apart {
  Vec3 between = Vec3::Zero();  // m, of the places
  double turned = 0;            // m, way of the points of both by turning, of the time
  double gap = 0;               // m; 0: not known to be apart
  bool holds(const Vec3& now, double turned_now) const {
    const double left = kOfGap * gap - (turned_now - turned);
    return left > 0 && (now - between).squaredNorm() < left * left;
  }
  static constexpr double kOfGap = 0.999;  // the rest is for rounding
};

// The same of a polyhedron and a wall, in the frame of the wall.
struct ApartFromWall {
  Vec3 place = Vec3::Zero();
  Mat3 turn = Mat3::Identity();
  double gap = 0;
  bool holds(const ShapePose& now) const;
};

// A body as its contacts see it in this step, in one place: made once a step from the columns. What
// tells that a pair is apart still lies in the first cache line.
struct alignas(kAlignment) BodyNow {
  double reach = 0;  // m, radius of the bounding sphere
  double turned =
      0;  // m, way that turning has carried its points since the lists were built, at most
  BodyState state;
  ShapePose pose;
  Quat orientation = Quat::Identity();
};

struct PairBodies {
  Index j = 0, i = 0;
};

// All bodies of now, and what is known to be apart; a stretch writes what is its own.
struct BodyTable {
  std::vector<BodyNow> body;
  std::vector<PairBodies> pair_bodies;  // of each listed pair: their records are large
  std::vector<Apart> pairs;             // of each listed pair
  std::vector<std::uint8_t> touches;    // each listed pair
  std::vector<ApartFromWall> walls;     // of each entry of wall candidates
};

// How far the turn from one orientation to another moves points within `reach` of the centre, at
// most: |q1 - q0| = 2 sin(angle / 4), and points move by no more than 2 reach sin(angle / 2).
inline double way_of_points(const Quat& from, const Quat& to, double reach) {
  const double chord2 = std::min((to.coeffs() - from.coeffs()).squaredNorm(),
                                 (to.coeffs() + from.coeffs()).squaredNorm());
  return 2 * reach * std::sqrt(chord2);
}

// Bodies [first, last) of now. `fresh`: the lists are new, or the first seen.
enum class Lists : std::uint8_t { kFresh, kKnown };
template <class Real>
void place_bodies(const World<Real>& world, std::size_t first, std::size_t last, Lists lists,
                  BodyTable& table);
// x_i - x_j, nearest image.
template <class Real>
Vec3 separation(const World<Real>& world, const Vec3& dx);

// Scratch of a worker.
template <class Real>
class PolyhedronContacts {
 public:
  // Pairs whose lower body is in [first, last), or walls of these bodies.
  void collect_pairs(World<Real>& world, BodyTable& table, std::size_t first, std::size_t last);
  void collect_walls(World<Real>& world, BodyTable& table, std::size_t first, std::size_t last);
  BodyContacts view();
  // Before finish(), of walls only: appends what they wear.
  void list_wear(const World<Real>& world, const StepConstants<double>& step, WearList& list) const;
  // `walls` receives the open contacts with walls, by body. `collisions`: null unless recorded.
  void finish(World<Real>& world, const StepConstants<double>& step,
              std::vector<PolyhedronWall>& walls, std::span<WallTotal> totals,
              PolyhedronTally& tally, PolyhedronCollisions* collisions);

 private:
  // What a lane is, and what the law does not need of it.
  struct Lane {
    PolyhedronPair* pair;  // null: a wall; of `wall` a pair uses normal and overlap only
    PolyhedronWall wall;
    const PolyhedronWall* old_wall;  // of a wall: what it goes on from, of World's, or null
    bool touching;
    Vec3 arm_i, arm_j, wall_velocity, wall_velocity_old;
    double area, mobility, inverse_tangential, stored_old, elastic_force_old;
    Vec3 couple, couple_old, moment_old;
    double smaller;  // m, equivalent radius of the smaller body
    double reduced_radius;  // m, R* of equivalent radii
  };
  struct Side {  // of a contact
    const BodyState& state;
    Vec3 arm;
  };
  // The contacts of a body with a rigid body of walls: candidates, if any are listed, and what was
  // open a step ago.
  struct WallInput {
    std::size_t body;
    Index wall_body;
    std::span<const Index> facets;
    ApartFromWall* apart;  // null: no candidates
    std::span<const PolyhedronWall> old;
  };
  void collect_pair(World<Real>& world, BodyTable& table, std::size_t row, const Vec3& between,
                    double turned);
  void collect_walls_of(World<Real>& world, BodyTable& table, std::size_t body,
                        std::span<const PolyhedronWall> old);
  void collect_wall(World<Real>& world, const BodyNow& body, const WallInput& in);
  void add_wall_lane(World<Real>& world, const BodyNow& body, const WallInput& in,
                     const PolyhedronWall* was, const WallPatch* now);
  struct Before {  // a step ago
    Vec3 normal;
    double overlap;
    Vec3 at_point, spring, force;
  };
  void put_before(const Before& before);
  // Completes the last of lanes_.
  void push(Lane& lane, const Side& i, const Side& j, Index law_row);
  struct Pressed {  // a patch: overlap (m), area, volume, moment of its pressure (m^3), radii (m)
    double overlap, area, volume;
    Vec3 moment;
    double smaller, reduced_radius;
  };
  void set_elastic(const World<Real>& world, const Pressed& patch, Index law_row, double& force,
                   double& stored, Vec3& couple) const;
  Vec3 moment_of(const World<Real>& world, const StepConstants<double>& step, std::size_t k) const;
  // Lane k, between the law and what finish() stores of it.
  void record(World<Real>& world, std::size_t k, const ContactTally& energies,
              PolyhedronCollisions& collisions) const;
  void record_pair(World<Real>& world, std::size_t k, const ContactEnergies& energies,
                   CollisionTally& tally) const;
  void record_wall(World<Real>& world, std::size_t k, const ContactEnergies& energies,
                   PolyhedronCollisions& collisions) const;
  Arrival arrival(std::size_t k) const;
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
  std::vector<WallSpring> springs_;
  std::vector<bool> carried_;
  std::size_t stride_ = 0, count_ = 0;
  Fallbacks fallbacks_;  // of what was collected last
};

}  // namespace quern
