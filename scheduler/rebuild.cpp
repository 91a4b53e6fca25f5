#include "scheduler/rebuild.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "kernels/contact.h"

namespace quern {

namespace {

constexpr std::uint64_t kShortestWindow = 4, kLongestWindow = 4000;
// A rebuild costs as much time a particle as so many slots whose spheres do not touch.
constexpr double kRebuildInSlots = 200;
// A big ball has hundreds of small partners in other tiles: it takes several lanes.
constexpr Index kLongestImport = 12;
constexpr std::size_t kChunk = 4096;  // particles per task where order does not matter

std::uint64_t spread_bits(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffff;
  v = (v | v << 16) & 0x1f0000ff0000ff;
  v = (v | v << 8) & 0x100f00f00f00f00f;
  v = (v | v << 4) & 0x10c30c30c30c30c3;
  v = (v | v << 2) & 0x1249249249249249;
  return v;
}

std::size_t chunks_of(std::size_t n) { return (n + kChunk - 1) / kChunk; }

// Brings periodic positions back into the domain; sets the bounds of all.
template <class Real>
void wrap_positions(World<Real>& world, Graph& graph, RebuildScratch<Real>& s) {
  Particles<Real>& p = world.particles;
  s.bounds.assign(chunks_of(p.size()), Bounds());
  graph.for_each(s.bounds.size(), [&](std::size_t chunk, int) {
    for (std::size_t k = chunk * kChunk; k < std::min(p.size(), (chunk + 1) * kChunk); ++k) {
      for (std::size_t a = 0; a < 3; ++a) {
        if (!world.periodic[a]) continue;
        const Eigen::Index e = static_cast<Eigen::Index>(a);
        const double low = world.low[e], length = world.high[e] - low;
        double& x = (&p.record[k].x)[a];
        const double turns = std::floor((x - low) / length);
        if (turns != 0) x -= turns * length;
      }
      s.bounds[chunk].add(Vec3(p.record[k].x, p.record[k].y, p.record[k].z));
    }
  });
}

Bounds together(const std::vector<Bounds>& parts) {
  Bounds all;
  for (const Bounds& part : parts) {
    all.add(part.low);
    all.add(part.high);
  }
  return all;
}

// Order along the Morton curve over a grid of half the mean spacing, ties by identity.
template <class Real>
void order_particles(const World<Real>& world, Graph& graph, RebuildScratch<Real>& s) {
  const Particles<Real>& p = world.particles;
  const std::size_t n = p.size();
  const auto [low, high] = together(s.bounds);
  const double extent = std::max((high - low).maxCoeff(), 1e-9);
  const double volume = (high - low).cwiseMax(1e-3 * extent).prod();
  const double cell = std::max(std::cbrt(volume / static_cast<double>(n)), extent / 2e6);
  s.keys.resize(n);
  graph.for_each(chunks_of(n), [&](std::size_t chunk, int) {
    for (std::size_t k = chunk * kChunk; k < std::min(n, (chunk + 1) * kChunk); ++k) {
      const auto bits = [&](double x, double from) {
        return spread_bits(static_cast<std::uint64_t>((x - from) / cell));
      };
      s.keys[k] = {bits(p.record[k].x, low.x()) | bits(p.record[k].y, low.y()) << 1 |
                       bits(p.record[k].z, low.z()) << 2,
                   p.id[k], static_cast<Index>(k)};
    }
  });
  graph.sort(s.keys);
  s.old_of_new.resize(n);
  s.new_of_old.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    s.old_of_new[k] = s.keys[k].row;
    s.new_of_old[s.keys[k].row] = static_cast<Index>(k);
  }
}

template <class Real>
void permute_particles(World<Real>& world, Graph& graph, RebuildScratch<Real>& s) {
  Particles<Real>& p = world.particles;
  const std::size_t n = p.size();
  s.sorted.reset(n);
  graph.for_each(world.tiles(), [&](std::size_t tile, int) {
    const std::size_t first = tile * world.tile_size;
    const std::size_t last = std::min<std::size_t>(n, first + world.tile_size);
    for (std::size_t k = first; k < last; ++k) {
      const Index from = s.old_of_new[k];
#define QUERN_MOVE(type, name, unit, doc) s.sorted.name[k] = p.name[from];
      QUERN_PARTICLE_FIELDS(QUERN_MOVE)
#undef QUERN_MOVE
      const Record<Real>& r = s.sorted.record[k];
      s.sorted.list_x[k] = r.x;
      s.sorted.list_y[k] = r.y;
      s.sorted.list_z[k] = r.z;
      s.sorted.list_vx[k] = static_cast<float>(r.vx);
      s.sorted.list_vy[k] = static_cast<float>(r.vy);
      s.sorted.list_vz[k] = static_cast<float>(r.vz);
      s.points[k] = {{r.x, r.y, r.z},
                     static_cast<double>(r.radius),
                     {s.sorted.list_vx[k], s.sorted.list_vy[k], s.sorted.list_vz[k]},
                     0,
                     s.sorted.id[k]};
    }
  });
#define QUERN_SWAP(type, name, unit, doc) std::swap(p.name, s.sorted.name);
  QUERN_PARTICLE_FIELDS(QUERN_SWAP)
#undef QUERN_SWAP
}

template <class Real>
SearchInput search_input(const World<Real>& world, RebuildScratch<Real>& s, std::size_t points) {
  SearchInput in{};
  in.count = points;
  in.point = s.points.get();
  in.window = static_cast<double>(world.clock.list_window) * world.clock.dt;
  in.slack = world.clock.slack;
  Bounds box = together(s.bounds);
  for (std::size_t k = world.particles.size(); k < points; ++k) {
    box.add(Vec3(in.point[k].x[0], in.point[k].x[1], in.point[k].x[2]));
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    in.box.low[a] = world.periodic[a] ? world.low[e] : box.low[e];
    in.box.high[a] = world.periodic[a] ? world.high[e] : box.high[e];
    in.box.period[a] = world.periodic[a] ? world.high[e] - world.low[e] : 0;
  }
  return in;
}

// Hands each tile the pairs that other tiles own with it, in order of owner tile.
template <class Real>
void import_pairs(const World<Real>& world, RebuildScratch<Real>& s) {
  for (auto& list : s.imported) list.clear();
  for (std::size_t tile = 0; tile < world.tiles(); ++tile) {
    for (const CandidatePair& pair : s.own[tile]) {
      const std::size_t other = pair.j / world.tile_size;
      if (other != tile) s.imported[other].push_back(pair);
    }
  }
}

// Gap of two particles where they are now, nearest image; decides the order of an owner's partners.
double gap_of(const SearchInput& in, Index i, Index j) {
  const SearchPoint &a = in.point[i], &b = in.point[j];
  double d2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double dx = a.x[k] - b.x[k];
    if (in.box.period[k] > 0) dx = nearest_image(dx, in.box.period[k]);
    d2 += dx * dx;
  }
  return std::sqrt(d2) - a.radius - b.radius;
}

