#include "kernels/polyhedron_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/laws/patch_damping.h"
#include "kernels/laws/stiffness.h"
#include "kernels/pairs/polyhedron_facet.h"
#include "kernels/pairs/polyhedron_polyhedron.h"
#include "kernels/pairs/wall_history.h"

namespace quern {

bool ApartFromWall::holds(const ShapePose& now) const {
  if (!(gap > 0)) return false;
  // A turn by an angle moves points by at most 2 R sin(angle / 2), and |R1 - R0| = 2 sqrt(2) sin of
  // that half.
  const double reach = now.scale * now.shape->bound_radius;
  const double turned = reach * std::sqrt(0.5 * (now.turn - turn).squaredNorm());
  const double left = Apart::kOfGap * gap - turned;
  return left > 0 && (now.place - place).squaredNorm() < left * left;
}

template <class Real>
void place_bodies(const World<Real>& world, std::size_t first, std::size_t last, Lists lists,
                  BodyTable& table) {
  const Polyhedra<Real>& p = world.polyhedra;
  for (std::size_t k = first; k < last; ++k) {
    BodyNow& now = table.body[k];
    const Quat q = p.orientation(k);
    now.state.place = p.place(k);
    now.state.velocity = p.velocity(k);
    now.state.spin = p.spin(k);
    now.state.inverse_mass = p.inverse_mass[k];
    now.state.mobility = p.inverse_inertia(k).maxCoeff();
    now.state.contacts = p.contacts[k];
    now.state.radius = p.scale[k];
    now.state.material = p.material[k];
    now.state.group = world.groups.of_species(p.species[k]);
    const Shape& shape = world.shapes[p.shape[k]];
    now.pose = {&shape, p.scale[k], now.state.place, q.toRotationMatrix()};
    now.reach = p.scale[k] * shape.bound_radius;
    now.turned = lists == Lists::kFresh
                     ? 0
                     : now.turned + way_of_points(now.orientation, q, now.reach);
    now.orientation = q;
  }
}

template <class Real>
Vec3 separation(const World<Real>& world, const Vec3& dx) {
  Vec3 nearest = dx;
  for (std::size_t a = 0; a < 3; ++a) {
    if (!world.periodic[a]) continue;
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    const double period = world.high[e] - world.low[e];
    nearest[e] -= period * std::nearbyint(dx[e] / period);
  }
  return nearest;
}

template <class Real>
void PolyhedronContacts<Real>::put(int row, const Vec3& v) {
  for (int a = 0; a < 3; ++a) put(row + a, v[a]);
}

template <class Real>
void PolyhedronContacts<Real>::reserve(std::size_t n) {
  if (n + kShapePad <= stride_) return;
  const std::size_t wider = std::max<std::size_t>(2 * stride_, n + 64);
  std::vector<double> numbers(BodyContacts::kRows * wider, 0.0);
  for (std::size_t row = 0; row < BodyContacts::kRows; ++row) {
    std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(row * stride_), count_,
                numbers.begin() + static_cast<std::ptrdiff_t>(row * wider));
  }
  numbers_ = std::move(numbers);
  stride_ = wider;
  law_row_.resize(wider);
}

template <class Real>
void PolyhedronContacts<Real>::set_elastic(const World<Real>& world, const Pressed& patch,
                                           Index law_row, double& force, double& stored,
                                           Vec3& couple) const {
  const double table = world.wall_law.normal_stiffness[law_row];
  const double cap = world.overlap_cap;
  if (world.patch.model == NormalModel::kStiffness) {
    const double pressed = cap > 0 ? std::min(patch.overlap, cap) : patch.overlap;
    const double kn = table * stiffness_factor(world.force_law, pressed, patch.reduced_radius);
    force = kn * pressed;
    stored = kn * pressed * (patch.overlap - (1 - stored_share(world.force_law)) * pressed);
    couple = Vec3::Zero();
    return;
  }
  double kv =
      world.patch.volume_stiffness > 0 ? world.patch.volume_stiffness : table / patch.smaller;
  if (cap > 0) kv = std::min(kv, table * cap / patch.area);
  force = kv * patch.area;
  stored = kv * patch.volume;
  couple = kv * patch.moment;
}

