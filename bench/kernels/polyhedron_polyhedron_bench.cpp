// Polyhedron against polyhedron, ours beside libccd, FCL and Bullet, on the same pairs, one core.
//
// Random rocks of 12 faces and 20 vertices and of 40 triangles and 22 vertices, equivalent radius 1
// and 0.9, with a given overlap or gap. "kept axis": what a listed pair remembers, the case of
// nearly every step; "new pair": nothing known, GJK first. Others give the least depth, ours the
// way out along the gradient of the overlap with volume, area and centroid. Before anything is
// timed ours is compared with the plain kernel (it must agree, or nothing is timed) and the others
// with ours; differences of depth are printed. Times are per pair; run with
// --benchmark_repetitions=9 for medians.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>

#include "bench/kernels/peers.h"
#include "tests/support/polyhedra.h"

namespace quern {
namespace {

constexpr std::size_t kPairs = 1000;

struct Case {
  const char* name;
  bool triangles;
  double overlap;  // negative: a gap
};
constexpr Case kCases[] = {{"12 faces, overlap 1e-3", false, 1e-3},
                           {"12 faces, gap 1e-2", false, -1e-2},
                           {"40 triangles, overlap 1e-3", true, 1e-3},
                           {"40 triangles, gap 1e-2", true, -1e-2}};

struct Pairs {
  std::vector<Shape> shapes;
  std::vector<peers::BodyPair> pairs;
  std::vector<PairAxis> kept;

  explicit Pairs(const Case& c) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      shapes.push_back(c.triangles ? rock_of_points(seed, 22) : rock_of_planes(seed, 12));
    }
    std::mt19937_64 random(3);
    for (std::size_t k = 0; k < kPairs; ++k) {
      peers::BodyPair pair;
      pair.a.shape = &shapes[random() % shapes.size()];
      pair.b.shape = &shapes[random() % shapes.size()];
      pair.a.turn = random_turn(random);
      pair.b.turn = random_turn(random);
      pair.b.scale = 0.9;
      bring_to_overlap(pair.a, pair.b, random_direction(random), std::max(c.overlap, 1e-9));
      PairAxis axis;
      PolyhedronTouch touch;
      touch_polyhedra(pair.a, pair.b, {}, axis, touch);
      if (c.overlap < 0) {
        pair.b.place -= c.overlap * touch.normal;
        touch_polyhedra(pair.a, pair.b, {}, axis, touch);
      }
      pairs.push_back(pair);
      kept.push_back(axis);
    }
  }
};

void check_ours(const Case& c, const Pairs& set) {
  for (std::size_t k = 0; k < kPairs; ++k) {
    PairAxis axis = set.kept[k];
    PolyhedronTouch ours, plain;
    const peers::BodyPair& p = set.pairs[k];
    const bool hit = touch_polyhedra(p.a, p.b, {}, axis, ours);
    const bool plain_hit = touch_polyhedra_plain(p.a, p.b, {}, nullptr, Vec3::Zero(), plain);
    const bool same = hit == plain_hit && hit == (c.overlap > 0) &&
                      (!hit || (std::abs(ours.overlap / plain.overlap - 1) < 1e-9 &&
                                std::abs(ours.volume / plain.volume - 1) < 1e-9));
    if (same) continue;
    std::fprintf(stderr, "kernel and plain kernel differ: %s, pair %zu\n", c.name, k);
    std::exit(1);
  }
}

void compare_peer(const Case& c, const Pairs& set, peers::Peer& peer) {
  peer.load(set.pairs);
  std::size_t wrong = 0;
  std::vector<double> error;
  for (std::size_t k = 0; k < kPairs; ++k) {
    const peers::Hit hit = peer.touch(k);
    wrong += hit.hit != (c.overlap > 0) ? 1 : 0;
    if (hit.hit && c.overlap > 0) error.push_back(std::abs(hit.depth / c.overlap - 1));
  }
  std::sort(error.begin(), error.end());
  std::printf("%-28s %-22s wrong hits %zu of %zu", c.name, peer.name(), wrong, kPairs);
  if (!error.empty()) {
    std::printf("; depth less ours: median %.1e, 99 %% %.1e, max %.1e", error[error.size() / 2],
                error[error.size() * 99 / 100], error.back());
  }
  std::printf("\n");
}

void report(benchmark::State& state) {
  state.counters["per_pair"] = benchmark::Counter(
      static_cast<double>(kPairs),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

enum class Know : std::uint8_t { kKeptAxis, kNothing };

void time_ours(benchmark::State& state, const Pairs& set, Know know, const PatchOptions& options) {
  for (auto unused : state) {
    for (std::size_t k = 0; k < kPairs; ++k) {
      PairAxis axis = know == Know::kKeptAxis ? set.kept[k] : PairAxis{};
      PolyhedronTouch touch;
      benchmark::DoNotOptimize(
          touch_polyhedra(set.pairs[k].a, set.pairs[k].b, options, axis, touch));
      benchmark::DoNotOptimize(touch);
    }
  }
  report(state);
}

void time_plain(benchmark::State& state, const Pairs& set) {
  for (auto unused : state) {
    for (std::size_t k = 0; k < kPairs; ++k) {
      const Vec3 slab(set.kept[k].axis[0], set.kept[k].axis[1], set.kept[k].axis[2]);
      PolyhedronTouch touch;
      benchmark::DoNotOptimize(
          touch_polyhedra_plain(set.pairs[k].a, set.pairs[k].b, {}, &slab, slab, touch));
    }
  }
  report(state);
}

void time_peer(benchmark::State& state, const Pairs& set, peers::Peer& peer) {
  peer.load(set.pairs);
  for (auto unused : state) {
    for (std::size_t k = 0; k < kPairs; ++k) benchmark::DoNotOptimize(peer.touch(k).depth);
  }
  report(state);
}

void register_case(const Case& c, const Pairs& set,
                   const std::vector<std::unique_ptr<peers::Peer>>& all) {
  const std::string name(c.name);
  const auto add = [&](const std::string& row, auto run) {
    benchmark::RegisterBenchmark((name + "/" + row).c_str(), run);
  };
  const PatchOptions chord, width{OverlapMeasure::kWidth, NormalModel::kStiffness};
  add("quern, kept axis", [&set, chord](auto& s) { time_ours(s, set, Know::kKeptAxis, chord); });
  add("quern, new pair", [&set, chord](auto& s) { time_ours(s, set, Know::kNothing, chord); });
  if (c.overlap > 0) {
    add("quern, width", [&set, width](auto& s) { time_ours(s, set, Know::kKeptAxis, width); });
    add("quern, plain", [&set](auto& s) { time_plain(s, set); });
  }
  for (const auto& peer : all) {
    add(peer->name(), [&set, &peer](auto& s) { time_peer(s, set, *peer); });
  }
}

}  // namespace
}  // namespace quern

int main(int argc, char** argv) {
  const auto all = quern::peers::all_peers();
  std::vector<std::unique_ptr<quern::Pairs>> sets;
  for (const quern::Case& c : quern::kCases) {
    sets.push_back(std::make_unique<quern::Pairs>(c));
    quern::check_ours(c, *sets.back());
    for (const auto& peer : all) quern::compare_peer(c, *sets.back(), *peer);
    quern::register_case(c, *sets.back(), all);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
