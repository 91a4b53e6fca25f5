// Qhull, then flat groups of its facets, then the outlines of the groups; see polyhedron.h.
//
// All lengths here are relative to the bound radius about the middle of the points' box.
#include "kernels/polyhedron.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace quern {
namespace {

using Loop = std::vector<Index>;

struct Facet {
  Loop loop;  // corners, counterclockwise seen from outside
  Vec3 area = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

Vec3 vector_area(const Loop& loop, const std::vector<Vec3>& point) {
  Vec3 sum = Vec3::Zero();
  const Vec3& base = point[loop[0]];
  for (std::size_t k = 1; k + 1 < loop.size(); ++k)
    sum += (point[loop[k]] - base).cross(point[loop[k + 1]] - base);
  return 0.5 * sum;
}

[[noreturn]] void fail_details() {
  throw UserError("its hull has details near " + std::string("1e-6 of its size") +
                  ", out of which no clean polyhedron can be made");
}

// Qhull with its memory and its silence. Its errors come back as exit codes.
class Qhull {
 public:
  explicit Qhull(const std::vector<Vec3>& point) : silence_(std::fopen("/dev/null", "w")) {
    if (silence_ == nullptr) throw SystemError("/dev/null: cannot be opened");
    for (const Vec3& p : point) coordinates_.insert(coordinates_.end(), p.data(), p.data() + 3);
    qh_zero(&qh_, silence_);
    std::string command = "qhull Pp";
    exit_code_ = qh_new_qhull(&qh_, 3, static_cast<int>(point.size()), coordinates_.data(), False,
                              command.data(), nullptr, silence_);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;
  ~Qhull() {
    qh_freeqhull(&qh_, !qh_ALL);
    int left = 0, left_bytes = 0;
    qh_memfreeshort(&qh_, &left, &left_bytes);
    std::fclose(silence_);
  }
  bool flat() const { return exit_code_ == qh_ERRsingular; }
  std::vector<Facet> facets(const std::vector<Vec3>& point) {
    if (exit_code_ != 0) fail_details();
    std::vector<Facet> out;
    for (facetT* facet = qh_.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next) {
      out.push_back(read(facet, point));
    }
    return out;
  }

 private:
  Facet read(facetT* facet, const std::vector<Vec3>& point) {
    Facet out;
    setT* corners = qh_facet3vertex(&qh_, facet);
    const int size = qh_setsize(&qh_, corners);
    for (int k = 0; k < size; ++k) {
      auto* corner = static_cast<vertexT*>(corners->e[k].p);
      out.loop.push_back(static_cast<Index>(qh_pointid(&qh_, corner->point)));
    }
    qh_settempfree(&qh_, &corners);
    out.area = vector_area(out.loop, point);
    const Vec3 outwards(facet->normal[0], facet->normal[1], facet->normal[2]);
    if (out.area.dot(outwards) < 0) {
      std::reverse(out.loop.begin(), out.loop.end());
      out.area = -out.area;
    }
    out.normal = out.area.norm() > 0 ? Vec3(out.area.normalized()) : outwards;
    return out;
  }

  qhT qh_ = {};
  std::FILE* silence_;
  std::vector<double> coordinates_;
  int exit_code_ = 0;
};

using DirectedEdge = std::pair<Index, Index>;

class Merger {
 public:
  Merger(const std::vector<Vec3>& point, std::vector<Facet> facets)
      : point_(point), facets_(std::move(facets)) {
    for (Index f = 0; f < facets_.size(); ++f) {
      const Loop& loop = facets_[f].loop;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const bool fresh = left_of_.try_emplace({loop[k], loop[(k + 1) % loop.size()]}, f).second;
        if (!fresh) fail_details();
      }
    }
  }

  Polyhedron run() {
    group_facets();
    std::vector<std::vector<Index>> groups_at(point_.size());
    for (const auto& [edge, facet] : left_of_) groups_at[edge.first].push_back(group_[facet]);
    for (auto& groups : groups_at) {
      std::sort(groups.begin(), groups.end());
      groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    }
    Polyhedron body;
    std::vector<Index> new_id(point_.size(), kNoIndex);
    for (Index v = 0; v < point_.size(); ++v) {
      if (groups_at[v].size() < 3) continue;
      new_id[v] = static_cast<Index>(body.vertex.size());
      body.vertex.push_back(point_[v]);
    }
    for (const Loop& outline : outlines()) add_face(outline, new_id, body);
    std::sort(body.face.begin(), body.face.end());
    return body;
  }

