// Size classes: numbers that tell the particles of a scene apart by species and size, for the
// files.
//
// Numbered from 0 over the scene: species by species, and in each the classes of its `sizes` as
// they are listed; a species without `sizes` is one class. A particle keeps no such number: it
// follows from its species, its kind and its diameter. Of classes of a species that overlap the
// narrowest takes a diameter, of equally wide ones the first.
#pragma once

#include <string>
#include <vector>

#include "soa/scene.h"

namespace quern {

class SizeClasses {
 public:
  static constexpr std::uint16_t kUnknown = 0xffff;  // of a species that the scene does not have

  SizeClasses() = default;
  explicit SizeClasses(const Scene& scene);

  // `diameter` of a polyhedron: of the sphere of equal volume (m).
  std::uint16_t of(std::size_t species, ShapeKind shape, double diameter) const;

  struct Row {
    double from = 0, to = 0;  // m; where particles come from a file, what the scene says of them
    ShapeKind shape = ShapeKind::kSphere;
    std::string name;  // "ball", "ore 15-25 mm"; no two are the same
  };
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
  std::vector<std::size_t> first_;  // row of each species; one more at the end
};

}  // namespace quern
