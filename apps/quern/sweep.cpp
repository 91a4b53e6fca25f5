#include "apps/quern/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "apps/quern/sweep_measure.h"
#include "apps/quern/sweep_slurm.h"
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

// Of so many cases the particle steps.
struct Load {
  std::size_t cases = 0;
  double work = 0;
  void add(const SweepRun& run) {
    ++cases;
    work += run.steps * run.particles;
  }
};

// The width that goes through most particle steps a second, said with the others.
SweepSpeed choose_width(const SweepPlan& plan, const SweepOptions& options, const Load& load) {
  std::vector<SweepWidth> widths = widths_of(plan, load.cases);
  if (options.threads > 0) {
    const int at_once = std::max(1, machine_cores() / options.threads);
    widths = {{std::min(at_once, widths.front().at_once), options.threads}};
  }
  if (options.at_once > 0) {
    for (SweepWidth& width : widths) width.at_once = std::min(width.at_once, options.at_once);
  }
  if (options.at_once > 0 && options.threads > 0) return {{options.at_once, options.threads}, 0};
  const std::vector<SweepSpeed> speeds = measure_widths(plan, widths, load.work);
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
  Load all;
  for (const SweepRun& run : plan.cases) all.add(run);
  const SweepSpeed speed = choose_width(plan, options, all);
  const double each = seconds_per_step(speed);
  const std::string time = each > 0 ? format_clock(all.work * each / speed.width.at_once) +
                                          " for all cases, without filling"
                                    : "not measured";
  log_info(fmt::format("time         about {}", time));
  log_info(fmt::format("disk         about {:.2g} GB for all cases", measure_disk(plan) * 1e-9));
  print_list(plan);
  return 0;
}

// Table and page of all cases, and how many there are of each kind.
int gather(const SweepPlan& plan) {
  const SweepTable table = table_of(plan);
  write_results(plan, table);
  const auto count = [&](const char* status) {
    return std::count_if(table.status.begin(), table.status.end(),
                         [&](const std::string& s) { return s.starts_with(status); });
  };
  const auto failed = count("failed");
  std::string line =
      fmt::format("{} of {} finished, {} failed", count("finished"), plan.cases.size(), failed);
  for (const char* status : {"running", "stopped", "missing"}) {
    if (count(status) > 0) line += fmt::format(", {} {}", count(status), status);
  }
  log_info("cases        " + line);
  log_info(fmt::format("results      {0}/sweep.csv, {0}/sweep.h5\npage         {0}/sweep.html",
                       plan.out));
  return failed > 0 ? 4 : 0;
}

int run_one(const SweepPlan& plan, const SweepOptions& options) {
  if (options.only > static_cast<int>(plan.cases.size()))
    throw UserError(fmt::format("--case {}: there are {} cases", options.only, plan.cases.size()));
  const auto k = static_cast<std::size_t>(options.only - 1);
  if (options.filling && plan.cases[k].filling < 0)
    throw UserError(fmt::format("--case {} --filling: it starts from none", options.only));
  const SweepWidth width{1, options.threads > 0 ? options.threads : machine_cores()};
  const JobsResult result =
      run_cases(plan, {k}, width, 0, options.filling ? JobsPart::kFillings : JobsPart::kCases);
  log_info(fmt::format("{}      {}", options.filling ? "filling" : "case   ",
                       result.finished > 0 ? "finished"
                       : result.failed > 0 ? "failed"
                                           : "stopped; the same command goes on"));
  return result.failed > 0 ? 4 : 0;
}

int run_all(const SweepPlan& plan, const SweepOptions& options) {
  print_cases(plan);
  std::vector<std::size_t> cases(plan.cases.size());
  std::iota(cases.begin(), cases.end(), std::size_t{0});
  Load left;
  for (const SweepRun& run : plan.cases) {
    if (outcome_of(run).state == RunState::kStopped) left.add(run);
  }
  SweepSpeed speed;
  if (left.cases > 0) speed = choose_width(plan, options, left);
  const JobsResult result =
      run_cases(plan, cases, speed.width, seconds_per_step(speed), JobsPart::kCases);
  gather(plan);
  if (result.stopped) log_info("stopped; the same command goes on");
  return result.failed > 0 ? 4 : 0;
}

}  // namespace

int sweep_command(const SweepOptions& options) {
  if (options.only > 0) heed_signals();  // a job may be told of its end at any moment
  const SweepPlan plan = plan_sweep(options.file, options.out);
  if (options.plan) return print_plan(plan, options);
  if (options.collect && !std::filesystem::is_directory(plan.out))
    throw UserError(fmt::format("there is no folder '{}' to collect from", plan.out));
  make_folder("results", plan.out);
  if (options.collect) return gather(plan);
  if (options.slurm) return submit_sweep(plan, options);
  return options.only > 0 ? run_one(plan, options) : run_all(plan, options);
}

}  // namespace quern
