#include "apps/quern/trade_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "apps/quern/start.h"
#include "io/log.h"
#include "io/summary.h"
#include "scheduler/stage_times.h"
#include "scheduler/step.h"

namespace quern {

namespace {

constexpr int kTurns = 7;

template <class Real>
class TimedRunOf final : public TimedRun {
 public:
  TimedRunOf(LoadedScene loaded, const std::string& checkpoint, int threads)
      : start_(std::move(loaded), checkpoint, [](std::string_view) {}),
        stepper_(start_.world, threads) {
    enter_phase(start_.world, start_.loaded.scene, start_.plan, start_.plan.size() - 1);
  }

  double take(double time) override {
    const auto steps = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::llround(time / start_.world.clock.dt)));
    run(steps / 10 + 1);  // warms the caches that the other run has filled
    Stopwatch watch;
    run(steps);
    return watch.lap() * time / (static_cast<double>(steps) * start_.world.clock.dt);
  }

 private:
  void run(std::uint64_t steps) {
    for (std::uint64_t k = 0; k < steps; ++k) {
      const StepReport report = stepper_.step();
      if ((report.bits & kFatalBits) != 0) {
        throw UserError(failure_text(start_.world, report, start_.plan.back()));
      }
    }
  }

  Start<Real> start_;
  Stepper<Real> stepper_;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

// Simulated time that takes the run `segment` s of the wall clock.
double stretch_of(TimedRun& run, double first, double segment) {
  double time = first;
  for (int k = 0; k < 20; ++k) {
    const double taken = run.take(time);
    if (taken > 0.5 * segment) return time * segment / taken;
    time *= 2;
  }
  return time;
}

TradeCost measure(const std::string& folder, const std::string& default_folder, int threads,
                  double segment) {
  const std::unique_ptr<TimedRun> reference = open_run(default_folder, threads);
  const std::unique_ptr<TimedRun> run = open_run(folder, threads);
  constexpr double kFirst = 1e-4;  // s
  const double time = stretch_of(*reference, kFirst, segment);
  run->take(0.1 * time);
  std::vector<double> ratios, seconds;
  for (int k = 0; k < kTurns; ++k) {
    const double of_default = reference->take(time), own = run->take(time);
    ratios.push_back(own / of_default);
    seconds.push_back(own / time);
  }
  return {quantile(ratios, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.75),
          quantile(seconds, 0.5)};
}

}  // namespace

std::unique_ptr<TimedRun> open_run(const std::string& folder, int threads) {
  const std::string path = usable_checkpoint(folder);
  LoadedScene loaded = load_scene_text(read_checkpoint_header(path).scene_text, path, folder);
  if (loaded.scene.run.precision == Precision::kDouble) {
    return std::make_unique<TimedRunOf<double>>(std::move(loaded), path, threads);
  }
  return std::make_unique<TimedRunOf<float>>(std::move(loaded), path, threads);
}

TradeCost cost_of(const std::string& folder, const std::string& default_folder, int threads,
                  double segment) {
  const std::string path = folder + "/cost.json";
  if (!std::filesystem::exists(path)) {
    const TradeCost cost = measure(folder, default_folder, threads, segment);
    Summary file;
    file.set("ratio", cost.ratio);
    file.set("ratio_low", cost.low);
    file.set("ratio_high", cost.high);
    file.set("wall_s_per_s", cost.seconds);
    file.write(path);
  }
  const SummaryFile file(path);
  return {file.number("ratio"), file.number("ratio_low"), file.number("ratio_high"),
          file.number("wall_s_per_s")};
}

}  // namespace quern
