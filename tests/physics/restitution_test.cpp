// The coefficient of restitution that a collision delivers, at any phase of the arrival.
//
// A hundred isolated collisions run side by side in one world; they differ in the share of a step
// that passes before first touch. Sphere against sphere, sphere against wall, and a cube that lands
// flat on a wall (the overlap of a polyhedron is its chord). Three oracles: the coefficient asked
// for (at 50 steps per contact), the discrete scheme of one contact in plain scalar code, which
// every single collision must follow to rounding, and means and standard deviations over a thousand
// phases from an independent program (kTable), which the scheme was chosen by.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "kernels/laws/damping.h"
#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

constexpr double kDiameter = 1.0 / 64;  // m, exact in f32
constexpr double kSpeed = 1;            // m/s, of approach
constexpr int kPhases = 100;

enum class Partner { kSphere, kWall, kCubeOnWall };
constexpr std::array<Partner, 3> kPartners = {Partner::kSphere, Partner::kWall,
                                              Partner::kCubeOnWall};
const char* name_of(Partner partner) {
  return partner == Partner::kSphere ? "spheres" : partner == Partner::kWall ? "wall" : "flat cube";
}

struct Setting {
  double restitution = 0.5, steps_per_contact = 50;
  NormalForce normal_force = NormalForce::kClamped;
  Partner partner = Partner::kSphere;
};

double reduced_mass(Partner partner) {
  return sphere_mass(kDiameter) * (partner == Partner::kSphere ? 0.5 : 1);
}

double step_of(const Setting& s) {
  return normal_contact_time(reduced_mass(s.partner), Law().kn) / s.steps_per_contact;
}

const double kCubeSide = kDiameter * std::cbrt(kPi / 6);  // of the volume of the sphere

void make_cubes(Scene& scene) {
  scene.folder = QUERN_SOURCE_DIR "/apps/shapes";
  scene.contact.overlap = OverlapMeasure::kChord;
  scene.particles[0].name = "cube";
  scene.particles[0].shape = ShapeKind::kPolyhedron;
  scene.particles[0].meshes = {"cube.stl"};
}

// Share of a step between the start and first touch.
double phase(int k) { return (k + 0.5) / kPhases; }

// Every collision of the ensemble as the engine runs it: rebound speed over approach speed.
template <class Real>
std::vector<double> delivered(const Setting& s) {
  Law law;
  law.restitution = s.restitution;
  law.normal_force = s.normal_force;
  const double dt = step_of(s);
  Scene scene = small_scene(law, dt);
  if (s.partner != Partner::kSphere) add_plane(scene, Vec3::Zero(), Vec3::UnitX());
  if (s.partner == Partner::kCubeOnWall) make_cubes(scene);
  for (int k = 0; k < kPhases; ++k) {
    const double y = 0.05 * k - 2.5, gap = phase(k) * kSpeed * dt;
    if (s.partner == Partner::kCubeOnWall) {
      add_sphere(scene, kDiameter, {0.5 * kCubeSide + gap, y, 0}, {-kSpeed, 0, 0});
      scene.particles[0].explicit_particles.back().orientation = Turn{Vec3::UnitX(), 0};
    } else if (s.partner == Partner::kWall) {
      add_sphere(scene, kDiameter, {0.5 * kDiameter + gap, y, 0}, {-kSpeed, 0, 0});
    } else {
      add_sphere(scene, kDiameter, {kDiameter + gap, y, 0}, {-0.5 * kSpeed, 0, 0});
      add_sphere(scene, kDiameter, {0, y, 0}, {0.5 * kSpeed, 0, 0});
    }
  }
  World<Real> world = world_of<Real>(scene);
  Stepper<Real> stepper(world, 1);
  run_steps(world, stepper, static_cast<int>(2.5 * s.steps_per_contact) + 10);
  std::vector<double> rebound;
  for (Index k = 0; k < kPhases; ++k) {
    const Vec3 velocity = s.partner == Partner::kCubeOnWall ? Vec3(world.polyhedra.velocity(k))
                          : s.partner == Partner::kWall
                              ? velocity_of(world, k)
                              : Vec3(velocity_of(world, 2 * k) - velocity_of(world, 2 * k + 1));
    rebound.push_back(velocity.x() / kSpeed);
  }
  return rebound;
}

