#include "kernels/wall_contacts.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>

#include "kernels/pairs/sphere_facet.h"
#include "kernels/pairs/wall_history.h"

namespace quern {

namespace {

constexpr std::size_t kEntriesAhead = 8;
constexpr double kLeastRoom = 1e-3;  // of the radius: not worth a search of its own
constexpr double kFront = 1e-6;      // of the radius: so far from a border is clearly beside it
constexpr std::size_t kPoint = WallLanes::kPoint, kEnergies = kPoint + 3;
constexpr std::size_t kWear = kEnergies + 4, kRows = kWear + kWearSums;

// The touches of one particle with one body, in the world frame.
struct Touches {
  std::array<Index, kMaxWallTouches> wall, feature, facet;
  std::array<Vec3, kMaxWallTouches> normal, point;  // point: contact point, middle of the overlap
  std::array<double, kMaxWallTouches> overlap;
  std::size_t count = 0;
};

struct Ball {
  Index particle;
  Vec3 place, in_body;  // in_body: in the frame of the body
  double radius;
};

Vec3 contact_point(const Ball& ball, const Vec3& normal, double overlap) {
  return ball.place - (ball.radius - 0.5 * overlap) * normal;
}

void find_touches(const Body& body, const Ball& ball, std::span<const Index> facets,
                  std::span<const WallSpring> old, Touches& out) {
  const Mat3& turn = body.pose.rotation;
  std::array<WallTouch, kMaxWallTouches> touch;
  out.count = static_cast<std::size_t>(sphere_facet_touches(body.facets, ball.in_body, ball.radius,
                                                            facets, touch.data(), kMaxWallTouches));
  for (std::size_t k = 0; k < out.count; ++k) {
    WallTouch& t = touch[k];
    for (const WallSpring& spring : old) {
      if (spring.wall == t.wall && spring.feature == t.feature && spring.overlap > 0) {
        keep_side(t, turn.transpose() * spring.normal, ball.radius);
      }
    }
    out.wall[k] = t.wall;
    out.feature[k] = t.feature;
    out.facet[k] = t.facet;
    out.normal[k] = turn * t.normal;
    out.overlap[k] = t.overlap;
    out.point[k] = contact_point(ball, out.normal[k], t.overlap);
  }
}

template <class Real>
void push_closing(const World<Real>& world, const WallSpring& spring, WallLanes& lanes) {
  const Wall& wall = world.walls[spring.wall];
  lanes.push({spring.particle, spring.wall, spring.feature, kNoIndex, kNoIndex, spring.normal,
              spring.point, 0},
             &spring, world.bodies[wall.body], world.clock.dt, wall.material);
}

// Lanes for the contacts of one particle with one body; `old` are its open springs. `cell`: of its
// only contact, if known.
template <class Real>
void push_contacts(const World<Real>& world, const Body& body, const Ball& ball, const Touches& now,
                   std::span<const WallSpring> old, Index cell, WallLanes& lanes) {
  std::array<int, kMaxWallTouches> from;
  match_wall_springs(old,
                     {{now.wall.data(), now.count},
                      {now.feature.data(), now.count},
                      {now.normal.data(), now.count},
                      {now.point.data(), now.count}},
                     ball.radius, from.data());
  std::array<bool, kMaxWallTouches> used{};
  for (std::size_t k = 0; k < now.count; ++k) {
    const WallSpring* was = nullptr;
    if (from[k] >= 0) {
      const std::size_t at = static_cast<std::size_t>(from[k]);
      if (at < used.size()) used[at] = true;
      was = &old[at];
    }
    lanes.push({ball.particle, now.wall[k], now.feature[k], now.facet[k], cell, now.normal[k],
                now.point[k], now.overlap[k]},
               was, body, world.clock.dt, world.walls[now.wall[k]].material);
  }
  for (std::size_t k = 0; k < old.size(); ++k) {
    if (k >= used.size() || !used[k]) push_closing(world, old[k], lanes);
  }
}

// The contact with the face of one facet that goes on, without a search; false if it does not.
template <class Real>
bool push_known(const World<Real>& world, const Body& body, const Ball& ball,
                const KnownTouch& known, const WallSpring& old, WallLanes& lanes) {
  const FacetRecord& f = body.facets.record[known.facet];
  const double height = f.normal.dot(ball.in_body - f.corner[0]);
  if (!(height > kFront * ball.radius && height < ball.radius)) return false;
  if (old.wall != f.wall || old.feature != f.group) return false;
  const Vec3 normal = body.pose.rotation * f.normal;
  const double overlap = ball.radius - height;
  lanes.push({ball.particle, f.wall, f.group, known.facet, known.wear_cell, normal,
              contact_point(ball, normal, overlap), overlap},
             &old, body, world.clock.dt, world.walls[f.wall].material);
  return true;
}

// What the next steps may rely on.
KnownTouch look_again(const Facets& all, const Ball& ball, std::span<const Index> facets,
                      const Touches& now) {
  // An overlap above the radius is of a sphere that came from behind.
  if (now.count > 1 || (now.count == 1 && now.overlap[0] >= ball.radius)) return {};
  const FacetFreedom freedom = facet_freedom(all, ball.in_body, ball.radius, facets);
  if ((freedom.facet == kNoIndex) != (now.count == 0)) return {};
  return {ball.in_body, freedom.way, freedom.facet, kNoIndex};
}

// The cell of the facet that it touches, kNoIndex where it is not worth knowing or too near an edge
// to tell from the centre. If it may be relied on it is looked for again beyond.
Index look_for_cell(const WearGrid& grid, double radius, KnownTouch& known) {
  if (known.free < kLeastRoom * radius) return kNoIndex;
  double room = 0;
  const Index cell = grid.cell_at(known.facet, known.place, room);
  if (room >= kLeastRoom * radius) {
    known.free = std::min(known.free, room);
    known.wear_cell = cell;
  }
  return room > kFront * radius ? cell : kNoIndex;
}

}  // namespace

void WallLanes::push(const WallTouchNow& now, const WallSpring* old, const Body& body, double dt,
                     std::uint32_t material) {
  reserve(size_ + 1);
  const std::size_t k = size_++;
  particle_[k] = now.particle;
  wall_[k] = now.wall;
  feature_[k] = now.feature;
  facet_[k] = now.facet;
  wear_cell_[k] = now.wear_cell;
  material_[k] = material;
  old_[k] = old;
  double* const lane = numbers_.data() + k;
  const std::size_t stride = stride_;
  const auto put = [&](std::size_t row, const Vec3& v) {
    lane[row * stride] = v.x();
    lane[(row + 1) * stride] = v.y();
    lane[(row + 2) * stride] = v.z();
  };
  const WallVelocity& v = body.velocity;
  const bool moves = body.motion.kind != MotionKind::kFixed;
  const auto at = [&](const Vec3& x) { return moves ? v.at(x) : v.offset; };
  const auto from = [&](const Vec3& x) { return moves ? v.from(x, dt) : v.offset; };
  put(0, now.normal);
  lane[3 * stride] = now.overlap;
  put(4, old != nullptr ? old->normal : now.normal);
  lane[7 * stride] = old != nullptr ? old->overlap : 0;
  put(8, at(now.point));
  put(11, v.spin);
  put(14, from(old != nullptr ? old->point : now.point));
  put(17, old != nullptr ? old->spring : Vec3(Vec3::Zero()));
  put(20, old != nullptr ? old->force : Vec3(Vec3::Zero()));
  put(23, old != nullptr ? old->moment : Vec3(Vec3::Zero()));
  put(kPoint, now.point);
}

WallSpring WallLanes::spring(std::size_t k) const {
  const double* const lane = numbers_.data() + k;
  const auto get = [&](std::size_t row) {
    return Vec3(lane[row * stride_], lane[(row + 1) * stride_], lane[(row + 2) * stride_]);
  };
  return {wall_[k],    feature_[k], get(17),           get(20),      get(0),
          get(kPoint), get(23),     lane[3 * stride_], particle_[k], 0};
}

void WallLanes::reserve(std::size_t n) {
  if (n + kPairPad <= stride_) return;
  const std::size_t wider = std::max<std::size_t>(2 * stride_, 64 + n);
  std::vector<double> numbers(kRows * wider, 0.0);
  for (std::size_t row = 0; row < kRows; ++row) {
    std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(row * stride_), size_,
                numbers.begin() + static_cast<std::ptrdiff_t>(row * wider));
  }
  numbers_ = std::move(numbers);
  stride_ = wider;
  particle_.resize(wider);
  wall_.resize(wider);
  feature_.resize(wider);
  facet_.resize(wider);
  wear_cell_.resize(wider);
  old_.resize(wider);
  material_.resize(wider);
}

