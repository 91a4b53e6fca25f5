#include "scheduler/polyhedron_lists.h"

#include <algorithm>
#include <cmath>

#include "scheduler/list_allowance.h"
#include "scheduler/wall_lists.h"

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
  std::vector<std::vector<std::pair<Index, Index>>> of(bodies);
  for (std::size_t g = 0; g < batch.polyhedron.size(); ++g) {
    for (std::size_t block = batch.begin[g] / kShapePad; block < batch.begin[g + 1] / kShapePad;
         ++block) {
      for (std::uint32_t bits = batch.open[block]; bits != 0; bits &= bits - 1) {
        const Index slot =
            static_cast<Index>(block * kShapePad) + static_cast<Index>(__builtin_ctz(bits));
        of[batch.polyhedron[g]].emplace_back(batch.sphere[slot], slot);
      }
    }
  }
  OldSlots old;
  old.begin.push_back(0);
  for (auto& slots : of) {
    std::sort(slots.begin(), slots.end());
    old.sphere_slot.insert(old.sphere_slot.end(), slots.begin(), slots.end());
    old.begin.push_back(static_cast<Index>(old.sphere_slot.size()));
  }
  return old;
}

// Whether the straight lines of sphere and polyhedron, each left by no more than it may be, keep
// some plane of the polyhedron between them all the window long, if the polyhedron turns no more
// than it may.
template <class Real>
bool stays_apart(const World<Real>& world, const SearchInput& in, const NearSphere& pair,
                 const Mat3& into_body) {
  const Polyhedra<Real>& p = world.polyhedra;
  const double strayed = static_cast<double>(world.particles.list_allowance[pair.sphere]) +
                         static_cast<double>(p.list_allowance[pair.polyhedron]);
  if (static_cast<double>(pair.gap) > strayed) return true;
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
    if (std::abs(apart[e]) + std::abs(path[e]) + strayed > 0.5 * period) return false;
  }
  const Vec3 begin = into_body * apart, way = into_body * path;
  const Shape& shape = world.shapes[p.shape[pair.polyhedron]];
  const double scale = p.scale[pair.polyhedron];
  const double reach =
      1.000001 * (sphere.radius + strayed + static_cast<double>(p.list_turn[pair.polyhedron]));
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

// Where the group that begins at `first` ends: the spheres of one polyhedron.
std::size_t group_end(const std::vector<NearSphere>& near, std::size_t first) {
  std::size_t end = first;
  while (end < near.size() && near[end].polyhedron == near[first].polyhedron) ++end;
  return end;
}

// Sorts a tile's spheres by polyhedron and drops those that stay apart and have no history.
template <class Real>
void choose_near(const World<Real>& world, const SearchInput& in, const OldSlots& old,
                 const std::vector<Index>& old_of_new, std::vector<NearSphere>& near) {
  std::sort(near.begin(), near.end());
  Index body = kNoIndex;
  Mat3 into_body;
  std::erase_if(near, [&](const NearSphere& pair) {
    if (pair.polyhedron != body) {
      body = pair.polyhedron;
      into_body = world.polyhedra.orientation(body).toRotationMatrix().transpose();
    }
    return stays_apart(world, in, pair, into_body) &&
           old.find(body, old_of_new[pair.sphere]) == kNoIndex;
  });
}

// Groups of a tile, from group and slot on.
template <class Real>
void fill_groups(const std::vector<NearSphere>& near, const PolyhedronSphereBatch<Real>& before,
                 const OldSlots& old, const std::vector<Index>& old_of_new, Index group, Index slot,
                 PolyhedronSphereBatch<Real>& now) {
  for (std::size_t first = 0; first < near.size(); ++group) {
    const std::size_t end = group_end(near, first);
    const Index body = near[first].polyhedron, count = static_cast<Index>(end - first);
    now.polyhedron[group] = body;
    now.count[group] = count;
    now.begin[group] = slot;
    for (Index lane = 0; lane < padded(count); ++lane, ++slot) {
      const bool empty = lane >= count;
      const Index sphere = near[first + (empty ? 0 : lane)].sphere;
      now.sphere[slot] = sphere;
      const Index was = empty ? kNoIndex : old.find(body, old_of_new[sphere]);
      for (std::size_t a = 0; a < now.kHistoryStride; ++a) {
        now.number(slot, a) = was == kNoIndex ? Real(0) : before.number(was, a);
      }
    }
    first = end;
  }
}

template <class Real>
void lay_out_spheres(World<Real>& world, Graph& graph, const SearchInput& in,
                     const std::vector<Index>& old_of_new,
                     std::vector<std::vector<NearSphere>>& near) {
  using Batch = PolyhedronSphereBatch<Real>;
  const std::size_t tiles = near.size();
  const OldSlots old = open_slots(world.polyhedra.spheres, world.polyhedra.size());
  std::vector<Index> slot_begin(tiles + 1, 0), group_begin(tiles + 1, 0);
  graph.for_each(tiles, [&](std::size_t tile, int) {
    choose_near(world, in, old, old_of_new, near[tile]);
    for (std::size_t first = 0, end; first < near[tile].size(); first = end) {
      end = group_end(near[tile], first);
      slot_begin[tile + 1] += padded(end - first);
      ++group_begin[tile + 1];
    }
  });
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    slot_begin[tile + 1] += slot_begin[tile];
    group_begin[tile + 1] += group_begin[tile];
  }
  const Batch before = std::move(world.polyhedra.spheres);
  Batch& now = world.polyhedra.spheres = Batch();
  now.reset(group_begin[tiles], slot_begin[tiles]);
  now.begin[group_begin[tiles]] = slot_begin[tiles];
  now.tile_begin.reset(tiles + 1);
  std::copy(group_begin.begin(), group_begin.end(), now.tile_begin.begin());
  graph.for_each(tiles, [&](std::size_t tile, int) {
    fill_groups(near[tile], before, old, old_of_new, group_begin[tile], slot_begin[tile], now);
  });
  now.set_unsaved();
}

