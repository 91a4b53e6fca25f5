#include "scheduler/polyhedron_lists.h"

#include <algorithm>
#include <cmath>

#include "scheduler/rebuild.h"

namespace quern {

namespace {

template <class Real>
double bound_radius(const World<Real>& world, std::size_t body) {
  const Polyhedra<Real>& p = world.polyhedra;
  return p.scale[body] * world.shapes[p.shape[body]].bound_radius;
}

// Open contacts of a polyhedron with spheres before the rebuild: sphere's old index and slot.
struct OldSlots {
  std::vector<Index> begin;  // bodies + 1
  std::vector<std::pair<Index, Index>> sphere_slot;
  Index find(std::size_t body, Index sphere) const {
    const auto from = sphere_slot.begin() + begin[body], to = sphere_slot.begin() + begin[body + 1];
    const auto at = std::lower_bound(from, to, std::pair<Index, Index>(sphere, 0));
    return at != to && at->first == sphere ? at->second : kNoIndex;
  }
};

template <class Real>
OldSlots open_slots(const PolyhedronSphereBatch<Real>& batch, std::size_t bodies) {
  OldSlots old;
  std::vector<std::vector<std::pair<Index, Index>>> of(bodies);
  for (std::size_t g = 0; g < batch.polyhedron.size(); ++g) {
    for (Index k = 0; k < batch.count[g]; ++k) {
      const Index slot = batch.begin[g] + k;
      bool open = false;
      for (std::size_t a = 0; a < 6; ++a) open = open || batch.number(slot, a) != 0;
      if (open) of[batch.polyhedron[g]].emplace_back(batch.sphere[slot], slot);
    }
  }
  old.begin.push_back(0);
  for (auto& slots : of) {
    std::sort(slots.begin(), slots.end());
    old.sphere_slot.insert(old.sphere_slot.end(), slots.begin(), slots.end());
    old.begin.push_back(static_cast<Index>(old.sphere_slot.size()));
  }
  return old;
}

// Whether the straight lines of sphere and polyhedron, each left by no more than half the slack, keep
// some plane of the polyhedron between them all the window long, if the polyhedron turns by no more
// than `turn` (m, of its points).
template <class Real>
bool stays_far(const World<Real>& world, const SearchInput& in, const NearSphere& pair,
               const Mat3& into_body, double turn) {
  const Polyhedra<Real>& p = world.polyhedra;
  const SearchPoint& sphere = in.point[pair.sphere];
  const SearchPoint& body = in.point[world.particles.size() + pair.polyhedron];
  Vec3 apart, path;
  for (std::size_t a = 0; a < 3; ++a) {
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    apart[e] = sphere.x[a] - body.x[a];
    const double period = in.box.period[a];
    path[e] = in.window * (static_cast<double>(sphere.v[a]) - static_cast<double>(body.v[a]));
    if (period <= 0) continue;
    apart[e] -= period * std::nearbyint(apart[e] / period);
    // Another image may come nearer.
    if (std::abs(apart[e]) + std::abs(path[e]) + in.slack > 0.5 * period) return false;
  }
  const Vec3 begin = into_body * apart, way = into_body * path;
  const Shape& shape = world.shapes[p.shape[pair.polyhedron]];
  const double scale = p.scale[pair.polyhedron];
  const double reach = 1.000001 * (sphere.radius + in.slack + turn);
  for (std::size_t f = 0; f < shape.faces; ++f) {
    const Vec3 normal = shape.normal(f);
    const double height = normal.dot(begin) - scale * shape.d[f];
    if (height + std::min(0.0, normal.dot(way)) > reach) return true;
  }
  return false;
}

Index padded(std::size_t n) {
  return static_cast<Index>((n + kShapePad - 1) / kShapePad * kShapePad);
}

template <class Real>
void lay_out_spheres(World<Real>& world, Graph& graph, const SearchInput& in,
                     const std::vector<Index>& old_of_new,
                     std::vector<std::vector<NearSphere>>& near) {
  using Batch = PolyhedronSphereBatch<Real>;
  const OldSlots old = open_slots(world.polyhedra.spheres, world.polyhedra.size());
  const double turn = 0.5 * in.slack;
  graph.for_each(near.size(), [&](std::size_t tile, int) {
    std::sort(near[tile].begin(), near[tile].end());
    Index body = kNoIndex;
    Mat3 into_body;
    for (NearSphere& pair : near[tile]) {
      if (pair.polyhedron != body) {
        body = pair.polyhedron;
        into_body = world.polyhedra.orientation(body).toRotationMatrix().transpose();
      }
      pair.far = old.find(body, old_of_new[pair.sphere]) == kNoIndex &&
                 stays_far(world, in, pair, into_body, turn);
    }
    std::sort(near[tile].begin(), near[tile].end());
  });
  const Batch before = std::move(world.polyhedra.spheres);
  Batch& now = world.polyhedra.spheres = Batch();
  std::vector<Index> polyhedron, count, begin, near_count;
  Index slots = 0;
  now.tile_begin.reset(near.size() + 1);
  for (std::size_t tile = 0; tile < near.size(); ++tile) {
    now.tile_begin[tile] = static_cast<Index>(polyhedron.size());
    for (std::size_t k = 0; k < near[tile].size();) {
      std::size_t end = k, not_far = 0;
      while (end < near[tile].size() && near[tile][end].polyhedron == near[tile][k].polyhedron) {
        not_far += near[tile][end++].far ? 0 : 1;
      }
      near_count.push_back(static_cast<Index>(not_far));
      polyhedron.push_back(near[tile][k].polyhedron);
      count.push_back(static_cast<Index>(end - k));
      begin.push_back(slots);
      slots += padded(end - k);
      k = end;
    }
  }
  now.tile_begin[near.size()] = static_cast<Index>(polyhedron.size());
  begin.push_back(slots);
  const auto to_column = [](const std::vector<Index>& from, Column<Index>& to) {
    to.reset(from.size());
    std::copy(from.begin(), from.end(), to.begin());
  };
  to_column(polyhedron, now.polyhedron);
  to_column(count, now.count);
  to_column(begin, now.begin);
  now.sphere.reset(slots);
  now.numbers.reset(slots * Batch::kHistoryStride);
  now.numbers.fill(0);
  std::size_t group = 0;
  for (const auto& tile : near) {
    for (std::size_t k = 0; k < tile.size(); ++group) {
      for (Index lane = 0; lane < padded(count[group]); ++lane) {
        const bool empty = lane >= count[group];
        const Index slot = begin[group] + lane;
        const Index sphere = tile[k + (empty ? 0 : lane)].sphere;
        now.sphere[slot] = sphere;
        const Index was = empty ? kNoIndex : old.find(polyhedron[group], old_of_new[sphere]);
        if (was == kNoIndex) continue;
        for (std::size_t a = 0; a < Batch::kHistory; ++a) {
          now.number(slot, a) = before.number(was, a);
        }
      }
      k += count[group];
    }
  }
  now.set_unsaved();
  to_column(near_count, now.near);
  now.near_turn = turn;
}

template <class Real>
void lay_out_pairs(World<Real>& world, std::vector<std::pair<Index, Index>>& found) {
  std::sort(found.begin(), found.end());
  std::vector<PolyhedronPair>& pairs = world.polyhedra.pairs;
  std::vector<PolyhedronPair> now;
  now.reserve(found.size());
  auto old = pairs.begin();
  for (const auto& [j, i] : found) {
    while (old != pairs.end() && (old->j < j || (old->j == j && old->i < i))) ++old;
    const bool known = old != pairs.end() && old->j == j && old->i == i;
    now.push_back(known ? *old : PolyhedronPair());
    now.back().j = j;
    now.back().i = i;
  }
  pairs = std::move(now);
}

template <class Real>
void find_walls(World<Real>& world) {
  Polyhedra<Real>& p = world.polyhedra;
  p.wall_candidate_begin.assign(1, 0);
  p.wall_candidate_facet_begin.assign(1, 0);
  p.wall_candidate_body.clear();
  p.wall_candidate_facet.clear();
  const double span = static_cast<double>(world.clock.list_window) * world.clock.dt;
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
      const Body& body = world.bodies[b];
      const Vec3 x = p.place(k);
      const Vec3 v = Vec3(static_cast<double>(p.list_vx[k]), static_cast<double>(p.list_vy[k]),
                          static_cast<double>(p.list_vz[k]));
      const double reach = bound_radius(world, k) + 0.5 * world.clock.slack +
                           wall_reach(body, x, v, world.wall_time(), span);
      const Vec3 in_body = body.pose.rotation.transpose() * (x - body.pose.shift);
      find_facets(body.facets, in_body, reach, p.wall_candidate_facet);
      if (p.wall_candidate_facet.size() == p.wall_candidate_facet_begin.back()) continue;
      p.wall_candidate_body.push_back(static_cast<Index>(b));
      p.wall_candidate_facet_begin.push_back(static_cast<Index>(p.wall_candidate_facet.size()));
    }
    p.wall_candidate_begin.push_back(static_cast<Index>(p.wall_candidate_body.size()));
  }
}

}  // namespace

