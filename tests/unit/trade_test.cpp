// What `quern trade` makes of numbers: peaks and moments of spectra, errors, the front, the table
// and what `quern check` reads from it. Oracles are closed forms and sums written out.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "apps/quern/trade_advice.h"
#include "apps/quern/trade_spectra.h"
#include "apps/quern/trade_table.h"
#include "soa/collisions.h"

namespace quern {
namespace {

double middle(std::size_t bin) {
  return kFirstDecade + (static_cast<double>(bin) - 0.5) / kBinsPerDecade;
}

// Bins of a normal law in log10 E.
std::vector<double> bell(double at, double width, double height) {
  std::vector<double> bins(kEnergyBins, 0);
  for (std::size_t k = 1; k + 1 < kEnergyBins; ++k) {
    const double x = (middle(k) - at) / width;
    bins[k] = height * std::exp(-0.5 * x * x);
  }
  return bins;
}

TEST(TradeSpectra, PeakOfABellIsFoundBetweenTheBins) {
  // The parabola over half a decade to each side errs by the bell's odd part about the bin: below a
  // hundredth of a decade at a width of one decade.
  for (const double at : {-4.0, -4.02, -4.05, -4.08}) {
    EXPECT_NEAR(spectrum_peak(bell(at, 1, 1000)), at, 0.01) << at;
  }
}

TEST(TradeSpectra, NothingHasNoPeak) {
  EXPECT_TRUE(std::isnan(spectrum_peak(std::vector<double>(kEnergyBins, 0))));
}

TEST(TradeSpectra, MomentsAreThoseOfAllKindsWithoutTheOpenBins) {
  std::vector<double> count = bell(-5, 0.5, 100);
  const std::vector<double> second = bell(-3, 0.5, 100);
  count.insert(count.end(), second.begin(), second.end());
  count[0] = 1e9;                    // below all bins
  count[2 * kEnergyBins - 1] = 1e9;  // above all bins
  const std::vector<SpectrumFigure> found = spectrum_figures({count}, {count});
  // Two equal bells two decades apart: mean between them, variance 0.5^2 + 1^2. Both bells lie more
  // than ten widths inside, the sums are those of the integral to rounding.
  EXPECT_NEAR(found[2].value, -4, 1e-9);
  EXPECT_NEAR(found[4].value, std::sqrt(1.25), 1e-9);
  EXPECT_TRUE(std::isnan(found[2].standard_error));  // one block tells no scatter
}

TEST(TradeSpectra, StandardErrorsAreThoseOfTheBlocksThatSumsGrewBy) {
  const std::vector<double> places = {-5, -4.9, -5.2, -5.1};
  std::vector<std::vector<double>> grown;
  std::vector<double> sum(kEnergyBins, 0);
  for (const double at : places) {
    const std::vector<double> block = bell(at, 0.5, 100);
    for (std::size_t k = 0; k < kEnergyBins; ++k) sum[k] += block[k];
    grown.push_back(sum);
  }
  const SpectrumFigure mean = spectrum_figures(grown, grown)[2];
  // Mean -5.05; squares 0.05^2 + 0.15^2 + 0.15^2 + 0.05^2 = 0.05, over 4 x 3.
  EXPECT_NEAR(mean.value, -5.05, 1e-9);
  EXPECT_NEAR(mean.standard_error, std::sqrt(0.05 / 12), 1e-9);
}

TradeFigures figures(double power, double power_error, double toe) {
  TradeFigures f;
  f.figures = {{"power_W", "power", "W", true, power, power_error},
               {"toe_deg", "toe", "deg", false, toe, 0.3}};
  return f;
}

TEST(TradeErrors, AreInPercentOrInTheFiguresUnitWithTheRootOfTheSummedSquares) {
  const std::vector<TradeError> e = errors_of(figures(103, 3, 228), figures(100, 4, 230));
  EXPECT_NEAR(e[0].value, 3, 1e-12);
  EXPECT_NEAR(e[0].standard_error, 5, 1e-12);
  EXPECT_EQ(e[0].unit, "%");
  EXPECT_NEAR(e[1].value, -2, 1e-12);
  EXPECT_NEAR(e[1].standard_error, 0.3 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(e[1].unit, "deg");
}

TEST(TradeErrors, BelowTwoStandardErrorsABoundIsTold) {
  const TradeError below{"a", "a", "%", -0.99, 0.5}, above{"a", "a", "%", -1.01, 0.5};
  EXPECT_TRUE(below.below());
  EXPECT_EQ(error_text(below), "< 1");
  EXPECT_DOUBLE_EQ(below.bound(), 1);
  EXPECT_FALSE(above.below());
  EXPECT_EQ(error_text(above), "-1 +- 0.5");
  EXPECT_DOUBLE_EQ(above.bound(), 1.01);
  EXPECT_EQ(error_text({"a", "a", "%", 146.2, 12.3}), "+146 +- 12");
  EXPECT_EQ(error_text({"a", "a", "%", -0.0123, 0.00456}), "-0.012 +- 0.005");
  EXPECT_EQ(error_text({"a", "a", "%", 1, 60}), "< 120");
  EXPECT_EQ(error_text({"a", "a", "%", NAN, 0.5}), "-");
}

TEST(TradeErrors, OfAProfileIsItsMeanDifferenceAndTheNoiseThatTwoEqualRunsShow) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.1);
  TradeFigures a, b;
  constexpr int kPlaces = 20000;
  for (int k = 0; k < kPlaces; ++k) {
    a.profile.depth.push_back(1 + noise(random));
    b.profile.depth.push_back(1 + noise(random));
    a.profile.error.push_back(0.1);
    b.profile.error.push_back(0.1);
  }
  const TradeError e = errors_of(a, b).back();
  // Both are estimates of 100 sqrt(2 / pi) 0.1 sqrt(2); a mean of 20,000 sizes scatters by 0.6 %.
  EXPECT_NEAR(e.value / e.standard_error, 1, 0.03);
  EXPECT_NEAR(e.standard_error, 11.28, 0.05);
  EXPECT_TRUE(e.below());
}

TradeResult result(const std::string& dial, const std::string& value, double cost, double error,
                   const std::string& precision = "mixed") {
  TradeResult r;
  r.row = {dial, value, {value, {}}, "finest"};
  r.against = "finest";
  r.precision = precision;
  r.cost.ratio = cost;
  r.errors = {{"power_W", "power", "%", error, 0.1}, {"toe_deg", "toe", "deg", 0.1, 0.4}};
  return r;
}

TEST(TradeTable, FrontHoldsWhatNoOtherBeatsInBothCostAndPower) {
  TradeTable table;
  table.rows = {result("default", "a", 1, 1), result("x", "b", 0.5, 2), result("x", "c", 0.6, 3),
                result("x", "d", 2, 0.01), result("x", "e", 3, 0.15)};
  TradeResult failed = result("x", "f", 0.1, 0);
  failed.status = "went wrong";
  table.rows.push_back(failed);
  mark_front(table);
  // e: 0.15 is below two standard errors, and so is d; both are at most 0.2, but d is cheaper.
  const std::vector<bool> expected = {true, true, false, true, false, false};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(table.rows[k].front, expected[k]) << k;
  }
  EXPECT_NE(terminal_text(table).find("went wrong"), std::string::npos);
}

