// Lists of polyhedra, made at a rebuild: spheres near each of them, pairs of them, facets of walls.
//
// The search knows a polyhedron by its bounding sphere, behind the spheres in the order of points.
// Of the spheres found the planes part most for the whole life of the lists, as long as nobody
// leaves its straight line and no polyhedron turns by more than it may (list_allowance.h): they are
// dropped.
#pragma once

#include <vector>

#include "kernels/candidates.h"
#include "scheduler/graph.h"
#include "soa/world.h"

namespace quern {

// A sphere listed with a polyhedron, in the order of the records of now.
struct NearSphere {
  Index polyhedron, sphere;
  float gap, speed;  // of the bounding sphere, as CandidatePair has them
  bool operator<(const NearSphere& o) const {
    return polyhedron != o.polyhedron ? polyhedron < o.polyhedron : sphere < o.sphere;
  }
};

// Candidates of polyhedra. Pairs of them count bodies, the lower one is j.
struct BodyCandidates {
  std::vector<std::vector<NearSphere>> near;  // per tile of the sphere
  std::vector<CandidatePair> pairs;
  std::vector<float> speed;  // m/s, of the fastest meeting of each body
};

// Points of all polyhedra; notes where, how fast and how turned they are.
template <class Real>
void add_points(World<Real>& world, SearchPoint* points);

// Takes the pairs with polyhedra (j >= spheres) out of a tile's candidates.
void take_near_spheres(std::size_t spheres, std::vector<CandidatePair>& own,
                       std::vector<NearSphere>& near);

// Candidates of the polyhedra themselves: pairs, facets of walls, and spheres larger than they,
// which go to `near` of the sphere's tile. Sets the speeds of the polyhedra's meetings with all of
// them.
template <class Real>
void search_polyhedra(World<Real>& world, const SearchInput& in, const SearchGrid& grid,
                      BodyCandidates& found);

// Lays the lists out anew when all allowances are known; drops who stays apart, carries histories
// of open contacts over. `old_of_new`: where a sphere was before the spheres were sorted.
template <class Real>
void lay_out_polyhedra(World<Real>& world, Graph& graph, const SearchInput& in,
                       const std::vector<Index>& old_of_new, BodyCandidates& found);

}  // namespace quern
