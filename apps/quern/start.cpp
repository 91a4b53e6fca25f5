#include "apps/quern/start.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <filesystem>

#include "apps/quern/recorder.h"
#include "io/log.h"
#include "io/scene_reader.h"
#include "kernels/contact.h"
#include "scheduler/exchange.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

template <class Real>
void warn_of_target(const CheckpointHeader& header) {
  const std::string target = choose_kernels<Real>().target;
  if (header.simd_target == target) return;
  log_warn(fmt::format("the run was computed with {} and goes on with {}: its bits will differ",
                       header.simd_target, target));
}

std::string start_path(const Scene& scene) {
  const fs::path path = fs::path(scene.folder) / scene.run.start_file;
  return fs::is_directory(path) ? usable_checkpoint(path.string()) : path.string();
}

template <class Real>
std::vector<const Facets*> bodies_of(const World<Real>& world) {
  std::vector<const Facets*> all;
  for (const Body& body : world.bodies) all.push_back(&body.facets);
  return all;
}

template <class Real>
void set_groups(World<Real>& world) {
  Particles<Real>& p = world.particles;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const std::uint64_t tag = p.traits[k].tag;
    p.traits[k].tag =
        make_tag(tag_material(tag), tag_contacts(tag), world.groups.of_species(p.species[k]));
  }
}

template <class Real>
void count_mass(World<Real>& world) {
  world.total_mass = 0;
  for (const Traits<Real>& traits : world.particles.traits) {
    world.total_mass += 1 / static_cast<double>(traits.inverse_mass);
  }
  for (const double inverse_mass : world.polyhedra.inverse_mass) {
    world.total_mass += 1 / inverse_mass;
  }
}

}  // namespace

bool is_filled(const Scene& scene) { return scene.run.start == StartKind::kFill; }

void return_large_blocks() {
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 20);
}

template <class Real>
Start<Real>::Start(LoadedScene from, const std::string& checkpoint, Say say)
    : loaded(std::move(from)), say_(say) {
  const Scene& scene = loaded.scene;
  SceneGeometry geometry = build_geometry(scene, loaded.meshes, loaded.seeds);
  const bool fills = checkpoint.empty() && is_filled(scene);
  const bool rains = is_filled(scene) && inserted_later(scene);
  const double fall = fills ? fill(geometry) : 0;
  std::vector<ParticleSeed> early;  // of a scene with rain: those there from the start
  double smallest = 1e300, mass = 0;
  for (const ParticleSeed& p : loaded.seeds) {
    if (rains && is_explicit(scene, p)) early.push_back(p);
    smallest = std::min(smallest, p.inner());
    mass += scene.materials[p.material].density * sphere_volume(p.radius);
  }
  world = make_world<Real>(scene, std::move(geometry), loaded.seeds, rains ? early : loaded.seeds,
                           std::move(loaded.shapes));
  if (fills) {
    world.clock.fall = fall;
  } else if (checkpoint.empty()) {
    start_from(start_path(scene));
  } else {
    world.total_mass = 0;  // older checkpoints have none; a sum in another order has other bits
    read_checkpoint(checkpoint, [&](StateVisitor& v) { world.visit(v); });
    if (!world.wear.fits()) throw UserError(checkpoint + ": its wear is of other cells");
    warn_of_target<Real>(read_checkpoint_header(checkpoint));
    if (world.total_mass == 0) count_mass(world);
  }
  if (!fills) set_groups(world);
  if (rains) {
    rain_ = std::make_unique<Rain>(scene, bodies_of(world), loaded.seeds);
    rain_->resume_after(world.clock.inserted);
  } else {
    std::vector<ParticleSeed>().swap(loaded.seeds);  // tens of megabytes in a large scene
  }
  plan = plan_phases(scene, loaded.dt, world.clock.fall, mass, smallest);
}

// Places the particles; returns how far the charge may fall.
template <class Real>
double Start<Real>::fill(SceneGeometry& geometry) {
  const Scene& scene = loaded.scene;
  const std::vector<const Facets*> walls = geometry.facets();
  const FillReport report = place_particles(scene, walls, loaded.seeds);
  include_fill(scene, report.low, report.high, geometry);
  if (inserted_later(scene)) {
    say_(fmt::format("{} particles rain in over {:g} s", loaded.seeds.size(), scene.fill.over));
    return (geometry.high - geometry.low).norm();
  }
  say_(fmt::format("placed {} particles in {:.1f} s, solid fraction {:.3f}", loaded.seeds.size(),
                   report.seconds, report.fraction));
  for (const std::string& line : check_overlaps(scene, walls, loaded.seeds)) log_warn(line);
  return report.height(scene.run.gravity);
}

