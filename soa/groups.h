// Groups: what a run tells apart when it says who collided with whom: ore, media, liner, or what
// the scene names. A pair of groups is a kind of collision.
//
// Groups of particles come first, in the order of the species, then those of walls in the order in
// which walls are made. Kinds are the pairs of particle groups (a <= b) and of a particle group
// with a wall group, counted row by row:
//
//              ore  media | liner
//     ore       0     1   |   2
//     media           3   |   4
#pragma once

#include <string>
#include <vector>

#include "soa/scene.h"

namespace quern {

inline constexpr std::size_t kMostGroups = 8;  // of particles

class Groups {
 public:
  Groups() = default;
  explicit Groups(const Scene& scene);  // UserError if there are more than kMostGroups

  const std::vector<std::string>& names() const { return names_; }
  std::size_t of_particles() const { return of_particles_; }
  // Row of a name, which is one of names().
  std::size_t row(const std::string& name) const;
  // Of a row of the scene's [[particles]]; the first group of a species that the scene does not have.
  std::uint8_t of_species(std::size_t species) const {
    return species < of_species_.size() ? of_species_[species] : 0;
  }

  std::size_t kinds() const { return of_particles_ == 0 ? 0 : first_kind(of_particles_); }
  // Either order; at least one is a group of particles.
  std::size_t kind(std::size_t a, std::size_t b) const {
    return a <= b ? first_kind(a) + (b - a) : first_kind(b) + (a - b);
  }
  std::string kind_name(std::size_t kind) const;  // "ore-media"

 private:
  // Row a has one kind for each group from a on.
  std::size_t first_kind(std::size_t a) const { return a * names_.size() - a * (a - 1) / 2; }
  void add(const std::string& name);

  std::vector<std::string> names_;
  std::size_t of_particles_ = 0;
  std::vector<std::uint8_t> of_species_;
};

// The group that a species belongs to.
inline const std::string& group_of(const ParticleSpec& species) {
  return species.group.empty() ? species.name : species.group;
}

}  // namespace quern
