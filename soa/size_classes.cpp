#include "soa/size_classes.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace quern {
namespace {

// The only class of a species without `sizes`.
SizeClasses::Row only_class(const ParticleSpec& species) {
  SizeClasses::Row row{0, 0, species.shape, species.name};
  const SizeDistribution& sizes = species.distribution;
  if (species.diameter) row.from = row.to = *species.diameter;
  if (sizes.kind == DistributionKind::kRosinRammler) {
    row.from = sizes.from;
    row.to = sizes.to;
  } else if (sizes.kind == DistributionKind::kPassingTable) {
    row.from = sizes.passing.front().first;
    row.to = sizes.passing.back().first;
  }
  for (const ExplicitParticle& particle : species.explicit_particles) {
    row.from = row.from == 0 ? particle.diameter : std::min(row.from, particle.diameter);
    row.to = std::max(row.to, particle.diameter);
  }
  return row;
}

std::string name_of(const std::string& species, const SizeClass& size) {
  char text[64];
  if (size.from == size.to)
    std::snprintf(text, sizeof text, " %g mm", 1e3 * size.from);
  else
    std::snprintf(text, sizeof text, " %g-%g mm", 1e3 * size.from, 1e3 * size.to);
  return species + text;
}

// Classes of equal sizes differ by their shape, or else by a number.
void tell_apart(std::vector<SizeClasses::Row>& rows) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto taken = [&](const std::string& name) {
      return std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(k),
                         [&](const SizeClasses::Row& row) { return row.name == name; });
    };
    if (!taken(rows[k].name)) continue;
    const std::string base =
        rows[k].name + (rows[k].shape == ShapeKind::kSphere ? " spheres" : " polyhedra");
    rows[k].name = base;
    for (int n = 2; taken(rows[k].name); ++n) rows[k].name = base + " " + std::to_string(n);
  }
}

}  // namespace

SizeClasses::SizeClasses(const Scene& scene) {
  first_.push_back(0);
  for (const ParticleSpec& species : scene.particles) {
    for (const SizeClass& size : species.sizes) {
      rows_.push_back({size.from, size.to, shape_of(species, size), name_of(species.name, size)});
    }
    if (species.sizes.empty()) rows_.push_back(only_class(species));
    first_.push_back(rows_.size());
  }
  tell_apart(rows_);
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
