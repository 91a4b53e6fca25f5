// Patches of walls inside a polyhedron; see polyhedron_facet.h.
//
// Everything is formed relative to the polyhedron's centre, in its body frame and in units of its
// equivalent radius: a plane's section with the polyhedron is local, and a triangle, however large,
// only cuts that section by its three edges. The section serves all triangles of the plane, and is
// one part as it is where no edge of the plane's group comes near: most contacts. Joining goes by
// planes, not triangles: which triangle owns an edge must not matter.
#include "kernels/pairs/polyhedron_facet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/pairs/facet_work.h"

namespace quern {
namespace {

using namespace facet_work;

constexpr int kMaxCuts = 12;
constexpr double kSameLine = 1e-12;  // two cuts are one; of the equivalent radius
constexpr double kOnCut = 1e-9;      // a part may stand out of a cut by this much
constexpr double kRounding = 4e-16;
constexpr double kMargin = 1e-9;  // about a section, of the equivalent radius

bool keep_polygon(Work& work, Kept& kept) noexcept {
  const ClippedPolygon& polygon = *work.buffers.now;
  if (work.corners + polygon.corners > kMaxCornersKept) {
    work.full = true;
    return false;
  }
  kept = {work.corners, polygon.corners};
  std::copy_n(polygon.corner, polygon.corners, work.corner.begin() + work.corners);
  work.corners += polygon.corners;
  return true;
}

void load_polygon(Work& work, const Kept& kept, int label) noexcept {
  work.buffers.start();
  for (int k = 0; k < kept.count; ++k) {
    work.buffers.add(work.corner[static_cast<std::size_t>(kept.first + k)], label);
  }
}

// The plane through edge k of the triangle, across it, outward.
Plane edge_plane(const Work& work, const FacetRecord& facet, std::size_t k) noexcept {
  const Vec3& from = facet.corner[k];
  const Vec3 out = (facet.corner[(k + 1) % 3] - from).cross(facet.normal).normalized();
  return {work.turned(out), out.dot(from - work.pose.place) / work.pose.scale};
}

Plane facet_plane(const Work& work, const FacetRecord& facet) noexcept {
  return {work.turned(facet.normal),
          facet.normal.dot(facet.corner[0] - work.pose.place) / work.pose.scale};
}

// A circle about the section, a little larger.
void set_circle(const Work& work, const ClippedPolygon& section, Surface& surface) noexcept {
  Vec3 middle = Vec3::Zero();
  for (int k = 0; k < section.corners; ++k) middle += section.corner[k];
  middle /= section.corners;
  double most = 0;
  for (int k = 0; k < section.corners; ++k) {
    most = std::max(most, (section.corner[k] - middle).squaredNorm());
  }
  surface.middle = work.pose.place + work.pose.scale * (work.pose.turn * middle);
  surface.radius = work.pose.scale * (std::sqrt(most) * (1 + kMargin) + 2 * kMargin);
}

// Whether the group is known with another normal, so that its surfaces end at flat edges too.
bool mark_uneven(Work& work, Index group) noexcept {
  bool uneven = false;
  for (int s = 0; s < work.surfaces; ++s) {
    Surface& known = work.surface[static_cast<std::size_t>(s)];
    if (known.group == group) known.edged = uneven = true;
  }
  return uneven;
}

// Index of the surface the triangle lies in, or -1 if its plane does not cut the polyhedron.
int surface_of(Work& work, const FacetRecord& facet) noexcept {
  for (int s = work.surfaces - 1; s >= 0; --s) {
    const Surface& known = work.surface[static_cast<std::size_t>(s)];
    if (known.group == facet.group && known.normal == facet.normal) {
      return known.section.count > 0 ? s : -1;
    }
  }
  const Plane plane = facet_plane(work, facet);
  if (std::abs(plane.offset) >= work.shape.bound_radius) return -1;
  if (work.surfaces == kMaxSurfaces) {
    work.full = true;
    return -1;
  }
  Surface& surface = work.surface[static_cast<std::size_t>(work.surfaces)];
  Kept section = {0, 0};
  surface.edged = mark_uneven(work, facet.group);
  const bool cut = section_of_shape(work.shape, plane, work.buffers, surface.cut);
  if (!cut && work.surfaces >= kMaxSurfaces / 2) {  // not worth remembering
    work.crowded = true;
    return -1;
  }
  if (cut && !keep_polygon(work, section)) return -1;
  surface.plane = plane;
  surface.normal = facet.normal;
  surface.group = facet.group;
  surface.wall = facet.wall;
  surface.section = section;
  if (cut) {
    surface.section_area = polygon_area(*work.buffers.now, plane.normal);
    set_circle(work, *work.buffers.now, surface);
  }
  surface.centred = false;
  surface.triangle = kNoIndex;
  surface.area = 0;
  surface.moment = Vec3::Zero();
  surface.patch = work.surfaces++;
  return cut ? surface.patch : -1;
}

// Integral of x over the polygon, and its area.
double add_moment(const ClippedPolygon& polygon, const Vec3& normal, Vec3& first) noexcept {
  double area = 0;
  for (int k = 1; k + 1 < polygon.corners; ++k) {
    const Vec3 &o = polygon.corner[0], &a = polygon.corner[k], &b = polygon.corner[k + 1];
    const double piece = 0.5 * normal.dot((a - o).cross(b - o));
    area += piece;
    first += (piece / 3.0) * (o + a + b);
  }
  return area;
}

double perimeter(const ClippedPolygon& polygon) noexcept {
  double sum = 0;
  for (int k = 0; k < polygon.corners; ++k) {
    sum += (polygon.corner[k + 1 < polygon.corners ? k + 1 : 0] - polygon.corner[k]).norm();
  }
  return sum;
}

// How far the middle of the section lies beyond edge k of the triangle, over the edge's length.
double beyond_edge(const Surface& surface, const FacetRecord& facet, std::size_t k,
                   double& size2) noexcept {
  const Vec3 side = facet.corner[(k + 1) % 3] - facet.corner[k];
  size2 = side.squaredNorm();
  return side.cross(facet.normal).dot(surface.middle - facet.corner[k]);
}

// Takes the triangle down for add_part() unless it lies apart from the section, and what it tells
// of whether its group covers the section.
void add_near(Work& work, Index triangle, int s) noexcept {
  Surface& surface = work.surface[static_cast<std::size_t>(s)];
  const FacetRecord& facet = work.facets.record[triangle];
  const double radius2 = surface.radius * surface.radius;
  const double close = kMargin * work.pose.scale;
  bool edged = false, centred = true;
  for (std::size_t k = 0; k < 3; ++k) {
    double size2;
    const double beyond = beyond_edge(surface, facet, k, size2);
    const bool crosses = beyond * beyond < radius2 * size2;
    if (!crosses && beyond > 0) return;
    edged |= crosses && (facet.edge[k] & kInsideGroup) == 0;
    centred &= beyond <= 0 || beyond * beyond <= close * close * size2;
  }
  if (work.nears == kMaxParts) {
    work.full = true;
    return;
  }
  surface.edged |= edged;
  surface.centred |= centred;
  surface.triangle = std::min(surface.triangle, triangle);
  work.near[static_cast<std::size_t>(work.nears++)] = {triangle, s};
}

// A part of the wall: the polygon in the buffers, of which `corners` are kept if `whole`, the
// section as it is.
void add_polygon(Work& work, Part part, bool whole) noexcept {
  Surface& surface = work.surface[static_cast<std::size_t>(part.surface)];
  const ClippedPolygon& polygon = *work.buffers.now;
  Vec3 first = Vec3::Zero();
  const double area = add_moment(polygon, surface.plane.normal, first);
  // The perimeter is less than that of the circle.
  const double noise = kRounding * work.shape.bound_radius;
  if (area <= noise * (2 * kPi * surface.radius / work.pose.scale) &&
      area <= noise * perimeter(polygon)) {
    return;
  }
  if (work.parts == kMaxParts || (!whole && !keep_polygon(work, part.corners))) {
    work.full = true;
    return;
  }
  for (int k = 0; k < polygon.corners; ++k) {
    if (polygon.beyond[k] < 3) part.edges |= 1u << polygon.beyond[k];
  }
  surface.area += area;
  surface.moment += first.cross(surface.plane.normal);
  work.part[static_cast<std::size_t>(work.parts++)] = part;
}

// The part of a triangle of a plane that its group does not cover for sure.
void add_part(Work& work, const NearTriangle& near) noexcept {
  const Surface& surface = work.surface[static_cast<std::size_t>(near.surface)];
  const FacetRecord& facet = work.facets.record[near.triangle];
  load_polygon(work, surface.section, 3);
  bool whole = true;  // no edge comes near
  for (std::size_t k = 0; k < 3; ++k) {
    double size2;
    const double beyond = beyond_edge(surface, facet, k, size2);
    if (beyond < 0 && beyond * beyond >= surface.radius * surface.radius * size2) continue;
    if (!clip_polygon(work.buffers, edge_plane(work, facet, k), static_cast<int>(k))) return;
    whole = false;
  }
  add_polygon(work, {near.triangle, near.surface, 0, surface.section}, whole);
}

// Whether the group covers the section: no edge that ends it comes near, and it is there.
bool is_covered(const Work& work, int s) noexcept {
  const Surface& surface = work.surface[static_cast<std::size_t>(s)];
  return surface.section.count > 0 && surface.centred && !surface.edged && !work.crowded;
}

void add_parts(Work& work) noexcept {
  for (int s = 0; s < work.surfaces; ++s) {
    if (!is_covered(work, s)) continue;
    const Surface& surface = work.surface[static_cast<std::size_t>(s)];
    load_polygon(work, surface.section, 3);
    add_polygon(work, {surface.triangle, s, 0, surface.section}, true);
  }
  for (int k = 0; k < work.nears; ++k) {
    const NearTriangle& near = work.near[static_cast<std::size_t>(k)];
    if (!is_covered(work, near.surface)) add_part(work, near);
  }
}

// Whether the edge passes within the bound radius of the polyhedron's centre.
bool is_near(const Work& work, const FacetRecord& facet, std::size_t k) noexcept {
  const Vec3 from = facet.corner[k] - work.pose.place;
  const Vec3 along = facet.corner[(k + 1) % 3] - facet.corner[k];
  const double t = std::clamp(-from.dot(along) / along.squaredNorm(), 0.0, 1.0);
  const double reach = work.shape.bound_radius * work.pose.scale;
  return (from + t * along).squaredNorm() <= reach * reach;
}

void add_joints(Work& work, Index triangle, int s) noexcept {
  const FacetRecord& facet = work.facets.record[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    if ((facet.edge[k] & kInsideGroup) != 0) continue;
    const Index edge = facet.edge[k];
    if (work.facets.edge_kind[edge] != EdgeKind::kConvex || !is_near(work, facet, k)) continue;
    if (work.joints == kMaxJoints) {
      work.full = true;
      return;
    }
    work.joint[static_cast<std::size_t>(work.joints++)] = {edge, s};
  }
}

int root(const Work& work, int s) noexcept {
  while (work.surface[static_cast<std::size_t>(s)].patch != s) {
    s = work.surface[static_cast<std::size_t>(s)].patch;
  }
  return s;
}

void join(Work& work, int a, int b) noexcept {
  a = root(work, a);
  b = root(work, b);
  work.surface[static_cast<std::size_t>(std::max(a, b))].patch = std::min(a, b);
}

// Surfaces with a part of the wall in the polyhedron, joined into patches.
void join_surfaces(Work& work) noexcept {
  const auto area = [&](int s) { return work.surface[static_cast<std::size_t>(s)].area; };
  const auto group = [&](int s) { return work.surface[static_cast<std::size_t>(s)].group; };
  for (int a = 0; a < work.surfaces; ++a) {
    for (int b = 0; b < a; ++b) {
      if (area(a) > 0 && area(b) > 0 && group(a) == group(b)) join(work, a, b);
    }
  }
  Joint* joint = work.joint.data();
  std::sort(joint, joint + work.joints, [](const Joint& a, const Joint& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.surface < b.surface;
  });
  for (int k = 1; k < work.joints; ++k) {
    const int a = joint[k - 1].surface, b = joint[k].surface;
    if (joint[k - 1].edge == joint[k].edge && area(a) > 0 && area(b) > 0) join(work, a, b);
  }
}

// The planes of a patch, its surfaces first, then the limits at its edges.
struct PatchPlanes {
  std::array<Plane, kMaxPatchPlanes> plane;
  std::size_t walls = 0, count = 0;
  std::uint32_t flags = 0;
  std::span<const Plane> all() const { return {plane.data(), count}; }
};

bool bounds_patch(const Work& work, const Part& part, std::size_t k) noexcept {
  if ((part.edges >> k & 1) == 0) return false;
  const EdgeKind kind = work.facets.edge_kind[work.facets.edge_of[3 * part.triangle + k]];
  return kind != EdgeKind::kFlat && kind != EdgeKind::kConvex;
}

bool keeps_all_parts(const Work& work, const Plane& cut, int patch) noexcept {
  for (int p = 0; p < work.parts; ++p) {
    const Part& part = work.part[static_cast<std::size_t>(p)];
    if (root(work, part.surface) != patch) continue;
    for (int k = 0; k < part.corners.count; ++k) {
      const Vec3& x = work.corner[static_cast<std::size_t>(part.corners.first + k)];
      if (cut.height(x) > kOnCut) return false;
    }
  }
  return true;
}

void add_cut(const Work& work, const Plane& cut, int patch, PatchPlanes& planes) noexcept {
  for (std::size_t k = planes.walls; k < planes.count; ++k) {
    const Plane& known = planes.plane[k];
    if ((known.normal - cut.normal).norm() < kSameLine &&
        std::abs(known.offset - cut.offset) < kSameLine) {
      return;
    }
  }
  if (!keeps_all_parts(work, cut, patch)) {
    planes.flags |= kPatchNotched;
  } else if (planes.count < kMaxPatchPlanes && planes.count < planes.walls + kMaxCuts) {
    planes.plane[planes.count++] = cut;
    planes.flags |= kPatchLimited;
  } else {
    planes.flags |= kPatchFull;
  }
}

void gather_planes(const Work& work, int patch, PatchPlanes& planes) noexcept {
  for (int s = 0; s < work.surfaces; ++s) {
    const Surface& surface = work.surface[static_cast<std::size_t>(s)];
    if (surface.area > 0 && root(work, s) == patch) planes.plane[planes.count++] = surface.plane;
  }
  planes.walls = planes.count;
  for (int p = 0; p < work.parts; ++p) {
    const Part& part = work.part[static_cast<std::size_t>(p)];
    if (root(work, part.surface) != patch) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!bounds_patch(work, part, k)) continue;
      add_cut(work, edge_plane(work, work.facets.record[part.triangle], k), patch, planes);
    }
  }
}

