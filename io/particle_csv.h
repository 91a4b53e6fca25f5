// Particles from a CSV file: a header line that names the columns (any order), then one line a
// particle, numbers in SI. Columns: x, y, z, diameter (needed), vx, vy, vz, wx, wy, wz (0 if
// absent). Empty lines and lines that begin with # are skipped.
#pragma once

#include <string>
#include <vector>

#include "soa/scene.h"

namespace quern {

struct ParticleCsv {
  std::vector<ExplicitParticle> particles;
  std::vector<std::string> errors;  // "file:line: error: ...", at most 20 and a count of the rest
};

ParticleCsv read_particle_csv(const std::string& path);

}  // namespace quern
