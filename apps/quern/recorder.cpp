#include "apps/quern/recorder.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "apps/quern/wear_recorder.h"
#include "io/scene_reader.h"
#include "io/statistics.h"
#include "kernels/contact.h"
#include "scheduler/contact_frame.h"
#include "scheduler/phases.h"
#include "scheduler/snapshot.h"
#include "scheduler/wear_frame.h"
#include "soa/hash.h"

namespace quern {

namespace {

bool any_polyhedra(const Scene& scene) {
  return std::any_of(scene.particles.begin(), scene.particles.end(),
                     [](const ParticleSpec& species) { return has_polyhedra(species); });
}

std::vector<Quantity> series_quantities(const std::vector<TallyRow>& tallies,
                                        const std::vector<Wall>& walls,
                                        const std::optional<CollisionRecorder>& collisions) {
  std::vector<Quantity> all;
  for (const TallyRow& row : tallies) all.push_back(row.quantity);
  for (const Wall& wall : walls) {
    for (const char* axis : {"x", "y", "z"}) {
      all.push_back({fmt::format("walls/{}/force_{}", wall.name, axis), "N",
                     "of the charge on the wall, last step"});
    }
    for (const char* axis : {"x", "y", "z"}) {
      all.push_back({fmt::format("walls/{}/torque_{}", wall.name, axis), "N m",
                     "of the charge on the wall about its motion's centre, last step"});
    }
    all.push_back({fmt::format("walls/{}/power", wall.name), "W",
                   "work of the wall on the charge per time, last step"});
  }
  if (collisions) {
    const std::vector<Quantity> by_kind = collisions->quantities();
    all.insert(all.end(), by_kind.begin(), by_kind.end());
  }
  return all;
}

template <class Real>
TallyInput tally_input(const World<Real>& world) {
  TallyInput in;
  in.time = world.time();
  in.mass = world.total_mass;
  in.particles = static_cast<double>(world.bodies_of_charge());
  in.gravity = world.gravity;
  in.window = &world.window;
  in.totals = &world.totals;
  in.ledger = &world.ledger;
  return in;
}

std::uint64_t steps_in(double time, double dt) {
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(time / dt)));
}

std::uint64_t run_steps(const Scene& scene, double dt) {
  return plan_phases(scene, dt, 1, 1, 1).back().steps;
}

double run_duration(const Scene& scene, double dt) {
  return static_cast<double>(run_steps(scene, dt)) * dt;
}

double time_of_revolution(Scene scene, double revolutions) {
  scene.run.duration.reset();
  scene.run.revolutions = revolutions;
  constexpr double kFine = 1e-9;
  return run_duration(scene, kFine);
}

const char* target_name(const Scene& scene) {
  return scene.run.precision == Precision::kDouble ? choose_kernels<double>().target
                                                   : choose_kernels<float>().target;
}

