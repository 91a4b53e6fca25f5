// Polyhedra for tests: shapes with exact corners, random rocks, and pairs at a wanted overlap.
//
// make_shape() takes corners and faces as they are (no centring, no scaling, no merging), so that a
// cube has exactly the planes its name says and a spoilt cube keeps its spare vertices.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "kernels/hull.h"
#include "kernels/pairs/polyhedron_polyhedron.h"
#include "kernels/polyhedron.h"

namespace quern {

template <class T, class Range>
void fill_column(Column<T>& column, const Range& values, std::size_t size) {
  column.reset(size);
  for (std::size_t k = 0; k < size; ++k) column[k] = static_cast<T>(values(k));
}

inline Vec3 newell_normal(const std::vector<Vec3>& vertex, const std::vector<Index>& face) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < face.size(); ++k) {
    sum += vertex[face[k]].cross(vertex[face[(k + 1) % face.size()]]);
  }
  return sum.normalized();
}

inline Shape make_shape(const std::string& name, const std::vector<Vec3>& vertex,
                        const std::vector<std::vector<Index>>& face) {
  Shape shape;
  shape.name = name;
  shape.vertices = static_cast<Index>(vertex.size());
  shape.faces = static_cast<Index>(face.size());
  const auto coordinate = [&](int axis) {
    return [&, axis](std::size_t k) { return vertex[k < vertex.size() ? k : 0][axis]; };
  };
  fill_column(shape.x, coordinate(0), shape.padded_vertices());
  fill_column(shape.y, coordinate(1), shape.padded_vertices());
  fill_column(shape.z, coordinate(2), shape.padded_vertices());

  std::vector<Vec3> normal;
  std::vector<double> offset;
  for (const std::vector<Index>& corners : face) {
    normal.push_back(newell_normal(vertex, corners));
    double d = normal.back().dot(vertex[corners[0]]);
    for (const Index v : corners) d = std::max(d, normal.back().dot(vertex[v]));
    offset.push_back(d);
  }
  const auto component = [&](int axis) {
    return [&, axis](std::size_t k) { return k < normal.size() ? normal[k][axis] : 0.0; };
  };
  fill_column(shape.nx, component(0), shape.padded_faces());
  fill_column(shape.ny, component(1), shape.padded_faces());
  fill_column(shape.nz, component(2), shape.padded_faces());
  fill_column(
      shape.d, [&](std::size_t k) { return k < offset.size() ? offset[k] : kFarPlane; },
      shape.padded_faces());

  std::map<std::pair<Index, Index>, Index> edge_of;
  std::vector<Index> begin, corner, edge, ends, sides;
  for (std::size_t f = 0; f < face.size(); ++f) {
    begin.push_back(static_cast<Index>(corner.size()));
    for (std::size_t k = 0; k < face[f].size(); ++k) {
      const Index p = face[f][k], q = face[f][(k + 1) % face[f].size()];
      const auto [at, fresh] = edge_of.try_emplace(std::minmax(p, q), Index(edge_of.size()));
      if (fresh) {
        ends.insert(ends.end(), {p, q});
        sides.insert(sides.end(), {Index(f), Index(f)});
      } else {
        sides[2 * at->second + 1] = static_cast<Index>(f);
      }
      corner.push_back(p);
      edge.push_back(at->second);
    }
  }
  begin.push_back(static_cast<Index>(corner.size()));
  shape.edges = static_cast<Index>(edge_of.size());
  const auto from = [](const std::vector<Index>& list) {
    return [&list](std::size_t k) { return list[k]; };
  };
  fill_column(shape.face_begin, from(begin), begin.size());
  fill_column(shape.face_vertex, from(corner), corner.size());
  fill_column(shape.face_edge, from(edge), edge.size());
  fill_column(shape.edge_vertex, from(ends), ends.size());
  fill_column(shape.edge_face, from(sides), sides.size());

  shape.face_words = (shape.faces + 63) / 64;
  shape.vertex_faces.reset(std::size_t(shape.vertices) * shape.face_words);
  shape.vertex_faces.fill(0);
  for (std::size_t f = 0; f < face.size(); ++f) {
    for (const Index v : face[f]) {
      shape.vertex_faces[v * shape.face_words + f / 64] |= 1ull << (f % 64);
    }
  }
  set_vertex_edges(shape);
  shape.inner_radius = *std::min_element(offset.begin(), offset.end());
  for (const Vec3& v : vertex) shape.bound_radius = std::max(shape.bound_radius, v.norm());
  return shape;
}

