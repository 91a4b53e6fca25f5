// The account of energy and momentum of a running engine.
//
// Bookkeeping: walls' and gravity's work against stored and dissipated energy. Accuracy: the part
// of the dissipation that is error of the step falls as dt^2. Conservation: momentum always, energy
// without damping and friction. Symmetries: the same scene moved, turned, mirrored, relabelled.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/tally.h"
#include "tests/support/small_scene.h"
#include "tests/support/test_walls.h"

namespace quern::test {
namespace {

constexpr double kRadius = 1.0 / 128;

template <class Real>
class Account : public testing::Test {};
TYPED_TEST_SUITE(Account, Precisions, Names);
template <class Real>
class Symmetry : public testing::Test {};
TYPED_TEST_SUITE(Symmetry, Precisions, Names);

TYPED_TEST(Account, OfALabMillClosesAndItsPartsAreWhatTheySay) {
  Scene scene = shipped_scene("lab_mill_spheres", {"run.settle=none"});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  run_until(world, stepper, 0.3);
  const Ledger& l = world.ledger;
  std::printf("  error %.2g, numerical loss %.2g of %.3g J dissipated\n", ledger_error(l),
              numerical_loss_share(l), l.dissipated());
  // The limits that a run is held to.
  EXPECT_LT(ledger_error(l), sizeof(TypeParam) == 4 ? 1e-3 : 1e-4);
  EXPECT_GT(l.gravity_work, 0);
  EXPECT_GT(l.slide, 0);
  EXPECT_GT(l.tangential_damping, 0);
  EXPECT_GT(l.normal_damping(), 0);
  EXPECT_GT(l.dissipated(), 0.01);
  EXPECT_LT(numerical_loss_share(l), 0.05);
}

// A charge that falls under the drag of settling. The drag acts between a step's kick and its drift, and
// the account values forces by the velocity after it: it closes to drag x dt, here 1.2e-4.
TYPED_TEST(Account, NamesWhatTheDragOfSettlingTakes) {
  World<TypeParam> world =
      world_of<TypeParam>(shipped_scene("lab_mill_spheres", {"run.settle=none"}));
  world.moving_walls = false;
  world.drag = std::exp(-12 * world.clock.dt);
  Stepper<TypeParam> stepper(world, 1);
  run_until(world, stepper, 0.3);
  const Ledger& l = world.ledger;
  std::printf("  error %.2g; drag %.3g J of gravity's %.3g J\n", ledger_error(l), l.drag_loss,
              l.gravity_work);
  EXPECT_GT(l.drag_loss, 0.1 * l.gravity_work);
  EXPECT_LT(ledger_error(l), 1.2e-4);
}

// Collisions at random phases and angles: loss that is error of the step, over what came in.
template <class Real>
double loss_at(double steps_per_contact) {
  Law law;
  law.restitution = 0.8;
  const double contact = normal_contact_time(0.5 * sphere_mass(2 * kRadius), law.kn);
  const double dt = contact / steps_per_contact;
  Scene scene = small_scene(law, dt);
  Random random(5);
  for (int k = 0; k < 400; ++k) {
    const Vec3 place(0.1 * (k % 20) - 1, 0.1 * (k / 20) - 1, 0);  // NOLINT: rows of twenty
    const Vec3 line = (random.turn() * Vec3::UnitX()).eval();
    const double speed = random(0.5, 2), wait = random(0, 1) * contact;
    const Vec3 side = line.unitOrthogonal() * random(0, 0.5);
    const Vec3 velocity = -speed * (line + side);
    add_sphere(scene, 2 * kRadius, place);
    add_sphere(scene, 2 * kRadius, place + 2 * kRadius * line - wait * velocity, velocity);
  }
  World<Real> world = world_of<Real>(scene);
  Stepper<Real> stepper(world, 1);
  run_until(world, stepper, 3 * contact);
  return world.ledger.numerical_loss / world.ledger.start_kinetic;
}

TYPED_TEST(Account, NumericalLossFallsWithTheSquareOfTheStep) {
  const double coarse = loss_at<TypeParam>(20), middle = loss_at<TypeParam>(40);
  const double fine = loss_at<TypeParam>(80);
  std::printf("  share of the energy: %.3g, %.3g, %.3g at 20, 40, 80 steps per contact\n", coarse,
              middle, fine);
  // 400 phases: the mean of phi - phi^2 and its like is uncertain by 1 / sqrt(400) of itself.
  EXPECT_NEAR(coarse / middle, 4, 0.8);
  EXPECT_NEAR(middle / fine, 4, 0.8);
}

// A contact of two equal spheres, of Hertz' springs at 2 m/s.
double contact_time_of(const Law& law) {
  const double mass = 0.5 * sphere_mass(2 * kRadius);
  if (law.springs == ForceLaw::kLinearSpringDashpot) return normal_contact_time(mass, law.kn);
  return hertz_contact_time(mass, 0.5 * kRadius, hertz_modulus(law.young, law.poisson), 2);
}

const Law kLaws[] = {Law(), hertz_law()};

// A cloud that falls together: no walls, no gravity.
Scene cloud(const Law& law, int per_side) {
  const double dt = contact_time_of(law) / 50;
  Scene scene = small_scene(law, dt);
  Random random(11);
  const double pitch = 2.2 * kRadius;
  const double middle = 0.5 * (per_side - 1) * pitch;
  for (int k = 0; k < per_side * per_side * per_side; ++k) {
    const Vec3 cell(k % per_side, k / per_side % per_side, k / per_side / per_side);
    const Vec3 place = pitch * cell - Vec3::Constant(middle) + random.in_cube(0.04 * pitch);
    add_sphere(scene, 2 * kRadius, place, -20 * place + random.in_cube(0.5), random.in_cube(50));
  }
  return scene;
}

TYPED_TEST(Account, PairForcesSumToZero) {
  World<TypeParam> world = world_of<TypeParam>(cloud(Law(), 6));
  Stepper<TypeParam> stepper(world, 1);
  stepper.step();
  const auto momentum = [&] {
    const auto& p = world.totals.momentum;
    return Vec3(p[0], p[1], p[2]);
  };
  const Vec3 start = momentum();
  double speeds = 0, contacts = 0;
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    speeds += std::abs(world.particles.record[k].vx) / world.particles.traits[k].inverse_mass;
  }
  const int steps = 3000;
  for (int k = 0; k < steps; ++k) {
    stepper.step();
    contacts += world.totals.pair_contacts;
  }
  ASSERT_GT(contacts, 10000);
  // Kicks are opposite to the bit; velocities round once a contact and step, at random: half an ulp
  // of m v times the root of their number, here doubled; sums over the cloud round to n ulp.
  const double ulp = 1.2e-16, each = speeds / static_cast<double>(world.particles.size());
  EXPECT_LT((momentum() - start).norm(), 2 * ulp * each * std::sqrt(contacts) + 216 * ulp * speeds);
}

template <class Real>
double kinetic_energy(const World<Real>& world) {
  double sum = 0;
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    const Record<Real>& r = world.particles.record[k];
    const double mass = 1 / static_cast<double>(world.particles.traits[k].inverse_mass);
    const double v2 = r.vx * r.vx + r.vy * r.vy + r.vz * r.vz;
    const Vec3 w(world.particles.spin_x[k], world.particles.spin_y[k], world.particles.spin_z[k]);
    const double radius = static_cast<double>(r.radius);
    sum += 0.5 * mass * (v2 + 0.4 * radius * radius * w.squaredNorm());
  }
  return sum;
}

