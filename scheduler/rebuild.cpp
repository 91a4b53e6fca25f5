#include "scheduler/rebuild.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "kernels/contact.h"
#include "scheduler/wall_lists.h"

namespace quern {

namespace {

constexpr std::uint64_t kShortestWindow = 4, kLongestWindow = 4000;
// A rebuild costs as much time a particle as so many slots whose spheres do not touch.
constexpr double kRebuildInSlots = 400;
// Of the idle slots, those that a shorter window and a smaller slack would spare.
constexpr double kGrowingShare = 1.0 / 3;
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
void sort_along_curve(const World<Real>& world, Graph& graph, RebuildScratch<Real>& s) {
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
}

template <class Real>
void permute_particles(World<Real>& world, Graph& graph, const std::vector<Index>& old_of_new) {
  Particles<Real>& p = world.particles;
  const auto permute = [&](auto& column) {
    std::remove_reference_t<decltype(column)> sorted;
    sorted.reset(p.size());
    graph.for_each(world.tiles(), [&](std::size_t tile, int) {
      const std::size_t first = tile * world.tile_size;
      const std::size_t last = std::min<std::size_t>(p.size(), first + world.tile_size);
      for (std::size_t k = first; k < last; ++k) sorted[k] = column[old_of_new[k]];
    });
    std::swap(column, sorted);
  };
#define QUERN_PERMUTE(type, name, unit, doc) permute(p.name);
  QUERN_PARTICLE_FIELDS(QUERN_PERMUTE)
#undef QUERN_PERMUTE
}

// Sorts the particles, or leaves them where they are: old_of_new and new_of_old say who went where.
template <class Real>
void order_particles(World<Real>& world, Graph& graph, RebuildScratch<Real>& s) {
  const std::size_t n = world.particles.size();
  s.old_of_new.resize(n);
  s.new_of_old.resize(n);
  const bool sorts = world.clock.rebuilds % kSortEvery == 0;
  if (sorts) sort_along_curve(world, graph, s);
  graph.for_each(chunks_of(n), [&](std::size_t chunk, int) {
    for (std::size_t k = chunk * kChunk; k < std::min(n, (chunk + 1) * kChunk); ++k) {
      s.old_of_new[k] = sorts ? s.keys[k].row : static_cast<Index>(k);
      s.new_of_old[s.old_of_new[k]] = static_cast<Index>(k);
    }
  });
  std::vector<CurveKey>().swap(s.keys);
  if (sorts) permute_particles(world, graph, s.old_of_new);
}

// Where the particles are and how fast: the lines that the lists go by.
template <class Real>
void note_lines(World<Real>& world, Graph& graph, SearchPoint* points) {
  Particles<Real>& p = world.particles;
  graph.for_each(chunks_of(p.size()), [&](std::size_t chunk, int) {
    for (std::size_t k = chunk * kChunk; k < std::min(p.size(), (chunk + 1) * kChunk); ++k) {
      const Record<Real>& r = p.record[k];
      p.list_x[k] = r.x;
      p.list_y[k] = r.y;
      p.list_z[k] = r.z;
      p.list_vx[k] = static_cast<float>(r.vx);
      p.list_vy[k] = static_cast<float>(r.vy);
      p.list_vz[k] = static_cast<float>(r.vz);
      points[k] = {{r.x, r.y, r.z},
                   static_cast<double>(r.radius),
                   {p.list_vx[k], p.list_vy[k], p.list_vz[k]},
                   0,
                   p.id[k]};
    }
  });
}

template <class Real>
SearchInput search_input(const World<Real>& world, const RebuildScratch<Real>& s,
                         Column<SearchPoint>& point) {
  SearchInput in{};
  in.count = point.size();
  in.point = point.data();
  in.window = static_cast<double>(world.clock.list_window) * world.clock.dt;
  in.slack = world.clock.slack;
  Bounds box = together(s.bounds);
  for (std::size_t k = world.particles.size(); k < point.size(); ++k) {
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

}  // namespace

void adapt_lists(Clock& clock, const ListEnd& end) {
  const std::uint64_t lasted = std::max<std::uint64_t>(clock.total_steps - clock.list_step, 1);
  // What a rebuild costs a step beside that part of the idle slots which grows with window and
  // slack: least together where the two are equal.
  const double rebuilding = kRebuildInSlots / static_cast<double>(lasted);
  const double balance = rebuilding / (kGrowingShare * std::max(end.idle_slots, 0.01));
  const double grown =
      static_cast<double>(lasted) * (end.expired ? std::clamp(balance, 0.8, 2.0) : 1.25);
  clock.list_window =
      std::clamp(static_cast<std::uint64_t>(grown), kShortestWindow, kLongestWindow);
  if (clock.fixed_slack != 0) return;
  if (end.expired) {
    // Nobody came near the limit: four times what was needed is enough for twice the window.
    clock.slack = std::min(clock.slack, 8 * end.deviation);
  } else {
    clock.slack *= std::clamp(std::sqrt(balance), 0.8, 1.25);
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
  // The step writes all of the next records: the points have their place meanwhile.
  world.particles.record_next.release();
  world.particles.traits_next.release();
  Column<SearchPoint> point;  // of spheres, then of polyhedra
  point.reset(n + (polyhedra ? world.polyhedra.size() : 0));
  s.speed.assign(n, 0);
  s.bounds.clear();
  if (n > 0) {
    wrap_positions(world, graph, s);
    order_particles(world, graph, s);
    note_lines(world, graph, point.data());
    carry_wall_springs(world, s.new_of_old);
  }
  if (polyhedra) add_points(world, point.data() + n);

  const SearchInput in = search_input(world, s, point);
  build_grid(in, s.grid, [&](std::size_t count, const std::function<void(std::size_t)>& task) {
    graph.for_each(count, [&](std::size_t k, int) { task(k); });
  });
  const std::size_t tiles = world.tiles();
  s.pairs.resize(tiles);
  if (polyhedra) s.bodies.near.resize(tiles);
  const auto first_of = [&](std::size_t tile) {
    return static_cast<Index>(tile * world.tile_size);
  };
  const auto size_of = [&](std::size_t tile) {
    return std::min(world.tile_size, static_cast<Index>(n) - first_of(tile));
  };
  graph.for_each(tiles, [&](std::size_t tile, int) {
    TilePairs& pairs = s.pairs[tile];
    make_room(pairs);
    find_candidates(in, s.grid, first_of(tile), first_of(tile) + size_of(tile), pairs.own);
    if (polyhedra) take_near_spheres(n, pairs.own, s.bodies.near[tile]);
    find_leaving(tile, tiles, world.tile_size, pairs);
    if (!world.bodies.empty()) find_wall_candidates(world, in.point, tile, s.speed);
  });
  if (polyhedra) {
    search_polyhedra(world, in, s.grid, s.bodies);
    set_body_allowances(world, s.bodies.speed);
  }
  address_runs(s.pairs);
  graph.for_each(tiles, [&](std::size_t tile, int) {
    import_pairs(s.pairs, tile);
    const TilePairs& pairs = s.pairs[tile];
    set_allowances(world, tile,
                   {pairs.own, pairs.imported, polyhedra ? &s.bodies.near[tile] : nullptr},
                   s.speed);
  });
  if (polyhedra) lay_out_polyhedra(world, graph, in, s.old_of_new, s.bodies);
  graph.for_each(tiles, [&](std::size_t tile, int) {
    plan_blocks(world.particles.list_allowance, first_of(tile), size_of(tile), s.pairs[tile]);
  });
  lay_out_pairs(world, graph, s.pairs, s.old_of_new, s.layout);
  point.release();
  world.particles.reset_next();
  world.clock.list_step = world.clock.total_steps;
  world.clock.list_stale = 0;
  ++world.clock.rebuilds;
}

template void rebuild(World<float>&, Graph&, RebuildScratch<float>&);
template void rebuild(World<double>&, Graph&, RebuildScratch<double>&);

}  // namespace quern
