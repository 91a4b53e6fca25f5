// Polyhedra in the state hash and in checkpoints: any one bit of what decides the future counts, is
// written and comes back; the order of records does not; a scene without them holds nothing of
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "io/checkpoint.h"
#include "io/hdf5_file.h"
#include "soa/hash.h"
#include "tests/support/polyhedron_world.h"
#include "tests/support/small_scene.h"
#include "tests/support/temp_folder.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

using test::world_by_hand;

template <class Real>
class PolyhedraState : public testing::Test {
 protected:
  World<Real> world = world_by_hand<Real>();
  const std::uint64_t before = state_hash(world);

  template <class T>
  void expect_every_bit_counts(const char* what, T& number) {
    for (std::size_t bit = 0; bit < 8 * sizeof(T); ++bit) {
      unsigned char bytes[sizeof(T)];
      std::memcpy(bytes, &number, sizeof(T));
      bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1u << bit % 8));
      const T was = number;
      std::memcpy(&number, bytes, sizeof(T));
      EXPECT_NE(state_hash(world), before) << what << ", bit " << bit;
      std::memcpy(&number, &was, sizeof(T));
    }
    ASSERT_EQ(state_hash(world), before) << what;
  }
  void expect_every_bit_counts(const char* what, Vec3& v) {
    for (Eigen::Index a = 0; a < 3; ++a) expect_every_bit_counts(what, v[a]);
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(PolyhedraState, Precisions);

TYPED_TEST(PolyhedraState, HashChangesWithAnyBitOfABody) {
  Polyhedra<TypeParam>& p = this->world.polyhedra;
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (Column<double>* c : {&p.x, &p.y, &p.z, &p.vx, &p.vy, &p.vz, &p.qw, &p.qx, &p.qy, &p.qz,
                              &p.lx, &p.ly, &p.lz, &p.scale}) {
      this->expect_every_bit_counts("place, pose or motion", (*c)[k]);
    }
    this->expect_every_bit_counts("shape", p.shape[k]);
    this->expect_every_bit_counts("material", p.material[k]);
    this->expect_every_bit_counts("contacts", p.contacts[k]);
  }
  this->expect_every_bit_counts("model work", this->world.ledger.model_work);
}

TYPED_TEST(PolyhedraState, HashChangesWithAnyBitOfAnOpenContact) {
  Polyhedra<TypeParam>& p = this->world.polyhedra;
  PolyhedronPair& pair = p.pairs.front();
  for (Vec3* v :
       {&pair.spring, &pair.force, &pair.moment, &pair.normal, &pair.arm_i, &pair.arm_j}) {
    this->expect_every_bit_counts("pair", *v);
  }
  this->expect_every_bit_counts("overlap", pair.overlap);
  this->expect_every_bit_counts("elastic force", pair.elastic_force);
  this->expect_every_bit_counts("partner", pair.i);
  for (WallSpring& s : p.walls) {
    for (Vec3* v : {&s.spring, &s.force, &s.normal, &s.point, &s.moment}) {
      this->expect_every_bit_counts("wall", *v);
    }
    this->expect_every_bit_counts("overlap", s.overlap);
    this->expect_every_bit_counts("feature", s.feature);
  }
  for (std::size_t slot = 0; slot < p.spheres.sphere.size(); ++slot) {
    if (!p.spheres.is_open(slot)) continue;
    for (std::size_t k = 0; k < p.spheres.kHistory; ++k) {
      this->expect_every_bit_counts("history", p.spheres.number(slot, k));
    }
  }
}

TYPED_TEST(PolyhedraState, HashLeavesOutListsAndCaches) {
  Polyhedra<TypeParam>& p = this->world.polyhedra;
  for (PolyhedronPair& pair : p.pairs) {
    pair.axis[1] += 1;
    pair.gap += 1;
    pair.axis_flags ^= 1;
  }
  p.wall_candidate_facet.push_back(3);
  p.list_x[0] += 1;
  p.wx[0] += 1;                                  // follows from momentum and orientation
  p.spheres.number(1, p.spheres.kOverlap) -= 1;  // of a sphere that is apart
  p.pairs.pop_back();                            // listed, not touching
  EXPECT_EQ(state_hash(this->world), this->before);
}