// What the contact was a step ago, into the lane that push() completes.
template <class Real>
void PolyhedronContacts<Real>::put_before(const Before& before) {
  using B = BodyContacts;
  reserve(count_ + 1);
  put(B::kNormalOld, before.normal);
  put(B::kOverlapOld, before.overlap);
  put(B::kAtOld, before.at_point);
  put(B::kSpring, before.spring);
  put(B::kForce, before.force);
}

template <class Real>
void PolyhedronContacts<Real>::push(Lane& lane, const Side& i, const Side& j, Index law_row) {
  using B = BodyContacts;
  const WallSpring& w = lane.wall;  // normal and overlap of pairs as well
  const auto turning = [](const Side& s) {
    return s.state.inverse_mass + s.arm.squaredNorm() * s.state.mobility;
  };
  const Vec3 at_point =
      i.state.velocity + i.state.spin.cross(i.arm) - j.state.velocity - j.state.spin.cross(j.arm);
  put(B::kNormal, w.normal);
  put(B::kOverlap, lane.touching ? w.overlap : 0);
  put(B::kAtPoint, at_point);
  put(B::kSpinI, i.state.spin);
  put(B::kSpinJ, j.state.spin);
  put(B::kInverseMass, i.state.inverse_mass + j.state.inverse_mass);
  put(B::kTangentialInverse, turning(i) + turning(j));
  put(B::kCountRate,
      i.state.contacts * i.state.inverse_mass + j.state.contacts * j.state.inverse_mass);
  put(B::kTangentialCountRate, i.state.contacts * turning(i) + j.state.contacts * turning(j));
  put(B::kElasticForce, lane.pair ? lane.pair->elastic_force : lane.wall.elastic_force);
  put(B::kStored, lane.pair ? lane.pair->stored : lane.wall.stored);
  put(B::kReducedRadius, lane.reduced_radius);
  law_row_[count_] = law_row;
  lane.inverse_tangential = turning(i) + turning(j);
  lane.mobility =
      patch_mobility(i.state.mobility, i.state.contacts, j.state.mobility, j.state.contacts);
  ++count_;
}

template <class Real>
void PolyhedronContacts<Real>::collect_pair(World<Real>& world, BodyTable& table,
                                            std::size_t row_of_pair, const Vec3& between,
                                            double turned) {
  PolyhedronPair& pair = world.polyhedra.pairs[row_of_pair];
  Apart& apart = table.pairs[row_of_pair];
  const BodyNow &body_j = table.body[pair.j], &body_i = table.body[pair.i];
  const double reach = body_i.reach + body_j.reach, distance2 = between.squaredNorm();
  const bool near = distance2 < reach * reach;
  apart = {between, turned, near ? 0 : std::sqrt(distance2) - reach};
  if (!near && pair.touching == 0) return;
  ShapePose a = body_j.pose, b = body_i.pose;
  a.place = Vec3::Zero();
  b.place = between;
  PairAxis axis;
  std::copy_n(pair.axis, 3, axis.axis);
  axis.gap = pair.gap;
  axis.flags = pair.axis_flags;
  PolyhedronTouch touch;
  const bool touching =
      near && touch_polyhedra(a, b, {world.patch.overlap, world.patch.model}, axis, touch);
  if (near) {
    fallbacks_.contained += (touch.flags & kTouchContained) != 0;
    fallbacks_.bounded += (touch.flags & kTouchFull) != 0;
  }
  std::copy_n(axis.axis, 3, pair.axis);
  pair.gap = axis.gap;
  pair.axis_flags = axis.flags;
  if (near && !touching) apart.gap = static_cast<double>(axis.gap);
  table.touches[row_of_pair] = touching ? 1 : 0;
  if (!touching && pair.touching == 0) return;

  const Side i{body_i.state, touching ? Vec3(touch.point - between) : pair.arm_i};
  const Side j{body_j.state, touching ? touch.point : pair.arm_j};
  const Vec3 at_old = i.state.velocity + i.state.spin.cross(pair.arm_i) - j.state.velocity -
                      j.state.spin.cross(pair.arm_j);
  Lane& lane = lanes_.emplace_back();
  lane.pair = &pair;
  lane.touching = touching;
  lane.area = touching ? touch.area : 0;
  lane.smaller = std::min(a.scale, b.scale);
  lane.reduced_radius = reduced_radius(a.scale, b.scale);
  lane.arm_i = i.arm;
  lane.arm_j = j.arm;
  lane.stored_old = pair.stored;
  lane.elastic_force_old = pair.elastic_force;
  lane.couple_old = pair.couple;
  lane.moment_old = pair.moment;
  lane.wall.normal = touching ? touch.normal : pair.normal;
  lane.wall.overlap = touching ? touch.overlap : 0;
  const Index row = i.state.material * world.materials + j.state.material;
  const Vec3 normal_old = pair.touching != 0 ? pair.normal : lane.wall.normal;
  const double overlap_old = pair.overlap;
  pair.elastic_force = pair.stored = 0;
  pair.couple.setZero();
  if (touching) {
    set_elastic(
        world,
        {touch.overlap, touch.area, touch.volume, touch.moment, lane.smaller, lane.reduced_radius},
        row, pair.elastic_force, pair.stored, pair.couple);
  }
  lane.couple = pair.couple;
  put_before({normal_old, overlap_old, at_old, pair.spring, pair.force});
  push(lane, i, j, row);
}

