// Whether a welded mesh is the surface of one body, and which side of it is out. Set-up code.
//
// Every edge must lie between exactly two triangles. From one triangle of each body the orientation
// is carried over shared edges (flood fill), and a body whose volume comes out negative is turned
// inside out. Nothing is refused here: the caller decides what it can use.
#pragma once

#include "soa/facet_weld.h"

namespace quern {

struct MeshCheck {
  Index edges = 0;
  Index open_edges = 0;     // with one triangle
  Index crowded_edges = 0;  // with three or more
  Index bodies = 0;         // parts that share no edge
  Index flipped = 0;        // triangles that were turned
  bool one_sided = false;   // no orientation agrees over all edges
  Vec3 first_open = Vec3::Zero(), first_crowded = Vec3::Zero();  // mid-points of such edges
  double volume = 0;  // of all bodies; 0 unless closed and two-sided
  bool closed() const { return open_edges == 0 && crowded_edges == 0 && !one_sided; }
};

// Turns triangles of `mesh` so that all face outwards, as far as that can be told.
MeshCheck check_and_orient(WeldedMesh& mesh);

// How far the surface of an oriented, closed mesh is bent inwards at its worst edge: the height of
// the lower of the two far corners above the other triangle's plane. `where`: that edge's middle.
double deepest_reflex(const WeldedMesh& mesh, Vec3& where);

}  // namespace quern
