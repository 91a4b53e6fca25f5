// Rebuild: when the lists are stale, sort particles along a space-filling curve, cut tiles, search
// candidates, carry the history of every contact over. Nothing of the physics changes by it.
//
//   wrap -> curve order -> permute columns -> grid -> own pairs and candidates for walls per tile
//   -> import pairs of other tiles -> allowances -> fill slots with springs from the old slots
#pragma once

#include <memory>
#include <vector>

#include "kernels/candidates.h"
#include "scheduler/graph.h"
#include "scheduler/list_allowance.h"
#include "scheduler/polyhedron_lists.h"
#include "soa/world.h"

namespace quern {

// The blocks of one part of a tile before they are laid out: lanes in order, 16 to a block.
struct BlockPlan {
  struct Lane {
    Index owner, begin, count;  // its partners: partners[begin .. begin + count)
    Index touching;             // how many of them it touches now
  };
  std::vector<Index> partners;
  std::vector<Lane> lanes;
};

struct Bounds {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  void add(const Vec3& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
};

// Working memory of a rebuild; most of it is given back at its end.
template <class Real>
struct RebuildScratch {
  std::vector<CurveKey> keys;
  std::vector<Index> old_of_new, new_of_old;
  std::unique_ptr<SearchPoint[]> points;  // of spheres, then of polyhedra
  std::vector<Bounds> bounds;             // of the spheres, per chunk
  SearchGrid grid;
  std::vector<std::vector<CandidatePair>> own;       // per tile
  std::vector<std::vector<CandidatePair>> imported;  // per tile
  BodyCandidates bodies;
  std::vector<BlockPlan> own_plan, imported_plan;  // per tile
  std::vector<float> speed;                        // m/s, of the fastest meeting of each sphere
  Particles<Real> sorted;
  PairBatch<Real> pairs;
};

// Throws InvariantError if a position is not finite.
template <class Real>
void rebuild(World<Real>& world, Graph& graph, RebuildScratch<Real>& scratch);

// Largest way a particle at x with velocity v can move against a body within the span from `time`
// on.
double wall_reach(const Body& body, const Vec3& x, const Vec3& v, double time, double span);

// Chooses the next window and slack from how the last lists ended; a function of the state alone.
// Wide lists cost every step, short-lived ones cost rebuilds.
struct ListEnd {
  bool expired = false;        // by their window; else somebody left its line
  double deviation = 0;        // m, the largest from a straight line
  double smallest_radius = 0;  // m
  double idle_slots = 0;       // a particle: listed and not touching
};
void adapt_lists(Clock& clock, const ListEnd& end);

}  // namespace quern
