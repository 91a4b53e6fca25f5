#include "apps/quern/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/quern/load.h"
#include "apps/quern/machine.h"
#include "apps/quern/recorder.h"
#include "apps/quern/step_rate.h"
#include "apps/quern/trade_advice.h"
#include "io/log.h"
#include "scheduler/impact_trial.h"
#include "scheduler/trial.h"

namespace quern {

namespace {

// Critical speed of a mill in rpm, 42.3 / sqrt(D).
double critical_rpm(double diameter) { return 42.3 / std::sqrt(diameter); }

void print_contents(const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  std::map<std::size_t, std::pair<std::size_t, double>> by_species;
  double mass = 0, volume = 0;
  for (const ParticleSeed& p : loaded.seeds) {
    const double v = sphere_volume(p.radius), m = scene.materials[p.material].density * v;
    ++by_species[p.species].first;
    by_species[p.species].second += m;
    mass += m;
    volume += v;
  }
  for (const auto& [row, sums] : by_species) {
    log_info(fmt::format("particles    {:>9} {:<16} {:.6g} kg", sums.first,
                         scene.particles[row].name, sums.second));
  }
  log_info(fmt::format("in all       {:>9} particles, {:.6g} kg, solid volume {:.4g} m^3",
                       loaded.seeds.size(), mass, volume));
  log_info(fmt::format("memory       about {:.0f} MB expected of a run, {:.0f} MB available",
                       expected_memory(scene) * 1e-6, available_memory() * 1e-6));
  if (!scene.mill) return;
  const MillSpec& mill = *scene.mill;
  const double level = volume / kBulkSolidFraction / (mill_inner_area(mill) * mill.length);
  log_info(fmt::format("filling      {:.1f} % of the mill's volume (bulk at porosity 0.4)",
                       100 * level));
  double fastest = 0;
  for (const Schedule::Point& p : mill.rotation.points)
    fastest = std::max(fastest, std::abs(p.value));
  const double rpm = fastest * 30 / kPi;
  log_info(fmt::format("speed        {:.4g} rpm, {:.1f} % of critical ({:.4g} rpm)", rpm,
                       100 * rpm / critical_rpm(mill.diameter), critical_rpm(mill.diameter)));
}

// What the steps of springs that stiffen are counted at.
void print_impacts(const LoadedScene& loaded, const std::vector<StepAdvice>& all) {
  const StepAdvice& finest = *std::min_element(
      all.begin(), all.end(),
      [](const StepAdvice& a, const StepAdvice& b) { return a.rayleigh_time < b.rayleigh_time; });
  log_info(fmt::format("  of impacts at {:.3g} m/s ('contact.impact_speed')",
                       typical_speed(loaded.scene)));
  log_info(
      fmt::format("Rayleigh     {:.4g} s of {}; the step is {:.3g} of it ({:g} refused, {:g} "
                  "warned, {:g} advised)",
                  finest.rayleigh_time, finest.a, loaded.dt / finest.rayleigh_time,
                  kRefusedRayleigh, kWarnedRayleigh, kAdvisedRayleigh));
}

void print_steps(const LoadedScene& loaded) {
  const std::vector<StepAdvice> all = advise_steps(loaded.scene, loaded.seeds, loaded.dt);
  log_info(
      fmt::format("time step    {:.4g} s; steps per contact: normal ({:g} refused, {:g} warned, "
                  "{:g} advised), tangential",
                  loaded.dt, kRefusedSteps, kWarnedSteps, kAdvisedSteps));
  for (const StepAdvice& a : all) {
    log_info(fmt::format("  {:<20} {:<20} {:8.1f} {:8.1f}", a.a, a.b, a.steps_normal,
                         a.steps_tangential));
  }
  if (loaded.scene.contact.law == ForceLaw::kHertzMindlin) print_impacts(loaded, all);
  const TrialSpec spec = finest_class_trial(loaded.scene);
  const StabilityTrial trial = measure_stability(loaded.scene, spec);
  const std::string found =
      trial.limit > 0
          ? fmt::format("stayed at rest down to {:g} steps per contact", trial.limit)
          : fmt::format(
                "did not come to rest at any step tried, not even at {:g} steps per contact",
                spec.steps_per_contact.front());
  log_info(fmt::format("limit        a dense packing of spheres of {:g}-{:g} mm {} (measured)",
                       1e3 * spec.from, 1e3 * spec.to, found));
}

void print_accuracy(const LoadedScene& loaded) {
  if (loaded.seeds.empty()) return;
  const DeliveredRestitution found = measure_restitution(loaded.scene, loaded.seeds, loaded.dt);
  log_info(
      fmt::format("restitution  of {:g} asked {:.4f} +- {:.4f} is delivered, by when in a step two "
                  "meet (measured; of all materials the pair furthest off)",
                  found.asked, found.mean, found.scatter));
  log_info("accuracy     of other scenes at settings like these (quern trade; errors with standard "
           "errors, <: below two)");
  const JudgedScene scene = {fewest_steps_per_contact(loaded),
                             impact_overlap(loaded.scene, loaded.seeds),
                             precision_name(loaded.scene)};
  for (const std::string& line : expected_accuracy(scene, shipped_tables())) log_info(line);
}

void print_walls(const Facets& facets) {
  const FacetReport& r = facets.report;
  std::string faults;
  const auto add = [&](Index count, const char* what) {
    if (count > 0) faults += fmt::format(", {} {}", count, what);
  };
  add(r.duplicates, "dropped as duplicates");
  add(r.flipped_edges, "edges between triangles that face opposite ways");
  add(r.non_manifold_edges, "edges of more than two triangles");
  log_info(
      fmt::format("walls        {} triangles, {} edges; {} without area, {} welded corners, "
                  "{} split edges, {} open edges{}",
                  facets.triangles(), facets.edges(), r.zero_area, r.welded_vertices, r.split_edges,
                  r.boundary_edges, faults));
}

void print_cost(LoadedScene& loaded, int threads) {
  const SceneGeometry geometry = build_geometry(loaded.scene, loaded.meshes, loaded.seeds);
  for (const Body& body : geometry.bodies) print_walls(body.facets);
  const std::optional<StepRate> rate = measure_steps(loaded, threads, 2, log_info);
  if (!rate) {
    log_info("time         not measured: the particles rain in and have no room all at once");
    return;
  }
  log_info(fmt::format("memory       {:.0f} MB peak so far, {:.0f} B per particle",
                       static_cast<double>(peak_memory()) * 1e-6,
                       static_cast<double>(peak_memory()) / rate->particles));
  const std::string text =
      rate->per_second > 0
          ? fmt::format(
                "{:.3g} particle steps per second measured on the loose charge, {} threads; "
                "about {} with the charge settled",
                rate->per_second, rate->threads, format_clock(rate->settled_seconds(rate->steps)))
          : "not measured: particles overlap where they are placed";
  log_info(fmt::format("time         {:.0f} steps; {}", rate->steps, text));
}

}  // namespace

int check_command(const RunOptions& options) {
  LoadedScene loaded = load_scene(options.scene, options.overrides);
  log_info(fmt::format("{}: valid", options.scene));
  print_contents(loaded);
  print_steps(loaded);
  print_accuracy(loaded);
  print_cost(loaded, options.threads);
  judge_time_step(loaded);
  return 0;
}

}  // namespace quern
