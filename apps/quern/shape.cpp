// Prints the report of kernels/hull.h and writes FILE.hdf, the surface where it lies in the file.
//
// Lengths are those of the file: a species scales a shape to its own equivalent diameter.
#include "apps/quern/shape.h"

#include <fmt/format.h>

#include <filesystem>

#include "apps/quern/load.h"
#include "io/file_commit.h"
#include "io/frames.h"
#include "io/log.h"

namespace quern {

namespace {

void print(const char* what, const std::string& text) {
  log_info(fmt::format("{:<20} {}", what, text));
}

std::string vector_text(const Vec3& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v[0], v[1], v[2]);
}

void print_checks(const ShapeReport& report) {
  print("read",
        fmt::format("{} triangles, {} vertices, {} triangles dropped, {} turned outwards",
                    report.triangles_read, report.welded_vertices, report.dropped, report.flipped));
  print("surface", report.open_edges + report.crowded_edges == 0
                       ? fmt::format("closed, bodies: {}", report.bodies)
                       : fmt::format("{} open edges, {} edges of more than two triangles",
                                     report.open_edges, report.crowded_edges));
  print("polyhedron",
        fmt::format("{} faces, {} vertices, {} edges; {} spare vertices dropped", report.faces,
                    report.vertices, report.edges, report.spare_vertices));
}

void print_measures(const Shape& shape, const ShapeReport& report) {
  const double r = shape.file_scale;
  std::string volume = fmt::format("{:.8g}", report.volume);
  if (report.volume_ratio) {
    volume += fmt::format(", {:.6f} times that of the mesh ({:.8g})", *report.volume_ratio,
                          *report.mesh_volume);
  }
  print("volume", volume);
  print("equivalent diameter", fmt::format("{:.6g}", 2 * r));
  print("centroid", vector_text(shape.file_centroid));
  print("inertia / m r^2", vector_text(shape.inertia) + " (r: equivalent radius; sphere 0.4)");
  for (int k = 0; k < 3; ++k)
    print(k == 0 ? "principal axes" : "", vector_text(shape.file_axes.col(k)));
  print("bound radius",
        fmt::format("{:.6g}, {:.4f} r", shape.bound_radius * r, shape.bound_radius));
  print("inner radius",
        fmt::format("{:.6g}, {:.4f} r", shape.inner_radius * r, shape.inner_radius));
  print("principal box", fmt::format("{} (L, I, S)", vector_text(report.box)));
  print("elongation I/L", fmt::format("{:.4f}", report.box[1] / report.box[0]));
  print("flatness S/I", fmt::format("{:.4f}", report.box[2] / report.box[1]));
}

std::string write_frame(const Shape& shape, const ShapeCommand& command) {
  SurfaceFrame frame;
  for (Index v = 0; v < shape.vertices; ++v) {
    const Vec3 p = shape.file_centroid + shape.file_scale * (shape.file_axes * shape.vertex(v));
    for (int k = 0; k < 3; ++k) frame.vertex.push_back(p[k]);
  }
  for (Index f = 0; f < shape.faces; ++f)
    for (Index k = shape.face_begin[f] + 1u; k + 1u < shape.face_begin[f + 1]; ++k) {
      for (const Index corner : {Index{shape.face_begin[f]}, k, k + 1})
        frame.triangle.push_back(shape.face_vertex[corner]);
      frame.face.push_back(static_cast<std::uint16_t>(f));
    }
  make_folder("frame", command.out);
  const std::string name = std::filesystem::path(command.file).stem().string() + ".hdf";
  const std::string path = (std::filesystem::path(command.out) / name).string();
  write_surface(path, frame);
  return path;
}

}  // namespace

int shape_command(const ShapeCommand& command) {
  ShapeReport report;
  const Shape shape = read_shape(command.file, {command.hull}, report);
  for (const std::string& line : report.warnings) log_warn(line);
  print("shape", command.file);
  print_checks(report);
  print_measures(shape, report);
  print("frame", write_frame(shape, command));
  return 0;
}

}  // namespace quern
