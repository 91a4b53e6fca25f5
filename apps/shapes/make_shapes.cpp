// Makes the shapes of this folder: make_shapes FOLDER. Equal diameter of volume 1 each; the same
// files on every machine (a test compares them with those that ship).
//
// A rock is the body between planes tangent to a ball, each moved in or out a little, then
// stretched to the axes of an ellipsoid: what a crusher leaves has flat faces, and where planes
// meet by chance just three share a corner. Of many draws that one is kept whose shortest edge is
// longest. ore12 is the rock of Xie et al. (2021): their file has 40 triangles for 12 faces, so it
// holds two vertices that shape nothing; here one lies on an edge, one inside a face. ore6, ore20
// and ore40 are the same rock with fewer and more faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "kernels/mass_properties.h"
#include "kernels/polyhedron.h"
#include "scheduler/random.h"

namespace {

using quern::Index;
using quern::Polyhedron;
using quern::Vec3;

constexpr int kDraws = 2000;

struct RockSpec {
  const char* name;
  int faces;
  Vec3 axes;      // of the ellipsoid
  double jitter;  // of a plane's distance
};

const RockSpec kRocks[] = {
    {"ore6", 6, {1.0, 0.90, 0.80}, 0.10},
    {"ore12", 12, {1.0, 0.90, 0.80}, 0.10},
    {"ore20", 20, {1.0, 0.90, 0.80}, 0.06},
    {"ore40", 40, {1.0, 0.90, 0.80}, 0.03},
    {"rock_blocky_10", 10, {1.0, 0.95, 0.90}, 0.15},
    {"rock_blocky_16", 16, {1.0, 0.85, 0.80}, 0.10},
    {"rock_flat_12", 12, {1.0, 0.85, 0.40}, 0.10},
    {"rock_flat_14", 14, {1.0, 0.75, 0.30}, 0.12},
    {"rock_elongated_12", 12, {1.0, 0.50, 0.45}, 0.10},
    {"rock_elongated_14", 14, {1.0, 0.45, 0.30}, 0.12},
};

struct Mesh {
  std::vector<Vec3> vertex;
  std::vector<std::array<Index, 3>> triangle;
};

// Directions that keep apart: each is the best of 8 candidates.
std::vector<Vec3> directions(int count, quern::CounterRandom& random) {
  std::vector<Vec3> out;
  while (out.size() < static_cast<std::size_t>(count)) {
    Vec3 best = Vec3::UnitX();
    double best_nearest = 2;
    for (int k = 0; k < 8; ++k) {
      Vec3 n;
      do {
        for (int a = 0; a < 3; ++a) n[a] = random.uniform(-1, 1);
      } while (n.norm() > 1 || n.norm() < 0.1);
      n.normalize();
      double nearest = -1;
      for (const Vec3& other : out) nearest = std::max(nearest, n.dot(other));
      if (nearest >= best_nearest) continue;
      best = n;
      best_nearest = nearest;
    }
    out.push_back(best);
  }
  return out;
}

// The body n_k.x <= d_k, stretched: the planes of the hull of n_k / d_k are its corners.
Polyhedron between_planes(const std::vector<Vec3>& normal, const std::vector<double>& distance,
                          const Vec3& stretch) {
  std::vector<Vec3> dual, corner;
  for (std::size_t k = 0; k < normal.size(); ++k) dual.push_back(normal[k] / distance[k]);
  const Polyhedron hull = quern::convex_hull(dual);
  for (std::size_t f = 0; f < hull.face.size(); ++f) {
    if (hull.offset[f] < 0.5) return {};  // open, or a spike
    corner.emplace_back(stretch.cwiseProduct(hull.normal[f]) / hull.offset[f]);
  }
  return quern::convex_hull(corner);
}

double shortest_edge(const Polyhedron& body) {
  double shortest = 1e300;
  for (const auto& face : body.face)
    for (std::size_t k = 0; k < face.size(); ++k)
      shortest = std::min(shortest,
                          (body.vertex[face[k]] - body.vertex[face[(k + 1) % face.size()]]).norm());
  return shortest;
}

Polyhedron make_rock(const RockSpec& spec) {
  Polyhedron best;
  double best_edge = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    quern::CounterRandom random(
        quern::mix_bits(std::uint64_t(draw + 1) * 1000 + Index(spec.faces)));
    const std::vector<Vec3> normal = directions(spec.faces, random);
    std::vector<double> distance;
    while (distance.size() < normal.size())
      distance.push_back(random.uniform(1 - spec.jitter, 1 + spec.jitter));
    Polyhedron body = between_planes(normal, distance, spec.axes);
    if (body.face.size() != normal.size()) continue;
    const double edge = shortest_edge(body);
    if (edge <= best_edge || body.edges() * 2 != body.vertex.size() * 3) continue;
    best = std::move(body);
    best_edge = edge;
  }
  return best;
}

Mesh as_mesh(const Polyhedron& body) { return {body.vertex, body.triangles()}; }

using Edge = std::pair<Index, Index>;

Edge longest_edge(const Polyhedron& body) {
  Edge longest = {0, 0};
  const auto length = [&](const Edge& e) {
    return (body.vertex[e.first] - body.vertex[e.second]).norm();
  };
  for (const auto& face : body.face)
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Edge e = {face[k], face[(k + 1) % face.size()]};
      if (e.first < e.second && length(e) > length(longest)) longest = e;
    }
  return longest;
}

