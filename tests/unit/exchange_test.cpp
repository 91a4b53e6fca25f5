// Spheres that become polyhedra: what is taken over, what is kept, and how it is relaxed.
#include "scheduler/exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "kernels/laws/damping.h"
#include "scheduler/graph.h"
#include "scheduler/rebuild.h"
#include "soa/hash.h"
#include "tests/support/hashed_runs.h"
#include "tests/support/test_shapes.h"

namespace quern {
namespace {

// A box of spheres of two kinds in three classes, in tiles of 16; the large class may be polyhedra.
Scene box_scene(ShapeKind large) {
  Scene scene;
  scene.run.gravity = Vec3(0, 0, -50);  // soon at rest
  scene.run.time_step = 2e-5;
  scene.run.duration = 1;
  scene.run.tile_size = 16;
  scene.materials = {{"ore", 2000, 0}, {"steel", 7800, 0}};
  scene.contact.normal_stiffness = 1e5;
  scene.contact.tangential_stiffness = 4e4;
  scene.contact.restitution = 0.3;
  scene.contact.sliding_friction = 0.5;
  scene.boxes.push_back({"box", "steel", Vec3::Zero(), Vec3(0.06, 0.06, 0.15), false, Motion()});
  scene.fill.method = FillMethod::kRandom;
  scene.particles.resize(2);
  scene.particles[0].name = "rock";
  scene.particles[0].material = "ore";
  scene.particles[0].meshes = {"rock.stl"};
  scene.particles[0].sizes = {{0.008, 0.010, 60, std::nullopt},
                              {0.014, 0.018, 12, std::nullopt, large}};
  scene.particles[1].name = "ball";
  scene.particles[1].material = "steel";
  scene.particles[1].diameter = 0.012;
  scene.particles[1].count = 20;
  return scene;
}

// What a charge remembers of its contacts, by the names that its particles had at first.
struct Springs {
  std::map<std::pair<Index, Index>, std::vector<double>> pairs;  // (i, j)
  std::map<std::pair<Index, Index>, Vec3> walls;                 // (particle, feature)
};

template <class Real>
Springs springs_of(const World<Real>& world, const std::vector<Index>& name) {
  Springs all;
  const auto name_of = [&](Index row) { return name[world.particles.id[row]]; };
  for (std::size_t t = 0; t + 1 < world.pairs.begin.size(); ++t) {
    world.pairs.for_each(t, PairBatch<Real>::Part::kOwn, [&](std::size_t slot, Index i, Index j) {
      if (!world.pairs.is_open(slot)) return;
      std::vector<double>& row = all.pairs[{name_of(i), name_of(j)}];
      for (std::size_t k = 0; k < world.pairs.history(); ++k) {
        row.push_back(static_cast<double>(world.pairs.number(t, slot, k)));
      }
    });
  }
  for (const TileWalls& t : world.tile_walls) {
    for (const WallSpring& s : t.springs) {
      all.walls[{name_of(s.particle), s.feature}] = s.force;
    }
  }
  return all;
}

template <class Real>
class Exchange : public testing::Test {
 protected:
  // The charge of spheres, dropped and at rest for the most part.
  void SetUp() override {
    const Scene spheres = box_scene(ShapeKind::kSphere);
    settled_ = world_of<Real>(spheres);
    settled_.moving_walls = false;
    settled_.drag = std::exp(-10 * settled_.clock.dt);
    Stepper<Real> stepper(settled_, 1);
    for (int k = 0; k < 8000; ++k) ASSERT_EQ(stepper.step().bits & kFatalBits, 0u);
    shapes_.push_back(test::built_box(Vec3(1, 1.2, 1.5)));
    seeds_ = draw_sizes(scene_);
    const std::vector<Index> rows[] = {{0}, {}};
    assign_shapes(shapes_, rows, seeds_);
    for (std::size_t k = 0; k < seeds_.size(); ++k) {
      name_.push_back(static_cast<Index>(k));
      if (seeds_[k].is_sphere()) sphere_name_.push_back(static_cast<Index>(k));
    }
  }

