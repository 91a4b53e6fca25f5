// Shapes from points and planes, built as a file's mesh would be; brute-force convex bodies.
#pragma once

#include <algorithm>
#include <vector>

#include "kernels/hull.h"
#include "kernels/pairs/convex_clip.h"
#include "kernels/polyhedron.h"
#include "tests/support/test_walls.h"

namespace quern::test {

inline Shape built_shape(const std::vector<Vec3>& points) {
  const Polyhedron body = convex_hull(points);
  std::vector<Triangle> mesh;
  for (const auto& t : body.triangles()) {
    mesh.push_back({{body.vertex[t[0]], body.vertex[t[1]], body.vertex[t[2]]}});
  }
  ShapeReport report;
  return build_shape(mesh, "test", {}, report);
}

inline Shape built_box(const Vec3& sides) {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k) {
    points.push_back(0.5 *
                     sides.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  }
  return built_shape(points);
}

// Corners of the body behind all planes: every meeting of three that no other cuts off.
inline std::vector<Vec3> corners_behind(const std::vector<Plane>& planes, double tolerance) {
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        Mat3 normals;
        normals << planes[i].normal.transpose(), planes[j].normal.transpose(),
            planes[k].normal.transpose();
        if (std::abs(normals.determinant()) < 1e-9) continue;
        const Vec3 x =
            normals.inverse() * Vec3(planes[i].offset, planes[j].offset, planes[k].offset);
        if (std::all_of(planes.begin(), planes.end(),
                        [&](const Plane& p) { return p.height(x) <= tolerance; })) {
          corners.push_back(x);
        }
      }
    }
  }
  return corners;
}

inline std::vector<Plane> planes_of(const Shape& shape) {
  std::vector<Plane> planes;
  for (std::size_t f = 0; f < shape.faces; ++f) planes.push_back({shape.normal(f), shape.d[f]});
  return planes;
}

// A rock of `faces` faces: planes at a distance of about 1 with normals well apart.
inline Shape rock(int faces, unsigned seed) {
  Random random(seed);
  std::vector<Plane> planes;
  while (planes.size() < static_cast<std::size_t>(faces)) {
    const Vec3 n = random.in_cube(1).normalized();
    const bool close = std::any_of(planes.begin(), planes.end(), [&](const Plane& p) {
      return p.normal.dot(n) > std::cos(2.2 / std::sqrt(static_cast<double>(faces)));
    });
    if (!close) planes.push_back({n, random(0.9, 1.1)});
  }
  return built_shape(corners_behind(planes, 1e-12));
}

inline Vec3 point_of(const ShapePose& pose, const Vec3& body) {
  return pose.place + pose.scale * (pose.turn * body);
}

// Depth of the deepest vertex below the plane n.x = height.
inline double deepest_vertex(const ShapePose& pose, const Vec3& n, double height) {
  double depth = -HUGE_VAL;
  for (std::size_t k = 0; k < pose.shape->vertices; ++k) {
    depth = std::max(depth, height - n.dot(point_of(pose, pose.shape->vertex(k))));
  }
  return depth;
}

}  // namespace quern::test
