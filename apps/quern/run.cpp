// A run from the scene to its summary: phases of settling, then the mill. All state is in the
// World; this file decides when to record, to checkpoint and to stop.
#include "apps/quern/run.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <memory>

#include "apps/quern/load.h"
#include "apps/quern/recorder.h"
#include "io/checkpoint.h"
#include "io/file_commit.h"
#include "io/log.h"
#include "io/scene_reader.h"
#include "scheduler/exchange.h"
#include "scheduler/phases.h"
#include "scheduler/rain.h"
#include "scheduler/step.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

volatile std::sig_atomic_t g_signal = 0;

void on_signal(int signal) {
  g_signal = signal;
  std::signal(signal, SIG_DFL);  // a second one ends at once
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Real>
class Run {
 public:
  Run(LoadedScene loaded, const RunOptions& options, const std::string& checkpoint)
      : loaded_(std::move(loaded)), options_(options), started_(now()) {
    const Scene& scene = loaded_.scene;
    SceneGeometry geometry = build_geometry(scene, loaded_.meshes, loaded_.seeds);
    const bool fills = checkpoint.empty() && scene.run.start == StartKind::kFill;
    const bool rains = scene.run.start == StartKind::kFill && inserted_later(scene);
    double fall = 0;
    if (fills) {
      forget_old_run();
      fall = fill(geometry);
    }
    std::vector<ParticleSeed> early;  // of a scene with rain: those there from the start
    for (const ParticleSeed& p : loaded_.seeds) {
      if (rains && is_explicit(scene, p)) early.push_back(p);
      smallest_ = std::min(smallest_, p.inner());
      scene_mass_ += scene.materials[p.material].density * sphere_volume(p.radius);
    }
    world_ = make_world<Real>(scene, std::move(geometry), loaded_.seeds,
                              rains ? early : loaded_.seeds, std::move(loaded_.shapes));
    if (fills) {
      world_.clock.fall = fall;
    } else if (checkpoint.empty()) {
      start_from(start_path(scene));
      forget_old_run();
    } else {
      read_checkpoint(checkpoint, [&](StateVisitor& v) { world_.visit(v); });
      warn_of_target(read_checkpoint_header(checkpoint));
      count_mass();
    }
    if (rains) {
      rain_ = std::make_unique<Rain>(scene, bodies_of(world_), loaded_.seeds);
    } else {
      std::vector<ParticleSeed>().swap(loaded_.seeds);  // tens of megabytes in a large scene
    }
    if (rain_) rain_->resume_after(world_.clock.inserted);
    plan_ = plan_phases(scene, loaded_.dt, world_.clock.fall, scene_mass_, smallest_);
    stepper_ = std::make_unique<Stepper<Real>>(world_, options.threads);
    const bool resumed = !checkpoint.empty();
    const bool in_run = resumed && world_.clock.phase + 1 == plan_.size();
    recorder_ = std::make_unique<Recorder>(
        options.out, scene, loaded_.dt, world_.walls,
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
      if (run && row > 0 && world_.clock.step == 0) save(options_.out + "/settled");
      const bool stage = row > 0 && plan_[row].kind == plan_[row - 1].kind;
      if (world_.clock.step == 0 && !stage) save(options_.out);
      fine = run_phase(plan_[row]);
      if (g_signal != 0 || stopped_) break;
    }
    if (fine) save(options_.out);
    return finish(fine);
  }

 private:
  // What another run has left in the folder would be taken for this one's.
  void forget_old_run() const {
    for (const char* name : {"summary.json", "checkpoint.h5", "checkpoint.previous.h5"}) {
      std::error_code error;
      fs::remove(fs::path(options_.out) / name, error);
      if (error) {
        throw SystemError(
            fmt::format("cannot remove '{}/{}': {}", options_.out, name, error.message()));
      }
    }
  }

  static void warn_of_target(const CheckpointHeader& header) {
    const std::string target = choose_kernels<Real>().target;
    if (header.simd_target == target) return;
    log_warn(fmt::format("the run was computed with {}, this machine has {}: its bits will differ",
                         header.simd_target, target));
  }

  static std::string start_path(const Scene& scene) {
    const fs::path path = fs::path(scene.folder) / scene.run.start_file;
    return fs::is_directory(path) ? usable_checkpoint(path.string()) : path.string();
  }

  static std::vector<const Facets*> bodies_of(const World<Real>& world) {
    std::vector<const Facets*> all;
    for (const Body& body : world.bodies) all.push_back(&body.facets);
    return all;
  }

  // Places the particles; returns how far the charge may fall.
  double fill(SceneGeometry& geometry) {
    const Scene& scene = loaded_.scene;
    const std::vector<const Facets*> walls = geometry.facets();
    const FillReport report = place_particles(scene, walls, loaded_.seeds);
    include_fill(scene, report.low, report.high, geometry);
    if (inserted_later(scene)) {
      log_info(
          fmt::format("{} particles rain in over {:g} s", loaded_.seeds.size(), scene.fill.over));
      return (geometry.high - geometry.low).norm();
    }
    log_info(fmt::format("placed {} particles in {:.1f} s, solid fraction {:.3f}",
                         loaded_.seeds.size(), report.seconds, report.fraction));
    for (const std::string& line : check_overlaps(scene, walls, loaded_.seeds)) log_warn(line);
    return (report.high - report.low).maxCoeff();
  }

  // Rain: lets in what is due by now, in the first phase.
  void let_in() {
    if (!rain_ || world_.clock.phase != 0 || rain_->waiting() == 0) return;
    constexpr std::uint64_t kEvery = 50;
    if (world_.clock.step % kEvery != 0) return;
    const std::vector<std::size_t> in =
        rain_->insert(world_.time() + 1e-9, room_taken(), loaded_.seeds);
    if (in.empty()) return;
    std::vector<ParticleSeed> fresh;
    for (const std::size_t k : in) fresh.push_back(loaded_.seeds[k]);
    append_particles(world_, loaded_.scene, fresh);
    world_.clock.inserted = rain_->inserted();
  }

  // By the particles there are: each with the sphere around it.
  std::vector<PlacedSphere> room_taken() const {
    std::vector<PlacedSphere> taken;
    for (const Record<Real>& r : world_.particles.record) {
      taken.push_back({Vec3(r.x, r.y, r.z), static_cast<double>(r.radius)});
    }
    const Polyhedra<Real>& p = world_.polyhedra;
    for (std::size_t k = 0; k < p.size(); ++k) {
      taken.push_back({p.place(k), world_.shapes[p.shape[k]].bound_radius * p.scale[k]});
    }
    return taken;
  }

  void count_mass() {
    world_.total_mass = 0;
    for (const Traits<Real>& traits : world_.particles.traits) {
      world_.total_mass += 1 / static_cast<double>(traits.inverse_mass);
    }
    for (const double inverse_mass : world_.polyhedra.inverse_mass) {
      world_.total_mass += 1 / inverse_mass;
    }
  }

  // Another run's state becomes this run's start; where that run knew spheres only, those that this
  // scene wants as polyhedra are exchanged.
  void start_from(const std::string& path) {
    Scene& scene = loaded_.scene;
    const CheckpointHeader header = read_checkpoint_header(path);
    if (header.precision != precision_name(scene)) {
      throw UserError(fmt::format(
          "run.start_file: '{}' holds a run of precision \"{}\", this scene asks for \"{}\"; set "
          "run.precision",
          path, header.precision, precision_name(scene)));
    }
    warn_of_target(header);
    const std::vector<ParticleSpec> there =
        parse_scene(header.scene_text, path, scene.folder, {}, StartFile::kReadBefore)
            .scene.particles;
    const Vec3 low = world_.low, high = world_.high;
    const bool exchange =
        !world_.shapes.empty() && std::none_of(there.begin(), there.end(), has_polyhedra);
    std::vector<Shape> shapes;
    if (exchange) std::swap(shapes, world_.shapes);  // without shapes a world reads no polyhedra
    read_checkpoint(path, [&](StateVisitor& v) { world_.visit(v); });
    if (exchange) {
      world_ = exchange_shapes(std::move(world_), scene, loaded_.seeds, std::move(shapes));
      scene.run.relax = scene.run.relax.value_or(kExchangeRelax);
      log_info(fmt::format("{} spheres became polyhedra; they are relaxed for {:g} s",
                           world_.polyhedra.size(), *scene.run.relax));
    } else {
      count_mass();
    }
    world_.low = low;
    world_.high = high;
    include_charge(scene, world_);
    restart_clock();
  }

  // The clock and the account begin anew.
  void restart_clock() {
    world_.clock.step = 0;
    world_.clock.phase = 0;
    world_.clock.dt = loaded_.dt;
    world_.clock.list_stale = 1;
    world_.clock.rebuilds = 0;
    world_.clock.warnings = 0;
    world_.polyhedra.fallbacks = Fallbacks();
    const std::optional<double> slack = loaded_.scene.run.list_slack;
    world_.clock.fixed_slack = slack ? 1 : 0;
    if (slack) world_.clock.slack = *slack;
    world_.ledger = Ledger();
    world_.window = Window();
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
      let_in();
      const double before = now();
      const StepReport report = stepper_->step();
      if (run) {
        figures_.step_seconds += now() - before;
        ++figures_.run_steps;
      }
      if ((report.bits & kFatalBits) != 0) {
        figures_.error = failure(report, phase);
        log_error(figures_.error);
        return false;
      }
      if (run) recorder_->after_step(world_);
      if (g_signal != 0) break;
      if (world_.clock.step % 32 != 0) continue;
      if (progress_.due()) progress_.show(line(phase, phase_started, first_step));
      const double every = loaded_.scene.output.checkpoint_every;
      if (every > 0 && now() - last_checkpoint_ > every) save(options_.out);
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

  void save(const std::string& folder) {
    make_folder("results", folder);
    CheckpointHeader header;
    header.scene_text = scene_to_toml(loaded_.scene);
    header.scene_name = options_.scene;
    header.simd_target = stepper_->target();
    header.precision = precision_name(loaded_.scene);
    header.version = QUERN_VERSION;
    header.time = world_.time();
    header.step = world_.clock.step;
    if (recorder_) recorder_->keep();
    write_checkpoint(folder, header, [&](StateVisitor& v) { world_.visit(v); });
    last_checkpoint_ = now();
  }

  // What went wrong, where and when.
  std::string failure(const StepReport& report, const PhasePlan& phase) const {
    const Offender& o = report.first;
    std::string what;
    if ((report.bits & kNotFinite) != 0) {
      what = "a position or velocity is not finite";
    } else if ((report.bits & kOutside) != 0) {
      what = "a particle has left the domain";
    } else {
      what = fmt::format("an overlap reached {:.2f} of the smaller radius", report.max_overlap);
    }
    std::string partner;
    if (o.partner != kNoIndex && o.partner_is_wall) {
      partner = fmt::format(" against wall '{}'", world_.walls[o.partner].name);
    } else if (o.partner != kNoIndex) {
      partner = fmt::format(" against particle {}", o.partner);
    }
    return fmt::format(
        "{}: particle {} at ({:.6g}, {:.6g}, {:.6g}) m{}, {} t = {:.6g} s, step {}; the state "
        "before is in {}/checkpoint.h5",
        what, o.id, o.position[0], o.position[1], o.position[2], partner,
        phase.kind == Phase::kRun ? "running at" : "settling at",
        static_cast<double>(world_.clock.step) * phase.dt, world_.clock.step, options_.out);
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

  int finish(bool fine) {
    figures_.wall_seconds = now() - started_;
    figures_.times = stepper_->take_times();
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
    const Ledger& l = world_.ledger;
    if (std::isfinite(recorder_->recorded_power())) {
      log_info(fmt::format("power        {} (torque, energies and their errors in summary.json)",
                           format_power(recorder_->recorded_power())));
    } else {
      log_info(fmt::format("power        no row of the series yet; the record starts at t = {:g} s",
                           record_start(loaded_.scene)));
    }
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

  LoadedScene loaded_;
  RunOptions options_;
  double started_ = 0, last_checkpoint_ = 0;
  World<Real> world_;
  std::vector<PhasePlan> plan_;
  std::unique_ptr<Stepper<Real>> stepper_;
  std::unique_ptr<Recorder> recorder_;
  RunFigures figures_;
  Progress progress_;
  std::unique_ptr<Rain> rain_;
  double smallest_ = 1e300, scene_mass_ = 0;
  bool stopped_ = false;
};

// Rebuilds take and give back columns of many megabytes. Left to itself the allocator soon keeps
// such blocks, in pieces, and the run grows by half; above a megabyte each block is mapped and
// returned.
void return_large_blocks() {
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 20);
}

int start(LoadedScene loaded, const RunOptions& options, const std::string& checkpoint) {
  return_large_blocks();
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (loaded.scene.run.precision == Precision::kDouble) {
    return Run<double>(std::move(loaded), options, checkpoint).go();
  }
  return Run<float>(std::move(loaded), options, checkpoint).go();
}

}  // namespace

int run_command(const RunOptions& options) {
  LoadedScene loaded = load_scene(options.scene, options.overrides);
  judge_time_step(loaded);
  make_folder("results", options.out);
  write_text_file("scene", options.out + "/scene.toml", scene_to_toml(loaded.scene),
                  Durability::kKill);
  return start(std::move(loaded), options, "");
}

int resume_command(const RunOptions& options) {
  std::string warning;
  const std::string path = usable_checkpoint(options.out, &warning);
  if (!warning.empty()) log_warn(warning);
  const CheckpointHeader header = read_checkpoint_header(path);
  LoadedScene loaded = load_scene_text(header.scene_text, path, options.out);
  RunOptions with_scene = options;
  with_scene.scene = header.scene_name;
  return start(std::move(loaded), with_scene, path);
}

}  // namespace quern
