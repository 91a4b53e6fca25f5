// One convex polyhedron against triangulated walls: one contact for each patch it presses into.
//
// Each candidate triangle is cut to the part inside the polyhedron. Planes with such parts make one
// patch if they are of one coplanar group, or meet in a convex edge near the polyhedron; a concave
// edge parts them. So a plate is one contact however it is triangulated, a lifter's convex edge is
// one whose normal goes over from face to face, a concave corner is two. Of a patch
//
//   normal   along the sum of the parts' area vectors: -gradient of the overlap volume
//   overlap  how far the polyhedron must move along the normal to leave the wall behind the patch
//            (chord), or the extent of what lies behind it (width)
//   point    centroid of what lies behind the patch
//
// "Behind the patch" is behind all its planes, and within those concave edges and edges of open
// sheets that reach into the polyhedron: there a plane through the edge, across the sheet, is the
// limit. Without it the whole depth would appear at once as soon as a polyhedron touches the corner
// of a concave edge. A limit that would take away a part of the patch itself (a notch in a sheet)
// is left out. One spring stands for the whole patch: a cube at rest on a face overlaps by m g / k.
//
// One-sided: a wall acts on what is before it. Plain f64 code; nothing is allocated or kept.
#pragma once

#include <span>

#include "kernels/pairs/convex_clip.h"
#include "soa/facets.h"

namespace quern {

enum PatchFlags : std::uint32_t {
  kPatchFull = 1,     // a scratch limit was met: area and overlap are lower bounds, or (in the
                      // first patch) patches were left out
  kPatchDeep = 2,     // deeper than the thickness of the wall: the overlap is that thickness
  kPatchLimited = 4,  // bounded by a concave or a free edge
  kPatchNotched = 8,  // such an edge was left out, see above
  kPatchThin = 16,    // no volume behind all planes: those of less area were left out
  kPatchBehind = 32   // the polyhedron's centre is behind the patch
};

struct WallPatch {
  Vec3 normal;       // unit, from the wall to the polyhedron (frame of the wall's body)
  double overlap;    // m; > 0
  Vec3 point;        // m, frame of the wall's body
  double area;       // m^2, length of the vector area
  Vec3 vector_area;  // m^2, of the wall's surface in the polyhedron, towards the polyhedron
  Vec3 moment;       // m^3, integral over that surface of (x - centre of the polyhedron) cross n
  double volume;     // m^3, behind the patch
  Index feature;     // key: lowest coplanar group of the patch
  Index wall;
  std::uint32_t flags;
};

struct WallPatchOptions {
  OverlapMeasure overlap = OverlapMeasure::kChord;
  double thickness = 0;  // m, of the wall; 0: the polyhedron's inner radius
};

// A polyhedron has far fewer patches than this.
inline constexpr int kMaxWallPatches = 16;

// Returns the number of patches written, ordered by wall and feature. `pose` is in the frame of the
// wall's body. `candidates`: ids of triangles in ascending order, among them every triangle within
// scale * bound_radius of the centre. If there are more patches than `capacity`, those of least
// area are left out.
int polyhedron_facet_touches(const Facets& facets, const ShapePose& pose,
                             std::span<const Index> candidates, const WallPatchOptions& options,
                             WallPatch* out, int capacity) noexcept;

// A lower bound of the distance (m) between the polyhedron and all candidates, at most its bound
// radius: the least over the triangles of what their planes and those across their edges show. 0:
// not known to be apart.
double distance_from_facets(const Facets& facets, const ShapePose& pose,
                            std::span<const Index> candidates) noexcept;

}  // namespace quern