WallContacts WallLanes::view(Index idle) {
  WallContacts w{};
  const std::size_t n = size_;
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
  for (std::size_t k = 0; k < 4; ++k) w.energies[k] = numbers_.data() + (kEnergies + k) * stride_;
  for (std::size_t k = 0; k < kWearSums; ++k) w.wear[k] = numbers_.data() + (kWear + k) * stride_;
  w.particle = particle_.data();
  w.material = material_.data();
  return w;
}

template <class Real>
void WallLanes::find_centers(const World<Real>& world, const WallCandidates& c,
                             std::span<const KnownTouch> known) {
  const std::size_t entries = c.particle.size();
  if (holds_.size() < entries) {
    for (std::vector<double>& x : center_) x.resize(2 * entries);
    holds_.resize(2 * entries);
  }
  const Record<Real>* const record = world.particles.record.data();
  const Traits<Real>* const traits = world.particles.traits.data();
  for (std::size_t k = 0; k < entries; ++k) {
    if (k + kEntriesAhead < entries) {
      hwy::Prefetch(record + c.particle[k + kEntriesAhead]);
      hwy::Prefetch(traits + c.particle[k + kEntriesAhead]);
    }
    const Record<Real>& r = record[c.particle[k]];
    const Pose& pose = world.bodies[c.body[k]].pose;
    const double x = r.x - pose.shift.x(), y = r.y - pose.shift.y(), z = r.z - pose.shift.z();
    const auto along = [&](Eigen::Index a) {
      return pose.rotation(0, a) * x + (pose.rotation(1, a) * y + pose.rotation(2, a) * z);
    };
    const double at[3] = {along(0), along(1), along(2)};
    const KnownTouch& sure = known[k];
    double way2 = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double way = at[a] - sure.place[static_cast<Eigen::Index>(a)];
      way2 += way * way;
      center_[a][k] = at[a];
    }
    holds_[k] = way2 < sure.free * sure.free;
  }
}

