#include "scheduler/phases.h"

#include <algorithm>
#include <cmath>

#include "kernels/laws/stiffness.h"
#include "scheduler/setup.h"

namespace quern {

namespace {

constexpr double kTrueLawTime = 0.1;  // s, the end of every settling
// 1/s. What was placed close falls at 0.8 m/s: a ball that lands much faster presses fines in
// so deep that they burst out when the springs stiffen. Rain has far to fall.
constexpr double kSoftDrag = 12, kRainDrag = 4;
constexpr double kStiffenTime = 0.12;       // s; a deep bed rises by centimetres while it stiffens
constexpr int kStiffenStages = 48;          // so many that a stage releases a tenth of the overlap
constexpr double kStiffenDrag = 60;         // 1/s: the bed swings, and falls together again, slowly
constexpr double kRelaxTrueLawTime = 0.05;  // s, the end of every relaxing
constexpr double kRelaxDrag = 20;           // 1/s
constexpr double kRelaxFriction = 0.3;  // of the scene's, while overlaps of polyhedra are capped
constexpr double kFirstCap = 1e-2;  // of the last one
constexpr double kPolyhedronCap = 1e-2;  // of the smallest one's radius, where the scene has no cap
constexpr int kRelaxStages = 32;

// By what the step may be divided where stiffnesses are multiplied: the contact takes as much
// longer. That of Hertz is (m^2 / (k^2 v))^(1/5).
double step_factor(const Scene& scene, double stiffness) {
  return scene.contact.law == ForceLaw::kHertzMindlin ? std::pow(stiffness, 0.4)
                                                      : std::sqrt(stiffness);
}

std::uint64_t steps_in(double time, double dt) {
  return static_cast<std::uint64_t>(std::llround(std::max(time, 0.0) / dt));
}

// s, of the slowest swing of a bed that is `depth` m high and stands on its floor: four times its
// depth over the speed of sound along a row of spheres, d sqrt(k / m), of the softest pair.
double swing_time(const Scene& scene, double depth, double radius) {
  double density = 0, softest = HUGE_VAL;
  for (const Material& m : scene.materials) density = std::max(density, m.density);
  const double load = density * scene.run.gravity.norm() * depth * 4 * radius * radius;
  for (const PairValues& pair : resolve_pairs(scene)) {
    double stiffness = pair.normal_stiffness;
    if (scene.contact.law == ForceLaw::kHertzMindlin) {  // where it carries the load
      const double factor = stiffness * std::sqrt(reduced_radius(radius, radius));
      stiffness = 1.5 * std::cbrt(load * factor * factor);
    }
    if (stiffness > 0) softest = std::min(softest, stiffness);
  }
  return 2 * depth / radius * std::sqrt(density * sphere_volume(radius) / softest);
}

void add_settling(const Scene& scene, double dt, double depth, double rest_energy,
                  double smallest_radius, std::vector<PhasePlan>& plan) {
  const RunSpec& run = scene.run;
  const bool until_rest = run.settle == SettleKind::kUntilRest;
  const double gravity = std::max(run.gravity.norm(), 1e-9);
  const double fall = std::sqrt(2 * depth / gravity);
  double total = run.settle_time;
  // Long enough for what is placed loosely: under the drag it falls at gravity / kSoftDrag.
  if (until_rest && total <= 0) total = std::max(4 * fall, depth * kSoftDrag / gravity) + 1;
  const bool soft = run.soft_stiffness < 1;
  const double stretch = soft ? 1 / step_factor(scene, run.soft_stiffness) : 1;
  double soft_time = total - kTrueLawTime;
  if (scene.fill.method == FillMethod::kRain)
    soft_time = std::max(soft_time, scene.fill.over + fall);
  if (soft && soft_time > 0) {
    plan.push_back({Phase::kSoft, run.soft_stiffness, dt * stretch,
                    scene.fill.method == FillMethod::kRain ? kRainDrag : kSoftDrag,
                    steps_in(soft_time, dt * stretch), until_rest ? rest_energy : 0});
    // A bed that swings slower than it stiffens would be thrown up: it takes longer, under less
    // drag.
    const double slow = std::max(1.0, swing_time(scene, depth, smallest_radius) / kStiffenTime);
    const double longer = slow * slow, drag = kStiffenDrag / slow;
    for (int stage = 1; stage <= kStiffenStages; ++stage) {
      // Slow at the soft end, where the bed rises most and steps are long.
      const double x = stage / double{kStiffenStages};
      const double stiffness = std::pow(run.soft_stiffness, 1 - x * x);
      const double stage_dt = dt / step_factor(scene, stiffness);
      plan.push_back({Phase::kStiffen, stiffness, stage_dt, drag,
                      steps_in(longer * kStiffenTime / kStiffenStages, stage_dt), 0});
    }
    plan.push_back({Phase::kStiffen, 1, dt, drag, steps_in(longer * run.calm_time, dt), 0});
    plan.push_back({Phase::kSettle, 1, dt, 0, steps_in(kTrueLawTime, dt), 0});
  } else {
    plan.push_back({Phase::kSettle, 1, dt, 0, steps_in(total, dt), until_rest ? rest_energy : 0});
  }
}

void add_relaxing(const Scene& scene, double dt, std::vector<PhasePlan>& plan) {
  const double total = scene.run.relax.value_or(0);
  const double capped = total - kRelaxTrueLawTime;
  for (int stage = 0; stage < kRelaxStages && capped > 0; ++stage) {
    const double cap = std::pow(kFirstCap, 1 - stage / (kRelaxStages - 1.0));
    plan.push_back({Phase::kRelax, 1, dt, kRelaxDrag, steps_in(capped / kRelaxStages, dt), 0, cap});
  }
  if (total > 0) {
    plan.push_back({Phase::kSettle, 1, dt, 0, steps_in(std::min(total, kRelaxTrueLawTime), dt), 0});
  }
}

template <class Real>
double smallest_polyhedron(const World<Real>& world) {
  double least = world.polyhedra.empty() ? 0 : HUGE_VAL;
  for (const double scale : world.polyhedra.scale) least = std::min(least, scale);
  return least;
}

}  // namespace

double run_time(const Scene& scene) {
  if (scene.run.duration) return *scene.run.duration;
  if (!scene.run.revolutions || !scene.mill) return 0;
  const double angle = 2 * kPi * *scene.run.revolutions;
  double low = 0, high = 1;
  while (std::abs(schedule_integral(scene.mill->rotation, high)) < angle && high < 1e9) high *= 2;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (std::abs(schedule_integral(scene.mill->rotation, middle)) < angle ? low : high) = middle;
  }
  return high;
}