template <class Real>
void add_points(World<Real>& world, std::vector<SearchPoint>& points) {
  Polyhedra<Real>& p = world.polyhedra;
  Column<double>* place[3] = {&p.x, &p.y, &p.z};
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (!world.periodic[a]) continue;
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      const double low = world.low[e], length = world.high[e] - low;
      const double turns = std::floor(((*place[a])[k] - low) / length);
      if (turns != 0) (*place[a])[k] -= turns * length;
    }
    p.list_x[k] = p.x[k];
    p.list_y[k] = p.y[k];
    p.list_z[k] = p.z[k];
    p.list_vx[k] = static_cast<float>(p.vx[k]);
    p.list_vy[k] = static_cast<float>(p.vy[k]);
    p.list_vz[k] = static_cast<float>(p.vz[k]);
    points.push_back({{p.x[k], p.y[k], p.z[k]},
                      bound_radius(world, k),
                      {p.list_vx[k], p.list_vy[k], p.list_vz[k]},
                      0,
                      p.first_id + static_cast<Index>(k)});
  }
}

void take_near_spheres(std::size_t spheres, std::vector<CandidatePair>& own,
                       std::vector<NearSphere>& near) {
  near.clear();
  const auto kept = std::remove_if(own.begin(), own.end(), [&](const CandidatePair& pair) {
    if (pair.j < spheres) return false;
    near.push_back({pair.j - static_cast<Index>(spheres), pair.i});
    return true;
  });
  own.erase(kept, own.end());
}

