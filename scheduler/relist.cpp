#include "scheduler/relist.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/candidates.h"
#include "kernels/polyhedron_contacts.h"
#include "scheduler/wall_lists.h"
#include "soa/facet_closest.h"

namespace quern {

namespace {

constexpr std::size_t kGroup = 64;
constexpr std::size_t kMostStrays = 16;   // at once; with more the lists have had their time
constexpr double kLeastShare = 1.0 / 16;  // of the wanted allowance
constexpr double kRounded = 1 - 1e-6;
// Other rounding than in the step: nobody who strayed there may be overlooked here.
constexpr double kStrayed = 0.999;

template <class Columns>
Vec3 line_place(const Columns& p, std::size_t k) {
  return {p.list_x[k], p.list_y[k], p.list_z[k]};
}
template <class Columns>
Vec3 line_velocity(const Columns& p, std::size_t k) {
  return {static_cast<double>(p.list_vx[k]), static_cast<double>(p.list_vy[k]),
          static_cast<double>(p.list_vz[k])};
}
// The velocity of a line is f32: what it is then.
template <class Columns>
Vec3 set_velocity(Columns& p, std::size_t k, const Vec3& velocity) {
  p.list_vx[k] = static_cast<float>(velocity.x());
  p.list_vy[k] = static_cast<float>(velocity.y());
  p.list_vz[k] = static_cast<float>(velocity.z());
  return line_velocity(p, k);
}
// The line that is at `place` when the lists are so old.
template <class Columns>
void set_line(Columns& p, std::size_t k, const Vec3& place, double elapsed, double allowance) {
  const Vec3 begin = place - elapsed * line_velocity(p, k);
  p.list_x[k] = begin.x();
  p.list_y[k] = begin.y();
  p.list_z[k] = begin.z();
  p.list_allowance[k] = static_cast<float>(kRounded * allowance);
}

template <class Real>
double period_of(const World<Real>& world, Eigen::Index axis) {
  return world.periodic[static_cast<std::size_t>(axis)] ? world.high[axis] - world.low[axis] : 0;
}
template <class Real>
Vec3 nearest(const World<Real>& world, Vec3 dx) {
  for (Eigen::Index a = 0; a < 3; ++a) {
    const double period = period_of(world, a);
    if (period > 0) dx[a] -= period * std::nearbyint(dx[a] / period);
  }
  return dx;
}

// Whether the own slots of `owner` hold this partner.
template <class Real>
bool owns(const World<Real>& world, Index owner, Index partner) {
  const Index first = world.particles.pair_first[owner];
  for (Index k = 0; k < world.particles.pair_count[owner]; ++k) {
    if (world.pairs.partner[first + k * static_cast<Index>(kPairPad)] == partner) return true;
  }
  return false;
}
// Whether a sphere is listed near a polyhedron, whose groups ascend in each tile.
template <class Real>
bool is_near(const World<Real>& world, Index sphere, Index body) {
  const PolyhedronSphereBatch<Real>& batch = world.polyhedra.spheres;
  const std::size_t tile = sphere / world.tile_size;
  const Index* last = batch.polyhedron.begin() + batch.tile_begin[tile + 1];
  const Index* group =
      std::lower_bound(batch.polyhedron.begin() + batch.tile_begin[tile], last, body);
  if (group == last || *group != body) return false;
  const std::size_t g = static_cast<std::size_t>(group - batch.polyhedron.begin());
  const Index* slot = batch.sphere.begin() + batch.begin[g];
  return std::find(slot, slot + batch.count[g], sphere) != slot + batch.count[g];
}
template <class Real>
bool are_listed(const World<Real>& world, Index a, Index b) {
  const std::pair<Index, Index> wanted(std::min(a, b), std::max(a, b));
  const auto ids = [](const PolyhedronPair& pair) {
    return std::pair<Index, Index>(pair.j, pair.i);
  };
  const auto& pairs = world.polyhedra.pairs;
  const auto at = std::lower_bound(
      pairs.begin(), pairs.end(), wanted,
      [&](const PolyhedronPair& pair, const auto& pair_ids) { return ids(pair) < pair_ids; });
  return at != pairs.end() && ids(*at) == wanted;
}

// The least distance of two that are dx apart and part with dv, within the time.
double closest(const Vec3& dx, const Vec3& dv, double time) {
  const double xv = dx.dot(dv), vv = dv.squaredNorm();
  const double when = xv < 0 ? (vv * time > -xv ? -xv / vv : time) : 0;
  return (dx + when * dv).norm();
}

// The least gap of a body of this radius to a facet that is not listed for it, beyond what body and
// wall cover in the time; `most` if it is larger. listed(wall body, facet).
template <class Real, class Listed>
double room_among_walls(const World<Real>& world, const Vec3& x, const Vec3& v, double radius,
                        double remaining, double most, const Listed& listed) {
  std::vector<Index> near;
  double room = most;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const Body& body = world.bodies[b];
    const Pose pose = pose_at(body.motion, world.wall_time());
    const double way = radius + wall_reach(body, x, v, world.wall_time(), remaining);
    const Vec3 in_body = pose.rotation.transpose() * (x - pose.shift);
    near.clear();
    find_facets(body.facets, in_body, way + room, near);
    for (const Index facet : near) {
      if (listed(static_cast<Index>(b), facet)) continue;
      const double distance =
          std::sqrt(closest_on_facet(body.facets.record[facet], in_body).distance2);
      room = std::min(room, distance - way);
    }
  }
  return room;
}

// Whether entry e of lists of facets is of this wall body and holds the facet.
template <class List>
bool holds(const List& wall_body, const List& first, const List& facets, std::size_t e, Index body,
           Index facet) {
  return wall_body[e] == body &&
         std::binary_search(facets.begin() + first[e], facets.begin() + first[e + 1], facet);
}

}  // namespace

