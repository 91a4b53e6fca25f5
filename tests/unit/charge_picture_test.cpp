// The picture of the charge: well-formed, whole, and showing what it was given where it belongs.
#include "io/charge_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

namespace quern {
namespace {

constexpr double kDegree = kPi / 180;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// A quarter of the mill filled at `fraction`: angles 270 to 360 degrees.
ChargePicture quarter(int angles, int rings, double fraction) {
  ChargePicture picture;
  picture.title = "Quarter";
  picture.grid = {angles, rings, 0.15};
  picture.shape.found = picture.shape.toe_found = true;
  picture.shape.bed_fraction = fraction;
  picture.shape.fraction.assign(picture.grid.cells(), 0);
  picture.shape.bulk.assign(picture.grid.cells(), 0);
  for (int ring = 0; ring < rings; ++ring) {
    for (int a = angles * 3 / 4; a < angles; ++a) {
      picture.shape.fraction[picture.grid.cell(ring, a)] = fraction;
      picture.shape.bulk[picture.grid.cell(ring, a)] = 1;
    }
  }
  picture.profile = {{0.15, 0}, {0, 0.15}, {-0.15, 0}, {0, -0.15}};
  return picture;
}

TEST(ChargePicture, ClosesWhatItOpensAndNamesNothingOutside) {
  ChargePicture picture = quarter(36, 10, 0.6);
  picture.rays = {{"shoulder", 0, 0.01, 0.1}};
  const std::string svg = charge_svg(picture);
  EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  for (const char* tag : {"text", "g", "title"}) {
    const std::string name(tag);
    EXPECT_EQ(count(svg, "<" + name + " ") + count(svg, "<" + name + ">"),
              count(svg, "</" + name + ">"))
        << tag;
  }
  EXPECT_EQ(count(svg, "http"), 1u);  // the name of the format
  EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0u);
}

TEST(ChargePicture, EscapesTitles) {
  ChargePicture picture = quarter(36, 10, 0.6);
  picture.title = "a < b & c";
  const std::string svg = charge_svg(picture);
  EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
  EXPECT_EQ(svg.find("a < b"), std::string::npos);
}

TEST(ChargePicture, LabelsRaysWithTheirErrorsWhereKnown) {
  ChargePicture picture = quarter(36, 10, 0.6);
  picture.rays = {{"shoulder", 45.25 * kDegree, 0.5 * kDegree, 0},
                  {"toe", 230 * kDegree, std::numeric_limits<double>::quiet_NaN(), 0}};
  const std::string svg = charge_svg(picture);
  EXPECT_NE(svg.find(">shoulder 45.2° ± 0.5°<"), std::string::npos);
  EXPECT_NE(svg.find(">toe 230.0°<"), std::string::npos);
}

// Upwards in the mill is towards smaller y in the file.
TEST(ChargePicture, PutsAnglesCounterclockwiseFromPlusX) {
  ChargePicture picture = quarter(36, 10, 0.6);
  picture.rays = {{"up", 90 * kDegree, 0, 0.15}, {"right", 0, 0, 0.15}};
  const std::string svg = charge_svg(picture);
  const std::regex circle("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"");
  std::vector<std::pair<double, double>> at;
  for (std::sregex_iterator m(svg.begin(), svg.end(), circle), end; m != end; ++m) {
    at.emplace_back(std::stod((*m)[1]), std::stod((*m)[2]));
  }
  ASSERT_EQ(at.size(), 2u);
  if (at[0].first > at[1].first) std::swap(at[0], at[1]);
  EXPECT_LT(at[0].second, at[1].second);
  // Both on the shell: a right angle with equal legs, written to a tenth of a pixel.
  EXPECT_NEAR(at[1].first - at[0].first, at[1].second - at[0].second, 0.2);
}

// 70,000 cells, no two neighbours alike: an industrial mill at its worst.
TEST(ChargePicture, OfALargeMapStaysBelowFourMegabytes) {
  ChargePicture picture = quarter(360, 195, 0.6);
  for (std::size_t k = 0; k < picture.grid.cells(); ++k) {
    picture.shape.fraction[k] = 0.6 * static_cast<double>(k * 7919 % 1000) / 1000;
  }
  EXPECT_LT(charge_svg(picture).size(), 4u << 20);
}

// Without particles, as of a mill that is empty.
TEST(ChargePicture, CanBeDrawnOfNothing) {
  ChargePicture picture = quarter(36, 10, 0.0);
  picture.shape.bulk.assign(picture.grid.cells(), 0);
  picture.profile.clear();
  EXPECT_NE(charge_svg(picture).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace quern
