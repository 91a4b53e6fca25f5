// Wear in whole steps of the engine, against hand calculations by the engine's own discrete scheme.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/laws/damping.h"
#include "kernels/wear_report.h"
#include "tests/support/hashed_runs.h"
#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

constexpr double kRadius = 1.0 / 128, kGravity = 9.81, kDt = 1e-6, kPressure = 5e9;
const double kMass = sphere_mass(2 * kRadius);

WearSpec wear_spec() {
  WearSpec wear;
  wear.cell_size = 0.01;
  wear.flow_pressure = kPressure;
  wear.archard_coefficient = 1e-3;
  return wear;
}

Scene plate(const Law& law, const Vec3& gravity) {
  Scene scene = small_scene(law, kDt, 0.25);
  scene.run.gravity = gravity;
  scene.wear = wear_spec();
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  return scene;
}

// On the plate, at the overlap at which it rests.
Scene resting(const Law& law, const Vec3& velocity, const Vec3& spin) {
  Scene scene = plate(law, {0, 0, -kGravity});
  const double zeta = damping_ratio(law.restitution, law.normal_force);
  const double soft = 1 + zeta * std::sqrt(law.kn / kMass) * kDt;
  add_sphere(scene, 2 * kRadius, {0.0625, 0.03125, kRadius - kMass * kGravity * soft / law.kn},
             velocity, spin);
  return scene;
}

World<double> recording_world(const Scene& scene,
                              const std::vector<std::vector<Triangle>>& meshes = {}) {
  World<double> world = world_of<double>(scene, meshes);
  world.wear.recording = true;
  return world;
}

WearRow wall_total(const World<double>& world) { return world.wear.total_of(world.wear.walls, 0); }

WearRow sum_of_cells(const World<double>& world) {
  WearRow sum{};
  for (std::size_t c = 0; c < world.wear.cell_count(); ++c) {
    const WearRow row = world.wear.total_of(world.wear.cells, c);
    for (std::size_t k = 0; k < kWearSums; ++k) sum[k] += row[k];
  }
  return sum;
}

TEST(Wear, OfASphereThatSlidesIsFrictionTimesTheWayItSlips) {
  const Law law;
  const double v0 = 1, force = kMass * kGravity, friction = law.sliding * force;
  World<double> world = recording_world(resting(law, {v0, 0, 0}, Vec3::Zero()));
  Stepper<double> stepper(world, 1);
  constexpr int kSteps = 10000;
  run_steps(world, stepper, kSteps);
  // Step n has the velocities of n - 1/2, the first those of the start; the rim of the sphere comes
  // up to the centre's velocity by 5/2 of what the centre loses.
  const double slows = law.sliding * kGravity * 3.5;
  double slip = 0;
  for (int n = 0; n < kSteps; ++n) slip += kDt * (v0 - slows * (n == 0 ? 0 : (n - 0.5) * kDt));
  const WearRow sum = wall_total(world);
  EXPECT_NEAR(sum[kSiemEnergy] / (friction * slip), 1, 1e-6);
  EXPECT_NEAR(sum[kArchardWork] / (force * slip), 1, 1e-6);
  EXPECT_NEAR(sum[kNormalImpulse] / (force * kSteps * kDt), 1, 1e-6);
  EXPECT_NEAR(sum[kShearImpulse] / (friction * kSteps * kDt), 1, 1e-6);
  EXPECT_EQ(sum[kFinnieEnergy], 0);  // it lay there
  // What sliding dissipates lacks what the first step put into the spring.
  EXPECT_NEAR(sum[kSlidingEnergy] / world.ledger.slide, 1, 0.01);  // the ledger opens a step later
  EXPECT_NEAR(sum[kSlidingEnergy] / sum[kSiemEnergy], 1, 1e-3);
  EXPECT_NEAR(world.wear.time[0], kSteps * kDt, 1e-12);
  const WallWear floor = wall_wear(world, plate(law, Vec3::Zero()), 0);
  EXPECT_NEAR(floor.total()[kSiemEnergy] / (friction * slip / (4 * kPressure)), 1, 1e-6);
}

TEST(Wear, IsNoneOfSiemWhereSpinDrivesTheSphere) {
  const Law law;
  // Spin about +y carries the rim to -x: friction drives the centre towards +x.
  World<double> world = recording_world(resting(law, Vec3::Zero(), {0, 200, 0}));
  Stepper<double> stepper(world, 1);
  run_steps(world, stepper, 5000);
  ASSERT_GT(velocity_of(world, 0).x(), 0.01);
  const WearRow sum = wall_total(world);
  EXPECT_EQ(sum[kSiemEnergy], 0);
  EXPECT_GT(sum[kSlidingEnergy], 0);
  EXPECT_GT(sum[kArchardWork], 0);
}

