// What is known of a sphere near walls from an earlier step: sphere_facet_touches() says the same
// anywhere within the way that facet_freedom() gives, and a run in which nothing is ever known from
// the step before comes out with the same bits.
#include <gtest/gtest.h>

#include "kernels/pairs/sphere_facet.h"
#include "scheduler/random.h"
#include "soa/hash.h"
#include "tests/support/build_world.h"
#include "tests/support/mill_of_spheres.h"
#include "tests/support/test_walls.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

using test::Random;

struct Found {
  int faces = 0, apart = 0, limits = 0;
};

// Moves the centre about within its way, to the very end of it half of the time, and looks again.
// `limits` counts answers that are others a little farther on: the way is not needlessly short.
void check_freedom(const Facets& f, const Vec3& center, double radius, Random& random,
                   Found& found) {
  std::vector<Index> near;
  find_facets(f, center, 2 * radius, near);
  const FacetFreedom freedom = facet_freedom(f, center, radius, near);
  if (!(freedom.way > 0) || near.empty()) return;
  const double way = std::min(freedom.way, 0.9 * radius);
  ++(freedom.facet == kNoIndex ? found.apart : found.faces);
  for (int i = 0; i < 20; ++i) {
    const double share = i % 2 == 0 ? 1 - 1e-9 : random(0, 1);
    const Vec3 to = random.in_cube(1).normalized();
    const auto look = [&](double distance, WallTouch(&out)[kMaxWallTouches]) {
      return sphere_facet_touches(f, center + distance * to, radius, near, out, kMaxWallTouches);
    };
    WallTouch out[kMaxWallTouches];
    const int count = look(share * way, out);
    double height = radius;
    if (freedom.facet != kNoIndex) {
      const FacetRecord& face = f.record[freedom.facet];
      height = face.normal.dot(center + share * way * to - face.corner[0]);
      if (height <= 0) continue;
    }
    ASSERT_EQ(count, height < radius ? 1 : 0);
    if (count == 1) {
      EXPECT_EQ(out[0].feature, f.group[freedom.facet]);
      EXPECT_EQ(out[0].normal, f.normal[freedom.facet]);
      EXPECT_EQ(out[0].overlap, radius - height);
      EXPECT_FALSE(out[0].behind);
    }
    if (way == freedom.way && look(1.1 * way, out) != count) ++found.limits;
  }
}

TEST(KnownTouch, IsWhatALookWouldTell) {
  Random random(3);
  std::vector<Triangle> mill = mill_shell(test::lab_mill(), -0.02, 0.02);
  for (const Triangle& t : mill_ends(test::lab_mill())) mill.push_back(t);
  const Facets walls[] = {test::facets_of(mill),
                          test::facets_of(test::random_plate(6, false, random)),
                          test::facets_of(test::random_plate(6, true, random))};
  for (const Facets& f : walls) {
    Found found;
    for (int i = 0; i < 3000; ++i) {
      const Index t = static_cast<Index>(random.below(f.triangles()));
      const double u = random(0, 1), radius = 0.006;
      const Vec3 on = test::inner_point({f.record[t].corner}, u, random(0, 1 - u));
      check_freedom(f, on + radius * random(-1.5, 1.5) * f.normal[t], radius, random, found);
    }
    EXPECT_GT(found.faces, 100);
    EXPECT_GT(found.apart, 100);
    EXPECT_GT(found.limits, 100);
  }
}

TEST(KnownTouch, ChangesNoBitOfARun) {
  // Soft, so that spheres stay at the wall for long.
  const Scene scene =
      scene_of(test::kMillOfSpheres,
               {"contact.normal_stiffness=1e4 N/m", "contact.tangential_stiffness=4e3 N/m",
                "particles.ore.count=800"});
  World<float> world = world_of<float>(scene), other = world_of<float>(scene);
  for (World<float>* w : {&world, &other}) {
    CounterRandom random(5);
    for (Record<float>& r : w->particles.record) {
      for (double* v : {&r.vx, &r.vy, &r.vz}) *v = random.uniform(-2, 2);
    }
  }
  Stepper<float> knowing(world, 1);
  double contacts = 0;
  for (int step = 0; step < 1500; ++step) {
    knowing.step();
    Stepper<float>(other, 1).step();
    contacts += world.totals.wall_contacts;
    if (step % 50 != 0) continue;
    ASSERT_EQ(state_hash(world), state_hash(other)) << "step " << step;
  }
  EXPECT_EQ(state_hash(world), state_hash(other));
  EXPECT_GT(contacts, 3000);
}

}  // namespace
}  // namespace quern