// One contact; `was` null: new, `now` null (normal and point are then not asked for): closing. `now`
// is in the world frame but for its moment and area vector.
template <class Real>
void PolyhedronContacts<Real>::add_wall_lane(World<Real>& world, const BodyNow& body,
                                             const WallInput& in, const PolyhedronWall* was,
                                             const WallPatch* now) {
  const Body& wall = world.bodies[in.wall_body];
  const double scale = body.pose.scale;
  Lane& lane = lanes_.emplace_back();
  lane.pair = nullptr;
  lane.touching = now != nullptr;
  lane.old_wall = was;
  if (was) lane.wall = *was;
  lane.stored_old = lane.wall.stored;
  lane.elastic_force_old = lane.wall.elastic_force;
  lane.couple_old = lane.wall.couple;
  lane.moment_old = lane.wall.moment;
  lane.smaller = lane.reduced_radius = scale;
  const Vec3 normal_old = was ? was->normal : now->normal;
  const double overlap_old = was ? was->overlap : 0;
  const Vec3 arm_old = was ? was->arm : Vec3(Vec3::Zero());
  lane.wall.particle = static_cast<Index>(in.body);
  lane.wall.elastic_force = lane.wall.stored = 0;
  lane.wall.couple.setZero();
  lane.wall.overlap = 0;
  if (now) {
    lane.wall.wall = now->wall;
    lane.wall.feature = now->feature;
    lane.wall.normal = now->normal;
    lane.wall.point = now->point;
    lane.wall.arm = now->point - body.state.place;
    lane.wall.overlap = now->overlap;
    lane.area = now->area;
  }
  const Index row =
      body.state.material * world.materials + world.walls[lane.wall.wall].material;
  if (now) {
    // The kernel's moment is about the body's centre; the couple is what the point leaves of it.
    const Mat3& turn = wall.pose.rotation;
    const Vec3 about_point = turn * (now->moment) - lane.wall.arm.cross(turn * now->vector_area);
    set_elastic(world, {now->overlap, now->area, now->volume, about_point, scale, scale}, row,
                lane.wall.elastic_force, lane.wall.stored, lane.wall.couple);
  }
  lane.couple = lane.wall.couple;
  lane.wall_velocity = wall.velocity.at(lane.wall.point);
  BodyState wall_state;
  wall_state.velocity = lane.wall_velocity;
  wall_state.spin = wall.velocity.spin;
  const Side i{body.state, lane.wall.arm}, j{wall_state, Vec3::Zero()};
  lane.arm_i = i.arm;
  lane.wall_velocity_old = wall.velocity.from(was ? was->point : now->point, world.clock.dt);
  const Vec3 at_old = i.state.velocity + i.state.spin.cross(arm_old) - lane.wall_velocity_old;
  put_before({normal_old, overlap_old, at_old, was ? was->spring : Vec3(Vec3::Zero()),
              was ? was->force : Vec3(Vec3::Zero())});
  push(lane, i, j, row);
}