TYPED_TEST(Account, DissipationIsTheKineticEnergyThatIsMissing) {
  for (Law law : kLaws) {
    law.restitution = 0.8;
    law.rolling = 0.02;
    World<TypeParam> world = world_of<TypeParam>(cloud(law, 4));
    Stepper<TypeParam> stepper(world, 1);
    const double before = kinetic_energy(world);
    int quiet = 0;  // steps since the last contact
    while (quiet < 3000 && world.clock.step < 200000) {
      stepper.step();
      quiet = world.totals.pair_contacts > 0 ? 0 : quiet + 1;
    }
    ASSERT_EQ(world.ledger.elastic, 0);
    const double missing = before - kinetic_energy(world);
    ASSERT_GT(missing, 0.3 * before);
    // The account is exact for the leapfrog: rounding of forces, 6e-8 and 1e-16, and of sums.
    const double limit = sizeof(TypeParam) == 4 ? 1e-6 : 1e-12;
    EXPECT_NEAR(world.ledger.dissipated() / missing, 1, limit);
  }
}

TYPED_TEST(Account, EnergyIsConservedWithoutDampingAndFriction) {
  for (Law law : kLaws) {
    law.restitution = 1;
    law.sliding = 0;
    World<TypeParam> world = world_of<TypeParam>(cloud(law, 6));
    Stepper<TypeParam> stepper(world, 1);
    double worst = 0, most_elastic = 0;
    stepper.step();
    const double start = world.ledger.kinetic + world.ledger.elastic;
    for (int k = 0; k < 3000; ++k) {
      stepper.step();
      const double now = world.ledger.kinetic + world.ledger.elastic;
      worst = std::max(worst, std::abs(now / start - 1));
      most_elastic = std::max(most_elastic, world.ledger.elastic / start);
    }
    ASSERT_GT(most_elastic, 0.01);
    // K is the product of the half steps' velocities: exact for the leapfrog up to (w dt)^2 / 8 of
    // the energy in springs; entry and exit cost (w dt)^2 / 12 each of a contact's energy, and
    // every sphere has a few contacts one after another: 4 (w dt)^2 with w dt = pi / 50.
    EXPECT_LT(worst, 4 * std::pow(kPi / 50, 2));
  }
}

