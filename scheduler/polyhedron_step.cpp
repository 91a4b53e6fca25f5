#include "scheduler/polyhedron_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/rotate.h"
#include "scheduler/totals.h"

namespace quern {

namespace {

// Rows of each of n bodies: begin[k] .. begin[k+1] of `rows`, ascending.
template <class BodyOf>
void index_by_body(std::size_t bodies, std::size_t count, const BodyOf& body_of,
                   std::vector<Index>& begin, std::vector<Index>& rows) {
  begin.assign(bodies + 1, 0);
  rows.resize(count);
  for (std::size_t k = 0; k < count; ++k) ++begin[body_of(k) + 1];
  for (std::size_t k = 0; k < bodies; ++k) begin[k + 1] += begin[k];
  std::vector<Index> at(begin.begin(), begin.end() - 1);
  for (std::size_t k = 0; k < count; ++k) rows[at[body_of(k)]++] = static_cast<Index>(k);
}

}  // namespace

template <class Real>
BodyStepper<Real>::BodyStepper(World<Real>& world, const Kernels<Real>& kernels, int threads)
    : world_(world), kernels_(kernels), narrow_(choose_polyhedron_sphere()) {
  workers_.resize(static_cast<std::size_t>(threads));
}

template <class Real>
void BodyStepper<Real>::prepare(const StepConstants<double>& walls, bool rebuilt) {
  constants_ = walls;
  constants_.rolling = false;  // of spheres only
  stretches_.resize(stretches());
  odd_.assign(world_.tiles(), std::nullopt);
  for (Stretch& s : stretches_) {
    s.walls.clear();
    s.totals.assign(world_.walls.size(), WallTotal());
    s.tally = PolyhedronTally();
    s.move = MoveTally();
    if (!world_.collisions.on()) continue;
    s.collisions.tally.reset(world_.groups, liner_time(world_.clock.total_steps, world_.clock.dt));
    s.collisions.wall_episodes.clear();
  }
  const bool first = table_.body.empty();
  if (rebuilt || first) {
    index_lists();
    lists_ = Lists::kFresh;
  } else {
    lists_ = Lists::kKnown;
  }
}

template <class Real>
void BodyStepper<Real>::place_stretch(std::size_t stretch) {
  const std::size_t first = stretch * kStretch;
  place_bodies(world_, first, std::min(first + kStretch, world_.polyhedra.size()), lists_, table_);
}

template <class Real>
void BodyStepper<Real>::index_lists() {
  const Polyhedra<Real>& p = world_.polyhedra;
  index_by_body(
      p.size(), p.pairs.size(), [&](std::size_t k) { return p.pairs[k].i; }, pair_begin_, pair_of_);
  index_by_body(
      p.size(), p.spheres.polyhedron.size(), [&](std::size_t k) { return p.spheres.polyhedron[k]; },
      group_begin_, group_of_);
  first_pair_.assign(p.size() + 1, 0);
  table_.pair_bodies.clear();
  for (const PolyhedronPair& pair : p.pairs) {
    ++first_pair_[pair.j + 1];
    table_.pair_bodies.push_back({pair.j, pair.i});
  }
  for (std::size_t k = 0; k < p.size(); ++k) first_pair_[k + 1] += first_pair_[k];
  for (Column<double>& t : torque_) t.reset(p.size());
  table_.body.resize(p.size());
  table_.pairs.assign(p.pairs.size(), Apart());
  table_.touches.assign(p.pairs.size(), 0);
  table_.walls.assign(p.wall_candidate_body.size(), ApartFromWall());
}

template <class Real>
void BodyStepper<Real>::run_stretch(std::size_t stretch, int worker, BusyTimes& times) {
  PolyhedronContacts<Real>& contacts = workers_[static_cast<std::size_t>(worker)].contacts;
  const std::size_t first = stretch * kStretch;
  const std::size_t last = std::min(first + kStretch, world_.polyhedra.size());
  Stretch& s = stretches_[stretch];
  s.wear.entries.clear();
  const auto push = [&] {
    kernels_.push_bodies(constants_, contacts.view());
    if (world_.wear.records()) contacts.list_wear(world_, constants_, s.wear);
    contacts.finish(world_, constants_, s.walls, s.totals, s.tally,
                    world_.collisions.on() ? &s.collisions : nullptr);
  };
  Stopwatch watch;
  contacts.collect_pairs(world_, table_, first, last);
  push();
  times.add(Stage::kPolyhedronPairs, watch);
  contacts.collect_walls(world_, table_, first, last);
  push();
  times.add(Stage::kPolyhedronWalls, watch);
}

template <class Real>
GroupLanes BodyStepper<Real>::lanes_for(std::size_t count, Worker& worker) const {
  constexpr std::size_t kColumns = 4;
  const std::size_t stride = (count + kShapePad - 1) / kShapePad * kShapePad;
  if (worker.lanes.size() < kColumns * stride) worker.lanes.resize(kColumns * stride);
  double* at = worker.lanes.data();
  const auto next = [&] { return std::exchange(at, at + stride); };
  GroupLanes lanes{};
  for (double*& c : lanes.center) c = next();
  lanes.radius = next();
  return lanes;
}

template <class Real>
void BodyStepper<Real>::run_tile(std::size_t tile, int worker, const TileRows& rows,
                                 ContactTally& tally, CollisionTally* collisions) {
  PolyhedronSphereBatch<Real>& batch = world_.polyhedra.spheres;
  const Particles<Real>& p = world_.particles;
  const ParticleView<Real> view = {p.record.data(), p.traits.data()};
  Worker& scratch = workers_[static_cast<std::size_t>(worker)];
  const Index last = batch.tile_begin[tile + 1];
  scratch.near.clear(batch, batch.tile_begin[tile], last);
  for (Index g = batch.tile_begin[tile]; g < last; ++g) {
    if (g + 2 < last) {
      const char* later = reinterpret_cast<const char*>(&table_.body[batch.polyhedron[g + 2]]);
      for (std::size_t k = 0; k < sizeof(BodyNow); k += 64) __builtin_prefetch(later + k);
    }
    const BodyNow& body = table_.body[batch.polyhedron[g]];
    const Index count = batch.count[g];
    const GroupLanes lanes = lanes_for(count, scratch);
    kernels_.gather_spheres(constants_, view, body.state.place,
                            batch.sphere.data() + batch.begin[g], count, lanes);
    scratch.near.add(narrow_, batch, g, body.state, body.pose, lanes);
  }
  if (scratch.near.empty()) return;
  const Recording recording = constants_.recording;
  kernels_.push_spheres(constants_, view,
                        scratch.near.view(rows.first, world_.overlap_cap, recording), rows, tally);
  odd_[tile] = scratch.near.odd(batch);
  if (collisions != nullptr) scratch.near.record(view, recording, *collisions);
}

template <class Real>
void BodyStepper<Real>::gather() {
  std::vector<PolyhedronWall>& walls = world_.polyhedra.walls;
  walls.clear();
  std::vector<Episode>& episodes = world_.polyhedra.wall_episodes;
  episodes.clear();
  for (const Stretch& s : stretches_) {
    walls.insert(walls.end(), s.walls.begin(), s.walls.end());
    const std::vector<Episode>& more = s.collisions.wall_episodes;
    if (world_.collisions.on()) episodes.insert(episodes.end(), more.begin(), more.end());
  }
  first_wall_.assign(world_.polyhedra.size() + 1, 0);
  for (const PolyhedronWall& wall : walls) ++first_wall_[wall.particle + 1];
  for (std::size_t k = 0; k + 1 < first_wall_.size(); ++k) first_wall_[k + 1] += first_wall_[k];
}

template <class Real>
void BodyStepper<Real>::sum_forces(std::size_t body, Vec3& force, Vec3& torque,
                                   double& contacts) const {
  const Polyhedra<Real>& p = world_.polyhedra;
  for (Index k = first_pair_[body]; k < first_pair_[body + 1]; ++k) {
    if (table_.touches[k] == 0) continue;
    const PolyhedronPair& pair = p.pairs[k];
    force -= pair.force;
    torque -= pair.arm_j.cross(pair.force) + pair.moment;
    contacts += 1;
  }
  for (Index k = pair_begin_[body]; k < pair_begin_[body + 1]; ++k) {
    if (table_.touches[pair_of_[k]] == 0) continue;
    const PolyhedronPair& pair = p.pairs[pair_of_[k]];
    force += pair.force;
    torque += pair.arm_i.cross(pair.force) + pair.moment;
    contacts += 1;
  }
  for (Index k = first_wall_[body]; k < first_wall_[body + 1]; ++k) {
    const PolyhedronWall& wall = p.walls[k];
    force += wall.force;
    torque += wall.arm.cross(wall.force) + wall.moment;
    contacts += 1;
  }
  for (Index k = group_begin_[body]; k < group_begin_[body + 1]; ++k) {
    if (p.spheres.has_sums[group_of_[k]] == 0) continue;
    const double* sums = p.spheres.sums.data() + group_of_[k] * p.spheres.kSums;
    force += Vec3(sums[0], sums[1], sums[2]);
    torque += Vec3(sums[3], sums[4], sums[5]);
    contacts += sums[6];
  }
}

// Leapfrog of the centre, and what the ledger needs, as kernels/integrate-inl.h does for spheres.
template <class Real>
void BodyStepper<Real>::move_body(std::size_t body, const Vec3& force, Stretch& stretch) {
  Polyhedra<Real>& p = world_.polyhedra;
  const Clock& clock = world_.clock;
  const double kick = clock.first_kick != 0 ? 0.5 * clock.dt : clock.dt;
  const double mass = 1 / p.inverse_mass[body];
  const Vec3 before = p.velocity(body), x = p.place(body);
  const Vec3 kicked = before + kick * (p.inverse_mass[body] * force + world_.gravity);
  const Vec3 velocity = world_.drag * kicked;
  const Vec3 place = x + clock.dt * velocity;
  MoveTally& t = stretch.move;
  t.translational += 0.5 * mass * before.dot(kicked);
  t.drag_loss += 0.5 * mass * (kicked.squaredNorm() - velocity.squaredNorm());
  const double listed = static_cast<double>(clock.total_steps + 1 - clock.list_step) * clock.dt;
  const Vec3 line(p.list_x[body] + listed * static_cast<double>(p.list_vx[body]),
                  p.list_y[body] + listed * static_cast<double>(p.list_vy[body]),
                  p.list_z[body] + listed * static_cast<double>(p.list_vz[body]));
  const double deviation2 = (place - line).squaredNorm();
  const double allowed = static_cast<double>(p.list_allowance[body]);
  t.max_deviation2 = std::max(t.max_deviation2, deviation2);
  if (deviation2 > allowed * allowed) t.strays += 1;
  bool inside = true;
  for (std::size_t a = 0; a < 3; ++a) {
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    t.momentum[a] += mass * before[e];
    t.moment_of_mass[a] += mass * x[e];
    if (!world_.periodic[a]) {
      inside = inside && place[e] >= world_.low[e] && place[e] <= world_.high[e];
    }
  }
  if (!inside || !std::isfinite(deviation2 + allowed)) t.bad += 1;
  const double way = clock.dt * velocity.norm();
  if (way > p.scale[body] * world_.shapes[p.shape[body]].inner_radius) t.fast += 1;
  p.x[body] = place.x();
  p.y[body] = place.y();
  p.z[body] = place.z();
  p.vx[body] = velocity.x();
  p.vy[body] = velocity.y();
  p.vz[body] = velocity.z();
}

// Kick, drag and free rotation of a stretch; torque_ holds the torques.
template <class Real>
void BodyStepper<Real>::rotate_stretch(std::size_t first, std::size_t count, Stretch& stretch) {
  Polyhedra<Real>& p = world_.polyhedra;
  const double dt = world_.clock.dt;
  const double kick = world_.clock.first_kick != 0 ? 0.5 * dt : dt;
  for (std::size_t k = first; k < first + count; ++k) {
    const Vec3 torque(torque_[0][k], torque_[1][k], torque_[2][k]);
    const Vec3 before = p.momentum(k), kicked = before + kick * torque;
    stretch.move.rotational += 0.5 * p.spin(k).dot(kicked);
    if (world_.drag == 1) continue;
    const Vec3 dragged = world_.drag * kicked;
    const Quat q = p.orientation(k);
    stretch.move.drag_loss += 0.5 * (kicked.dot(spin_of(q, kicked, p.inverse_inertia(k))) -
                                     dragged.dot(spin_of(q, dragged, p.inverse_inertia(k))));
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      torque_[a][k] = (dragged[e] - before[e]) / kick;
    }
  }
  RotationView view{};
  Column<double>* orientation[4] = {&p.qw, &p.qx, &p.qy, &p.qz};
  Column<double>* momentum[3] = {&p.lx, &p.ly, &p.lz};
  Column<double>* spin[3] = {&p.wx, &p.wy, &p.wz};
  Column<double>* inverse[3] = {&p.inverse_ix, &p.inverse_iy, &p.inverse_iz};
  for (int a = 0; a < 4; ++a) view.orientation[a] = orientation[a]->data() + first;
  for (int a = 0; a < 3; ++a) {
    view.momentum[a] = momentum[a]->data() + first;
    view.spin[a] = spin[a]->data() + first;
    view.torque[a] = torque_[a].data() + first;
    view.inverse_inertia[a] = inverse[a]->data() + first;
  }
  view.count = count;
  rotate_bodies(view, kick, dt);
  for (std::size_t k = first; k < first + count; ++k) {
    const double way = way_of_points(p.list_orientation(k), p.orientation(k), table_.body[k].reach);
    if (way > static_cast<double>(p.list_turn[k])) stretch.move.strays += 1;
    if (!std::isfinite(way + static_cast<double>(p.list_turn[k]))) stretch.move.bad += 1;
  }
}