// Groups pairs by their owner: partners nearest first, owners of many partners first, of those the
// ones with many contacts: few lanes are empty, and the rows of a block touch in most lanes or in
// none.
template <bool kOwn>
void arrange(const SearchInput& in, std::span<const CandidatePair> pairs, Index first,
             BlockPlan& plan) {
  plan.partners.clear();
  plan.lanes.clear();
  const auto owner_of = [](const CandidatePair& p) { return kOwn ? p.i : p.j; };
  Index last = first;
  for (const CandidatePair& p : pairs) last = std::max(last, owner_of(p) + 1);
  std::vector<Index> begin(last - first + 1, 0);
  for (const CandidatePair& p : pairs) ++begin[owner_of(p) - first + 1];
  for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  std::vector<std::pair<double, Index>> partner(pairs.size());
  std::vector<Index> end(begin);
  for (const CandidatePair& p : pairs) {
    partner[end[owner_of(p) - first]++] = {gap_of(in, p.i, p.j), kOwn ? p.j : p.i};
  }
  for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
    std::sort(partner.begin() + begin[k], partner.begin() + begin[k + 1]);
    const Index most = kOwn ? kNoIndex : kLongestImport;
    for (Index from = begin[k]; from < begin[k + 1];) {
      const Index count = std::min(begin[k + 1] - from, most);
      const auto near = partner.begin() + from;
      const auto apart =
          std::find_if(near, near + count, [](const auto& p) { return p.first > 0; });
      plan.lanes.push_back(
          {first + static_cast<Index>(k), from, count, static_cast<Index>(apart - near)});
      from += count;
    }
  }
  for (const auto& p : partner) plan.partners.push_back(p.second);
  std::stable_sort(plan.lanes.begin(), plan.lanes.end(), [](const auto& a, const auto& b) {
    return a.count != b.count ? a.count > b.count : a.touching > b.touching;
  });
}

