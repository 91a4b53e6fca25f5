#include "soa/groups.h"

#include <algorithm>

#include "soa/base.h"

namespace quern {

Groups::Groups(const Scene& scene) {
  for (const ParticleSpec& species : scene.particles) add(group_of(species));
  of_particles_ = names_.size();
  if (of_particles_ > kMostGroups) throw UserError("more than 8 groups of particles");
  for (const ParticleSpec& species : scene.particles) {
    of_species_.push_back(static_cast<std::uint8_t>(row(group_of(species))));
  }
  if (scene.mill) add(scene.mill->group);
  for (const MeshWallSpec& wall : scene.meshes) add(wall.group);
  for (const BoxSpec& wall : scene.boxes) add(wall.group);
  for (const PlaneSpec& wall : scene.planes) add(wall.group);
}

void Groups::add(const std::string& name) {
  if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
}

std::size_t Groups::row(const std::string& name) const {
  const auto at = std::find(names_.begin(), names_.end(), name);
  QUERN_CHECK(at != names_.end());
  return static_cast<std::size_t>(at - names_.begin());
}

std::string Groups::kind_name(std::size_t kind) const {
  std::size_t a = 0;
  while (first_kind(a + 1) <= kind) ++a;
  return names_[a] + "-" + names_[a + (kind - first_kind(a))];
}

}  // namespace quern
