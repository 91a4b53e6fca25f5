// Polyhedra at rest, sliding, stacked: geometry, law and rotation together in a plain integrator.
//
// Units: cubes of side 1 and mass 1, gravity 1, kn = 1e4, so that a cube at rest overlaps by 1e-4;
// 25 steps per contact, restitution 0.5 (zeta 0.2553, clamped), friction 0.5.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/laws/patch_damping.h"
#include "kernels/pairs/polyhedron_facet.h"
#include "kernels/rotate.h"
#include "tests/support/patch_law.h"
#include "tests/support/test_shapes.h"

namespace quern::test {
namespace {

struct Solid {
  ShapePose pose;
  Quat orientation = Quat::Identity();
  Vec3 velocity = Vec3::Zero(), momentum = Vec3::Zero();
  Vec3 inertia = Vec3::Constant(1.0 / 6);
  double contacts = 0;
  law::History wall, below;

  Vec3 inverse_inertia() const { return inverse_inertia_of(inertia); }
  Vec3 spin() const { return spin_of(orientation, momentum, inverse_inertia()); }
  law::Body body() const {
    return {pose.place, velocity, spin(), 1.0, inverse_inertia().maxCoeff(), contacts};
  }
};

constexpr double kStiffness = 1e4;
constexpr double kStaticOverlap = 1e-4;

law::Constants constants(bool patch_damping) {
  const double dt = kPi * std::sqrt(1 / kStiffness) / 25;
  return {kStiffness, 0.4 * kStiffness, 0.2553, 0.2553, 0.5, dt, patch_damping};
}

// Solids on one another, in order from the plate up; leapfrog with a first kick of half a step.
class Stack {
 public:
  Stack(const Facets& plate, const law::Constants& law, const Vec3& gravity)
      : plate_(plate), law_(law), gravity_(gravity) {}

  void add(const Solid& solid) { solids_.push_back(solid); }
  const Solid& operator[](std::size_t k) const { return solids_[k]; }
  double dt() const { return law_.dt; }
  void set_gravity(const Vec3& gravity) { gravity_ = gravity; }

  void step() {
    std::vector<Vec3> force(solids_.size(), Vec3::Zero()), torque = force;
    std::vector<double> contacts(solids_.size(), 0);
    touch_plate(force[0], torque[0], contacts[0]);
    for (std::size_t k = 1; k < solids_.size(); ++k) touch_below(k, force, torque, contacts);
    const double kick = started_ ? law_.dt : 0.5 * law_.dt;
    started_ = true;
    for (std::size_t k = 0; k < solids_.size(); ++k) {
      Solid& s = solids_[k];
      s.velocity += kick * (force[k] + gravity_);
      s.momentum += kick * torque[k];
      s.pose.place += law_.dt * s.velocity;
      s.orientation = rotate_freely(s.orientation, s.momentum, s.inverse_inertia(), law_.dt);
      s.pose.turn = s.orientation.toRotationMatrix();
      s.contacts = contacts[k];
    }
  }

 private:
  void touch_plate(Vec3& force, Vec3& torque, double& contacts) {
    Solid& s = solids_[0];
    candidates_.clear();
    find_facets(plate_, s.pose.place, s.pose.scale * s.pose.shape->bound_radius, candidates_);
    WallPatch patch;
    if (polyhedron_facet_touches(plate_, s.pose, candidates_, {}, &patch, 1) == 0) {
      s.wall.open = false;
      return;
    }
    const law::Response r = law::respond(
        law_, s.body(), {}, {patch.normal, patch.point, patch.overlap, patch.area}, s.wall);
    force += r.force;
    torque += r.torque_i;
    contacts += 1;
  }

  void touch_below(std::size_t k, std::vector<Vec3>& force, std::vector<Vec3>& torque,
                   std::vector<double>& contacts) {
    Solid &upper = solids_[k], &lower = solids_[k - 1];
    std::vector<Plane> planes = planes_of(*lower.pose.shape);
    for (Plane& p : planes) {  // of the lower solid, in body units of the upper
      const Vec3 n = lower.pose.turn * p.normal;
      const double offset =
          p.offset * lower.pose.scale + n.dot(lower.pose.place - upper.pose.place);
      p = {upper.pose.turn.transpose() * n, offset / upper.pose.scale};
    }
    PlaneOverlap found;
    if (!intersect_with_planes(*upper.pose.shape, planes, {}, found)) {
      upper.below.open = false;
      return;
    }
    const double scale = upper.pose.scale;
    const law::Touch touch{-(upper.pose.turn * found.normal), point_of(upper.pose, found.centroid),
                           found.overlap * scale, found.vector_area.norm() * scale * scale};
    const law::Response r = law::respond(law_, upper.body(), lower.body(), touch, upper.below);
    force[k] += r.force;
    torque[k] += r.torque_i;
    force[k - 1] -= r.force;
    torque[k - 1] += r.torque_j;
    contacts[k] += 1;
    contacts[k - 1] += 1;
  }