template <class Real>
void Relister<Real>::enclose(const World<Real>& world, std::size_t group) {
  const Particles<Real>& p = world.particles;
  Group& g = groups_[group] = {Vec3::Constant(1e300), Vec3::Constant(-1e300), 0, 0};
  for (std::size_t k = group * kGroup; k < std::min(p.size(), (group + 1) * kGroup); ++k) {
    const Vec3 x = line_place(p, k);
    g.low = g.low.cwiseMin(x);
    g.high = g.high.cwiseMax(x);
    g.speed = std::max(g.speed, line_velocity(p, k).norm());
    g.reach = std::max(g.reach, static_cast<double>(p.record[k].radius) +
                                    static_cast<double>(p.list_allowance[k]));
  }
}

template <class Real>
template <class Columns>
typename Relister<Real>::Line Relister<Real>::line_of(const Columns& p, std::size_t k,
                                                      double radius) const {
  const Vec3 v = line_velocity(p, k);
  return {static_cast<Index>(k), line_place(p, k) + elapsed_ * v, v, radius,
          static_cast<double>(p.list_allowance[k])};
}
template <class Real>
typename Relister<Real>::Line Relister<Real>::line_of_sphere(const World<Real>& world,
                                                             std::size_t k) const {
  return line_of(world.particles, k, static_cast<double>(world.particles.record[k].radius));
}
template <class Real>
typename Relister<Real>::Line Relister<Real>::line_of_body(const World<Real>& world,
                                                           std::size_t k) const {
  const Polyhedra<Real>& p = world.polyhedra;
  return line_of(p, k, p.scale[k] * world.shapes[p.shape[k]].bound_radius);
}

template <class Real>
typename Relister<Real>::Meeting Relister<Real>::meet(const World<Real>& world, const Line& a,
                                                      const Line& b) const {
  const Vec3 dx = nearest(world, a.place - b.place), dv = a.velocity - b.velocity;
  Meeting m = {dx, closest(dx, dv, remaining_), true};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double period = period_of(world, axis);
    if (period <= 0) continue;
    const double other = period - std::abs(dx[axis]) - remaining_ * std::abs(dv[axis]);
    if (other >= m.distance) continue;
    m.distance = other;
    m.nearest_only = false;
  }
  return m;
}

// The least height of a sphere, as long as the lists live, over that plane of a polyhedron which
// keeps them furthest apart, if the points of the polyhedron turn by no more than `turn`.
template <class Real>
double Relister<Real>::plane_gap(const World<Real>& world, Index body, const Line& sphere,
                                 const Line& line, const Meeting& meeting, double turn) const {
  if (!meeting.nearest_only) return -HUGE_VAL;
  const Polyhedra<Real>& p = world.polyhedra;
  const Shape& shape = world.shapes[p.shape[body]];
  const Mat3 into_body = p.list_orientation(body).toRotationMatrix().transpose();
  const Vec3 begin = into_body * meeting.apart;
  const Vec3 way = remaining_ * (into_body * (sphere.velocity - line.velocity));
  double gap = -HUGE_VAL;
  for (std::size_t f = 0; f < shape.faces; ++f) {
    const Vec3 normal = shape.normal(f);
    const double height = normal.dot(begin) - p.scale[body] * shape.d[f];
    gap = std::max(gap, height + std::min(0.0, normal.dot(way)));
  }
  return kRounded * gap - sphere.radius - turn;
}

