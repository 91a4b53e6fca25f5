// The state hash: any one bit of what it covers changes it; what it leaves out does not.
#include "soa/hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tests/support/build_world.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

// Spheres of two materials dropped into a box: pair and wall contacts, rolling moments.
constexpr const char* kScene = R"(
format = 1
[run]
duration = "1 s"
time_step = "1e-5 s"
tile_size = 8
[materials.ore]
density = "2000 kg/m^3"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
sliding_friction = 0.4
rolling_friction = 0.01
restitution = 0.6
[mill]
material = "ore"
diameter = "80 mm"
length = "40 mm"
ends = "walls"
rotation = "60 rpm"
[[particles]]
name = "ore"
material = "ore"
diameter = "10 mm"
count = 60
)";

template <class Real>
World<Real> tumbled() {
  World<Real> world = world_of<Real>(scene_of(kScene));
  Stepper<Real> stepper(world, 1);
  run_until(world, stepper, 0.1);
  while (world.clock.list_stale != 0) stepper.step();
  return world;
}

template <class Real>
class StateHash : public testing::Test {
 protected:
  World<Real> world = tumbled<Real>();
  const std::uint64_t before = state_hash(world);

  // Flips each bit of a number in turn.
  template <class T>
  void expect_every_bit_counts(const char* what, T& number) {
    for (std::size_t bit = 0; bit < 8 * sizeof(T); ++bit) {
      flip(number, bit);
      EXPECT_NE(state_hash(world), before) << what << ", bit " << bit;
      flip(number, bit);
    }
    ASSERT_EQ(state_hash(world), before);
  }

 private:
  template <class T>
  static void flip(T& number, std::size_t bit) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1u << bit % 8));
    std::memcpy(&number, bytes, sizeof(T));
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(StateHash, Precisions);

TYPED_TEST(StateHash, ChangesWithAnyBitOfAParticle) {
  Particles<TypeParam>& p = this->world.particles;
  for (const std::size_t k : {std::size_t{0}, p.size() / 2, p.size() - 1}) {
    Record<TypeParam>& r = p.record[k];
    for (double* v : {&r.x, &r.y, &r.z, &r.vx, &r.vy, &r.vz}) {
      this->expect_every_bit_counts("place or velocity", *v);
    }
    for (double* v : {&p.spin_x[k], &p.spin_y[k], &p.spin_z[k]}) {
      this->expect_every_bit_counts("spin", *v);
    }
    for (float* v : {&p.rest_x[k], &p.rest_y[k], &p.rest_z[k]}) {
      this->expect_every_bit_counts("rest of the place", *v);
    }
    this->expect_every_bit_counts("radius", r.radius);
    this->expect_every_bit_counts("material and contacts", p.traits[k].tag);
  }
}

TYPED_TEST(StateHash, ChangesWithAnyBitOfAPairSpring) {
  PairBatch<TypeParam>& pairs = this->world.pairs;
  std::vector<std::pair<std::size_t, std::size_t>> open;  // tile, slot
  for (std::size_t tile = 0; tile < pairs.tiles(); ++tile) {
    pairs.for_each(tile, PairBatch<TypeParam>::Part::kOwn, [&](std::size_t slot, Index, Index) {
      if (pairs.is_open(slot) && open.size() < 3) open.emplace_back(tile, slot);
    });
  }
  ASSERT_EQ(open.size(), 3u);
  for (const auto& [tile, slot] : open) {
    for (std::size_t k = 0; k < pairs.history(); ++k) {
      this->expect_every_bit_counts("spring, force, rest or moment", pairs.number(tile, slot, k));
    }
  }
}

TYPED_TEST(StateHash, ChangesWithAnyBitOfAWallSpring) {
  int seen = 0;
  for (TileWalls& tile : this->world.tile_walls) {
    if (tile.springs.empty() || ++seen > 2) continue;
    WallSpring& s = tile.springs.front();
    for (Vec3* v : {&s.spring, &s.force, &s.normal, &s.point, &s.moment}) {
      for (Eigen::Index a = 0; a < 3; ++a) this->expect_every_bit_counts("wall spring", (*v)[a]);
    }
    this->expect_every_bit_counts("overlap", s.overlap);
    this->expect_every_bit_counts("feature", s.feature);
  }
  EXPECT_GT(seen, 1);
}

TYPED_TEST(StateHash, ChangesWithAnyBitOfClockAndLedger) {
  this->expect_every_bit_counts("step", this->world.clock.step);
  this->expect_every_bit_counts("total steps", this->world.clock.total_steps);
  Ledger& l = this->world.ledger;
  for (double* v : {&l.kinetic, &l.elastic, &l.wall_work, &l.gravity_work, &l.contact_work,
                    &l.slide, &l.tangential_damping, &l.numerical_loss}) {
    this->expect_every_bit_counts("ledger", *v);
  }
}

// A body's pose is that of the last step, and none is restored with a checkpoint: the hash asks for
// the place of the wall at this moment.
TYPED_TEST(StateHash, ChangesWithTheTurnOfTheMillNotWithItsLastPose) {
  Body& mill = this->world.bodies.front();
  mill.pose = Pose();
  EXPECT_EQ(state_hash(this->world), this->before);
  mill.motion.rate.points.front().value *= 1 + 1e-12;
  EXPECT_NE(state_hash(this->world), this->before);
}

// Particles in reverse order; slots and springs stay where they are and follow their particles.
template <class Real>
void reverse_records(World<Real>& world) {
  Particles<Real>& p = world.particles;
  const Index last = static_cast<Index>(p.size() - 1);
#define QUERN_REVERSE(type, name, unit, doc) std::reverse(p.name.begin(), p.name.end());
  QUERN_PARTICLE_FIELDS(QUERN_REVERSE)
#undef QUERN_REVERSE
  for (Index& k : world.pairs.owner) k = last - k;
  for (Index& k : world.pairs.partner) k = last - k;
  for (TileWalls& tile : world.tile_walls) {
    for (WallSpring& s : tile.springs) s.particle = last - s.particle;
  }
}

// A rebuild sorts the particles anew, cuts other tiles and moves every spring to another slot.
TYPED_TEST(StateHash, DoesNotDependOnTheOrderOfRecordsOrTiles) {
  World<TypeParam>& w = this->world;
  Graph graph(1);
  RebuildScratch<TypeParam> scratch;
  for (const Index tile_size : {5u, 64u}) {
    reverse_records(w);
    EXPECT_EQ(state_hash(w), this->before) << "reversed";
    w.tile_size = tile_size;
    rebuild(w, graph, scratch);
    EXPECT_EQ(state_hash(w), this->before) << "in tiles of " << tile_size;
  }
}

TYPED_TEST(StateHash, DoesNotDependOnListsAndCaches) {
  World<TypeParam>& w = this->world;
  w.clock.list_window += 1;
  w.particles.list_x[0] += 1;
  for (TileWalls& tile : w.tile_walls) tile.candidates.facet.push_back(0);
  EXPECT_EQ(state_hash(w), this->before);
}

}  // namespace
}  // namespace quern
