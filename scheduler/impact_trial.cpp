// All collisions of a trial run side by side in one world, far from one another, without gravity.
#include "scheduler/impact_trial.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scheduler/setup.h"
#include "scheduler/step.h"

namespace quern {

namespace {

constexpr int kPhases = 100;
constexpr double kDepth = 1e-3;  // overlap over diameter: shallow, and far above rounding in f32

struct Collider {
  std::size_t material = 0;
  double diameter = 0;
};

// The smallest of each material.
std::vector<Collider> colliders(std::span<const ParticleSeed> particles) {
  std::vector<Collider> all;
  for (const ParticleSeed& p : particles) {
    const auto same = [&](const Collider& c) { return c.material == p.material; };
    auto found = std::find_if(all.begin(), all.end(), same);
    if (found == all.end()) found = all.insert(all.end(), {p.material, HUGE_VAL});
    found->diameter = std::min(found->diameter, 2 * p.radius);
  }
  return all;
}

// Two that meet at a speed.
struct Meeting {
  Collider a, b;
  double speed = 0, contact_time = 0;
};

ParticleSpec species_of(const Scene& scene, const Collider& c, const char* name) {
  ParticleSpec spec;
  spec.name = name;
  spec.material = scene.materials[c.material].name;
  spec.explicit_particles.push_back({Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), c.diameter});
  return spec;
}

// One of each, with the law of the scene.
Scene pair_scene(const Scene& scene, const Collider& a, const Collider& b) {
  Scene s;
  s.run.precision = scene.run.precision;
  s.run.gravity = Vec3::Zero();
  s.run.duration = 1;
  s.contact = scene.contact;
  s.contact.impact_speed = typical_speed(scene);
  s.materials = scene.materials;
  s.particles = {species_of(scene, a, "first"), species_of(scene, b, "second")};
  return s;
}

// Springs that stiffen have a contact time for each speed: it is that of the scene's impacts. That
// of linear ones is the same at all, and shallow impacts serve.
Meeting meeting_of(const Scene& scene, const Collider& a, const Collider& b) {
  const Scene pair = pair_scene(scene, a, b);
  Meeting m{a, b, typical_speed(scene), 0};
  for (const StepAdvice& advice : advise_steps(pair, draw_sizes(pair), 1)) {
    if (advice.a == "first" && advice.b == "second") m.contact_time = advice.contact_time;
  }
  if (scene.contact.law == ForceLaw::kLinearSpringDashpot) {
    m.speed = kDepth * std::min(a.diameter, b.diameter) * kPi / m.contact_time;
  }
  return m;
}

Scene scene_of(const Scene& scene, const Meeting& m, double dt) {
  Scene s = pair_scene(scene, m.a, m.b);
  s.run.time_step = dt;
  const double apart = 3 * std::max(m.a.diameter, m.b.diameter);
  const double reach = 0.5 * (m.a.diameter + m.b.diameter);
  for (ParticleSpec& species : s.particles) species.explicit_particles.clear();
  for (int k = 0; k < kPhases; ++k) {
    const double y = apart * k, gap = (k + 0.5) / kPhases * m.speed * dt;
    s.particles[0].explicit_particles.push_back(
        {{reach + gap, y, 0}, {-0.5 * m.speed, 0, 0}, Vec3::Zero(), m.a.diameter});
    s.particles[1].explicit_particles.push_back(
        {{0, y, 0}, {0.5 * m.speed, 0, 0}, Vec3::Zero(), m.b.diameter});
  }
  s.domain.low = Vec3::Constant(-2 * apart);
  s.domain.high = Vec3(3 * apart, apart * (kPhases + 1), 2 * apart);
  return s;
}

template <class Real>
DeliveredRestitution deliver(const Scene& scene, const Meeting& m, double asked, double dt) {
  const Scene trial = scene_of(scene, m, dt);
  std::vector<ParticleSeed> seeds = draw_sizes(trial);
  SceneGeometry geometry = build_geometry(trial, {}, seeds);
  World<Real> world = make_world<Real>(trial, std::move(geometry), seeds, seeds);
  world.clock.dt = dt;
  set_law(world, trial, {});
  Stepper<Real> stepper(world, 1);
  const auto steps = static_cast<int>(3 * m.contact_time / dt) + 10;
  for (int k = 0; k < steps; ++k) stepper.step();
  std::vector<double> parting(kPhases, 0);
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    const double v = static_cast<double>(world.particles.record[k].vx);
    parting[world.particles.id[k] % kPhases] += world.particles.species[k] == 0 ? v : -v;
  }
  DeliveredRestitution found{asked, 0, 0};
  for (const double v : parting) found.mean += v / m.speed / kPhases;
  for (const double v : parting) {
    found.scatter += std::pow(v / m.speed - found.mean, 2) / kPhases;
  }
  found.scatter = std::sqrt(found.scatter);
  return found;
}

}  // namespace

DeliveredRestitution measure_restitution(const Scene& scene,
                                         std::span<const ParticleSeed> particles, double dt) {
  const std::vector<PairValues> laws = resolve_pairs(scene);
  const std::vector<Collider> all = colliders(particles);
  DeliveredRestitution worst;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i; j < all.size(); ++j) {
      const Meeting m = meeting_of(scene, all[i], all[j]);
      const double asked =
          laws[all[i].material * scene.materials.size() + all[j].material].restitution;
      const DeliveredRestitution found = scene.run.precision == Precision::kDouble
                                             ? deliver<double>(scene, m, asked, dt)
                                             : deliver<float>(scene, m, asked, dt);
      const auto off = [](const DeliveredRestitution& d) {
        return std::hypot(d.mean - d.asked, d.scatter);
      };
      if (off(found) >= off(worst)) worst = found;
    }
  }
  return worst;
}

double impact_overlap(const Scene& scene, std::span<const ParticleSeed> particles) {
  Collider heaviest;
  double mass = 0;
  for (const ParticleSeed& p : particles) {
    const double m = scene.materials[p.material].density * sphere_volume(p.radius);
    if (m <= mass) continue;
    mass = m;
    heaviest = {p.material, 2 * p.radius};
  }
  if (mass == 0) return 0;
  // The largest overlap is speed times contact time over this.
  constexpr double kHertzDepth = 2.9432750;
  const bool linear = scene.contact.law == ForceLaw::kLinearSpringDashpot;
  const double time = meeting_of(scene, heaviest, heaviest).contact_time;
  return typical_speed(scene) * time / (linear ? kPi : kHertzDepth) / (0.5 * heaviest.diameter);
}

}  // namespace quern
