// Particles from a CSV file: a header line that names the columns (any order), then one line a
// particle, numbers in SI. Columns: x, y, z, diameter (needed), vx, vy, vz, wx, wy, wz (0 if
// absent), class (a species' name). Several species may share a file that has classes: each takes
// its own rows, and every row must belong to one of them. Empty lines and lines that begin with #
// are skipped.
#pragma once

#include <string>
#include <vector>

#include "soa/scene.h"

namespace quern {

struct ParticleCsv {
  std::vector<ExplicitParticle> particles;
  std::vector<std::string> errors;  // "file:line: error: ...", at most 20 and a count of the rest
};

// The particles of the species `own`; `sharing`: the names of all species that take the file, `own`
// among them. What is wrong is told of all rows.
ParticleCsv read_particle_csv(const std::string& path, const std::string& own,
                              const std::vector<std::string>& sharing);

}  // namespace quern
