// A run from the scene to its summary: phases of settling, then the mill. All state is in the
// World; this file decides when to record, to checkpoint and to stop.
#include "apps/quern/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <memory>
#include <sstream>

#include "apps/quern/load.h"
#include "apps/quern/recorder.h"
#include "apps/quern/report.h"
#include "apps/quern/start.h"
#include "io/checkpoint.h"
#include "io/file_commit.h"
#include "io/log.h"
#include "io/scene_reader.h"
#include "scheduler/phases.h"
#include "scheduler/step.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

volatile std::sig_atomic_t g_signal = 0;
std::atomic<std::time_t> g_signal_times[NSIG];  // s, of the first of each
static_assert(std::atomic<std::time_t>::is_always_lock_free);

// A second one ends at once, from two seconds on. Within one it is the same told again: `timeout`
// signals its command and then the group that this is in. (Whole seconds are compared.)
void on_signal(int signal) {
  g_signal = signal;
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const std::time_t first = g_signal_times[signal];
  if (first == 0) g_signal_times[signal] = now.tv_sec;
  if (first == 0 || now.tv_sec - first < 2) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string scene_file(const std::string& folder) { return folder + "/scene.toml"; }

template <class Real>
class Run {
 public:
  Run(LoadedScene loaded, const RunOptions& options, const std::string& checkpoint)
      : options_(options),
        started_(now()),
        start_(start_of(std::move(loaded), options, checkpoint)),
        loaded_(start_->loaded),
        world_(start_->world),
        plan_(start_->plan) {
    const Scene& scene = loaded_.scene;
    stepper_ = std::make_unique<Stepper<Real>>(world_, options.threads);
    const bool resumed = !checkpoint.empty();
    const bool in_run = resumed && world_.clock.phase + 1 == plan_.size();
    recorder_ = std::make_unique<Recorder>(
        options.out, scene, loaded_.dt, world_.walls, world_.groups,
        in_run ? std::optional<double>(static_cast<double>(world_.clock.step) * world_.clock.dt)
               : std::nullopt);
  }

  int go() {
    last_checkpoint_ = now();
    bool fine = true;
    for (std::size_t row = world_.clock.phase; row < plan_.size() && fine; ++row) {
      const std::uint64_t warnings = world_.clock.warnings;
      enter_phase(world_, loaded_.scene, plan_, row);
      const bool run = row + 1 == plan_.size();
      if (world_.clock.warnings < warnings) {
        log_warn(deep_line(warnings) + " while settling: a larger 'run.soft_stiffness' helps");
      }
      if (run && row > 0 && world_.clock.step == 0) save(options_.out + "/settled", Tables::kLater);
      const bool stage = row > 0 && plan_[row].kind == plan_[row - 1].kind;
      if (world_.clock.step == 0 && !stage) save(options_.out, Tables::kLater);
      fine = run_phase(plan_[row]);
      const bool relaxed = row + 1 < plan_.size() && plan_[row].kind == Phase::kRelax &&
                           plan_[row + 1].kind != Phase::kRelax;
      if (fine && relaxed && world_.caps_spheres) log_info(capped_line());
      if (g_signal != 0 || stopped_) break;
    }
    if (fine) save(options_.out, Tables::kLater);
    return finish(fine);
  }

 private:
  static std::unique_ptr<Start<Real>> start_of(LoadedScene loaded, const RunOptions& options,
                                               const std::string& checkpoint) {
    const bool fresh = checkpoint.empty(), fills = is_filled(loaded.scene);
    if (fresh && fills) take_folder(options, loaded.scene);
    auto start = std::make_unique<Start<Real>>(std::move(loaded), checkpoint, log_info);
    if (fresh && !fills)
      take_folder(options, start->loaded.scene);  // it may have started from there
    return start;
  }

  // From now on the folder is this run's: one that is killed before its first checkpoint begins
  // anew from scene.toml.
  static void take_folder(const RunOptions& options, const Scene& scene) {
    forget_old_run(options);
    write_text_file("scene", scene_file(options.out), scene_to_toml(scene), Durability::kPowerCut);
  }

  // What another run has left in the folder would be taken for this one's.
  static void forget_old_run(const RunOptions& options) {
    for (const char* name :
         {"scene.toml", "summary.json", "report.html", "checkpoint.h5", "checkpoint.previous.h5"}) {
      std::error_code error;
      fs::remove(fs::path(options.out) / name, error);
      if (error) {
        throw SystemError(
            fmt::format("cannot remove '{}/{}': {}", options.out, name, error.message()));
      }
    }
  }

  bool run_phase(const PhasePlan& phase) {
    const bool run = phase.kind == Phase::kRun;
    if (run) stepper_->take_times();  // those of settling are not asked for
    const double phase_started = now();
    const std::uint64_t first_step = world_.clock.step;
    while (!phase_is_over(world_, phase)) {
      if (run && options_.until && world_.time() >= *options_.until - 0.5 * phase.dt) {
        stopped_ = true;
        break;
      }
      start_->let_in();
      if (run) recorder_->before_step(world_);
      const double before = now();
      const StepReport report = stepper_->step();
      if (run) {
        figures_.step_seconds += now() - before;
        ++figures_.run_steps;
      }
      if ((report.bits & kFatalBits) != 0) {
        figures_.error = fmt::format("{}; the state before is in {}/checkpoint.h5",
                                     failure_text(world_, report, phase), options_.out);
        log_error(figures_.error);
        return false;
      }
      if (run) recorder_->after_step(world_);
      if (g_signal != 0) break;
      if (world_.clock.step % 32 != 0) continue;
      if (progress_.due()) progress_.show(line(phase, phase_started, first_step));
      const double every = loaded_.scene.output.checkpoint_every;
      if (every > 0 && now() - last_checkpoint_ > every) save(options_.out, Tables::kSoFar);
    }
    if (run) progress_.finish(line(phase, phase_started, first_step));
    return true;
  }

  ProgressLine line(const PhasePlan& phase, double phase_started, std::uint64_t first_step) const {
    ProgressLine p;
    const bool run = phase.kind == Phase::kRun;
    p.settling = !run;
    p.time = static_cast<double>(world_.clock.step) * phase.dt;
    double until = static_cast<double>(phase.steps) * phase.dt;
    if (run && options_.until) until = std::min(until, *options_.until);
    p.until = until;
    const double taken = now() - phase_started;
    const double steps = static_cast<double>(world_.clock.step - first_step);
    const double n = static_cast<double>(world_.particles.size() + world_.polyhedra.size());
    p.rate = taken > 0 ? n * steps / taken : 0;
    p.contacts = world_.totals.pair_contacts + world_.totals.wall_contacts;
    p.max_overlap = world_.totals.max_overlap;
    if (run) {
      if (loaded_.scene.mill) {
        p.revolutions = schedule_integral(loaded_.scene.mill->rotation, p.time) / (2 * kPi);
      }
      p.power = recorder_->last_power();
      p.energy_error = ledger_error(world_.ledger);
    }
    p.elapsed = now() - started_;
    if (steps > 0)
      p.eta = taken / steps * (until / phase.dt - static_cast<double>(world_.clock.step));
    p.checkpoint_age = now() - last_checkpoint_;
    return p;
  }

  // What a report needs if the run is killed; renewed where that takes a twentieth of the time at
  // most.
  void write_tables_so_far() {
    constexpr double kShare = 0.05;
    const double began = now();
    if (plan_[world_.clock.phase].kind != Phase::kRun) return;
    if (began - tables_written_ < tables_cost_ / kShare) return;
    RunFigures figures = figures_;
    set_machine(figures);
    recorder_->write_summary(world_, figures);
    tables_written_ = now();
    tables_cost_ = tables_written_ - began;
  }

  enum class Tables { kSoFar, kLater };
  void save(const std::string& folder, Tables tables) {
    make_folder("results", folder);
    CheckpointHeader header;
    header.scene_text = scene_to_toml(loaded_.scene);
    header.scene_name = options_.scene;
    header.simd_target = stepper_->target();
    header.precision = precision_name(loaded_.scene);
    header.version = QUERN_VERSION;
    header.time = world_.time();
    header.step = world_.clock.step;
    if (tables == Tables::kSoFar) write_tables_so_far();
    if (recorder_) recorder_->keep();
    write_checkpoint(folder, header, [&](StateVisitor& v) { world_.visit(v); });
    last_checkpoint_ = now();
  }

  // Of the run phase: seconds of the clock, and what the threads did in the tasks.
  static std::string stages_line(const StageTimes& t) {
    double busy = 0;
    for (const double b : t.busy) busy += b;
    std::string parts;
    for (std::size_t k = 0; k < t.busy.size(); ++k) {
      if (!(t.busy[k] > 0)) continue;
      std::string name = kStageNames[k];
      std::replace(name.begin(), name.end(), '_', ' ');
      parts +=
          fmt::format("{}{} {:.0f} %", parts.empty() ? " (" : ", ", name, 100 * t.busy[k] / busy);
    }
    if (!parts.empty()) parts += ")";
    return fmt::format("rebuild {:.1f} s ({} times), tasks {:.1f} s{}, totals {:.1f} s", t.rebuild,
                       t.rebuilds, t.tasks, parts, t.totals);
  }

  static std::string deep_line(std::uint64_t warnings) {
    return fmt::format("{} contacts were deeper than half the smaller radius (summed over steps)",
                       warnings);
  }

  std::string capped_line() const {
    return fmt::format(
        "relaxed: {:.0f} contacts are deeper than 'overlap_cap', the deepest {:.2g} of the smaller "
        "radius; {} were pushed at the cap (summed over steps)",
        world_.totals.warnings, world_.totals.max_overlap, world_.capped_contacts);
  }

  static std::string fallbacks_line(const Fallbacks& f) {
    std::string parts;
    const auto add = [&](std::uint64_t count, const char* what) {
      if (count > 0) parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", count, what);
    };
    add(f.contained, "of a body within another");
    add(f.bounded, "cut short by a limit of the narrow phase");
    add(f.wall_depth, "deeper in a wall than it is taken to be thick");
    return "contacts of polyhedra with a force that is not what it should be: " + parts +
           " (summed over steps)";
  }

  void set_machine(RunFigures& figures) const {
    figures.wall_seconds = now() - started_;
    figures.threads = stepper_->graph().threads();
    figures.simd_target = stepper_->target();
  }

  int finish(bool fine) {
    figures_.wall_seconds = now() - started_;
    figures_.times = stepper_->take_times();
    figures_.steps_per_contact = fewest_steps_per_contact(loaded_);
    figures_.threads = stepper_->graph().threads();
    figures_.simd_target = stepper_->target();
    figures_.finished = fine && g_signal == 0 && !stopped_;
    if (world_.clock.warnings > 0) log_warn(deep_line(world_.clock.warnings));
    if (world_.polyhedra.fallbacks.any()) log_warn(fallbacks_line(world_.polyhedra.fallbacks));
    recorder_->write_summary(world_, figures_);
    if (!fine) return 4;
    if (g_signal != 0) {
      log_info(fmt::format("stopped by signal {} at t = {:.6g} s; go on with: quern resume {}",
                           static_cast<int>(g_signal), world_.time(), options_.out));
      return 0;
    }
    if (recorder_->charge()) log_info("charge       " + recorder_->charge()->line());
    const WindowLines& window = recorder_->window_lines();
    if (!window.warning.empty()) log_warn(window.warning);
    log_info("steadiness   " + window.steady);
    if (!recorder_->wear_line().empty()) log_info("wear         " + recorder_->wear_line());
    const Ledger& l = world_.ledger;
    if (std::isfinite(recorder_->recorded_power())) {
      log_info(fmt::format("power        {} (torque, energies and their errors in summary.json)",
                           format_power(recorder_->recorded_power())));
    } else {
      log_info(fmt::format("power        no row of the series yet; the record starts at t = {:g} s",
                           record_start(loaded_.scene)));
    }
    if (!window.formulas.empty()) log_info("formulas     " + window.formulas);
    log_info(fmt::format(
        "energy       walls {:.4g} J + gravity {:.4g} J = dissipated {:.4g} J + stored {:.4g} J; "
        "error {:.1e}, numerical loss {:.1e}",
        l.wall_work, l.gravity_work, l.dissipated(),
        l.kinetic + l.elastic - l.start_kinetic - l.start_elastic, ledger_error(l),
        numerical_loss_share(l)));
    if (figures_.step_seconds > 0) {
      log_info(fmt::format("speed        {:.3g} particle steps per second, {} threads, {}",
                           static_cast<double>(world_.particles.size() + world_.polyhedra.size()) *
                               static_cast<double>(figures_.run_steps) / figures_.step_seconds,
                           figures_.threads, figures_.simd_target));
    }
    log_info("stages       " + stages_line(figures_.times));
    log_info(
        fmt::format("results      {}", fs::absolute(options_.out).lexically_normal().string()));
    return 0;
  }

  RunOptions options_;
  double started_ = 0, last_checkpoint_ = 0;
  double tables_written_ = 0, tables_cost_ = 0;  // s
  std::unique_ptr<Start<Real>> start_;
  const LoadedScene& loaded_;
  World<Real>& world_;
  const std::vector<PhasePlan>& plan_;
  std::unique_ptr<Stepper<Real>> stepper_;
  std::unique_ptr<Recorder> recorder_;
  RunFigures figures_;
  Progress progress_;
  bool stopped_ = false;
};

// The page is made once all files are closed.
int start(LoadedScene loaded, const RunOptions& options, const std::string& checkpoint) {
  return_large_blocks();
  // SIGUSR1: batch systems send it ahead of a time limit.
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, on_signal);
  const int code = loaded.scene.run.precision == Precision::kDouble
                       ? Run<double>(std::move(loaded), options, checkpoint).go()
                       : Run<float>(std::move(loaded), options, checkpoint).go();
  write_report_of_run(options.out);
  return code;
}