// Slot of the pair (i, j) in the old batch, or kNoIndex; an owner's slots are kPairPad apart.
template <class Real>
Index old_slot(const PairBatch<Real>& old, Index first, Index count, Index partner) {
  for (Index k = 0; k < count; ++k) {
    const Index slot = first + k * static_cast<Index>(kPairPad);
    if (old.partner[slot] == partner) return slot;
  }
  return kNoIndex;
}

// Fills the blocks of one part of a tile and carries the history of their contacts over.
template <class Real, bool kOwn>
void fill_blocks(World<Real>& world, RebuildScratch<Real>& s, const BlockPlan& plan, Index block) {
  PairBatch<Real>& fresh = s.pairs;
  const PairBatch<Real>& old = world.pairs;
  Particles<Real>& p = world.particles;
  const std::size_t history = fresh.history();
  for (std::size_t at = 0; at < plan.lanes.size(); at += kPairPad, ++block) {
    const std::size_t first_row = fresh.row_begin[block], rows = plan.lanes[at].count;
    for (std::size_t lane = 0; lane < kPairPad; ++lane) {
      const bool empty = at + lane >= plan.lanes.size();
      const BlockPlan::Lane from = plan.lanes[empty ? at : at + lane];
      fresh.owner[block * kPairPad + lane] = from.owner;
      if (kOwn && !empty) {
        p.pair_first[from.owner] = static_cast<Index>(first_row * kPairPad + lane);
        p.pair_count[from.owner] = from.count;
      }
      for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t slot = (first_row + row) * kPairPad + lane;
        Index partner = from.owner, was = kNoIndex;
        if (!empty && row < from.count) {
          partner = plan.partners[from.begin + row];
          const Index i = kOwn ? from.owner : partner, j = kOwn ? partner : from.owner;
          was = old_slot(old, s.sorted.pair_first[i], s.sorted.pair_count[i], s.old_of_new[j]);
        }
        fresh.partner[slot] = partner;
        for (std::size_t k = 0; k < history; ++k) {
          fresh.number(slot, k) = was == kNoIndex ? Real(0) : old.number(was, k);
        }
      }
    }
  }
}

template <class Real>
void lay_out_pairs(World<Real>& world, Graph& graph, RebuildScratch<Real>& s) {
  const std::size_t tiles = world.tiles();
  PairBatch<Real>& fresh = s.pairs;
  fresh.rolling = world.rolling;
  fresh.begin.reset(tiles + 1);
  fresh.own_end.reset(tiles);
  std::vector<Index> row_begin;
  std::size_t rows = 0;
  const auto add_blocks = [&](const BlockPlan& plan) {
    for (std::size_t at = 0; at < plan.lanes.size(); at += kPairPad) {
      row_begin.push_back(static_cast<Index>(rows));
      rows += plan.lanes[at].count;
    }
  };
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    fresh.begin[tile] = static_cast<Index>(row_begin.size());
    add_blocks(s.own_plan[tile]);
    fresh.own_end[tile] = static_cast<Index>(row_begin.size());
    add_blocks(s.imported_plan[tile]);
  }
  QUERN_CHECK(rows * kPairPad < kNoIndex);
  fresh.begin[tiles] = static_cast<Index>(row_begin.size());
  fresh.reset(row_begin.size(), rows);
  row_begin.push_back(static_cast<Index>(rows));
  std::copy(row_begin.begin(), row_begin.end(), fresh.row_begin.begin());
  // The old order's pair_first and pair_count, read while the new ones are written.
  std::swap(s.sorted.pair_first, world.particles.pair_first);
  std::swap(s.sorted.pair_count, world.particles.pair_count);
  Column<Index> old_first = std::move(s.sorted.pair_first);
  Column<Index> old_count = std::move(s.sorted.pair_count);
  s.sorted.release();
  s.sorted.pair_first = std::move(old_first);
  s.sorted.pair_count = std::move(old_count);
  world.particles.pair_first.fill(0);
  world.particles.pair_count.fill(0);
  graph.for_each(tiles, [&](std::size_t tile, int) {
    fill_blocks<Real, true>(world, s, s.own_plan[tile], fresh.begin[tile]);
    fill_blocks<Real, false>(world, s, s.imported_plan[tile], fresh.own_end[tile]);
  });
  std::swap(world.pairs, s.pairs);
}

}  // namespace

