// Reports of closest points, one a triangle; their choice by local minimum; see sphere_facet.h.
//
// A point counts as the closest point of a neighbour if the neighbour's own is within 1e-6 R of it.
// Comparing places instead of feature ids makes the choice proof against rounding: beside an edge
// one triangle may name the edge and the other its corner, and both mean the same point. Two
// touches at one place (same tolerance) that share a coplanar group are one; the nearer is kept.
#include "kernels/pairs/sphere_facet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soa/facet_closest.h"

namespace quern {
namespace {

constexpr int kMaxReports = 192;
constexpr double kSamePlace = 1e-6;  // of the radius
constexpr double kStraightThrough = -0.999;
constexpr double kOfWay = 0.999;      // the rest is for rounding
constexpr double kOnTheWall = 1e-12;  // of the radius: below, the facet's normal is taken

struct Report {
  Vec3 offset;  // closest point minus centre
  double distance2;
  const FacetRecord* facet;
  Index triangle, feature;
  int region;
};

// All that the choice needs: the reports within the radius, nearest first within each wall.
struct Reports {
  const Facets& facets;
  double radius;
  Report list[kMaxReports];
  int count = 0;

  Reports(const Facets& f, double r) noexcept : facets(f), radius(r) {}
  const Report* begin() const { return list; }
  const Report* end() const { return list + count; }
  bool same_place(const Report& a, const Report& b) const {
    const double reach = kSamePlace * radius;
    return a.facet->wall == b.facet->wall && (a.offset - b.offset).squaredNorm() < reach * reach;
  }
};

Index feature_id(const Facets& f, const FacetRecord& facet, int region) noexcept {
  if (region == 0) return facet.group;
  const bool is_edge = region < 4;
  const Index id =
      is_edge ? facet.edge[std::size_t(region - 1)] : facet.vertex[std::size_t(region - 4)];
  if (id & kInsideGroup) return facet.group;
  return f.groups + (is_edge ? id : f.edges() + id);
}

// Whether the triangle of `other` is one of those around the feature that `report` lies on.
bool is_around(const Report& other, const Report& report) noexcept {
  const auto has = [](const std::array<Index, 3>& ids, Index id) {
    return ids[0] == id || ids[1] == id || ids[2] == id;
  };
  const int region = report.region;
  if (region == 0) return other.triangle == report.triangle;
  if (region < 4) return has(other.facet->edge, report.facet->edge[std::size_t(region - 1)]);
  return has(other.facet->vertex, report.facet->vertex[std::size_t(region - 4)]);
}

int valence(const Facets& f, const Report& report) noexcept {
  if (report.region == 0) return 1;
  if (report.region < 4) {
    return f.edge_valence[report.facet->edge[std::size_t(report.region - 1)] & ~kInsideGroup];
  }
  return f.vertex_valence[report.facet->vertex[std::size_t(report.region - 4)] & ~kInsideGroup];
}

bool nearer(const Report& a, const Report& b) noexcept {
  if (a.facet->wall != b.facet->wall) return a.facet->wall < b.facet->wall;
  if (a.distance2 != b.distance2) return a.distance2 < b.distance2;
  return a.feature != b.feature ? a.feature < b.feature : a.triangle < b.triangle;
}

void add_report(Reports& reports, const Report& report) noexcept {
  if (reports.count < kMaxReports) {
    reports.list[reports.count++] = report;
    return;
  }
  Report* farthest =
      std::max_element(reports.list, reports.list + kMaxReports,
                       [](const Report& a, const Report& b) { return a.distance2 < b.distance2; });
  if (report.distance2 < farthest->distance2) *farthest = report;
}

void collect(Reports& reports, const Vec3& center, std::span<const Index> candidates) noexcept {
  const double radius = reports.radius;
  for (const Index t : candidates) {
    const FacetRecord& facet = reports.facets.record[t];
    if (std::abs(facet.normal.dot(center - facet.corner[0])) >= radius) continue;
    const ClosestPoint p = closest_on_facet(facet, center);
    if (!(p.distance2 < radius * radius)) continue;
    add_report(reports, {p.offset, p.distance2, &facet, t,
                         feature_id(reports.facets, facet, p.region), p.region});
  }
  std::sort(reports.list, reports.list + reports.count, nearer);
}

// Every triangle around the report's feature has its closest point here.
bool is_local_minimum(const Reports& reports, const Report& report) noexcept {
  if (report.region == 0) return true;
  int here = 0;
  for (const Report& other : reports) {
    here += is_around(other, report) && reports.same_place(other, report) ? 1 : 0;
  }
  return here >= valence(reports.facets, report);
}

// Two reports at one place are one contact if a triangle around each lies in the same group.
bool share_group(const Reports& reports, const Report& a, const Report& b) noexcept {
  for (const Report& x : reports) {
    if (!is_around(x, a)) continue;
    for (const Report& y : reports) {
      if (is_around(y, b) && x.facet->group == y.facet->group) return true;
    }
  }
  return false;
}

bool is_repeat(const Reports& reports, const Report& report, const Report* const* kept,
               int count) noexcept {
  for (int i = 0; i < count; ++i) {
    if (kept[i]->feature == report.feature) return true;
    if (reports.same_place(*kept[i], report) && share_group(reports, *kept[i], report)) return true;
  }
  return false;
}

// Picks the touches among the reports into `kept`; returns how many.
int choose(const Reports& reports, const Report** kept) noexcept {
  int count = 0;
  const Report* last = nullptr;
  for (const Report& report : reports) {
    const bool nearest = last == nullptr || last->facet->wall != report.facet->wall;
    last = &report;
    if (!nearest && is_repeat(reports, report, kept, count)) continue;
    if (nearest || is_local_minimum(reports, report)) kept[count++] = &report;
  }
  return count;
}

bool is_behind(const Reports& reports, const Report& report) noexcept {
  Vec3 front = Vec3::Zero();
  for (const Report& other : reports) {
    if (is_around(other, report)) front += other.facet->normal;
  }
  return front.dot(report.offset) > 0;
}

WallTouch touch_of(const Reports& reports, const Report& report, const Vec3& center) noexcept {
  const double distance = std::sqrt(report.distance2);
  WallTouch touch;
  touch.behind = is_behind(reports, report);
  touch.normal = report.facet->normal;
  if (distance > kOnTheWall * reports.radius) {
    // An edge or vertex inside a plane group is a place on the face like any other.
    touch.normal = report.feature == report.facet->group
                       ? Vec3((touch.behind ? -1.0 : 1.0) * report.facet->normal)
                       : Vec3(-report.offset / distance);
  } else {
    touch.behind = false;
  }
  touch.overlap = reports.radius - distance;
  touch.point = center + report.offset;
  touch.feature = report.feature;
  touch.wall = report.facet->wall;
  touch.facet = report.triangle;
  touch.nearest = true;
  for (const Report& other : reports) {
    if (other.facet->wall == touch.wall) {
      touch.nearest = &other == &report;
      break;
    }
  }
  return touch;
}

// From the foot of the point on the facet to the nearest edge; the foot lies within.
double way_to_edges(const FacetRecord& facet, const Vec3& x) noexcept {
  double way = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = facet.corner[(k + 1) % 3] - facet.corner[k];
    way = std::min(way, facet.normal.dot(edge.cross(x - facet.corner[k])) / edge.norm());
  }
  return way;
}

}  // namespace

