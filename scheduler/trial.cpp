#include "scheduler/trial.h"

#include <algorithm>
#include <cmath>

#include "kernels/laws/damping.h"
#include "scheduler/fill.h"
#include "scheduler/phases.h"
#include "scheduler/setup.h"
#include "scheduler/step.h"

namespace quern {

namespace {

constexpr double kRestDrag = 200;  // 1/s
constexpr double kRest = 1e-9;     // m g d, kinetic energy of a particle at rest

Scene trial_scene(const Scene& scene, const TrialSpec& spec, double dt) {
  Scene s;
  s.run.precision = Precision::kDouble;
  s.run.gravity = {0, 0, -9.81};
  s.run.time_step = dt;
  s.run.duration = 1;
  s.run.settle = SettleKind::kDuration;
  s.contact = scene.contact;
  s.contact.impact_speed = typical_speed(scene);  // the same steps per contact
  s.materials = scene.materials;
  const double side = 3.2 * spec.to;
  const double depth =
      3.5 * static_cast<double>(spec.particles) * std::pow(spec.to, 3) / (side * side);
  s.run.settle_time = 3 * std::sqrt(2 * depth / 9.81);
  s.domain.low = Vec3(0, 0, -spec.to);
  s.domain.high = Vec3(side, side, depth + 2 * spec.to);
  s.domain.periodic[0] = s.domain.periodic[1] = true;
  s.planes.push_back({"floor", spec.wall_material, Vec3::Zero(), Vec3::UnitZ(), Motion()});
  s.fill.method = FillMethod::kRandom;
  s.fill.low = Vec3::Zero();
  s.fill.high = Vec3(side, side, depth);
  ParticleSpec p;
  p.name = "trial";
  p.material = spec.material;
  p.sizes.push_back({spec.from, spec.to, static_cast<long>(spec.particles), std::nullopt});
  s.particles.push_back(p);
  return s;
}

void run_steps(Stepper<double>& stepper, std::uint64_t steps) {
  for (std::uint64_t k = 0; k < steps; ++k) {
    if ((stepper.step().bits & kFatalBits) != 0) return;
  }
}

// The kinetic energy that this part of all particles stays below, J.
double energy_below(const World<double>& world, double part) {
  std::vector<double> energy;
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    const Record<double>& r = world.particles.record[k];
    energy.push_back(0.5 * (r.vx * r.vx + r.vy * r.vy + r.vz * r.vz) /
                     world.particles.traits[k].inverse_mass);
    if (!std::isfinite(energy.back())) return HUGE_VAL;
  }
  const auto at = static_cast<std::size_t>(part * static_cast<double>(energy.size()));
  std::nth_element(energy.begin(), energy.begin() + static_cast<std::ptrdiff_t>(at), energy.end());
  return energy[at];
}

}  // namespace

TrialSpec finest_class_trial(const Scene& scene) {
  TrialSpec spec;
  spec.from = HUGE_VAL;
  const auto consider = [&](const ParticleSpec& p, double from, double to) {
    if (from >= spec.from) return;
    spec.from = from;
    spec.to = to;
    spec.material = p.material;
  };
  for (const ParticleSpec& p : scene.particles) {
    if (p.diameter) consider(p, *p.diameter, *p.diameter);
    for (const SizeClass& c : p.sizes) consider(p, c.from, c.to);
    const SizeDistribution& d = p.distribution;
    if (d.kind == DistributionKind::kRosinRammler) consider(p, d.from, 1.5 * d.from);
    if (!d.passing.empty()) consider(p, d.passing.front().first, 1.5 * d.passing.front().first);
    for (const ExplicitParticle& e : p.explicit_particles) consider(p, e.diameter, e.diameter);
  }
  spec.to = std::min(spec.to, 2 * spec.from);
  spec.wall_material = spec.material;
  if (!scene.planes.empty()) spec.wall_material = scene.planes.front().material;
  if (scene.mill) spec.wall_material = scene.mill->material;
  return spec;
}

StabilityTrial measure_stability(const Scene& scene, const TrialSpec& spec) {
  // Settled once with a comfortable step; every point starts from that packing.
  Scene base = trial_scene(scene, spec, 1);
  const std::vector<ParticleSeed> sizes = draw_sizes(base);
  double contact = HUGE_VAL;
  for (const StepAdvice& a : advise_steps(base, sizes, 1))
    contact = std::min(contact, a.contact_time);
  base.run.time_step = contact / 8;
  std::vector<ParticleSeed> seeds = sizes;
  SceneGeometry geometry = build_geometry(base, {}, seeds);
  place_particles(base, geometry.facets(), seeds);
  World<double> world = make_world<double>(base, std::move(geometry), seeds, seeds);
  const std::vector<PhasePlan> plan =
      plan_phases(base, *base.run.time_step, 0.1, world.total_mass, 0.5 * spec.from);
  Stepper<double> stepper(world, 1);
  for (std::size_t row = 0; row + 1 < plan.size(); ++row) {
    enter_phase(world, base, plan, row);
    run_steps(stepper, plan[row].steps);
  }
  const double mass = world.total_mass / static_cast<double>(seeds.size());
  const double weight = mass * 9.81 * spec.from;  // J: a lift by one diameter
  // The last spheres roll for a while: a drag brings all but rattlers to rest, then it is taken
  // away.
  constexpr std::uint64_t kRound = 2000;
  constexpr int kMostRounds = 150;
  world.drag = std::exp(-kRestDrag * world.clock.dt);
  for (int k = 0; k < kMostRounds && energy_below(world, 0.9) > kRest * weight; ++k) {
    run_steps(stepper, kRound);
  }
  world.drag = 1;
  StabilityTrial trial;
  for (const double steps : spec.steps_per_contact) {
    // Another step is another effective stiffness: the packing shifts, and comes to rest again only
    // if the scheme lets it.
    world.clock.dt = contact / steps;
    world.clock.list_stale = 1;
    StabilityPoint point;
    point.steps_per_contact = steps;
    for (double time = 0; time < spec.patience && !point.stable;
         time += static_cast<double>(kRound) * world.clock.dt) {
      run_steps(stepper, kRound);
      point.energy = energy_below(world, 0.5);
      point.stable = point.energy < kRest * weight;
    }
    trial.points.push_back(point);
    if (!point.stable) break;
    trial.limit = steps;
  }
  return trial;
}

}  // namespace quern
