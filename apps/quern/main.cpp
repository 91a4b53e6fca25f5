// The command line of quern: run, resume, report, compare, check, bench, trade, sweep, shape, info.
//
// Exit codes: 0 fine, 1 a defect of ours, 2 the user's input, 3 the system (disk, files), 4 the run
// went wrong (and left a checkpoint).
#include <CLI/CLI.hpp>
#include <cfenv>
#include <cstdlib>

#include "apps/quern/bench.h"
#include "apps/quern/check.h"
#include "apps/quern/info.h"
#include "apps/quern/load.h"
#include "apps/quern/report.h"
#include "apps/quern/run.h"
#include "apps/quern/shape.h"
#include "apps/quern/sweep.h"
#include "apps/quern/trade.h"
#include "io/log.h"
#include "kernels/simd_target.h"

namespace {

CLI::App* add_trade(CLI::App& app, quern::TradeOptions& o) {
  CLI::App* trade = app.add_subcommand("trade", "speed against accuracy, one dial at a time");
  trade->add_option("scene", o.scene, "SCENE.toml, of a mill")->required();
  trade->add_option("--out", o.out, "folder for the runs and the table")
      ->default_str("out/trade/<scene>");
  trade->add_option("--threads", o.threads, "number of threads (0: all)")
      ->check(CLI::Range(0, 4096));
  trade->add_option("--set", o.overrides, "key=value, replaces a value of the scene")->take_all();
  trade->add_option("--only", o.only, "a dial or setting as --list has it, repeatable")->take_all();
  trade->add_option("--steady", o.steady, "turns of the steady state")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  trade->add_option("--lead", o.lead, "turns of a setting before the record")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  trade->add_option("--revolutions", o.revolutions, "turns recorded")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1e6));
  trade->add_option("--spheres", o.spheres,
                    "folder of a run whose end is the steady charge of spheres");
  trade->add_option("--segment", o.segment, "s, a timed stretch of the default")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e3));
  trade->add_flag("--list", o.list, "shows the settings and runs none");
  trade->add_flag("--table", o.table, "the table of what is finished; runs none");
  return trade;
}

CLI::App* add_sweep(CLI::App& app, quern::SweepOptions& o) {
  CLI::App* sweep = app.add_subcommand("sweep", "many runs of a scene: factors, table, page");
  sweep->add_option("file", o.file, "SWEEP.toml")->required();
  sweep->add_option("--out", o.out, "folder for the runs and the table")
      ->default_str("out/<sweep>");
  sweep->add_option("--at-once", o.at_once, "runs at a time (0: as is fastest)")
      ->check(CLI::Range(0, 4096));
  sweep
      ->add_option("--threads", o.threads,
                   "of each run (0: as is fastest; all with --case, 1 with --slurm)")
      ->check(CLI::Range(0, 4096));
  CLI::Option* plan =
      sweep->add_flag("--plan", o.plan, "shows the cases, time and disk, and runs none");
  CLI::Option* one =
      sweep->add_option("--case", o.only, "runs one case alone, by its number in --plan")
          ->check(CLI::Range(1, 1000000));
  sweep->add_flag("--filling", o.filling, "with --case: only the filling that it starts from")
      ->needs(one);
  CLI::Option* collect = sweep->add_flag(
      "--collect", o.collect, "the table and page of what is finished by now; runs none");
  CLI::Option* slurm =
      sweep->add_flag("--slurm", o.slurm, "submits the cases to Slurm, as an array of jobs");
  for (CLI::Option* option : {plan, one, collect}) slurm->excludes(option);
  for (CLI::Option* option : {plan, one}) collect->excludes(option);
  plan->excludes(one);
  sweep->add_flag("--no-submit", o.no_submit, "with --slurm: writes the job scripts only")
      ->needs(slurm);
  sweep
      ->add_option("--time-limit", o.time_limit,
                   "with --slurm: of a job; a case that needs more is queued again")
      ->capture_default_str()
      ->needs(slurm);
  sweep
      ->add_option("--sbatch", o.sbatch,
                   "with --slurm: an option of sbatch (partition=long), repeatable")
      ->take_all()
      ->needs(slurm);
  return sweep;
}

