// Mills at the ends of what a scene may ask for: 1 km from the origin, centrifuging, full of
// needles and plates, periodic and barely longer than two particles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

#include "kernels/tally.h"
#include "scheduler/check_lists.h"
#include "soa/facets.h"
#include "tests/support/small_scene.h"
#include "tests/support/solids.h"
#include "tests/support/temp_folder.h"

namespace quern::test {
namespace {

template <class Real>
class ExtremeMills : public testing::Test {};
TYPED_TEST_SUITE(ExtremeMills, Precisions, Names);

// The laboratory mill as a mesh about `center`, its spheres where the mill at the origin has them.
struct FarMill {
  Scene scene;
  std::vector<std::vector<Triangle>> mesh;

  explicit FarMill(const Vec3& center) {
    const std::vector<std::string> few = {"run.settle=none", "particles.ball.count=30",
                                          "particles.ore.count=100"};
    const Scene at_origin = shipped_scene("lab_mill_spheres", few);
    const World<double> placed = world_of<double>(at_origin);
    scene = at_origin;
    const MillSpec mill = *scene.mill;
    scene.mill.reset();
    Motion motion;
    motion.kind = MotionKind::kRotation;
    motion.center = center;
    motion.rate = mill.rotation;
    std::vector<Triangle> all = mill_shell(mill, 0, mill.length);
    for (const Triangle& t : mill_ends(mill)) all.push_back(t);
    for (Triangle& t : all) {
      for (Vec3& corner : t.corner) corner += center;
    }
    mesh = {all};
    scene.meshes.push_back({"mill", "", mill.material, 1, motion});
    for (ParticleSpec& species : scene.particles) {
      species.diameter.reset();
      species.count.reset();
    }
    for (Index id = 0; id < placed.particles.size(); ++id) {
      const std::size_t row = row_of(placed, id);
      const double diameter = 2 * placed.particles.record[row].radius;
      scene.particles[placed.particles.species[row]].explicit_particles.push_back(
          {center + place_of(placed, id), Vec3::Zero(), Vec3::Zero(), diameter});
    }
  }
};

// The same physics 100 m and 1 km from the origin: places are rounded to 7e-15 and 6e-14 m there,
// 2000 steps of the fall add up the root of 2000 of these roundings, and the first collisions
// multiply what comes of it by less than a thousand.
TYPED_TEST(ExtremeMills, MoveAlikeAKilometreAway) {
  std::vector<Vec3> at_origin;
  for (const double far : {0.0, 100.0, 1000.0}) {
    const Vec3 center = far * Vec3(0.8, -0.6, 0.3);
    const FarMill mill(center);
    World<TypeParam> world = world_of<TypeParam>(mill.scene, mill.mesh);
    Stepper<TypeParam> stepper(world, 1);
    run_until(world, stepper, 0.02);
    double apart = 0;
    for (Index id = 0; id < world.particles.size(); ++id) {
      const Vec3 x = place_of(world, id) - center;
      if (far == 0) {
        at_origin.push_back(x);
      } else {
        apart = std::max(apart, (x - at_origin[id]).norm());
      }
    }
    std::printf("  %4g m: %.2g m apart after 0.02 s\n", far, apart);
    EXPECT_LE(apart, 1000 * std::sqrt(2000) * 5.7e-17 * far);
  }
}

// Later the charge is chaotic: its power over 0.4 s is the same but for 5 %, three times what
// the scatter of LabMillReference's runs is in that time.
TEST(ExtremeMillsOf, SpheresTakeTheSamePowerAKilometreAway) {
  double power[2];
  for (int k = 0; k < 2; ++k) {
    const FarMill mill(k * 1000 * Vec3(0.8, -0.6, 0.3));
    World<float> world = world_of<float>(mill.scene, mill.mesh);
    Stepper<float> stepper(world, 1);
    run_until(world, stepper, 0.3);
    world.window = Window();
    run_until(world, stepper, 0.7);
    power[k] = world.window.power / world.window.steps;
    EXPECT_LT(ledger_error(world.ledger), 1e-5);
  }
  std::printf("  %.4f W at the origin, %.4f W a kilometre away\n", power[0], power[1]);
  EXPECT_NEAR(power[1] / power[0], 1, 0.05);
}

// At 600 rpm, 8 times the critical speed, the whole charge rides on the shell: it moves with the
// wall, but for what rolls between lifters and swings as gravity turns around it (g / omega, 0.16
// m/s; three of these), and the mill hardly works on it any more: over two whole turns, for within
// one it gives and takes back. At 60 rpm, 78 % of critical, it is thrown. The account closes in
// both.
TEST(ExtremeMillsOf, SpheresCentrifugeAndThrow) {
  for (const double rpm : {60.0, 600.0}) {
    SCOPED_TRACE(rpm);
    World<float> world = world_of<float>(shipped_scene(
        "lab_mill_spheres", {"run.settle=none", "particles.ball.count=20", "particles.ore.count=80",
                             "mill.rotation=" + std::to_string(rpm) + " rpm"}));
    Stepper<float> stepper(world, 1);
    run_until(world, stepper, 0.6);
    const double spun_up = world.ledger.wall_work;
    run_until(world, stepper, 0.8);
    const double omega = rpm * kPi / 30;
    double slip = 0, inmost = 1;
    for (Index id = 0; id < world.particles.size(); ++id) {
      const Vec3 x = place_of(world, id);
      const double r = std::hypot(x.x(), x.y());
      slip = std::max(slip, (velocity_of(world, id) - omega * Vec3(-x.y(), x.x(), 0)).norm());
      inmost = std::min(inmost, r);
    }
    std::printf(
        "  %g rpm: slip %.2g of the shell's speed, nearest to the axis %.3f m; ledger %.1g\n", rpm,
        slip / (0.15 * omega), inmost, ledger_error(world.ledger));
    EXPECT_LT(ledger_error(world.ledger), 1e-5);
    const double work = world.ledger.wall_work - spun_up;
    if (rpm > 100) {
      EXPECT_LT(slip, 3 * 9.81 / omega);
      EXPECT_GT(inmost, 0.15 - 0.01 - 2.5 * 0.018);
      EXPECT_LT(std::abs(work), 0.01 * spun_up);
    } else {
      EXPECT_GT(slip, 0.5 * 0.15 * omega);
      EXPECT_LT(inmost, 0.1);
      EXPECT_GT(work, 0.05 * spun_up);
    }
  }
}

void write_stl(const std::string& path, const Triangles& solid) {
  std::ofstream out(path);
  out << "solid s\n";
  for (const Triangle& t : solid) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& c : t.corner) {
      out << "vertex " << c.x() << ' ' << c.y() << ' ' << c.z() << '\n';
    }
    out << "endloop\nendfacet\n";
  }
  out << "endsolid s\n";
}

