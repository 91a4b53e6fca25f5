// Candidate lists against brute force: every pair that may touch within the window, once, by its
// owner, and no pair that can't; on every SIMD target of this CPU.
//
// The oracle looks at all pairs and all 27 images and finds the closest approach on straight lines
// by ternary search (the square of a distance on straight lines is convex in time). Both work in
// f64 on lengths of a few metres: pairs whose gap is within 1e-9 m of the slack may be listed or
// not.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "kernels/candidates.h"
#include "tests/support/contact_cases.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

using test::for_each_target;
using test::Random;

constexpr double kDoubt = 1e-9;  // m

struct SearchScene {
  std::vector<SearchPoint> point;
  SearchBox box;
  double window = 0, slack = 0;

  std::size_t size() const { return point.size(); }
  Vec3 place(std::size_t k) const { return {point[k].x[0], point[k].x[1], point[k].x[2]}; }
  Vec3 velocity(std::size_t k) const {
    return Eigen::Vector3f(point[k].v[0], point[k].v[1], point[k].v[2]).cast<double>();
  }
  SearchInput input() {
    SearchInput in{};
    in.point = point.data();
    in.count = size();
    in.box = box;
    in.window = window;
    in.slack = slack;
    return in;
  }
};

struct SceneOptions {
  std::size_t count = 300;
  double ratio = 10;     // largest to smallest radius
  double speed = 3;      // m/s, of particles against each other
  double window = 3e-3;  // s
  std::array<bool, 3> periodic{};
  double drift = 5;  // m/s, common
};

constexpr double kSmallest = 0.0075;     // m, radius
constexpr double kLow = 3, kSide = 0.8;  // m, of the box

// Spheres anywhere in a box; the box is tight around them if not periodic.
SearchScene random_scene(const SceneOptions& o, unsigned seed) {
  Random random(seed);
  SearchScene s;
  s.window = o.window;
  s.slack = 0.2 * kSmallest;
  const Vec3 drift = random.in_cube(o.drift);
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (std::size_t k = 0; k < o.count; ++k) {
    SearchPoint p{};
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      p.x[a] = kLow + random(0, kSide);
      p.v[a] = static_cast<float>(drift[e] + random(-o.speed, o.speed));
      low[e] = std::min(low[e], p.x[a]);
      high[e] = std::max(high[e], p.x[a]);
    }
    // Some of one size, so that identity decides.
    const double size = random.below(4) == 0 ? 2 : std::pow(o.ratio, random(0, 1));
    p.radius = kSmallest * std::min(size, o.ratio);
    p.id = static_cast<Index>(k);
    s.point.push_back(p);
  }
  for (std::size_t k = o.count; k > 1; --k) {
    std::swap(s.point[k - 1].id, s.point[random.below(k)].id);
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    s.box.low[a] = o.periodic[a] ? kLow : low[e];
    s.box.high[a] = o.periodic[a] ? kLow + kSide : high[e];
    s.box.period[a] = o.periodic[a] ? kSide : 0;
  }
  return s;
}

double closest_approach(const Vec3& dx, const Vec3& dv, double window, double enough) {
  const double least = dx.norm() - window * dv.norm();
  if (least > enough) return least;
  double low = 0, high = window;
  for (int k = 0; k < 100; ++k) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (((dx + a * dv).squaredNorm() < (dx + b * dv).squaredNorm()) ? high : low) =
        (dx + a * dv).squaredNorm() < (dx + b * dv).squaredNorm() ? b : a;
  }
  return std::min({dx.norm(), (dx + window * dv).norm(), (dx + low * dv).norm()});
}

// Smallest gap of the pair within the window, over all images; any gap beyond the slack if it is
// beyond the slack.
double smallest_gap(const SearchScene& s, std::size_t i, std::size_t j) {
  const double reach = s.point[i].radius + s.point[j].radius;
  double best = 1e300;
  int turns[3];
  for (turns[0] = -1; turns[0] <= 1; ++turns[0]) {
    for (turns[1] = -1; turns[1] <= 1; ++turns[1]) {
      for (turns[2] = -1; turns[2] <= 1; ++turns[2]) {
        Vec3 dx = s.place(i) - s.place(j);
        bool counts = true;
        for (std::size_t a = 0; a < 3; ++a) {
          dx[static_cast<Eigen::Index>(a)] += turns[a] * s.box.period[a];
          counts = counts && (turns[a] == 0 || s.box.period[a] > 0);
        }
        if (!counts) continue;
        best = std::min(best, closest_approach(dx, s.velocity(i) - s.velocity(j), s.window,
                                               reach + s.slack + 1e-6));
      }
    }
  }
  return best - reach;
}

std::map<std::pair<Index, Index>, double> gaps_of(const SearchScene& s) {
  std::map<std::pair<Index, Index>, double> gaps;
  for (Index i = 0; i < s.size(); ++i) {
    for (Index j = 0; j < s.size(); ++j) {
      const SearchPoint &a = s.point[i], &b = s.point[j];
      const bool owns = a.radius < b.radius || (a.radius == b.radius && a.id < b.id);
      if (!owns) continue;
      const double gap = smallest_gap(s, i, j);
      if (gap < s.slack + 10 * kDoubt) gaps[{i, j}] = gap;
    }
  }
  return gaps;
}

std::vector<CandidatePair> candidates(SearchScene s, std::size_t tile = 64) {
  const SearchInput in = s.input();
  SearchGrid grid;
  build_grid(in, grid, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    for (std::size_t k = count; k-- > 0;) task(k);
  });
  std::vector<CandidatePair> found;
  for (std::size_t first = 0; first < s.size(); first += tile) {
    find_candidates(in, grid, static_cast<Index>(first),
                    static_cast<Index>(std::min(s.size(), first + tile)), found);
  }
  return found;
}

