// The filling loop: one sphere after the other, a level that rises, and what to say when it is
// full.
#include "scheduler/fill.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "scheduler/body_overlap.h"
#include "scheduler/fill_region.h"
#include "scheduler/random.h"
#include "scheduler/sphere_grid.h"

namespace quern {
namespace {

constexpr int kTriesBeforeRise = 4000;    // places tried for one sphere below one level
constexpr int kTriesWhenFull = 40000;     // and when the level can rise no further
constexpr int kMissesPerTry = 1000;       // draws outside the region that count as one try
constexpr double kRise = 1.03;            // of the volume below the level
constexpr double kRainFraction = 0.12;    // loose enough to fall freely
constexpr double kThinnestColumn = 0.02;  // solid fraction of the tallest column above an open box

class Placer {
 public:
  Placer(const Scene& scene, std::span<const Facets* const> walls,
         std::vector<ParticleSeed>& particles)
      : scene_(scene),
        particles_(particles),
        walls_(walls),
        region_(make_region(scene, walls, particles)),
        levels_(region_),
        grid_(region_.periodic(), radii_of(particles)) {
    order_.reserve(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
      if (is_explicit(scene, particles[i])) {
        grid_.insert(particles[i].position, particles[i].reach(), static_cast<Index>(i));
      } else {
        order_.push_back(i);
        solid_ += sphere_volume(particles[i].radius);
      }
    }
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return particles_[a].reach() > particles_[b].reach();
    });
  }

  // Returns the solid fraction below the level reached.
  double fill() {
    check_possible();
    set_volume(solid_ / aimed_fraction());
    for (placed_ = 0; placed_ < order_.size(); ++placed_) place(order_[placed_]);
    return solid_ / volume_;
  }

 private:
  static std::vector<double> radii_of(const std::vector<ParticleSeed>& particles) {
    std::vector<double> radii;
    radii.reserve(particles.size());
    for (const ParticleSeed& p : particles) radii.push_back(p.reach());
    return radii;
  }

  static FillRegion make_region(const Scene& scene, std::span<const Facets* const> walls,
                                const std::vector<ParticleSeed>& particles) {
    FillRegion region(scene, walls);
    if (!is_open_box(scene) || scene.fill.method == FillMethod::kRandom) return region;
    double solid = 0;
    for (const ParticleSeed& p : particles) solid += sphere_volume(p.radius);
    const double height = column_height(region, solid / kThinnestColumn);
    if (scene.fill.method == FillMethod::kRain) {
      region.move_above_box(height);
    } else {
      region.extend_above_box(height);
    }
    return region;
  }

  double aimed_fraction() const {
    if (scene_.fill.method == FillMethod::kSegment && !scene_.run.gravity.isZero()) {
      return scene_.fill.max_fraction;
    }
    if (scene_.fill.method == FillMethod::kRain && is_open_box(scene_)) return kRainFraction;
    return std::numeric_limits<double>::min();  // the whole region
  }

  void check_possible() const {
    const PeriodicAxes& periodic = region_.periodic();
    for (int a = 0; a < 3; ++a) {
      if (!periodic.on[static_cast<std::size_t>(a)] || order_.empty()) continue;
      if (2 * particles_[order_.front()].reach() > periodic.length[a]) {
        throw UserError("fill: the largest particle is wider than the period of the domain");
      }
    }
    constexpr double kDensestKnown = 0.75;
    if (solid_ > kDensestKnown * levels_.volume()) fail_full();
  }

  void set_volume(double volume) {
    volume_ = std::min(volume, levels_.volume());
    level_ = levels_.level_for(volume_);
    draw_low_ = region_.low();
    draw_high_ = region_.high();
    for (int a = 0; a < 3; ++a) {  // gravity along an axis: no draws in vain
      const double up = region_.up()[a];
      if (std::abs(up) < 1 - 1e-12) continue;
      draw_high_[a] = std::min(draw_high_[a], up > 0 ? level_ : -floor_);
      draw_low_[a] = std::max(draw_low_[a], up > 0 ? floor_ : -level_);
    }
  }

  // The old volume is full for this sphere: the next ones go into the new layer and its seam.
  void rise(double radius) {
    const bool last = volume_ * kRise >= levels_.volume();  // the last hope is anywhere
    floor_ = last ? -std::numeric_limits<double>::infinity() : level_ - 2 * radius;
    set_volume(volume_ * kRise);
  }

