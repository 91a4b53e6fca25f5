#include "apps/quern/sweep_measure.h"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <thread>

#include "apps/quern/child_run.h"
#include "apps/quern/machine.h"
#include "apps/quern/step_rate.h"
#include "io/file_commit.h"
#include "io/scene_reader.h"
#include "scheduler/phases.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

constexpr double kSpare = 0.9;  // of the memory

// s, of a width: together about so much of what the sweep will take, at a usual speed.
double measuring_time(double work, std::size_t widths) {
  constexpr double kLeast = 0.1, kMost = 1, kShare = 0.005, kUsualSpeed = 5e6;
  const double expected = work / (kUsualSpeed * machine_cores());
  return std::clamp(kShare * expected / static_cast<double>(widths), kLeast, kMost);
}

const SweepRun& middle(const SweepPlan& plan) { return plan.cases[plan.cases.size() / 2]; }

double most_memory(const SweepPlan& plan) {
  double most = 0;
  for (const SweepRun& run : plan.cases) most = std::max(most, run.memory);
  return most;
}

double bytes_below(const fs::path& folder) {
  double bytes = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) bytes += static_cast<double>(entry.file_size());
  }
  return bytes;
}

// Frames of a run; 0: none are asked for.
double frames_of(const Scene& scene, double time) {
  return scene.output.frames_every > 0 ? std::floor(time / scene.output.frames_every) + 1 : 0;
}

}  // namespace

int machine_cores() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0) return CPU_COUNT(&allowed);
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

std::vector<SweepWidth> widths_of(const SweepPlan& plan, std::size_t cases) {
  const int cores = machine_cores();
  const double fit = std::floor(kSpare * available_memory() / most_memory(plan));
  const int most = static_cast<int>(
      std::clamp(std::min(fit, static_cast<double>(cases)), 1.0, static_cast<double>(cores)));
  std::vector<SweepWidth> widths;
  for (int threads = 1; threads < 2 * cores; threads *= 2) {
    const SweepWidth width{std::min(most, std::max(1, cores / threads)), std::min(threads, cores)};
    widths.push_back(width);
  }
  return widths;
}

std::vector<SweepSpeed> measure_widths(const SweepPlan& plan, const std::vector<SweepWidth>& widths,
                                       double work) {
  const double time = measuring_time(work, widths.size());
  const SweepRun& run = middle(plan);
  LoadedScene loaded = load_scene(plan.spec.scene, run.place.set, say_nothing);
  std::vector<SweepSpeed> speeds;
  for (const SweepWidth& width : widths) {
    const std::vector<double> each = in_processes(width.at_once, [&] {
      const std::optional<StepRate> rate = measure_steps(loaded, width.threads, time, say_nothing);
      return rate ? rate->per_second : 0;
    });
    speeds.push_back({width, std::accumulate(each.begin(), each.end(), 0.0)});
  }
  return speeds;
}

double seconds_per_step(const SweepSpeed& speed) {
  if (!(speed.per_second > 0)) return 0;
  StepRate rate;
  rate.particles = 1;
  rate.per_second = speed.per_second / speed.width.at_once;
  return rate.settled_seconds(1);
}

double measure_disk(const SweepPlan& plan) {
  const SweepRun& run = middle(plan);
  const LoadedScene loaded = load_scene(plan.spec.scene, run.place.set, say_nothing);
  Scene scene = loaded.scene;
  const double time = run_time(scene), wanted = frames_of(scene, time);
  constexpr int kSteps = 4;
  scene.run.settle = SettleKind::kNone;
  scene.run.duration = kSteps * loaded.dt;
  scene.run.revolutions = scene.run.record_from = scene.run.record_from_revolution = std::nullopt;
  scene.output.series_every = loaded.dt;
  if (wanted > 0) scene.output.frames_every = kSteps / 2 * loaded.dt;
  scene.record.snapshots_every = 0;
  const std::string folder = plan.out + "/measure", file = folder + ".toml";
  make_folder("results", plan.out);
  write_text_file("scene", file, scene_to_toml(scene), Durability::kKill);
  std::optional<ChildRun> child = ChildRun::start(folder, [&] {
    return std::vector<std::string>{"run", file, "--out", folder, "--threads", "1"};
  });
  while (child && !child->poll()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  double bytes = bytes_below(folder);
  if (wanted > 0 && fs::exists(folder + "/frames")) {
    const double frames = bytes_below(folder + "/frames");
    bytes += frames * (wanted / (kSteps / 2 + 1) - 1);
  }
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  fs::remove(file, ignored);
  return bytes * static_cast<double>(plan.cases.size());
}

}  // namespace quern