// A box with its centre in the origin.
inline Shape box_shape(double lx, double ly, double lz) {
  std::vector<Vec3> v;
  for (int k = 0; k < 8; ++k) {
    v.emplace_back(k & 1 ? lx / 2 : -lx / 2, k & 2 ? ly / 2 : -ly / 2, k & 4 ? lz / 2 : -lz / 2);
  }
  return make_shape(
      "box", v,
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

inline Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}
inline Mat3 random_turn(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Quat(w, x, y, z).normalized().toRotationMatrix();
}

inline Shape shape_of_points(const std::string& name, const std::vector<Vec3>& points) {
  std::vector<Triangle> triangles;
  const Polyhedron body = convex_hull(points);
  for (const auto& t : body.triangles()) {
    triangles.push_back({{body.vertex[t[0]], body.vertex[t[1]], body.vertex[t[2]]}});
  }
  ShapeReport report;
  return build_shape(triangles, name, {true}, report);
}

// A generic rock: `faces` random planes about an ellipsoid, three in each vertex (the corners are
// the facets of the hull of the planes' poles).
inline Shape rock_of_planes(std::uint64_t seed, int faces) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> jitter(0.9, 1.1);
  std::vector<Vec3> poles;
  for (int k = 0; k < faces; ++k) {
    const double y = 1 - 2 * (k + 0.5) / faces, turn = 2.399963 * k;
    const double r = std::sqrt(1 - y * y);
    Vec3 p(r * std::cos(turn), y, r * std::sin(turn));
    p = (p + 0.25 * random_direction(random)).normalized() * jitter(random);
    poles.push_back(p.cwiseProduct(Vec3(1, 1.1, 0.8)));
  }
  std::vector<Vec3> corners;
  const Polyhedron dual = convex_hull(poles);
  for (std::size_t f = 0; f < dual.face.size(); ++f) {
    corners.push_back(dual.normal[f] / dual.offset[f]);
  }
  return shape_of_points("rock", corners);
}

// A rock of triangles: the hull of points about a sphere; 22 give 40 triangles.
inline Shape rock_of_points(std::uint64_t seed, int points) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> jitter(0.97, 1.03);
  std::vector<Vec3> corners;
  for (int k = 0; k < points; ++k) {
    const double y = 1 - 2 * (k + 0.5) / points, turn = 2.399963 * k;
    const double r = std::sqrt(1 - y * y);
    const Vec3 p(r * std::cos(turn), y, r * std::sin(turn));
    corners.push_back((p + 0.1 * random_direction(random)).normalized() * jitter(random));
  }
  return shape_of_points("points", corners);
}

// Moves b along the line of centres until the overlap (chord) is `wanted`, by halving.
inline void bring_to_overlap(const ShapePose& a, ShapePose& b, const Vec3& direction,
                             double wanted) {
  double near = 0, far = 1.01 * (a.scale * a.shape->bound_radius + b.scale * b.shape->bound_radius);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (near + far);
    b.place = a.place + middle * direction;
    PolyhedronTouch touch;
    const bool deep =
        touch_polyhedra_plain(a, b, {}, &direction, direction, touch) && touch.overlap > wanted;
    (deep ? near : far) = middle;
  }
  b.place = a.place + near * direction;
}

}  // namespace quern