// visit(line) with each sphere that may come within the reach and the allowance of a stray.
template <class Real>
template <class Visit>
void Relister<Real>::for_spheres_near(const World<Real>& world, const Line& stray,
                                      const Visit& visit) const {
  const Particles<Real>& p = world.particles;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    const double reach = stray.radius + stray.allowance + group.reach + elapsed_ * group.speed +
                         remaining_ * (group.speed + stray.velocity.norm());
    const Vec3 off = nearest(world, stray.place - 0.5 * (group.low + group.high));
    const Vec3 beyond = (off.cwiseAbs() - 0.5 * (group.high - group.low)).cwiseMax(0.0);
    if (beyond.squaredNorm() > reach * reach) continue;
    for (std::size_t k = g * kGroup; k < std::min(p.size(), (g + 1) * kGroup); ++k) {
      visit(line_of_sphere(world, k));
    }
  }
}

// The least gap to a sphere that it is not listed with, beyond what that one may stray; its own
// allowance if that is less.
template <class Real>
double Relister<Real>::room_among_spheres(const World<Real>& world, const Line& stray) const {
  double room = stray.allowance;
  for_spheres_near(world, stray, [&](const Line& other) {
    const double gap =
        meet(world, stray, other).distance - stray.radius - other.radius - other.allowance;
    if (gap >= room || other.particle == stray.particle ||
        owns(world, stray.particle, other.particle) ||
        owns(world, other.particle, stray.particle)) {
      return;
    }
    room = gap;
  });
  return room;
}

// The same to a polyhedron.
template <class Real>
double Relister<Real>::room_among_bodies(const World<Real>& world, const Line& stray) const {
  const Polyhedra<Real>& p = world.polyhedra;
  double room = stray.allowance;
  for (Index k = 0; k < p.size(); ++k) {
    const Line body = line_of_body(world, k);
    const Meeting meeting = meet(world, stray, body);
    const double by_bounds = meeting.distance - stray.radius - body.radius - body.allowance;
    if (by_bounds >= room || is_near(world, stray.particle, k)) continue;
    const double turn = static_cast<double>(p.list_turn[k]);
    const double by_planes = plane_gap(world, k, stray, body, meeting, turn) - body.allowance;
    room = std::min(room, std::max(by_bounds, by_planes));
  }
  return room;
}

template <class Real>
bool Relister<Real>::relist_sphere(World<Real>& world, std::size_t k) {
  Particles<Real>& p = world.particles;
  const Record<Real>& r = p.record[k];
  Line line = line_of_sphere(world, k);
  const Vec3 velocity = set_velocity(p, k, {r.vx, r.vy, r.vz});
  // It may be hit again as hard as it was.
  const double wanted = std::min(kRounded * 0.5 * world.clock.slack,
                                 line.allowance + remaining_ * (velocity - line.velocity).norm());
  line.place = {r.x, r.y, r.z};
  line.velocity = velocity;
  line.allowance = wanted;
  line.allowance = room_among_spheres(world, line);
  line.allowance = room_among_bodies(world, line);
  const WallCandidates& c = world.tile_walls[k / world.tile_size].candidates;
  line.allowance = room_among_walls(
      world, line.place, line.velocity, line.radius, remaining_, line.allowance,
      [&](Index wall_body, Index facet) {
        for (std::size_t e = 0; e < c.particle.size(); ++e) {
          if (c.particle[e] == k && holds(c.body, c.first, c.facet, e, wall_body, facet))
            return true;
        }
        return false;
      });
  if (!(line.allowance > kLeastShare * wanted)) return false;
  set_line(p, k, line.place, elapsed_, line.allowance);
  enclose(world, k / kGroup);
  return true;
}