// The scheme of one isolated contact: implicit midpoint with a share of a dashpot at first touch.
double scheme(const Setting& s, double zeta, double phase_of_arrival) {
  const double m = reduced_mass(s.partner), k = Law().kn, dt = step_of(s);
  const double c = 2 * zeta * std::sqrt(m * k);
  const double bound = 1 + dt * c / (2 * m), kp = k / bound, cp = c / bound;
  const bool clamped = s.normal_force == NormalForce::kClamped;
  double overlap = -phase_of_arrival * kSpeed * dt, closing = kSpeed;
  do {
    double force = 0;
    if (overlap > 0) {
      const bool fresh = closing > 0 && overlap < closing * dt;
      const double share = clamped && fresh ? 0.5 + overlap / (closing * dt) : 1;
      force = kp * overlap + share * cp * closing;
      if (clamped) force = std::max(0.0, force);
    }
    closing -= dt * force / m;
    overlap += dt * closing;
  } while (closing > 0 || overlap > 0);
  return -closing / kSpeed;
}

double zeta_of(const Setting& s) { return damping_ratio(s.restitution, s.normal_force); }

struct Spread {
  double mean = 0, deviation = 0, low = 1e300, high = -1e300;
};

Spread spread_of(const std::vector<double>& e) {
  Spread s;
  for (double v : e) {
    s.mean += v / static_cast<double>(e.size());
    s.low = std::min(s.low, v);
    s.high = std::max(s.high, v);
  }
  for (double v : e) s.deviation += (v - s.mean) * (v - s.mean) / static_cast<double>(e.size());
  s.deviation = std::sqrt(s.deviation);
  return s;
}

template <class Real>
class Restitution : public testing::Test {
 protected:
  static constexpr bool kMixed = sizeof(Real) == 4;
};
TYPED_TEST_SUITE(Restitution, Precisions, Names);

constexpr std::array<double, 5> kAsked = {0.3, 0.5, 0.65, 0.8, 0.9};

TYPED_TEST(Restitution, ClampedAtFiftyStepsIsWhatWasAskedForAtEveryPhase) {
  for (const Partner partner : kPartners) {
    for (const double e : kAsked) {
      const Setting s = {e, 50, NormalForce::kClamped, partner};
      const Spread got = spread_of(delivered<TypeParam>(s));
      // The acceptance limits of the scheme.
      EXPECT_NEAR(got.mean, e, 1e-3) << "e " << e << ", " << name_of(partner);
      EXPECT_GT(got.low, e - 3e-3) << "e " << e << ", " << name_of(partner);
      EXPECT_LT(got.high, e + 3e-3) << "e " << e << ", " << name_of(partner);
    }
  }
}

TYPED_TEST(Restitution, UnclampedAtFiftyStepsIsRightInTheMeanAndWithinHalfAStepOfDamping) {
  for (const Partner partner : kPartners) {
    for (const double e : kAsked) {
      const Setting s = {e, 50, NormalForce::kUnclamped, partner};
      const Spread got = spread_of(delivered<TypeParam>(s));
      EXPECT_NEAR(got.mean, e, 1e-3) << "e " << e;
      // Without the share of first touch, up to half a step too much or too little of the dashpot
      // acts at entry (relative impulse zeta w dt, times e at the exit) and the same at the exit.
      const double half_step = zeta_of(s) * kPi / s.steps_per_contact;
      const double limit = 2 * half_step * e + 1e-3;
      EXPECT_GT(got.low, e - limit) << "e " << e;
      EXPECT_LT(got.high, e + limit) << "e " << e;
    }
  }
}

