// Spheres that become polyhedra: what is taken over, what is kept, and how it is relaxed.
#include "scheduler/exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "scheduler/graph.h"
#include "scheduler/rebuild.h"
#include "soa/hash.h"
#include "tests/support/build_world.h"
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
        row.push_back(static_cast<double>(world.pairs.number(slot, k)));
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

  Scene scene_ = box_scene(ShapeKind::kPolyhedron);
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
  EXPECT_EQ(world.overlap_cap, plan[0].overlap_cap * smallest);
  EXPECT_LT(world.drag, 1);
  EXPECT_FALSE(world.moving_walls);
  enter_phase(world, this->scene_, plan, plan.size() - 2);
  EXPECT_EQ(world.overlap_cap, 0);
  EXPECT_EQ(world.drag, 1);
}

}  // namespace
}  // namespace quern
