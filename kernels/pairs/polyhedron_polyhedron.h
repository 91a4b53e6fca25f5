// Two convex polyhedra: do they touch, and where, how deep and along which normal.
//
// With I the overlap of A and B and S the vector area of A's surface inside B (outward of A):
//   normal  n = S / |S| from A to B        (S = -dV/dx_B: the gradient of the overlap volume)
//   point   the centroid of I
//   overlap how far B must move along n to leave A (chord), or the width of I along n
// after Xie, Ma, Song, Zhao, Powder Technology 386 (2021) 154-165, eq. 12, read in three
// dimensions. All are continuous in the pose, save where a flush pair of faces slides through zero.
//
// The stages: 1. the axis on which the pair was last apart (or the last normal) rejects most pairs
// by two supports; 2. if it fails and the pair did not touch, GJK looks for another; 3. only faces
// with a vertex inside the slab that both bodies share along the axis can bound I; 4. these are
// clipped; 5. sums, chord. Stage 4 on the fast way clips edges as intervals, lanes over edges, and
// joins their ends to the traces of one surface on the other. Where ends do not pair up (faces in
// one plane, edges that just meet) and for large shapes, polygons are clipped instead: the plain
// way, which is also the oracle of tests. Geometry is f64 in the body frame of A, unit A.scale.
//
// Evaluate a pair once, in a fixed order, and apply opposite forces.
#pragma once

#include "kernels/pairs/convex_clip.h"
#include "soa/shapes.h"

namespace quern {

// What a listed pair keeps. All zero: nothing known yet.
struct PairAxis {
  float axis[3] = {0, 0, 0};  // world frame, from A to B, about unit
  float gap = 0;              // m, a lower bound of the distance along the axis when last apart
  std::uint32_t flags = 0;    // kAxisTouched
};
static_assert(sizeof(PairAxis) <= 24, "many pairs are listed for each that touches");
inline constexpr std::uint32_t kAxisTouched = 1;

enum TouchFlags : std::uint32_t {
  kTouchContained = 1,   // one body in the other: the normal is the last one, or between centres
  kTouchPolygons = 2,    // polygons were clipped
  kTouchCoincident = 4,  // faces of both lay in one plane with the same normal
  kTouchThin = 8,        // thinner than rounding: no touch
  kTouchSearched = 16,   // GJK was asked for an axis
  kTouchFull = 32        // a scratch limit was met; the result is a lower bound
};

struct PolyhedronTouch {
  Vec3 normal;       // world frame, from A to B
  Vec3 point;        // m, centroid of the overlap, in the frame of the poses
  double overlap;    // m
  double area;       // m^2, |S|
  double volume;     // m^3
  Vec3 vector_area;  // m^2, S
  Vec3 moment;  // m^3, integral of (x - point) cross n over A's surface in B; with kVolume only
  std::uint32_t flags;  // set even if nothing touches
};

// Form the place of B relative to A first (a.place = 0), so that far origins cost no digits.
// Whether the bodies overlap; updates `axis`.
bool touch_polyhedra(const ShapePose& a, const ShapePose& b, const PatchOptions& options,
                     PairAxis& axis, PolyhedronTouch& out) noexcept;

// Stages 3 to 5 by polygons alone. `slab` (world frame) culls faces, any direction is right; null:
// all faces. `last` stands in for a normal where one body is in the other.
bool touch_polyhedra_plain(const ShapePose& a, const ShapePose& b, const PatchOptions& options,
                           const Vec3* slab, const Vec3& last, PolyhedronTouch& out) noexcept;

// B as seen from A: body frame of A, in units of A.scale.
struct PairFrame {
  const Shape* a;
  const Shape* b;
  double ratio;  // b.scale / a.scale
  Mat3 turn;     // body frame of B to that of A
  Vec3 place;    // of B
  double reach;  // size to which rounding relates
};
PairFrame pair_frame(const ShapePose& a, const ShapePose& b) noexcept;

// What both ways find, in the frame of the pair; finish_touch() decides and brings it home.
struct PairOverlap {
  double volume, surface;              // overlap; area of its whole surface
  Vec3 centroid, vector_area, moment;  // moment about the origin
  std::uint32_t flags;
};
enum class TouchKind : std::uint8_t { kNone, kTouching, kContained };
TouchKind judge_overlap(const PairFrame& frame, PairOverlap& found) noexcept;
// The normal to be used: along S, or for contained pairs `last` (frame of the pair), or between
// centres, or any.
Vec3 overlap_normal(const PairFrame& frame, const PairOverlap& found, TouchKind kind,
                    const Vec3& last) noexcept;
void finish_touch(const ShapePose& a, const PairOverlap& found, const Vec3& normal, double overlap,
                  PolyhedronTouch& out) noexcept;

// Overlap by clipping polygons of the faces that `slab` (frame of the pair, null: none) leaves.
bool overlap_by_polygons(const PairFrame& frame, const PatchOptions& options, const Vec3* slab,
                         const Vec3& last, PairOverlap& found, Vec3& normal,
                         double& overlap) noexcept;

}  // namespace quern
