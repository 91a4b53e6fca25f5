// Polyhedron against sphere, ours beside libccd, FCL and Bullet, on the same pairs, one core.
//
// Rocks of 12 faces and 20 vertices, 1 to 2 m large, which suits the absolute tolerances of others;
// spheres all about them with a given overlap or gap, of the rock's size and of a fifth of it. Ours
// takes them in groups about one rock, as listed pairs come; the others take pairs. Before anything
// is timed every program's hits and depths are compared with the plain kernel's and the differences
// printed; ours must agree to rounding, or nothing is timed. Times are per pair, poses included;
// run with --benchmark_repetitions=9 for medians.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>

#include "bench/kernels/peers.h"
#include "kernels/pairs/polyhedron_sphere.h"
#include "tests/support/convex_shapes.h"

namespace quern {
namespace {

constexpr std::size_t kPairs = 960;

struct Case {
  const char* name;
  double size;     // sphere radius over the rock's scale
  double overlap;  // over the sphere's radius; negative: a gap
};
constexpr Case kCases[] = {
    {"equal size, overlap 1e-3", 1, 1e-3},  {"equal size, gap 1e-2", 1, -1e-2},
    {"equal size, gap 0.3", 1, -0.3},       {"small sphere, overlap 1e-3", 0.2, 1e-3},
    {"small sphere, gap 1e-2", 0.2, -1e-2}, {"small sphere, gap 0.3", 0.2, -0.3}};

const std::vector<Shape>& rocks() {
  static const std::vector<Shape> all = [] {
    std::vector<Shape> made;
    for (unsigned seed = 1; made.size() < 8; ++seed) {
      Shape s = test::rock("rock", 12, seed, Vec3::Ones());
      if (s.faces == 12 && s.vertices == 20 && s.bound_radius < 2) made.push_back(std::move(s));
    }
    return made;
  }();
  return all;
}

// A centre in this direction whose sphere has this overlap.
Vec3 place_sphere(const ShapePose& rock, const Vec3& direction, double radius, double overlap) {
  double low = 0, high = 2 * (rock.scale * rock.shape->bound_radius + radius);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    PolyhedronSphereTouch t;
    // Measured with a sphere that reaches at any distance.
    touch_polyhedron_sphere(rock, middle * direction, radius + high, t);
    (t.overlap - high > overlap ? low : high) = middle;
  }
  return high * direction;
}

// The pairs of a case in groups about one rock.
struct Groups {
  std::vector<peers::BodyPair> pairs;
  std::vector<PolyhedronSphereGroup> groups;
  std::vector<ShapePose> poses;
  Column<double> in[4];
  std::vector<NearTouch> touch;
  std::vector<Index> slot;
  std::vector<std::uint8_t> open;

  Groups(const Case& c, std::size_t group_size) {
    std::mt19937 draw(11);
    const std::size_t padded = (group_size + kShapePad - 1) / kShapePad * kShapePad;
    const std::size_t count = kPairs / group_size;
    for (Column<double>& column : in) {
      column.reset(count * padded);
      column.fill(0);
    }
    poses.reserve(count);
    touch.resize(count * padded);
    slot.resize(count * padded);
    open.resize(padded / kShapePad);
    for (std::size_t g = 0; g < count; ++g) {
      add_group(c, g * padded, group_size, draw);
    }
  }

