// A number that is not finite, put into any column of a world in motion, is caught by the next step
// and traced to the particle, or to the contact, that had it.
//
// Columns are those of the tables in soa/fields.h and soa/polyhedra.h and the numbers that contacts
// of every pair type remember; NaN, infinity and minus infinity; between two steps, and where the
// lists are stale and would be built from them. Such numbers raise floating-point exceptions, which
// are let pass here.
#include <gtest/gtest.h>

#include <cfenv>
#include <functional>
#include <limits>
#include <type_traits>

#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

constexpr double kWrong[] = {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()};

class LetPass {
 public:
  LetPass() : before_(fedisableexcept(FE_ALL_EXCEPT)) {}
  ~LetPass() {
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(before_);
  }
  LetPass(const LetPass&) = delete;
  LetPass& operator=(const LetPass&) = delete;

 private:
  int before_;
};

// The state of a world, kept and put back.
class Kept : public StateVisitor {
 public:
  void column(const char*, const char*, ColumnBase& all, std::size_t) override {
    if (keeps_) {
      const auto* bytes = static_cast<const char*>(all.raw());
      blocks_.emplace_back(bytes, bytes + all.size() * all.element_bytes());
      return;
    }
    const std::vector<char>& block = blocks_[at_++];
    all.reset(block.size() / all.element_bytes());
    std::copy(block.begin(), block.end(), static_cast<char*>(all.raw()));
  }
  void later_column(const char* name, const char* unit, ColumnBase& all,
                    std::size_t components) override {
    column(name, unit, all, components);
  }
  void values(const char*, const char*, ElementType, void* data, std::size_t count) override {
    auto* bytes = static_cast<char*>(data);
    if (keeps_) return void(blocks_.emplace_back(bytes, bytes + 8 * count));
    const std::vector<char>& block = blocks_[at_++];
    std::copy(block.begin(), block.end(), bytes);
  }
  void put_back() {
    keeps_ = false;
    at_ = 0;
  }

 private:
  bool keeps_ = true;
  std::size_t at_ = 0;
  std::vector<std::vector<char>> blocks_;
};

// Rocks and balls at rest in a box: contacts of all five pair types.
Scene heap() {
  Law law;
  law.kn = 1e4;
  law.kt = 4e3;
  law.rolling = 0.01;
  Scene scene = small_scene(law, 1e-3, 40);
  scene.materials[0].density = 1;
  scene.run.gravity = Vec3(0, 0, -1);
  scene.run.tile_size = 8;
  scene.folder = QUERN_SOURCE_DIR "/apps/shapes";
  BoxSpec box;
  box.name = "box";
  box.material = "ore";
  box.low = Vec3(-0.7, -0.7, 0);
  box.high = Vec3(3.4, 3.4, 20);
  scene.boxes = {box};
  ParticleSpec rocks = scene.particles[0];
  rocks.name = "rock";
  rocks.shape = ShapeKind::kPolyhedron;
  rocks.meshes = {"ore12.stl"};
  for (int k = 0; k < 36; ++k) {
    ExplicitParticle p;
    p.position = Vec3(1.3 * (k % 3), 1.3 * (k / 3 % 3), 0.8 + 1.3 * (k / 9)) +
                 Vec3(0.05 * (k % 2), 0.04 * (k % 5), 0);
    p.diameter = 1;
    if ((k + k / 9) % 3 == 0) {
      p.orientation = Turn{Vec3(1, 0.3 * k, 2).normalized(), 0.7 * k};
      rocks.explicit_particles.push_back(p);
    } else {
      scene.particles[0].explicit_particles.push_back(p);
    }
  }
  scene.particles.push_back(rocks);
  return scene;
}

template <class Real>
class NotFinite : public testing::Test {
 protected:
  using Put = std::function<void(World<Real>&)>;

  static void SetUpTestSuite() {
    world_ = new World<Real>(world_of<Real>(heap()));
    Stepper<Real> stepper(*world_, 1);
    run_steps(*world_, stepper, 10000);
    kept_ = new Kept;
    world_->visit(*kept_);
  }
  static void TearDownTestSuite() {
    delete kept_;
    delete world_;
  }

  static World<Real>& state() {
    kept_->put_back();
    world_->visit(*kept_);
    return *world_;
  }