 private:
  Index across(const DirectedEdge& edge) const {
    const auto at = left_of_.find({edge.second, edge.first});
    if (at == left_of_.end()) fail_details();
    return at->second;
  }
  // The largest facet that is left seeds a group; it takes neighbours that lie in its plane.
  void group_facets() {
    std::vector<Index> order(facets_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return facets_[a].area.squaredNorm() > facets_[b].area.squaredNorm();
    });
    group_.assign(facets_.size(), kNoIndex);
    for (const Index seed : order)
      if (group_[seed] == kNoIndex) grow_group(seed);
  }
  void grow_group(Index seed) {
    std::vector<Index> front = {seed};
    group_[seed] = groups_;
    while (!front.empty()) {
      const Loop loop = facets_[front.back()].loop;
      front.pop_back();
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Index next = across({loop[k], loop[(k + 1) % loop.size()]});
        if (group_[next] != kNoIndex || !in_plane(facets_[next], facets_[seed])) continue;
        group_[next] = groups_;
        front.push_back(next);
      }
    }
    ++groups_;
  }
  bool in_plane(const Facet& facet, const Facet& seed) const {
    if (facet.normal.dot(seed.normal) <= 0) return false;
    const Vec3& base = point_[seed.loop[0]];
    return std::all_of(facet.loop.begin(), facet.loop.end(), [&](Index v) {
      return std::abs(seed.normal.dot(point_[v] - base)) <= kFlat;
    });
  }
  // The outline of each group: those of its edges beyond which another group lies.
  std::vector<Loop> outlines() const {
    std::vector<std::map<Index, Index>> next(groups_);
    for (const auto& [edge, facet] : left_of_) {
      if (group_[across(edge)] == group_[facet]) continue;
      if (!next[group_[facet]].emplace(edge).second) fail_details();
    }
    std::vector<Loop> out;
    for (const auto& step : next) {
      Loop loop;
      Index at = step.begin()->first;
      do {
        loop.push_back(at);
        const auto onwards = step.find(at);
        if (onwards == step.end() || loop.size() > step.size()) fail_details();
        at = onwards->second;
      } while (at != loop[0]);
      if (loop.size() != step.size()) fail_details();
      out.push_back(loop);
    }
    return out;
  }
  void add_face(const Loop& outline, const std::vector<Index>& new_id, Polyhedron& body) const {
    Loop face;
    for (const Index v : outline)
      if (new_id[v] != kNoIndex) face.push_back(new_id[v]);
    if (face.size() < 3) fail_details();
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    body.face.push_back(face);
  }

  const std::vector<Vec3>& point_;
  std::vector<Facet> facets_;
  std::map<DirectedEdge, Index> left_of_;
  std::vector<Index> group_;
  Index groups_ = 0;
};

void set_planes(Polyhedron& body) {
  body.normal.clear();
  body.offset.clear();
  for (const auto& face : body.face) {
    const Vec3 area = vector_area(face, body.vertex);
    if (!(area.norm() > 0)) fail_details();
    const Vec3 n = area.normalized();
    double offset = n.dot(body.vertex[face[0]]);
    for (const Index v : face) offset = std::max(offset, n.dot(body.vertex[v]));
    body.normal.push_back(n);
    body.offset.push_back(offset);
  }
}

// Moves each vertex of three faces into their planes, the vertices of more stay.
void settle_vertices(Polyhedron& body) {
  std::vector<std::vector<Index>> faces_at(body.vertex.size());
  for (Index f = 0; f < body.face.size(); ++f)
    for (const Index v : body.face[f]) faces_at[v].push_back(f);
  std::vector<Vec3> mean(body.face.size(), Vec3::Zero());
  for (Index f = 0; f < body.face.size(); ++f) {
    for (const Index v : body.face[f]) mean[f] += body.vertex[v];
    mean[f] /= static_cast<double>(body.face[f].size());
  }
  std::vector<Vec3> moved = body.vertex;
  for (Index v = 0; v < body.vertex.size(); ++v) {
    if (faces_at[v].size() != 3) continue;
    Mat3 normals;
    Vec3 height;
    for (int k = 0; k < 3; ++k) {
      const Index f = faces_at[v][std::size_t(k)];
      normals.row(k) = body.normal[f].transpose();
      height[k] = body.normal[f].dot(mean[f] - body.vertex[v]);
    }
    if (height.cwiseAbs().maxCoeff() < 1e-14 || std::abs(normals.determinant()) < 1e-4) continue;
    const Vec3 shift = normals.inverse() * height;
    if (shift.norm() <= 100 * kFlat) moved[v] += shift;
  }
  body.vertex = moved;
}

}  // namespace

std::size_t Polyhedron::edges() const {
  std::size_t corners = 0;
  for (const auto& loop : face) corners += loop.size();
  return corners / 2;
}

std::vector<std::array<Index, 3>> Polyhedron::triangles() const {
  std::vector<std::array<Index, 3>> out;
  for (const auto& loop : face)
    for (std::size_t k = 1; k + 1 < loop.size(); ++k)
      out.push_back({loop[0], loop[k], loop[k + 1]});
  return out;
}

Polyhedron convex_hull(const std::vector<Vec3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  if (points.size() < 4 || box.diagonal().norm() == 0) return {};
  const Vec3 center = box.center();
  const double radius = 0.5 * box.diagonal().norm();
  std::vector<Vec3> scaled;
  for (const Vec3& p : points) scaled.emplace_back((p - center) / radius);
  Qhull hull(scaled);
  if (hull.flat()) return {};
  Polyhedron body = Merger(scaled, hull.facets(scaled)).run();
  if (body.vertex.size() + body.face.size() != body.edges() + 2) fail_details();
  set_planes(body);
  settle_vertices(body);
  for (Vec3& v : body.vertex) v = center + radius * v;
  set_planes(body);
  return body;
}

double least_width(const Polyhedron& body) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t f = 0; f < body.face.size(); ++f) {
    double width = 0;
    for (const Vec3& v : body.vertex)
      width = std::max(width, body.offset[f] - body.normal[f].dot(v));
    least = std::min(least, width);
  }
  return body.empty() ? 0 : least;
}

}  // namespace quern
