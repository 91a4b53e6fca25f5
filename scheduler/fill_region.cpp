// Bounds, sides and levels of the region to be filled; see the header for what counts as inside.
#include "scheduler/fill_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quern {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kLevelPoints = 1u << 17;

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

double distance_from_axis(double ax, double ay, double bx, double by) {
  const double ex = bx - ax, ey = by - ay;
  const double t = std::clamp(-(ax * ex + ay * ey) / (ex * ex + ey * ey), 0.0, 1.0);
  return std::hypot(ax + t * ex, ay + t * ey);
}

}  // namespace

MillSection::MillSection(const MillSpec& mill) {
  const std::vector<Eigen::Vector2d> profile = mill_profile(mill);
  std::vector<Side> sides;
  clear_radius_ = kInfinity;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const Eigen::Vector2d &a = profile[k], &b = profile[(k + 1) % profile.size()];
    sides.push_back({a.x(), a.y(), b.x(), b.y()});
    clear_radius_ = std::min(clear_radius_, distance_from_axis(a.x(), a.y(), b.x(), b.y()));
    outer_radius_ = std::max(outer_radius_, a.norm());
  }
  QUERN_CHECK(!sides.empty());
  bins_.resize(sides.size());
  for (const Side& s : sides) {  // one bin more at each end, for rounding
    const std::size_t n = bins_.size();
    std::size_t from = bin_of(s.ax, s.ay), to = bin_of(s.bx, s.by);
    if ((to + n - from) % n > n / 2) std::swap(from, to);
    const std::size_t count = std::min(n, (to + n - from) % n + 3);
    for (std::size_t k = 0; k < count; ++k) bins_[(from + n - 1 + k) % n].push_back(s);
  }
}

std::size_t MillSection::bin_of(double x, double y) const {
  const double turn = std::atan2(y, x) / (2 * kPi) + 0.5;
  const auto n = bins_.size();
  return std::min(n - 1, static_cast<std::size_t>(turn * static_cast<double>(n)));
}

// Even-odd rule along the ray from (x, y) away from the axis: it stays in one bin.
bool MillSection::contains(double x, double y) const {
  const double r2 = x * x + y * y;
  if (r2 < clear_radius_ * clear_radius_) return true;
  if (r2 > outer_radius_ * outer_radius_) return false;
  bool inside = false;
  for (const Side& s : bins_[bin_of(x, y)]) {
    const bool a_left = cross(x, y, s.ax, s.ay) >= 0, b_left = cross(x, y, s.bx, s.by) >= 0;
    if (a_left == b_left) continue;
    const double ex = s.bx - s.ax, ey = s.by - s.ay;
    const double along = cross(s.ax, s.ay, ex, ey) / cross(x, y, ex, ey);  // in units of |(x, y)|
    if (along > 1) inside = !inside;
  }
  return inside;
}

FillRegion::FillRegion(const Scene& scene, std::span<const Facets* const> walls)
    : periodic_(periodic_axes(scene)), walls_(walls.begin(), walls.end()) {
  const double g = scene.run.gravity.norm();
  if (g > 0) up_ = -scene.run.gravity / g;
  if (scene.mill) mill_.emplace(*scene.mill);
  only_mill_ = scene.mill && scene.meshes.empty() && scene.planes.empty() && scene.boxes.empty();
  sided_ = !scene.meshes.empty();
  for (const PlaneSpec& plane : scene.planes) {
    const Vec3 normal = plane.normal.normalized();
    half_spaces_.push_back({normal, normal.dot(plane.point)});
  }
  domain_low_ = scene.domain.low.value_or(Vec3::Constant(-kInfinity));
  domain_high_ = scene.domain.high.value_or(Vec3::Constant(kInfinity));
  choose_bounds(scene);
  intersect(domain_low_, domain_high_);
  for (int a = 0; a < 3; ++a) {
    if (!periodic_.on[static_cast<std::size_t>(a)]) continue;
    const double period = periodic_.length[a];
    low_[a] = std::max(low_[a], periodic_.low[a]);
    high_[a] = std::min(high_[a], periodic_.low[a] + period);
    if (high_[a] - low_[a] > (1 - 1e-12) * period) inset_[a] = 0;
  }
  if (!((high_ - low_).minCoeff() > 0)) {
    throw UserError("fill: the region is empty; check fill.low and fill.high against the walls");
  }
}

void FillRegion::choose_bounds(const Scene& scene) {
  const Vec3 everywhere = Vec3::Constant(kInfinity);
  low_ = -everywhere;
  high_ = everywhere;
  const bool given = scene.fill.low && scene.fill.high;
  intersect(scene.fill.low.value_or(-everywhere), scene.fill.high.value_or(everywhere));
  if (scene.mill) {
    const double r = mill_->outer_radius();
    intersect(Vec3(-r, -r, 0), Vec3(r, r, scene.mill->length));
  } else if (!given && !bound_by_walls_only(scene)) {
    if (!scene.domain.low || !scene.domain.high) {
      throw UserError(
          "fill: nothing bounds the region to be filled; give fill.low and fill.high, a mill, a "
          "box "
          "or the domain");
    }
    intersect(*scene.domain.low, *scene.domain.high);
  }
}

