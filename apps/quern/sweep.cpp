#include "apps/quern/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "apps/quern/sweep_measure.h"
#include "apps/quern/sweep_table.h"
#include "io/file_commit.h"
#include "io/log.h"

namespace quern {

namespace {

void print_cases(const SweepPlan& plan) {
  const auto done = static_cast<std::size_t>(std::count_if(
      plan.cases.begin(), plan.cases.end(),
      [](const SweepRun& run) { return outcome_of(run).state == RunState::kFinished; }));
  log_info(fmt::format("cases        {}, {} of them finished; {} fillings", plan.cases.size(), done,
                       plan.fillings.size()));
}

void print_list(const SweepPlan& plan) {
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    const SweepRun& run = plan.cases[k];
    const std::string filling =
        run.filling < 0 ? "" : plan.fillings[static_cast<std::size_t>(run.filling)].folder;
    log_info(fmt::format("{:>5}  {}  {}{}", k + 1, run.place.name,
                         fmt::join(run.place.values, ", "),
                         filling.empty() ? "" : "  from " + filling.substr(plan.out.size() + 1)));
  }
}

// The width that goes through most particle steps a second, said with the others.
SweepSpeed choose_width(const SweepPlan& plan, const SweepOptions& options, std::size_t cases) {
  std::vector<SweepWidth> widths = widths_of(plan, cases);
  if (options.threads > 0) {
    const int at_once = std::max(1, machine_cores() / options.threads);
    widths = {{std::min(at_once, widths.front().at_once), options.threads}};
  }
  if (options.at_once > 0) {
    for (SweepWidth& width : widths) width.at_once = std::min(width.at_once, options.at_once);
  }
  if (options.at_once > 0 && options.threads > 0) return {{options.at_once, options.threads}, 0};
  const std::vector<SweepSpeed> speeds = measure_widths(plan, widths);
  const SweepSpeed best = *std::max_element(
      speeds.begin(), speeds.end(),
      [](const SweepSpeed& a, const SweepSpeed& b) { return a.per_second < b.per_second; });
  std::string all;
  for (const SweepSpeed& speed : speeds) {
    all += fmt::format("{}{} x {} threads {:.3g}/s", all.empty() ? "" : ", ", speed.width.at_once,
                       speed.width.threads, speed.per_second);
  }
  log_info(fmt::format("width        {} at a time, {} threads each (particle steps measured: {})",
                       best.width.at_once, best.width.threads, all));
  return best;
}

int print_plan(const SweepPlan& plan, const SweepOptions& options) {
  print_cases(plan);
  const SweepSpeed speed = choose_width(plan, options, plan.cases.size());
  double work = 0;
  for (const SweepRun& run : plan.cases) work += run.steps * run.particles;
  const double each = seconds_per_step(speed);
  const std::string time =
      each > 0 ? format_clock(work * each / speed.width.at_once) + " for all cases, without filling"
               : "not measured";
  log_info(fmt::format("time         about {}", time));
  log_info(fmt::format("disk         about {:.2g} GB for all cases", measure_disk(plan) * 1e-9));
  print_list(plan);
  return 0;
}

std::vector<std::size_t> wanted_cases(const SweepPlan& plan, const SweepOptions& options) {
  if (options.only > static_cast<int>(plan.cases.size()))
    throw UserError(fmt::format("--case {}: there are {} cases", options.only, plan.cases.size()));
  if (options.only > 0) return {static_cast<std::size_t>(options.only - 1)};
  std::vector<std::size_t> all(plan.cases.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

int sweep_command(const SweepOptions& options) {
  const SweepPlan plan = plan_sweep(options.file, options.out);
  if (options.plan) return print_plan(plan, options);
  make_folder("results", plan.out);
  const std::vector<std::size_t> cases = wanted_cases(plan, options);
  if (options.only == 0) print_cases(plan);
  const auto left =
      static_cast<std::size_t>(std::count_if(cases.begin(), cases.end(), [&](std::size_t k) {
        return outcome_of(plan.cases[k]).state == RunState::kStopped;
      }));
  SweepSpeed speed;
  if (options.only > 0) {
    speed.width = {1, options.threads > 0 ? options.threads : machine_cores()};
  } else if (left > 0) {
    speed = choose_width(plan, options, left);
  }
  const JobsResult result = run_cases(plan, cases, speed.width, seconds_per_step(speed));
  if (options.only == 0) write_results(plan);
  log_info(fmt::format("cases        {} of {} finished, {} failed", result.finished, cases.size(),
                       result.failed));
  if (options.only == 0)
    log_info(fmt::format("results      {0}/sweep.csv, {0}/sweep.h5\npage         {0}/sweep.html",
                         plan.out));
  if (result.stopped) log_info("stopped; the same command goes on");
  return result.failed > 0 ? 4 : 0;
}

}  // namespace quern
