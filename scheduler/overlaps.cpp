// check_overlaps: what touches too deeply at the start, in words.
//
// Explicit particles may overlap on purpose (a test starts at its static overlap), so this warns
// and does not judge. Particles are taken largest first and each looks among those before it, so
// every pair is seen once and no query spans many cells of a finer level. Polyhedra are sought by
// the spheres around them and then measured as they are.
#include <algorithm>
#include <cstdio>
#include <numeric>

#include "scheduler/body_overlap.h"
#include "scheduler/fill.h"
#include "scheduler/sphere_grid.h"

namespace quern {
namespace {

struct Overlap {
  std::size_t particle = 0;
  Index partner = kNoIndex;  // kNoIndex: a wall
  double depth = 0;          // m
  double relative = 0;       // of the smaller radius
};

double wall_overlap(std::span<const Facets* const> walls, const ParticleSeed& p) {
  if (p.shape != nullptr) return polyhedron_wall_overlap(walls, p);
  double nearest = p.radius;
  for (const Facets* facets : walls) {
    nearest = std::min(nearest, distance_to_facets(*facets, p.position, p.radius));
  }
  return p.radius - nearest;
}

std::vector<Overlap> find_overlaps(const Scene& scene, std::span<const Facets* const> walls,
                                   std::span<const ParticleSeed> particles, double allowed) {
  std::vector<double> radii;
  for (const ParticleSeed& p : particles) radii.push_back(p.reach());
  std::vector<std::size_t> order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  const PeriodicAxes periodic = periodic_axes(scene);
  SphereGrid grid(periodic, radii);
  std::vector<Overlap> found;
  for (const std::size_t i : order) {
    const ParticleSeed& p = particles[i];
    const std::size_t first = found.size();
    grid.visit(p.position, p.reach(), [&](Index partner, double reached) {
      const ParticleSeed& q = particles[partner];
      const Vec3 between = periodic.nearest_image(periodic.wrapped(q.position) -
                                                  periodic.wrapped(p.position));
      const double depth = overlap_of(p, q, between, reached);
      const double smaller = std::min(p.radius, q.radius);
      const auto same = [&](const Overlap& o) { return o.partner == partner; };
      const auto begin = found.begin() + static_cast<std::ptrdiff_t>(first);
      if (depth > allowed * smaller && std::none_of(begin, found.end(), same)) {
        found.push_back({i, partner, depth, depth / smaller});
      }
      return false;
    });
    const double depth = wall_overlap(walls, p);
    if (depth > allowed * p.radius) found.push_back({i, kNoIndex, depth, depth / p.radius});
    grid.insert(p.position, p.reach(), static_cast<Index>(i));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Overlap& a, const Overlap& b) { return a.relative > b.relative; });
  return found;
}

std::string describe(const Scene& scene, std::span<const ParticleSeed> particles,
                     const Overlap& o) {
  const auto name = [&](std::size_t i) {
    return "particle " + std::to_string(i) + " (" + species_label(scene, particles[i].species) +
           ")";
  };
  char depth[80];
  std::snprintf(depth, sizeof depth, " by %.3g m at the start, %.3g of the smaller radius", o.depth,
                o.relative);
  return name(o.particle) + " overlaps " +
         (o.partner == kNoIndex ? std::string("a wall") : name(o.partner)) + depth;
}

}  // namespace

std::vector<std::string> check_overlaps(const Scene& scene, std::span<const Facets* const> walls,
                                        std::span<const ParticleSeed> particles, double allowed,
                                        std::size_t most_lines) {
  const std::vector<Overlap> found = find_overlaps(scene, walls, particles, allowed);
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < found.size() && k < most_lines; ++k) {
    lines.push_back(describe(scene, particles, found[k]));
  }
  if (found.size() > most_lines) {
    lines.push_back("and " + std::to_string(found.size() - most_lines) + " more overlaps");
  }
  return lines;
}

}  // namespace quern
