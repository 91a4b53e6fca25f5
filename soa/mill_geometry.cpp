// Walls by their numbers: the lifter profile of a mill, its ends, planes and boxes.
//
// The profile is a polygon inscribed in the shell circle. A lifter's flat top lies at radius minus
// height; its faces lean by the face angle from the lifter's mid-plane and end on the circle, so
// the base is the wider end. All normals point to the charge.
#include <cmath>

#include "soa/facets.h"

namespace quern {
namespace {

using Vec2 = Eigen::Vector2d;

// Two triangles over a quadrilateral, counterclockwise as seen from the charge.
void add_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
              std::vector<Triangle>& out) {
  out.push_back({{a, b, c}});
  out.push_back({{a, c, d}});
}

// Angle from a lifter's mid-plane at which its face meets the circle of the shell.
double base_angle(double radius, const LifterSpec& lifter) {
  const double slope = std::tan(lifter.face_angle);
  const double top = radius - lifter.height, half = 0.5 * lifter.top_width;
  // Point (top + s, half + s slope) on the circle: a quadratic in s.
  const double a = 1 + slope * slope, b = 2 * (top + half * slope);
  const double c = top * top + half * half - radius * radius;
  const double discriminant = b * b - 4 * a * c;
  QUERN_CHECK(discriminant >= 0 && c <= 0);
  const double s = -2 * c / (b + std::sqrt(discriminant));
  return std::atan2(half + s * slope, top + s);
}

}  // namespace

std::vector<Vec2> mill_profile(const MillSpec& mill) {
  const double radius = 0.5 * mill.diameter;
  std::vector<Vec2> profile;
  const auto on_circle = [&](double angle) {
    return Vec2(radius * std::cos(angle), radius * std::sin(angle));
  };
  if (!mill.lifters || mill.lifters->count == 0) {
    QUERN_CHECK(mill.pieces_per_arc >= 3);
    for (int i = 0; i < mill.pieces_per_arc; ++i) {
      profile.push_back(on_circle(2 * kPi * i / mill.pieces_per_arc));
    }
    return profile;
  }
  const LifterSpec& lifter = *mill.lifters;
  const double base = base_angle(radius, lifter), pitch = 2 * kPi / lifter.count;
  QUERN_CHECK(2 * base < pitch && mill.pieces_per_arc >= 1);
  for (int k = 0; k < lifter.count; ++k) {
    const double middle = pitch * k;
    const Eigen::Rotation2Dd turn(middle);
    const double top = radius - lifter.height, half = 0.5 * lifter.top_width;
    profile.push_back(on_circle(middle - base));
    profile.push_back(turn * Vec2(top, -half));
    profile.push_back(turn * Vec2(top, half));
    for (int i = 0; i < mill.pieces_per_arc; ++i) {
      profile.push_back(on_circle(middle + base + (pitch - 2 * base) * i / mill.pieces_per_arc));
    }
  }
  return profile;
}

std::vector<Triangle> mill_shell(const MillSpec& mill, double z_low, double z_high) {
  const auto profile = mill_profile(mill);
  std::vector<Triangle> out;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const Vec2 &p = profile[i], &q = profile[(i + 1) % profile.size()];
    add_quad({p.x(), p.y(), z_low}, {p.x(), p.y(), z_high}, {q.x(), q.y(), z_high},
             {q.x(), q.y(), z_low}, out);
  }
  return out;
}

std::vector<Triangle> mill_ends(const MillSpec& mill) {
  const double a = mill.diameter * 2 / 3, z = mill.length;
  std::vector<Triangle> out;
  add_quad({-a, -a, 0}, {a, -a, 0}, {a, a, 0}, {-a, a, 0}, out);
  add_quad({-a, -a, z}, {-a, a, z}, {a, a, z}, {a, -a, z}, out);
  return out;
}

double mill_inner_area(const MillSpec& mill) {
  const auto profile = mill_profile(mill);
  double twice = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const Vec2 &p = profile[i], &q = profile[(i + 1) % profile.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * twice;
}

bool profile_contains(const std::vector<Vec2>& profile, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const Vec2 &p = profile[i], &q = profile[(i + 1) % profile.size()];
    if ((p.y() > y) == (q.y() > y)) continue;
    if (x < p.x() + (q.x() - p.x()) * (y - p.y()) / (q.y() - p.y())) inside = !inside;
  }
  return inside;
}

std::vector<Triangle> plane_patch(const PlaneSpec& plane, const Vec3& center, double half_width) {
  const Vec3 n = plane.normal.normalized();
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Vec3 u = half_width * Vec3::Unit(least).cross(n).normalized();
  const Vec3 v = n.cross(u);
  const Vec3 foot = center - n.dot(center - plane.point) * n;
  std::vector<Triangle> out;
  add_quad(foot - u - v, foot + u - v, foot + u + v, foot - u + v, out);
  return out;
}

std::vector<Triangle> box_faces(const BoxSpec& box, const Vec3& gravity) {
  int up_axis = 1;
  if (gravity.squaredNorm() > 0) gravity.cwiseAbs().maxCoeff(&up_axis);
  const bool up_is_high = !(gravity[up_axis] > 0);
  std::vector<Triangle> out;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      if (box.open_top && axis == up_axis && high == up_is_high) continue;
      const Vec3 size = box.high - box.low;
      const Vec3 u = Vec3::Unit((axis + 1) % 3) * size[(axis + 1) % 3];
      const Vec3 v = Vec3::Unit((axis + 2) % 3) * size[(axis + 2) % 3];
      Vec3 origin = box.low;
      if (high) origin[axis] = box.high[axis];
      const Vec3 &first = high ? v : u, &second = high ? u : v;
      add_quad(origin, origin + first, origin + first + second, origin + second, out);
    }
  }
  return out;
}

}  // namespace quern