// Sums over the surfaces of a patch, in body units; normal in the frame of the wall's body.
struct PatchSums {
  Vec3 vector_area = Vec3::Zero(), moment = Vec3::Zero(), middle = Vec3::Zero();
  double area = 0;
  int surfaces = 0, largest = 0;
  Index feature = kNoIndex, wall = 0;
};

PatchSums sum_patch(const Work& work, int patch) noexcept {
  PatchSums sums;
  double most = 0;
  for (int s = 0; s < work.surfaces; ++s) {
    const Surface& surface = work.surface[static_cast<std::size_t>(s)];
    if (surface.area <= 0 || root(work, s) != patch) continue;
    sums.vector_area += surface.area * surface.normal;
    sums.moment += surface.moment;
    sums.feature = std::min(sums.feature, surface.group);
    sums.wall = surface.wall;
    ++sums.surfaces;
    if (surface.area > most) sums.largest = s;
    most = std::max(most, surface.area);
  }
  sums.area = sums.vector_area.norm();
  return sums;
}

// Behind all planes; where they leave nothing, behind the largest surface alone.
bool overlap_of_patch(const Work& work, int patch, const PatchSums& sums, const Vec3& normal,
                      std::uint32_t& flags, WallOverlap& overlap) noexcept {
  PatchPlanes planes;
  gather_planes(work, patch, planes);
  flags |= planes.flags;
  if (planes.count == 1) {
    const Surface& only = work.surface[static_cast<std::size_t>(sums.largest)];
    const Vec3& corner = work.corner[static_cast<std::size_t>(only.section.first)];
    return overlap_behind_plane(work.shape, only.plane, only.cut, {corner, only.section_area},
                                overlap);
  }
  const Vec3 n = work.turned(normal);
  if (overlap_with_wall(work.shape, planes.all(), n, overlap)) return true;
  flags |= kPatchThin;
  const Plane& largest = work.surface[static_cast<std::size_t>(sums.largest)].plane;
  return overlap_with_wall(work.shape, {&largest, 1}, n, overlap);
}

