// Schedules, poses and chord velocities of walls. Oracles: closed forms worked out by hand, and the
// definition of the chord itself.
#include "soa/motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace quern {
namespace {

// Constant 2 up to t = 1, rising to 5 at t = 3, falling to -1 at t = 4, then constant.
Schedule ramp() { return {{{1, 2}, {3, 5}, {4, -1}}}; }

Motion rotation(const Schedule& rate) {
  Motion m;
  m.kind = MotionKind::kRotation;
  m.axis = Vec3(1, 2, -2) / 3;
  m.center = Vec3(0.3, -0.1, 0.2);
  m.rate = rate;
  return m;
}

Motion oscillation() {
  Motion m;
  m.kind = MotionKind::kOscillation;
  m.axis = Vec3::UnitY();
  m.amplitude = 0.01;
  m.frequency = 25;
  return m;
}

Vec3 carried(const Motion& m, double from, double to, const Vec3& x) {
  const Pose a = pose_at(m, from), b = pose_at(m, to);
  return b.rotation * (a.rotation.transpose() * (x - a.shift)) + b.shift;
}

TEST(Schedule, IsLinearBetweenItsPointsAndConstantOutside) {
  const Schedule s = ramp();
  EXPECT_EQ(schedule_value(s, -7), 2);
  EXPECT_EQ(schedule_value(s, 1), 2);
  EXPECT_EQ(schedule_value(s, 2), 3.5);
  EXPECT_EQ(schedule_value(s, 3.5), 2);
  EXPECT_EQ(schedule_value(s, 4), -1);
  EXPECT_EQ(schedule_value(s, 100), -1);
}

TEST(Schedule, IntegratesInClosedForm) {
  const Schedule s = ramp();
  EXPECT_EQ(schedule_integral(s, -1), 0);
  EXPECT_EQ(schedule_integral(s, 0.5), 1);
  EXPECT_DOUBLE_EQ(schedule_integral(s, 2), 2 + 2.75);
  EXPECT_DOUBLE_EQ(schedule_integral(s, 4), 2 + 7 + 2);
  EXPECT_DOUBLE_EQ(schedule_integral(s, 6), 11 - 2);
}

TEST(Schedule, OfOnePointIntegratesToRateTimesTime) {
  const Schedule s = {{{0, 1.0995574287564276}}};
  EXPECT_EQ(schedule_integral(s, 45.7), 1.0995574287564276 * 45.7);
}

TEST(Schedule, AllowsAStepBetweenTwoPointsAtOneTime) {
  const Schedule s = {{{0, 1}, {2, 1}, {2, 3}, {5, 3}}};
  EXPECT_EQ(schedule_value(s, 1.9), 1);
  EXPECT_EQ(schedule_value(s, 2.1), 3);
  EXPECT_DOUBLE_EQ(schedule_integral(s, 4), 2 + 6);
}

TEST(Pose, IsTheIdentityUntilTheMillStarts) {
  for (const Motion& m : {rotation(ramp()), oscillation()}) {
    for (double t : {-3.0, 0.0}) {
      EXPECT_EQ(pose_at(m, t).rotation, Mat3::Identity());
      EXPECT_EQ(pose_at(m, t).shift, Vec3::Zero());
    }
  }
}

TEST(Pose, TurnsByTheRightHandRuleAboutTheCenter) {
  Motion m = rotation({{{0, kPi / 2}}});
  m.axis = Vec3::UnitZ();
  m.center = Vec3(1, 0, 0);
  const Pose p = pose_at(m, 1);
  EXPECT_LT((p.rotation * Vec3(2, 0, 5) + p.shift - Vec3(1, 1, 5)).norm(), 1e-15);
}

TEST(Pose, OfATranslationMovesAlongTheAxis) {
  Motion m;
  m.kind = MotionKind::kTranslation;
  m.axis = Vec3::UnitX();
  m.rate = {{{0, 0}, {2, 4}}};
  EXPECT_LT((pose_at(m, 3).shift - Vec3(8, 0, 0)).norm(), 1e-14);
}

TEST(Pose, OfAnOscillationIsTheSine) {
  const double t = 0.0123;
  const double expected = 0.01 * std::sin(2 * kPi * 25 * t);
  EXPECT_NEAR(pose_at(oscillation(), t).shift.y(), expected, 1e-16);
}

// Bound: the pose rounds at 1e-16 x 1 m, divided by the step.
TEST(WallVelocity, IsTheChordOfThePose) {
  const double dt = 1e-3;
  for (const Motion& m : {rotation(ramp()), oscillation()}) {
    for (double t : {0.0005, 0.001, 0.7, 2.2, 3.9995, 6.0}) {
      const Vec3 x(0.4, 1.1, -0.6);
      const Vec3 chord = (x - carried(m, t, t - dt, x)) / dt;
      EXPECT_LT((velocity_over(m, t, dt).at(x) - chord).norm(), 2e-15 / dt) << t;
    }
  }
}

TEST(WallVelocity, LeavesOmegaCrossRByHalfOmegaSquaredRDt) {
  const double omega = 2, dt = 1e-4, radius = 3;
  Motion m = rotation({{{0, omega}}});
  m.axis = Vec3::UnitZ();
  m.center = Vec3::Zero();
  const Vec3 v = velocity_over(m, 1, dt).at(Vec3(radius, 0, 0));
  EXPECT_NEAR(v.x(), 0.5 * omega * omega * radius * dt, 1e-10);
  EXPECT_NEAR(v.y(), omega * radius, 1e-6);
}

TEST(WallVelocity, IsAsSmoothAfterADayAsAtTheStart) {
  const Motion m = rotation({{{0, 1.1}}});
  const double dt = 1e-5;
  const WallVelocity early = velocity_over(m, 1, dt), late = velocity_over(m, 86400, dt);
  // The step between two times of 86400 s is itself rounded to 1.5e-11 s.
  EXPECT_LT((early.gradient - late.gradient).norm(), 1.5e-11 / dt * 1.1 * 2);
  EXPECT_NEAR(late.spin.norm(), 1.1, 1.5e-11 / dt * 1.1 * 2);
}

TEST(WallVelocity, HasTheMeanRateAsSpin) {
  const Motion m = rotation(ramp());
  const Vec3 spin = velocity_over(m, 2.5, 0.5).spin;
  const double mean = (schedule_integral(m.rate, 2.5) - schedule_integral(m.rate, 2)) / 0.5;
  EXPECT_LT((spin - mean * m.axis).norm(), 1e-14);
}

TEST(WallVelocity, IsZeroWhileTheChargeSettles) {
  for (const Motion& m : {rotation(ramp()), oscillation()}) {
    const WallVelocity v = velocity_over(m, 0, 1e-3);
    EXPECT_EQ(v.at(Vec3(1, 2, 3)), Vec3::Zero());
    EXPECT_EQ(v.spin, Vec3::Zero());
  }
}

TEST(MaxRate, BoundsTheRateOverTheWindow) {
  const Motion m = rotation(ramp());
  EXPECT_EQ(max_rate(m, 0, 0.5), 2);
  EXPECT_EQ(max_rate(m, 2, 2), 5);
  EXPECT_EQ(max_rate(m, 10, 1), 1);
  EXPECT_EQ(max_rate(m, -5, 4), 0);
  for (double t = 0; t < 5; t += 0.37) {
    for (double s = 0; s <= 1; s += 0.01) {
      EXPECT_LE(std::abs(schedule_value(m.rate, t + s)), max_rate(m, t, 1) + 1e-15);
    }
  }
  EXPECT_DOUBLE_EQ(max_rate(oscillation(), 3, 1), 0.01 * 2 * kPi * 25);
}

}  // namespace
}  // namespace quern
