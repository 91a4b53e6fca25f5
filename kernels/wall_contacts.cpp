#include "kernels/wall_contacts.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>

#include "kernels/pairs/sphere_facet.h"
#include "kernels/pairs/wall_history.h"

namespace quern {

namespace {

constexpr std::size_t kEntriesAhead = 8;
constexpr std::size_t kRows = WallContacts::kGeometry + 10;

// The touches of one particle with one body, in the world frame.
struct Touches {
  std::array<Index, kMaxWallTouches> wall, feature;
  std::array<Vec3, kMaxWallTouches> normal, point;  // point: contact point, middle of the overlap
  std::array<double, kMaxWallTouches> overlap;
  int count = 0;
};

struct Ball {
  Index particle;
  Vec3 place;
  double radius;
};

Vec3 contact_point(const Ball& ball, const Vec3& normal, double overlap) {
  return ball.place - (ball.radius - 0.5 * overlap) * normal;
}

void find_touches(const Body& body, const Ball& ball, std::span<const Index> facets,
                  std::span<const WallSpring> old, Touches& out) {
  const Mat3& turn = body.pose.rotation;
  const Vec3 centre = turn.transpose() * (ball.place - body.pose.shift);
  std::array<WallTouch, kMaxWallTouches> touch;
  out.count = sphere_facet_touches(body.facets, centre, ball.radius, facets, touch.data(),
                                   kMaxWallTouches);
  for (int k = 0; k < out.count; ++k) {
    const std::size_t at = static_cast<std::size_t>(k);
    WallTouch& t = touch[at];
    for (const WallSpring& spring : old) {
      if (spring.wall == t.wall && spring.feature == t.feature && spring.overlap > 0) {
        keep_side(t, turn.transpose() * spring.normal, ball.radius);
      }
    }
    out.wall[at] = t.wall;
    out.feature[at] = t.feature;
    out.normal[at] = turn * t.normal;
    out.overlap[at] = t.overlap;
    out.point[at] = contact_point(ball, out.normal[at], t.overlap);
  }
}

void push_closing(const WallSpring& spring, const Body& body, double dt, std::uint32_t material,
                  WallLanes& lanes) {
  WallSpring meta = spring;
  meta.overlap = 0;
  const WallVelocity& v = body.velocity;
  lanes.push(meta, spring.normal, spring.overlap,
             {v.at(spring.point), v.from(spring.point, dt), v.spin}, material);
}

// Lanes for the contacts of one particle with one body; `old` are its open springs.
template <class Real>
void push_contacts(const World<Real>& world, Index b, const Ball& ball,
                   std::span<const Index> facets, std::span<const WallSpring> old,
                   WallLanes& lanes) {
  const Body& body = world.bodies[b];
  Touches now;
  find_touches(body, ball, facets, old, now);
  const std::size_t count = static_cast<std::size_t>(now.count);
  std::array<int, kMaxWallTouches> from;
  match_wall_springs(old,
                     {{now.wall.data(), count},
                      {now.feature.data(), count},
                      {now.normal.data(), count},
                      {now.point.data(), count}},
                     ball.radius, from.data());
  std::array<bool, kMaxWallTouches> used{};
  for (std::size_t k = 0; k < count; ++k) {
    WallSpring meta;
    Vec3 normal_old = now.normal[k];
    double overlap_old = 0;
    Vec3 point_old = now.point[k];
    if (from[k] >= 0) {
      const std::size_t was = static_cast<std::size_t>(from[k]);
      if (was < used.size()) used[was] = true;
      meta = old[was];
      normal_old = meta.normal;
      overlap_old = meta.overlap;
      point_old = meta.point;
    }
    meta.wall = now.wall[k];
    meta.feature = now.feature[k];
    meta.particle = ball.particle;
    meta.normal = now.normal[k];
    meta.point = now.point[k];
    meta.overlap = now.overlap[k];
    const WallVelocity& v = body.velocity;
    lanes.push(meta, normal_old, overlap_old,
               {v.at(meta.point), v.from(point_old, world.clock.dt), v.spin},
               world.walls[meta.wall].material);
  }
  for (std::size_t k = 0; k < old.size(); ++k) {
    if (k < used.size() && used[k]) continue;
    push_closing(old[k], body, world.clock.dt, world.walls[old[k].wall].material, lanes);
  }
}

}  // namespace

void WallLanes::push(const WallSpring& meta, const Vec3& normal_old, double overlap_old,
                     const WallMotion& wall, std::uint32_t material) {
  const std::size_t k = meta_.size();
  reserve(k + 1);
  meta_.push_back(meta);
  particle_[k] = meta.particle;
  material_[k] = material;
  const auto put = [&](std::size_t row, double v) { numbers_[row * stride_ + k] = v; };
  for (std::size_t a = 0; a < 3; ++a) {
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    put(a, meta.normal[e]);
    put(4 + a, normal_old[e]);
    put(8 + a, wall.velocity[e]);
    put(11 + a, wall.spin[e]);
    put(14 + a, wall.velocity_old[e]);
    put(17 + a, meta.spring[e]);
    put(20 + a, meta.force[e]);
    put(23 + a, meta.moment[e]);
  }
  put(3, meta.overlap);
  put(7, overlap_old);
}

void WallLanes::reserve(std::size_t n) {
  if (n + kPairPad <= stride_) return;
  const std::size_t wider = std::max<std::size_t>(2 * stride_, 64 + n);
  std::vector<double> numbers(kRows * wider, 0.0);
  for (std::size_t row = 0; row < kRows; ++row) {
    std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(row * stride_), meta_.size(),
                numbers.begin() + static_cast<std::ptrdiff_t>(row * wider));
  }
  numbers_ = std::move(numbers);
  stride_ = wider;
  particle_.resize(wider);
  material_.resize(wider);
}

