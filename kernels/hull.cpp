// Checks in the order in which they can be made; see hull.h.
#include "kernels/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include "kernels/closed_mesh.h"
#include "kernels/mass_properties.h"
#include "kernels/pairs/convex_clip.h"
#include "kernels/polyhedron.h"
#include "kernels/shape_layout.h"

namespace quern {
namespace {

constexpr double kConvex = 1e-5;      // of the bound radius: how deep a dent is rounding
constexpr double kSameVolume = 1e-4;  // mesh and hull of a convex body
constexpr double kNotableRatio = 1.02;
constexpr double kFlatVolume = 1e-12;  // over R^3
constexpr double kFlatWidth = 1e-4;    // over the diameter
constexpr const char* kTakeHull = "; hull = true (quern shape: --hull) takes its convex hull";

std::string number(double value, int digits = 4) {
  if (std::abs(value) < 1e-12) return "0";
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

std::string count(std::size_t n, const std::string& noun) {
  if (n == 1) return "1 " + noun;
  const bool body = noun.ends_with("body");
  return std::to_string(n) + " " + (body ? noun.substr(0, noun.size() - 1) + "ies" : noun + "s");
}

std::string at(const Vec3& p) {
  return "(" + number(p[0]) + ", " + number(p[1]) + ", " + number(p[2]) + ")";
}

// Keeps the vertices that triangles use: those of a triangle without area shape nothing.
void drop_unused_vertices(WeldedMesh& mesh) {
  std::vector<Index> new_id(mesh.vertex.size(), kNoIndex);
  for (const auto& t : mesh.triangle)
    for (const Index v : t) new_id[v] = 0;
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < mesh.vertex.size(); ++v) {
    if (new_id[v] == kNoIndex) continue;
    new_id[v] = static_cast<Index>(kept.size());
    kept.push_back(mesh.vertex[v]);
  }
  mesh.vertex = std::move(kept);
  for (auto& t : mesh.triangle)
    for (Index& v : t) v = new_id[v];
}

class Builder {
 public:
  Builder(const std::string& name, const ShapeOptions& options, ShapeReport& report)
      : name_(name), options_(options), report_(report) {}

  Shape build(const std::vector<Triangle>& triangles) {
    report_ = ShapeReport();
    read(triangles);
    check_surface();
    try {
      body_ = convex_hull(mesh_.vertex);
    } catch (const UserError& problem) {
      refuse(problem.what());
    }
    measure();
    check_thickness();
    check_size();
    check_convex();
    Shape shape = lay_out_shape(body_, name_);
    measure_box(shape);
    return shape;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw UserError(name_ + ": " + what); }
  void warn(const std::string& what) { report_.warnings.push_back(name_ + ": " + what); }
  // What no convex body may be: refused, unless the hull was asked for.
  void object(const std::string& what) {
    if (!options_.hull) refuse(what + kTakeHull);
    warn(what + "; its hull was taken");
  }

  void read(const std::vector<Triangle>& triangles) {
    report_.triangles_read = static_cast<Index>(triangles.size());
    if (triangles.empty()) refuse("the mesh has no triangles");
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const Vec3& p : triangles[t].corner)
        for (int k = 0; k < 3; ++k)
          if (!std::isfinite(p[k]))
            refuse("triangle " + std::to_string(t + 1) +
                   " has a corner that is not a finite number");
    if (triangles.size() < 4) {
      refuse("the mesh has " + count(triangles.size(), "triangle") + ", a body needs at least 4");
    }
    FacetReport welding;
    mesh_ = weld(triangles, welding);
    drop_unused_vertices(mesh_);
    report_.dropped = welding.zero_area + welding.duplicates;
    report_.welded_vertices = static_cast<Index>(mesh_.vertex.size());
    if (mesh_.triangle.size() < 4) {
      refuse("flat: only " + count(mesh_.triangle.size(), "triangle") + " of " +
             std::to_string(triangles.size()) + " have an area of their own");
    }
  }

  void check_surface() {
    const MeshCheck check = check_and_orient(mesh_);
    report_.flipped = check.flipped;
    report_.bodies = check.bodies;
    report_.open_edges = check.open_edges;
    report_.crowded_edges = check.crowded_edges;
    if (check.open_edges > 0) {
      object("not closed: " + count(check.open_edges, "edge") +
             " with one triangle only, the first at " + at(check.first_open));
    }
    if (check.crowded_edges > 0) {
      object("not a simple surface: " + count(check.crowded_edges, "edge") +
             " with more than two triangles, the first at " + at(check.first_crowded));
    }
    if (check.one_sided) object("its surface has one side only: inside and outside are the same");
    if (check.closed()) report_.mesh_volume = check.volume;
    if (check.closed() && check.bodies > 1) {
      object("has " + std::to_string(check.bodies) + " separate bodies, a shape is one");
    }
    if (check.flipped > 0 && check.closed()) {
      warn(count(check.flipped, "triangle") + " faced inwards and " +
           (check.flipped == 1 ? "was" : "were") + " turned");
    }
  }