std::string host_name() {
  char name[256] = "unknown";
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace

double record_start(const Scene& scene) {
  if (scene.run.record_from) return *scene.run.record_from;
  if (scene.run.record_from_revolution) {
    return time_of_revolution(scene, *scene.run.record_from_revolution);
  }
  return 0;
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

const char* precision_name(const Scene& scene) { return word_of(scene.run.precision); }

Recorder::Recorder(const std::string& folder, const Scene& scene, double dt,
                   const std::vector<Wall>& walls, const Groups& groups,
                   std::optional<double> resumed_at)
    : folder_(folder),
      scene_(scene),
      record_from_(record_start(scene)),
      tallies_(tally_rows_of(any_polyhedra(scene))),
      collisions_(scene.record.collisions ? std::optional<CollisionRecorder>(groups)
                                          : std::nullopt),
      first_step_(static_cast<std::uint64_t>(std::llround(record_from_ / dt))),
      series_(folder + "/run.h5", series_quantities(tallies_, walls, collisions_),
              resumed_at ? SeriesMode::kAppend : SeriesMode::kNew),
      blocks_(first_step_, run_steps(scene, dt)) {
  const double every =
      scene.output.series_every > 0 ? scene.output.series_every : run_duration(scene, dt) / 1000;
  series_steps_ = steps_in(every, dt);
  if (scene.output.frames_every > 0) {
    frame_steps_ = steps_in(scene.output.frames_every, dt);
    frames_.emplace(folder + "/frames");
  }
  if (scene.record.charge_shape || ClassRecorder::asked(scene)) {
    snapshots_.emplace(scene, dt, first_step_, run_steps(scene, dt));
    if (scene.record.charge_shape) charge_.emplace(scene, *snapshots_);
    if (ClassRecorder::asked(scene)) classes_.emplace(scene, *snapshots_);
  }
  if (resumed_at) {
    series_.truncate_after(*resumed_at + 0.5 * dt);
  } else {
    series_.text("scene", scene_to_toml(scene));
    series_.provenance("version", QUERN_VERSION);
    series_.provenance("commit", QUERN_COMMIT);
    series_.provenance("machine", host_name());
    series_.provenance("simd_target", target_name(scene));
    series_.provenance("precision", precision_name(scene));
  }
}

template <class Real>
void Recorder::after_step(World<Real>& world) {
  const std::uint64_t step = world.clock.step;
  if (step % series_steps_ == 0) {
    const TallyInput in = tally_input(world);
    std::vector<double> row;
    for (const TallyRow& tally : tallies_) row.push_back(tally.value(in));
    for (const WallTotal& wall : world.wall_totals) {
      row.insert(row.end(), wall.force.begin(), wall.force.end());
      row.insert(row.end(), wall.torque.begin(), wall.torque.end());
      row.push_back(wall.work / world.clock.dt);
    }
    if (collisions_) collisions_->append(world.collisions, row);
    series_.append(row);
    const double steps = std::max(world.window.steps, 1.0);
    last_power_ = world.window.power / steps;
    world.window = Window();
  }
  if (frame_steps_ > 0 && step % frame_steps_ == 0) {
    frames_->write(static_cast<int>(step / frame_steps_), particle_frame(world),
                   world.wear.asked() ? wear_frame(world, scene_) : wall_frame(world),
                   polyhedron_frame(world),
                   scene_.output.contacts ? std::optional(contact_frame(world)) : std::nullopt);
  }
  if (snapshots_ && snapshots_->due(step)) take_snapshots(world);
  if (blocks_.due(step)) blocks_.write(world, series_);
}

template <class Real>
void Recorder::take_snapshots(const World<Real>& world) {
  const ParticleFrame frame = particle_frame(world);
  if (charge_) charge_->take(world.clock.step, frame, series_);
  if (classes_) classes_->take(world.clock.step, frame, energy_frame(world), series_);
}

template <class Real>
void Recorder::write_summary(World<Real>& world, const RunFigures& figures) {
  Summary s;
  const double n = static_cast<double>(world.bodies_of_charge());
  const std::vector<double> time = series_.read("time");
  const auto first = static_cast<std::size_t>(
      std::upper_bound(time.begin(), time.end(), record_from_ + 1e-9) - time.begin());
  const auto recorded = [&](const char* name) {
    const std::vector<double> all = series_.read(name);
    return block_mean(std::span(all).subspan(std::min(first, all.size())));
  };
  s.set("particles", world.bodies_of_charge());
  s.set("spheres", world.particles.size());
  s.set("polyhedra", world.polyhedra.size());
  s.set("steps", world.clock.step);
  s.set("time_s", world.wall_time());
  s.set("finished", figures.finished);
  if (!figures.error.empty()) s.set("error", figures.error);
  s.set("wall_s", figures.wall_seconds);
  s.set("particle_steps_per_s",
        figures.step_seconds > 0 ? n * static_cast<double>(figures.run_steps) / figures.step_seconds
                                 : 0.0);
  s.set("rebuild_s", figures.times.rebuild);
  for (std::size_t k = 0; k < kStageNames.size(); ++k) {
    const double busy = figures.times.busy[k];
    if (busy > 0) s.set(fmt::format("{}_busy_s", kStageNames[k]), busy);
  }
  s.set("recorded_from_s", record_from_);
  s.set("recorded_samples", time.size() - std::min(first, time.size()));
  recorded_power_ = recorded("power").mean;
  s.set_mean("power_W", recorded("power"));
  s.set_mean("torque_Nm", recorded("torque"));
  s.set_mean("kinetic_energy_J", recorded("kinetic_energy"));
  s.set_mean("rotational_energy_J", recorded("rotational_energy"));
  s.set_mean("elastic_energy_J", recorded("elastic_energy"));
  s.set_mean("potential_energy_J", recorded("potential_energy"));
  s.set_mean("contacts_per_particle", recorded("contacts_per_particle"));
  if (!world.shapes.empty()) {
    for (const char* name :
         {"polyhedron_sphere_contacts", "polyhedron_pair_contacts", "polyhedron_wall_contacts"}) {
      s.set_mean(name, recorded(name));
    }
  }
  for (const char* axis : {"x", "y", "z"}) {
    s.set_mean(fmt::format("center_of_mass_{}_m", axis),
               recorded(fmt::format("center_of_mass_{}", axis).c_str()));
  }
  s.set_array("center_of_mass_m",
              {recorded("center_of_mass_x").mean, recorded("center_of_mass_y").mean,
               recorded("center_of_mass_z").mean});
  const Ledger& l = world.ledger;
  s.set("wall_work_J", l.wall_work);
  s.set("gravity_work_J", l.gravity_work);
  s.set("dissipation_J", l.dissipated());
  s.set("dissipation_normal_J", l.normal_damping());
  s.set("dissipation_sliding_J", l.slide);
  s.set("dissipation_tangential_J", l.tangential_damping);
  if (!world.shapes.empty() || world.force_law == ForceLaw::kHertzMindlin) {
    s.set("model_work_J", l.model_work);
    s.set("model_work_share", model_work_share(l));
  }
  s.set("stored_energy_change_J", l.kinetic + l.elastic - l.start_kinetic - l.start_elastic);
  s.set("steps_per_contact", figures.steps_per_contact);
  s.set("ledger_error", ledger_error(l));
  s.set("numerical_loss", numerical_loss_share(l));
  if (collisions_) collisions_->write(world, record_from_, series_, s);
  s.set("overlap_warnings", world.clock.warnings);
  if (scene_.run.overlap_cap) s.set("capped_contacts", world.capped_contacts);
  if (!world.shapes.empty()) {
    s.set("contained_warnings", world.polyhedra.fallbacks.contained);
    s.set("bounded_warnings", world.polyhedra.fallbacks.bounded);
    s.set("wall_depth_warnings", world.polyhedra.fallbacks.wall_depth);
  }
  s.set("rebuilds", world.clock.rebuilds);
  s.set("list_slack_m", world.clock.slack);
  s.set("listed_pairs_per_particle", static_cast<double>(world.pairs.slots()) / n);
  s.set("total_mass_kg", world.total_mass);
  s.set("state_hash", fmt::format("{:016x}", state_hash(world)));
  s.set("peak_memory_B", peak_memory());
  const ParticleFrame f = particle_frame(world);
  window_lines_ =
      report_window(scene_, {record_from_, world.time(), first}, f, world.total_mass, series_, s);
  if (classes_) classes_->finish(world.clock.step, series_);
  if (charge_) {
    charge_->set_liner(world.collisions.liner);
    charge_->finish(world.clock.step, f, series_, s);
    charge_->write_picture(folder_ + "/charge_shape.svg");
  }
  if (world.wear.asked()) wear_line_ = write_wear(world, scene_, series_, s);
  s.set("threads", figures.threads);
  s.set("simd_target", figures.simd_target);
  s.set("precision", precision_name(scene_));
  s.set("seed", scene_.run.seed);
  s.set("version", QUERN_VERSION);
  s.set("commit", QUERN_COMMIT);
  s.write(folder_ + "/summary.json");
  series_.provenance("threads", std::to_string(figures.threads));
  write_tables(world, f);
}

template <class Real>
void Recorder::write_tables(const World<Real>& world, const ParticleFrame& f) {
  const std::vector<TableColumn> columns = {
      table_column<double>({"position", "m", "centre of mass"}, f.position, 3),
      table_column<float>({"velocity", "m/s", "half-step velocity"}, f.velocity, 3),
      table_column<float>({"spin", "rad/s", "half-step spin"}, f.spin, 3),
      table_column<float>({"radius", "m", "radius; of a polyhedron: of the sphere of its volume"},
                          f.radius),
      table_column<std::uint32_t>({"id", "1", "identity"}, f.id),
      table_column<std::uint16_t>({"species", "1", "row of [[particles]]"}, f.species),
      table_column<std::uint16_t>({"class", "1", "size class, counted over all species"},
                                  f.size_class),
      table_column<std::uint16_t>({"contacts", "1", "touching partners, walls included"},
                                  f.contacts)};
  series_.write_table("final_particles", columns);
  const std::optional<PolyhedronFrame> p = polyhedron_frame(world);
  if (!p) return;
  const std::span<const std::uint32_t> id = std::span(f.id).subspan(f.spheres);
  const TableColumn polyhedra[] = {
      table_column<std::uint32_t>({"id", "1", "identity"}, id),
      table_column<std::uint32_t>({"shape", "1", "row of /shapes"}, p->shape),
      table_column<double>({"orientation", "1", "quaternion w x y z, body to world"},
                           p->orientation, 4)};
  series_.write_table("final_polyhedra", polyhedra);
  for (std::size_t k = 0; k < world.shapes.size(); ++k) {
    const SurfaceFrame surface = shape_surface(world.shapes[k]);
    const TableColumn columns_of_shape[] = {
        table_column<double>({"vertex", "1", "body frame, over the equivalent radius"},
                             surface.vertex, 3),
        table_column<std::uint32_t>({"triangle", "1", "rows of vertex, counterclockwise"},
                                    surface.triangle, 3),
        table_column<std::uint16_t>({"face", "1", "of each triangle"}, surface.face)};
    series_.write_table(fmt::format("shapes/{}", k), columns_of_shape);
    series_.text(fmt::format("shapes/{}/name", k), world.shapes[k].name);
  }
}

template void Recorder::after_step(World<float>&);
template void Recorder::after_step(World<double>&);
template void Recorder::write_summary(World<float>&, const RunFigures&);
template void Recorder::write_summary(World<double>&, const RunFigures&);

}  // namespace quern
