// The overlap of convex bodies by clipping polygons: areas, volume, centroid, depth along a normal.
//
// A polygon is cut by one plane after another (Sutherland and Hodgman, CACM 17, 1974) on the signs
// of signed distances. There is no topology to go wrong: a sign that rounding has turned costs an
// area of the order of rounding, never a crash. Each edge of a polygon remembers which plane lies
// beyond it, which is what the depth along a normal needs: it is found on a line through a corner,
// or where an edge between two faces that look up passes over one between two that look down.
//
// All lengths here are in the frame of one polyhedron with unit equivalent radius ("body units"),
// so that large plates and far origins never enter; to_body() leads there. Buffers are fixed;
// nothing is allocated. kScratchFull tells that a limit was met, and the result is then a lower
// bound.
#pragma once

#include <span>

#include "soa/shapes.h"

namespace quern {

struct PatchOptions {
  OverlapMeasure overlap = OverlapMeasure::kChord;
  NormalModel model = NormalModel::kStiffness;
};

// Left uninitialised on purpose, as scratch holds a thousand of them.
struct Plane {
  Vec3 normal;    // unit, outward
  double offset;  // normal . x <= offset inside
  double height(const Vec3& x) const noexcept { return normal.dot(x) - offset; }
};

inline constexpr int kMaxShapeFaces = 512;  // set-up refuses shapes with more faces or vertices
inline constexpr int kMaxShapeVertices = 1024;
inline constexpr int kMaxShapeEdges = kMaxShapeFaces + kMaxShapeVertices;  // Euler: two fewer
inline constexpr int kMaxCorners = 1600;       // of a polygon while it is clipped
inline constexpr int kMaxOverlapEdges = 4096;  // of an overlap, each counted from both its faces
inline constexpr double kCoincident = 32 * 2.220446049250313e-16;          // of the size
inline constexpr double kCoincidentNormals = 400 * 2.220446049250313e-16;  // rad

// A convex polygon, counterclockwise seen along -normal. Left uninitialised on purpose.
struct ClippedPolygon {
  int corners;
  Vec3 corner[kMaxCorners];
  int beyond[kMaxCorners];  // plane beyond the edge from corner k to the next
};

// Two polygons, one of them the current one.
struct ClipBuffers {
  ClippedPolygon polygon[2];
  ClippedPolygon* now = &polygon[0];
  ClippedPolygon* spare = &polygon[1];
  bool full = false;  // a cut was left out for want of room
  void start() noexcept { now->corners = 0; }
  void add(const Vec3& corner, int beyond) noexcept {
    now->corner[now->corners] = corner;
    now->beyond[now->corners++] = beyond;
  }
};

// Keeps what lies behind the plane; new edges are labelled. False if nothing is left.
bool clip_polygon(ClipBuffers& buffers, const Plane& plane, int label) noexcept;

// Where an edge between these heights over a plane (one <= 0, one > 0) meets it: the same bits
// whichever way round the edge is walked.
inline Vec3 crossing(const Vec3& inside, double height_in, const Vec3& outside, double height_out) {
  return inside + (height_in / (height_in - height_out)) * (outside - inside);
}

// Clips by all faces of a shape, in its body frame; face f is labelled first_label + f.
bool clip_by_shape(ClipBuffers& buffers, const Shape& shape, int first_label) noexcept;

// Twice the area vector's length over two: area of a polygon with this unit normal.
double polygon_area(const ClippedPolygon& polygon, const Vec3& normal) noexcept;

// From the frame of a pose (world, wall ...) to body units.
inline Vec3 to_body(const ShapePose& pose, const Vec3& x) noexcept {
  return pose.turn.transpose() * (x - pose.place) / pose.scale;
}
inline Plane to_body(const ShapePose& pose, const Plane& plane) noexcept {
  return {pose.turn.transpose() * plane.normal, -plane.height(pose.place) / pose.scale};
}

// One edge of an overlap, counterclockwise on plane `left`.
struct OverlapEdge {
  Vec3 from, to;
  int left, right;
};

// Grows face by face. Side 0 are faces of body A that lie in B, side 1 those of B that lie in A.
class OverlapSums {
 public:
  // `plane` is the index of the polygon's own plane, as in the labels.
  void add_face(const ClippedPolygon& polygon, const Plane& own, int plane, int side) noexcept;
  // The same without edges, for who needs no width or chord, after start(): volumes count from
  // there.
  void start(const Vec3& reference) noexcept {
    begun_ = true;
    reference_ = reference;
  }
  void add_cones(const ClippedPolygon& polygon, const Plane& own, int side) noexcept;
  bool empty() const noexcept { return !begun_; }

  double volume() const noexcept { return volume_; }
  double area() const noexcept { return area_; }  // of the whole surface
  Vec3 centroid() const noexcept { return reference_ + first_ / volume_; }
  // Vector area of A's surface in B, outward of A. Taken from both sides, which closure makes
  // equal.
  Vec3 vector_area() const noexcept { return 0.5 * (side_[0] - side_[1]); }
  double closure_error() const noexcept { return (side_[0] + side_[1]).norm(); }
  // Moment of that surface about the origin: integral of x cross n.
  Vec3 moment() const noexcept {
    return 0.5 * (moment_[0] - moment_[1]) + reference_.cross(vector_area());
  }
  // Extent of the overlap along n.
  double width(const Vec3& n) const noexcept;
  // How far the deepest corner lies behind the plane.
  double depth_below(const Plane& plane) const noexcept;
  // Exit from the first `of_a` planes less the entry into the rest, on lines through the overlap's
  // corners and crossings; `planes` by label.
  double chord(const Vec3& n, std::span<const Plane> planes, std::size_t of_a) const noexcept;
  bool full() const noexcept { return full_; }

 private:
  bool begun_ = false, full_ = false;
  Vec3 reference_ = Vec3::Zero();
  double volume_ = 0, area_ = 0;
  Vec3 first_ = Vec3::Zero();  // integral of x - reference
  Vec3 side_[2] = {Vec3::Zero(), Vec3::Zero()};
  Vec3 moment_[2] = {Vec3::Zero(), Vec3::Zero()};
  int edges_ = 0;
  OverlapEdge edge_[kMaxOverlapEdges];
};

// A shape and some planes, all in body units: the part of the shape behind all the planes.
struct PlaneOverlap {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
  Vec3 vector_area =
      Vec3::Zero();            // of the shape's surface behind the planes; outward of the shape
  Vec3 moment = Vec3::Zero();  // integral of x cross n over that surface, about the centroid of
                               // the shape
  Vec3 normal = Vec3::Zero();  // of vector_area: from the shape into what the planes bound
  double overlap = 0;          // chord or width along it
  bool full = false;
};
// False if there is no such part or it is thinner than rounding. At most kMaxShapeFaces planes.
bool intersect_with_planes(const Shape& shape, std::span<const Plane> planes,
                           const PatchOptions& options, PlaneOverlap& out) noexcept;

}  // namespace quern
