// A small world with polyhedra, filled by hand: nothing of it has been stepped, every number is
// another one.
//
// Six spheres of 1 in tiles of four, two shapes (a box, a rock) and three polyhedra of equivalent
// radius 1, in a domain of 64 about the origin. Polyhedra 0 and 1 are an open pair, 0 and 2 a
// listed one; 1 and 2 press into a wall; spheres 0 and 4 touch polyhedra, others are listed near
// them.
#pragma once

#include "soa/world.h"
#include "tests/support/test_shapes.h"

namespace quern::test {

inline constexpr Index kSpheres = 6, kPolyhedra = 3;

class Numbers {  // one after the other, none of them zero
 public:
  double operator()() { return next_ += 0.125 + 1e-9; }
  Vec3 vector() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }

 private:
  double next_ = 1;
};

template <class Real>
void add_spheres(World<Real>& world, Numbers& number) {
  Particles<Real>& p = world.particles;
  p.resize(kSpheres);
  for (Index k = 0; k < kSpheres; ++k) {
    Record<Real>& r = p.record[k];
    r = Record<Real>();
    r.x = -20 + 4.0 * k;
    r.vx = number();
    r.radius = 1;
    p.traits[k] = {Real(1), make_tag(0, 1)};
    p.id[k] = k;
    p.species[k] = 0;
    p.spin_x[k] = number();
    p.spin_y[k] = p.spin_z[k] = p.list_x[k] = p.list_y[k] = p.list_z[k] = 0;
    p.rest_x[k] = p.rest_y[k] = p.rest_z[k] = 0;
    p.list_vx[k] = p.list_vy[k] = p.list_vz[k] = 0;
    p.pair_first[k] = p.pair_count[k] = 0;
  }
  world.tile_walls.resize(world.tiles());
  world.pairs.reset(0, 0);
  world.pairs.begin.reset(world.tiles() + 1);
  world.pairs.own_end.reset(world.tiles());
  for (Column<Index>* c : {&world.pairs.row_begin, &world.pairs.begin, &world.pairs.own_end}) {
    c->fill(0);
  }
}

template <class Real>
void add_polyhedra(World<Real>& world, Numbers& number) {
  world.shapes.push_back(built_box({1, 2, 3}));
  world.shapes.push_back(rock(12, 7));
  Polyhedra<Real>& p = world.polyhedra;
  p.resize(kPolyhedra);
#define QUERN_CLEAR(type, name, unit, doc) p.name.fill(0);
  QUERN_POLYHEDRON_FIELDS(QUERN_CLEAR)
#undef QUERN_CLEAR
  p.first_id = kSpheres;
  for (Index k = 0; k < kPolyhedra; ++k) {
    p.x[k] = 10 + 4.0 * k;
    for (Column<double>* c : {&p.vx, &p.vy, &p.vz, &p.lx, &p.ly, &p.lz, &p.wx, &p.wy, &p.wz}) {
      (*c)[k] = number();
    }
    const Quat q = Quat(number(), number(), number(), number()).normalized();
    p.qw[k] = q.w();
    p.qx[k] = q.x();
    p.qy[k] = q.y();
    p.qz[k] = q.z();
    p.scale[k] = p.inverse_mass[k] = 1;
    p.shape[k] = k == 1 ? 0 : 1;
    p.species[k] = 1;
    p.contacts[k] = k + 1;
  }
}

template <class Real>
void add_contacts(Polyhedra<Real>& p, Numbers& number) {
  for (const Index i : {1u, 2u}) {
    PolyhedronPair pair;
    pair.i = i;
    pair.axis[0] = 0.5f;
    if (i == 1) {
      pair.touching = 1;
      for (Vec3* v :
           {&pair.spring, &pair.force, &pair.moment, &pair.normal, &pair.arm_i, &pair.arm_j}) {
        *v = number.vector();
      }
      pair.overlap = number();
      pair.elastic_force = number();
    }
    p.pairs.push_back(pair);
    WallSpring& spring = p.walls.emplace_back();
    spring.particle = i;
    spring.feature = 7;
    for (Vec3* v : {&spring.spring, &spring.force, &spring.normal, &spring.point, &spring.moment}) {
      *v = number.vector();
    }
    spring.overlap = number();
  }
  p.wall_candidate_begin = {0, 0, 1, 2};
  p.wall_candidate_body = {0, 0};
  p.wall_candidate_facet_begin = {0, 2, 3};
  p.wall_candidate_facet = {0, 1, 1};
}

// Groups of tile 0: spheres 0, 1 near polyhedron 0 and sphere 2 near 1; of tile 1: 4, 5 near 0.
template <class Real>
void add_sphere_groups(PolyhedronSphereBatch<Real>& batch, Numbers& number) {
  const auto set = [](Column<Index>& column, std::initializer_list<Index> values) {
    column.reset(values.size());
    std::copy(values.begin(), values.end(), column.begin());
  };
  constexpr Index pad = kShapePad;
  set(batch.tile_begin, {0, 2, 3});
  set(batch.polyhedron, {0, 1, 0});
  set(batch.count, {2, 1, 2});
  set(batch.begin, {0, pad, 2 * pad, 3 * pad});
  const Index sphere[3][2] = {{0, 1}, {2, 2}, {4, 5}};
  batch.sphere.reset(3 * pad);
  for (Index s = 0; s < 3 * pad; ++s) batch.sphere[s] = sphere[s / pad][s % pad == 1 ? 1 : 0];
  batch.numbers.reset(3 * pad * batch.kHistoryStride);
  batch.numbers.fill(0);
  for (const Index slot : {0u, 2 * pad}) {
    for (std::size_t k = 0; k < batch.kHistory; ++k) {
      batch.number(slot, k) = static_cast<Real>(number());
    }
  }
  batch.number(1, batch.kOverlap) = Real(-0.5);  // apart: what is known of the gap
  batch.set_unsaved();
}

template <class Real>
World<Real> world_by_hand(bool polyhedra = true) {
  World<Real> world;
  Numbers number;
  world.tile_size = 4;
  world.low = Vec3::Constant(-32);
  world.high = Vec3::Constant(32);
  world.clock.list_stale = 0;
  world.clock.dt = number();
  add_spheres(world, number);
  if (!polyhedra) return world;
  add_polyhedra(world, number);
  add_contacts(world.polyhedra, number);
  add_sphere_groups(world.polyhedra.spheres, number);
  world.ledger.model_work = number();
  return world;
}

}  // namespace quern::test