WallContacts WallLanes::view(Index idle) {
  WallContacts w{};
  const std::size_t n = meta_.size();
  w.count = (n + kPairPad - 1) / kPairPad * kPairPad;
  reserve(w.count);
  for (std::size_t k = n; k < w.count; ++k) {
    for (std::size_t row = 0; row < kRows; ++row) numbers_[row * stride_ + k] = 0;
    numbers_[k] = numbers_[4 * stride_ + k] = 1;  // unit normals
    particle_[k] = idle;
    material_[k] = 0;
  }
  double* row = numbers_.data();
  for (double*& g : w.geometry) g = std::exchange(row, row + stride_);
  for (double*& s : w.spring) s = std::exchange(row, row + stride_);
  for (double*& f : w.force) f = std::exchange(row, row + stride_);
  for (double*& m : w.moment) m = std::exchange(row, row + stride_);
  w.wall_work = row;
  w.particle = particle_.data();
  w.material = material_.data();
  return w;
}

template <class Real>
void collect_wall_contacts(const World<Real>& world, std::size_t tile, WallLanes& lanes) {
  lanes.clear();
  const TileWalls& walls = world.tile_walls[tile];
  const WallCandidates& c = walls.candidates;
  const std::vector<WallSpring>& springs = walls.springs;
  const auto body_of = [&](const WallSpring& s) { return world.walls[s.wall].body; };
  std::size_t at = 0;
  const auto close_before = [&](Index particle, Index body) {
    while (at < springs.size() &&
           (springs[at].particle < particle ||
            (springs[at].particle == particle && body_of(springs[at]) < body))) {
      const WallSpring& s = springs[at++];
      push_closing(s, world.bodies[body_of(s)], world.clock.dt, world.walls[s.wall].material, lanes);
    }
  };
  for (std::size_t entry = 0; entry < c.particle.size(); ++entry) {
    const Index particle = c.particle[entry], body = c.body[entry];
    if (entry + kEntriesAhead < c.particle.size()) {
      hwy::Prefetch(world.particles.record.data() + c.particle[entry + kEntriesAhead]);
    }
    close_before(particle, body);
    const std::size_t begin = at;
    while (at < springs.size() && springs[at].particle == particle &&
           body_of(springs[at]) == body) {
      ++at;
    }
    const Record<Real>& r = world.particles.record[particle];
    const Ball ball = {particle, Vec3(r.x, r.y, r.z), static_cast<double>(r.radius)};
    const std::span<const Index> facets(c.facet.data() + c.first[entry],
                                        c.first[entry + 1] - c.first[entry]);
    push_contacts(world, body, ball, facets, {springs.data() + begin, at - begin}, lanes);
  }
  close_before(kNoIndex, kNoIndex);
}

void return_wall_contacts(const WallContacts& contacts, WallLanes& lanes,
                          const std::vector<Wall>& walls, const std::vector<Body>& bodies,
                          TileWalls& tile, std::span<WallTotal> totals) {
  tile.springs.clear();
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    WallSpring& meta = lanes.meta(k);
    WallTotal& total = totals[meta.wall];
    total.work += contacts.wall_work[k];
    if (!(meta.overlap > 0)) continue;
    meta.spring = {contacts.spring[0][k], contacts.spring[1][k], contacts.spring[2][k]};
    meta.force = {contacts.force[0][k], contacts.force[1][k], contacts.force[2][k]};
    meta.moment = {contacts.moment[0][k], contacts.moment[1][k], contacts.moment[2][k]};
    const Vec3 arm = meta.point - bodies[walls[meta.wall].body].motion.center;
    const Vec3 torque = -arm.cross(meta.force) - meta.moment;
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      total.force[a] -= meta.force[e];
      total.torque[a] += torque[e];
    }
    tile.springs.push_back(meta);
  }
}

template void collect_wall_contacts(const World<float>&, std::size_t, WallLanes&);
template void collect_wall_contacts(const World<double>&, std::size_t, WallLanes&);

}  // namespace quern