// A polyhedron may stray and turn: of what it wants of both it is given the same share.
template <class Real>
bool Relister<Real>::relist_body(World<Real>& world, std::size_t k) {
  Polyhedra<Real>& p = world.polyhedra;
  Line line = line_of_body(world, k);
  const Vec3 velocity = set_velocity(p, k, p.velocity(k));
  const double wanted = std::min(kRounded * 0.5 * world.clock.slack,
                                 line.allowance + remaining_ * (velocity - line.velocity).norm());
  const double turn = wanted + remaining_ * p.spin(k).norm() * line.radius;
  line.place = p.place(k);
  line.velocity = velocity;
  line.allowance = wanted;
  p.list_qw[k] = p.qw[k];
  p.list_qx[k] = p.qx[k];
  p.list_qy[k] = p.qy[k];
  p.list_qz[k] = p.qz[k];
  const Index body = static_cast<Index>(k);
  double share = 1;
  for_spheres_near(world, line, [&](const Line& sphere) {
    const Meeting meeting = meet(world, sphere, line);
    const double by_bounds =
        (meeting.distance - sphere.radius - line.radius - sphere.allowance) / wanted;
    if (by_bounds >= share || is_near(world, sphere.particle, body)) return;
    const double by_planes =
        (plane_gap(world, body, sphere, line, meeting, 0) - sphere.allowance) / (wanted + turn);
    share = std::min(share, std::max(by_bounds, by_planes));
  });
  for (Index other = 0; other < p.size(); ++other) {
    const Line against = line_of_body(world, other);
    const double gap =
        meet(world, line, against).distance - line.radius - against.radius - against.allowance;
    if (gap < share * wanted && other != body && !are_listed(world, body, other)) {
      share = gap / wanted;
    }
  }
  const double room = room_among_walls(
      world, line.place, line.velocity, line.radius, remaining_, share * wanted,
      [&](Index wall_body, Index facet) {
        for (std::size_t e = p.wall_candidate_begin[k]; e < p.wall_candidate_begin[k + 1]; ++e) {
          if (holds(p.wall_candidate_body, p.wall_candidate_facet_begin, p.wall_candidate_facet, e,
                    wall_body, facet)) {
            return true;
          }
        }
        return false;
      });
  share = std::min(share, room / wanted);
  if (!(share > kLeastShare)) return false;
  set_line(p, k, line.place, elapsed_, share * wanted);
  p.list_turn[k] = static_cast<float>(kRounded * share * turn);
  return true;
}

template <class Real>
void Relister<Real>::find_strays(const World<Real>& world, const std::vector<std::size_t>& tiles) {
  const Particles<Real>& p = world.particles;
  spheres_.clear();
  for (const std::size_t tile : tiles) {
    for (std::size_t k = tile * world.tile_size;
         k < std::min<std::size_t>(p.size(), (tile + 1) * world.tile_size); ++k) {
      const Record<Real>& r = p.record[k];
      const Line line = line_of_sphere(world, k);
      const double off = (Vec3(r.x, r.y, r.z) - line.place).norm();
      if (off > kStrayed * line.allowance) spheres_.push_back(k);
    }
  }
  bodies_.clear();
  const Polyhedra<Real>& q = world.polyhedra;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const Line line = line_of_body(world, k);
    const double turned = way_of_points(q.list_orientation(k), q.orientation(k), line.radius);
    if ((q.place(k) - line.place).norm() > kStrayed * line.allowance ||
        turned > kStrayed * static_cast<double>(q.list_turn[k])) {
      bodies_.push_back(k);
    }
  }
}

template <class Real>
bool Relister<Real>::relist(World<Real>& world, const std::vector<std::size_t>& tiles) {
  const Clock& clock = world.clock;
  elapsed_ = static_cast<double>(clock.total_steps - clock.list_step) * clock.dt;
  remaining_ = static_cast<double>(clock.list_window) * clock.dt - elapsed_;
  find_strays(world, tiles);
  if (spheres_.size() + bodies_.size() > kMostStrays) return false;
  if (groups_.empty()) {
    groups_.resize((world.particles.size() + kGroup - 1) / kGroup);
    for (std::size_t g = 0; g < groups_.size(); ++g) enclose(world, g);
  }
  for (const std::size_t k : spheres_) {
    if (!relist_sphere(world, k)) return false;
  }
  for (const std::size_t k : bodies_) {
    if (!relist_body(world, k)) return false;
  }
  return true;
}

template class Relister<float>;
template class Relister<double>;

}  // namespace quern