TYPED_TEST(Restitution, OfEveryCollisionIsThatOfTheDiscreteScheme) {
  // Rounding: the overlap is a difference of coordinates below 3 m, 4 ulp of them (9e-16 m) is
  // 4e-11 of the largest overlap (2e-5 m); near first touch it decides when the contact ends, which
  // is not near a tie at these phases. f32 forces: 2^-24 an operation, about 20 operations a step,
  // 20 steps. The law of polyhedra is f64 in both precisions.
  const double sphere_tolerance = this->kMixed ? 20 * 20 * 6e-8 : 1e-9;
  for (const NormalForce mode : {NormalForce::kClamped, NormalForce::kUnclamped}) {
    for (const Partner partner : kPartners) {
      const double tolerance = partner == Partner::kCubeOnWall ? 1e-9 : sphere_tolerance;
      for (const double steps : {4.4, 10.0, 20.0, 50.0}) {
        for (const double e : {0.3, 0.8}) {
          const Setting s = {e, steps, mode, partner};
          const std::vector<double> got = delivered<TypeParam>(s);
          for (int k = 0; k < kPhases; ++k) {
            EXPECT_NEAR(got[static_cast<std::size_t>(k)], scheme(s, zeta_of(s), phase(k)),
                        tolerance)
                << "e " << e << ", " << steps << " steps, phase " << phase(k) << ", "
                << name_of(partner);
          }
        }
      }
    }
  }
}

// Mean and standard deviation over 1000 phases, clamped.
struct TableRow {
  double e;
  std::array<double, 4> mean, deviation;
  std::array<double, 4> digit;  // half of the last digit given of the mean
};
constexpr std::array<double, 4> kSteps = {4.4, 10, 20, 50};
constexpr std::array<TableRow, 3> kTable = {{
    {0.3, {.323, .303, .3007, .3001}, {.021, .0025, .0006, .0001}, {5e-4, 5e-4, 5e-5, 5e-5}},
    {0.5, {.520, .503, .5005, .5001}, {.023, .004, .0007, .0001}, {5e-4, 5e-4, 5e-5, 5e-5}},
    {0.8, {.806, .801, .8002, .8000}, {.014, .006, .0005, .0002}, {5e-4, 5e-4, 5e-5, 5e-5}},
}};

TYPED_TEST(Restitution, OverStepsPerContactIsThatOfTheTable) {
  std::printf("  %-5s %17s %17s %17s %17s   mean (standard deviation), clamped\n", "e", "4.4 steps",
              "10", "20", "50");
  for (const TableRow& row : kTable) {
    std::printf("  %-5g", row.e);
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
      const Setting s = {row.e, kSteps[k], NormalForce::kClamped, Partner::kSphere};
      const Spread got = spread_of(delivered<TypeParam>(s));
      std::printf("   %.4f (%.4f)", got.mean, got.deviation);
      // 100 phases in place of 1000: the mean of a function with a jump J over the phase is
      // uncertain by J / 100, and J is below the range found.
      const double sampling = (got.high - got.low) / kPhases;
      EXPECT_NEAR(got.mean, row.mean[k], row.digit[k] + sampling) << row.e << " " << kSteps[k];
      // The deviation is given with one or two digits: half a digit of the first is 5 % ... 50 %.
      EXPECT_NEAR(got.deviation, row.deviation[k], row.digit[k] + sampling);
    }
    std::printf("\n");
  }
}

TYPED_TEST(Restitution, OfAnElasticCollisionIsOne) {
  // With no dashpot the scheme is leapfrog; an isolated hit that starts and ends between steps is
  // in error by (w dt)^2 / 8 = 5e-4 of the speed at most at 50 steps.
  for (const Partner partner : kPartners) {
    const Spread got = spread_of(delivered<TypeParam>({1.0, 50, NormalForce::kClamped, partner}));
    EXPECT_GT(got.low, 1 - 5e-4);
    EXPECT_LT(got.high, 1 + 5e-4);
  }
}

TYPED_TEST(Restitution, BelowCriticalDampingClampedDeliversThatOfCriticalDamping) {
  for (const Partner partner : kPartners) {
    for (const double e : {0.01, 0.1}) {
      const Spread got = spread_of(delivered<TypeParam>({e, 50, NormalForce::kClamped, partner}));
      EXPECT_NEAR(got.mean, std::exp(-2.0), 6e-3) << e << ", " << name_of(partner);
      EXPECT_LT(got.high - got.low, 1.2e-2) << e << ", " << name_of(partner);
    }
  }
}

}  // namespace
}  // namespace quern::test
