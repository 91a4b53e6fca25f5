// Rebuild: when the lists are stale, sort particles along a space-filling curve, cut tiles, search
// candidates, carry the history of every contact over. Nothing of the physics changes by it.
//
//   wrap -> curve order, now and then -> grid -> own pairs and candidates for walls per tile
//   -> import pairs of other tiles -> allowances -> fill slots with springs from the old slots
#pragma once

#include <vector>

#include "kernels/candidates.h"
#include "scheduler/graph.h"
#include "scheduler/list_allowance.h"
#include "scheduler/pair_layout.h"
#include "scheduler/polyhedron_lists.h"
#include "soa/world.h"

namespace quern {

// Particles move little between two rebuilds: they are sorted in one of so many.
inline constexpr std::uint64_t kSortEvery = 4;

struct Bounds {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  void add(const Vec3& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
};

// Working memory, kept from rebuild to rebuild: fresh pages cost as much as a search.
template <class Real>
struct RebuildScratch {
  std::vector<CurveKey> keys;
  std::vector<Index> old_of_new, new_of_old;
  std::vector<Bounds> bounds;  // of the spheres, per chunk
  SearchGrid grid;
  std::vector<TilePairs> pairs;
  BodyCandidates bodies;
  std::vector<float> speed;  // m/s, of the fastest meeting of each sphere
  PairLayout<Real> layout;
};

// Throws InvariantError if a position is not finite.
template <class Real>
void rebuild(World<Real>& world, Graph& graph, RebuildScratch<Real>& scratch);

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