  // Steps once after `put`; `stale`: the step builds new lists.
  StepReport after(const Put& put, bool stale) {
    World<Real>& world = state();
    Stepper<Real> stepper(world, 1);
    EXPECT_EQ(stepper.step().bits & kFatalBits, 0u);  // lists are fresh and histories in use
    world.clock.list_stale = stale ? 1 : 0;
    put(world);
    return stepper.step();
  }

  void expect_caught(const std::string& column, Index id, const Put& put, bool stale = false) {
    const StepReport report = after(put, stale);
    EXPECT_NE(report.bits & kNotFinite, 0u) << column;
    EXPECT_EQ(report.first.id, id) << column;
  }

  // `id` and `partner` in either order; `partner` may be the box.
  void expect_contact(const std::string& column, Index id, Index partner, bool wall,
                      const Put& put) {
    const StepReport report = after(put, false);
    EXPECT_NE(report.bits & kNotFinite, 0u) << column;
    EXPECT_EQ(std::minmax(report.first.id, report.first.partner), std::minmax(id, partner))
        << column;
    EXPECT_EQ(report.first.partner_is_wall, wall) << column;
  }

  static World<Real>* world_;
  static Kept* kept_;
  LetPass let_pass_;
};
template <class Real>
World<Real>* NotFinite<Real>::world_ = nullptr;
template <class Real>
Kept* NotFinite<Real>::kept_ = nullptr;
TYPED_TEST_SUITE(NotFinite, Precisions, Names);

constexpr Index kSphere = 13, kBody = 5;

// A number of a particle by name, and how to put `x` there in row `k`.
template <class Real>
using Number = std::pair<const char*, std::function<void(World<Real>&, std::size_t k, double x)>>;
template <class Real>
std::vector<Number<Real>> numbers_of_a_sphere() {
  using W = World<Real>;
  std::vector<Number<Real>> numbers;
#define QUERN_NUMBER(what)                                                            \
  numbers.push_back({#what, [](W& w, std::size_t k, double x) {                       \
                       w.particles.what = static_cast<decltype(w.particles.what)>(x); \
                     }});
  QUERN_NUMBER(record[k].x)
  QUERN_NUMBER(record[k].y)
  QUERN_NUMBER(record[k].z)
  QUERN_NUMBER(record[k].radius)
  QUERN_NUMBER(record[k].vx)
  QUERN_NUMBER(record[k].vy)
  QUERN_NUMBER(record[k].vz)
  QUERN_NUMBER(record[k].wx)
  QUERN_NUMBER(record[k].wy)
  QUERN_NUMBER(record[k].wz)
  QUERN_NUMBER(traits[k].inverse_mass)
#undef QUERN_NUMBER
  const auto every = [&](const char* name, auto column) {
    numbers.push_back({name, [column](W& w, std::size_t k, double x) {
                         auto& c = w.particles.*column;
                         c[k] = static_cast<std::decay_t<decltype(c[k])>>(x);
                       }});
  };
#define QUERN_COLUMN(type, name, unit, doc) \
  if constexpr (std::is_floating_point_v<type>) every(#name, &Particles<Real>::name);
  QUERN_PARTICLE_FIELDS(QUERN_COLUMN)
#undef QUERN_COLUMN
  EXPECT_EQ(numbers.size(), 11u + 13u);
  return numbers;
}

TYPED_TEST(NotFinite, OfASphereNamesIt) {
  using W = World<TypeParam>;
  const auto numbers = numbers_of_a_sphere<TypeParam>();
  for (const auto& [name, put] : numbers) {
    for (const double wrong : kWrong) {
      const auto here = [&](W& w) { put(w, row_of(w, kSphere), wrong); };
      this->expect_caught(name, kSphere, here);
    }
  }
  // What the lists are built from, where they are.
  for (std::size_t k = 0; k < 7; ++k) {
    for (const double wrong : kWrong) {
      const auto here = [&](W& w) { numbers[k].second(w, row_of(w, kSphere), wrong); };
      this->expect_caught(std::string(numbers[k].first) + ", stale lists", kSphere, here, true);
    }
  }
}

