// The angles with their errors, on charges whose angles are known: a map of exact cells and
// contacts with the liner that a made-up charge would have, handed over one by one.
#include "kernels/charge_angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernels/charge_map.h"
#include "kernels/liner_histogram.h"

namespace quern {
namespace {

constexpr double kDegree = kPi / 180, kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kBlocks = 10;

// A charge along the shell from the toe counterclockwise through 270 degrees to the shoulder, 0.3 m
// thick in a mill of 1 m, full cells only; contact with the liner from the toe on to the head, hits
// from the toe back to `last_hit`. All in degrees.
struct Known {
  double toe = 230, shoulder = 40, head = 75, last_hit = 195;
  double jitter = 0;  // of all of them, from block to block
  double direction = 1;
  bool hits = true;

  double place(double degree) const { return direction > 0 ? degree : 180 - degree; }
  double moved(int block) const { return jitter * (block % 2 == 0 ? 1 : -1); }

  ChargeMap map(int block) const {
    PolarGrid grid{360, 20, 1};
    ChargeMap map = make_charge_map(grid, 1);
    map.snapshots = 1;
    const int from = static_cast<int>(std::lround(toe + moved(block)));
    const int to = static_cast<int>(std::lround(shoulder + moved(block) + 360));
    for (int degree = from; degree < to; ++degree) {
      const int turned = static_cast<int>(place(degree + 0.5) + 720) % 360;
      for (int ring = 14; ring < 20; ++ring)
        map.volume[grid.cell(ring, turned)] = 0.6 * grid.area(ring);
    }
    return map;
  }

  LinerHistogram liner(int block) const {
    LinerHistogram liner = make_liner_histogram();
    constexpr double kDt = 1e-3;
    const auto touch = [&](double degree, double loss, LinerTouch kind) {
      const double angle = place(degree + moved(block)) * kDegree;
      add_to_liner(liner_bin(std::cos(angle), std::sin(angle)), kDt, loss, kind, liner);
    };
    for (int k = 0; k < 10 * (head + 360 - toe); ++k) touch(toe + 0.1 * k, 1, LinerTouch::kSlow);
    // 95 % of the joules up to last_hit, the rest 10 degrees beyond.
    for (int k = 0; hits && k < 95; ++k) {
      touch(toe - (k + 0.5) * (toe - last_hit) / 95, 1, LinerTouch::kHit);
    }
    for (int k = 0; hits && k < 5; ++k) touch(last_hit - 10 - 0.1 * k, 1, LinerTouch::kHit);
    return liner;
  }