// One hit by the scheme of kernels/README.md, in the plane of motion; it sticks or slides.
struct Hit {
  double siem = 0, slide = 0, archard = 0;
  Hit(const Law& law, double gap, double vx, double vz) {
    const double zeta = damping_ratio(law.restitution, law.normal_force);
    const double inertia = 0.4 * kMass * kRadius * kRadius, mt = 2.0 / 7 * kMass;
    const double cn = 2 * zeta * std::sqrt(kMass * law.kn), ct = 2 * zeta * std::sqrt(mt * law.kt);
    const double kn = law.kn / (1 + kDt * cn / (2 * kMass));
    const double kt = law.kt / (1 + kDt * ct / (2 * mt));
    const double bn = cn / (1 + kDt * cn / (2 * kMass)), bt = ct / (1 + kDt * ct / (2 * mt));
    double z = kRadius + gap, spin = 0, spring = 0, old_spring = 0;  // spin about +y
    bool open = false;
    for (int n = 0; n < 2000; ++n) {
      const double overlap = kRadius - z;
      double fx = 0, fz = 0, arm = kRadius - 0.5 * overlap;
      if (overlap > 0) {
        const bool first = vz < 0 && overlap < -vz * kDt;
        const double w = first ? 0.5 + overlap / (-vz * kDt) : 1;
        fz = std::max(0.0, kn * overlap - w * bn * vz);
        const double vt = vx - arm * spin;
        const double trial = spring + vt * kDt, force = -kt * trial - bt * vt;
        const double cap = law.sliding * fz;
        old_spring = spring;
        fx = std::abs(force) > cap ? std::copysign(cap, force) : force;
        spring = kt * std::abs(trial) > cap ? std::copysign(cap / kt, trial) : trial;
        if (std::abs(force) <= cap) spring = trial;
        slide += 0.5 * kt * (old_spring + spring) * (trial - spring);
        if (fx * vt < 0 && fx * vx < 0) siem -= kDt * fx * vt;
        if (std::abs(force) > cap) archard += fz * std::abs(vt) * kDt;
        open = true;
      } else if (open) {
        slide += 0.5 * kt * spring * spring;
        spring = 0;
        open = false;
      }
      vx += kDt * fx / kMass;
      vz += kDt * fz / kMass;
      spin += kDt * (-arm * fx) / inertia;
      z += kDt * vz;
    }
  }
};

TEST(Wear, OfOneObliqueHitIsWhatTheSchemeSays) {
  Law law;
  for (const double angle : {0.2, 0.7, 1.3}) {  // slides through; in part; sticks for long
    const double speed = 2, vx = speed * std::cos(angle), vz = -speed * std::sin(angle);
    const double gap = 0.25 * std::abs(vz) * kDt;
    Scene scene = plate(law, Vec3::Zero());
    add_sphere(scene, 2 * kRadius, {0.0625, 0.03125, kRadius + gap}, {vx, 0, vz});
    World<double> world = recording_world(scene);
    Stepper<double> stepper(world, 1);
    run_steps(world, stepper, 2000);
    ASSERT_GT(velocity_of(world, 0).z(), 0);
    const Hit hit(law, gap, vx, vz);
    const WearRow sum = wall_total(world);
    EXPECT_NEAR(sum[kSiemEnergy] / hit.siem, 1, 1e-6) << angle;
    EXPECT_NEAR(sum[kArchardWork] / hit.archard, 1, 1e-6) << angle;
    EXPECT_NEAR(sum[kSlidingEnergy] / hit.slide, 1, 1e-6) << angle;
    EXPECT_NEAR(world.ledger.slide / hit.slide, 1, 1e-6) << angle;
    const double s = std::sin(angle), c = std::cos(angle);
    const double shape = std::tan(angle) < 1.0 / 3 ? std::sin(2 * angle) - 3 * s * s : c * c / 3;
    EXPECT_NEAR(sum[kFinnieEnergy] / (kMass * speed * speed * shape), 1, 1e-6) << angle;
  }
}