// The first box, or all of the meshes.
bool FillRegion::bound_by_walls_only(const Scene& scene) {
  if (!scene.boxes.empty()) {
    intersect(scene.boxes.front().low, scene.boxes.front().high);
    return true;
  }
  if (scene.meshes.empty() || !scene.planes.empty()) return false;
  Vec3 low = Vec3::Constant(kInfinity), high = -low;
  for (const Facets* facets : walls_) {
    for (const Vec3& v : facets->vertex) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
  }
  intersect(low, high);
  return true;
}

void FillRegion::intersect(const Vec3& low, const Vec3& high) {
  low_ = low_.cwiseMax(low);
  high_ = high_.cwiseMin(high);
}

bool is_open_box(const Scene& scene) {
  const bool given = scene.fill.low && scene.fill.high;
  return !scene.mill && !given && !scene.boxes.empty() && scene.boxes.front().open_top &&
         !scene.run.gravity.isZero();
}

int FillRegion::main_axis() const {
  int axis = 1;
  up_.cwiseAbs().maxCoeff(&axis);
  return axis;
}

void FillRegion::extend_above_box(double height) {
  const int axis = main_axis();
  if (up_[axis] > 0) {
    high_[axis] = std::min(high_[axis] + height, domain_high_[axis]);
  } else {
    low_[axis] = std::max(low_[axis] - height, domain_low_[axis]);
  }
}

void FillRegion::move_above_box(double height) {
  const int axis = main_axis();
  const double rim = up_[axis] > 0 ? high_[axis] : low_[axis];
  extend_above_box(height);
  (up_[axis] > 0 ? low_ : high_)[axis] = rim;
}

double column_height(const FillRegion& box, double volume) {
  const Vec3 size = box.high() - box.low();
  int axis = 1;
  box.up().cwiseAbs().maxCoeff(&axis);
  return volume * size[axis] / size.prod();
}

void FillRegion::keep_upper_half() { half_spaces_.push_back({up_, up_.dot(0.5 * (low_ + high_))}); }

bool FillRegion::admits(const Vec3& x, double radius) const {
  for (int a = 0; a < 3; ++a) {
    const double inset = radius * inset_[a];
    if (x[a] < low_[a] + inset || x[a] > high_[a] - inset) return false;
  }
  for (const HalfSpace& h : half_spaces_) {
    if (h.normal.dot(x) < h.offset + radius) return false;
  }
  if (!mill_) return true;
  const double r = mill_->outer_radius() - radius;
  const double distance2 = x.head<2>().squaredNorm();
  return r > 0 && distance2 <= r * r && mill_->contains(x.x(), x.y());
}

bool FillRegion::clear_of_walls(const Vec3& x, double radius) const {
  if (only_mill_) {
    const double r = mill_->clear_radius() - radius;
    if (r > 0 && x.head<2>().squaredNorm() <= r * r) return true;  // admits() saw to the ends
  }
  for (const Facets* facets : walls_) {
    if (distance_to_facets(*facets, x, radius) < radius) return false;
  }
  return !sided_ || on_inner_side(x);
}

// The side of the nearest facet. Several are equally near across an edge or a corner: the one that
// faces x most squarely decides.
bool FillRegion::on_inner_side(const Vec3& x) const {
  const double farthest = 2 * (high_ - low_).norm();
  double nearest = farthest;
  for (double reach = farthest / 64; nearest >= reach && reach <= farthest; reach *= 2) {
    for (const Facets* facets : walls_) {
      const double distance = distance_to_facets(*facets, x, reach);
      if (distance < reach) nearest = std::min(nearest, distance);
    }
  }
  double squarest = 0;
  std::vector<Index> near;
  for (const Facets* facets : walls_) {
    near.clear();
    find_facets(*facets, x, nearest * (1 + 1e-9), near);
    for (const Index t : near) {
      const Vec3 away = x - closest_point(*facets, t, x);
      if (away.norm() > nearest * (1 + 1e-9)) continue;
      const double facing = facets->normal[t].dot(away);
      if (std::abs(facing) > std::abs(squarest)) squarest = facing;
    }
  }
  return squarest > 0;
}

LevelTable::LevelTable(const FillRegion& region) {
  // Roberts' R3 sequence: additive recurrence with powers of 1/p, p^4 = p + 1.
  constexpr double kP = 1.2207440846057594754;
  const Vec3 step(1 / kP, 1 / (kP * kP), 1 / (kP * kP * kP));
  const Vec3 extent = region.high() - region.low();
  QUERN_CHECK(extent.allFinite());
  for (std::size_t k = 0; k < kLevelPoints; ++k) {
    Vec3 u = Vec3::Constant(0.5) + step * static_cast<double>(k);
    for (int a = 0; a < 3; ++a) u[a] -= std::floor(u[a]);
    const Vec3 x = region.low() + u.cwiseProduct(extent);
    if (region.admits(x, 0) && region.clear_of_walls(x, 0)) heights_.push_back(region.height(x));
  }
  std::sort(heights_.begin(), heights_.end());
  volume_ = extent.prod() * static_cast<double>(heights_.size()) / kLevelPoints;
  top_ = heights_.empty() ? 0 : kInfinity;
}

double LevelTable::level_for(double volume) const {
  if (volume >= volume_ || heights_.empty()) return top_;
  const double rank = volume / volume_ * static_cast<double>(heights_.size());
  return heights_[std::min(heights_.size() - 1, static_cast<std::size_t>(rank))];
}

}  // namespace quern
