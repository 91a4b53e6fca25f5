// The order, the schedule and the batches of particles that are inserted over time.
#include "scheduler/rain.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "scheduler/random.h"

namespace quern {
namespace {

constexpr int kTries = 2000;            // places tried for one particle in one batch
constexpr double kZoneFraction = 0.05;  // solid fraction in the zone above a box, at most
constexpr double kThinnestZone = 4;     // in diameters of the largest particle

// The zone above a box has to let through solid / (area over) per second in free fall from rest:
// fraction = flux t / h with t = sqrt(2 h / g), so h = 2 (flux / fraction)^2 / g.
double zone_height(const Scene& scene, std::span<const ParticleSeed> particles,
                   const FillRegion& box) {
  double solid = 0, largest = 0;
  for (const ParticleSeed& p : particles) {
    solid += sphere_volume(p.radius);
    largest = std::max(largest, p.reach());
  }
  const double flux = column_height(box, solid) / scene.fill.over;  // m/s
  const double through = flux / kZoneFraction;
  return std::max(kThinnestZone * 2 * largest, 2 * through * through / scene.run.gravity.norm());
}

}  // namespace

Rain::Rain(const Scene& scene, std::span<const Facets* const> walls,
           std::span<const ParticleSeed> particles)
    : seed_(scene.run.seed), over_(scene.fill.over), region_(scene, walls) {
  QUERN_CHECK(over_ > 0);
  if (is_open_box(scene)) {
    region_.move_above_box(zone_height(scene, particles, region_));
  } else if (!scene.fill.low || !scene.fill.high) {
    region_.keep_upper_half();
  }
  std::vector<std::pair<std::uint64_t, std::size_t>> shuffled;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (is_explicit(scene, particles[i])) continue;
    shuffled.emplace_back(CounterRandom(seed_, RandomStream::kRainOrder, i).bits(), i);
  }
  std::sort(shuffled.begin(), shuffled.end());
  for (const auto& entry : shuffled) order_.push_back(entry.second);
}

void Rain::resume_after(std::size_t inserted) {
  QUERN_CHECK(inserted <= order_.size());
  inserted_ = inserted;
}

std::size_t Rain::due(double time) const {
  const double share = std::clamp(time / over_, 0.0, 1.0);
  return static_cast<std::size_t>(share * static_cast<double>(order_.size()));
}

std::vector<std::size_t> Rain::insert(double time, std::span<const PlacedSphere> present,
                                      std::vector<ParticleSeed>& particles) {
  const std::size_t end = due(time);
  std::vector<std::size_t> placed;
  if (end <= inserted_) return placed;
  std::vector<double> radii;
  for (const PlacedSphere& s : present) radii.push_back(s.radius);
  for (std::size_t k = inserted_; k < end; ++k) radii.push_back(particles[order_[k]].reach());
  SphereGrid grid(region_.periodic(), radii);
  for (const PlacedSphere& s : present) grid.insert(s.position, s.radius, kNoIndex);
  const std::uint64_t moment = mix_bits(seed_ ^ std::bit_cast<std::uint64_t>(time));
  for (; inserted_ < end; ++inserted_) {
    ParticleSeed& p = particles[order_[inserted_]];
    const double radius = p.reach();
    CounterRandom random(moment, RandomStream::kRainPlace, order_[inserted_]);
    const Vec3 low = region_.low_for(radius), size = region_.high_for(radius) - low;
    bool found = false;
    for (int k = 0; k < kTries && !found; ++k) {
      const double u = random.uniform(), v = random.uniform(), w = random.uniform();
      const Vec3 x = low + size.cwiseProduct(Vec3(u, v, w));
      found = region_.admits(x, radius) && grid.is_free(x, radius) &&
              region_.clear_of_walls(x, radius);
      if (found) p.position = x;
    }
    if (!found) break;
    grid.insert(p.position, radius, kNoIndex);
    placed.push_back(order_[inserted_]);
  }
  return placed;
}

}  // namespace quern