TEST(Wear, CountsFromTheMomentItIsRecorded) {
  const Law law;
  World<double> world = recording_world(resting(law, {1, 0, 0}, Vec3::Zero()));
  world.wear.recording = false;
  Stepper<double> stepper(world, 1);
  run_steps(world, stepper, 100);
  EXPECT_EQ(wall_total(world)[kNormalImpulse], 0);
  world.wear.recording = true;
  run_steps(world, stepper, 50);
  EXPECT_NEAR(wall_total(world)[kNormalImpulse] / (kMass * kGravity * 50 * kDt), 1, 1e-6);
}

// A lab mill at work, and the same with polyhedra.
Scene mill_at_work(bool polyhedra) {
  std::vector<std::string> overrides = {"run.settle=none", "run.tile_size=4"};
  Scene scene = shipped_scene(polyhedra ? "lab_mill" : "lab_mill_spheres", overrides);
  scene.wear = wear_spec();
  scene.wear->cell_size = 0.004;
  return scene;
}

template <class Real>
void record(World<Real>& world, int threads, int steps) {
  world.wear.recording = true;
  Stepper<Real> stepper(world, threads);
  if (threads > 1) stepper.graph().shuffle(7);
  run_steps(world, stepper, steps);
}

bool same_bits(const Column<double>& a, const Column<double>& b) {
  return a.size() == b.size() && std::memcmp(a.raw(), b.raw(), a.size() * sizeof(double)) == 0;
}

class WearOfAMill : public testing::TestWithParam<bool> {};

TEST_P(WearOfAMill, HasTheSameBitsForAnyNumberOfThreadsAndAfterARestart) {
  const Scene scene = mill_at_work(GetParam());
  const StartIn<float> start(scene, 6000);
  const auto world = [&] { return read_state<float>(scene, start.folder.path()); };
  const auto one = world();
  const std::uint64_t physics = [&] {
    const auto silent = world();
    Stepper<float> stepper(*silent, 1);
    run_steps(*silent, stepper, 1500);
    return state_hash(*silent);
  }();
  record(*one, 1, 1500);
  EXPECT_EQ(state_hash(*one), physics) << "recording changed the run";
  ASSERT_GT(one->wear.walls[kSiemEnergy], 0);
  for (const int threads : {2, 3}) {
    const auto other = world();
    record(*other, threads, 1500);
    EXPECT_TRUE(same_bits(one->wear.cells, other->wear.cells)) << threads;
    EXPECT_TRUE(same_bits(one->wear.species, other->wear.species)) << threads;
  }
  // Cells that are known from earlier steps are those that a new stepper finds.
  const auto forgetful = world();
  for (int k = 0; k < 300; ++k) record(*forgetful, 1, 5);
  EXPECT_TRUE(same_bits(one->wear.cells, forgetful->wear.cells));
  const auto stopped = world();
  record(*stopped, 2, 700);
  TempFolder between;
  write_state(*stopped, between.path());
  const auto resumed = read_state<float>(scene, between.path());
  EXPECT_EQ(resumed->wear.time[0], stopped->wear.time[0]);
  record(*resumed, 3, 800);
  EXPECT_TRUE(same_bits(one->wear.cells, resumed->wear.cells));
  EXPECT_TRUE(same_bits(one->wear.walls, resumed->wear.walls));
}

TEST_P(WearOfAMill, CellsWallsAndSpeciesHaveTheSameTotalAndTheLedgersSliding) {
  const Scene scene = mill_at_work(GetParam());
  World<double> world = world_of<double>(scene);
  Stepper<double> stepper(world, 2);
  world.wear.recording = true;
  run_steps(world, stepper, 8000);
  const WearRow cells = sum_of_cells(world);
  for (std::size_t k = 0; k < kWearSums; ++k) {
    double walls = 0, species = 0;
    for (std::size_t w = 0; w < world.walls.size(); ++w) {
      walls += world.wear.total_of(world.wear.walls, w)[k];
    }
    for (std::size_t s = 0; s < scene.particles.size(); ++s) {
      species += world.wear.total_of(world.wear.species, s)[k];
    }
    ASSERT_GT(walls, 0) << k;
    EXPECT_NEAR(cells[k] / walls, 1, 1e-10) << k;
    EXPECT_NEAR(species / walls, 1, 1e-10) << k;
  }
  // Cell by cell: those of a wall sum to the wall.
  for (Index w = 0; w < world.walls.size(); ++w) {
    const WallWear wall = wall_wear(world, scene, w);
    double energy = 0;
    for (const double e : wall.energy) energy += e;
    EXPECT_NEAR(energy / world.wear.total_of(world.wear.walls, w)[kSiemEnergy], 1, 1e-10) << w;
  }
}