// Needles of 12 x 1 x 1, plates of 8 x 8 x 1 and slivers, four corners nearly in a plane, tumble
// with balls at 60 rpm: none leaves, sticks through a wall or flies off faster than what it fell
// from, and the account closes to what free rotation keeps, (w dt)^2.
TEST(ExtremeMillsOf, NeedlesPlatesAndSliversTumble) {
  const TempFolder folder;
  write_stl(folder / "needle.stl", box_solid(Vec3(-6, -0.5, -0.5), Vec3(6, 0.5, 0.5)));
  write_stl(folder / "plate.stl", box_solid(Vec3(-4, -4, -0.5), Vec3(4, 4, 0.5)));
  const Vec3 a(0, 0, 0), b(10, 0, 0.4), c(9, 9, -0.3), d(0, 10, 0.5);
  write_stl(folder / "sliver.stl", triangles_of(convex_hull({a, b, c, d})));
  Scene scene = shipped_scene("lab_mill", {"run.settle=none", "particles.ball.count=15",
                                           "particles.ore.count=30", "mill.rotation=60 rpm"});
  scene.folder = folder.path();
  scene.particles[0].meshes = {"needle.stl", "plate.stl", "sliver.stl"};
  scene.particles[0].diameter = 0.006;  // needles 30 mm long in a mill of 40 mm
  scene.contact.normal_stiffness = 4e4;
  scene.contact.tangential_stiffness = 1.6e4;
  scene.run.time_step.reset();
  const DrawnScene all = drawn(scene);
  scene.run.time_step = 2.5 * choose_time_step(scene, all.seeds);  // 10 steps per contact
  World<float> world = world_of<float>(scene);
  Stepper<float> stepper(world, 2);
  const double most = 2 * std::sqrt(2 * 9.81 * 0.3) + 2 * 0.15 * 2 * kPi;
  double fastest = 0, touching = 0;
  while (world.time() < 0.2) {
    run_steps(world, stepper, 20);
    for (std::size_t k = 0; k < world.polyhedra.size(); ++k) {
      fastest = std::max(fastest, world.polyhedra.velocity(k).norm());
    }
    touching += world.totals.polyhedron_pair_contacts;
  }
  const Fallbacks& f = world.polyhedra.fallbacks;
  std::printf(
      "  dt %.2g s, fastest %.2f m/s, ledger error %.1g, model work %.1g, contained %llu, "
      "bounded %llu, wall depth %llu\n",
      world.clock.dt, fastest, ledger_error(world.ledger), model_work_share(world.ledger),
      static_cast<unsigned long long>(f.contained), static_cast<unsigned long long>(f.bounded),
      static_cast<unsigned long long>(f.wall_depth));
  EXPECT_LT(fastest, most);
  EXPECT_LT(ledger_error(world.ledger), 1e-3);
  EXPECT_GT(touching, 50);
  EXPECT_FALSE(f.any());
}

