#include "scheduler/wall_lists.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quern {

double wall_reach(const Body& body, const Vec3& x, const Vec3& v, double time, double span) {
  const Motion& m = body.motion;
  if (m.kind == MotionKind::kFixed) return v.norm() * span;
  const double rate = max_rate(m, time, span);
  if (m.kind != MotionKind::kRotation) return (v.norm() + rate) * span;
  const double distance = (x - m.center).cross(m.axis).norm() + v.norm() * span;
  const Vec3 carried = schedule_value(m.rate, time) * m.axis.cross(x - m.center);
  const double varied = max_rate_change(m, time, span);
  return ((v - carried).norm() + varied * distance) * span + rate * rate * distance * span * span;
}

namespace {

constexpr std::size_t kGroup = 64;  // neighbours along the curve that are looked at together first

// What a group of spheres covers.
struct GroupBox {
  Vec3 middle;
  double radius, sphere, speed;  // m: about the middle, of the largest sphere; m/s: of the fastest
};

GroupBox box_of(const SearchPoint* point, std::size_t count) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  GroupBox box = {Vec3::Zero(), 0, 0, 0};
  for (std::size_t k = 0; k < count; ++k) {
    const SearchPoint& p = point[k];
    const Vec3 x(p.x[0], p.x[1], p.x[2]);
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
    box.sphere = std::max(box.sphere, p.radius);
    box.speed = std::max(box.speed, velocity_of(p).norm());
  }
  box.middle = 0.5 * (low + high);
  box.radius = 0.5 * (high - low).norm();
  return box;
}

// Whether any of the group may come near the body: its own way and the wall's together.
bool may_meet(const Body& body, const GroupBox& box, double time, double span, double stray,
              std::vector<Index>& found) {
  const Motion& m = body.motion;
  double speed = box.speed;
  if (m.kind == MotionKind::kRotation) {
    const double distance = (box.middle - m.center).cross(m.axis).norm() + box.radius;
    speed += max_rate(m, time, span) * (distance + box.speed * span);
  } else if (m.kind != MotionKind::kFixed) {
    speed += max_rate(m, time, span);
  }
  const double reach = 1.000001 * (box.sphere + box.radius + stray + speed * span);
  found.clear();
  find_facets(body.facets, body.pose.rotation.transpose() * (box.middle - body.pose.shift), reach,
              found);
  return !found.empty();
}

}  // namespace

Vec3 velocity_of(const SearchPoint& p) {
  return Eigen::Map<const Eigen::Vector3f>(p.v.data()).cast<double>();
}

template <class Real>
void find_wall_candidates(World<Real>& world, const SearchPoint* points, std::size_t tile,
                          std::vector<float>& speed) {
  WallCandidates& c = world.tile_walls[tile].candidates;
  c.particle.clear();
  c.body.clear();
  c.facet.clear();
  c.first.assign(1, 0);
  const double span = static_cast<double>(world.clock.list_window) * world.clock.dt;
  const double stray = 0.5 * world.clock.slack, time = world.wall_time();
  const std::size_t last =
      std::min<std::size_t>(world.particles.size(), (tile + 1) * world.tile_size);
  std::vector<Index> near, bodies;
  for (std::size_t group = tile * world.tile_size; group < last; group += kGroup) {
    const std::size_t end = std::min(last, group + kGroup);
    const GroupBox box = box_of(points + group, end - group);
    bodies.clear();
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
      if (may_meet(world.bodies[b], box, time, span, stray, near)) {
        bodies.push_back(static_cast<Index>(b));
      }
    }
    if (bodies.empty()) continue;
    for (std::size_t k = group; k < end; ++k) {
      const SearchPoint& p = points[k];
      const Vec3 x(p.x[0], p.x[1], p.x[2]), v = velocity_of(p);
      for (const Index b : bodies) {
        const Body& body = world.bodies[b];
        const double reach = p.radius + stray + wall_reach(body, x, v, time, span);
        const Vec3 in_body = body.pose.rotation.transpose() * (x - body.pose.shift);
        find_facets(body.facets, in_body, reach, c.facet);
        if (c.facet.size() == c.first.back()) continue;
        speed[k] = std::max(speed[k], static_cast<float>((v - body.velocity.at(x)).norm()));
        c.particle.push_back(static_cast<Index>(k));
        c.body.push_back(b);
        c.first.push_back(static_cast<Index>(c.facet.size()));
      }
    }
  }
}

// Wall springs, and their episodes if there are any, follow their particles to their new tiles, in
// particle order.
template <class Real>
void carry_wall_springs(World<Real>& world, const std::vector<Index>& new_of_old) {
  std::vector<WallSpring> all;
  std::vector<Episode> episodes;
  for (TileWalls& t : world.tile_walls) {
    all.insert(all.end(), t.springs.begin(), t.springs.end());
    episodes.insert(episodes.end(), t.episodes.begin(), t.episodes.end());
    t.springs.clear();
    t.episodes.clear();
  }
  world.tile_walls.resize(world.tiles());
  for (WallSpring& spring : all) spring.particle = new_of_old[spring.particle];
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return all[a].particle < all[b].particle;
  });
  for (const std::size_t k : order) {
    TileWalls& tile = world.tile_walls[all[k].particle / world.tile_size];
    tile.springs.push_back(all[k]);
    if (!episodes.empty()) tile.episodes.push_back(episodes[k]);
  }
}

template void find_wall_candidates(World<float>&, const SearchPoint*, std::size_t,
                                   std::vector<float>&);
template void find_wall_candidates(World<double>&, const SearchPoint*, std::size_t,
                                   std::vector<float>&);
template void carry_wall_springs(World<float>&, const std::vector<Index>&);
template void carry_wall_springs(World<double>&, const std::vector<Index>&);

}  // namespace quern