  void measure() {
    mass_ = mass_properties(body_.vertex, body_.triangles());
    double bound = 0;
    for (const Vec3& v : body_.vertex) bound = std::max(bound, (v - mass_.centroid).norm());
    report_.volume = mass_.volume;
    report_.bound_radius = bound;
    report_.least_width = least_width(body_);
  }

  void check_thickness() const {
    const double R = report_.bound_radius;
    const bool thin = report_.least_width < kFlatWidth * 2 * R;
    if (body_.empty() || mass_.volume <= kFlatVolume * R * R * R || thin) {
      const double share = R > 0 ? report_.least_width / (2 * R) : 0;
      refuse("flat: its least width is " + number(share) + " of its diameter, at least " +
             number(kFlatWidth) + " is needed");
    }
  }

  void check_convex() {
    if (report_.mesh_volume && *report_.mesh_volume > 0) {
      report_.volume_ratio = report_.volume / *report_.mesh_volume;
    }
    if (!report_.mesh_volume || report_.bodies > 1) return warn_of_ratio();
    const double R = report_.bound_radius;
    Vec3 where = Vec3::Zero();
    double dent = deepest_reflex(mesh_, where);
    for (const Vec3& v : mesh_.vertex) {
      const double depth = depth_inside(v);
      if (depth <= dent) continue;
      dent = depth;
      where = v;
    }
    const bool same = report_.volume_ratio && std::abs(*report_.volume_ratio - 1) <= kSameVolume;
    if (dent > kConvex * R) {
      object("not convex: bent inwards by " + number(dent / R) + " of its bound radius at " +
             at(where) + ratio_text());
    } else if (!same) {
      object("its surface intersects itself" + ratio_text());
    }
    warn_of_ratio();
  }
  double depth_inside(const Vec3& p) const {
    double depth = std::numeric_limits<double>::max();
    for (std::size_t f = 0; f < body_.face.size(); ++f)
      depth = std::min(depth, body_.offset[f] - body_.normal[f].dot(p));
    return depth;
  }
  std::string ratio_text() const {
    if (!report_.volume_ratio) return "";
    return ", its hull has " + number(*report_.volume_ratio, 6) + " times its volume";
  }
  void warn_of_ratio() {
    if (report_.volume_ratio && *report_.volume_ratio > kNotableRatio) {
      warn("the hull has " + number(*report_.volume_ratio, 6) + " times the volume of the mesh");
    }
  }

  void check_size() {
    report_.faces = static_cast<Index>(body_.face.size());
    report_.vertices = static_cast<Index>(body_.vertex.size());
    report_.edges = static_cast<Index>(body_.edges());
    if (body_.face.size() > std::size_t{kMaxShapeFaces} ||
        body_.vertex.size() > std::size_t{kMaxShapeVertices}) {
      refuse("too many details: " + count(body_.face.size(), "face") + " and " +
             std::to_string(body_.vertex.size()) + " vertices, a shape may have " +
             std::to_string(kMaxShapeFaces) + " and " + std::to_string(kMaxShapeVertices) +
             "; simplify the mesh");
    }
    report_.spare_vertices = report_.welded_vertices - report_.vertices;
    const std::size_t triangles = mesh_.triangle.size();
    report_.merged_triangles =
        static_cast<Index>(triangles - std::min(triangles, body_.face.size()));
  }

  void measure_box(const Shape& shape) {
    Eigen::AlignedBox3d box;
    for (Index v = 0; v < shape.vertices; ++v) box.extend(shape.vertex(v));
    report_.box = shape.file_scale * box.sizes();
    std::sort(report_.box.data(), report_.box.data() + 3, std::greater<>());
  }

  const std::string& name_;
  const ShapeOptions& options_;
  ShapeReport& report_;
  WeldedMesh mesh_;
  Polyhedron body_;
  MassProperties mass_;
};

}  // namespace

Shape build_shape(const std::vector<Triangle>& triangles, const std::string& name,
                  const ShapeOptions& options, ShapeReport& report) {
  return Builder(name, options, report).build(triangles);
}

}  // namespace quern