template <class Real>
std::vector<Number<Real>> numbers_of_a_polyhedron() {
  using W = World<Real>;
  std::vector<Number<Real>> numbers;
  const auto every = [&](const char* name, auto column) {
    numbers.push_back({name, [column](W& w, std::size_t k, double x) {
                         auto& c = w.polyhedra.*column;
                         c[k] = static_cast<std::decay_t<decltype(c[k])>>(x);
                       }});
  };
#define QUERN_COLUMN(type, name, unit, doc) \
  if constexpr (std::is_floating_point_v<type>) every(#name, &Polyhedra<Real>::name);
  QUERN_POLYHEDRON_FIELDS(QUERN_COLUMN)
#undef QUERN_COLUMN
  EXPECT_EQ(numbers.size(), 33u);
  return numbers;
}

TYPED_TEST(NotFinite, OfAPolyhedronNamesIt) {
  using W = World<TypeParam>;
  const auto numbers = numbers_of_a_polyhedron<TypeParam>();
  for (const auto& [name, put] : numbers) {
    for (const double wrong : kWrong) {
      const auto here = [&](W& w) { put(w, kBody, wrong); };
      this->expect_caught(name, 24 + kBody, here);
    }
  }
}

// Nobody reads what they have for partners.
TYPED_TEST(NotFinite, OfWhoTouchesNobodyNamesIt) {
  Scene scene = small_scene(Law(), 1e-5);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  for (int k = 0; k < 3; ++k) add_sphere(scene, 0.1, {0.5 * k, 0, 1});
  scene.folder = QUERN_SOURCE_DIR "/apps/shapes";
  ParticleSpec rocks = scene.particles[0];
  rocks.name = "rock";
  rocks.shape = ShapeKind::kPolyhedron;
  rocks.meshes = {"ore12.stl"};
  for (ExplicitParticle& p : rocks.explicit_particles) p.position.y() = 1;
  scene.particles.push_back(rocks);
  const auto expect_caught = [&](const Number<TypeParam>& number, std::size_t k, Index id) {
    for (const double wrong : kWrong) {
      World<TypeParam> world = world_of<TypeParam>(scene);
      Stepper<TypeParam> stepper(world, 1);
      ASSERT_EQ(stepper.step().bits & kFatalBits, 0u);
      number.second(world, k, wrong);
      const StepReport report = stepper.step();
      EXPECT_NE(report.bits & kNotFinite, 0u) << number.first;
      EXPECT_EQ(report.first.id, id) << number.first;
    }
  };
  const std::size_t sphere = row_of(world_of<TypeParam>(scene), 1);
  for (const auto& number : numbers_of_a_sphere<TypeParam>()) expect_caught(number, sphere, 1);
  for (const auto& number : numbers_of_a_polyhedron<TypeParam>()) expect_caught(number, 1, 4);
}

TYPED_TEST(NotFinite, OfWhatAPairOfSpheresRemembersNamesBoth) {
  using W = World<TypeParam>;
  // The first contact of a tile, of its own and of another tile's.
  for (const auto part :
       {PairBatch<TypeParam>::Part::kOwn, PairBatch<TypeParam>::Part::kImported}) {
    W& world = this->state();
    std::size_t slot = 0, tile = 0, found = 0;
    Index i = kNoIndex, j = kNoIndex;
    for (std::size_t t = 0; t < world.tiles() && found == 0; ++t) {
      world.pairs.for_each(t, part, [&](std::size_t s, Index a, Index b) {
        if (found > 0 || !world.pairs.is_open(s)) return;
        ++found;
        std::tie(slot, tile, i, j) = std::tuple(s, t, world.particles.id[a], world.particles.id[b]);
      });
    }
    ASSERT_EQ(found, 1u);
    for (std::size_t k = 0; k < world.pairs.law_history(); ++k) {
      // An imported contact's force and moment of before are not read: the tile of i books their
      // work.
      const bool is_of_before = (k >= 3 && k < 6) || k >= 9;
      if (part == PairBatch<TypeParam>::Part::kImported && is_of_before) continue;
      for (const double wrong : kWrong) {
        // One more step has been taken since: the same contact by its partners.
        const auto here = [&](W& w) {
          for (std::size_t t = 0; t < w.tiles(); ++t) {
            w.pairs.for_each(t, part, [&](std::size_t s, Index a, Index b) {
              if (w.particles.id[a] != i || w.particles.id[b] != j || t != tile) return;
              w.pairs.number(t, s, k) = static_cast<TypeParam>(wrong);
            });
          }
        };
        this->expect_contact("number " + std::to_string(k), i, j, false, here);
      }
    }
  }
}

TYPED_TEST(NotFinite, OfWhatASphereOnAWallRemembersNamesIt) {
  using W = World<TypeParam>;
  W& world = this->state();
  std::size_t tile = 0;
  while (tile < world.tiles() && world.tile_walls[tile].springs.empty()) ++tile;
  ASSERT_LT(tile, world.tiles());
  const Index id = world.particles.id[world.tile_walls[tile].springs[0].particle];
  const auto numbers = [](WallSpring& s) {
    std::vector<double*> all = {&s.overlap};
    for (Vec3* v : {&s.spring, &s.force, &s.normal, &s.moment}) {
      for (Eigen::Index a = 0; a < 3; ++a) all.push_back(&(*v)[a]);
    }
    return all;
  };
  for (std::size_t k = 0; k < 13; ++k) {
    for (const double wrong : kWrong) {
      const auto here = [&](W& w) { *numbers(w.tile_walls[tile].springs[0])[k] = wrong; };
      this->expect_contact("number " + std::to_string(k), id, 0, true, here);
    }
  }
}

TYPED_TEST(NotFinite, OfWhatASphereOnARockRemembersNamesBoth) {
  using W = World<TypeParam>;
  using Batch = PolyhedronSphereBatch<TypeParam>;
  W& world = this->state();
  const Batch& batch = world.polyhedra.spheres;
  std::size_t slot = 0, group = 0;
  while (slot < batch.sphere.size() && !(batch.number(slot, Batch::kOverlap) > 0)) ++slot;
  ASSERT_LT(slot, batch.sphere.size());
  while (batch.begin[group + 1] <= slot) ++group;
  const Index sphere = world.particles.id[batch.sphere[slot]];
  const Index body = world.polyhedra.first_id + batch.polyhedron[group];
  for (std::size_t k = 0; k < Batch::kHistory; ++k) {
    for (const double wrong : kWrong) {
      const auto here = [&](W& w) {
        w.polyhedra.spheres.number(slot, k) = static_cast<TypeParam>(wrong);
      };
      this->expect_contact("number " + std::to_string(k), sphere, body, false, here);
    }
  }
}

TYPED_TEST(NotFinite, OfWhatTwoRocksRememberNamesBoth) {
  using W = World<TypeParam>;
  W& world = this->state();
  std::size_t row = 0;
  const auto& pairs = world.polyhedra.pairs;
  while (row < pairs.size() && pairs[row].touching == 0) ++row;
  ASSERT_LT(row, pairs.size());
  const Index first = world.polyhedra.first_id;
  const Index i = first + pairs[row].i, j = first + pairs[row].j;
  const auto numbers = [](PolyhedronPair& p) {
    // Its last overlap is read only by the step in which it ends.
    std::vector<double*> all = {&p.elastic_force, &p.stored};
    for (Vec3* v : {&p.spring, &p.force, &p.moment, &p.normal, &p.arm_i, &p.arm_j, &p.couple}) {
      for (Eigen::Index a = 0; a < 3; ++a) all.push_back(&(*v)[a]);
    }
    return all;
  };
  for (std::size_t k = 0; k < 23; ++k) {
    for (const double wrong : kWrong) {
      const auto here = [&](W& w) { *numbers(w.polyhedra.pairs[row])[k] = wrong; };
      this->expect_contact("number " + std::to_string(k), i, j, false, here);
    }
  }
}

TYPED_TEST(NotFinite, OfWhatARockOnAWallRemembersNamesIt) {
  using W = World<TypeParam>;
  W& world = this->state();
  ASSERT_FALSE(world.polyhedra.walls.empty());
  const Index id = world.polyhedra.first_id + world.polyhedra.walls[0].particle;
  const auto numbers = [](PolyhedronWall& s) {
    std::vector<double*> all = {&s.elastic_force, &s.stored};
    for (Vec3* v : {&s.spring, &s.force, &s.normal, &s.moment, &s.couple, &s.arm}) {
      for (Eigen::Index a = 0; a < 3; ++a) all.push_back(&(*v)[a]);
    }
    return all;
  };
  for (std::size_t k = 0; k < 20; ++k) {
    for (const double wrong : kWrong) {
      const auto here = [&](W& w) { *numbers(w.polyhedra.walls[0])[k] = wrong; };
      this->expect_contact("number " + std::to_string(k), id, 0, true, here);
    }
  }
}

}  // namespace
}  // namespace quern::test
