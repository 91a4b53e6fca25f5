// STL files: any bytes are triangles of finite corners or errors; as walls and as polyhedra the
// triangles are taken or refused with a message.
#include <cmath>

#include "io/mesh_reader.h"
#include "kernels/hull.h"
#include "tests/fuzz/fuzz.h"

namespace quern {
namespace {

void as_shape(const std::vector<Triangle>& triangles, bool hull) {
  try {
    ShapeReport report;
    const Shape shape = build_shape(triangles, "file.stl", {hull}, report);
    fuzz::must(report.volume > 0 && report.faces >= 4 && shape.inner_radius > 0);
  } catch (const UserError&) {
  }
}

}  // namespace
}  // namespace quern

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quern;
  const fuzz::InputFile file(data, size);
  const MeshResult mesh = read_stl(file.path(), 1);
  fuzz::must(mesh.errors.empty() || mesh.triangles.empty());
  if (mesh.triangles.empty()) return 0;
  for (const Triangle& t : mesh.triangles) {
    for (const Vec3& corner : t.corner) fuzz::must(corner.allFinite());
  }
  as_shape(mesh.triangles, false);
  as_shape(mesh.triangles, true);
  return 0;
}