// The face with most corners of those that do not touch the edge.
std::size_t face_apart_from(const Edge& edge, const Polyhedron& body) {
  std::size_t best = body.face.size(), corners = 0;
  for (std::size_t f = 0; f < body.face.size(); ++f) {
    const auto& face = body.face[f];
    const bool touches = std::any_of(face.begin(), face.end(),
                                     [&](Index v) { return v == edge.first || v == edge.second; });
    if (touches || face.size() <= corners) continue;
    best = f;
    corners = face.size();
  }
  return best;
}

// Adds a vertex on the longest edge, around which the two faces beside it become fans, and one
// inside a face apart from it.
Mesh with_spare_vertices(const Polyhedron& body) {
  Mesh mesh{body.vertex, {}};
  const Edge edge = longest_edge(body);
  const std::size_t split = face_apart_from(edge, body);
  Vec3 middle = Vec3::Zero();
  for (const Index v : body.face[split]) middle += body.vertex[v];
  const auto on_edge = static_cast<Index>(mesh.vertex.size()), inside = on_edge + 1;
  mesh.vertex.emplace_back(0.55 * body.vertex[edge.first] + 0.45 * body.vertex[edge.second]);
  mesh.vertex.emplace_back(middle / static_cast<double>(body.face[split].size()));
  for (std::size_t f = 0; f < body.face.size(); ++f) {
    std::vector<Index> loop = body.face[f];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto next = loop.begin() + static_cast<long>((k + 1) % loop.size());
      if (edge != Edge(std::minmax({loop[k], *next}))) continue;
      loop.insert(loop.begin() + static_cast<long>(k) + 1, on_edge);
      std::rotate(loop.begin(), loop.begin() + static_cast<long>(k) + 1, loop.end());
      break;
    }
    if (f == split) {  // the outline, closed, around its middle
      loop.insert(loop.begin(), inside);
      loop.push_back(loop[1]);
    }
    for (std::size_t k = 1; k + 1 < loop.size(); ++k)
      mesh.triangle.push_back({loop[0], loop[k], loop[k + 1]});
  }
  return mesh;
}

Mesh make_cube() {
  std::vector<Vec3> corner;
  for (int k = 0; k < 8; ++k) corner.emplace_back(k & 1, k >> 1 & 1, k >> 2);
  return as_mesh(quern::convex_hull(corner));
}

Mesh make_tetrahedron() {
  return as_mesh(quern::convex_hull({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}));
}

// Rings of latitude between two poles.
Mesh make_ball(Index around, Index rings) {
  Mesh ball;
  for (Index r = 1; r < rings; ++r) {
    const double polar = quern::kPi * r / rings;
    for (Index k = 0; k < around; ++k) {
      const double angle = 2 * quern::kPi * k / around;
      ball.vertex.emplace_back(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                               std::cos(polar));
    }
  }
  const auto north = static_cast<Index>(ball.vertex.size()), south = north + 1;
  ball.vertex.emplace_back(0, 0, 1);
  ball.vertex.emplace_back(0, 0, -1);
  for (Index k = 0; k < around; ++k) {
    const Index next = (k + 1) % around;
    ball.triangle.push_back({north, k, next});
    for (Index r = 0; r + 2 < rings; ++r) {
      const Index a = r * around + k, b = r * around + next;
      ball.triangle.push_back({a, a + around, b + around});
      ball.triangle.push_back({a, b + around, b});
    }
    ball.triangle.push_back({south, (rings - 2) * around + next, (rings - 2) * around + k});
  }
  return ball;
}

void write_stl(const std::string& folder, const std::string& name, Mesh mesh) {
  const quern::MassProperties mass = quern::mass_properties(mesh.vertex, mesh.triangle);
  const double diameter = std::cbrt(6 * mass.volume / quern::kPi);
  std::ofstream file(folder + "/" + name + ".stl");
  file << "solid " << name << "\n";
  const auto write = [&file](const char* what, const Vec3& v) {
    std::array<char, 96> line;
    // -0.0 and 0.0 are the same number and must be the same text
    std::snprintf(line.data(), line.size(), "%s %.7g %.7g %.7g\n", what, v[0] + 0.0, v[1] + 0.0,
                  v[2] + 0.0);
    file << line.data();
  };
  for (Vec3& v : mesh.vertex) {
    v = (v - mass.centroid) / diameter;
    for (int k = 0; k < 3; ++k) v[k] = std::abs(v[k]) < 1e-9 ? 0.0 : v[k];
  }
  for (const auto& t : mesh.triangle) {
    const Vec3 &a = mesh.vertex[t[0]], &b = mesh.vertex[t[1]], &c = mesh.vertex[t[2]];
    write("facet normal", Vec3::Zero());
    file << "outer loop\n";
    for (const Vec3& v : {a, b, c}) write("vertex", v);
    file << "endloop\nendfacet\n";
  }
  file << "endsolid " << name << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_shapes FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  write_stl(folder, "cube", make_cube());
  write_stl(folder, "tetrahedron", make_tetrahedron());
  write_stl(folder, "ball360", make_ball(20, 10));
  for (const RockSpec& spec : kRocks) {
    const Polyhedron rock = make_rock(spec);
    if (rock.empty()) return 1;
    std::printf("%s: shortest edge %.3f\n", spec.name, shortest_edge(rock));
    const bool ore = std::string(spec.name) == "ore12";
    write_stl(folder, spec.name, ore ? with_spare_vertices(rock) : as_mesh(rock));
  }
  return 0;
}