template <class Real>
void collect_wall_contacts(const World<Real>& world, std::size_t tile, std::span<KnownTouch> known,
                           WallLanes& lanes) {
  const TileWalls& walls = world.tile_walls[tile];
  const WallCandidates& c = walls.candidates;
  lanes.clear();
  lanes.find_centers(world, c, known);
  const WallSpring* spring = walls.springs.data();
  const WallSpring* const last = spring + walls.springs.size();
  for (std::size_t entry = 0; entry < c.particle.size(); ++entry) {
    const Index particle = c.particle[entry];
    const auto is_before = [&](const WallSpring& s) {
      return s.particle < particle ||
             (s.particle == particle && world.walls[s.wall].body < c.body[entry]);
    };
    while (spring != last && is_before(*spring)) push_closing(world, *spring++, lanes);
    const WallSpring* const old = spring;
    while (spring != last && spring->particle == particle &&
           world.walls[spring->wall].body == c.body[entry]) {
      ++spring;
    }
    const std::span<const WallSpring> open(old, spring);
    KnownTouch& sure = known[entry];
    const bool holds = lanes.holds(entry);
    if (holds && sure.facet == kNoIndex && open.empty()) continue;
    const Body& body = world.bodies[c.body[entry]];
    const Record<Real>& r = world.particles.record[particle];
    const Ball ball = {particle, Vec3(r.x, r.y, r.z), lanes.center(entry),
                       static_cast<double>(r.radius)};
    if (holds && sure.facet != kNoIndex && open.size() == 1 &&
        push_known(world, body, ball, sure, open[0], lanes)) {
      continue;
    }
    const std::span<const Index> facets(c.facet.data() + c.first[entry],
                                        c.first[entry + 1] - c.first[entry]);
    Touches now;
    find_touches(body, ball, facets, open, now);
    sure = look_again(body.facets, ball, facets, now);
    Index cell = kNoIndex;
    if (sure.facet != kNoIndex && world.wear.records()) {
      cell = look_for_cell(world.wear.grids[c.body[entry]], ball.radius, sure);
    }
    push_contacts(world, body, ball, now, open, cell, lanes);
  }
  while (spring != last) push_closing(world, *spring++, lanes);
}

void return_wall_contacts(const WallContacts& contacts, const WallLanes& lanes,
                          const std::vector<Wall>& walls, const std::vector<Body>& bodies,
                          TileWalls& tile, std::span<WallTotal> totals) {
  tile.springs.clear();
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    WallTotal& total = totals[lanes.wall(k)];
    total.work += contacts.wall_work[k];
    if (!lanes.is_open(k)) continue;
    const WallSpring& now = tile.springs.emplace_back(lanes.spring(k));
    const Vec3 arm = now.point - bodies[walls[now.wall].body].motion.center;
    const Vec3 torque = -arm.cross(now.force) - now.moment;
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      total.force[a] -= now.force[e];
      total.torque[a] += torque[e];
    }
  }
}

template void collect_wall_contacts(const World<float>&, std::size_t, std::span<KnownTouch>,
                                    WallLanes&);
template void collect_wall_contacts(const World<double>&, std::size_t, std::span<KnownTouch>,
                                    WallLanes&);

}  // namespace quern
