// Welding and T-junctions through a hash grid of points; see facet_weld.h.
//
// Everything is done in the order of the input, so that equal files give equal meshes. The fan from
// the opposite corner replaces a split triangle in place.
#include "soa/facet_weld.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace quern {
namespace {

constexpr double kWeldTolerance = 1e-6;  // of the bounding-box diagonal
constexpr int kMaxSplitPasses = 32;

// Points in hashed cubic cells. Coordinates may span at most 2^20 cells a side.
class PointGrid {
 public:
  PointGrid(const Vec3& low, double cell) : low_(low), cell_(cell) {}

  void add(const Vec3& p) {
    const Index id = static_cast<Index>(next_.size());
    const auto [at, fresh] = head_.try_emplace(key(cell_of(p)), id);
    next_.push_back(fresh ? kNoIndex : at->second);
    at->second = id;
  }
  // Calls visit(id) for every point in the cells that meet the box; ids ascend in no cell.
  template <class Visit>
  void visit(const Vec3& low, const Vec3& high, Visit&& call) const {
    const Cell a = cell_of(low), b = cell_of(high);
    const double cells =
        double(b[0] - a[0] + 1) * double(b[1] - a[1] + 1) * double(b[2] - a[2] + 1);
    if (cells > 8.0 * double(next_.size())) {
      for (Index id = 0; id < next_.size(); ++id) call(id);
      return;
    }
    Cell c;
    for (c[2] = a[2]; c[2] <= b[2]; ++c[2])
      for (c[1] = a[1]; c[1] <= b[1]; ++c[1])
        for (c[0] = a[0]; c[0] <= b[0]; ++c[0]) visit_cell(c, call);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(const Vec3& p) const {
    Cell c;
    for (int k = 0; k < 3; ++k) {
      c[std::size_t(k)] = static_cast<std::int64_t>(std::floor((p[k] - low_[k]) / cell_)) + 1;
    }
    return c;
  }
  static std::uint64_t key(const Cell& c) {
    return static_cast<std::uint64_t>(c[0] | (c[1] << 21) | (c[2] << 42));
  }
  template <class Visit>
  void visit_cell(const Cell& c, Visit& call) const {
    const auto at = head_.find(key(c));
    if (at == head_.end()) return;
    for (Index id = at->second; id != kNoIndex; id = next_[id]) call(id);
  }

  Vec3 low_;
  double cell_;
  std::unordered_map<std::uint64_t, Index> head_;
  std::vector<Index> next_;
};

Eigen::AlignedBox3d bounds(const std::vector<Triangle>& triangles) {
  Eigen::AlignedBox3d box;
  for (const auto& t : triangles) {
    for (const auto& p : t.corner) {
      if (!p.allFinite()) throw UserError("a triangle has a corner that is not a finite number");
      box.extend(p);
    }
  }
  return box;
}

class Welder {
 public:
  Welder(const Eigen::AlignedBox3d& box, FacetReport& report)
      : tolerance_(std::max(kWeldTolerance * box.diagonal().norm(), 1e-300)),
        low_(box.min()),
        grid_(box.min(), 2 * tolerance_),
        report_(report) {}

  void add(const Triangle& triangle) {
    std::array<Index, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = vertex_at(triangle.corner[k]);
    if (is_flat_line(t)) {
      ++report_.zero_area;
    } else if (!seen_.insert(sorted(t)).second) {
      ++report_.duplicates;
    } else {
      mesh_.triangle.push_back(t);
    }
  }
  void split_t_junctions() {
    for (int pass = 0; pass < kMaxSplitPasses && split_pass(); ++pass) {
    }
  }
  WeldedMesh take() { return std::move(mesh_); }

 private:
  static std::array<Index, 3> sorted(std::array<Index, 3> t) {
    std::sort(t.begin(), t.end());
    return t;
  }
  const Vec3& at(Index v) const { return mesh_.vertex[v]; }

  Index vertex_at(const Vec3& p) {
    Index found = kNoIndex;
    const Vec3 reach = Vec3::Constant(tolerance_);
    grid_.visit(p - reach, p + reach, [&](Index v) {
      if ((at(v) - p).norm() <= tolerance_) found = std::min(found, v);
    });
    if (found == kNoIndex) {
      grid_.add(p);
      mesh_.vertex.push_back(p);
      return static_cast<Index>(mesh_.vertex.size() - 1);
    }
    if (at(found) != p) ++report_.welded_vertices;
    return found;
  }
  // The least height of the triangle is within the tolerance.
  bool is_flat_line(const std::array<Index, 3>& t) const {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
    const Vec3 a = at(t[1]) - at(t[0]), b = at(t[2]) - at(t[0]);
    const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
    return a.cross(b).norm() <= tolerance_ * longest;
  }