template <class Real>
void Start<Real>::let_in() {
  if (!rain_ || world.clock.phase != 0 || rain_->waiting() == 0) return;
  constexpr std::uint64_t kEvery = 50;
  if (world.clock.step % kEvery != 0) return;
  const std::vector<std::size_t> in =
      rain_->insert(world.time() + 1e-9, room_taken(), loaded.seeds);
  if (in.empty()) return;
  std::vector<ParticleSeed> fresh;
  for (const std::size_t k : in) fresh.push_back(loaded.seeds[k]);
  append_particles(world, loaded.scene, fresh);
  world.clock.inserted = rain_->inserted();
}

// By the particles there are: each with the sphere around it.
template <class Real>
std::vector<PlacedSphere> Start<Real>::room_taken() const {
  std::vector<PlacedSphere> taken;
  for (const Record<Real>& r : world.particles.record) {
    taken.push_back({Vec3(r.x, r.y, r.z), static_cast<double>(r.radius)});
  }
  const Polyhedra<Real>& p = world.polyhedra;
  for (std::size_t k = 0; k < p.size(); ++k) {
    taken.push_back({p.place(k), world.shapes[p.shape[k]].bound_radius * p.scale[k]});
  }
  return taken;
}

// Another run's state becomes this run's start; where that run knew spheres only, those that this
// scene wants as polyhedra are exchanged.
template <class Real>
void Start<Real>::start_from(const std::string& path) {
  Scene& scene = loaded.scene;
  const CheckpointHeader header = read_checkpoint_header(path);
  if (header.precision != precision_name(scene)) {
    throw UserError(fmt::format(
        "run.start_file: '{}' holds a run of precision \"{}\", this scene asks for \"{}\"; set "
        "run.precision",
        path, header.precision, precision_name(scene)));
  }
  warn_of_target<Real>(header);
  const std::vector<ParticleSpec> there =
      parse_scene(header.scene_text, path, scene.folder, {}, StartFile::kReadBefore)
          .scene.particles;
  const Vec3 low = world.low, high = world.high;
  const bool exchange =
      !world.shapes.empty() && std::none_of(there.begin(), there.end(), has_polyhedra);
  std::vector<Shape> shapes;
  if (exchange) std::swap(shapes, world.shapes);  // without shapes a world reads no polyhedra
  read_checkpoint(path, [&](StateVisitor& v) { world.visit(v); });
  world.end_recording();
  if (exchange) {
    world = exchange_shapes(std::move(world), scene, loaded.seeds, std::move(shapes));
    scene.run.relax = scene.run.relax.value_or(kExchangeRelax);
    say_(fmt::format("{} spheres became polyhedra; they are relaxed for {:g} s",
                     world.polyhedra.size(), *scene.run.relax));
  } else {
    count_mass(world);
  }
  world.low = low;
  world.high = high;
  include_charge(scene, world);
  restart_clock();
}

// The clock and the account begin anew.
template <class Real>
void Start<Real>::restart_clock() {
  world.clock.step = 0;
  world.clock.phase = 0;
  world.clock.dt = loaded.dt;
  world.clock.list_stale = 1;
  world.clock.rebuilds = 0;
  world.clock.warnings = 0;
  world.capped_contacts = 0;
  world.polyhedra.fallbacks = Fallbacks();
  const std::optional<double> slack = loaded.scene.run.list_slack;
  world.clock.fixed_slack = slack ? 1 : 0;
  if (slack) world.clock.slack = *slack;
  world.ledger = Ledger();
  world.window = Window();
  world.wear.clear(world.walls.size(), loaded.scene.particles.size());
}

template <class Real>
std::string failure_text(const World<Real>& world, const StepReport& report,
                         const PhasePlan& phase) {
  const Offender& o = report.first;
  std::string what;
  if ((report.bits & kNotFinite) != 0) {
    what = "a number is not finite";
  } else if ((report.bits & kOutside) != 0) {
    what = "a particle has left the domain";
  } else if ((report.bits & kTooFast) != 0) {
    what = "a step moves a particle by more than its radius, too fast for the wall in its way";
  } else {
    what = fmt::format("an overlap reached {:.2f} of the smaller radius", report.max_overlap);
  }
  std::string partner;
  if (o.partner != kNoIndex && o.partner_is_wall) {
    partner = fmt::format(" against wall '{}'", world.walls[o.partner].name);
  } else if (o.partner != kNoIndex) {
    partner = fmt::format(" against particle {}", o.partner);
  }
  return fmt::format("{}: particle {} at ({:.6g}, {:.6g}, {:.6g}) m{}, {} t = {:.6g} s, step {}",
                     what, o.id, o.position[0], o.position[1], o.position[2], partner,
                     phase.kind == Phase::kRun ? "running at" : "settling at",
                     static_cast<double>(world.clock.step) * phase.dt, world.clock.step);
}

template class Start<float>;
template class Start<double>;
template std::string failure_text(const World<float>&, const StepReport&, const PhasePlan&);
template std::string failure_text(const World<double>&, const StepReport&, const PhasePlan&);

}  // namespace quern
