// Brute force over all bodies and facets near each polyhedron, against its running lists; the plain
// narrow phase decides what touches.
#include <algorithm>
#include <cmath>

#include "kernels/pairs/polyhedron_polyhedron.h"
#include "kernels/pairs/polyhedron_sphere.h"
#include "scheduler/check_lists.h"
#include "soa/facet_closest.h"

namespace quern {

namespace {

// A touch within rounding of the positions is no contact that could be missed.
constexpr double kRounding = 1e-12;

template <class Real>
ShapePose pose_of(const World<Real>& world, std::size_t k) {
  const Polyhedra<Real>& q = world.polyhedra;
  return {&world.shapes[q.shape[k]], q.scale[k], q.place(k), q.orientation(k).toRotationMatrix()};
}

template <class Real>
double bound_of(const World<Real>& world, std::size_t k) {
  return world.polyhedra.scale[k] * world.shapes[world.polyhedra.shape[k]].bound_radius;
}

// The difference of two places to the nearest periodic image.
template <class Real>
Vec3 to_nearest(const World<Real>& world, Vec3 d) {
  for (Eigen::Index a = 0; a < 3; ++a) {
    if (!world.periodic[static_cast<std::size_t>(a)]) continue;
    const double length = world.high[a] - world.low[a];
    d[a] -= length * std::round(d[a] / length);
  }
  return d;
}

template <class Real>
std::string name_of(const World<Real>& world, std::size_t k) {
  return "polyhedron " + std::to_string(world.polyhedra.first_id + k);
}

template <class Real>
std::string name_of_sphere(const World<Real>& world, Index row) {
  return "sphere " + std::to_string(world.particles.id[row]);
}

// Rows of the spheres listed near each polyhedron, ascending.
template <class Real>
std::vector<std::vector<Index>> spheres_near(const World<Real>& world,
                                             std::vector<std::string>& faults) {
  const PolyhedronSphereBatch<Real>& batch = world.polyhedra.spheres;
  std::vector<std::vector<Index>> near(world.polyhedra.size());
  for (std::size_t t = 0; t + 1 < batch.tile_begin.size(); ++t) {
    for (Index g = batch.tile_begin[t]; g < batch.tile_begin[t + 1]; ++g) {
      for (Index slot = batch.begin[g]; slot < batch.begin[g] + batch.count[g]; ++slot) {
        const Index row = batch.sphere[slot];
        if (row / world.tile_size != t) {
          faults.push_back(name_of_sphere(world, row) + " is listed by a tile that is not its own");
        }
        near[batch.polyhedron[g]].push_back(row);
      }
    }
  }
  for (std::size_t k = 0; k < near.size(); ++k) {
    std::sort(near[k].begin(), near[k].end());
    if (std::adjacent_find(near[k].begin(), near[k].end()) != near[k].end()) {
      faults.push_back(name_of(world, k) + " lists a sphere twice");
    }
  }
  return near;
}

template <class Real>
void check_spheres(const World<Real>& world, std::vector<std::string>& faults) {
  const std::vector<std::vector<Index>> near = spheres_near(world, faults);
  for (std::size_t k = 0; k < near.size(); ++k) {
    const ShapePose pose = pose_of(world, k);
    for (Index row = 0; row < world.particles.size(); ++row) {
      const Record<Real>& r = world.particles.record[row];
      const double radius = static_cast<double>(r.radius), reach = radius + bound_of(world, k);
      const Vec3 center = to_nearest(world, Vec3(r.x, r.y, r.z) - pose.place);
      PolyhedronSphereTouch touch;
      if (center.squaredNorm() > reach * reach) continue;
      if (!touch_polyhedron_sphere(pose, center, radius, touch)) continue;
      if (touch.overlap < kRounding * reach) continue;
      if (std::binary_search(near[k].begin(), near[k].end(), row)) continue;
      faults.push_back(name_of(world, k) + " and " + name_of_sphere(world, row) +
                       " touch: not listed by the sphere's tile");
    }
  }
}

template <class Real>
void check_pairs(const World<Real>& world, std::vector<std::string>& faults) {
  const Polyhedra<Real>& q = world.polyhedra;
  std::vector<std::pair<Index, Index>> listed;
  for (const PolyhedronPair& pair : q.pairs) listed.emplace_back(pair.j, pair.i);
  std::sort(listed.begin(), listed.end());
  if (std::adjacent_find(listed.begin(), listed.end()) != listed.end()) {
    faults.push_back("a pair of polyhedra is listed twice");
  }
  for (Index i = 0; i < q.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      const double reach = bound_of(world, i) + bound_of(world, j);
      const Vec3 apart = to_nearest(world, q.place(i) - q.place(j));
      if (apart.squaredNorm() > reach * reach) continue;
      ShapePose a = pose_of(world, j), b = pose_of(world, i);
      a.place = Vec3::Zero();
      b.place = apart;
      PolyhedronTouch touch;
      if (!touch_polyhedra_plain(a, b, {}, nullptr, Vec3::Zero(), touch)) continue;
      if (touch.overlap < kRounding * reach) continue;
      if (std::binary_search(listed.begin(), listed.end(), std::pair(j, i))) continue;
      faults.push_back(name_of(world, j) + " and " + name_of(world, i) + " touch: not listed");
    }
  }
}

// Facets listed near body k of one wall body, ascending.
template <class Real>
std::vector<Index> facets_near(const World<Real>& world, std::size_t k, Index wall_body) {
  const Polyhedra<Real>& q = world.polyhedra;
  std::vector<Index> near;
  if (q.wall_candidate_begin.empty()) return near;
  for (Index e = q.wall_candidate_begin[k]; e < q.wall_candidate_begin[k + 1]; ++e) {
    if (q.wall_candidate_body[e] != wall_body) continue;
    near.insert(near.end(), q.wall_candidate_facet.begin() + q.wall_candidate_facet_begin[e],
                q.wall_candidate_facet.begin() + q.wall_candidate_facet_begin[e + 1]);
  }
  std::sort(near.begin(), near.end());
  return near;
}

// The narrow phase wants every facet that the bounding sphere reaches.
template <class Real>
void check_walls(const World<Real>& world, std::vector<std::string>& faults) {
  for (Index b = 0; b < world.bodies.size(); ++b) {
    const Body& body = world.bodies[b];
    const Pose pose = pose_at(body.motion, world.wall_time());
    for (std::size_t k = 0; k < world.polyhedra.size(); ++k) {
      const Vec3 x = pose.rotation.transpose() * (world.polyhedra.place(k) - pose.shift);
      const double reach = bound_of(world, k) * (1 - kRounding);
      const std::vector<Index> near = facets_near(world, k, b);
      for (Index f = 0; f < body.facets.record.size(); ++f) {
        if (closest_on_facet(body.facets.record[f], x).distance2 >= reach * reach) continue;
        if (std::binary_search(near.begin(), near.end(), f)) continue;
        faults.push_back(name_of(world, k) + " reaches facet " + std::to_string(f) + " of wall '" +
                         world.walls[body.facets.record[f].wall].name + "': not a candidate");
      }
    }
  }
}

}  // namespace

template <class Real>
std::vector<std::string> missed_polyhedron_contacts(const World<Real>& world) {
  std::vector<std::string> faults;
  if (world.clock.list_stale != 0 || world.polyhedra.empty()) return faults;
  check_spheres(world, faults);
  check_pairs(world, faults);
  check_walls(world, faults);
  return faults;
}

template std::vector<std::string> missed_polyhedron_contacts(const World<float>&);
template std::vector<std::string> missed_polyhedron_contacts(const World<double>&);

}  // namespace quern