template <class Real>
void PolyhedronContacts<Real>::collect_wall(World<Real>& world, const BodyNow& body,
                                            const WallInput& in) {
  const Body& wall = world.bodies[in.wall_body];
  const Mat3& turn = wall.pose.rotation;
  const ShapePose pose = {body.pose.shape, body.pose.scale,
                          turn.transpose() * (body.state.place - wall.pose.shift),
                          turn.transpose() * body.pose.turn};
  std::array<WallPatch, kMaxWallPatches> patch;
  std::size_t count = 0;
  if (in.apart) {
    if (in.old.empty() && in.apart->holds(pose)) return;
    count = static_cast<std::size_t>(polyhedron_facet_touches(wall.facets, pose, in.facets,
                                                              {world.patch.overlap, 0},
                                                              patch.data(), kMaxWallPatches));
    *in.apart = {pose.place, pose.turn,
                 count > 0 ? 0 : distance_from_facets(wall.facets, pose, in.facets)};
  }
  if (count == 0 && in.old.empty()) return;
  std::array<Index, kMaxWallPatches> wall_of, feature;
  std::array<Vec3, kMaxWallPatches> normal, point;
  for (std::size_t k = 0; k < count; ++k) {
    wall_of[k] = patch[k].wall;
    feature[k] = patch[k].feature;
    normal[k] = patch[k].normal = turn * patch[k].normal;
    point[k] = patch[k].point = turn * patch[k].point + wall.pose.shift;
    fallbacks_.bounded += (patch[k].flags & kPatchFull) != 0;
    fallbacks_.wall_depth += (patch[k].flags & kPatchDeep) != 0;
  }
  springs_.assign(in.old.begin(), in.old.end());
  std::array<int, kMaxWallPatches> from;
  match_wall_springs(springs_,
                     {{wall_of.data(), count},
                      {feature.data(), count},
                      {normal.data(), count},
                      {point.data(), count}},
                     pose.scale, from.data());
  carried_.assign(in.old.size(), false);
  for (std::size_t k = 0; k < count; ++k) {
    const PolyhedronWall* was = nullptr;
    if (from[k] >= 0) {
      carried_[static_cast<std::size_t>(from[k])] = true;
      was = &in.old[static_cast<std::size_t>(from[k])];
    }
    add_wall_lane(world, body, in, was, &patch[k]);
  }
  for (std::size_t k = 0; k < in.old.size(); ++k) {
    if (!carried_[k]) add_wall_lane(world, body, in, &in.old[k], nullptr);
  }
}

template <class Real>
void PolyhedronContacts<Real>::collect_walls_of(World<Real>& world, BodyTable& table,
                                                std::size_t body,
                                                std::span<const PolyhedronWall> old) {
  const Polyhedra<Real>& p = world.polyhedra;
  if (old.empty() && p.wall_candidate_begin[body] == p.wall_candidate_begin[body + 1]) return;
  for (Index b = 0; b < world.bodies.size(); ++b) {
    std::size_t from = 0, to = 0;
    while (from < old.size() && world.walls[old[from].wall].body != b) ++from;
    for (to = from; to < old.size() && world.walls[old[to].wall].body == b;) ++to;
    WallInput in{body, b, {}, nullptr, old.subspan(from, to - from)};
    for (Index e = p.wall_candidate_begin[body]; e < p.wall_candidate_begin[body + 1]; ++e) {
      if (p.wall_candidate_body[e] != b) continue;
      in.facets = {p.wall_candidate_facet.data() + p.wall_candidate_facet_begin[e],
                   p.wall_candidate_facet_begin[e + 1] - p.wall_candidate_facet_begin[e]};
      in.apart = &table.walls[e];
    }
    if (in.apart || !in.old.empty()) collect_wall(world, table.body[body], in);
  }
}

