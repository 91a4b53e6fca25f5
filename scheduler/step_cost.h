// StepCost: what a step must at least stream from memory, counted from the sizes of the columns
// that its stages go through, and the arithmetic of its spheres, counted from the kernels by hand.
//
// Each column counts once for the stage that goes through it, however often the caches serve it
// again. Counted in a step:
//
//   sphere walls        candidates, springs read and written
//   sphere pairs        owners, rows, partners and history of all slots, empty ones too; history
//                       written of each row of which a slot touches
//   polyhedron spheres  groups, their spheres and flags, sums written and read; history read and
//                       written of slots that touch
//   polyhedron pairs    who is listed, how far apart; records read and written of those that touch
//   polyhedron walls    candidates, how far apart; contacts read, written, and brought together
//   motion              records and traits now and next, spins read and written, list_*; of
//                       polyhedra the state read and written, what is constant, bodies of now
//
// and of a rebuild all columns of spheres, keys, points of the search, pairs found, slots old and
// new. Not counted: partners of other tiles, facets and shapes, rows and lanes, totals: they stay
// in the caches. Polyhedra are left out of a rebuild's bytes, and all but spheres among themselves
// and their motion out of the arithmetic.
#pragma once

#include "scheduler/stage_times.h"
#include "soa/world.h"

namespace quern {

// Additions, multiplications, divisions, roots, minima and maxima; a fused multiply-add is two.
struct Operations {
  double real = 0, f64 = 0;  // in the precision of the law, in f64
};
// Estimates: counted in touching_bits(), sphere_sphere(), respond() and move_spheres(), for lanes
// that hold a pair. A slot that touches is an idle one first.
inline constexpr Operations kOfIdleSlot = {2, 14}, kOfSlotOnGrid = {17, 0},
                            kOfTouchingSlot = {357, 28};
inline constexpr Operations kOfDamping = {27, 0},
                            kOfRolling = {57, 0},  // besides, of a touching slot
    kOfHertzMindlin = {60, 0};
inline constexpr Operations kOfMotion = {0, 119};  // of a sphere

struct StepCost {
  std::array<double, kStageNames.size()> listed{};  // pairs a step looks at; walls: facets
  std::array<double, kStageNames.size()> bytes{};   // a step, by stage
  double slots = 0;          // of sphere pairs: with empty ones and those of two tiles twice
  double rebuild_bytes = 0;  // a rebuild
  Operations operations;     // a step
  void add(const StepCost& o, double share);
};

// Of the step that has just been made.
template <class Real>
StepCost count_step(const World<Real>& world);

}  // namespace quern
