// The closest point by faces, plain and scalar; see polyhedron_sphere.h.
//
// The closest point lies on a face that the centre sees, and each such face is a convex polygon
// whose closest point is the foot of the centre or lies on a side that the foot is beyond. The best
// over all of them needs no walk over the surface, no epsilon, and cannot cycle.
#include "kernels/pairs/polyhedron_sphere.h"

#include <algorithm>
#include <cmath>

namespace quern {
namespace {

constexpr double kOnTheSurface = 1e-12;  // of the radius: below, the face's normal is taken

struct Closest {
  double distance;
  Vec3 point;
  PolyhedronFeature feature;
};

Index highest_plane(const Shape& s, const Vec3& c, double& height) noexcept {
  Index best = 0;
  for (Index f = 0; f < s.faces; ++f) {
    const double h = s.normal(f).dot(c) - s.d[f];
    if (f == 0 || h > height) {
      height = h;
      best = f;
    }
  }
  return best;
}

void closest_on_edge(const Vec3& a, const Vec3& b, const Vec3& c, Closest& best) noexcept {
  const Vec3 side = b - a;
  const double along = side.dot(c - a) / side.squaredNorm();
  const double t = std::clamp(along, 0.0, 1.0);
  const Vec3 point = a + t * side;
  const double distance = (c - point).norm();
  if (!(distance < best.distance)) return;
  best = {distance, point, t == along ? PolyhedronFeature::kEdge : PolyhedronFeature::kVertex};
}

// Lowers `best` to the closest point of face f, whose plane is `height` below c.
void closest_on_face(const Shape& s, Index f, const Vec3& c, double height,
                     Closest& best) noexcept {
  const Vec3 n = s.normal(f);
  bool above_face = true;
  for (std::size_t k = s.face_begin[f]; k < s.face_begin[f + 1u]; ++k) {
    const std::size_t next = k + 1u < s.face_begin[f + 1u] ? k + 1u : s.face_begin[f];
    const Vec3 a = s.vertex(s.face_vertex[k]), b = s.vertex(s.face_vertex[next]);
    if ((b - a).cross(n).dot(c - a) <= 0) continue;
    above_face = false;
    closest_on_edge(a, b, c, best);
  }
  if (above_face && height < best.distance) {
    best = {height, c - height * n, PolyhedronFeature::kFace};
  }
}

}  // namespace

bool touch_polyhedron_sphere(const ShapePose& pose, const Vec3& center, double radius,
                             PolyhedronSphereTouch& out) noexcept {
  const Shape& s = *pose.shape;
  const Vec3 c = pose.turn.transpose() * center / pose.scale;
  out = {};
  double height = 0;
  out.face = highest_plane(s, c, height);
  out.overlap = radius - pose.scale * height;
  if (out.overlap <= 0) return false;

  Closest best{kFarPlane, c, PolyhedronFeature::kFace};
  out.inside = height <= 0;
  for (Index f = 0; f < s.faces && !out.inside; ++f) {
    const double h = s.normal(f).dot(c) - s.d[f];
    if (h > 0 && h < best.distance) closest_on_face(s, f, c, h, best);
  }
  const bool by_face = out.inside || best.feature == PolyhedronFeature::kFace ||
                       pose.scale * best.distance <= kOnTheSurface * radius;
  out.feature = by_face ? PolyhedronFeature::kFace : best.feature;
  const double distance = pose.scale * (by_face ? height : best.distance);
  const Vec3 n = by_face ? s.normal(out.face) : Vec3((c - best.point) / best.distance);
  out.normal = pose.turn * n;
  out.overlap = radius - distance;
  out.point = center - 0.5 * (radius + distance) * out.normal;
  out.deep = out.overlap > 0.5 * radius;
  return out.overlap > 0;
}

}  // namespace quern