double wall_reach(const Body& body, const Vec3& x, const Vec3& v, double time, double span) {
  const Motion& m = body.motion;
  if (m.kind == MotionKind::kFixed) return v.norm() * span;
  const double rate = max_rate(m, time, span);
  if (m.kind != MotionKind::kRotation) return (v.norm() + rate) * span;
  const double distance = (x - m.center).cross(m.axis).norm() + v.norm() * span;
  const Vec3 carried = schedule_value(m.rate, time) * m.axis.cross(x - m.center);
  const double varied = max_rate_change(m, time, span);
  return ((v - carried).norm() + varied * distance) * span + rate * rate * distance * span * span;
}

namespace {

template <class Real>
void find_wall_candidates(World<Real>& world, RebuildScratch<Real>& s, std::size_t tile) {
  WallCandidates& c = world.tile_walls[tile].candidates;
  c.particle.clear();
  c.body.clear();
  c.facet.clear();
  c.first.assign(1, 0);
  const double span = static_cast<double>(world.clock.list_window) * world.clock.dt;
  const std::size_t last =
      std::min<std::size_t>(world.particles.size(), (tile + 1) * world.tile_size);
  for (std::size_t k = tile * world.tile_size; k < last; ++k) {
    const SearchPoint& p = s.points[k];
    const Vec3 x(p.x[0], p.x[1], p.x[2]);
    const Vec3 v = Eigen::Map<const Eigen::Vector3f>(p.v.data()).cast<double>();
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
      const Body& body = world.bodies[b];
      const double reach =
          p.radius + 0.5 * world.clock.slack + wall_reach(body, x, v, world.wall_time(), span);
      const Vec3 in_body = body.pose.rotation.transpose() * (x - body.pose.shift);
      find_facets(body.facets, in_body, reach, c.facet);
      if (c.facet.size() == c.first.back()) continue;
      s.speed[k] = std::max(s.speed[k], static_cast<float>((v - body.velocity.at(x)).norm()));
      c.particle.push_back(static_cast<Index>(k));
      c.body.push_back(static_cast<Index>(b));
      c.first.push_back(static_cast<Index>(c.facet.size()));
    }
  }
}

// Wall springs follow their particles to their new tiles, in particle order.
template <class Real>
void carry_wall_springs(World<Real>& world, const RebuildScratch<Real>& s) {
  std::vector<WallSpring> all;
  for (TileWalls& t : world.tile_walls) {
    all.insert(all.end(), t.springs.begin(), t.springs.end());
    t.springs.clear();
  }
  world.tile_walls.resize(world.tiles());
  for (WallSpring& spring : all) spring.particle = s.new_of_old[spring.particle];
  std::stable_sort(all.begin(), all.end(), [](const WallSpring& a, const WallSpring& b) {
    return a.particle < b.particle;
  });
  for (const WallSpring& spring : all) {
    world.tile_walls[spring.particle / world.tile_size].springs.push_back(spring);
  }
}

}  // namespace