INSTANTIATE_TEST_SUITE_P(Charges, WearOfAMill, testing::Bool(), [](const auto& kind) {
  return kind.param ? std::string("WithPolyhedra") : std::string("OfSpheres");
});

// A cube on the plate: its one contact has no history of motion but the start's.
TEST(Wear, OfACubeThatSlidesIsFrictionTimesItsWay) {
  Law law;
  Scene scene = plate(law, {0, 0, -kGravity});
  scene.domain.low = Vec3::Constant(-0.25);
  ParticleSpec& cube = scene.particles[0];
  cube.shape = ShapeKind::kPolyhedron;
  cube.meshes = {QUERN_SOURCE_DIR "/apps/shapes/cube.stl"};
  scene.folder = "";
  const double side = 0.01, diameter = side * std::cbrt(6 / kPi);
  cube.diameter = diameter;
  const double mass = kDensity * side * side * side;
  const double soft =
      1 + damping_ratio(law.restitution, law.normal_force) * std::sqrt(law.kn / mass) * kDt;
  ExplicitParticle one;
  one.position = {0.0625, 0.03125, 0.5 * side - mass * kGravity * soft / law.kn};
  one.velocity = {1, 0, 0};
  one.diameter = diameter;
  one.orientation = Turn{Vec3::UnitZ(), 0};
  cube.explicit_particles.push_back(one);
  World<double> world = recording_world(scene);
  Stepper<double> stepper(world, 1);
  run_steps(world, stepper, 10000);
  // Balance of momentum; the last velocity is half a step old, the first kick was half a step.
  const Vec3 v = world.polyhedra.velocity(0);
  const double time = 10000 * kDt, way = world.polyhedra.place(0).x() - 0.0625;
  const WearRow sum = wall_total(world);
  EXPECT_NEAR(sum[kNormalImpulse] / (mass * (v.z() + kGravity * time)), 1, 1e-6);
  EXPECT_NEAR(sum[kShearImpulse] / (mass * (1 - v.x())), 1, 1e-4);  // first step: half counts
  EXPECT_NEAR(sum[kSiemEnergy] / (law.sliding * mass * kGravity * way), 1, 0.02);
  EXPECT_NEAR(sum[kSlidingEnergy] / sum[kSiemEnergy], 1, 0.02);
  EXPECT_NEAR(sum_of_cells(world)[kSiemEnergy] / sum[kSiemEnergy], 1, 1e-12);
}

TEST(Wear, OfAMeshIsInTheCellsUnderTheTrack) {
  const Law law;
  Scene scene = small_scene(law, kDt, 0.25);
  scene.run.gravity = {0, 0, -kGravity};
  scene.wear = wear_spec();
  Motion motion;
  motion.kind = MotionKind::kTranslation;
  motion.axis = Vec3::UnitY();
  motion.rate.points = {{0, 0.5}};
  add_mesh(scene, "sheet", motion);
  const double zeta = damping_ratio(law.restitution, law.normal_force);
  const double soft = 1 + zeta * std::sqrt(law.kn / kMass) * kDt;
  add_sphere(scene, 2 * kRadius, {0.0125, 0.0125, kRadius - kMass * kGravity * soft / law.kn},
             {1, 0.5, 0});
  const Vec3 a(-0.1, -0.1, 0), b(0.1, -0.1, 0), c(0.1, 0.1, 0), d(-0.1, 0.1, 0);
  World<double> world = recording_world(scene, {{{{a, b, c}}, {{a, c, d}}}});
  Stepper<double> stepper(world, 1);
  run_steps(world, stepper, 20000);
  // In the frame of the sheet the sphere goes along +x, from (0.0125, 0.0125).
  const WallWear sheet = wall_wear(world, scene, 0);
  const double end = place_of(world, 0).x();
  ASSERT_GT(end, 0.025);
  double on_track = 0, all = 0;
  for (std::size_t k = 0; k < sheet.cells.size(); ++k) {
    Vec3 low = sheet.cells[k].corner[0], high = low;
    for (const Vec3& corner : sheet.cells[k].corner) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    all += sheet.energy[k];
    const bool under =
        low.y() <= 0.0126 && high.y() >= 0.0124 && high.x() >= 0.0125 && low.x() <= end + 1e-6;
    if (under) on_track += sheet.energy[k];
  }
  EXPECT_GT(all, 0);
  EXPECT_EQ(on_track, all);
}

}  // namespace
}  // namespace quern::test
