// Shapes for contact tests, made from their faces by hand, without the reader and the hull builder.
//
// Planes come from the corners (Newell), edges from pairs of opposite sides; nothing is scaled or
// moved to principal axes, for contact does not ask for it. Rocks are the intersections of random
// half-spaces near the unit sphere: three planes meet in each vertex, as in ore.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "soa/shapes.h"

namespace quern::test {

using Faces = std::vector<std::vector<int>>;  // corners, counterclockwise seen from outside

inline void set_vertices(Shape& s, const std::vector<Vec3>& vertices) {
  s.vertices = static_cast<Index>(vertices.size());
  for (Column<double>* c : {&s.x, &s.y, &s.z}) c->reset(s.padded_vertices());
  for (std::size_t k = 0; k < s.padded_vertices(); ++k) {
    const Vec3& v = vertices[k < vertices.size() ? k : 0];
    s.x[k] = v.x();
    s.y[k] = v.y();
    s.z[k] = v.z();
    s.bound_radius = std::max(s.bound_radius, v.norm());
  }
}

inline void set_planes(Shape& s, const Faces& faces) {
  s.faces = static_cast<Index>(faces.size());
  for (Column<double>* c : {&s.nx, &s.ny, &s.nz, &s.d}) {
    c->reset(s.padded_faces());
    c->fill(0);
  }
  s.d.fill(kFarPlane);
  s.inner_radius = s.bound_radius;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Vec3 n = Vec3::Zero(), middle = Vec3::Zero();
    const std::size_t corners = faces[f].size();
    const Vec3 first = s.vertex(std::size_t(faces[f][0]));
    for (std::size_t k = 0; k < corners; ++k) {
      const Vec3 a = s.vertex(std::size_t(faces[f][k])) - first;
      const Vec3 b = s.vertex(std::size_t(faces[f][(k + 1) % corners])) - first;
      n += a.cross(b);
      middle += a;
    }
    n.normalize();
    s.nx[f] = n.x();
    s.ny[f] = n.y();
    s.nz[f] = n.z();
    s.d[f] = n.dot(first + middle / static_cast<double>(corners));
    s.inner_radius = std::min(s.inner_radius, s.d[f]);
  }
}

inline void set_edges(Shape& s, const Faces& faces) {
  std::map<std::pair<int, int>, Index> edge_of;
  std::vector<std::array<std::uint16_t, 4>> edges;  // vertices, left and right face
  std::vector<std::uint16_t> begin{0}, vertex, edge;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < faces[f].size(); ++k) {
      const int a = faces[f][k], b = faces[f][(k + 1) % faces[f].size()];
      const auto [at, is_new] = edge_of.try_emplace(std::minmax(a, b), Index(edges.size()));
      if (is_new) edges.push_back({std::uint16_t(a), std::uint16_t(b), std::uint16_t(f), 0});
      if (!is_new) edges[at->second][3] = std::uint16_t(f);
      vertex.push_back(std::uint16_t(a));
      edge.push_back(std::uint16_t(at->second));
    }
    begin.push_back(std::uint16_t(vertex.size()));
  }
  s.edges = static_cast<Index>(edges.size());
  const auto copy = [](const std::vector<std::uint16_t>& from, Column<std::uint16_t>& to) {
    to.reset(from.size());
    std::copy(from.begin(), from.end(), to.data());
  };
  copy(begin, s.face_begin);
  copy(vertex, s.face_vertex);
  copy(edge, s.face_edge);
  s.edge_vertex.reset(2 * edges.size());
  s.edge_face.reset(2 * edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (std::size_t k = 0; k < 2; ++k) {
      s.edge_vertex[2 * e + k] = edges[e][k];
      s.edge_face[2 * e + k] = edges[e][2 + k];
    }
  }
  s.face_words = (s.faces + 63) / 64;
  s.vertex_faces.reset(std::size_t(s.vertices) * s.face_words);
  s.vertex_faces.fill(0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const int v : faces[f]) {
      s.vertex_faces[std::size_t(v) * s.face_words + f / 64] |= std::uint64_t{1} << (f % 64);
    }
  }
}

inline Shape shape_of(const std::string& name, const std::vector<Vec3>& vertices,
                      const Faces& faces) {
  Shape s;
  s.name = name;
  set_vertices(s, vertices);
  set_planes(s, faces);
  set_edges(s, faces);
  set_vertex_edges(s);
  set_edge_lanes(s);
  return s;
}