// A few bodies that hit each other and a plate at once; enough contacts for everything the law has.
struct Body3 {
  double diameter;
  Vec3 place, velocity, spin;
};
std::vector<Body3> cluster() {
  const double d = 2 * kRadius;
  return {{d, {0, 0, 0.501 * d}, {0.3, 0.1, -1}, {20, -30, 40}},
          {d, {1.01 * d, 0.1 * d, 0.502 * d}, {-1, 0, -0.5}, {-60, 10, 5}},
          {2 * d, {0.3 * d, 1.52 * d, 1.0 * d + 1e-6}, {0, -1.5, -0.2}, {0, 0, 80}},
          {d, {0.45 * d, 0.1 * d, 1.4 * d}, {0.1, 0.2, -2}, {5, 6, 7}}};
}

struct Motion3 {
  Mat3 turn = Mat3::Identity();  // may be a reflection
  Vec3 shift = Vec3::Zero();
  std::vector<int> order = {0, 1, 2, 3};
  Law law = {};
};

template <class Real>
std::vector<Body3> run_cluster(const Motion3& m) {
  Law law = m.law;
  law.rolling = 0.05;
  const double dt = contact_time_of(law) / 25;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = m.turn * Vec3(0, 0, -9.81);
  add_mesh(scene, "plate");
  const Vec3 a(-1, -1, 0), b(1, -1, 0), c(1, 1, 0), d(-1, 1, 0);
  std::vector<Triangle> plate = moved({{{a, b, c}}, {{a, c, d}}}, m.turn, m.shift);
  const double handed = m.turn.determinant();
  if (handed < 0) plate = turned_over(plate);
  // Away from the edge between the triangles.
  const Vec3 off(0.3, -0.2, 0);
  for (const int k : m.order) {
    const Body3 body = cluster()[static_cast<std::size_t>(k)];
    add_sphere(scene, body.diameter, m.turn * (body.place + off) + m.shift, m.turn * body.velocity,
               handed * (m.turn * body.spin));
  }
  World<Real> world = world_of<Real>(scene, {plate});
  Stepper<Real> stepper(world, 1);
  double contacts = 0;
  for (int k = 0; k < 400; ++k) {
    stepper.step();
    contacts += world.totals.pair_contacts + world.totals.wall_contacts;
  }
  EXPECT_GT(contacts, 150);
  std::vector<Body3> out(4);
  const Mat3 back = m.turn.transpose();
  for (Index k = 0; k < 4; ++k) {
    const std::size_t body = static_cast<std::size_t>(m.order[k]);
    out[body] = {0, back * (place_of(world, k) - m.shift) - off, back * velocity_of(world, k),
                 handed * (back * spin_of(world, k))};
  }
  return out;
}

// Largest difference: velocities and rim speeds in m/s.
double difference(const std::vector<Body3>& a, const std::vector<Body3>& b) {
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    worst = std::max({worst, (a[k].velocity - b[k].velocity).norm(),
                      kRadius * (a[k].spin - b[k].spin).norm(),
                      (a[k].place - b[k].place).norm() / kRadius});
  }
  return worst;
}