// A gas of spheres with friction in a periodic cube.
Scene gas(double length, int copies) {
  Law law;
  law.kn = 1e4;
  law.kt = 4e3;
  law.restitution = 1;
  law.rolling = 0.01;
  const double d = 1.0 / 64, dt = normal_contact_time(0.1 * sphere_mass(d), law.kn) / 40;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = Vec3(0.3, 0, 0);
  scene.domain.low = Vec3::Zero();
  scene.domain.high = Vec3(length * copies, length, length);
  for (bool& p : scene.domain.periodic) p = true;
  for (int copy = 0; copy < copies; ++copy) {
    const Vec3 shift(copy * length, 0, 0);
    add_sphere(scene, d, shift + Vec3(0.25, 0.25, 0.25) * length, {1, 0.3, -0.2}, {30, 0, 9});
    add_sphere(scene, d, shift + Vec3(0.75, 0.75, 0.25) * length, {-1, 0.1, 0.8}, {0, 20, 0});
    add_sphere(scene, 0.75 * d, shift + Vec3(0.25, 0.75, 0.75) * length, {0.5, -0.9, 0.1});
    add_sphere(scene, 0.5 * d, shift + Vec3(0.75, 0.25, 0.75) * length, {-0.5, 0.7, 1});
  }
  return scene;
}

// A period barely above two diameters of the largest sphere gives what two such periods side by
// side with each sphere twice do: no contact is lost or seen twice through a face. One below is
// refused.
TYPED_TEST(ExtremeMills, PeriodicBarelyTwiceAParticleAreRight) {
  const double d = 1.0 / 64;
  std::vector<Vec3> once, twice;
  double contacts = 0;
  for (const int copies : {1, 2}) {
    World<TypeParam> world = world_of<TypeParam>(gas(2.001 * d, copies));
    Stepper<TypeParam> stepper(world, 1);
    for (int k = 0; k < 2000; ++k) {
      run_steps(world, stepper, 1);
      if (copies == 1) contacts += world.totals.pair_contacts;
      for (const std::string& line : missed_contacts(world)) ADD_FAILURE() << line;
    }
    for (Index id = 0; id < 4; ++id) {
      (copies == 1 ? once : twice).push_back(velocity_of(world, id));
    }
  }
  EXPECT_GT(contacts, 200);
  const double eps = sizeof(TypeParam) == 4 ? 1e-3 : 1e-8;  // 6e-8 and 1e-16 x what collisions make
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LT((once[k] - twice[k]).norm(), eps);
  try {
    world_of<TypeParam>(gas(1.999 * d, 1));
    ADD_FAILURE() << "not refused";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("below two diameters"), std::string::npos);
  }
}

}  // namespace
}  // namespace quern::test
