// All collisions of a trial run side by side in one world, far from one another, without gravity.
#include "scheduler/impact_trial.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/laws/damping.h"
#include "scheduler/setup.h"
#include "scheduler/step.h"

namespace quern {

namespace {

constexpr int kPhases = 100;
constexpr double kDepth = 1e-3;  // overlap over diameter: shallow, and far above rounding in f32

struct Collider {
  std::size_t material = 0;
  double diameter = 0, mass = 0;
};

// The smallest of each material.
std::vector<Collider> colliders(const Scene& scene, std::span<const ParticleSeed> particles) {
  std::vector<Collider> all;
  for (const ParticleSeed& p : particles) {
    const auto same = [&](const Collider& c) { return c.material == p.material; };
    auto found = std::find_if(all.begin(), all.end(), same);
    if (found == all.end()) found = all.insert(all.end(), {p.material, HUGE_VAL, 0});
    if (2 * p.radius >= found->diameter) continue;
    const double mass = scene.materials[p.material].density * sphere_volume(p.radius);
    *found = {p.material, 2 * p.radius, mass};
  }
  return all;
}

struct Meeting {
  Collider a, b;
  PairValues law;
  double contact_time() const {
    return quern::contact_time(a.mass * b.mass / (a.mass + b.mass), law.normal_stiffness);
  }
  double reach() const { return 0.5 * (a.diameter + b.diameter); }
  // The overlap is speed times contact time over pi.
  double speed() const { return kDepth * std::min(a.diameter, b.diameter) * kPi / contact_time(); }
};

ParticleSpec species_of(const Scene& scene, const Collider& c, const char* name) {
  ParticleSpec spec;
  spec.name = name;
  spec.material = scene.materials[c.material].name;
  return spec;
}

Scene scene_of(const Scene& scene, const Meeting& m, double dt) {
  Scene s;
  s.run.precision = scene.run.precision;
  s.run.gravity = Vec3::Zero();
  s.run.time_step = dt;
  s.run.duration = 1;
  s.contact = scene.contact;
  s.materials = scene.materials;
  s.particles = {species_of(scene, m.a, "first"), species_of(scene, m.b, "second")};
  const double apart = 3 * std::max(m.a.diameter, m.b.diameter);
  for (int k = 0; k < kPhases; ++k) {
    const double y = apart * k, gap = (k + 0.5) / kPhases * m.speed() * dt;
    s.particles[0].explicit_particles.push_back(
        {{m.reach() + gap, y, 0}, {-0.5 * m.speed(), 0, 0}, Vec3::Zero(), m.a.diameter});
    s.particles[1].explicit_particles.push_back(
        {{0, y, 0}, {0.5 * m.speed(), 0, 0}, Vec3::Zero(), m.b.diameter});
  }
  s.domain.low = Vec3::Constant(-2 * apart);
  s.domain.high = Vec3(3 * apart, apart * (kPhases + 1), 2 * apart);
  return s;
}

template <class Real>
DeliveredRestitution deliver(const Scene& scene, const Meeting& m, double dt) {
  const Scene trial = scene_of(scene, m, dt);
  std::vector<ParticleSeed> seeds = draw_sizes(trial);
  SceneGeometry geometry = build_geometry(trial, {}, seeds);
  World<Real> world = make_world<Real>(trial, std::move(geometry), seeds, seeds);
  world.clock.dt = dt;
  set_law(world, trial, {});
  Stepper<Real> stepper(world, 1);
  const auto steps = static_cast<int>(3 * m.contact_time() / dt) + 10;
  for (int k = 0; k < steps; ++k) stepper.step();
  std::vector<double> parting(kPhases, 0);
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    const double v = static_cast<double>(world.particles.record[k].vx);
    parting[world.particles.id[k] % kPhases] += world.particles.species[k] == 0 ? v : -v;
  }
  DeliveredRestitution found{m.law.restitution, 0, 0};
  for (const double v : parting) found.mean += v / m.speed() / kPhases;
  for (const double v : parting) {
    found.scatter += std::pow(v / m.speed() - found.mean, 2) / kPhases;
  }
  found.scatter = std::sqrt(found.scatter);
  return found;
}

}  // namespace

DeliveredRestitution measure_restitution(const Scene& scene,
                                         std::span<const ParticleSeed> particles, double dt) {
  const std::vector<PairValues> laws = resolve_pairs(scene);
  const std::vector<Collider> all = colliders(scene, particles);
  DeliveredRestitution worst;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i; j < all.size(); ++j) {
      const Meeting m{all[i], all[j],
                      laws[all[i].material * scene.materials.size() + all[j].material]};
      const DeliveredRestitution found = scene.run.precision == Precision::kDouble
                                             ? deliver<double>(scene, m, dt)
                                             : deliver<float>(scene, m, dt);
      const auto off = [](const DeliveredRestitution& d) {
        return std::hypot(d.mean - d.asked, d.scatter);
      };
      if (off(found) >= off(worst)) worst = found;
    }
  }
  return worst;
}

double impact_overlap(const Scene& scene, std::span<const ParticleSeed> particles) {
  double mass = 0, radius = 0, stiffness = 1;
  const std::vector<PairValues> laws = resolve_pairs(scene);
  for (const ParticleSeed& p : particles) {
    const double m = scene.materials[p.material].density * sphere_volume(p.radius);
    if (m <= mass) continue;
    mass = m;
    radius = p.radius;
    stiffness = laws[p.material * (scene.materials.size() + 1)].normal_stiffness;
  }
  if (mass == 0) return 0;
  const double fall = scene.mill ? scene.mill->diameter : 1;
  const double speed = std::sqrt(2 * scene.run.gravity.norm() * fall);
  return speed * std::sqrt(0.5 * mass / stiffness) / radius;
}

}  // namespace quern
