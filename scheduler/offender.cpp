// Who made a step go wrong: a look at all particles and contacts, for the message of a run that
// stops.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "kernels/pairs/sphere_facet.h"
#include "scheduler/step.h"

namespace quern {

// The first polyhedron whose place is not finite or outside.
template <class Real>
void find_outside_body(const World<Real>& world, Offender& found) {
  const Polyhedra<Real>& p = world.polyhedra;
  for (std::size_t k = 0; k < p.size() && found.id == kNoIndex; ++k) {
    const Vec3 x = p.place(k);
    bool bad = !x.allFinite() || !p.velocity(k).allFinite();
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      bad = bad || (!world.periodic[a] && !(x[e] >= world.low[e] && x[e] <= world.high[e]));
    }
    if (!bad) continue;
    found.id = p.first_id + static_cast<Index>(k);
    found.position = {x.x(), x.y(), x.z()};
  }
}

// The deepest overlap of a polyhedron, over the smaller radius.
template <class Real>
void find_deep_body(const World<Real>& world, Offender& found) {
  const Polyhedra<Real>& p = world.polyhedra;
  const auto take = [&](std::size_t body, double overlap, double radius) {
    if (overlap / radius <= found.overlap) return false;
    found.overlap = overlap / radius;
    found.id = p.first_id + static_cast<Index>(body);
    found.position = {p.x[body], p.y[body], p.z[body]};
    found.partner_is_wall = false;
    return true;
  };
  for (const PolyhedronPair& pair : p.pairs) {
    if (take(pair.i, pair.overlap, std::min(p.scale[pair.i], p.scale[pair.j]))) {
      found.partner = p.first_id + pair.j;
    }
  }
  for (const PolyhedronWall& wall : p.walls) {
    if (!take(wall.particle, wall.overlap, p.scale[wall.particle])) continue;
    found.partner = wall.wall;
    found.partner_is_wall = true;
  }
  const PolyhedronSphereBatch<Real>& batch = p.spheres;
  for (std::size_t g = 0; g < batch.polyhedron.size(); ++g) {
    for (Index slot = batch.begin[g]; slot < batch.begin[g] + batch.count[g]; ++slot) {
      const double radius =
          std::min(static_cast<double>(world.particles.record[batch.sphere[slot]].radius),
                   p.scale[batch.polyhedron[g]]);
      if (!take(batch.polyhedron[g], static_cast<double>(batch.number(slot, 9)), radius)) continue;
      found.partner = world.particles.id[batch.sphere[slot]];
    }
  }
}

template <class Real>
Offender find_offender(const World<Real>& world, std::uint32_t bits) {
  Offender found;
  const Particles<Real>& p = world.particles;
  const auto set = [&](std::size_t k) {
    found.id = p.id[k];
    found.position = {p.record[k].x, p.record[k].y, p.record[k].z};
  };
  find_outside_body(world, found);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Record<Real>& r = p.record[k];
    bool bad = !std::isfinite(r.x + r.y + r.z + r.vx + r.vy + r.vz + p.spin_x[k] + p.spin_y[k] +
                              p.spin_z[k]);
    const double x[3] = {r.x, r.y, r.z};
    for (int a = 0; a < 3; ++a) {
      const bool periodic = world.periodic[static_cast<std::size_t>(a)];
      bad = bad || (!periodic && !(x[a] >= world.low[a] && x[a] <= world.high[a]));
    }
    if (bad && p.id[k] < found.id) set(k);
  }
  if (found.id != kNoIndex || (bits & kDeepOverlap) == 0) return found;
  const auto look_at = [&](std::size_t, Index i, Index j) {
    const Record<Real>&a = p.record[i], &b = p.record[j];
    double dx[3] = {a.x - b.x, a.y - b.y, a.z - b.z};
    for (int e = 0; e < 3; ++e) {
      if (!world.periodic[static_cast<std::size_t>(e)]) continue;
      const double period = world.high[e] - world.low[e];
      dx[e] -= period * std::nearbyint(dx[e] / period);
    }
    const double overlap = static_cast<double>(a.radius) + static_cast<double>(b.radius) -
                           std::sqrt(dx[0] * dx[0] + dx[1] * dx[1] + dx[2] * dx[2]);
    if (overlap / static_cast<double>(a.radius) <= found.overlap) return;
    set(i);
    found.partner = p.id[j];
    found.overlap = overlap / static_cast<double>(a.radius);
  };
  for (std::size_t t = 0; t < world.tiles(); ++t) {
    world.pairs.for_each(t, PairBatch<Real>::Part::kOwn, look_at);
  }
  find_deep_body(world, found);
  for (const TileWalls& t : world.tile_walls) {
    for (const WallSpring& s : t.springs) {
      const double overlap = s.overlap / static_cast<double>(p.record[s.particle].radius);
      if (overlap <= found.overlap) continue;
      set(s.particle);
      found.partner = s.wall;
      found.partner_is_wall = true;
      found.overlap = overlap;
    }
  }
  return found;
}