template <class Real>
void PolyhedronContacts<Real>::collect_pairs(World<Real>& world, BodyTable& table,
                                             std::size_t first, std::size_t last) {
  count_ = 0;
  lanes_.clear();
  fallbacks_ = Fallbacks();
  const std::vector<PairBodies>& pairs = table.pair_bodies;
  auto pair = std::lower_bound(pairs.begin(), pairs.end(), first,
                               [](const PairBodies& a, std::size_t j) { return a.j < j; });
  for (; pair != pairs.end() && pair->j < last; ++pair) {
    const BodyNow &j = table.body[pair->j], &i = table.body[pair->i];
    const Vec3 between = separation(world, Vec3(i.state.place - j.state.place));
    const double turned = i.turned + j.turned;
    const std::size_t row = static_cast<std::size_t>(pair - pairs.begin());
    if (!table.pairs[row].holds(between, turned)) collect_pair(world, table, row, between, turned);
  }
}

template <class Real>
void PolyhedronContacts<Real>::collect_walls(World<Real>& world, BodyTable& table,
                                             std::size_t first, std::size_t last) {
  count_ = 0;
  lanes_.clear();
  fallbacks_ = Fallbacks();
  Polyhedra<Real>& p = world.polyhedra;
  auto wall = std::lower_bound(p.walls.begin(), p.walls.end(), first,
                               [](const PolyhedronWall& w, std::size_t k) { return w.particle < k; });
  for (std::size_t body = first; body < last; ++body) {
    const auto begin = wall;
    while (wall != p.walls.end() && wall->particle == body) ++wall;
    collect_walls_of(world, table, body, {begin, wall});
  }
}

template <class Real>
BodyContacts PolyhedronContacts<Real>::view() {
  const std::size_t padded = (count_ + kShapePad - 1) / kShapePad * kShapePad;
  reserve(padded);
  using B = BodyContacts;
  for (std::size_t k = count_; k < padded; ++k) {
    for (std::size_t row = 0; row < B::kRows; ++row) numbers_[row * stride_ + k] = 0;
    numbers_[B::kNormal * stride_ + k] = numbers_[B::kNormalOld * stride_ + k] = 1;
    numbers_[B::kInverseMass * stride_ + k] = numbers_[B::kTangentialInverse * stride_ + k] = 1;
    law_row_[k] = 0;
  }
  return {numbers_.data(), stride_, law_row_.data(), padded};
}

// Moment on i: what damps the patch, and the couple of the volume model.
template <class Real>
Vec3 PolyhedronContacts<Real>::moment_of(const World<Real>& world,
                                         const StepConstants<double>& step, std::size_t k) const {
  using B = BodyContacts;
  const Lane& lane = lanes_[k];
  if (!lane.touching) return Vec3::Zero();
  Vec3 moment = get(B::kReduction, k) * lane.couple;
  if (!world.patch.damping) return moment;
  const Index row = law_row_[k];
  PatchDashpot dashpot;
  const double grown =
      std::sqrt(stiffness_factor(world.force_law, lane.wall.overlap, lane.reduced_radius));
  dashpot.normal_damping =
      grown * step.law.normal_damping[row] / std::sqrt(get(B::kInverseMass, k));
  dashpot.tangential_damping =
      grown * step.law.tangential_damping[row] * std::sqrt(3.5 / lane.inverse_tangential);
  dashpot.sliding_friction = step.law.sliding_friction[row];
  dashpot.mobility = lane.mobility;
  dashpot.dt = step.dt;
  moment += patch_moment(dashpot, get3(B::kNormal, k), get3(B::kSpinI, k) - get3(B::kSpinJ, k),
                         lane.area, get(B::kNormalForce, k));
  return moment;
}

