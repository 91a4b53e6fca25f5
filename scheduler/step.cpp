#include "scheduler/step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/wall_collisions.h"
#include "scheduler/grid_places.h"
#include "scheduler/not_finite.h"
#include "scheduler/totals.h"

namespace quern {

namespace {

template <class Real, class Columns>
LawTable<Real> table_of(const Columns& law, Index materials, ForceLaw kind) {
  return {law.normal_stiffness.data(),
          law.tangential_stiffness.data(),
          law.normal_damping.data(),
          law.tangential_damping.data(),
          law.sliding_friction.data(),
          law.rolling_friction.data(),
          materials,
          kind};
}

}  // namespace

template <class Real>
Stepper<Real>::Stepper(World<Real>& world, int threads)
    : world_(world),
      graph_(threads),
      kernels_(choose_kernels<Real>(world.force_law, world.precision)) {
  workers_.resize(static_cast<std::size_t>(graph_.threads()));
  for (Worker& w : workers_) w.rows.reset((world.tile_size + 16u) * kRowWidth);
}

// Law tables and constants may have changed between steps (phases of settling): cheap, done always.
template <class Real>
void Stepper<Real>::prepare() {
  const auto fill = [&](auto& c) {
    c.dt = world_.clock.dt;
    c.clamped = world_.clamped;
    c.rolling = world_.rolling;
    c.damped = world_.damped;
    // Of pairs; contacts with walls are followed if anything is asked.
    c.recording = world_.collisions_asked.kinds ? world_.collisions.recording : Recording::kOff;
    c.groups = static_cast<Index>(world_.groups.of_particles());
    c.wears = world_.wear.records();
    c.wear_absolute = world_.wear.velocity == WearVelocity::kAbsolute;
    c.finnie_force_ratio = world_.wear.finnie_force_ratio;
    c.nearest2 = HUGE_VAL;
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      c.period[a] = world_.periodic[a] ? world_.high[e] - world_.low[e] : 0;
      c.inverse_period[a] = world_.periodic[a] ? 1 / c.period[a] : 0;
      if (world_.periodic[a]) c.nearest2 = std::min(c.nearest2, 0.25 * c.period[a] * c.period[a]);
    }
  };
  fill(constants_);
  fill(wall_constants_);
  if (world_.caps_spheres) {
    constants_.overlap_cap = wall_constants_.overlap_cap = world_.overlap_cap;
  }
  constants_.law = table_of<Real>(world_.law, world_.materials, world_.force_law);
  wall_constants_.law = table_of<double>(world_.wall_law, world_.materials, world_.force_law);
  tile_totals_.resize(world_.tiles());
  tile_walls_.resize(world_.tiles() * world_.walls.size());
  known_touches_.resize(world_.tiles());
  if (world_.wear.records()) tile_wear_.resize(world_.tiles());
  if (world_.collisions.on()) tile_collisions_.resize(world_.tiles());
  world_.wall_totals.resize(world_.walls.size());
}

// What the motion kernel goes on with until particles are put into another order.
template <class Real>
void Stepper<Real>::place_on_grid() {
  if (world_.precision != Precision::kSingle) return;
  constants_.grid = {world_.low, world_.high, world_.periodic, world_.largest_radius};
  quern::place_on_grid(world_, constants_.grid, graph_, on_grid_);
  on_grid_next_.reset(on_grid_.size());
}

template <class Real>
void Stepper<Real>::move_walls() {
  for (Body& body : world_.bodies) {
    body.pose = pose_at(body.motion, world_.wall_time());
    body.velocity = WallVelocity();
    if (world_.moving_walls) {
      body.velocity = velocity_over(body.motion, world_.wall_time(), world_.clock.dt);
    }
  }
}

