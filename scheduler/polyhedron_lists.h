// Lists of polyhedra, made at a rebuild: spheres near each of them, pairs of them, facets of walls.
//
// The search knows a polyhedron by its bounding sphere, behind the spheres in the order of points.
// Bounding spheres do not turn, so the lists hold as long as nobody leaves its straight line. Of the
// spheres listed the planes part most for the whole life of the lists, as long as the polyhedron
// hardly turns: these come last in their groups, and the step leaves them out.
#pragma once

#include <vector>

#include "kernels/candidates.h"
#include "scheduler/graph.h"
#include "soa/world.h"

namespace quern {

// A sphere listed with a polyhedron, in the order of the records of now.
struct NearSphere {
  Index polyhedron, sphere;
  bool far = false;  // cannot touch before the next rebuild unless the polyhedron turns
  bool operator<(const NearSphere& o) const {
    if (polyhedron != o.polyhedron) return polyhedron < o.polyhedron;
    return far != o.far ? !far : sphere < o.sphere;
  }
};

// Points of the polyhedra behind those of the spheres; notes where and how fast they are.
template <class Real>
void add_points(World<Real>& world, std::vector<SearchPoint>& points);

// Takes the pairs with polyhedra (j >= spheres) out of a tile's candidates.
void take_near_spheres(std::size_t spheres, std::vector<CandidatePair>& own,
                       std::vector<NearSphere>& near);

// Candidates of the polyhedra themselves: pairs, and spheres larger than they, which go to `near` of
// the sphere's tile. Then all lists are laid out anew; histories of open contacts are carried over.
// `old_of_new`: where a sphere was before the spheres were sorted.
template <class Real>
void rebuild_polyhedra(World<Real>& world, Graph& graph, const SearchInput& in,
                       const SearchGrid& grid, const std::vector<Index>& old_of_new,
                       std::vector<std::vector<NearSphere>>& near);

}  // namespace quern
