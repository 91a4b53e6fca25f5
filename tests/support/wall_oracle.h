// What a sphere touches, found the slow way: the oracle of the sphere-wall narrow phase.
//
// Works on loose triangles, without welding, features or grids. A point of a triangle nearest to
// the centre is a local minimum of the distance to the surface if it is also the nearest point of
// every triangle that contains it. Barycentric coordinates by least squares decide what is inside,
// so no formula is shared with the code under test.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "soa/facets.h"

namespace quern::oracle {

inline Vec3 closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& x) {
  const double t = (x - a).dot(b - a) / (b - a).squaredNorm();
  return t <= 0 ? a : t >= 1 ? b : Vec3(a + t * (b - a));
}

inline Vec3 closest_on_triangle(const Triangle& triangle, const Vec3& x) {
  const auto& [a, b, c] = triangle.corner;
  Eigen::Matrix<double, 3, 2> sides;
  sides << b - a, c - a;
  const Eigen::Vector2d w = sides.colPivHouseholderQr().solve(x - a);
  if (w[0] >= 0 && w[1] >= 0 && w[0] + w[1] <= 1) return a + sides * w;
  Vec3 best = closest_on_segment(a, b, x);
  for (const Vec3& p : {closest_on_segment(b, c, x), closest_on_segment(c, a, x)}) {
    if ((p - x).squaredNorm() < (best - x).squaredNorm()) best = p;
  }
  return best;
}

// Points of contact, nearest first. Points closer than 1e-5 R are taken for one.
inline std::vector<Vec3> contact_points(const std::vector<Triangle>& surface, const Vec3& center,
                                        double radius) {
  const double same = 1e-5 * radius;
  std::vector<Vec3> closest;
  for (const auto& t : surface) closest.push_back(closest_on_triangle(t, center));
  std::vector<Vec3> found;
  for (const Vec3& p : closest) {
    if ((p - center).norm() >= radius) continue;
    bool is_minimum = true;
    for (std::size_t t = 0; t < surface.size() && is_minimum; ++t) {
      const bool contains = (closest_on_triangle(surface[t], p) - p).norm() < 0.01 * same;
      is_minimum = !contains || (closest[t] - p).norm() < same;
    }
    const auto is_known = [&](const Vec3& q) { return (p - q).norm() < same; };
    if (is_minimum && std::none_of(found.begin(), found.end(), is_known)) found.push_back(p);
  }
  std::sort(found.begin(), found.end(), [&](const Vec3& a, const Vec3& b) {
    return (a - center).norm() < (b - center).norm();
  });
  return found;
}

}  // namespace quern::oracle