  const Facets& plate_;
  law::Constants law_;
  Vec3 gravity_;
  std::vector<Solid> solids_;
  std::vector<Index> candidates_;
  bool started_ = false;
};

Facets wide_plate() {
  const Vec3 a(-20, -20, 0), b(20, -20, 0), c(20, 20, 0), d(-20, 20, 0);
  return facets_of({{{a, b, c}}, {{a, c, d}}}, 5);
}

struct Cube {
  Shape shape = built_box({1, 1, 1});
  double scale = 0.5 / shape.vertex(0).cwiseAbs().maxCoeff();
  Solid at(const Vec3& place, const Quat& q = Quat::Identity()) const {
    Solid s;
    s.pose = {&shape, scale, place, q.toRotationMatrix()};
    s.orientation = q;
    return s;
  }
};

Solid tilted_cube(const Cube& cube, double tilt) {
  const Quat q(Eigen::AngleAxisd(tilt, Vec3(1, 0.4, 0).normalized()));
  Solid s = cube.at(Vec3::Zero(), q);
  s.pose.place.z() = deepest_vertex(s.pose, Vec3::UnitZ(), 0);
  return s;
}

// T13: at rest after 1e5 steps from any tilt, all four corners as deep as m g / kn' says. kn' is kn
// reduced by the implicit damping: kn / (1 + dt c_n / 2), with dt c_n / 2 = zeta pi / 25.
TEST(CubeOnPlate, ComesToRestOnItsFourCorners) {
  const Facets plate = wide_plate();
  const Cube cube;
  ASSERT_NEAR(cube.shape.inertia[0] * cube.scale * cube.scale, 1.0 / 6, 1e-12);
  for (const double tilt : {0.0, 1e-6, 1e-2, 0.3}) {
    Stack world(plate, constants(true), -Vec3::UnitZ());
    world.add(tilted_cube(cube, tilt));
    for (int step = 0; step < 100000; ++step) world.step();
    const Solid& s = world[0];
    EXPECT_LT(s.velocity.norm(), 1e-10) << tilt;
    EXPECT_LT(s.spin().norm(), 1e-10) << tilt;
    std::vector<double> height;
    for (std::size_t k = 0; k < 8; ++k)
      height.push_back(point_of(s.pose, cube.shape.vertex(k)).z());
    std::sort(height.begin(), height.end());
    const double overlap = kStaticOverlap * (1 + 0.2553 * kPi / 25);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(height[k] / overlap, -1, 1e-6) << tilt;
  }
}

// Without the moments of the patch: rocking for ever, but bounded. This documents the literal law.
TEST(CubeOnPlate, RocksWithoutPatchDamping) {
  const Facets plate = wide_plate();
  const Cube cube;
  for (const double tilt : {1e-2, 0.3}) {
    Stack world(plate, constants(false), -Vec3::UnitZ());
    world.add(tilted_cube(cube, tilt));
    double most = 0;
    for (int step = 0; step < 100000; ++step) {
      world.step();
      if (step >= 90000) most = std::max(most, world[0].spin().norm());
    }
    EXPECT_LE(most, 5e-2) << tilt;
    EXPECT_GT(most, 1e-4) << tilt;
  }
}

// A solid on an incline that is raised from flat to its slope (by turning gravity) over `rise`
// steps.
struct Incline {
  Facets plate = wide_plate();
  Stack world;
  double angle;
  int rise, steps = 0;

