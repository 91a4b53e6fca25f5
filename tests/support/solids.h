// Bodies as loose triangles, for tests of shapes: known ones in closed form, and random rocks.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "kernels/polyhedron.h"
#include "soa/facets.h"

namespace quern {

using Triangles = std::vector<Triangle>;

inline Triangles triangles_of(const Polyhedron& body) {
  Triangles out;
  for (const auto& t : body.triangles())
    out.push_back({{body.vertex[t[0]], body.vertex[t[1]], body.vertex[t[2]]}});
  return out;
}

// Written out, so that nothing of ours is needed to make it. Each face is a fan from its corner
// that comes first.
inline Triangles box_solid(const Vec3& low, const Vec3& high) {
  const auto corner = [&](int k) {
    return Vec3(k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]);
  };
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Triangles out;
  for (const auto& f : faces) {
    out.push_back({{corner(f[0]), corner(f[1]), corner(f[2])}});
    out.push_back({{corner(f[0]), corner(f[2]), corner(f[3])}});
  }
  return out;
}

inline Triangles unit_cube() { return box_solid(Vec3::Zero(), Vec3::Ones()); }

// The corner of the unit cube at the origin, and its three neighbours.
inline Triangles corner_tetrahedron() {
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  return {{{o, y, x}}, {{o, z, y}}, {{o, x, z}}, {{x, y, z}}};
}

// Unit sphere by meridians and rings of latitude.
inline Triangles latitude_ball(int around, int rings) {
  const auto point = [&](int ring, int k) {
    const double polar = kPi * ring / rings, angle = 2 * kPi * (k % around) / around;
    if (ring == 0 || ring == rings) return Vec3(0, 0, ring == 0 ? 1 : -1);
    return Vec3(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                std::cos(polar));
  };
  Triangles out;
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < around; ++k) {
      const Vec3 a = point(ring, k), b = point(ring, k + 1);
      const Vec3 c = point(ring + 1, k), d = point(ring + 1, k + 1);
      if (ring + 1 < rings) out.push_back({{a, c, d}});
      if (ring > 0) out.push_back({{a, d, b}});
      if (ring + 1 == rings) out.back() = {{a, c, b}};
    }
  return out;
}

// The hull of `points` random points on an ellipsoid: all faces triangles.
inline Triangles random_rock(std::mt19937& random, int points) {
  std::normal_distribution<double> normal;
  std::vector<Vec3> cloud;
  for (int k = 0; k < points; ++k) {
    const Vec3 v = Vec3(normal(random), normal(random), normal(random)).normalized();
    cloud.emplace_back(v.cwiseProduct(Vec3(1, 0.8, 0.55)));
  }
  return triangles_of(convex_hull(cloud));
}

template <class Map>
Triangles mapped(Triangles triangles, Map&& map) {
  for (Triangle& t : triangles)
    for (Vec3& p : t.corner) p = map(p);
  return triangles;
}

inline Triangles turned_inside_out(Triangles triangles) {
  for (Triangle& t : triangles) std::swap(t.corner[1], t.corner[2]);
  return triangles;
}

inline Triangles joined(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline Mat3 random_turn(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Quat(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

}  // namespace quern
