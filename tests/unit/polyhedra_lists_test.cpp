// The check of the lists of polyhedra must be able to fail: worlds by hand in which one touch is
// listed, or is not.
#include <gtest/gtest.h>

#include "scheduler/check_lists.h"
#include "tests/support/polyhedron_world.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

class PolyhedronLists : public testing::Test {
 protected:
  World<float> world = test::world_by_hand<float>();
  Polyhedra<float>& bodies = world.polyhedra;

  std::size_t faults() const { return missed_contacts(world).size(); }
  void put_sphere(Index row, const Vec3& x) {
    Record<float>& r = world.particles.record[row];
    r.x = x.x();
    r.y = x.y();
    r.z = x.z();
  }
  void put_body(Index k, const Vec3& x) {
    bodies.x[k] = x.x();
    bodies.y[k] = x.y();
    bodies.z[k] = x.z();
  }
  // A square of two triangles with its centre at x, facing upwards, as the only wall.
  void add_plate(const Vec3& x) {
    PlaneSpec plane;
    plane.point = x;
    plane.normal = Vec3::UnitY();
    Body plate;
    plate.facets = build_facets({{plane_patch(plane, x, 8), 0}}, 1);
    ASSERT_EQ(plate.facets.triangles(), 2u);
    world.bodies.push_back(std::move(plate));
    world.walls.push_back({"plate", 0, 0});
  }
};

TEST_F(PolyhedronLists, HaveNoFaultWhereNothingTouches) { EXPECT_EQ(faults(), 0u); }

TEST_F(PolyhedronLists, MustHoldASphereThatTouches) {
  put_sphere(1, bodies.place(0) + Vec3(0, 1.2, 0));
  EXPECT_EQ(faults(), 0u) << "listed";
  put_sphere(3, bodies.place(0) - Vec3(0, 1.2, 0));
  ASSERT_EQ(faults(), 1u);
  EXPECT_EQ(missed_contacts(world).front(),
            "polyhedron 6 and sphere 3 touch: not listed by the sphere's tile");
  world.clock.list_stale = 1;
  EXPECT_EQ(faults(), 0u) << "stale lists are not looked at";
}

// Within the bounding spheres, and beyond the body: a box of 1 x 2 x 3 has its nearest face at a
// third of its bounding sphere.
TEST_F(PolyhedronLists, NeedNotHoldASphereThatIsOnlyNear) {
  bodies.qw[1] = 1;
  bodies.qx[1] = bodies.qy[1] = bodies.qz[1] = 0;
  const Shape& box = world.shapes[0];
  double near = HUGE_VAL;
  Vec3 way = Vec3::Zero();
  for (std::size_t f = 0; f < box.faces; ++f) {
    if (box.d[f] < near) near = box.d[f], way = box.normal(f);
  }
  ASSERT_LT(near, 0.5 * box.bound_radius);
  put_sphere(3, bodies.place(1) + (near + 1 + 1e-6) * way);
  EXPECT_EQ(faults(), 0u);
  put_sphere(3, bodies.place(1) + (near + 1 - 1e-6) * way);
  EXPECT_EQ(faults(), 1u);
}

TEST_F(PolyhedronLists, MustHoldAPairThatTouches) {
  put_body(1, bodies.place(0) + Vec3(0.5, 0, 0));
  EXPECT_EQ(faults(), 0u) << "listed";
  put_body(2, bodies.place(1) + Vec3(0.7, 0, 0));
  EXPECT_EQ(faults(), 1u) << "2 and 0 are listed, 2 and 1 are not";
}

TEST_F(PolyhedronLists, MustHoldWhatTouchesAcrossAPeriodicFace) {
  put_body(1, {31.8, 0, 0});
  put_body(2, {-31.8, 0, 0});
  put_sphere(3, {-31.8, 1, 0});
  EXPECT_EQ(faults(), 1u) << "sphere 3 and body 2";
  world.periodic[0] = true;
  EXPECT_EQ(faults(), 3u) << "and body 1 with both";
}

TEST_F(PolyhedronLists, MustNotHoldAnythingTwice) {
  bodies.pairs.push_back(bodies.pairs.back());
  EXPECT_EQ(faults(), 1u);
  bodies.spheres.sphere[1] = bodies.spheres.sphere[0];
  EXPECT_EQ(faults(), 2u);
}

TEST_F(PolyhedronLists, MustHoldEveryFacetInReach) {
  const Vec3 x(10, -20, 0);
  add_plate(x);
  EXPECT_EQ(faults(), 0u);
  const auto middle = [&](std::size_t t) {
    const auto& c = world.bodies[0].facets.record[t].corner;
    return Vec3((c[0] + c[1] + c[2]) / 3);
  };
  put_body(1, x);  // both facets are candidates
  put_body(2, middle(1));
  EXPECT_EQ(faults(), 0u);
  put_body(2, middle(0));  // its candidate is facet 1
  EXPECT_EQ(faults(), 1u);
  put_body(0, x);  // without candidates
  put_body(1, x + Vec3(0, 5, 0));
  EXPECT_EQ(faults(), 3u);
}

}  // namespace
}  // namespace quern