TEST(TradeTable, WhatWentWrongMayBeLongerThanAnyColumn) {
  TradeTable table;
  table.rows = {result("default", "a", 1, 1), result("x", "b", 0.5, 2)};
  const std::size_t head = terminal_text(table).find("\ndefault");
  table.rows.push_back(result("x", "c", 0.1, 0));
  table.rows.back().status = std::string(300, 'w');
  EXPECT_EQ(terminal_text(table).find("\ndefault"), head);
  EXPECT_NE(terminal_text(table).find(table.rows.back().status), std::string::npos);
}

TEST(TradeTable, CheckReadsTheNearestCoarserSettingBackFromCsv) {
  TradeTable table;
  table.rows = {result("default", "13 steps", 1, 0.15), result("steps per contact", "4", 0.3, 7),
                result("steps per contact", "30", 2, -0.5), result("softened", "10 x, so", 0.3, 2),
                result("precision", "double", 1.3, 0.3, "double")};
  const double steps[] = {13, 4, 30, 13, 13}, overlap[] = {0.1, 0.1, 0.1, 0.32, 0.1};
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    table.rows[k].figures.steps_per_contact = steps[k];
    table.rows[k].figures.impact_overlap = overlap[k];
  }
  const std::string csv = csv_text(table);
  const auto lines = [&](double own_steps, double own_overlap, const std::string& precision) {
    return expected_accuracy({own_steps, own_overlap, precision}, {{"mill", csv}});
  };
  const auto says = [](const std::string& line, const std::string& what) {
    EXPECT_NE(line.find(what), std::string::npos) << line << "\nlacks " << what;
  };
  std::vector<std::string> found = lines(20, 0.2, "mixed");
  ASSERT_EQ(found.size(), 3u);
  says(found[0], "mill at 13: power < 0.2 %, toe < 0.8 deg");  // not 30: it is finer
  says(found[1], "mill at 0.32 r: power +2 +- 0.1 %");
  says(found[2], "in mixed: power < 0.2 %");
  found = lines(12.99, 0.1, "double");
  says(found[0], "at 13:");  // as good as equal
  says(found[1], "at 0.1 r:");
  says(found[2], "in double: power +0.3 +- 0.1 %");
  found =
      lines(3, 0.5, "single");  // coarser than all: the coarsest; a precision not measured: no line
  ASSERT_EQ(found.size(), 2u);
  says(found[0], "at 4: power +7 +- 0.1 %");
  says(found[1], "at 0.32 r:");
}

}  // namespace
}  // namespace quern
