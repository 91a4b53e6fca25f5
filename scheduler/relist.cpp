#include "scheduler/relist.h"

#include <algorithm>
#include <cmath>

#include "kernels/candidates.h"
#include "scheduler/wall_lists.h"
#include "soa/facet_closest.h"

namespace quern {

namespace {

constexpr std::size_t kGroup = 64;
constexpr std::size_t kMostStrays = 16;   // at once; with more the lists have had their time
constexpr double kLeastShare = 1.0 / 16;  // of the wanted allowance
constexpr double kRounded = 1 - 1e-6;

template <class Real>
Vec3 line_place(const Particles<Real>& p, std::size_t k) {
  return {p.list_x[k], p.list_y[k], p.list_z[k]};
}
template <class Real>
Vec3 line_velocity(const Particles<Real>& p, std::size_t k) {
  return {static_cast<double>(p.list_vx[k]), static_cast<double>(p.list_vy[k]),
          static_cast<double>(p.list_vz[k])};
}

template <class Real>
Vec3 nearest(const World<Real>& world, Vec3 dx) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (!world.periodic[a]) continue;
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    const double period = world.high[e] - world.low[e];
    dx[e] -= period * std::nearbyint(dx[e] / period);
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

// The least distance of two that are dx apart and part with dv, within the time.
double closest(const Vec3& dx, const Vec3& dv, double time) {
  const double xv = dx.dot(dv), vv = dv.squaredNorm();
  const double when = xv < 0 ? (vv * time > -xv ? -xv / vv : time) : 0;
  return (dx + when * dv).norm();
}

// The least gap of a sphere to a facet that is not among its candidates, beyond what sphere and
// wall cover in the time; `most` if it is larger.
template <class Real>
double room_among_walls(const World<Real>& world, Index particle, const Vec3& x, const Vec3& v,
                        double remaining, double most) {
  const WallCandidates& c = world.tile_walls[particle / world.tile_size].candidates;
  const double radius = static_cast<double>(world.particles.record[particle].radius);
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
      bool listed = false;
      for (std::size_t e = 0; e < c.particle.size() && !listed; ++e) {
        listed = c.particle[e] == particle && c.body[e] == b &&
                 std::binary_search(c.facet.begin() + c.first[e], c.facet.begin() + c.first[e + 1],
                                    facet);
      }
      if (listed) continue;
      const double distance =
          std::sqrt(closest_on_facet(body.facets.record[facet], in_body).distance2);
      room = std::min(room, distance - way);
    }
  }
  return room;
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

// The least gap to a sphere that it is not listed with, beyond what that one may stray; its own
// allowance if that is less.
template <class Real>
double Relister<Real>::room_among_spheres(const World<Real>& world, const Line& stray) const {
  const Particles<Real>& p = world.particles;
  double room = stray.allowance;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    const double reach = stray.radius + room + group.reach + elapsed_ * group.speed +
                         remaining_ * (group.speed + stray.velocity.norm());
    const Vec3 off = nearest(world, stray.place - 0.5 * (group.low + group.high));
    const Vec3 beyond = (off.cwiseAbs() - 0.5 * (group.high - group.low)).cwiseMax(0.0);
    if (beyond.squaredNorm() > reach * reach) continue;
    for (std::size_t k = g * kGroup; k < std::min(p.size(), (g + 1) * kGroup); ++k) {
      const Vec3 v = line_velocity(p, k);
      const double others = stray.radius + static_cast<double>(p.record[k].radius) +
                            static_cast<double>(p.list_allowance[k]);
      const Vec3 dx = nearest(world, stray.place - (line_place(p, k) + elapsed_ * v));
      const double gap = closest(dx, stray.velocity - v, remaining_) - others;
      const Index other = static_cast<Index>(k);
      if (gap >= room || other == stray.particle || owns(world, stray.particle, other) ||
          owns(world, other, stray.particle)) {
        continue;
      }
      room = gap;
    }
  }
  return room;
}

template <class Real>
bool Relister<Real>::relist_one(World<Real>& world, std::size_t k) {
  Particles<Real>& p = world.particles;
  const Record<Real>& r = p.record[k];
  const float v[3] = {static_cast<float>(r.vx), static_cast<float>(r.vy), static_cast<float>(r.vz)};
  Line line = {static_cast<Index>(k),
               {r.x, r.y, r.z},
               {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])},
               static_cast<double>(r.radius),
               0};
  // It may be hit again as hard as it was.
  const double wanted = std::min(kRounded * 0.5 * world.clock.slack,
                                 static_cast<double>(p.list_allowance[k]) +
                                     remaining_ * (line.velocity - line_velocity(p, k)).norm());
  line.allowance = wanted;
  line.allowance = room_among_spheres(world, line);
  line.allowance =
      room_among_walls(world, line.particle, line.place, line.velocity, remaining_, line.allowance);
  if (!(line.allowance > kLeastShare * wanted)) return false;
  const Vec3 begin = line.place - elapsed_ * line.velocity;
  p.list_x[k] = begin.x();
  p.list_y[k] = begin.y();
  p.list_z[k] = begin.z();
  p.list_vx[k] = v[0];
  p.list_vy[k] = v[1];
  p.list_vz[k] = v[2];
  p.list_allowance[k] = static_cast<float>(kRounded * line.allowance);
  enclose(world, k / kGroup);
  return true;
}

template <class Real>
bool Relister<Real>::relist(World<Real>& world, const std::vector<std::size_t>& tiles) {
  const Particles<Real>& p = world.particles;
  const Clock& clock = world.clock;
  elapsed_ = static_cast<double>(clock.total_steps - clock.list_step) * clock.dt;
  remaining_ = static_cast<double>(clock.list_window) * clock.dt - elapsed_;
  std::vector<std::size_t> strays;
  for (const std::size_t tile : tiles) {
    for (std::size_t k = tile * world.tile_size;
         k < std::min<std::size_t>(p.size(), (tile + 1) * world.tile_size); ++k) {
      const Record<Real>& r = p.record[k];
      const Vec3 off = Vec3(r.x, r.y, r.z) - (line_place(p, k) + elapsed_ * line_velocity(p, k));
      // Other rounding than in the step: nobody who strayed there may be overlooked here.
      if (off.norm() > 0.999 * static_cast<double>(p.list_allowance[k])) strays.push_back(k);
    }
  }
  if (strays.size() > kMostStrays) return false;
  if (groups_.empty()) {
    groups_.resize((p.size() + kGroup - 1) / kGroup);
    for (std::size_t g = 0; g < groups_.size(); ++g) enclose(world, g);
  }
  return std::all_of(strays.begin(), strays.end(),
                     [&](std::size_t k) { return relist_one(world, k); });
}

template class Relister<float>;
template class Relister<double>;

}  // namespace quern