  ChargeAngles angles(int with_liner = kBlocks) const {
    std::vector<ChargeMap> maps;
    std::vector<LinerHistogram> histograms;
    for (int k = 0; k < kBlocks; ++k) {
      maps.push_back(map(k));
      if (with_liner > 0) histograms.push_back(k < with_liner ? liner(k) : make_liner_histogram());
    }
    ChargeQuery query;
    query.direction = direction;
    query.particle_size = 0.05;
    return find_charge_angles(maps, histograms, query);
  }
};

void expect_degrees(const AngleFigure& figure, double degree) {
  EXPECT_NEAR(angle_near(figure.value, degree * kDegree) / kDegree, degree, 1);
}

TEST(ChargeAngles, AreWithinADegreeOfWhatTheyAre) {
  for (const double direction : {1.0, -1.0}) {
    for (const double head : {60.0, 90.0}) {
      Known known;
      known.direction = direction;
      known.head = head;
      const ChargeAngles found = known.angles();
      expect_degrees(found.shoulder, known.place(known.shoulder));
      expect_degrees(found.toe, known.place(known.toe));
      expect_degrees(found.head, known.place(head));
      expect_degrees(found.impact_toe, known.place(known.last_hit));
      EXPECT_TRUE(found.impacts_found);
      for (const AngleFigure* figure :
           {&found.shoulder, &found.toe, &found.head, &found.impact_toe}) {
        EXPECT_NEAR(figure->error, 0, 1e-12);                 // every block is the same
        EXPECT_NEAR(figure->at_low, figure->value, kDegree);  // edges are sharp
        EXPECT_NEAR(figure->at_high, figure->value, kDegree);
      }
    }
  }
}

// Half of the blocks two degrees one way, half the other: a deviation of 2 sqrt(10 / 9), over the
// root of ten.
TEST(ChargeAngles, HaveTheErrorThatTheirBlocksShow) {
  Known known;
  known.jitter = 2;
  const ChargeAngles found = known.angles();
  for (const AngleFigure* figure : {&found.shoulder, &found.toe, &found.head, &found.impact_toe}) {
    EXPECT_NEAR(figure->error / kDegree, 2 * std::sqrt(10.0 / 9 / 10), 1e-9);
  }
  ASSERT_EQ(found.blocks.size(), 10u);
  EXPECT_NEAR(found.blocks[0].toe - found.blocks[1].toe, 4 * kDegree, 1e-9);
}

TEST(ChargeAngles, WithoutHitsTheImpactToeIsTheToeAndSaysSo) {
  Known known;
  known.hits = false;
  known.jitter = 2;
  const ChargeAngles found = known.angles();
  EXPECT_FALSE(found.impacts_found);
  EXPECT_EQ(found.impact_toe.value, found.toe.value);
  EXPECT_EQ(found.impact_toe.error, found.toe.error);
  EXPECT_TRUE(std::isfinite(found.head.value));
}

TEST(ChargeAngles, WithoutAHistogramHeadAndImpactToeAreUnknown) {
  const ChargeAngles found = Known().angles(0);
  EXPECT_FALSE(found.liner_known);
  EXPECT_TRUE(std::isfinite(found.toe.value));
  EXPECT_TRUE(std::isnan(found.head.value));
  EXPECT_TRUE(std::isnan(found.impact_toe.value));
}

// A run that stopped after three of ten blocks of time.
TEST(ChargeAngles, OfAPartOfTheWindowUseTheBlocksThatAreThere) {
  Known known;
  known.jitter = 2;
  const ChargeAngles found = known.angles(3);
  expect_degrees(found.head, known.head + known.jitter);  // where any block has reached
  // Two blocks one way and one the other: deviation 2 sqrt(8 / 3 / 2), three blocks.
  EXPECT_NEAR(found.head.error / kDegree, 2 * std::sqrt(8.0 / 3 / 2 / 3), 1e-9);
}

TEST(AngleError, IgnoresTurnsAndWhatWasNotFound) {
  const std::vector<double> found = {359 * kDegree, 1 * kDegree, kNan, -2 * kDegree, 2 * kDegree};
  EXPECT_NEAR(angle_spread(0, found) / kDegree, std::sqrt(10.0 / 3), 1e-9);
  EXPECT_NEAR(angle_error(0, found) / kDegree, std::sqrt(10.0 / 3) / 2, 1e-9);
  EXPECT_TRUE(std::isnan(angle_error(0, std::vector<double>{kNan, 1})));
  // Blocks may know what the whole does not; nothing is compared with it.
  EXPECT_TRUE(std::isnan(angle_spread(kNan, found)));
  EXPECT_TRUE(std::isnan(angle_error(kNan, found)));
}

TEST(LinerHistogram, FindsTheBinOfAPointWithoutItsAngle) {
  for (int k = 0; k < 100 * 360; ++k) {
    const double angle = (k + 0.5) / 100 * kDegree, away = std::pow(10, k % 7 - 3);
    EXPECT_EQ(liner_bin(away * std::cos(angle), away * std::sin(angle)), k / 100) << k;
  }
  // Just before and behind where each bin begins.
  for (int k = 1; k < 360; ++k) {
    for (const int side : {-1, 1}) {
      const double angle = k * kDegree + side * 1e-12;
      EXPECT_EQ(liner_bin(std::cos(angle), std::sin(angle)), side > 0 ? k : k - 1) << k;
    }
  }
  EXPECT_EQ(liner_bin(1, 0), 0);
  EXPECT_EQ(liner_bin(0, 3), 90);
  EXPECT_EQ(liner_bin(-2, 0), 180);
  EXPECT_EQ(liner_bin(0, -1), 270);
  EXPECT_EQ(liner_bin(1, -1e-20), 359);
  EXPECT_EQ(liner_bin(0, 0), 0);
}

TEST(LinerHistogram, TakesEachContactInItsBin) {
  LinerHistogram liner = make_liner_histogram(4);
  add_to_liner(0, 1e-3, 2, LinerTouch::kSlow, liner);
  add_to_liner(0, 1e-3, 3, LinerTouch::kHit, liner);
  add_to_liner(3, 1e-3, 5, LinerTouch::kHit, liner);
  add_to_liner(2, 1e-3, 7, LinerTouch::kHit, liner);
  EXPECT_EQ(liner.contact_time, (std::vector<double>{2e-3, 0, 1e-3, 1e-3}));
  EXPECT_EQ(liner.hit_dissipation, (std::vector<double>{3, 0, 7, 5}));
  LinerHistogram sum = liner;
  add_liner(liner, sum);
  EXPECT_EQ(sum.hit_dissipation[2], 14);
  EXPECT_NEAR(hit_speed2(4, 0.5), 0.04, 1e-15);
}

}  // namespace
}  // namespace quern