// Spheres in reverse order and in tiles of another size; groups in another order.
TYPED_TEST(PolyhedraState, HashDoesNotDependOnTheOrderOfRecords) {
  World<TypeParam>& w = this->world;
  Particles<TypeParam>& s = w.particles;
#define QUERN_REVERSE(type, name, unit, doc) std::reverse(s.name.begin(), s.name.end());
  QUERN_PARTICLE_FIELDS(QUERN_REVERSE)
#undef QUERN_REVERSE
  PolyhedronSphereBatch<TypeParam>& batch = w.polyhedra.spheres;
  for (Index& row : batch.sphere) row = test::kSpheres - 1 - row;
  EXPECT_EQ(state_hash(w), this->before) << "spheres reversed";
  for (Column<Index>* c : {&batch.polyhedron, &batch.count}) std::reverse(c->begin(), c->end());
  std::reverse(batch.begin.begin(), batch.begin.end() - 1);
  batch.tile_begin[1] = 1;
  EXPECT_EQ(state_hash(w), this->before) << "groups reversed";
  w.tile_size = 64;
  batch.tile_begin.resize(2);
  batch.tile_begin[1] = 3;
  EXPECT_EQ(state_hash(w), this->before) << "one tile";
  std::reverse(w.polyhedra.pairs.begin(), w.polyhedra.pairs.end());
  std::reverse(w.polyhedra.walls.begin(), w.polyhedra.walls.end());
  EXPECT_EQ(state_hash(w), this->before) << "contacts reversed";
}

// Every dataset of a state as bytes, by name.
class Collector final : public StateVisitor {
 public:
  std::vector<std::pair<std::string, std::string>> found;
  void column(const char* name, const char*, ColumnBase& c, std::size_t) override {
    keep(name, c.raw(), c.size() * c.element_bytes());
  }
  void values(const char* name, const char*, ElementType type, void* data,
              std::size_t count) override {
    keep(name, data, count * (type == ElementType::kU32 ? 4 : 8));
  }

 private:
  void keep(const char* name, const void* data, std::size_t bytes) {
    found.emplace_back(name, std::string(static_cast<const char*>(data), bytes));
  }
};

template <class Real>
auto bytes_of(World<Real>& world) {
  Collector collector;
  world.visit(collector);
  return collector.found;
}

template <class Real>
void write(const TempFolder& folder, World<Real>& world) {
  write_checkpoint(folder.path(), CheckpointHeader(), [&](StateVisitor& v) { world.visit(v); });
}

template <class Real>
std::string complaint_on_reading(const TempFolder& folder, World<Real>& world) {
  try {
    read_checkpoint(folder / "checkpoint.h5", [&](StateVisitor& v) { world.visit(v); });
  } catch (const SystemError& error) {
    return error.what();
  }
  return "";
}

TYPED_TEST(PolyhedraState, ComesBackFromACheckpointBitForBit) {
  const TempFolder folder;
  this->world.polyhedra.fallbacks = {3, 5, 7};
  write(folder, this->world);
  World<TypeParam> other;
  other.tile_size = this->world.tile_size;
  for (int k = 0; k < 2; ++k) other.shapes.emplace_back();
  ASSERT_EQ(complaint_on_reading(folder, other), "");
  EXPECT_EQ(state_hash(other), this->before);
  EXPECT_EQ(bytes_of(other), bytes_of(this->world));
  EXPECT_EQ(other.polyhedra.first_id, test::kSpheres);
}

// What a version before wrote: without the blocks that came later.
class Earlier final : public StateVisitor {
 public:
  explicit Earlier(StateVisitor& to) : to_(to) {}
  void column(const char* name, const char* unit, ColumnBase& c, std::size_t width) override {
    to_.column(name, unit, c, width);
  }
  void values(const char* name, const char* unit, ElementType type, void* data,
              std::size_t count) override {
    to_.values(name, unit, type, data, count);
  }
  void later_values(const char*, const char*, ElementType, void*, std::size_t) override {}

 private:
  StateVisitor& to_;
};