// A few hundred steps with contacts: errors of position (an ulp of 1 m is 2e-16 m) enter forces
// over the overlap (1e-5 m), 2e-11, and grow through some collisions; f32 rounds the parts of a
// turned vector anew, 6e-8 each.
template <class Real>
constexpr double kTurned = sizeof(Real) == 4 ? 1e-5 : 1e-9;

TYPED_TEST(Symmetry, MovingTheSceneMovesTheResult) {
  for (const Law& law : kLaws) {
    Motion3 m;
    m.law = law;
    const auto plain = run_cluster<TypeParam>(m);
    m.shift = {1.25, -2.5, 0.75};
    EXPECT_LT(difference(run_cluster<TypeParam>(m), plain), kTurned<TypeParam>);
  }
}

TYPED_TEST(Symmetry, TurningTheSceneTurnsTheResult) {
  for (const Law& law : kLaws) {
    Motion3 m;
    m.law = law;
    const auto plain = run_cluster<TypeParam>(m);
    Random random(2);
    for (int k = 0; k < 5; ++k) {
      m.turn = random.turn();
      EXPECT_LT(difference(run_cluster<TypeParam>(m), plain), kTurned<TypeParam>);
    }
  }
}

TYPED_TEST(Symmetry, MirroringTheSceneMirrorsTheResult) {
  for (const Law& law : kLaws) {
    Motion3 m;
    m.law = law;
    const auto plain = run_cluster<TypeParam>(m);
    for (const Vec3& mirror : {Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)}) {
      m.turn = mirror.asDiagonal();
      EXPECT_LT(difference(run_cluster<TypeParam>(m), plain), kTurned<TypeParam>);
    }
  }
}

TYPED_TEST(Symmetry, RelabellingSpheresRelabelsTheResult) {
  for (const Law& law : kLaws) {
    Motion3 m;
    m.law = law;
    const auto plain = run_cluster<TypeParam>(m);
    for (const std::vector<int>& order :
         {std::vector<int>{3, 2, 1, 0}, {1, 0, 2, 3}, {2, 0, 3, 1}, {0, 3, 1, 2}}) {
      m.order = order;
      EXPECT_LT(difference(run_cluster<TypeParam>(m), plain), kTurned<TypeParam>);
    }
  }
}

TYPED_TEST(Symmetry, SwappingThePartnersOfAPairSwapsTheResult) {
  // Of two sizes the smaller is the same partner in either order: the same bits. Of equal ones the
  // order decides who is first, so sums round differently: 300 steps, at random, of speeds near 1.
  const double ulp = sizeof(TypeParam) == 4 ? 6e-8 : 1.2e-16;
  for (const double larger : {1.0, 2.0}) {
    const double d = 2 * kRadius, limit = larger > 1 ? 0 : 20 * ulp;
    const double reach = 0.5 * (1 + larger) * d;
    const std::vector<Body3> bodies = {
        {d, {0, 0, 0}, {0.3, 0.1, 0}, {20, -30, 40}},
        {larger * d, {0.8 * reach, 0.601 * reach, 0}, {-1, -1, 0.2}, {0, 9, 9}}};
    std::vector<Body3> results[2];
    for (std::size_t swap = 0; swap < 2; ++swap) {
      Scene scene = small_scene(Law(), 1e-6);
      for (std::size_t k = 0; k < 2; ++k) {
        const Body3& b = bodies[swap == 1 ? 1 - k : k];
        add_sphere(scene, b.diameter, b.place, b.velocity, b.spin);
      }
      World<TypeParam> world = world_of<TypeParam>(scene);
      Stepper<TypeParam> stepper(world, 1);
      run_steps(world, stepper, 300);
      for (Index k = 0; k < 2; ++k) {
        const Index id = swap == 1 ? 1 - k : k;
        results[swap].push_back(
            {0, place_of(world, id), velocity_of(world, id), spin_of(world, id)});
      }
    }
    EXPECT_LE(difference(results[0], results[1]), limit) << "size ratio " << larger;
    EXPECT_GT((results[0][0].velocity - bodies[0].velocity).norm(), 0.1);
  }
}

}  // namespace
}  // namespace quern::test