int dispatch(int argc, char** argv) {
  CLI::App app{"quern: discrete-element simulation of grinding mills"};
  app.require_subcommand(1);
  app.set_version_flag("--version", QUERN_VERSION " " QUERN_COMMIT);
  quern::RunOptions options;
  double until = 0;

  CLI::App* run = app.add_subcommand("run", "run a scene");
  run->add_option("scene", options.scene, "SCENE.toml")->required();
  run->add_option("--out", options.out, "folder for the results")->default_str("out/<scene>");
  run->add_option("--threads", options.threads, "number of threads (0: all)")
      ->check(CLI::Range(0, 4096));
  CLI::Option* run_until = run->add_option("--until", until, "stop at this mill time, s");
  run->add_option("--set", options.overrides, "key=value, replaces a value of the scene")
      ->take_all();

  CLI::App* resume = app.add_subcommand("resume", "go on with a run from its checkpoint");
  resume->add_option("folder", options.out, "folder of the run")->required();
  resume->add_option("--threads", options.threads, "number of threads (0: all)")
      ->check(CLI::Range(0, 4096));
  CLI::Option* resume_until = resume->add_option("--until", until, "stop at this mill time, s");

  quern::ReportCommand report_options;
  CLI::App* report = app.add_subcommand("report", "the page of a run, of one that goes on too");
  report->add_option("folder", report_options.folders, "folder of the run")
      ->required()
      ->expected(1);
  report->add_option("--out", report_options.out, "the page")->default_str("<folder>/report.html");

  CLI::App* compare = app.add_subcommand("compare", "one page of several runs side by side");
  compare->add_option("folders", report_options.folders, "folders of the runs")
      ->required()
      ->expected(2, 8);
  compare->add_option("--out", report_options.out, "the page")->default_str("compare.html");

  CLI::App* check = app.add_subcommand("check", "validate a scene and say what it will cost");
  check->add_option("scene", options.scene, "SCENE.toml")->required();
  check->add_option("--threads", options.threads, "number of threads (0: all)")
      ->check(CLI::Range(0, 4096));
  check->add_option("--set", options.overrides, "key=value, replaces a value of the scene")
      ->take_all();

  quern::BenchOptions bench_options;
  CLI::App* bench = app.add_subcommand("bench", "what a step of a scene costs, stage by stage");
  bench->add_option("scene", bench_options.scene, "SCENE.toml")->required();
  bench->add_option("--steps", bench_options.steps, "steps of a repeat, after a warm-up of a tenth")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000000));
  bench->add_option("--threads", bench_options.threads, "number of threads (0: all)")
      ->check(CLI::Range(0, 4096));
  bench->add_option("--repeats", bench_options.repeats, "the best one is shown")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  bench->add_option("--set", bench_options.overrides, "key=value, replaces a value of the scene")
      ->take_all();
  bench->add_option("--target", bench_options.target, "SIMD target (default: the best)")
      ->check(CLI::IsMember(quern::simd_targets()));
  bench->add_flag("--json", bench_options.json, "for scripts");

  quern::TradeOptions trade_options;
  CLI::App* trade = add_trade(app, trade_options);

  quern::SweepOptions sweep_options;
  CLI::App* sweep = add_sweep(app, sweep_options);

  quern::ShapeCommand shape_options;
  CLI::App* shape = app.add_subcommand("shape", "what an STL file gives as a polyhedron");
  shape->add_option("file", shape_options.file, "FILE.stl")->required();
  shape->add_flag("--hull", shape_options.hull, "take the convex hull of what is no convex body");
  shape->add_option("--out", shape_options.out, "folder for the frame")->default_str("out/shapes");

  CLI::App* info = app.add_subcommand("info", "laws, pair types, fields, tallies, SIMD targets");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : 2;
  }
  if (run_until->count() + resume_until->count() > 0) options.until = until;
  if (run->parsed()) {
    if (options.out.empty()) {
      options.out = "out/" + std::filesystem::path(options.scene).stem().string();
    }
    return quern::run_command(options);
  }
  if (resume->parsed()) return quern::resume_command(options);
  if (report->parsed()) return quern::report_command(report_options);
  if (compare->parsed()) return quern::compare_command(report_options);
  if (check->parsed()) return quern::check_command(options);
  if (bench->parsed()) return quern::bench_command(bench_options);
  if (trade->parsed()) {
    if (trade_options.out.empty()) {
      trade_options.out = "out/trade/" + std::filesystem::path(trade_options.scene).stem().string();
    }
    return quern::trade_command(trade_options);
  }
  if (sweep->parsed()) {
    if (sweep_options.out.empty()) {
      sweep_options.out = "out/" + std::filesystem::path(sweep_options.file).stem().string();
    }
    return quern::sweep_command(sweep_options);
  }
  if (shape->parsed()) {
    if (shape_options.out.empty()) shape_options.out = "out/shapes";
    return quern::shape_command(shape_options);
  }
  if (info->parsed()) return quern::info_command();
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  // For tests: what must not happen in any lane ends the program at the spot.
  if (std::getenv("QUERN_TRAP_FP") != nullptr)
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  try {
    return dispatch(argc, argv);
  } catch (const quern::InputErrors& errors) {
    for (const std::string& line : errors.lines) std::fprintf(stderr, "%s\n", line.c_str());
    return 2;
  } catch (const quern::UserError& error) {
    quern::log_error(error.what());
    return 2;
  } catch (const quern::SystemError& error) {
    quern::log_error(error.what());
    return 3;
  } catch (const std::exception& error) {
    quern::log_error(error.what());
    return 1;
  }
}