template <class Real>
void Stepper<Real>::run_walls(std::size_t tile, Worker& worker, const TileRows& rows,
                              CollisionTally* collisions) {
  TileWalls& walls = world_.tile_walls[tile];
  const std::span<WallTotal> totals(tile_walls_.data() + tile * world_.walls.size(),
                                    world_.walls.size());
  std::fill(totals.begin(), totals.end(), WallTotal());
  const bool wears = world_.wear.records();
  if (wears) tile_wear_[tile].entries.clear();
  const std::size_t entries = walls.candidates.particle.size();
  std::vector<KnownTouch>& known = known_touches_[tile];
  const bool fresh_lists = world_.clock.list_step == world_.clock.total_steps;
  if (fresh_lists || known.size() != entries) known.assign(entries, KnownTouch());
  if (entries == 0 && walls.springs.empty()) return;
  collect_wall_contacts(world_, tile, known, worker.lanes);
  if (worker.lanes.size() == 0) return;
  const WallContacts contacts = worker.lanes.view(rows.first);
  for (const Episode& e : walls.episodes) __builtin_prefetch(&e);
  const Particles<Real>& p = world_.particles;
  kernels_.walls(wall_constants_, {p.record.data(), p.traits.data()}, contacts, rows,
                 tile_totals_[tile].walls);
  note_odd_wall(tile);
  if (wears) list_wear(world_, contacts, worker.lanes, tile_wear_[tile]);
  if (collisions != nullptr) {
    record_wall_contacts(world_, contacts, worker.lanes, walls, *collisions);
  }
  return_wall_contacts(contacts, worker.lanes, world_.walls, world_.bodies, walls, totals);
}

template <class Real>
void Stepper<Real>::run_tile(std::size_t tile, int worker) {
  Particles<Real>& p = world_.particles;
  Worker& w = workers_[static_cast<std::size_t>(worker)];
  const std::size_t first = tile * world_.tile_size;
  const std::size_t size = std::min<std::size_t>(world_.tile_size, p.size() - first);
  const TileRows rows = {w.rows.data(), static_cast<Index>(first), static_cast<Index>(size)};
  std::fill_n(w.rows.data(), (size + 16) * kRowWidth, 0.0);
  TileTotals& totals = tile_totals_[tile];
  totals = TileTotals();
  Stopwatch watch;

  CollisionTally* collisions = nullptr;
  if (world_.collisions.on()) {
    collisions = &tile_collisions_[tile];
    collisions->reset(world_.groups, liner_time(world_.clock.total_steps, world_.clock.dt));
  }
  run_walls(tile, w, rows, collisions);
  w.times.add(Stage::kSphereWalls, watch);

  if (!world_.collisions_asked.kinds) collisions = nullptr;
  push_tile_pairs(kernels_, constants_, {p.record.data(), p.traits.data(), on_grid_.data()},
                  world_.pairs, tile, rows, w.pairs, totals.pairs, collisions);
  w.times.add(Stage::kSpherePairs, watch);
  if (bodies_) {
    const double spheres = totals.pairs.contacts;
    bodies_->run_tile(tile, worker, rows, totals.pairs, collisions);
    totals.near_bodies = totals.pairs.contacts - spheres;
    w.times.add(Stage::kPolyhedronSpheres, watch);
  }

  MoveView<Real> m{};
  m.now = p.record.data();
  m.next = p.record_next.data();
  m.traits_now = p.traits.data();
  m.traits_next = p.traits_next.data();
  m.on_grid_next = on_grid_next_.data();
  m.grid = &constants_.grid;
  Column<double>* spin[3] = {&p.spin_x, &p.spin_y, &p.spin_z};
  Column<float>* rest[3] = {&p.rest_x, &p.rest_y, &p.rest_z};
  Column<double>* place[3] = {&p.list_x, &p.list_y, &p.list_z};
  Column<float>* velocity[3] = {&p.list_vx, &p.list_vy, &p.list_vz};
  for (int a = 0; a < 3; ++a) {
    m.spin[a] = spin[a]->data();
    m.rest[a] = rest[a]->data();
    m.list_place[a] = place[a]->data();
    m.list_velocity[a] = velocity[a]->data();
    m.gravity[a] = world_.gravity[a];
    const bool periodic = world_.periodic[static_cast<std::size_t>(a)];
    m.low[a] = periodic ? -1e30 : world_.low[a];
    m.high[a] = periodic ? 1e30 : world_.high[a];
  }
  m.list_allowance = p.list_allowance.data();
  const Clock& clock = world_.clock;
  m.list_time = static_cast<double>(clock.total_steps + 1 - clock.list_step) * clock.dt;
  m.drag = world_.drag;
  m.kick = clock.first_kick != 0 ? 0.5 * clock.dt : clock.dt;
  kernels_.move(m, rows, clock.dt, totals.move);
  note_odd_pair(tile, w);
  w.times.add(Stage::kMotion, watch);
}