template <class Real>
void rebuild_polyhedra(World<Real>& world, Graph& graph, const SearchInput& in,
                       const SearchGrid& grid, const std::vector<Index>& old_of_new,
                       std::vector<std::vector<NearSphere>>& near) {
  const Index spheres = static_cast<Index>(world.particles.size());
  const Index all = spheres + static_cast<Index>(world.polyhedra.size());
  std::vector<CandidatePair> own;
  find_candidates(in, grid, spheres, all, own);
  std::vector<std::pair<Index, Index>> pairs;
  for (const CandidatePair& pair : own) {
    const Index body = pair.i - spheres;
    if (pair.j < spheres) {
      near[pair.j / world.tile_size].push_back({body, pair.j});
    } else {
      pairs.push_back(std::minmax(body, pair.j - spheres));
    }
  }
  lay_out_spheres(world, graph, in, old_of_new, near);
  lay_out_pairs(world, pairs);
  find_walls(world);
}

template void add_points(World<float>&, std::vector<SearchPoint>&);
template void add_points(World<double>&, std::vector<SearchPoint>&);
template void rebuild_polyhedra(World<float>&, Graph&, const SearchInput&, const SearchGrid&,
                                const std::vector<Index>&, std::vector<std::vector<NearSphere>>&);
template void rebuild_polyhedra(World<double>&, Graph&, const SearchInput&, const SearchGrid&,
                                const std::vector<Index>&, std::vector<std::vector<NearSphere>>&);

}  // namespace quern