std::vector<PhasePlan> plan_phases(const Scene& scene, double dt, double depth, double mass,
                                   double smallest_radius) {
  std::vector<PhasePlan> plan;
  add_relaxing(scene, dt, plan);
  if (scene.run.settle != SettleKind::kNone && scene.run.start == StartKind::kFill) {
    // At rest: the kinetic energy would not lift the charge by a hundredth of its finest radius.
    const double rest_energy = 0.01 * mass * scene.run.gravity.norm() * smallest_radius;
    add_settling(scene, dt, depth, rest_energy, smallest_radius, plan);
  }
  plan.push_back({Phase::kRun, 1, dt, 0, steps_in(run_time(scene), dt), 0});
  return plan;
}

template <class Real>
void enter_phase(World<Real>& world, const Scene& scene, const std::vector<PhasePlan>& plan,
                 std::size_t row) {
  const PhasePlan& phase = plan.at(row);
  Clock& clock = world.clock;
  // With a drag, that is, outside the true law, what swings sideways is to come to rest as well;
  // what stands deep in others is to slip out instead of wedging.
  set_law(world, scene,
          {phase.stiffness, phase.drag > 0,
           phase.overlap_cap > 0 && !world.polyhedra.empty() ? kRelaxFriction : 1});
  world.drag = std::exp(-phase.drag * phase.dt);
  world.overlap_cap = phase.overlap_cap *
                      scene.run.overlap_cap.value_or(kPolyhedronCap * smallest_polyhedron(world));
  world.caps_spheres = phase.overlap_cap > 0 && scene.run.overlap_cap.has_value();
  world.moving_walls = phase.kind == Phase::kRun;
  if (clock.phase == row && clock.total_steps > 0 && clock.dt == phase.dt) return;  // resumed
  clock.phase = row;
  clock.step = 0;
  if (clock.dt != phase.dt) clock.list_stale = 1;  // the lists' window is in steps
  clock.dt = phase.dt;
  world.ledger = Ledger();
  world.window = Window();
  if (phase.kind != Phase::kRun) return;
  clock.warnings = 0;
  world.polyhedra.fallbacks = Fallbacks();
}

template <class Real>
bool phase_is_over(const World<Real>& world, const PhasePlan& plan) {
  if (world.clock.step >= plan.steps) return true;
  constexpr std::uint64_t kLookEvery = 50;
  if (plan.rest_energy <= 0 || world.clock.step % kLookEvery != 0) return false;
  // Not at rest if it has only just been let go.
  if (static_cast<double>(world.clock.step) * plan.dt < 0.2) return false;
  return world.totals.translational + world.totals.rotational < plan.rest_energy;
}

template void enter_phase(World<float>&, const Scene&, const std::vector<PhasePlan>&, std::size_t);
template void enter_phase(World<double>&, const Scene&, const std::vector<PhasePlan>&, std::size_t);
template bool phase_is_over(const World<float>&, const PhasePlan&);
template bool phase_is_over(const World<double>&, const PhasePlan&);

}  // namespace quern