// While what the tile's contacts remembered is still at hand.
template <class Real>
void Stepper<Real>::note_odd_pair(std::size_t tile, const Worker& worker) {
  TileTotals& t = tile_totals_[tile];
  if (std::isfinite(t.pairs.work + t.pairs.elastic + t.move.translational + t.move.rotational)) {
    return;
  }
  const auto odd = find_odd_history(worker.pairs, world_.pairs.law_history());
  if (!odd || t.odd.id != kNoIndex) return;
  const auto [i, j] = *odd;
  const Particles<Real>& p = world_.particles;
  t.odd = {p.id[i], p.id[j], false, {p.record[i].x, p.record[i].y, p.record[i].z}, 0};
}

template <class Real>
void Stepper<Real>::note_odd_wall(std::size_t tile) {
  TileTotals& t = tile_totals_[tile];
  if (std::isfinite(t.walls.work + t.walls.elastic)) return;
  for (const WallSpring& s : world_.tile_walls[tile].springs) {
    const Vec3 numbers = s.spring + s.force + s.normal + s.point + s.moment;
    if (numbers.allFinite() && std::isfinite(s.overlap)) continue;
    const Record<Real>& r = world_.particles.record[s.particle];
    t.odd = {world_.particles.id[s.particle], s.wall, true, {r.x, r.y, r.z}, 0};
    return;
  }
}

// Stretches of bodies are dear and come first; bodies move when all forces on them are known.
template <class Real>
void Stepper<Real>::run_tasks(bool rebuilt) {
  if (!bodies_ && !world_.polyhedra.empty()) bodies_.emplace(world_, kernels_, graph_.threads());
  if (bodies_) bodies_->prepare(wall_constants_, rebuilt);
  const std::size_t stretches = bodies_ ? bodies_->stretches() : 0;
  const auto busy = [&](int w) -> BusyTimes& {
    return workers_[static_cast<std::size_t>(w)].times;
  };
  if (bodies_) {
    graph_.for_each(stretches, [&](std::size_t k, int worker) {
      Stopwatch watch;
      bodies_->place_stretch(k);
      busy(worker).add(Stage::kMotion, watch);
    });
  }
  graph_.for_each(stretches + world_.tiles(), [&](std::size_t task, int worker) {
    if (task < stretches) {
      bodies_->run_stretch(task, worker, busy(worker));
    } else {
      run_tile(task - stretches, worker);
    }
  });
  if (!bodies_) return;
  bodies_->gather();
  graph_.for_each(stretches, [&](std::size_t k, int worker) {
    Stopwatch watch;
    bodies_->move_stretch(k);
    busy(worker).add(Stage::kMotion, watch);
  });
}

template <class Real>
StageTimes Stepper<Real>::take_times() {
  StageTimes taken = std::exchange(times_, StageTimes());
  taken.shared = graph_.take_shared_time();
  for (Worker& w : workers_) {
    const BusyTimes mine = std::exchange(w.times, BusyTimes());
    for (std::size_t k = 0; k < mine.busy.size(); ++k) taken.busy[k] += mine.busy[k];
  }
  return taken;
}

template <class Real>
void Stepper<Real>::add_tiles() {
  StepTotals sum;
  std::fill(world_.wall_totals.begin(), world_.wall_totals.end(), WallTotal());
  ContactTally pairs, walls;
  fast_ = 0;
  for (std::size_t tile = 0; tile < tile_totals_.size(); ++tile) {
    const TileTotals& t = tile_totals_[tile];
    fast_ += t.move.fast;
    pairs.add(t.pairs);
    sum.polyhedron_sphere_contacts += t.near_bodies;
    walls.add(t.walls);
    add_move(t.move, sum);
    for (std::size_t w = 0; w < world_.walls.size(); ++w) {
      add_wall(tile_walls_[tile * world_.walls.size() + w], world_.wall_totals[w]);
    }
  }
  if (bodies_) {
    MoveTally move;
    const double before[2] = {pairs.contacts, walls.contacts};
    bodies_->add_to(pairs, walls, sum.model_work, move, world_.wall_totals);
    sum.polyhedron_pair_contacts = pairs.contacts - before[0];
    sum.polyhedron_wall_contacts = walls.contacts - before[1];
    fast_ += move.fast;
    add_move(move, sum);
  }
  sum.pair_work = pairs.work;
  sum.wall_contact_work = walls.work;
  sum.elastic = pairs.elastic + walls.elastic;
  sum.slide = pairs.slide + walls.slide;
  sum.tangential_damping = pairs.tangential_damping + walls.tangential_damping;
  sum.numerical_loss = pairs.numerical_loss + walls.numerical_loss;
  sum.model_work += pairs.model_work + walls.model_work;
  sum.pair_contacts = pairs.contacts;
  sum.wall_contacts = walls.contacts;
  sum.warnings = pairs.warnings + walls.warnings;
  sum.max_overlap = std::max(pairs.max_overlap, walls.max_overlap);
  world_.totals = sum;
}