int sphere_facet_touches(const Facets& facets, const Vec3& center, double radius,
                         std::span<const Index> candidates, WallTouch* out, int capacity) noexcept {
  Reports reports(facets, radius);
  collect(reports, center, candidates);
  if (reports.count == 0 || capacity <= 0) return 0;
  if (reports.count == 1) {
    out[0] = touch_of(reports, reports.list[0], center);
    return 1;
  }
  const Report* kept[kMaxReports];
  int count = choose(reports, kept);
  if (count > capacity) {
    std::sort(kept, kept + count, [](const Report* a, const Report* b) {
      return a->distance2 != b->distance2 ? a->distance2 < b->distance2 : nearer(*a, *b);
    });
    count = capacity;
  }
  std::sort(kept, kept + count, [](const Report* a, const Report* b) {
    if (a->facet->wall != b->facet->wall) return a->facet->wall < b->facet->wall;
    return a->feature < b->feature;
  });
  for (int i = 0; i < count; ++i) out[i] = touch_of(reports, *kept[i], center);
  return count;
}

FacetFreedom facet_freedom(const Facets& facets, const Vec3& center, double radius,
                           std::span<const Index> candidates) noexcept {
  FacetFreedom out = {std::numeric_limits<double>::infinity(), kNoIndex};
  Index group = kNoIndex;
  for (const Index t : candidates) {
    const FacetRecord& facet = facets.record[t];
    const double height = facet.normal.dot(center - facet.corner[0]);
    if (std::abs(height) >= radius) {
      out.way = std::min(out.way, std::abs(height) - radius);
      continue;
    }
    const ClosestPoint p = closest_on_facet(facet, center);
    if (p.region == 0) {
      if (!(height > 0) || out.facet != kNoIndex) return {0, kNoIndex};
      out = {std::min(out.way, way_to_edges(facet, center)), t};
      group = facet.group;
    }
  }
  for (const Index t : candidates) {
    const FacetRecord& facet = facets.record[t];
    // Of a plane of several facets the one that holds the foot is the nearest.
    if (facet.group == group) continue;
    if (std::abs(facet.normal.dot(center - facet.corner[0])) >= radius) continue;
    out.way = std::min(out.way, std::sqrt(closest_on_facet(facet, center).distance2) - radius);
  }
  out.way = std::max(0.0, kOfWay * (out.way - kSamePlace * radius));
  return out;
}

void keep_side(WallTouch& touch, const Vec3& stored_normal, double radius) noexcept {
  const double cosine = touch.normal.dot(stored_normal);
  if (cosine >= 0) return;
  const double distance = radius - touch.overlap;
  touch.overlap = radius + distance;
  touch.normal = cosine < kStraightThrough ? Vec3(-touch.normal) : stored_normal;
}

}  // namespace quern