  bool try_at(const Vec3& x, std::size_t i) {
    ParticleSeed& p = particles_[i];
    const auto blocks = [&](Index other, double depth) {
      const ParticleSeed& q = particles_[other];
      if (depth >= p.reach() - p.inner() + q.reach() - q.inner()) return true;  // inner spheres do
      const PeriodicAxes& periodic = region_.periodic();
      const Vec3 between =
          periodic.nearest_image(periodic.wrapped(q.position) - periodic.wrapped(x));
      return overlap_of(p, q, between, depth) > 0;
    };
    if (grid_.visit(x, p.reach(), blocks) || !region_.clear_of_walls(x, p.inner())) return false;
    p.position = x;
    if (p.shape != nullptr && polyhedron_wall_overlap(walls_, p) > 0) return false;
    grid_.insert(x, p.reach(), static_cast<Index>(i));
    return true;
  }

  void place(std::size_t i) {
    const double radius = particles_[i].inner();
    CounterRandom random(scene_.run.seed, RandomStream::kPlace, i);
    for (;;) {
      const Vec3 low = region_.low_for(radius).cwiseMax(draw_low_);
      const Vec3 high = region_.high_for(radius).cwiseMin(draw_high_);
      const bool full = volume_ >= levels_.volume();
      const int tries = full ? kTriesWhenFull : kTriesBeforeRise;
      for (long left = long{tries} * kMissesPerTry; left > 0;) {
        const double u = random.uniform(), v = random.uniform(), w = random.uniform();
        const Vec3 x = low + (high - low).cwiseProduct(Vec3(u, v, w));
        const double height = region_.height(x);
        const bool hit = height <= level_ && height >= floor_ && region_.admits(x, radius);
        if (hit && try_at(x, i)) return;
        left -= hit ? kMissesPerTry : 1;
      }
      if (full) fail_full();
      rise(particles_[i].reach());
    }
  }

  [[noreturn]] void fail_full() const {
    std::vector<std::size_t> wanted(scene_.particles.size(), 0), placed(wanted);
    double solid = 0;
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const ParticleSeed& p = particles_[order_[k]];
      ++wanted[p.species];
      if (k >= placed_) continue;
      ++placed[p.species];
      solid += sphere_volume(p.radius);
    }
    std::string by_species;
    for (std::size_t s = 0; s < wanted.size(); ++s) {
      if (wanted[s] == 0) continue;
      by_species += (by_species.empty() ? "" : ", ") + std::to_string(placed[s]) + " of " +
                    std::to_string(wanted[s]) + " " + species_label(scene_, s);
    }
    const double volume = levels_.volume();
    char numbers[160];
    std::snprintf(numbers, sizeof numbers,
                  "they fill %.3g of the %.4g m^3 of the region, all would fill %.3g",
                  volume > 0 ? solid / volume : 0.0, volume, volume > 0 ? solid_ / volume : 0.0);
    throw UserError("fill: the particles do not fit without overlap: placed " + by_species + "; " +
                    numbers +
                    ". Ask for fewer or smaller particles, widen fill.low and fill.high, or insert "
                    "them over time (method rain). Spheres of one size reach about 0.35 this way, "
                    "wide mixes 0.45");
  }

  const Scene& scene_;
  std::vector<ParticleSeed>& particles_;
  std::span<const Facets* const> walls_;
  FillRegion region_;
  LevelTable levels_;
  SphereGrid grid_;
  std::vector<std::size_t> order_;                           // to be placed, largest first
  std::size_t placed_ = 0;                                   // of order_
  double solid_ = 0;                                         // m^3 of all in order_
  double volume_ = 0, level_ = 0;                            // of the region below the level
  double floor_ = -std::numeric_limits<double>::infinity();  // draws are above it
  Vec3 draw_low_ = Vec3::Zero(), draw_high_ = Vec3::Zero();
};

void find_bounds(const Scene& scene, std::span<const ParticleSeed> particles, FillReport& report) {
  const Vec3 far = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 low = far, high = -far;
  for (const ParticleSeed& p : particles) {
    if (inserted_later(scene) && !is_explicit(scene, p)) continue;
    low = low.cwiseMin(p.position - Vec3::Constant(p.reach()));
    high = high.cwiseMax(p.position + Vec3::Constant(p.reach()));
  }
  if ((low.array() <= high.array()).all()) {
    report.low = low;
    report.high = high;
  }
}

}  // namespace

bool inserted_later(const Scene& scene) {
  return scene.fill.method == FillMethod::kRain && scene.fill.over > 0;
}

FillReport place_particles(const Scene& scene, std::span<const Facets* const> walls,
                           std::vector<ParticleSeed>& particles) {
  const auto start = std::chrono::steady_clock::now();
  FillReport report;
  const bool waiting = std::any_of(particles.begin(), particles.end(),
                                   [&](const ParticleSeed& p) { return !is_explicit(scene, p); });
  if (waiting && !inserted_later(scene)) report.fraction = Placer(scene, walls, particles).fill();
  find_bounds(scene, particles, report);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace quern
