// The narrow phases of the step, asked once: polyhedra by their fast way, walls by patches.
#include "scheduler/body_overlap.h"

#include <algorithm>

#include "kernels/pairs/polyhedron_facet.h"
#include "kernels/pairs/polyhedron_polyhedron.h"
#include "kernels/pairs/polyhedron_sphere.h"

namespace quern {

namespace {

ShapePose pose_of(const ParticleSeed& p, const Vec3& place) {
  return {p.shape, p.radius, place, p.orientation.toRotationMatrix()};
}

}  // namespace

double overlap_of(const ParticleSeed& a, const ParticleSeed& b, const Vec3& between, double depth) {
  if (a.shape != nullptr && b.shape != nullptr) {
    PairAxis axis;
    PolyhedronTouch touch;
    const ShapePose first = pose_of(a, Vec3::Zero()), second = pose_of(b, between);
    return touch_polyhedra(first, second, {}, axis, touch) ? touch.overlap : 0;
  }
  if (a.shape == nullptr && b.shape == nullptr) return depth;
  const ParticleSeed &body = a.shape != nullptr ? a : b, &sphere = a.shape != nullptr ? b : a;
  const Vec3 center = a.shape != nullptr ? between : Vec3(-between);
  PolyhedronSphereTouch touch;
  const bool touches =
      touch_polyhedron_sphere(pose_of(body, Vec3::Zero()), center, sphere.radius, touch);
  return touches ? touch.overlap : 0;
}

double polyhedron_wall_overlap(std::span<const Facets* const> walls, const ParticleSeed& p) {
  double deepest = 0;
  std::vector<Index> near;
  WallPatch patches[kMaxWallPatches];
  for (const Facets* facets : walls) {
    near.clear();
    find_facets(*facets, p.position, p.reach(), near);
    const int count = polyhedron_facet_touches(*facets, pose_of(p, p.position), near, {}, patches,
                                               kMaxWallPatches);
    for (int k = 0; k < count; ++k) deepest = std::max(deepest, patches[k].overlap);
  }
  return deepest;
}

}  // namespace quern