// What the tiles and then the stretches of polyhedra have listed, each in order.
template <class Real>
void Stepper<Real>::add_wear() {
  if (!world_.wear.records()) return;
  constexpr std::size_t kAhead = 3;  // lists: cells lie far apart
  const std::size_t tiles = tile_wear_.size();
  for (std::size_t k = 0; k < tiles + kAhead; ++k) {
    if (k < tiles) world_.wear.prefetch(tile_wear_[k].entries);
    if (k >= kAhead) world_.wear.add(tile_wear_[k - kAhead].entries);
  }
  if (bodies_) bodies_->add_wear();
  world_.wear.time[0] += world_.clock.dt;
}

// Books the step that has just been evaluated, see "Ledger" in scheduler/README.md.
template <class Real>
void Stepper<Real>::account() {
  const StepTotals& t = world_.totals;
  Ledger& l = world_.ledger;
  l.kinetic = t.translational + t.rotational;
  l.elastic = t.elastic;
  double wall_work = 0, torque = 0, power = 0;
  for (std::size_t w = 0; w < world_.walls.size(); ++w) {
    const Body& body = world_.bodies[world_.walls[w].body];
    const WallTotal& total = world_.wall_totals[w];
    wall_work += total.work;
    const Vec3 force(total.force[0], total.force[1], total.force[2]);
    const Vec3 moment(total.torque[0], total.torque[1], total.torque[2]);
    if (body.motion.kind == MotionKind::kRotation) torque += moment.dot(body.motion.axis);
    power -= force.dot(body.velocity.at(body.motion.center)) + moment.dot(body.velocity.spin);
  }
  if (l.open == 0) {
    l = Ledger();
    l.open = 1;
    l.start_kinetic = l.kinetic = t.translational + t.rotational;
    l.start_elastic = l.elastic = t.elastic;
  } else {
    l.wall_work += wall_work;
    l.abs_wall_work += std::abs(wall_work);
    l.gravity_work +=
        world_.clock.dt * (t.momentum[0] * world_.gravity.x() + t.momentum[1] * world_.gravity.y() +
                           t.momentum[2] * world_.gravity.z());
    l.contact_work += t.pair_work + t.wall_contact_work;
    l.slide += t.slide;
    l.tangential_damping += t.tangential_damping;
    l.numerical_loss += t.numerical_loss;
    l.model_work += t.model_work;
    l.drag_loss += t.drag_loss;
  }
  Window& w = world_.window;
  w.steps += 1;
  w.torque += torque;
  w.power += power;
  w.translational += t.translational;
  w.rotational += t.rotational;
  w.elastic += t.elastic;
  w.pair_contacts += t.pair_contacts;
  w.wall_contacts += t.wall_contacts;
  w.polyhedron_sphere_contacts += t.polyhedron_sphere_contacts;
  w.polyhedron_pair_contacts += t.polyhedron_pair_contacts;
  w.polyhedron_wall_contacts += t.polyhedron_wall_contacts;
  w.max_overlap = std::max(w.max_overlap, t.max_overlap);
  w.warnings += t.warnings;
  for (std::size_t a = 0; a < 3; ++a) w.moment_of_mass[a] += t.moment_of_mass[a];
}

template <class Real>
void Stepper<Real>::account_collisions() {
  Collisions& all = world_.collisions;
  for (ContactEnergies& kind : all.kinds) kind.elastic = 0;
  for (const CollisionTally& tile : tile_collisions_) tile.add_to(all);
  if (bodies_) bodies_->add_collisions(all);
  if (all.recording == Recording::kOpening) {
    all.recording = Recording::kOn;
    all.start = world_.ledger;
    world_.pairs.episodes = world_.collisions_asked.kinds;
  } else {
    all.steps += 1;
  }
}

