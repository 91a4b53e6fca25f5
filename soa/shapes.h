// Shape: a convex polyhedron as contact needs it; one shape serves all sizes.
//
// Body frame: origin in the centroid, axes along the principal axes of inertia, unit equivalent
// radius (volume 4/3 pi). A particle of equivalent radius r has vertices r v, planes n.x <= r d and
// inertia m r^2 `inertia`. Built once at set-up (kernels/hull.h), then read-only and shared.
//
//   vertices  x[] y[] z[]           padded to kShapePad by repeating vertex 0
//   planes    nx[] ny[] nz[] d[]    n.x <= d inside; padded with n = 0, d = kFarPlane
//   faces     corners face_vertex[face_begin[f] .. face_begin[f+1]), counterclockwise seen from
//             outside; face_edge[k] joins corner k of the face with its next corner
//   edges     edge_vertex[2e], [2e+1] and edge_face[2e], [2e+1]; seen from outside, face [2e] lies to
//             the left of the way from the first to the second vertex
//   edge lanes  edge_at x,y,z: the first vertex, edge_side: from there to the second, and 1 / side^2,
//             padded to kShapePad by repeating edge 0; made from the rest by set_edge_lanes()
//   vertex_faces  per vertex `face_words` words of 64 bits: the faces around it
//   vertex_edges  per vertex one word: the edges around it; empty if there are more than 64 edges
#pragma once

#include <string>
#include <vector>

#include "soa/column.h"

namespace quern {

// How deep two polyhedra, or a polyhedron and a wall, overlap; and what their normal force is.
enum class OverlapMeasure : std::uint8_t {
  kChord,  // how far to move along the normal to come apart: on all lines along it, the most that
           // the exit from A lies beyond the entry into B
  kWidth  // extent of the overlap along the normal
};
enum class NormalModel : std::uint8_t {
  kStiffness,  // force = stiffness x overlap
  kVolume      // force and moment are the gradient of the overlap volume; asks for `moment`
};

inline constexpr std::size_t kShapePad = 8;  // lanes of the widest f64 vector
inline constexpr double kFarPlane = 1e30;

struct Shape {
  std::string name;
  Index vertices = 0, faces = 0, edges = 0;  // without padding
  Column<double> x, y, z;
  Column<double> nx, ny, nz, d;
  Column<std::uint16_t> face_begin, face_vertex, face_edge;
  Column<std::uint16_t> edge_vertex, edge_face;
  Column<double> edge_at[3], edge_side[3], edge_inverse2;
  Column<std::uint64_t> vertex_faces, vertex_edges;
  Index face_words = 1;
  double bound_radius = 0;  // farthest vertex
  double inner_radius = 0;  // nearest plane
  Vec3 inertia = Vec3::Zero();  // principal moments over m r^2

  // How it lies in its file: file point = file_centroid + file_scale * file_axes * body point.
  Vec3 file_centroid = Vec3::Zero();
  Mat3 file_axes = Mat3::Identity();
  double file_scale = 1;  // equivalent radius in the file's units

  std::size_t padded_vertices() const { return (vertices + kShapePad - 1) / kShapePad * kShapePad; }
  std::size_t padded_faces() const { return (faces + kShapePad - 1) / kShapePad * kShapePad; }
  std::size_t padded_edges() const { return (edges + kShapePad - 1) / kShapePad * kShapePad; }
  Vec3 vertex(std::size_t k) const { return {x[k], y[k], z[k]}; }
  Vec3 normal(std::size_t f) const { return {nx[f], ny[f], nz[f]}; }
};

// The last step of building a shape, after its vertices and edges.
inline void set_edge_lanes(Shape& s) {
  for (int k = 0; k < 3; ++k) {
    s.edge_at[k].reset(s.padded_edges());
    s.edge_side[k].reset(s.padded_edges());
  }
  s.edge_inverse2.reset(s.padded_edges());
  for (std::size_t lane = 0; lane < s.padded_edges(); ++lane) {
    const std::size_t e = lane < s.edges ? lane : 0;
    const Vec3 at = s.vertex(s.edge_vertex[2 * e]);
    const Vec3 side = s.vertex(s.edge_vertex[2 * e + 1]) - at;
    for (int k = 0; k < 3; ++k) {
      s.edge_at[k][lane] = at[k];
      s.edge_side[k][lane] = side[k];
    }
    QUERN_CHECK(side.squaredNorm() > 0);
    s.edge_inverse2[lane] = 1 / side.squaredNorm();
  }
  s.vertex_edges.reset(s.edges <= 64 ? s.vertices : 0);
  s.vertex_edges.fill(0);
  for (std::size_t k = 0; k < 2 * s.edges && !s.vertex_edges.empty(); ++k) {
    s.vertex_edges[s.edge_vertex[k]] |= std::uint64_t{1} << k / 2;
  }
}

// Where a polyhedron is: world point = place + scale * turn * body point.
struct ShapePose {
  const Shape* shape = nullptr;
  double scale = 1;  // equivalent radius, m
  Vec3 place = Vec3::Zero();
  Mat3 turn = Mat3::Identity();
};

}  // namespace quern