bool build_patch(const Work& work, int patch, const WallPatchOptions& options,
                 WallPatch& out) noexcept {
  const PatchSums sums = sum_patch(work, patch);
  if (sums.area <= 0) return false;
  out.normal = sums.surfaces == 1 ? work.surface[static_cast<std::size_t>(sums.largest)].normal
                                  : Vec3(sums.vector_area / sums.area);
  out.flags = work.full ? kPatchFull : 0u;
  WallOverlap overlap;
  if (!overlap_of_patch(work, patch, sums, out.normal, out.flags, overlap)) return false;
  if (overlap.full) out.flags |= kPatchFull;
  const double scale = work.pose.scale;
  const double depth = options.overlap == OverlapMeasure::kWidth ? overlap.width : overlap.depth;
  const double thickness =
      options.thickness > 0 ? options.thickness : work.shape.inner_radius * scale;
  out.overlap = std::min(depth * scale, thickness);
  if (depth * scale > thickness) out.flags |= kPatchDeep;
  const Vec3 arm = work.pose.turn * overlap.centroid;
  if (arm.dot(out.normal) > 0) out.flags |= kPatchBehind;
  out.point = work.pose.place + scale * arm;
  out.area = sums.area * scale * scale;
  out.vector_area = (scale * scale) * sums.vector_area;
  out.moment = (scale * scale * scale) * (work.pose.turn * sums.moment);
  out.volume = overlap.volume * scale * scale * scale;
  out.feature = sums.feature;
  out.wall = sums.wall;
  return out.overlap > 0;
}