  Incline(double slope, int rise_steps)
      : world(plate, constants(true), Vec3::Zero()), angle(std::atan(slope)), rise(rise_steps) {}
  void run(int count) {
    for (int k = 0; k < count; ++k) {
      ++steps;
      const double now = angle * std::min(1.0, steps / (rise + 1.0));
      world.set_gravity(Vec3(std::sin(now), 0, -std::cos(now)));
      world.step();
    }
  }
  const Solid& solid() const { return world[0]; }
};

// At rest friction is the spring's alone, m g sin(a) / kt'; kt' is kt reduced like kn, with
// dt c_t / (2 m_t) = zeta dt sqrt(kt / m_t). The lever of m_t is that of the centroid.
void expect_stuck(const Incline& incline) {
  const Solid& s = incline.solid();
  EXPECT_LT(s.velocity.norm(), 1e-10);
  EXPECT_LT(s.spin().norm(), 1e-10);
  const law::Constants k = constants(true);
  WallPatch patch;
  std::vector<Index> candidates;
  find_facets(incline.plate, s.pose.place, 1, candidates);
  ASSERT_EQ(polyhedron_facet_touches(incline.plate, s.pose, candidates, {}, &patch, 1), 1);
  const double lever2 = (patch.point - s.pose.place).squaredNorm();
  const double mobility = 1 + lever2 * s.inverse_inertia().maxCoeff();
  const double kt = k.kt / (1 + k.zeta_t * k.dt * std::sqrt(k.kt * mobility));
  EXPECT_NEAR(s.wall.spring.x() * kt / std::sin(incline.angle), 1, 1e-8);
  // Weight and friction pass through the contact point.
  EXPECT_NEAR(patch.point.x() - s.pose.place.x(),
              std::tan(incline.angle) * (s.pose.place.z() - patch.point.z()), 1e-8);
}

TEST(CubeOnIncline, SticksUpToTheAngleOfFriction) {
  const Cube cube;
  for (const double slope : {0.1, 0.3, 0.4, 0.5 * (1 - 1e-3)}) {
    SCOPED_TRACE(slope);
    Incline incline(slope, 32000);
    incline.world.add(cube.at(Vec3(-10, 0, 0.5 - kStaticOverlap)));
    incline.run(60000);
    expect_stuck(incline);
    EXPECT_LT(incline.solid().pose.place.x() + 10, 2 * kStaticOverlap);
  }
}

// The law has one spring in a centroid that wanders as the cube rocks: no potential. Loaded at
// once, a cube still comes to rest where the whole face stays down (slope under 1/3, the centroid
// within the middle third); above, it rocks on, half of it in the air, and creeps. This documents
// the law.
TEST(CubeOnIncline, LoadedAtOnceSticksWhereTheFaceStaysDownAndCreepsAbove) {
  const Cube cube;
  for (const double slope : {0.1, 0.3, 0.4}) {
    SCOPED_TRACE(slope);
    Incline incline(slope, 0);
    incline.world.add(cube.at(Vec3(-10, 0, 0.5 - kStaticOverlap)));
    incline.run(16000);
    const double crept = incline.solid().pose.place.x() + 10;
    if (slope < 1.0 / 3) {
      expect_stuck(incline);
      EXPECT_LT(crept, 5 * kStaticOverlap);
    } else {
      EXPECT_GT(crept, 100 * kStaticOverlap);
      EXPECT_LT(crept, 0.2);  // free sliding without friction would go 75
    }
  }
}

// A flat box, whose face stays down while it slides; 1e-3 of gravity is what its rocking leaves.
TEST(BoxOnIncline, SticksBelowAndSlidesAboveTheAngleOfFriction) {
  const Shape shape = built_box({1, 1, 0.25});
  const double scale = std::cbrt(0.25 * 3 / (4 * kPi));
  // Principal axes may be permuted: the thin side goes down.
  Eigen::Index thin = 0;
  Vec3 extent = Vec3::Zero();
  for (std::size_t k = 0; k < shape.vertices; ++k) extent = extent.cwiseMax(shape.vertex(k));
  extent.minCoeff(&thin);
  const Quat q = Quat::FromTwoVectors(Vec3::Unit(thin), Vec3::UnitZ());
  for (const double slope : {0.5 * (1 - 1e-3), 0.5 * (1 + 1e-3), 0.55, 0.7, 1.0}) {
    SCOPED_TRACE(slope);
    Incline incline(slope, slope < 0.5 ? 16000 : 0);
    Solid s;
    s.pose = {&shape, scale, Vec3(-19, 0, 0.125 - kStaticOverlap), q.toRotationMatrix()};
    s.orientation = q;
    s.inertia = scale * scale * shape.inertia;
    incline.world.add(s);
    incline.run(slope < 0.5 ? 40000 : 2000);
    const double before = incline.solid().velocity.x();
    incline.run(4000);
    const double gain = (incline.solid().velocity.x() - before) / (4000 * incline.world.dt());
    const double expected = std::sin(incline.angle) - 0.5 * std::cos(incline.angle);
    if (slope < 0.5) {
      expect_stuck(incline);
    } else {
      EXPECT_NEAR(gain, expected, 1e-3);
    }
  }
}

// Two cubes, exactly aligned and shifted by 1e-12: flush sides must not change the force.
TEST(TwoCubes, SettleAtTheSameHeightAlignedOrShiftedByNothing) {
  const Facets plate = wide_plate();
  const Cube cube;
  std::vector<double> height;
  for (const double shift : {0.0, 1e-12, -1e-12}) {
    Stack world(plate, constants(true), -Vec3::UnitZ());
    world.add(cube.at(Vec3(0, 0, 0.5)));
    world.add(cube.at(Vec3(shift, shift, 1.5)));
    for (int step = 0; step < 40000; ++step) world.step();
    EXPECT_LT(world[1].velocity.norm(), 1e-9) << shift;
    EXPECT_LT(world[1].spin().norm(), 1e-9) << shift;
    height.push_back(world[1].pose.place.z());
  }
  EXPECT_NEAR(height[1], height[0], 1e-3 * kStaticOverlap);
  EXPECT_NEAR(height[2], height[0], 1e-3 * kStaticOverlap);
  // Two weights on the plate, one between the cubes; dt c_n / 2 is zeta pi / 25 over sqrt(m_e / m).
  const double reduced = 0.2553 * kPi / 25;
  const double expected = 1.5 - kStaticOverlap * (2 * (1 + reduced) + 1 + reduced * std::sqrt(2.0));
  EXPECT_NEAR(height[0], expected, 1e-3 * kStaticOverlap);
}

// The moments by themselves.
TEST(PatchDamping, OpposesTheSpinAndNeverMakesItLarger) {
  Random random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 n = random.in_cube(1).normalized(), spin = random.in_cube(1);
    const double inverse = std::pow(10.0, random(-2, 6)), contacts = random(0, 12);
    const PatchDashpot dashpot{std::pow(10.0, random(-2, 6)), std::pow(10.0, random(-2, 6)), 0.5,
                               patch_mobility(inverse, contacts, 0, 0), 1e-3};
    const Vec3 m = patch_moment(dashpot, n, spin, random(0, 1), HUGE_VAL);
    EXPECT_LE(m.dot(spin), 0);
    // All contacts with this moment: they change the spin by at most twice its size.
    const double count = std::max(1.0, contacts);
    const Vec3 drill = n.dot(m) * n;
    EXPECT_LE(count * inverse * 1e-3 * drill.norm(), 2 * std::abs(n.dot(spin)) * (1 + 1e-12));
    EXPECT_LE(count * inverse * 1e-3 * (m - drill).norm(),
              2 * (spin - n.dot(spin) * n).norm() * (1 + 1e-12));
  }
}

TEST(PatchDamping, IsThatOfADiscOfDashpotsUpToItsLimits) {
  const double area = 0.3, force = 2, radius = std::sqrt(area / kPi);
  const Vec3 n = Vec3::UnitZ(), spin(0.3, -0.2, 0.7);
  const PatchDashpot dashpot{5, 3, 0.5, 0, 1e-3};
  const Vec3 slow = patch_moment(dashpot, n, 1e-3 * spin, area, force);
  // Integrals over a disc by rings: y^2 per area gives A / (4 pi) and r^2 gives A / (2 pi).
  double rock = 0, drill = 0;
  for (int k = 0; k < 1000; ++k) {
    const double r = radius * (k + 0.5) / 1000, ring = 2 * kPi * r * radius / 1000;
    rock += 5 / area * ring * 0.5 * r * r;
    drill += 3 / area * ring * r * r;
  }
  EXPECT_LT((slow + 1e-3 * Vec3(rock * 0.3, rock * -0.2, drill * 0.7)).norm(), 1e-9);
  const Vec3 fast = patch_moment(dashpot, n, 1e6 * spin, area, force);
  EXPECT_NEAR(fast.head<2>().norm(), 0.5 * force * radius, 1e-12);
  EXPECT_NEAR(fast.z(), -2.0 / 3 * 0.5 * force * radius, 1e-12);
  EXPECT_EQ(patch_moment(dashpot, n, spin, 0, force), Vec3::Zero());
  EXPECT_EQ(patch_moment(dashpot, n, Vec3::Zero(), area, force), Vec3::Zero());
  // An unclamped contact pulls at its end; the patch must neither drive the spin nor divide by
  // zero.
  EXPECT_EQ(patch_moment(dashpot, n, spin, area, -force), Vec3::Zero());
  EXPECT_EQ(patch_moment(dashpot, n, Vec3::Zero(), area, -force), Vec3::Zero());
}

}  // namespace
}  // namespace quern::test