template <class Real>
void lay_out_pairs(World<Real>& world, std::vector<CandidatePair>& found) {
  std::vector<PolyhedronPair>& pairs = world.polyhedra.pairs;
  std::sort(found.begin(), found.end(), [](const CandidatePair& a, const CandidatePair& b) {
    return a.j != b.j ? a.j < b.j : a.i < b.i;
  });
  std::vector<PolyhedronPair> now;
  std::vector<Episode> episodes;
  now.reserve(found.size());
  auto old = pairs.begin();
  for (const CandidatePair& pair : found) {
    while (old != pairs.end() && (old->j < pair.j || (old->j == pair.j && old->i < pair.i))) {
      ++old;
    }
    const bool known = old != pairs.end() && old->j == pair.j && old->i == pair.i;
    now.push_back(known ? *old : PolyhedronPair());
    now.back().j = pair.j;
    now.back().i = pair.i;
    if (!world.collisions.on()) continue;
    const auto row = static_cast<std::size_t>(old - pairs.begin());
    episodes.push_back(known ? world.polyhedra.pair_episodes[row] : Episode());
  }
  pairs = std::move(now);
  world.polyhedra.pair_episodes = std::move(episodes);
}

template <class Real>
void find_walls(World<Real>& world, std::vector<float>& speed) {
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
      speed[k] = std::max(speed[k], static_cast<float>((v - body.velocity.at(x)).norm()));
      p.wall_candidate_body.push_back(static_cast<Index>(b));
      p.wall_candidate_facet_begin.push_back(static_cast<Index>(p.wall_candidate_facet.size()));
    }
    p.wall_candidate_begin.push_back(static_cast<Index>(p.wall_candidate_body.size()));
  }
}

}  // namespace

template <class Real>
void add_points(World<Real>& world, SearchPoint* points) {
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
    p.list_qw[k] = p.qw[k];
    p.list_qx[k] = p.qx[k];
    p.list_qy[k] = p.qy[k];
    p.list_qz[k] = p.qz[k];
    points[k] = {{p.x[k], p.y[k], p.z[k]},
                 bound_radius(world, k),
                 {p.list_vx[k], p.list_vy[k], p.list_vz[k]},
                 0,
                 p.first_id + static_cast<Index>(k)};
  }
}

void take_near_spheres(std::size_t spheres, std::vector<CandidatePair>& own,
                       std::vector<NearSphere>& near) {
  near.clear();
  const auto kept = std::remove_if(own.begin(), own.end(), [&](const CandidatePair& pair) {
    if (pair.j < spheres) return false;
    near.push_back({pair.j - static_cast<Index>(spheres), pair.i, pair.gap, pair.speed});
    return true;
  });
  own.erase(kept, own.end());
}

template <class Real>
void search_polyhedra(World<Real>& world, const SearchInput& in, const SearchGrid& grid,
                      BodyCandidates& found) {
  const Index spheres = static_cast<Index>(world.particles.size());
  const Index all = spheres + static_cast<Index>(world.polyhedra.size());
  std::vector<CandidatePair> own;
  find_candidates(in, grid, spheres, all, own);
  found.pairs.clear();
  for (const CandidatePair& pair : own) {
    const Index body = pair.i - spheres;
    if (pair.j < spheres) {
      found.near[pair.j / world.tile_size].push_back({body, pair.j, pair.gap, pair.speed});
    } else {
      const Index other = pair.j - spheres;
      found.pairs.push_back({std::max(body, other), std::min(body, other), pair.gap, pair.speed});
    }
  }
  found.speed.assign(world.polyhedra.size(), 0);
  const auto raise = [&](Index body, float to) {
    found.speed[body] = std::max(found.speed[body], to);
  };
  for (const CandidatePair& pair : found.pairs) {
    raise(pair.i, pair.speed);
    raise(pair.j, pair.speed);
  }
  for (const auto& near : found.near) {
    for (const NearSphere& pair : near) raise(pair.polyhedron, pair.speed);
  }
  find_walls(world, found.speed);
}

template <class Real>
void lay_out_polyhedra(World<Real>& world, Graph& graph, const SearchInput& in,
                       const std::vector<Index>& old_of_new, BodyCandidates& found) {
  drop_apart(world.polyhedra.list_allowance, found.pairs);
  lay_out_spheres(world, graph, in, old_of_new, found.near);
  lay_out_pairs(world, found.pairs);
}

template void add_points(World<float>&, SearchPoint*);
template void add_points(World<double>&, SearchPoint*);
template void search_polyhedra(World<float>&, const SearchInput&, const SearchGrid&,
                               BodyCandidates&);
template void search_polyhedra(World<double>&, const SearchInput&, const SearchGrid&,
                               BodyCandidates&);
template void lay_out_polyhedra(World<float>&, Graph&, const SearchInput&,
                                const std::vector<Index>&, BodyCandidates&);
template void lay_out_polyhedra(World<double>&, Graph&, const SearchInput&,
                                const std::vector<Index>&, BodyCandidates&);

}  // namespace quern
