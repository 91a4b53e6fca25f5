// Rigid motion of walls: the pose at a time, never accumulated, and velocities consistent with it.
//
// The angle of a rotation is the closed-form integral of its piecewise linear rate. The velocity of
// a wall point over a step is its chord, [x - P(t-dt) P(t)^-1 x] / dt, an affine map V x + u; the
// usual omega x r would be off by omega^2 R dt / 2.
#pragma once

#include "soa/scene.h"

namespace quern {

// x_world = rotation * x_body + shift
struct Pose {
  Mat3 rotation = Mat3::Identity();
  Vec3 shift = Vec3::Zero();
};

// Velocity of the wall's points over one step, as a function of their place at its end.
struct WallVelocity {
  Mat3 gradient = Mat3::Zero();
  Vec3 offset = Vec3::Zero();
  Vec3 spin = Vec3::Zero();  // angular velocity, rad/s
  Vec3 at(const Vec3& x) const { return gradient * x + offset; }
  // Of the point that was at x before the step, right to (angle of the step)^2 of itself.
  Vec3 from(const Vec3& x, double dt) const { return at(x + dt * at(x + dt * at(x))); }
};

double schedule_value(const Schedule& schedule, double time);
// Integral of the rate from 0 to time; 0 for time <= 0.
double schedule_integral(const Schedule& schedule, double time);

Pose pose_at(const Motion& motion, double time);
WallVelocity velocity_over(const Motion& motion, double time, double dt);
// Upper bound of |rate| over [time, time + span], for list windows.
double max_rate(const Motion& motion, double time, double span);
// Upper bound of |rate - rate(time)| over [time, time + span]; not for oscillations.
double max_rate_change(const Motion& motion, double time, double span);

}  // namespace quern