template <class Real>
StepReport Stepper<Real>::judge() const {
  StepReport report;
  const StepTotals& t = world_.totals;
  report.max_overlap = t.max_overlap;
  // Where shapes were exchanged, bodies stand deep in others until they are relaxed.
  if (world_.overlap_cap > 0) {
    if (world_.caps_spheres) report.capped = static_cast<std::uint64_t>(t.warnings);
  } else {
    report.warnings = static_cast<std::uint64_t>(t.warnings);
    if (t.warnings > 0) report.bits |= kOverlapWarning;
    if (t.max_overlap > 1) report.bits |= kDeepOverlap;
    if (bodies_) report.fallbacks = bodies_->fallbacks();
  }
  const bool finite = std::isfinite(t.translational + t.rotational + t.elastic + t.pair_work +
                                    t.wall_contact_work + t.model_work);
  if (!finite || t.bad > 0) {
    report.first = find_odd();
    const bool odd = !finite || report.first.id != kNoIndex;
    report.bits |= odd ? std::uint32_t{kNotFinite} : std::uint32_t{kOutside};
  }
  if (fast_ > 0 && (report.bits & kFatalBits) == 0) {
    report.first = find_too_fast(world_);
    if (report.first.id != kNoIndex) report.bits |= kTooFast;
  }
  if ((report.bits & kFatalBits) != 0 && report.first.id == kNoIndex) {
    report.first = find_offender(world_, report.bits);
  }
  return report;
}

// The next records are those of before the step.
template <class Real>
Offender Stepper<Real>::find_odd() const {
  BeforeStep<Real> before{
      &world_.particles.record_next, &world_.particles.traits_next, nullptr, {}};
  for (const TileTotals& t : tile_totals_) {
    if (before.contact.id == kNoIndex) before.contact = t.odd;
  }
  if (bodies_) {
    before.bodies = &bodies_->table();
    if (before.contact.id == kNoIndex) before.contact = bodies_->odd_contact();
  }
  return find_not_finite(world_, before);
}

// Whether the strays have new lines and the lists are complete.
template <class Real>
bool Stepper<Real>::relist_strays() {
  std::vector<std::size_t> tiles;
  for (std::size_t tile = 0; tile < tile_totals_.size(); ++tile) {
    if (tile_totals_[tile].move.strays > 0) tiles.push_back(tile);
  }
  return relister_.relist(world_, tiles);
}

template <class Real>
void Stepper<Real>::judge_lists() {
  Clock& clock = world_.clock;
  const bool expired = clock.total_steps - clock.list_step > clock.list_window;
  if (!expired && (world_.totals.strays == 0 || relist_strays())) return;
  // None are there yet where all rain in.
  const double particles =
      std::max(1.0, static_cast<double>(world_.particles.size() + world_.polyhedra.size()));
  const double slots =
      static_cast<double>(world_.pairs.slots() + world_.polyhedra.spheres.sphere.size());
  adapt_lists(clock, {expired, std::sqrt(world_.totals.max_deviation2), world_.smallest_radius,
                      (slots - world_.totals.pair_contacts) / particles});
  clock.list_stale = 1;
}

template <class Real>
StepReport Stepper<Real>::step() {
  prepare();
  Clock& clock = world_.clock;
  Stopwatch watch;
  const bool rebuilds = clock.list_stale != 0;
  if (rebuilds && !is_listable(world_)) {
    StepReport report;
    report.bits = kNotFinite;
    report.first = find_not_finite<Real>(
        world_, {&world_.particles.record, &world_.particles.traits, nullptr, {}});
    return report;
  }
  if (rebuilds) {
    move_walls();
    rebuild(world_, graph_, rebuild_);
    relister_.forget();
    place_on_grid();
    times_.rebuild += watch.lap();
    ++times_.rebuilds;
  } else if (on_grid_.empty()) {
    place_on_grid();
  }
  move_walls();
  run_tasks(rebuilds);
  times_.tasks += watch.lap();
  std::swap(world_.particles.record, world_.particles.record_next);
  std::swap(world_.particles.traits, world_.particles.traits_next);
  std::swap(on_grid_, on_grid_next_);
  add_tiles();
  add_wear();
  account();
  if (world_.collisions.on()) account_collisions();
  StepReport report = judge();
  report.rebuilt = rebuilds;
  ++clock.step;
  ++clock.total_steps;
  clock.warnings += report.warnings;
  world_.capped_contacts += report.capped;
  world_.polyhedra.fallbacks.add(report.fallbacks);
  clock.first_kick = 0;
  if ((report.bits & kFatalBits) == 0) judge_lists();
  times_.totals += watch.lap();
  return report;
}

template class Stepper<float>;
template class Stepper<double>;

}  // namespace quern
