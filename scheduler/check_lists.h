// Checks of a running world, for tests and for hunting defects: slow, and written without the code
// they check.
//
// missed_contacts() finds every touching pair by a sweep along x and every touching facet by
// looking at all of them, and asks the running lists for each. unequal_twins() compares the two
// copies of every contact between two tiles. Both return one line per fault, empty if all is well,
// and have nothing to say while the lists are stale: the next step builds new ones before it reads
// them.
#pragma once

#include <string>
#include <vector>

#include "soa/world.h"

namespace quern {

// Touching pairs that the tile of i does not list among its own, or that the tile of j, another
// one, does not import; touching facets that are not among the candidates of the particle; and
// what missed_polyhedron_contacts() finds.
template <class Real>
std::vector<std::string> missed_contacts(const World<Real>& world);

// Spheres and polyhedra that touch a polyhedron, or its nearest periodic image, and are not listed;
// facets that its bounding sphere reaches and that are no candidates; whatever is listed twice.
template <class Real>
std::vector<std::string> missed_polyhedron_contacts(const World<Real>& world);

// Cross-tile pairs without exactly one copy in the other tile, or whose copies differ in spring,
// force or moment. Zeros of either sign are equal: a vector none of whose lanes has anything to do
// is skipped, and the two copies lie in different vectors.
template <class Real>
std::vector<std::string> unequal_twins(const World<Real>& world);

// Sum of all pair forces as the tiles apply them: force on i from the owner's copy, the opposite on
// j from the copy of j's tile. Exactly zero if the twins are equal (each pair is summed by itself).
template <class Real>
Vec3 sum_of_pair_forces(const World<Real>& world);

}  // namespace quern
