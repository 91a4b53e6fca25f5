// Edge table, flood fill, reflex edges; see closed_mesh.h.
#include "kernels/closed_mesh.h"

#include <algorithm>
#include <cmath>

#include "kernels/mass_properties.h"

namespace quern {
namespace {

using Corners = std::array<Index, 3>;

Vec3 middle(const WeldedMesh& mesh, const EdgeUse& use) {
  return 0.5 * (mesh.vertex[use.low] + mesh.vertex[use.high]);
}

// Whether the triangle runs along its side from the lower to the higher vertex.
bool runs_up(const Corners& t, Index side) { return t[side] < t[(side + 1) % 3]; }

struct Neighbour {
  Index triangle = kNoIndex;
  bool agrees = true;  // their orientations, as they stand in the file
};

class Orienter {
 public:
  explicit Orienter(WeldedMesh& mesh) : mesh_(mesh), across_(mesh.triangle.size()) { pair_edges(); }

  MeshCheck run() {
    body_.assign(mesh_.triangle.size(), kNoIndex);
    turned_.assign(mesh_.triangle.size(), 0);
    for (Index t = 0; t < mesh_.triangle.size(); ++t)
      if (body_[t] == kNoIndex) flood(t);
    turn_bodies_out();
    for (Index t = 0; t < mesh_.triangle.size(); ++t) check_.flipped += turned_[t];
    return check_;
  }

 private:
  void pair_edges() {
    const std::vector<EdgeUse> uses = sorted_edge_uses(mesh_.triangle);
    for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
      while (last < uses.size() && uses[last].same_edge(uses[first])) ++last;
      ++check_.edges;
      if (last - first == 1) {
        if (check_.open_edges++ == 0) check_.first_open = middle(mesh_, uses[first]);
      } else if (last - first > 2) {
        if (check_.crowded_edges++ == 0) check_.first_crowded = middle(mesh_, uses[first]);
      } else {
        join(uses[first], uses[first + 1]);
      }
    }
  }
  void join(const EdgeUse& a, const EdgeUse& b) {
    const bool agrees =
        runs_up(mesh_.triangle[a.triangle], a.side) != runs_up(mesh_.triangle[b.triangle], b.side);
    across_[a.triangle][a.side] = {b.triangle, agrees};
    across_[b.triangle][b.side] = {a.triangle, agrees};
  }
  void flood(Index seed) {
    std::vector<Index> front = {seed};
    body_[seed] = check_.bodies;
    while (!front.empty()) {
      const Index t = front.back();
      front.pop_back();
      for (const Neighbour& next : across_[t]) {
        if (next.triangle == kNoIndex) continue;
        const std::uint8_t turned = next.agrees ? turned_[t] : !turned_[t];
        if (body_[next.triangle] == kNoIndex) {
          body_[next.triangle] = check_.bodies;
          turned_[next.triangle] = turned;
          front.push_back(next.triangle);
        } else if (turned_[next.triangle] != turned) {
          check_.one_sided = true;
        }
      }
    }
    ++check_.bodies;
  }
  void turn_bodies_out() {
    std::vector<std::vector<Corners>> bodies(check_.bodies);
    for (Index t = 0; t < mesh_.triangle.size(); ++t) {
      if (turned_[t]) std::swap(mesh_.triangle[t][1], mesh_.triangle[t][2]);
      bodies[body_[t]].push_back(mesh_.triangle[t]);
    }
    std::vector<std::uint8_t> inside_out(check_.bodies, 0);
    double volume = 0;
    for (Index b = 0; b < check_.bodies; ++b) {
      const double signed_volume = mass_properties(mesh_.vertex, bodies[b]).volume;
      inside_out[b] = signed_volume < 0;
      volume += std::abs(signed_volume);
    }
    if (check_.closed()) check_.volume = volume;
    for (Index t = 0; t < mesh_.triangle.size(); ++t) {
      if (!inside_out[body_[t]]) continue;
      std::swap(mesh_.triangle[t][1], mesh_.triangle[t][2]);
      turned_[t] = !turned_[t];
    }
  }

  WeldedMesh& mesh_;
  std::vector<std::array<Neighbour, 3>> across_;
  std::vector<Index> body_;
  std::vector<std::uint8_t> turned_;
  MeshCheck check_;
};

// Height of d above the triangle (a, b, c) or of c above (b, a, d), whichever is the smaller.
double reflex_height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  const Vec3 n = ab.cross(ac);
  const double area = std::max(n.norm(), ab.cross(ad).norm());
  return area > 0 ? n.dot(ad) / area : 0;
}

}  // namespace

MeshCheck check_and_orient(WeldedMesh& mesh) { return Orienter(mesh).run(); }

double deepest_reflex(const WeldedMesh& mesh, Vec3& where) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangle);
  double deepest = 0;
  for (std::size_t k = 0; k + 1 < uses.size(); ++k) {
    const EdgeUse &one = uses[k], &two = uses[k + 1];
    if (!one.same_edge(two)) continue;
    const Corners &t = mesh.triangle[one.triangle], &u = mesh.triangle[two.triangle];
    const double height =
        reflex_height(mesh.vertex[t[one.side]], mesh.vertex[t[(one.side + 1) % 3]],
                      mesh.vertex[t[(one.side + 2) % 3]], mesh.vertex[u[(two.side + 2) % 3]]);
    if (height <= deepest) continue;
    deepest = height;
    where = middle(mesh, one);
  }
  return deepest;
}

}  // namespace quern
