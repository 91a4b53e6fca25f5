// Rigid motion of walls: closed-form schedules, poses and chord velocities.
//
// Every quantity is a function of time alone. The advance over a step is integrated over that step
// itself, not formed as a difference of two long integrals, so that a wall that has turned for
// hours moves as smoothly as at the start: the difference would cost omega t / (omega dt) ulp.
#include "soa/motion.h"

#include <algorithm>
#include <cmath>

namespace quern {
namespace {

// Integral of the linear interpolation of a -> b over [from, to], all inside the segment.
double segment_integral(const Schedule::Point& a, const Schedule::Point& b, double from,
                        double to) {
  const double slope = (b.value - a.value) / (b.time - a.time);
  const double middle = 0.5 * (from + to);
  return (a.value + slope * (middle - a.time)) * (to - from);
}

// Integral of the rate over [from, to], from <= to.
double integral_between(const Schedule& schedule, double from, double to) {
  const auto& points = schedule.points;
  if (points.empty()) return 0;
  double sum = 0;
  const double before = std::min(to, points.front().time);
  if (before > from) sum += points.front().value * (before - from);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double low = std::max(from, points[i].time), high = std::min(to, points[i + 1].time);
    if (high > low) sum += segment_integral(points[i], points[i + 1], low, high);
  }
  const double after = std::max(from, points.back().time);
  if (to > after) sum += points.back().value * (to - after);
  return sum;
}

// How far the wall moves over [from, to] along its axis (m) or about it (rad).
double advance(const Motion& motion, double from, double to) {
  const double low = std::max(0.0, from), high = std::max(0.0, to);
  if (motion.kind == MotionKind::kFixed) return 0;
  if (motion.kind != MotionKind::kOscillation) return integral_between(motion.rate, low, high);
  const double omega = 2 * kPi * motion.frequency;
  return 2 * motion.amplitude * std::cos(omega * 0.5 * (low + high)) *
         std::sin(omega * 0.5 * (high - low));
}

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace

double schedule_value(const Schedule& schedule, double time) {
  const auto& points = schedule.points;
  if (points.empty()) return 0;
  if (time <= points.front().time) return points.front().value;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto &a = points[i], &b = points[i + 1];
    if (time < b.time) return a.value + (b.value - a.value) * (time - a.time) / (b.time - a.time);
  }
  return points.back().value;
}

double schedule_integral(const Schedule& schedule, double time) {
  return time <= 0 ? 0 : integral_between(schedule, 0, time);
}

Pose pose_at(const Motion& motion, double time) {
  Pose pose;
  const double amount = advance(motion, 0, time);
  if (motion.kind == MotionKind::kRotation) {
    pose.rotation = Eigen::AngleAxisd(amount, motion.axis.normalized()).toRotationMatrix();
    pose.shift = motion.center - pose.rotation * motion.center;
  } else {
    pose.shift = amount * motion.axis.normalized();
  }
  return pose;
}

WallVelocity velocity_over(const Motion& motion, double time, double dt) {
  WallVelocity velocity;
  if (motion.kind == MotionKind::kFixed) return velocity;
  // `from` is rounded, the same way for seconds on end; the step is dt.
  const double from = time - dt;
  const double amount = advance(motion, from, time) * (dt / (time - from));
  const Vec3 axis = motion.axis.normalized();
  if (motion.kind != MotionKind::kRotation) {
    velocity.offset = amount / dt * axis;
    return velocity;
  }
  // 1 - Rot(-amount) = sin(amount) K - (1 - cos(amount)) K^2 with K the cross product by the axis.
  const Mat3 k = cross_matrix(axis);
  const double half = std::sin(0.5 * amount);
  velocity.gradient = (std::sin(amount) / dt) * k - (2 * half * half / dt) * (k * k);
  velocity.offset = -(velocity.gradient * motion.center);
  velocity.spin = amount / dt * axis;
  return velocity;
}

double max_rate(const Motion& motion, double time, double span) {
  if (motion.kind == MotionKind::kFixed || time + span <= 0) return 0;
  if (motion.kind == MotionKind::kOscillation) {
    return std::abs(motion.amplitude * 2 * kPi * motion.frequency);
  }
  const double from = std::max(0.0, time), to = time + span;
  double most = std::max(std::abs(schedule_value(motion.rate, from)),
                         std::abs(schedule_value(motion.rate, to)));
  for (const auto& point : motion.rate.points) {
    if (point.time >= from && point.time <= to) most = std::max(most, std::abs(point.value));
  }
  return most;
}

double max_rate_change(const Motion& motion, double time, double span) {
  const double from = std::max(0.0, time), to = std::max(0.0, time + span);
  const double now = schedule_value(motion.rate, from);
  double most = std::abs(schedule_value(motion.rate, to) - now);
  for (const auto& point : motion.rate.points) {
    if (point.time >= from && point.time <= to) most = std::max(most, std::abs(point.value - now));
  }
  return most;
}

}  // namespace quern