// As it is written, whatever version wrote the text.
std::string defaults_filled(const std::string& text, const std::string& name,
                            const std::string& folder) {
  const SceneResult result = parse_scene(text, name, folder, {}, StartFile::kReadBefore);
  if (!result.errors.empty()) throw InputErrors{result.errors};
  return scene_to_toml(result.scene);
}

// The folder's scene.toml is that of the run whose checkpoint lies there, unless somebody changed
// one.
void refuse_another_scene(const std::string& folder, const std::string& checkpoint,
                          const std::string& text) {
  const std::string file = scene_file(folder);
  std::istringstream there(defaults_filled(read_text_file("scene", file), file, folder)),
      here(defaults_filled(text, checkpoint, folder));
  std::string wanted, found;
  while (wanted == found && (there || here)) {
    if (!std::getline(there, wanted)) wanted.clear();
    if (!std::getline(here, found)) found.clear();
  }
  if (wanted == found) return;
  throw UserError(
      fmt::format("'{}' is a checkpoint of another scene than '{}': `{}` there, `{}` here",
                  checkpoint, file, found, wanted));
}

}  // namespace

int run_command(const RunOptions& options) {
  LoadedScene loaded = load_scene(options.scene, options.overrides);
  judge_time_step(loaded);
  make_folder("results", options.out);
  return start(std::move(loaded), options, "");
}

int resume_command(const RunOptions& options) {
  const std::string scene = scene_file(options.out);
  if (!has_checkpoint(options.out) && fs::exists(scene)) {
    log_info("no checkpoint yet: the run begins anew");
    RunOptions anew = options;
    anew.scene = scene;
    return start(load_scene(scene, {}), anew, "");
  }
  std::string warning;
  const std::string path = usable_checkpoint(options.out, &warning);
  if (!warning.empty()) log_warn(warning);
  const CheckpointHeader header = read_checkpoint_header(path);
  if (fs::exists(scene)) refuse_another_scene(options.out, path, header.scene_text);
  LoadedScene loaded = load_scene_text(header.scene_text, path, options.out);
  RunOptions with_scene = options;
  with_scene.scene = header.scene_name;
  return start(std::move(loaded), with_scene, path);
}

}  // namespace quern
