// Elastic, frictionless collisions of two rocks: what the contact itself does to energy and
// momentum.
//
// force = k overlap n at the centroid is not the gradient of anything: a collision changes the
// energy by an amount of the order of the overlap, whatever the step. force = k S with its moment
// is the gradient of k V, and only the integrator is left. Velocity Verlet with the symmetric
// splitting of rotation by Dullweber, Leimkuhler and McLachlan (1997).
#include <gtest/gtest.h>

#include "tests/support/polyhedra.h"

namespace quern {
namespace {

struct Rock {
  ShapePose pose;
  Vec3 velocity = Vec3::Zero(), spin_momentum = Vec3::Zero();
  Vec3 inertia = Vec3::Ones();
  double mass = 1;
  double energy() const {
    const Vec3 body = pose.turn.transpose() * spin_momentum;
    return 0.5 * mass * velocity.squaredNorm() + 0.5 * body.cwiseQuotient(inertia).dot(body);
  }
  void kick(const Vec3& force, const Vec3& torque, double dt) {
    velocity += dt / mass * force;
    spin_momentum += dt * torque;
  }
  void drift(double dt) {
    pose.place += dt * velocity;
    Vec3 body = pose.turn.transpose() * spin_momentum;
    const int order[] = {0, 1, 2, 1, 0};
    const double part[] = {0.5, 0.5, 1, 0.5, 0.5};
    for (int k = 0; k < 5; ++k) {
      const int axis = order[k];
      const Mat3 turn =
          Eigen::AngleAxisd(part[k] * dt * body[axis] / inertia[axis], Vec3::Unit(axis))
              .toRotationMatrix();
      body = turn.transpose() * body;
      pose.turn = pose.turn * turn;
    }
  }
};

struct Collision {
  double energy_error = 0, momentum = 0, angular = 0, worst_overlap = 0;
  bool ended = false;
};

struct Setup {
  double overlap;  // about the greatest, over R
  int steps;       // per contact time
  PatchOptions options;
};

// Stiffness, mass and radius are 1; the speed sets the overlap.
Collision collide(Rock a, Rock b, const Setup& setup) {
  const double contact_time = kPi * std::sqrt(0.5), dt = contact_time / setup.steps;
  const double before = a.energy() + b.energy();
  const auto angular = [&] {
    return Vec3(a.spin_momentum + b.spin_momentum + a.pose.place.cross(a.velocity) +
                b.pose.place.cross(b.velocity));
  };
  const Vec3 angular_before = angular();
  Collision out;
  Vec3 force = Vec3::Zero(), torque_a = force, torque_b = force;
  PairAxis axis;
  int apart = 0;
  bool touched = false;
  for (int k = 0; k < 40 * setup.steps && !out.ended; ++k) {
    a.kick(-force, torque_a, dt / 2);
    b.kick(force, torque_b, dt / 2);
    a.drift(dt);
    b.drift(dt);
    force = torque_a = torque_b = Vec3::Zero();
    PolyhedronTouch t;
    if (touch_polyhedra(a.pose, b.pose, setup.options, axis, t)) {
      const bool volume = setup.options.model == NormalModel::kVolume;
      force = volume ? t.vector_area : Vec3(t.overlap * t.normal);
      const Vec3 moment = volume ? t.moment : Vec3::Zero();
      torque_b = (t.point - b.pose.place).cross(force) + moment;
      torque_a = -(t.point - a.pose.place).cross(force) - moment;
      out.worst_overlap = std::max(out.worst_overlap, t.overlap);
      touched = true;
      apart = 0;
    } else {
      out.ended = touched && ++apart > setup.steps / 5;
    }
    a.kick(-force, torque_a, dt / 2);
    b.kick(force, torque_b, dt / 2);
  }
  const double speed = a.velocity.norm() + b.velocity.norm();
  out.energy_error = std::abs(a.energy() + b.energy() - before) / before;
  out.momentum = (a.velocity + b.velocity).norm() / speed;
  out.angular = (angular() - angular_before).norm() / speed;
  return out;
}

struct Figures {
  double median, p90;
};

Figures collisions(const Setup& setup) {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> out;
    for (std::uint64_t k = 1; k <= 8; ++k) out.push_back(rock_of_planes(k, 12));
    return out;
  }();
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> errors;
  for (int k = 0; k < 200; ++k) {
    Rock a, b;
    for (Rock* rock : {&a, &b}) {
      rock->pose.shape = &shapes[random() % shapes.size()];
      rock->pose.turn = random_turn(random);
      rock->inertia = rock->pose.shape->inertia;
    }
    const Vec3 direction = random_direction(random);
    bring_to_overlap(a.pose, b.pose, direction, 1e-9);
    const Vec3 aim =
        (direction + 0.3 * Vec3(unit(random), unit(random), unit(random))).normalized();
    b.velocity = -setup.overlap * std::sqrt(0.5) * aim;
    a.velocity = -b.velocity;
    // Contact begins anywhere within a step.
    const double step = kPi * std::sqrt(0.5) / setup.steps, phase = 0.5 * (1 + unit(random));
    a.pose.place -= phase * step * a.velocity;
    b.pose.place -= phase * step * b.velocity;
    const Collision c = collide(a, b, setup);
    EXPECT_TRUE(c.ended);
    EXPECT_LE(c.momentum, 1e-13);
    EXPECT_LE(c.angular, 1e-12);
    errors.push_back(c.energy_error);
  }
  std::sort(errors.begin(), errors.end());
  return {errors[100], errors[180]};
}

class ElasticCollision : public testing::TestWithParam<OverlapMeasure> {};

// The limits are what the definition costs (a model error in proportion to the overlap), measured
// with an independent program; nothing of it depends on the step.
TEST_P(ElasticCollision, ChangesEnergyInProportionToTheOverlapOnly) {
  const PatchOptions options{GetParam(), NormalModel::kStiffness};
  const Figures deep = collisions({1e-2, 100, options}),
                deep_fine = collisions({1e-2, 200, options});
  EXPECT_LE(deep.median, 1.2e-2);
  EXPECT_LE(deep.p90, 6e-2);
  EXPECT_NEAR(deep.median, deep_fine.median, 0.1 * deep_fine.median);
  const Figures light = collisions({1e-3, 100, options}),
                light_fine = collisions({1e-3, 200, options});
  EXPECT_LE(light.median, 1.0e-3);
  EXPECT_LE(light.p90, 6e-3);
  EXPECT_NEAR(light.median, light_fine.median, 0.1 * light_fine.median);
  std::printf("1e-2: %.2e %.2e (Tc/200 %.2e), 1e-3: %.2e %.2e (Tc/200 %.2e)\n", deep.median,
              deep.p90, deep_fine.median, light.median, light.p90, light_fine.median);
}

INSTANTIATE_TEST_SUITE_P(Overlap, ElasticCollision,
                         testing::Values(OverlapMeasure::kChord, OverlapMeasure::kWidth));

TEST(ElasticCollisionOfVolumes, KeepsEnergyToTheOrderOfTheStep) {
  const PatchOptions options{OverlapMeasure::kChord, NormalModel::kVolume};
  const Figures coarse = collisions({1e-2, 100, options}), fine = collisions({1e-2, 200, options});
  EXPECT_LE(coarse.median, 1e-5);
  EXPECT_LE(6 * fine.median, coarse.median);
  std::printf("volume: %.2e (Tc/200 %.2e)\n", coarse.median, fine.median);
}

}  // namespace
}  // namespace quern
