#include "apps/quern/step_rate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "scheduler/phases.h"
#include "scheduler/step.h"

namespace quern {

namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Places the particles; those that come in over time all at once and anywhere, or a step would cost
// nothing. False: they have no room together.
bool place_all(const Scene& scene, SceneGeometry& geometry, std::vector<ParticleSeed>& seeds,
               double& depth, Say say) {
  Scene at_once = scene;
  if (inserted_later(scene)) {
    at_once.fill.over = 0;
    at_once.fill.low = at_once.fill.high = std::nullopt;  // where they come in
    // A box has room above it, as high as need be.
    const bool* periodic = scene.domain.periodic;
    if (!periodic[0] && !periodic[1] && !periodic[2]) {
      at_once.domain.low = at_once.domain.high = std::nullopt;
    }
  }
  FillReport fill;
  try {
    fill = place_particles(at_once, geometry.facets(), seeds);
  } catch (const UserError&) {
    if (!inserted_later(scene)) throw;
    return false;
  }
  say(fmt::format("placing      {:.1f} s, solid fraction {:.3f}{}", fill.seconds, fill.fraction,
                  inserted_later(scene)
                      ? fmt::format(" (at once, to measure; in the run they rain in over {:g} s)",
                                    scene.fill.over)
                      : ""));
  include_fill(at_once, fill.low, fill.high, geometry);
  depth = fill.height(scene.run.gravity);
  return true;
}

template <class Real>
std::optional<StepRate> measure(LoadedScene& loaded, int threads, double time, Say say) {
  std::vector<ParticleSeed> seeds = loaded.seeds;
  SceneGeometry geometry = build_geometry(loaded.scene, loaded.meshes, seeds);
  double depth = 0;
  if (!place_all(loaded.scene, geometry, seeds, depth, say)) return std::nullopt;
  World<Real> world =
      make_world<Real>(loaded.scene, std::move(geometry), seeds, seeds, std::move(loaded.shapes));
  const std::vector<PhasePlan> plan =
      plan_phases(loaded.scene, loaded.dt, depth, world.total_mass, world.smallest_radius);
  StepRate rate;
  for (const PhasePlan& phase : plan) rate.steps += static_cast<double>(phase.steps);
  rate.run_steps = static_cast<double>(plan.back().steps);
  rate.particles = static_cast<double>(seeds.size());
  Stepper<Real> stepper(world, threads);
  rate.threads = stepper.graph().threads();
  enter_phase(world, loaded.scene, plan, 0);
  const double start = seconds();
  std::uint64_t taken = 0;
  while (seconds() - start < time && taken < plan[0].steps) {
    if ((stepper.step().bits & kFatalBits) != 0) break;
    ++taken;
  }
  loaded.shapes = std::move(world.shapes);  // the seeds point there
  rate.per_second = rate.particles * static_cast<double>(taken) / (seconds() - start);
  return rate;
}

}  // namespace

double StepRate::settled_seconds(double count) const {
  // A settled charge has several times the contacts of one that has just been placed.
  constexpr double kSettledShare = 0.4;
  return count * particles / (kSettledShare * per_second);
}

std::optional<StepRate> measure_steps(LoadedScene& loaded, int threads, double time, Say say) {
  return loaded.scene.run.precision == Precision::kDouble
             ? measure<double>(loaded, threads, time, say)
             : measure<float>(loaded, threads, time, say);
}

}  // namespace quern