  World<Real> exchange() {
    return exchange_shapes(std::move(settled_), scene_, seeds_, std::move(shapes_));
  }

  // The exchanged charge as the program starts it, to be relaxed over `time`.
  World<Real> start_relaxing(double time) {
    scene_.run.start = StartKind::kFile;
    scene_.run.relax = time;
    World<Real> world = exchange();
    world.clock.step = 0;
    plan_ = plan_phases(scene_, world.clock.dt, 1, 1, 0.004);
    return world;
  }

  // All steps but those of the run, up to step `until` of them all; `look` after each.
  template <class Look>
  void relax(World<Real>& world, const RunOptions& o, std::uint64_t until, const Look& look) const {
    Stepper<Real> stepper(world, o.threads);
    if (o.shuffle != 0) stepper.graph().shuffle(o.shuffle);
    for (std::size_t row = world.clock.phase; row + 1 < plan_.size(); ++row) {
      enter_phase(world, scene_, plan_, row);
      while (!phase_is_over(world, plan_[row])) {
        if (world.clock.total_steps >= until) return;
        ASSERT_EQ(stepper.step().bits & kFatalBits, 0u) << "phase " << row;
        look();
      }
    }
  }

  Scene scene_ = box_scene(ShapeKind::kPolyhedron);
  std::vector<PhasePlan> plan_;
  World<Real> settled_;
  std::vector<Shape> shapes_;
  std::vector<ParticleSeed> seeds_;
  std::vector<Index> name_, sphere_name_;  // first identities: of all, of what stays a sphere
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(Exchange, Precisions);

TYPED_TEST(Exchange, PutsPolyhedraOfEqualVolumeWhereTheirSpheresWere) {
  std::map<Index, Record<TypeParam>> before;
  std::map<Index, Vec3> spin;
  const Particles<TypeParam>& old = this->settled_.particles;
  for (std::size_t k = 0; k < old.size(); ++k) {
    before[old.id[k]] = old.record[k];
    spin[old.id[k]] = Vec3(old.spin_x[k], old.spin_y[k], old.spin_z[k]);
  }
  const double mass = this->settled_.total_mass;
  const World<TypeParam> world = this->exchange();
  const Polyhedra<TypeParam>& p = world.polyhedra;
  ASSERT_EQ(p.size(), 12u);
  EXPECT_EQ(p.first_id, 80u);
  EXPECT_EQ(world.shapes.size(), 1u);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Index name = static_cast<Index>(60 + k);  // behind the small class
    const Record<TypeParam>& r = before[name];
    EXPECT_EQ(p.place(k), Vec3(r.x, r.y, r.z));
    EXPECT_EQ(p.velocity(k), Vec3(r.vx, r.vy, r.vz));
    EXPECT_EQ(p.spin(k), spin[name]);
    EXPECT_EQ(p.scale[k], this->seeds_[name].radius);
    EXPECT_EQ(p.orientation(k).coeffs(), this->seeds_[name].orientation.coeffs());
  }
  ASSERT_EQ(world.particles.size(), 80u);
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    const Record<TypeParam>& now = world.particles.record[k];
    const Record<TypeParam>& was = before[this->sphere_name_[world.particles.id[k]]];
    EXPECT_EQ(std::memcmp(&now, &was, sizeof now), 0);
  }
  EXPECT_NEAR(world.total_mass / mass, 1, 1e-6);  // masses of spheres are f32 in mixed
}

TYPED_TEST(Exchange, KeepsTheSpringsOfAllOthers) {
  const Springs before = springs_of(this->settled_, this->name_);
  World<TypeParam> world = this->exchange();
  Graph graph(1);
  RebuildScratch<TypeParam> scratch;
  rebuild(world, graph, scratch);
  const Springs after = springs_of(world, this->sphere_name_);
  const auto large = [](Index name) { return name >= 60 && name < 72; };
  std::size_t pairs = 0, walls = 0;
  for (const auto& [key, history] : before.pairs) {
    if (large(key.first) || large(key.second)) continue;
    ++pairs;
    ASSERT_EQ(after.pairs.count(key), 1u);
    EXPECT_EQ(after.pairs.at(key), history);
  }
  for (const auto& [key, force] : before.walls) {
    if (large(key.first)) continue;
    ++walls;
    ASSERT_EQ(after.walls.count(key), 1u);
    EXPECT_EQ(after.walls.at(key), force);
  }
  EXPECT_EQ(after.pairs.size(), pairs);
  EXPECT_EQ(after.walls.size(), walls);
  EXPECT_GT(pairs, 50u);
  EXPECT_LT(pairs, before.pairs.size());
  EXPECT_GT(walls, 10u);
}

TYPED_TEST(Exchange, LeavesAStateThatCanBeHashedBeforeItIsSorted) {
  const World<TypeParam> world = this->exchange();
  EXPECT_GT(springs_of(world, this->sphere_name_).pairs.size(), 50u);
  EXPECT_NE(state_hash(world), 0u);
  EXPECT_EQ(world.clock.list_stale, 1u);
}

TYPED_TEST(Exchange, MayLeaveNoSphereAtAll) {
  for (SizeClass& size : this->scene_.particles[0].sizes) size.shape = ShapeKind::kPolyhedron;
  this->scene_.particles[1].shape = ShapeKind::kPolyhedron;
  this->scene_.particles[1].meshes = {"rock.stl"};
  this->seeds_ = draw_sizes(this->scene_);
  const std::vector<Index> rows[] = {{0}, {0}};
  assign_shapes(this->shapes_, rows, this->seeds_);
  World<TypeParam> world = this->exchange();
  EXPECT_EQ(world.particles.size(), 0u);
  EXPECT_EQ(world.polyhedra.size(), 92u);
  EXPECT_EQ(world.polyhedra.first_id, 0u);
}

TYPED_TEST(Exchange, RefusesAnotherCharge) {
  const auto message = [&] {
    try {
      this->exchange();
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  this->seeds_.pop_back();
  EXPECT_NE(message().find("holds 92 particles, the scene 91"), std::string::npos);
  this->SetUp();
  this->seeds_[3].radius *= 1.001;
  EXPECT_NE(message().find("particle 3 of start_file"), std::string::npos);
}

TEST(Relaxing, EndsWithTheTrueLaw) {
  Scene scene = box_scene(ShapeKind::kPolyhedron);
  scene.run.start = StartKind::kFile;
  EXPECT_EQ(plan_phases(scene, 1e-5, 1, 1, 0.004).size(), 1u);  // nothing was exchanged
  scene.run.relax = 0.2;
  const std::vector<PhasePlan> plan = plan_phases(scene, 1e-5, 1, 1, 0.004);
  std::uint64_t capped = 0;
  double cap = 0;
  for (std::size_t row = 0; row + 2 < plan.size(); ++row) {
    EXPECT_EQ(plan[row].kind, Phase::kRelax);
    EXPECT_GT(plan[row].overlap_cap, cap);
    EXPECT_GT(plan[row].drag, 0);
    EXPECT_EQ(plan[row].stiffness, 1);
    cap = plan[row].overlap_cap;
    capped += plan[row].steps;
  }
  EXPECT_NEAR(static_cast<double>(capped), 15000, 0.5 * static_cast<double>(plan.size()));
  const PhasePlan& last = plan[plan.size() - 2];
  EXPECT_EQ(last.kind, Phase::kSettle);
  EXPECT_EQ(last.steps, 5000u);
  EXPECT_EQ(last.overlap_cap, 0);
  EXPECT_EQ(last.drag, 0);
  EXPECT_EQ(plan.back().kind, Phase::kRun);
}

TYPED_TEST(Exchange, IsRelaxedUnderACapOfTheSmallestPolyhedron) {
  this->scene_.run.start = StartKind::kFile;
  this->scene_.run.relax = kExchangeRelax;
  World<TypeParam> world = this->exchange();
  const std::vector<PhasePlan> plan = plan_phases(this->scene_, world.clock.dt, 1, 1, 0.004);
  double smallest = HUGE_VAL;
  for (const double scale : world.polyhedra.scale) smallest = std::min(smallest, scale);
  enter_phase(world, this->scene_, plan, 0);
  EXPECT_DOUBLE_EQ(world.overlap_cap, plan[0].overlap_cap * 0.01 * smallest);
  EXPECT_FALSE(world.caps_spheres);
  EXPECT_LT(world.drag, 1);
  EXPECT_FALSE(world.moving_walls);
  const double friction = this->scene_.contact.sliding_friction.value();
  EXPECT_LT(static_cast<double>(world.law.sliding_friction[0]), friction);
  enter_phase(world, this->scene_, plan, plan.size() - 2);
  EXPECT_EQ(world.overlap_cap, 0);
  EXPECT_EQ(world.drag, 1);
  EXPECT_EQ(world.law.sliding_friction[0], static_cast<TypeParam>(friction));
  // The scene's own cap is one of all contacts.
  Scene capped = this->scene_;
  capped.run.overlap_cap = 1e-5;
  enter_phase(world, capped, plan, 0);
  EXPECT_DOUBLE_EQ(world.overlap_cap, plan[0].overlap_cap * 1e-5);
  EXPECT_TRUE(world.caps_spheres);
  enter_phase(world, capped, plan, plan.size() - 2);
  EXPECT_FALSE(world.caps_spheres);
  // Spheres alone stand at the friction they have: at a lower one a bed at rest would move again.
  World<TypeParam> spheres = world_of<TypeParam>(box_scene(ShapeKind::kSphere));
  enter_phase(spheres, this->scene_, plan, 0);
  EXPECT_EQ(spheres.law.sliding_friction[0], static_cast<TypeParam>(friction));
}

// The largest speed of any point (m/s).
template <class Real>
double fastest_point(const World<Real>& world) {
  double most = 0;
  const Particles<Real>& s = world.particles;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const Record<Real>& r = s.record[k];
    const double radius = static_cast<double>(r.radius);
    most = std::max(most, Vec3(r.vx, r.vy, r.vz).norm() +
                              radius * Vec3(s.spin_x[k], s.spin_y[k], s.spin_z[k]).norm());
  }
  const Polyhedra<Real>& p = world.polyhedra;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double radius = p.scale[k] * world.shapes[p.shape[k]].bound_radius;
    most = std::max(most, p.velocity(k).norm() + radius * p.spin(k).norm());
  }
  return most;
}

// The largest push (N) of springs of polyhedra among themselves and with walls, and the largest
// normal force, damping included, that spheres feel of them.
struct Pushes {
  double spring = 0, on_spheres = 0;
  int contacts = 0;
};
template <class Real>
Pushes pushes_of(const World<Real>& world) {
  Pushes found;
  const Polyhedra<Real>& p = world.polyhedra;
  const auto add = [&](double force, double& most) {
    most = std::max(most, force);
    ++found.contacts;
  };
  for (const PolyhedronPair& pair : p.pairs) {
    if (pair.touching != 0) add(pair.elastic_force, found.spring);
  }
  for (const PolyhedronWall& wall : p.walls) add(wall.elastic_force, found.spring);
  for (std::size_t g = 0; g < p.spheres.polyhedron.size(); ++g) {
    for (Index slot = p.spheres.begin[g]; slot < p.spheres.begin[g] + p.spheres.count[g]; ++slot) {
      const auto number = [&](std::size_t k) {
        return static_cast<double>(p.spheres.number(slot, k));
      };
      if (!(number(p.spheres.kOverlap) > 0)) continue;
      add(Vec3(number(3), number(4), number(5)).dot(Vec3(number(6), number(7), number(8))),
          found.on_spheres);
    }
  }
  return found;
}

// While overlaps are capped no spring of a polyhedron pushes with more than kn times the cap; what
// spheres feel more is damping, at most that of the heaviest ball at twice the fastest point's
// speed. Then the charge is at rest but for a fall by less than its smallest radius, and no contact
// carries more than the weight of all.
TYPED_TEST(Exchange, IsLetGoWithoutABurst) {
  this->scene_.run.gravity = Vec3(0, 0, -9.81);
  World<TypeParam> world = this->start_relaxing(kExchangeRelax);
  world.gravity = this->scene_.run.gravity;
  const double kn = *this->scene_.contact.normal_stiffness, smallest = 0.004;
  const double ball = 7800 * kPi / 6 * 0.012 * 0.012 * 0.012;
  const double damping = 2 * damping_ratio(0.3, NormalForce::kClamped) * std::sqrt(kn * ball);
  const double weight = 9.81 * world.total_mass;
  int contacts = 0;
  double before = fastest_point(world), deepest = 0;
  double most_kinetic[2] = {0, 0};  // true law, capped
  this->relax(world, {}, UINT64_MAX, [&] {
    const double speed = std::exchange(before, fastest_point(world));
    double& most_now = most_kinetic[world.overlap_cap > 0 ? 1 : 0];
    most_now = std::max(most_now, world.totals.translational + world.totals.rotational);
    deepest = std::max(deepest, world.totals.max_overlap);
    if (world.overlap_cap == 0) return;
    const Pushes found = pushes_of(world);
    const double most = kn * world.overlap_cap;
    ASSERT_LE(found.spring, most * (1 + 1e-12));
    ASSERT_LE(found.on_spheres, most + 2 * damping * speed);
    contacts += found.contacts;
  });
  EXPECT_GT(contacts, 100000);
  EXPECT_GT(deepest, 0.3) << "nothing had to be let go";
  EXPECT_LT(most_kinetic[1], weight * smallest);
  EXPECT_LT(most_kinetic[0], 2 * weight * smallest);
  EXPECT_LT(world.totals.max_overlap, weight / kn / smallest);
  EXPECT_EQ(world.particles.size(), 80u);
  ASSERT_EQ(world.polyhedra.size(), 12u);
  const Vec3 high = this->scene_.boxes[0].high;
  const auto is_inside = [&](const Vec3& x) {
    return (x.array() > 0).all() && (x.array() < high.array()).all();
  };
  for (std::size_t k = 0; k < 12; ++k) EXPECT_TRUE(is_inside(world.polyhedra.place(k))) << k;
  for (const Record<TypeParam>& r : world.particles.record) {
    EXPECT_TRUE(is_inside(Vec3(r.x, r.y, r.z)));
  }
}

TYPED_TEST(Exchange, GivesTheSameBitsWithARestartWhileItIsRelaxed) {
  World<TypeParam> fresh = this->start_relaxing(0.06);
  const std::uint64_t first = fresh.clock.total_steps, last = first + 700;
  ASSERT_EQ(this->plan_[16].kind, Phase::kRelax);
  TempFolder begin, middle;
  write_state(fresh, begin.path());
  const auto read = [&](const std::string& folder) {
    std::vector<Shape> shapes;
    shapes.push_back(test::built_box(Vec3(1, 1.2, 1.5)));
    std::vector<ParticleSeed> seeds = draw_sizes(this->scene_);
    const std::vector<Index> rows[] = {{0}, {}};
    assign_shapes(shapes, rows, seeds);
    World<TypeParam> world = make_world<TypeParam>(
        this->scene_, build_geometry(this->scene_, {}, seeds), seeds, seeds, std::move(shapes));
    read_checkpoint(folder + "/checkpoint.h5", [&](StateVisitor& v) { world.visit(v); });
    return world;
  };
  const auto hash_after = [&](const RunOptions& o) {
    World<TypeParam> world = read(begin.path());
    if (o.resume_at != 0) {
      this->relax(world, o, first + o.resume_at, [] {});
      EXPECT_GT(world.overlap_cap, 0);
      write_state(world, middle.path());
      world = read(middle.path());
    }
    this->relax(world, o, last, [] {});
    EXPECT_EQ(world.clock.total_steps, last);
    EXPECT_EQ(world.overlap_cap, 0);
    return state_hash(world);
  };
  const std::uint64_t one = hash_after({});
  EXPECT_EQ(hash_after({.resume_at = 250}), one);
  EXPECT_EQ(hash_after({.threads = 3, .shuffle = 99, .resume_at = 1}), one);
}

}  // namespace
}  // namespace quern