void insert_patch(const WallPatch& patch, WallPatch* out, int capacity, int& count) noexcept {
  if (count == capacity) {
    WallPatch* least = std::min_element(
        out, out + count, [](const WallPatch& a, const WallPatch& b) { return a.area < b.area; });
    if (count == 0 || least->area >= patch.area) return;
    std::move(least + 1, out + count, least);
    --count;
  }
  int at = count++;
  const auto after = [&](const WallPatch& other) {
    return other.wall != patch.wall ? other.wall > patch.wall : other.feature > patch.feature;
  };
  for (; at > 0 && after(out[at - 1]); --at) out[at] = out[at - 1];
  out[at] = patch;
}

}  // namespace

int polyhedron_facet_touches(const Facets& facets, const ShapePose& pose,
                             std::span<const Index> candidates, const WallPatchOptions& options,
                             WallPatch* out, int capacity) noexcept {
  Work work(facets, pose);
  const double reach = work.shape.bound_radius * pose.scale;
  for (const Index triangle : candidates) {
    const FacetRecord& facet = facets.record[triangle];
    if (std::abs(facet.normal.dot(pose.place - facet.corner[0])) >= reach) continue;
    const int s = surface_of(work, facet);
    if (s < 0) continue;
    add_near(work, triangle, s);
    add_joints(work, triangle, s);
  }
  add_parts(work);
  if (work.parts == 0) return 0;
  join_surfaces(work);
  int count = 0;
  bool left_out = false;
  for (int s = 0; s < work.surfaces; ++s) {
    WallPatch patch;
    if (work.surface[static_cast<std::size_t>(s)].patch != s) continue;
    if (!build_patch(work, s, options, patch)) continue;
    left_out = left_out || count == capacity;
    insert_patch(patch, out, capacity, count);
  }
  if (left_out && count > 0) out[0].flags |= kPatchFull;
  return count;
}

}  // namespace quern