 private:
  void add_group(const Case& c, std::size_t at, std::size_t size, std::mt19937& draw) {
    std::uniform_real_distribution<double> u(0, 1);
    const Shape& shape = rocks()[draw() % rocks().size()];
    PolyhedronSphereGroup group;
    poses.push_back(
        {&shape, 1 + u(draw), Vec3(u(draw), u(draw), u(draw)), test::random_turn(draw)});
    const ShapePose& pose = poses.back();
    group.pose = &pose;
    const double radius = c.size * pose.scale;
    for (std::size_t k = 0; k < size; ++k) {
      const Vec3 center =
          place_sphere(pose, test::random_direction(draw), radius, c.overlap * radius);
      for (int axis = 0; axis < 3; ++axis) in[axis][at + k] = center[axis];
      in[3][at + k] = radius;
      pairs.push_back({pose, {nullptr, radius, pose.place + center, Mat3::Identity()}});
    }
    group.count = size;
    for (int axis = 0; axis < 3; ++axis) group.center[axis] = in[axis].data() + at;
    group.radius = in[3].data() + at;
    group.open = open.data();
    group.touch = touch.data() + at;
    group.slot = slot.data() + at;
    groups.push_back(group);
  }
};

PolyhedronSphereTouch plain(const peers::BodyPair& pair) {
  PolyhedronSphereTouch t;
  touch_polyhedron_sphere(pair.a, pair.b.place - pair.a.place, pair.b.scale, t);
  return t;
}

// Overlap and normal to rounding of numbers the size of the places, some 10 m.
void check_ours(const Case& c) {
  Groups set(c, 24);
  std::size_t at = 0;
  for (const PolyhedronSphereGroup& g : set.groups) {
    const std::size_t told = choose_polyhedron_sphere().touch(g);
    for (std::size_t k = 0, n = 0; k < g.count; ++k, ++at) {
      const PolyhedronSphereTouch t = plain(set.pairs[at]);
      const NearTouch* ours = n < told && g.slot[n] == k ? &g.touch[n++] : nullptr;
      const bool same = ours != nullptr ? std::abs(ours->overlap - t.overlap) < 1e-13 &&
                                              (Vec3(ours->normal) - t.normal).norm() < 1e-12
                                        : t.overlap <= 0;
      if (same) continue;
      std::fprintf(stderr, "kernel and plain kernel differ: %s, pair %zu\n", c.name, at);
      std::exit(1);
    }
  }
}

void compare_peers(const Case& c, const std::vector<std::unique_ptr<peers::Peer>>& all) {
  const Groups set(c, 24);
  for (const auto& peer : all) {
    peer->load(set.pairs);
    std::size_t wrong_hit = 0;
    std::vector<double> error, turned;
    for (std::size_t k = 0; k < set.pairs.size(); ++k) {
      const peers::Hit hit = peer->touch(k);
      const PolyhedronSphereTouch t = plain(set.pairs[k]);
      wrong_hit += hit.hit != (t.overlap > 0) ? 1 : 0;
      if (!hit.hit || t.overlap <= 0) continue;
      error.push_back(std::abs(hit.depth / t.overlap - 1));
      turned.push_back((hit.normal - t.normal).norm());
    }
    std::sort(error.begin(), error.end());
    std::sort(turned.begin(), turned.end());
    if (error.empty()) {
      std::printf("%-28s %-22s wrong hits %zu of %zu\n", c.name, peer->name(), wrong_hit,
                  set.pairs.size());
      continue;
    }
    std::printf(
        "%-28s %-22s wrong hits %zu of %zu; depth error median %.1e max %.1e; normal %.1e %.1e\n",
        c.name, peer->name(), wrong_hit, set.pairs.size(), error[error.size() / 2], error.back(),
        turned[turned.size() / 2], turned.back());
  }
}

void report(benchmark::State& state, std::size_t pairs) {
  state.counters["per_pair"] =
      benchmark::Counter(static_cast<double>(pairs), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

void time_ours(benchmark::State& state, const Case& c, std::size_t group_size) {
  const Groups set(c, group_size);
  const PolyhedronSphereKernel kernel = choose_polyhedron_sphere();
  for (auto unused : state) {
    std::size_t touching = 0;
    for (const PolyhedronSphereGroup& g : set.groups) touching += kernel.touch(g);
    benchmark::DoNotOptimize(touching);
  }
  report(state, set.pairs.size());
}

void time_plain(benchmark::State& state, const Case& c) {
  const Groups set(c, 24);
  for (auto unused : state) {
    for (const peers::BodyPair& pair : set.pairs) benchmark::DoNotOptimize(plain(pair).overlap);
  }
  report(state, set.pairs.size());
}

void time_peer(benchmark::State& state, const Case& c, peers::Peer& peer) {
  const Groups set(c, 24);
  peer.load(set.pairs);
  for (auto unused : state) {
    for (std::size_t k = 0; k < set.pairs.size(); ++k)
      benchmark::DoNotOptimize(peer.touch(k).depth);
  }
  report(state, set.pairs.size());
}

void register_all(const std::vector<std::unique_ptr<peers::Peer>>& all) {
  for (const Case& c : kCases) {
    const std::string name(c.name);
    for (const std::size_t size : {1, 4, 8, 24, 96}) {
      benchmark::RegisterBenchmark((name + "/quern, groups of " + std::to_string(size)).c_str(),
                                   [&c, size](benchmark::State& s) { time_ours(s, c, size); });
    }
    benchmark::RegisterBenchmark((name + "/quern, plain").c_str(),
                                 [&c](benchmark::State& s) { time_plain(s, c); });
    for (const auto& peer : all) {
      benchmark::RegisterBenchmark((name + "/" + peer->name()).c_str(),
                                   [&c, &peer](benchmark::State& s) { time_peer(s, c, *peer); });
    }
  }
}

}  // namespace
}  // namespace quern

int main(int argc, char** argv) {
  const auto all = quern::peers::all_peers();
  for (const quern::Case& c : quern::kCases) {
    quern::check_ours(c);
    quern::compare_peers(c, all);
  }
  std::printf("SIMD target %s\n", quern::choose_polyhedron_sphere().target);
  quern::register_all(all);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