void compare(const SearchScene& s, const std::map<std::pair<Index, Index>, double>& gaps) {
  const std::vector<CandidatePair> found = candidates(s);
  std::set<std::pair<Index, Index>> listed;
  for (const CandidatePair& p : found) {
    EXPECT_TRUE(listed.insert({p.i, p.j}).second) << "listed twice";
    EXPECT_TRUE(gaps.contains({p.i, p.j})) << "listed, but stays apart or is owned by the other";
  }
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.i != b.i ? a.i < b.i : a.j < b.j;
  }));
  for (const auto& [pair, gap] : gaps) {
    if (gap > s.slack - kDoubt) continue;
    EXPECT_TRUE(listed.contains(pair))
        << "missed " << pair.first << " and " << pair.second << ", gap " << gap << ", radii "
        << s.point[pair.first].radius << " and " << s.point[pair.second].radius;
  }
}

constexpr std::array<bool, 3> kBoxes[] = {
    {false, false, false}, {false, false, true}, {true, true, true}};

TEST(Lists, HoldExactlyThePairsThatMayTouchWithinTheWindow) {
  for (const auto& periodic : kBoxes) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      SceneOptions o;
      o.periodic = periodic;
      if (seed % 3 == 0) {
        o.ratio = 1;
        o.count = 600;
      }
      const SearchScene s = random_scene(o, seed);
      const auto gaps = gaps_of(s);
      ASSERT_GT(gaps.size(), 5u);
      for_each_target<double>([&](const std::string& target) {
        SCOPED_TRACE(target);
        compare(s, gaps);
      });
    }
  }
}

// Few particles, so that the runs of grid entries have every length from nothing to three vectors.
TEST(Lists, HoldExactlyThePairsOfTinyScenes) {
  for (std::size_t count = 1; count <= 3 * 16 + 1; ++count) {
    SceneOptions o;
    o.count = count;
    o.ratio = 20;
    o.periodic = kBoxes[count % 3];
    const SearchScene s = random_scene(o, static_cast<unsigned>(count));
    const auto gaps = gaps_of(s);
    for_each_target<double>([&](const std::string& target) {
      SCOPED_TRACE(target + ", " + std::to_string(count) + " particles");
      compare(s, gaps);
    });
  }
}

// Long windows: particles cross several times their own size, into and over periodic faces.
TEST(Lists, HoldExactlyThePairsThatMeetAfterAFarFlight) {
  for (const auto& periodic : kBoxes) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed) + (periodic[0] ? ", periodic" : ""));
      SceneOptions o;
      o.count = 150;
      o.periodic = periodic;
      o.speed = 5;
      o.window = 12e-3;
      o.ratio = 6;
      o.drift = seed % 2 == 0 ? 5 : 0;
      const SearchScene s = random_scene(o, seed + 50);
      compare(s, gaps_of(s));
    }
  }
}

// Head on the least distance is zero, or less by rounding: no root of that.
TEST(Lists, HoldPairsThatMeetHeadOn) {
  SceneOptions o;
  o.count = 2;
  o.drift = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SearchScene s = random_scene(o, seed);
    s.window = 1;
    Random random(seed);
    s.point[0].x[0] = s.point[1].x[0] + random(0.05, 0.2);
    s.point[0].v[0] = s.point[1].v[0] - static_cast<float>(random(1, 300));
    for (std::size_t a = 1; a < 3; ++a) {
      s.point[0].x[a] = s.point[1].x[a];
      s.point[0].v[a] = s.point[1].v[a];
    }
    const std::vector<CandidatePair> found = candidates(s);
    ASSERT_EQ(found.size(), 1u) << seed;
    // 2^-52 of 0.2 m squared, and its root: 1e-9 m.
    EXPECT_NEAR(found[0].gap, -(s.point[0].radius + s.point[1].radius), 1e-6 * kSide) << seed;
  }
}

// What the lists are for: particles leave their straight lines by up to half the slack, in any
// direction at any time, and no touch is missed.
TEST(Lists, MissNoContactOfParticlesThatDeviateByHalfTheSlack) {
  int touches = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SceneOptions o;
    o.periodic = kBoxes[seed % 3];
    const SearchScene s = random_scene(o, seed + 100);
    std::set<std::pair<Index, Index>> listed;
    for (const CandidatePair& p : candidates(s)) listed.insert({p.i, p.j});
    Random random(seed);
    for (int look = 0; look < 4; ++look) {
      const double time = s.window * look / 3;
      SearchScene later = s;  // at a moment: no window, no slack
      later.window = 0;
      for (std::size_t k = 0; k < s.size(); ++k) {
        // On the sphere of radius slack / 2, less what the rounding of the test's own sums takes.
        const Vec3 off = random.in_cube(1).normalized() * (0.5 * s.slack - kDoubt);
        for (std::size_t a = 0; a < 3; ++a) {
          const Eigen::Index e = static_cast<Eigen::Index>(a);
          double& x = later.point[k].x[a];
          x += time * s.velocity(k)[e] + off[e];
          const double period = s.box.period[a];
          if (period > 0) x -= period * std::floor((x - s.box.low[a]) / period);
        }
      }
      later.slack = 0;
      for (const auto& [pair, gap] : gaps_of(later)) {
        if (gap > 0) continue;
        ++touches;
        EXPECT_TRUE(listed.contains(pair)) << "seed " << seed << ", at " << time;
      }
    }
  }
  EXPECT_GT(touches, 300);
}

}  // namespace
}  // namespace quern