void adapt_lists(Clock& clock, const ListEnd& end) {
  const std::uint64_t lasted = std::max<std::uint64_t>(clock.total_steps - clock.list_step, 1);
  const std::uint64_t next = end.expired ? 2 * clock.list_window : lasted + lasted / 4;
  clock.list_window = std::clamp(next, kShortestWindow, kLongestWindow);
  if (clock.fixed_slack != 0) return;
  if (end.expired) {
    // Nobody came near the limit: four times what was needed is enough for twice the window.
    clock.slack = std::min(clock.slack, 8 * end.deviation);
  } else {
    // Lives and idle slots both grow with the slack s: a step costs about a / s + b s, least where
    // the two are equal.
    const double rebuilding = kRebuildInSlots / static_cast<double>(lasted);
    const double change = std::sqrt(rebuilding / std::max(end.idle_slots, 0.01));
    clock.slack *= std::clamp(change, 0.8, 1.25);
  }
  clock.slack = std::clamp(clock.slack, 0.02 * end.smallest_radius, 1.0 * end.smallest_radius);
}

template <class Real>
void rebuild(World<Real>& world, Graph& graph, RebuildScratch<Real>& s) {
  const std::size_t n = world.particles.size();
  const bool polyhedra = !world.polyhedra.empty();
  if (n == 0 && !polyhedra) {
    world.pairs.begin.reset(1);
    world.pairs.begin[0] = 0;
    world.pairs.own_end.reset(0);
    world.tile_walls.clear();
    return;
  }
  const std::size_t points = n + (polyhedra ? world.polyhedra.size() : 0);
  s.points = std::make_unique_for_overwrite<SearchPoint[]>(points);
  s.speed.assign(n, 0);
  s.bounds.clear();
  if (n > 0) {
    wrap_positions(world, graph, s);
    order_particles(world, graph, s);
    permute_particles(world, graph, s);
    carry_wall_springs(world, s);
  }
  if (polyhedra) add_points(world, s.points.get() + n);

  const SearchInput in = search_input(world, s, points);
  build_grid(in, s.grid);
  const std::size_t tiles = world.tiles();
  s.own.resize(tiles);
  s.imported.resize(tiles);
  if (polyhedra) s.bodies.near.resize(tiles);
  graph.for_each(tiles, [&](std::size_t tile, int) {
    s.own[tile].clear();
    const std::size_t first = tile * world.tile_size;
    find_candidates(in, s.grid, static_cast<Index>(first),
                    static_cast<Index>(std::min<std::size_t>(n, first + world.tile_size)),
                    s.own[tile]);
    if (polyhedra) take_near_spheres(n, s.own[tile], s.bodies.near[tile]);
    if (!world.bodies.empty()) find_wall_candidates(world, s, tile);
  });
  if (polyhedra) {
    search_polyhedra(world, in, s.grid, s.bodies);
    set_body_allowances(world, s.bodies.speed);
  }
  import_pairs(world, s);
  graph.for_each(tiles, [&](std::size_t tile, int) {
    set_allowances(world, tile,
                   {s.own[tile], s.imported[tile], polyhedra ? &s.bodies.near[tile] : nullptr},
                   s.speed);
  });
  if (polyhedra) lay_out_polyhedra(world, graph, in, s.old_of_new, s.bodies);
  s.own_plan.resize(tiles);
  s.imported_plan.resize(tiles);
  graph.for_each(tiles, [&](std::size_t tile, int) {
    const Index first = static_cast<Index>(tile * world.tile_size);
    drop_apart(world.particles.list_allowance, s.own[tile]);
    drop_apart(world.particles.list_allowance, s.imported[tile]);
    arrange<true>(in, s.own[tile], first, s.own_plan[tile]);
    arrange<false>(in, s.imported[tile], first, s.imported_plan[tile]);
  });
  std::vector<std::vector<CandidatePair>>().swap(s.own);
  std::vector<std::vector<CandidatePair>>().swap(s.imported);
  // A rebuild is rare and its scratch is as large as the state: it's given back, in time for the
  // slots.
  s.grid = SearchGrid();
  s.points.reset();
  lay_out_pairs(world, graph, s);
  s.sorted.release();
  s.pairs = PairBatch<Real>();
  std::vector<BlockPlan>().swap(s.own_plan);
  std::vector<BlockPlan>().swap(s.imported_plan);
  world.clock.list_step = world.clock.total_steps;
  world.clock.list_stale = 0;
  ++world.clock.rebuilds;
}

template void rebuild(World<float>&, Graph&, RebuildScratch<float>&);
template void rebuild(World<double>&, Graph&, RebuildScratch<double>&);

}  // namespace quern