  bool split_pass();
  std::vector<Index> free_vertices_on(const EdgeUse& use, const PointGrid& grid,
                                      const std::vector<Index>& free_vertex) const;
  void fan(const std::array<Index, 3>& t, Index side, const std::vector<Index>& inner,
           std::vector<std::array<Index, 3>>& out) const;

  double tolerance_;
  Vec3 low_;
  PointGrid grid_;
  FacetReport& report_;
  WeldedMesh mesh_;
  std::set<std::array<Index, 3>> seen_;
};

// Vertices of `free_vertex` inside the edge, in order from its low to its high end.
std::vector<Index> Welder::free_vertices_on(const EdgeUse& use, const PointGrid& grid,
                                            const std::vector<Index>& free_vertex) const {
  const Vec3 a = at(use.low), along = at(use.high) - a, reach = Vec3::Constant(tolerance_);
  const double length2 = along.squaredNorm();
  std::vector<std::pair<double, Index>> found;
  grid.visit(a.cwiseMin(at(use.high)) - reach, a.cwiseMax(at(use.high)) + reach, [&](Index i) {
    const Index v = free_vertex[i];
    if (v == use.low || v == use.high) return;
    const Vec3 from = at(v) - a;
    const double t = from.dot(along) / length2;
    if (t <= 0 || t >= 1 || (from - t * along).norm() > tolerance_) return;
    found.emplace_back(t, v);
  });
  std::sort(found.begin(), found.end());
  std::vector<Index> inner;
  for (const auto& [t, v] : found) inner.push_back(v);
  return inner;
}

// Replaces a triangle by the fan from the corner opposite to the side that holds `inner`.
void Welder::fan(const std::array<Index, 3>& t, Index side, const std::vector<Index>& inner,
                 std::vector<std::array<Index, 3>>& out) const {
  const Index from = t[side], to = t[(side + 1) % 3], apex = t[(side + 2) % 3];
  std::vector<Index> line = inner;
  if (from > to) std::reverse(line.begin(), line.end());
  line.erase(std::remove(line.begin(), line.end(), apex), line.end());
  line.push_back(to);
  Index last = from;
  for (Index v : line) {
    out.push_back({last, v, apex});
    last = v;
  }
}

// Splits every triangle at the first of its free edges that needs it; true if any was split.
bool Welder::split_pass() {
  const auto uses = sorted_edge_uses(mesh_.triangle);
  std::vector<EdgeUse> free_edges;
  std::vector<bool> is_free(mesh_.vertex.size(), false);
  double length_sum = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (i > 0 && uses[i].same_edge(uses[i - 1])) continue;
    if (i + 1 < uses.size() && uses[i].same_edge(uses[i + 1])) continue;
    free_edges.push_back(uses[i]);
    is_free[uses[i].low] = is_free[uses[i].high] = true;
    length_sum += (at(uses[i].low) - at(uses[i].high)).norm();
  }
  if (free_edges.empty()) return false;
  const double mean = length_sum / double(free_edges.size());
  PointGrid grid(low_, std::max(mean, 2 * tolerance_));
  std::vector<Index> free_vertex;
  for (Index v = 0; v < is_free.size(); ++v) {
    if (!is_free[v]) continue;
    grid.add(at(v));
    free_vertex.push_back(v);
  }
  std::vector<std::pair<Index, std::vector<Index>>> cut(mesh_.triangle.size());  // side, vertices
  Index cuts = 0;
  for (const auto& use : free_edges) {
    auto& [side, inner] = cut[use.triangle];
    if (!inner.empty()) continue;
    inner = free_vertices_on(use, grid, free_vertex);
    std::erase(inner, mesh_.triangle[use.triangle][(use.side + 2) % 3]);
    side = use.side;
    cuts += inner.empty() ? 0 : 1;
  }
  if (cuts == 0) return false;
  report_.split_edges += cuts;
  std::vector<std::array<Index, 3>> out;
  for (std::size_t t = 0; t < cut.size(); ++t) {
    if (cut[t].second.empty()) {
      out.push_back(mesh_.triangle[t]);
    } else {
      fan(mesh_.triangle[t], cut[t].first, cut[t].second, out);
    }
  }
  mesh_.triangle = std::move(out);
  return true;
}

}  // namespace

std::vector<EdgeUse> sorted_edge_uses(const std::vector<std::array<Index, 3>>& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

WeldedMesh weld(const std::vector<Triangle>& triangles, FacetReport& report) {
  report.triangles_read += static_cast<Index>(triangles.size());
  if (triangles.empty()) return {};
  Welder welder(bounds(triangles), report);
  for (const auto& t : triangles) welder.add(t);
  welder.split_t_junctions();
  return welder.take();
}

}  // namespace quern