// Asks for what sum_forces() will read of other stretches and of tiles, all over memory.
template <class Real>
void BodyStepper<Real>::prefetch_forces(std::size_t body) const {
  const Polyhedra<Real>& p = world_.polyhedra;
  for (Index k = pair_begin_[body]; k < pair_begin_[body + 1]; ++k) {
    if (table_.touches[pair_of_[k]] == 0) continue;
    const PolyhedronPair& pair = p.pairs[pair_of_[k]];
    __builtin_prefetch(&pair.force);
    __builtin_prefetch(&pair.arm_i);
  }
  for (Index k = group_begin_[body]; k < group_begin_[body + 1]; ++k) {
    if (p.spheres.has_sums[group_of_[k]] == 0) continue;
    __builtin_prefetch(&p.spheres.sums[group_of_[k] * p.spheres.kSums]);
  }
}

template <class Real>
void BodyStepper<Real>::move_stretch(std::size_t stretch) {
  Polyhedra<Real>& p = world_.polyhedra;
  Stretch& s = stretches_[stretch];
  const std::size_t first = stretch * kStretch, last = std::min(first + kStretch, p.size());
  for (std::size_t body = first; body < last; ++body) prefetch_forces(body);
  for (std::size_t body = first; body < last; ++body) {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    double contacts = 0;
    sum_forces(body, force, torque, contacts);
    for (std::size_t a = 0; a < 3; ++a) torque_[a][body] = torque[static_cast<Eigen::Index>(a)];
    move_body(body, force, s);
    p.contacts[body] = static_cast<std::uint32_t>(contacts);
  }
  rotate_stretch(first, last - first, s);
}