TYPED_TEST(PolyhedraState, OfAnEarlierVersionIsReadAsWell) {
  const TempFolder folder;
  this->world.polyhedra.fallbacks = {3, 5, 7};
  write_checkpoint(folder.path(), CheckpointHeader(), [&](StateVisitor& v) {
    Earlier earlier(v);
    this->world.visit(earlier);
  });
  World<TypeParam> other;
  other.tile_size = this->world.tile_size;
  for (int k = 0; k < 2; ++k) other.shapes.emplace_back();
  ASSERT_EQ(complaint_on_reading(folder, other), "");
  EXPECT_EQ(state_hash(other), this->before);
  EXPECT_FALSE(other.polyhedra.fallbacks.any());
}

TYPED_TEST(PolyhedraState, IsNotTakenForThatOfASceneWithoutPolyhedra) {
  const TempFolder folder;
  World<TypeParam> without = world_by_hand<TypeParam>(false);
  write(folder, this->world);
  const std::string left_over = complaint_on_reading(folder, without);
  EXPECT_NE(left_over.find("'state/polyhedra/"), std::string::npos) << left_over;
  EXPECT_NE(left_over.find("this scene has no such state"), std::string::npos) << left_over;

  write(folder, without);
  const std::string missing = complaint_on_reading(folder, this->world);
  EXPECT_NE(missing.find("'state/polyhedra/"), std::string::npos) << missing;
  EXPECT_NE(missing.find("another scene"), std::string::npos) << missing;
}

TYPED_TEST(PolyhedraState, IsAbsentFromASceneWithoutPolyhedra) {
  World<TypeParam> without = world_by_hand<TypeParam>(false);
  for (const auto& [name, bytes] : bytes_of(without)) {
    EXPECT_EQ(name.find("polyhedra"), std::string::npos) << name;
  }
}

// Balls that fall on each other and on a plate, lists rebuilt now and then.
TYPED_TEST(PolyhedraState, TakesNoMemoryInASteppedSceneOfSpheres) {
  Scene scene = test::small_scene(test::Law(), 1e-5);
  scene.run.gravity = Vec3(0, 0, -9.81);
  test::add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  for (int k = 0; k < 8; ++k) {
    test::add_sphere(scene, 0.0625,
                     Vec3(0.05 * (k % 2), 0.05 * (k / 2 % 2), 0.031 + 0.06 * (k / 4)),
                     Vec3(0, 0, -1));
  }
  World<TypeParam> balls = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(balls, 2);
  test::run_steps(balls, stepper, 500);
  bytes_of(balls);
  EXPECT_GT(balls.clock.rebuilds, 2u);
  EXPECT_GT(balls.window.pair_contacts, 0);
  EXPECT_GT(balls.window.wall_contacts, 0);
  EXPECT_EQ(stepper.bodies(), nullptr);
  EXPECT_EQ(balls.shapes.capacity(), 0u);
  const Polyhedra<TypeParam>& p = balls.polyhedra;
#define QUERN_EXPECT_NONE(type, name, unit, doc) EXPECT_EQ(p.name.capacity_bytes(), 0u) << #name;
  QUERN_POLYHEDRON_FIELDS(QUERN_EXPECT_NONE)
#undef QUERN_EXPECT_NONE
  EXPECT_EQ(p.pairs.capacity(), 0u);
  EXPECT_EQ(p.walls.capacity(), 0u);
  for (const std::vector<Index>* v : {&p.wall_candidate_begin, &p.wall_candidate_body,
                                      &p.wall_candidate_facet_begin, &p.wall_candidate_facet}) {
    EXPECT_EQ(v->capacity(), 0u);
  }
  const PolyhedronSphereBatch<TypeParam>& s = p.spheres;
  for (const ColumnBase* c : std::initializer_list<const ColumnBase*>{
           &s.tile_begin, &s.polyhedron, &s.count, &s.begin, &s.sphere, &s.numbers, &s.sums,
           &s.has_sums, &s.open}) {
    EXPECT_EQ(c->capacity_bytes(), 0u);
  }
}

}  // namespace
}  // namespace quern
