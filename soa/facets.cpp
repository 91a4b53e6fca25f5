// Topology of walls: edges and their kinds, coplanar groups, valences, the records of the narrow
// phase.
//
// Components are welded one by one and appended, so that nothing is shared between walls. Ids
// follow the order of the input: groups by their first triangle, edges by their vertices. A group
// that is plane to rounding gets one normal, that of its largest triangle, so that a sphere rolling
// over its triangles sees one plane to the last bit.
#include "soa/facets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "soa/facet_weld.h"

namespace quern {
namespace {

constexpr double kFlatCosine = 1 - 1e-10;
constexpr double kPlaneTolerance = 1e-14;  // of the largest coordinate

// Disjoint sets whose root is their smallest member.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

Vec3 area_vector(const Facets& f, Index t) {
  const Vec3& a = f.vertex[f.corner[3 * t]];
  return 0.5 * (f.vertex[f.corner[3 * t + 1]] - a).cross(f.vertex[f.corner[3 * t + 2]] - a);
}

// Appends a component; triangles of no area that splitting left behind are dropped here.
void append(Facets& f, const WeldedMesh& mesh, Index wall) {
  const Index first = f.vertices();
  f.vertex.insert(f.vertex.end(), mesh.vertex.begin(), mesh.vertex.end());
  for (const auto& t : mesh.triangle) {
    for (Index v : t) f.corner.push_back(first + v);
    const Vec3 area = area_vector(f, f.triangles() - 1);
    const double size = area.norm();
    if (!(size > 0)) {
      f.corner.resize(f.corner.size() - 3);
      ++f.report.zero_area;
      continue;
    }
    f.normal.push_back(area / size);
    f.wall.push_back(wall);
  }
}

struct EdgeFinding {
  EdgeKind kind;
  bool flipped;
};

// Kind of the edge between two triangles. Where they are oriented against each other the second
// counts as turned over.
EdgeFinding classify(const Facets& f, const EdgeUse& one, const EdgeUse& two) {
  const bool flipped =
      f.corner[3 * one.triangle + one.side] == f.corner[3 * two.triangle + two.side];
  const Vec3& n1 = f.normal[one.triangle];
  const Vec3 n2 = flipped ? Vec3(-f.normal[two.triangle]) : f.normal[two.triangle];
  if (n1.dot(n2) > kFlatCosine) return {EdgeKind::kFlat, flipped};
  const Vec3& apex = f.vertex[f.corner[3 * two.triangle + (two.side + 2) % 3]];
  const double height = n1.dot(apex - f.vertex[one.low]);
  return {height > 0 ? EdgeKind::kConcave : EdgeKind::kConvex, flipped};
}

std::vector<std::array<Index, 3>> corners_by_triangle(const Facets& f) {
  std::vector<std::array<Index, 3>> out(f.triangles());
  for (Index t = 0; t < f.triangles(); ++t) {
    out[t] = {f.corner[3 * t], f.corner[3 * t + 1], f.corner[3 * t + 2]};
  }
  return out;
}

void book(FacetReport& report, const EdgeFinding& found) {
  report.boundary_edges += found.kind == EdgeKind::kBoundary;
  report.non_manifold_edges += found.kind == EdgeKind::kNonManifold;
  report.flipped_edges += found.flipped;
}

// Fills edges and joins the triangles across flat ones.
void build_edges(Facets& f, Sets& sets) {
  const auto uses = sorted_edge_uses(corners_by_triangle(f));
  f.edge_of.resize(f.corner.size());
  for (std::size_t begin = 0, end; begin < uses.size(); begin = end) {
    end = begin + 1;
    while (end < uses.size() && uses[end].same_edge(uses[begin])) ++end;
    QUERN_CHECK(end - begin <= 0xffff);
    EdgeFinding found{end - begin == 1 ? EdgeKind::kBoundary : EdgeKind::kNonManifold, false};
    if (end - begin == 2) found = classify(f, uses[begin], uses[begin + 1]);
    if (found.kind == EdgeKind::kFlat) sets.join(uses[begin].triangle, uses[begin + 1].triangle);
    for (std::size_t i = begin; i < end; ++i) {
      f.edge_of[3 * uses[i].triangle + uses[i].side] = f.edges();
    }
    f.edge_kind.push_back(found.kind);
    f.edge_valence.push_back(static_cast<std::uint16_t>(end - begin));
    book(f.report, found);
  }
}

void build_groups(Facets& f, Sets& sets) {
  f.group.resize(f.triangles());
  for (Index t = 0; t < f.triangles(); ++t) {
    const Index root = sets.root(t);
    f.group[t] = root == t ? f.groups++ : f.group[root];
  }
}

void build_valences(Facets& f) {
  std::vector<Index> count(f.vertices(), 0);
  for (Index v : f.corner) ++count[v];
  for (Index n : count) {
    QUERN_CHECK(n <= 0xffff);
    f.vertex_valence.push_back(static_cast<std::uint16_t>(n));
  }
}

// Gives the triangles of a plane group one normal.
void share_normals(Facets& f) {
  std::vector<Index> largest(f.groups, kNoIndex);
  std::vector<double> area(f.groups, 0);
  double extent = 0;
  for (const auto& v : f.vertex) extent = std::max(extent, v.cwiseAbs().maxCoeff());
  for (Index t = 0; t < f.triangles(); ++t) {
    const double size = area_vector(f, t).norm();
    if (size <= area[f.group[t]]) continue;
    area[f.group[t]] = size;
    largest[f.group[t]] = t;
  }
  const std::vector<Vec3> own = f.normal;
  for (Index t = 0; t < f.triangles(); ++t) {
    const Index leader = largest[f.group[t]];
    const Vec3& n = own[leader];
    const Vec3& origin = f.vertex[f.corner[3 * leader]];
    double off = 0;
    for (Index k = 0; k < 3; ++k) {
      off = std::max(off, std::abs(n.dot(f.vertex[f.corner[3 * t + k]] - origin)));
    }
    if (off <= kPlaneTolerance * extent) f.normal[t] = own[t].dot(n) > 0 ? n : Vec3(-n);
  }
}

void build_records(Facets& f) {
  std::vector<bool> inside(f.vertices(), true);  // all edges around the vertex are flat
  for (Index i = 0; i < f.corner.size(); ++i) {
    if (f.edge_kind[f.edge_of[i]] == EdgeKind::kFlat) continue;
    const Index side = i % 3, first = i - side;
    inside[f.corner[first + side]] = inside[f.corner[first + (side + 1) % 3]] = false;
  }
  f.record.resize(f.triangles());
  for (Index t = 0; t < f.triangles(); ++t) {
    FacetRecord& r = f.record[t];
    for (Index k = 0; k < 3; ++k) {
      const Index v = f.corner[3 * t + k], e = f.edge_of[3 * t + k];
      r.corner[k] = f.vertex[v];
      r.vertex[k] = v | (inside[v] ? kInsideGroup : 0);
      r.edge[k] = e | (f.edge_kind[e] == EdgeKind::kFlat ? kInsideGroup : 0);
    }
    r.normal = f.normal[t];
    r.group = f.group[t];
    r.wall = f.wall[t];
  }
}

}  // namespace

Facets build_facets(const std::vector<FacetComponent>& components, double cell) {
  Facets f;
  for (const auto& component : components) {
    append(f, weld(component.triangles, f.report), component.wall);
  }
  Sets sets(f.triangles());
  build_edges(f, sets);
  build_groups(f, sets);
  build_valences(f);
  share_normals(f);
  build_records(f);
  build_facet_grid(f, cell);
  return f;
}

}  // namespace quern