template <class Real>
void PolyhedronContacts<Real>::finish(World<Real>& world, const StepConstants<double>& step,
                                      std::vector<PolyhedronWall>& walls,
                                      std::span<WallTotal> totals, PolyhedronTally& tally,
                                      PolyhedronCollisions* collisions) {
  using B = BodyContacts;
  tally.fallbacks.add(fallbacks_);
  for (std::size_t k = 0; k < count_; ++k) {
    Lane& lane = lanes_[k];
    const Vec3 force = get3(B::kForce, k), spin = get3(B::kSpinI, k) - get3(B::kSpinJ, k);
    const Vec3 moment = moment_of(world, step, k);
    const Vec3 force_old = lane.pair ? lane.pair->force : lane.wall.force;
    const double reduction = get(B::kReduction, k), half_dt = 0.5 * step.dt;
    const double stored = lane.pair ? lane.pair->stored : lane.wall.stored;
    const double pushed = lane.pair ? lane.pair->elastic_force : lane.wall.elastic_force;
    const double model_work =
        reduction *
        (half_dt * (lane.elastic_force_old * get3(B::kNormalOld, k).dot(get3(B::kAtOld, k)) +
                    pushed * get3(B::kNormal, k).dot(get3(B::kAtPoint, k)) +
                    (lane.couple_old + lane.couple).dot(spin)) +
         stored - lane.stored_old);
    tally.model_work += model_work;
    ContactTally t;
    t.work = get(B::kWork, k) + half_dt * (lane.moment_old + moment).dot(spin);
    t.elastic = get(B::kElastic, k);
    t.slide = get(B::kSlide, k);
    t.tangential_damping = get(B::kTangentialDamping, k);
    t.numerical_loss = get(B::kNumericalLoss, k);
    t.model_work = get(B::kModelWork, k);
    t.contacts = lane.touching ? 1 : 0;
    t.max_overlap = lane.wall.overlap / lane.smaller;
    const double cap = world.overlap_cap;
    t.warnings = lane.wall.overlap > (cap > 0 ? cap : 0.5 * lane.smaller) ? 1 : 0;
    if (!std::isfinite(t.work + t.elastic + model_work) && tally.odd.id == kNoIndex) {
      const Index first = world.polyhedra.first_id;
      tally.odd.id = first + (lane.pair ? lane.pair->i : lane.wall.particle);
      tally.odd.partner = lane.pair ? first + lane.pair->j : lane.wall.wall;
      tally.odd.partner_is_wall = !lane.pair;
    }
    tally.contacts[lane.pair ? 0 : 1].add(t);
    if (collisions != nullptr) record(world, k, t, *collisions);
    if (lane.pair) {
      PolyhedronPair& pair = *lane.pair;
      pair.touching = lane.touching ? 1 : 0;
      pair.spring = get3(B::kSpring, k);
      pair.force = force;
      pair.moment = moment;
      pair.normal = lane.touching ? lane.wall.normal : Vec3(Vec3::Zero());
      pair.overlap = lane.wall.overlap;
      pair.arm_i = lane.touching ? lane.arm_i : Vec3(Vec3::Zero());
      pair.arm_j = lane.touching ? lane.arm_j : Vec3(Vec3::Zero());
      continue;
    }
    WallTotal& total = totals[lane.wall.wall];
    total.work += half_dt * (force_old.dot(lane.wall_velocity_old) + force.dot(lane.wall_velocity) +
                             (lane.moment_old + moment).dot(get3(B::kSpinJ, k)));
    if (!lane.touching) continue;
    lane.wall.spring = get3(B::kSpring, k);
    lane.wall.force = force;
    lane.wall.moment = moment;
    const Vec3 centre = world.bodies[world.walls[lane.wall.wall].body].motion.center;
    const Vec3 torque = -(lane.wall.point - centre).cross(force) - moment;
    for (std::size_t a = 0; a < 3; ++a) {
      total.force[a] -= force[static_cast<Eigen::Index>(a)];
      total.torque[a] += torque[static_cast<Eigen::Index>(a)];
    }
    walls.push_back(lane.wall);
  }
}

template void place_bodies(const World<float>&, std::size_t, std::size_t, Lists, BodyTable&);
template void place_bodies(const World<double>&, std::size_t, std::size_t, Lists, BodyTable&);
template Vec3 separation(const World<float>&, const Vec3&);
template Vec3 separation(const World<double>&, const Vec3&);
template class PolyhedronContacts<float>;
template class PolyhedronContacts<double>;

}  // namespace quern
