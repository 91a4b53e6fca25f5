#include "soa/size_classes.h"

#include <algorithm>
#include <limits>

namespace quern {

SizeClasses::SizeClasses(const Scene& scene) {
  first_.push_back(0);
  for (const ParticleSpec& species : scene.particles) {
    for (const SizeClass& size : species.sizes) {
      rows_.push_back({size.from, size.to, shape_of(species, size)});
    }
    if (species.sizes.empty()) rows_.push_back({0, 0, species.shape});
    first_.push_back(rows_.size());
  }
  QUERN_CHECK(rows_.size() < kUnknown);
}

std::uint16_t SizeClasses::of(std::size_t species, ShapeKind shape, double diameter) const {
  if (species + 1 >= first_.size()) return kUnknown;
  // A state from another scene may hold spheres where this one has polyhedra only.
  const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(first_[species]);
  const auto end = rows_.begin() + static_cast<std::ptrdiff_t>(first_[species + 1]);
  const bool any = std::any_of(begin, end, [shape](const Row& row) { return row.shape == shape; });
  const double rounding = 1e-6 * diameter;  // radii are f32
  double least = std::numeric_limits<double>::infinity(), width = least;
  auto best = begin;
  for (auto row = begin; row != end; ++row) {
    if (any && row->shape != shape) continue;
    const double outside =
        std::max({0.0, row->from - diameter - rounding, diameter - row->to - rounding});
    if (outside > least || (outside == least && row->to - row->from >= width)) continue;
    best = row;
    least = outside;
    width = row->to - row->from;
  }
  return static_cast<std::uint16_t>(best - rows_.begin());
}

}  // namespace quern