template <class Real>
void BodyStepper<Real>::add_to(ContactTally& pairs, ContactTally& walls, double& model_work,
                               MoveTally& move, std::vector<WallTotal>& totals) const {
  for (const Stretch& s : stretches_) {
    pairs.add(s.tally.contacts[0]);
    walls.add(s.tally.contacts[1]);
    model_work += s.tally.model_work;
    add_move(s.move, move);
    move.fast += s.move.fast;
    for (std::size_t w = 0; w < totals.size(); ++w) add_wall(s.totals[w], totals[w]);
  }
}

template <class Real>
void BodyStepper<Real>::add_collisions(Collisions& all) const {
  for (const Stretch& s : stretches_) s.collisions.tally.add_to(all);
}

template <class Real>
Fallbacks BodyStepper<Real>::fallbacks() const {
  Fallbacks sum;
  for (const Stretch& s : stretches_) sum.add(s.tally.fallbacks);
  return sum;
}

template <class Real>
Offender BodyStepper<Real>::odd_contact() const {
  Offender found;
  for (const OddPair& pair : odd_) {
    if (!pair) continue;
    const Record<Real>& r = world_.particles.record[pair->first];
    found = {world_.particles.id[pair->first], world_.polyhedra.first_id + pair->second, false,
             {r.x, r.y, r.z}, 0};
    return found;
  }
  for (const Stretch& s : stretches_) {
    if (s.tally.odd.id == kNoIndex) continue;
    found = s.tally.odd;
    const Vec3 x = world_.polyhedra.place(found.id - world_.polyhedra.first_id);
    found.position = {x.x(), x.y(), x.z()};
    return found;
  }
  return found;
}

template <class Real>
void BodyStepper<Real>::add_wear() {
  for (const Stretch& s : stretches_) world_.wear.add(s.wear.entries);
}

template class BodyStepper<float>;
template class BodyStepper<double>;

}  // namespace quern
