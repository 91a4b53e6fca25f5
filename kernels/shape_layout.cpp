// Columns of a shape out of vertices, planes and faces; see shape_layout.h.
#include "kernels/shape_layout.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "kernels/mass_properties.h"

namespace quern {
namespace {

void lay_out_vertices(const Polyhedron& body, Shape& shape) {
  for (auto* column : {&shape.x, &shape.y, &shape.z}) column->reset(shape.padded_vertices());
  for (std::size_t k = 0; k < shape.padded_vertices(); ++k) {
    const Vec3& file = body.vertex[k < shape.vertices ? k : 0];
    const Vec3 v = shape.file_axes.transpose() * (file - shape.file_centroid) / shape.file_scale;
    shape.x[k] = v[0];
    shape.y[k] = v[1];
    shape.z[k] = v[2];
    shape.bound_radius = std::max(shape.bound_radius, v.norm());
  }
}

void lay_out_planes(const Polyhedron& body, Shape& shape) {
  for (auto* column : {&shape.nx, &shape.ny, &shape.nz, &shape.d})
    column->reset(shape.padded_faces());
  shape.inner_radius = kFarPlane;
  for (std::size_t f = 0; f < shape.padded_faces(); ++f) {
    Vec3 n = Vec3::Zero();
    double d = kFarPlane;
    if (f < shape.faces) {
      n = shape.file_axes.transpose() * body.normal[f];
      d = -kFarPlane;
      for (const Index v : body.face[f]) d = std::max(d, n.dot(shape.vertex(v)));
      shape.inner_radius = std::min(shape.inner_radius, d);
    }
    shape.nx[f] = n[0];
    shape.ny[f] = n[1];
    shape.nz[f] = n[2];
    shape.d[f] = d;
  }
}

void lay_out_faces(const Polyhedron& body, Shape& shape) {
  shape.face_begin.reset(shape.faces + 1);
  shape.face_vertex.reset(2 * shape.edges);
  shape.face_words = (shape.faces + 63) / 64;
  shape.vertex_faces.reset(std::size_t{shape.vertices} * shape.face_words);
  shape.vertex_faces.fill(0);
  std::uint16_t k = 0;
  for (Index f = 0; f < shape.faces; ++f) {
    shape.face_begin[f] = k;
    for (const Index v : body.face[f]) {
      shape.face_vertex[k++] = static_cast<std::uint16_t>(v);
      shape.vertex_faces[std::size_t{v} * shape.face_words + f / 64] |= std::uint64_t{1} << f % 64;
    }
  }
  shape.face_begin[shape.faces] = k;
}

void lay_out_edges(const Polyhedron& body, Shape& shape) {
  shape.face_edge.reset(2 * shape.edges);
  shape.edge_vertex.reset(2 * shape.edges);
  shape.edge_face.reset(2 * shape.edges);
  std::map<std::pair<Index, Index>, std::uint16_t> edge_of;
  for (const auto& face : body.face)
    for (std::size_t k = 0; k < face.size(); ++k)
      edge_of.try_emplace(std::minmax({face[k], face[(k + 1) % face.size()]}), std::uint16_t{0});
  QUERN_CHECK(edge_of.size() == shape.edges);
  std::uint16_t e = 0;
  for (auto& [ends, id] : edge_of) {
    shape.edge_vertex[2 * std::size_t{e}] = static_cast<std::uint16_t>(ends.first);
    shape.edge_vertex[2 * std::size_t{e} + 1] = static_cast<std::uint16_t>(ends.second);
    id = e++;
  }
  for (Index f = 0, k = 0; f < shape.faces; ++f) {
    const auto& face = body.face[f];
    for (std::size_t c = 0; c < face.size(); ++c, ++k) {
      const Index from = face[c], to = face[(c + 1) % face.size()];
      const std::uint16_t id = edge_of.at(std::minmax(from, to));
      shape.face_edge[k] = id;
      shape.edge_face[2 * std::size_t{id} + (from < to ? 0 : 1)] = static_cast<std::uint16_t>(f);
    }
  }
}

}  // namespace

Shape lay_out_shape(const Polyhedron& body, const std::string& name) {
  const MassProperties mass = mass_properties(body.vertex, body.triangles());
  QUERN_CHECK(!body.empty() && mass.volume > 0 && 2 * body.edges() <= kMostCorners);
  const PrincipalAxes principal = principal_axes(mass.inertia);
  Shape shape;
  shape.name = name;
  shape.vertices = static_cast<Index>(body.vertex.size());
  shape.faces = static_cast<Index>(body.face.size());
  shape.edges = static_cast<Index>(body.edges());
  shape.file_centroid = mass.centroid;
  shape.file_axes = principal.axes;
  shape.file_scale = std::cbrt(0.75 * mass.volume / kPi);
  shape.inertia = principal.moments / (mass.volume * shape.file_scale * shape.file_scale);
  lay_out_vertices(body, shape);
  lay_out_planes(body, shape);
  lay_out_faces(body, shape);
  lay_out_edges(body, shape);
  set_vertex_edges(shape);
  set_edge_lanes(shape);
  return shape;
}

}  // namespace quern
