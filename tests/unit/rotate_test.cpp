// Rotation of free and driven bodies against Euler's solutions, and each SIMD target against the
// plain code.
#include "kernels/rotate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "soa/column.h"
#include "tests/support/contact_cases.h"
#include "tests/support/test_walls.h"

namespace quern::test {
namespace {

// Bodies as columns; the arrays end in padding of zeros, as Column's do.
struct Bodies {
  Column<double> column[16];
  RotationView view{};

  explicit Bodies(std::size_t count) {
    for (auto& c : column) {
      c.reset(count);
      c.fill(0);
    }
    Column<double>* next = column;
    for (auto& p : view.orientation) p = (next++)->data();
    for (auto& p : view.momentum) p = (next++)->data();
    for (auto& p : view.spin) p = (next++)->data();
    for (auto& p : view.torque) p = (next++)->data();
    for (auto& p : view.inverse_inertia) p = (next++)->data();
    view.count = count;
  }
  void set(std::size_t k, const Quat& q, const Vec3& momentum, const Vec3& inertia) {
    const Vec3 inverse = inverse_inertia_of(inertia);
    view.orientation[0][k] = q.w();
    for (std::size_t a = 0; a < 3; ++a) {
      const auto e = static_cast<Eigen::Index>(a);
      view.orientation[1 + a][k] = q.vec()[e];
      view.momentum[a][k] = momentum[e];
      inverse_inertia(a)[k] = inverse[e];
    }
  }
  double* inverse_inertia(std::size_t a) { return column[13 + a].data(); }
  double* torque(std::size_t a) { return column[10 + a].data(); }
  Quat orientation(std::size_t k) const {
    return {view.orientation[0][k], view.orientation[1][k], view.orientation[2][k],
            view.orientation[3][k]};
  }
  Vec3 row(const double* const* three, std::size_t k) const {
    return {three[0][k], three[1][k], three[2][k]};
  }
  Vec3 momentum(std::size_t k) const { return row(view.momentum, k); }
  Vec3 spin(std::size_t k) const { return row(view.spin, k); }
  double energy(std::size_t k) const { return 0.5 * momentum(k).dot(spin(k)); }
};

double angle_between(const Quat& a, const Quat& b) { return 2 * (a.conjugate() * b).vec().norm(); }

const Vec3 kTumbling(0.35, 0.7, 1.0);

struct Drift {
  double largest = 0, secular = 0;  // of the energy
  double momentum = 0;              // of the angular momentum, as kept and as I w of the spin
};

// Eight random spins of size 1 for a time of 1000: the energy error at its largest, and the change
// of its mean between the first and the last tenth; the largest change of angular momentum.
Drift energy_drift(double dt) {
  Random random(11);
  const std::size_t count = 8;
  Bodies bodies(count);
  std::array<double, count> start{}, first{}, last{};
  std::array<Vec3, count> momentum;
  for (std::size_t k = 0; k < count; ++k) {
    const Quat q(random.turn());
    const Vec3 spin = random.in_cube(1).normalized();
    bodies.set(k, q, q * Vec3(kTumbling.cwiseProduct(spin)), kTumbling);
    start[k] = 0.5 * kTumbling.dot(spin.cwiseProduct(spin));
    momentum[k] = bodies.momentum(k);
  }
  Drift drift;
  const int steps = static_cast<int>(std::lround(1000 / dt)), tenth = steps / 10;
  for (int step = 0; step < steps; ++step) {
    rotate_bodies(bodies.view, dt, dt);
    for (std::size_t k = 0; k < count; ++k) {
      const double error = bodies.energy(k) / start[k] - 1;
      drift.largest = std::max(drift.largest, std::abs(error));
      const Quat q = bodies.orientation(k);
      const Vec3 turning = q * Vec3(kTumbling.cwiseProduct(q.conjugate() * bodies.spin(k)));
      for (const Vec3& now : {bodies.momentum(k), turning}) {
        drift.momentum = std::max(drift.momentum, (now - momentum[k]).norm() / momentum[k].norm());
      }
      if (step < tenth) first[k] += error / tenth;
      if (step >= steps - tenth) last[k] += error / tenth;
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    drift.secular = std::max(drift.secular, std::abs(last[k] - first[k]));
    EXPECT_NEAR(bodies.orientation(k).norm(), 1, 4e-16);  // two roundings of a Newton step
  }
  return drift;
}

// The splitting is second order with a measured constant of 1e-2 (dt |w|)^2, and keeps a shadow
// energy: what remains of a trend is how well a tenth of the run averages the oscillation.
TEST(Rotation, TumblingKeepsItsEnergyAndAngularMomentum) {
  const Drift coarse = energy_drift(0.1), fine = energy_drift(0.01);
  RecordProperty("largest", std::to_string(coarse.largest));
  RecordProperty("secular", std::to_string(1e6 * coarse.secular));
  RecordProperty("momentum", std::to_string(1e15 * std::max(coarse.momentum, fine.momentum)));
  EXPECT_LT(coarse.largest, 2e-4);
  EXPECT_LT(coarse.secular, 1e-5);
  EXPECT_LT(fine.largest, 2e-6);
  EXPECT_LT(fine.secular, 1e-7);
  EXPECT_NEAR(coarse.largest / fine.largest, 100, 20);
  EXPECT_LT(coarse.momentum, 1e-13);
  EXPECT_LT(fine.momentum, 1e-13);
}

// Angular momentum is I w with w read off the turning of the body itself: the mean rate over a step
// differs from the rate at its middle by at most (dt w)^2 / 4, which halves twice with dt.
TEST(Rotation, TurnsAsItsAngularMomentumSays) {
  const auto error = [](double dt) {
    Random random(5);
    double worst = 0;
    for (int k = 0; k < 50; ++k) {
      Quat q(random.turn());
      const Vec3 momentum = q * Vec3(kTumbling.cwiseProduct(random.in_cube(1)));
      const Vec3 inverse = inverse_inertia_of(kTumbling);
      const Quat next = rotate_freely(q, momentum, inverse, dt);
      const Vec3 rate = 2 / dt * (next * q.conjugate()).vec();
      const Quat middle = Quat(q.coeffs() + next.coeffs()).normalized();
      worst = std::max(worst, (rate - spin_of(middle, momentum, inverse)).norm());
    }
    return worst;
  };
  EXPECT_LT(error(1e-2), 1e-4);
  EXPECT_NEAR(error(1e-2) / error(5e-3), 4, 0.1);
}

// Second order against the limit: the orientation after a fixed time, two step sizes, Richardson.
TEST(Rotation, OrientationConvergesWithTheSquareOfTheStep) {
  const Vec3 momentum(0.3, 0.6, -0.4), inverse = inverse_inertia_of(kTumbling);
  const auto after = [&](int steps) {
    Quat q(0.8, 0.2, -0.4, 0.4);
    q.normalize();
    for (int i = 0; i < steps; ++i) q = rotate_freely(q, momentum, inverse, 10.0 / steps);
    return q;
  };
  const Quat limit = after(64000);
  EXPECT_NEAR(angle_between(limit, after(500)) / angle_between(limit, after(1000)), 4, 0.05);
}

// About the intermediate axis a body turns over again and again. Landau and Lifshitz, Mechanics 37:
// with 2 E I2 < L^2 the component along it is sn(t), zero every 2 K(k) / rate.
TEST(Rotation, FlipsOverTheIntermediateAxisInTheAnalyticTime) {
  const Vec3 inertia = kTumbling, inverse = inverse_inertia_of(inertia), spin(0.01, 1, 0.02);
  const Vec3 momentum = inertia.cwiseProduct(spin);
  const double energy2 = momentum.dot(spin), momentum2 = momentum.squaredNorm();
  ASSERT_GT(momentum2, energy2 * inertia[1]);
  const double rate =
      std::sqrt((inertia[2] - inertia[1]) * (momentum2 - energy2 * inertia[0]) / inertia.prod());
  const double modulus2 = (inertia[1] - inertia[0]) * (energy2 * inertia[2] - momentum2) /
                          ((inertia[2] - inertia[1]) * (momentum2 - energy2 * inertia[0]));
  const double flip = 2 * std::comp_ellint_1(std::sqrt(modulus2)) / rate;

  const double dt = 0.01;
  Quat q = Quat::Identity();
  double before = momentum[1];
  std::vector<double> crossing;
  for (int step = 1; crossing.size() < 11; ++step) {
    ASSERT_LT(step, 100000);
    q = rotate_freely(q, momentum, inverse, dt);
    const double along = (q.conjugate() * momentum)[1];
    if (before * along < 0) crossing.push_back(dt * (step - along / (along - before)));
    before = along;
  }
  EXPECT_NEAR((crossing.back() - crossing.front()) / 10 / flip, 1, 1e-4);
}

// A rod has no inertia about its axis: its spin is across the axis whatever L says, and across it
// it turns at L / I. Splitting into y and z errs by (w dt)^2 / 12 of the angle at most.
TEST(Rotation, ARodTurnsAboutItsAngularMomentumAndNotAboutItself) {
  const Vec3 inertia(0, 2, 2), inverse = inverse_inertia_of(inertia);
  EXPECT_EQ(inverse, Vec3(0, 0.5, 0.5));
  const double dt = 0.01;
  Quat q = Quat(Random(3).turn());
  const Vec3 momentum = q * Vec3(0, 0.6, 0.8);
  const Quat start = q;
  for (int step = 0; step < 1000; ++step) q = rotate_freely(q, momentum, inverse, dt);
  const Quat exact = Quat(Eigen::AngleAxisd(5.0, momentum.normalized())) * start;
  EXPECT_LT(angle_between(q, exact), 5.0 * 0.25 * dt * dt / 12);
  EXPECT_NEAR((q * Vec3::UnitX()).dot(momentum), 0, 0.25 * dt * dt / 12);
  const Vec3 along = q * Vec3::UnitX();
  EXPECT_NEAR(spin_of(q, along, inverse).norm(), 0, 1e-15);
  EXPECT_TRUE(rotate_freely(q, along, inverse, dt).coeffs().allFinite());
}

TEST(Rotation, ABodyAtRestStaysAsItIs) {
  const Quat q = Quat(Random(9).turn());
  for (const Vec3& inertia : {kTumbling, Vec3(1, 1, 1), Vec3(0, 1, 1)}) {
    Bodies bodies(3);
    bodies.set(1, q, Vec3::Zero(), inertia);
    for (int step = 0; step < 100; ++step) rotate_bodies(bodies.view, 1e-3, 1e-3);
    EXPECT_LT(angle_between(bodies.orientation(1), q), 1e-15);
    EXPECT_EQ(bodies.spin(1), Vec3::Zero());
  }
}

TEST(Rotation, ABodyOfEqualMomentsTurnsAboutItsAngularMomentum) {
  Quat q = Quat(Random(21).turn());
  const Quat start = q;
  const Vec3 momentum(0.3, -0.2, 0.5);
  for (int step = 0; step < 1000; ++step) q = rotate_freely(q, momentum, Vec3(1, 1, 1), 0.01);
  const Quat exact = Quat(Eigen::AngleAxisd(10 * momentum.norm(), momentum.normalized())) * start;
  // Second order: (|w| dt)^2 = 4e-5 of an angle of 6 at most, by a factor below 1/12.
  EXPECT_LT(angle_between(q, exact), 6 * 4e-5 / 12);
}

// A constant torque about a principal axis: with a first kick of half a step leapfrog is exact,
// angle = torque t^2 / (2 I); 1000 roundings of an angle of 0.5.
TEST(Rotation, AConstantTorqueGivesTheParabola) {
  const double dt = 1e-3, torque = 0.7;
  Bodies bodies(1);
  bodies.set(0, Quat::Identity(), Vec3::Zero(), kTumbling);
  bodies.torque(1)[0] = torque;
  for (int step = 0; step < 1000; ++step) {
    rotate_bodies(bodies.view, step == 0 ? 0.5 * dt : dt, dt);
  }
  const Quat exact(Eigen::AngleAxisd(0.5 * torque / kTumbling[1], Vec3::UnitY()));
  EXPECT_LT(angle_between(bodies.orientation(0), exact), 1e-13);
  EXPECT_NEAR(bodies.spin(0)[1], torque / kTumbling[1] * (1 - 0.5 * dt), 1e-13);
}

// Small and large angles beside each other; 1 ... 25 bodies, what lies behind stays untouched. An
// error of one unit in the last place in each of some 40 steps of calculation.
TEST(Rotation, EveryTargetGivesWhatThePlainCodeGives) {
  for_each_target<double>([](const std::string& target) {
    SCOPED_TRACE(target);
    Random random(17);
    for (std::size_t count = 1; count <= 25; ++count) {
      Bodies bodies(count);
      std::vector<Quat> q(count);
      std::vector<Vec3> momentum(count), inertia(count);
      for (std::size_t k = 0; k < count; ++k) {
        q[k] = Quat(random.turn());
        momentum[k] = std::pow(10.0, random(-4, 1.3)) * random.in_cube(1);
        inertia[k] = Vec3(k % 5 == 0 ? 0 : random(0.1, 1), random(0.1, 1), random(0.1, 1));
        bodies.set(k, q[k], momentum[k], inertia[k]);
        bodies.torque(k % 3)[k] = random(-1, 1);
      }
      const double dt = 0.1;
      for (std::size_t k = 0; k < count; ++k) {
        momentum[k][static_cast<Eigen::Index>(k % 3)] += 0.05 * bodies.torque(k % 3)[k];
      }
      rotate_bodies(bodies.view, 0.05, dt);
      for (std::size_t k = 0; k < count; ++k) {
        const Vec3 inverse = inverse_inertia_of(inertia[k]);
        // Angles up to theta are good to theta eps, beyond rounding of the turns themselves.
        const double theta = 1 + dt * momentum[k].norm() * inverse.maxCoeff();
        const Quat plain = rotate_freely(q[k], momentum[k], inverse, dt);
        EXPECT_LT(angle_between(bodies.orientation(k), plain), 40 * 2.2e-16 * theta);
        EXPECT_LT((bodies.spin(k) - spin_of(plain, momentum[k], inverse)).norm(),
                  80 * 2.2e-16 * theta * momentum[k].norm() * inverse.maxCoeff());
      }
      for (auto& c : bodies.column) EXPECT_EQ(c.data()[count], 0);
    }
  });
}

}  // namespace
}  // namespace quern::test