// A box of full sides (x, y, z).
inline Shape box(const std::string& name, const Vec3& sides) {
  std::vector<Vec3> v;
  for (int k = 0; k < 8; ++k) {
    v.push_back(0.5 * sides.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  }
  return shape_of(
      name, v,
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

inline Shape tetrahedron() {
  return shape_of("tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                  {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

// The intersection of `planes` half-spaces n.x <= d; `stretch` makes it long or flat.
inline Shape rock(const std::string& name, int planes, unsigned seed, const Vec3& stretch) {
  std::mt19937 draw(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Vec3> n;
  std::vector<double> d;
  while (int(n.size()) < planes) {
    const Vec3 v(u(draw), u(draw), u(draw));
    if (v.norm() > 1 || v.norm() < 0.1) continue;
    const bool close = std::any_of(n.begin(), n.end(), [&](const Vec3& o) {
      return o.dot(v.normalized()) > std::cos(2.2 / std::sqrt(double(planes)));
    });
    if (close) continue;
    n.push_back(v.normalized());
    d.push_back(1 + 0.1 * u(draw));
  }
  std::vector<Vec3> vertices;
  Faces around(n.size());
  for (std::size_t i = 0; i < n.size(); ++i) {
    for (std::size_t j = i + 1; j < n.size(); ++j) {
      for (std::size_t k = j + 1; k < n.size(); ++k) {
        Mat3 m;
        m << n[i].transpose(), n[j].transpose(), n[k].transpose();
        if (std::abs(m.determinant()) < 1e-9) continue;
        const Vec3 p = m.inverse() * Vec3(d[i], d[j], d[k]);
        bool within = true;
        for (std::size_t f = 0; f < n.size(); ++f) {
          within = within && (f == i || f == j || f == k || n[f].dot(p) < d[f]);
        }
        if (!within) continue;
        for (const std::size_t f : {i, j, k}) around[f].push_back(int(vertices.size()));
        vertices.push_back(p);
      }
    }
  }
  Faces faces;
  for (std::size_t f = 0; f < n.size(); ++f) {
    if (around[f].size() < 3) continue;
    const Vec3 e = n[f].unitOrthogonal(), g = n[f].cross(e);
    Vec3 middle = Vec3::Zero();
    for (const int v : around[f]) middle += vertices[std::size_t(v)] / double(around[f].size());
    const auto angle = [&](int v) {
      const Vec3 r = vertices[std::size_t(v)] - middle;
      return std::atan2(r.dot(g), r.dot(e));
    };
    std::sort(around[f].begin(), around[f].end(),
              [&](int a, int b) { return angle(a) < angle(b); });
    faces.push_back(around[f]);
  }
  for (Vec3& v : vertices) v = v.cwiseProduct(stretch);
  return shape_of(name, vertices, faces);
}

// Unit ball of 20 longitudes and 10 latitudes: 160 trapezoids and 40 triangles (360 triangles in a
// file that knows triangles only).
inline Shape ball_of_facets(int longitudes = 20, int latitudes = 10) {
  std::vector<Vec3> v{{0, 0, 1}};
  for (int i = 1; i < latitudes; ++i) {
    for (int k = 0; k < longitudes; ++k) {
      const double polar = kPi * i / latitudes, turn = 2 * kPi * k / longitudes;
      v.emplace_back(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                     std::cos(polar));
    }
  }
  v.emplace_back(0, 0, -1);
  const auto at = [&](int i, int k) { return 1 + (i - 1) * longitudes + k % longitudes; };
  Faces faces;
  for (int k = 0; k < longitudes; ++k) {
    faces.push_back({0, at(1, k), at(1, k + 1)});
    for (int i = 1; i + 1 < latitudes; ++i) {
      faces.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)});
    }
    faces.push_back({at(latitudes - 1, k), int(v.size()) - 1, at(latitudes - 1, k + 1)});
  }
  return shape_of("ball of facets", v, faces);
}

// One of each kind that contact has to stand.
inline std::vector<Shape> all_shapes() {
  std::vector<Shape> s;
  s.push_back(box("cube", Vec3::Constant(1.6)));
  s.push_back(tetrahedron());
  s.push_back(rock("rock of 12 faces", 12, 3, Vec3::Ones()));
  s.push_back(rock("flat rock", 14, 5, {1.4, 1.2, 0.4}));
  s.push_back(rock("long rock", 10, 7, {2, 0.7, 0.6}));
  s.push_back(box("plate", {2, 2, 2e-3}));
  s.push_back(box("needle", {2, 2e-3, 2e-3}));
  s.push_back(shape_of("sliver", {{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}, {0, 0.1, 1e-4}},
                       {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  s.push_back(ball_of_facets());
  return s;
}

inline Mat3 random_turn(std::mt19937& draw) {
  std::normal_distribution<double> g;
  return Quat(g(draw), g(draw), g(draw), g(draw)).normalized().toRotationMatrix();
}

inline Vec3 random_direction(std::mt19937& draw) {
  std::normal_distribution<double> g;
  return Vec3(g(draw), g(draw), g(draw)).normalized();
}

}  // namespace quern::test