namespace {

struct Flight {
  Index id, body;
  Vec3 place, velocity;     // m, at the end of the step; m/s
  double thickness, reach;  // m
};

// Whether a wall lies within the way of the step.
template <class Real>
bool is_too_fast(const World<Real>& world, const Flight& f, std::span<const Index> facets,
                 Offender& found) {
  const Body& body = world.bodies[f.body];
  const double dt = world.clock.dt;
  const Vec3 from = f.place - dt * f.velocity;
  const double way = dt * (f.velocity - body.velocity.at(from)).norm();
  if (!(way > f.thickness)) return false;
  const Vec3 in_body = body.pose.rotation.transpose() * (from - body.pose.shift);
  std::array<WallTouch, kMaxWallTouches> touch;
  const int count = sphere_facet_touches(body.facets, in_body, way + f.reach, facets, touch.data(),
                                         kMaxWallTouches);
  if (count == 0) return false;
  found = {f.id, touch[0].wall, true, {f.place.x(), f.place.y(), f.place.z()}, 0};
  return true;
}

}  // namespace

template <class Real>
Offender find_too_fast(const World<Real>& world) {
  Offender found;
  const Particles<Real>& p = world.particles;
  for (const TileWalls& tile : world.tile_walls) {
    const WallCandidates& c = tile.candidates;
    for (std::size_t k = 0; k < c.particle.size(); ++k) {
      const Record<Real>& r = p.record[c.particle[k]];
      const double radius = static_cast<double>(r.radius);
      const Flight f{p.id[c.particle[k]],    c.body[k], Vec3(r.x, r.y, r.z),
                     Vec3(r.vx, r.vy, r.vz), radius,    radius};
      const std::span<const Index> facets(c.facet.data() + c.first[k], c.first[k + 1] - c.first[k]);
      if (is_too_fast(world, f, facets, found)) return found;
    }
  }
  const Polyhedra<Real>& b = world.polyhedra;
  for (std::size_t k = 0; k < b.size(); ++k) {
    const Shape& shape = world.shapes[b.shape[k]];
    for (Index e = b.wall_candidate_begin[k]; e < b.wall_candidate_begin[k + 1]; ++e) {
      const Flight f{b.first_id + static_cast<Index>(k),
                     b.wall_candidate_body[e],
                     b.place(k),
                     b.velocity(k),
                     b.scale[k] * shape.inner_radius,
                     b.scale[k] * shape.bound_radius};
      const Index first = b.wall_candidate_facet_begin[e];
      const std::span<const Index> facets(b.wall_candidate_facet.data() + first,
                                          b.wall_candidate_facet_begin[e + 1] - first);
      if (is_too_fast(world, f, facets, found)) return found;
    }
  }
  return found;
}

template Offender find_too_fast(const World<float>&);
template Offender find_too_fast(const World<double>&);
template Offender find_offender(const World<float>&, std::uint32_t);
template Offender find_offender(const World<double>&, std::uint32_t);

}  // namespace quern
