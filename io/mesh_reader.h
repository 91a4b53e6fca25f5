// Triangles from STL files, binary and ASCII.
//
// Binary is recognised by its exact size (84 + 50 x count), even when it begins with "solid"; ASCII
// is read by tokens. Normals in the file are ignored: the order of the corners says which side
// faces the charge. Nothing is repaired or passed over: NaN, infinities, decimal commas, facets
// that are no triangles and files that are cut off are errors.
#pragma once

#include <string>
#include <vector>

#include "soa/facets.h"

namespace quern {

struct MeshResult {
  std::vector<Triangle> triangles;  // m; empty if there are errors
  std::vector<std::string> errors;  // "file:line:column: error: ..." or "file: error: ..."
};

// `scale`: file units to metres, > 0. At most 20 errors are listed, with a count of the rest.
MeshResult read_stl(const std::string& path, double scale);

}  // namespace quern
