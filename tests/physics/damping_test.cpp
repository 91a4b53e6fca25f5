// Damping ratios from coefficients of restitution: published values, the closed form of the damped
// oscillator, and a numerical integration of the clamped one as an independent oracle.
#include "kernels/laws/damping.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace quern::test {
namespace {

constexpr auto kClamped = NormalForce::kClamped;
constexpr auto kUnclamped = NormalForce::kUnclamped;

// Rebound speed of x'' = -x - 2 zeta x' from x = 0, x' = 1 when the force has come down to zero:
// classical Runge-Kutta with step h, the end found by linear interpolation of the force.
double integrated_restitution(double zeta) {
  const double h = 1e-4;
  double x = 0, v = 1, force = 2 * zeta;
  const auto pull = [zeta](double place, double speed) { return -place - 2 * zeta * speed; };
  for (;;) {
    const double v1 = v, a1 = pull(x, v);
    const double v2 = v + 0.5 * h * a1, a2 = pull(x + 0.5 * h * v1, v2);
    const double v3 = v + 0.5 * h * a2, a3 = pull(x + 0.5 * h * v2, v3);
    const double v4 = v + h * a3, a4 = pull(x + h * v3, v4);
    const double next_x = x + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    const double next_v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    const double next_force = next_x + 2 * zeta * next_v;
    if (next_force <= 0 && next_v < 0) {
      const double part = force / (force - next_force);
      return -(v + part * (next_v - v));
    }
    x = next_x;
    v = next_v;
    force = next_force;
  }
}

TEST(Damping, ClampedHasTheValuesOfSchwagerAndPoeschel) {
  // Granular Matter 9 (2007) 465; half of the last digit given.
  const std::array<std::pair<double, double>, 7> kValues = {{{0.9, .0343},
                                                             {0.8, .0744},
                                                             {0.75, .0972},
                                                             {0.7, .1222},
                                                             {0.65, .1499},
                                                             {0.5, .2553},
                                                             {0.3, .4972}}};
  for (const auto& [e, zeta] : kValues) EXPECT_NEAR(damping_ratio(e, kClamped), zeta, 5e-5) << e;
  EXPECT_NEAR(clamped_restitution(1.243), 0.1, 1e-4);  // the digit of 1.243, times the slope 0.12
}

TEST(Damping, ClampedDeliversWhatIntegrationOfTheOscillatorGives) {
  for (const double e : {0.99, 0.9, 0.75, 0.5, 0.3, 0.2, 0.136}) {
    // Interpolating over a step of 1e-4 is in error by h^2 / 8 times a second derivative near 1.
    EXPECT_NEAR(integrated_restitution(damping_ratio(e, kClamped)), e, 1e-8) << e;
  }
  for (const double zeta : {0.1, 0.9, 1.0, 1.5, 3.0}) {
    EXPECT_NEAR(integrated_restitution(zeta), clamped_restitution(zeta), 1e-8) << zeta;
  }
}

TEST(Damping, UnclampedIsThatOfHalfAPeriodOfTheDampedOscillator) {
  for (const double e : {0.99, 0.9, 0.5, 0.1, 0.01}) {
    const double zeta = damping_ratio(e, kUnclamped);
    EXPECT_NEAR(std::exp(-kPi * zeta / std::sqrt(1 - zeta * zeta)), e, 1e-14) << e;
  }
}

TEST(Damping, GrowsAsRestitutionFalls) {
  for (const NormalForce mode : {kClamped, kUnclamped}) {
    double before = -1;
    for (double e = 1; e > 0.14; e -= 0.001) {
      const double zeta = damping_ratio(e, mode);
      EXPECT_GT(zeta, before) << e;
      before = zeta;
    }
    EXPECT_EQ(damping_ratio(1, mode), 0);
  }
}

TEST(Damping, ClampedStopsAtCriticalDamping) {
  EXPECT_NEAR(kLeastClampedRestitution, std::exp(-2.0), 1e-16);
  EXPECT_NEAR(clamped_restitution(1), kLeastClampedRestitution, 1e-16);
  EXPECT_NEAR(damping_ratio(kLeastClampedRestitution * (1 + 1e-9), kClamped), 1, 1e-4);
  for (const double e : {0.135, 0.1, 1e-6}) EXPECT_EQ(damping_ratio(e, kClamped), 1) << e;
  EXPECT_GT(damping_ratio(0.1, kUnclamped), 0.5);
}

TEST(Damping, RefusesWhatIsNoRestitution) {
  for (const double e : {0.0, -0.5, 1.1, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(damping_ratio(e, kClamped), InvariantError) << e;
  }
}

}  // namespace
}  // namespace quern::test
