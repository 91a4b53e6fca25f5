// Units, numbers, and particles from CSV files.
#include "io/quantity.h"

#include <gtest/gtest.h>

#include "io/particle_csv.h"
#include "tests/unit/scene_text.h"

namespace quern {
namespace {

ParticleCsv read_of_ore(const std::string& path, const Lines& sharing = {"ore"}) {
  return read_particle_csv(path, "ore", sharing);
}

// --- quantities

TEST(Quantity, ConvertsEveryKindOfUnit) {
  using enum Dimension;
  const struct {
    const char* text;
    Dimension dimension;
    double value;
  } rows[] = {
      {"152 mm", kLength, 0.152},
      {"152mm", kLength, 0.152},
      {" 1.5 m ", kLength, 1.5},
      {"3 cm", kLength, 0.03},
      {"7 um", kLength, 7e-6},
      {"2 km", kLength, 2000},
      {"1e-5 s", kTime, 1e-5},
      {"3 ms", kTime, 3e-3},
      {"3 us", kTime, 3e-6},
      {"2 min", kTime, 120},
      {"2 h", kTime, 7200},
      {"3 kg", kMass, 3},
      {"3 g", kMass, 3e-3},
      {"3 t", kMass, 3000},
      {"-1 m/s", kSpeed, -1},
      {"5 mm/s", kSpeed, 5e-3},
      {"30 rpm", kAngularVelocity, kPi},
      {"2 rad/s", kAngularVelocity, 2},
      {"180 deg/s", kAngularVelocity, kPi},
      {"1 Hz", kAngularVelocity, 2 * kPi},
      {"50 Hz", kFrequency, 50},
      {"60 rpm", kFrequency, 1},
      {"90 deg", kAngle, kPi / 2},
      {"2e7 N/m", kStiffness, 2e7},
      {"20 MN/m", kStiffness, 2e7},
      {"20 kN/m", kStiffness, 2e4},
      {"4.5 t/m^3", kDensity, 4500},
      {"4.5 g/cm^3", kDensity, 4500},
      {"-9.81 m/s^2", kAcceleration, -9.81},
      {"370 HV", kHardness, 370},
      {"2 mJ", kEnergy, 2e-3},
      {"3 GPa", kPressure, 3e9},
      {"30 %", kShare, 0.3},
      {"0.3", kShare, 0.3},
      {"+3 m", kLength, 3},
  };
  for (const auto& row : rows) {
    const QuantityResult result = parse_quantity(row.text, row.dimension);
    EXPECT_EQ(result.error, "") << row.text;
    EXPECT_DOUBLE_EQ(result.value, row.value) << row.text;
  }
}

TEST(Quantity, RefusesWhatIsNoQuantity) {
  for (const char* text : {"", " ", "m", "1", "1 kg", "1,5 m", "nan m", "inf m", "1e999 m", "0x1 m",
                           "1 m m", "--1 m", "1 M", "1 metre"})
    EXPECT_NE(parse_quantity(text, Dimension::kLength).error, "") << text;
}

TEST(Quantity, WritesTextThatReadsBackToTheSameNumber) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, -2.5e17, 0.0, 6.02214076e23})
    EXPECT_EQ(parse_quantity(format_quantity(value, Dimension::kMass), Dimension::kMass).value,
              value);
}

// --- particles from CSV

TEST(ParticleCsv, ReadsColumnsInAnyOrder) {
  const TestFolder folder;
  const ParticleCsv csv = read_of_ore(
      folder.write("p.csv", "# made by hand\r\ndiameter, z, y, x, wz\r\n0.01, 3, 2, 1, 5\r\n\r\n"));
  ASSERT_EQ(csv.errors, Lines{});
  ASSERT_EQ(csv.particles.size(), 1u);
  EXPECT_EQ(csv.particles[0].position, Vec3(1, 2, 3));
  EXPECT_EQ(csv.particles[0].spin, Vec3(0, 0, 5));
  EXPECT_EQ(csv.particles[0].diameter, 0.01);
}

TEST(ParticleCsv, ReportsEveryBadLine) {
  const TestFolder folder;
  const std::string path = folder.write(
      "p.csv", "x,y,z,diameter\n0,0,0,0.01\n0,0,0\n0,0,a,0.01\n0,0,0,-1\n0,0,nan,1\n0,0,1.5.2,1\n");
  const Lines expected = {
      path + ":3: error: 3 values, the header has 4 columns",
      path + ":4: error: z: 'a' is no number", path + ":5: error: diameter: must be greater than 0",
      path + ":6: error: z: 'nan' is no number", path + ":7: error: z: '1.5.2' is no number"};
  EXPECT_EQ(read_of_ore(path).errors, expected);
}

TEST(ParticleCsv, ReportsABadHeader) {
  const TestFolder folder;
  const std::string path = folder.write("p.csv", "x,y,z,diametr,x\n1,2,3,4,5\n");
  const Lines expected = {
      path +
          ":1: error: 'diametr' is no column - did you mean 'diameter'? (x, y, z, diameter, vx, "
          "vy, vz, wx, wy, wz, class)",
      path + ":1: error: column 'x' is there twice",
      path + ":1: error: the header needs a column 'diameter'"};
  EXPECT_EQ(read_of_ore(path).errors, expected);
}

TEST(ParticleCsv, ErrorsReachTheSceneThatNamesTheFile) {
  const TestFolder folder;
  folder.write("p.csv", "x,y,z,diameter\n1,2,3\n");
  const SceneResult result =
      parse_scene(changed(kGoodScene, "diameter = \"13.75 mm\"\ncount = 300", "csv = \"p.csv\""),
                  "mill.toml", folder.path.string());
  EXPECT_EQ(result.errors, Lines{(folder.path / "p.csv").string() +
                                 ":2: error: 3 values, the header has 4 columns"});
}

const char* const kMixture =
    "x,y,z,class,diameter\n0,0,1,ore,0.01\n0,0,2,ball,0.02\n0,0,3,ore,0.03\n";

TEST(ParticleCsv, GivesEachSpeciesTheRowsOfItsClass) {
  const TestFolder folder;
  const std::string path = folder.write("p.csv", kMixture);
  const ParticleCsv ore = read_of_ore(path, {"ball", "ore"});
  ASSERT_EQ(ore.errors, Lines{});
  ASSERT_EQ(ore.particles.size(), 2u);
  EXPECT_EQ(ore.particles[0].diameter, 0.01);
  EXPECT_EQ(ore.particles[1].position, Vec3(0, 0, 3));
}

TEST(ParticleCsv, RefusesAClassThatNoSpeciesTakes) {
  const TestFolder folder;
  const std::string path =
      folder.write("p.csv", "class,x,y,z,diameter\nbal,0,0,1,0.01\n,0,0,2,0.02\n");
  const Lines expected = {
      path +
          ":2: error: class: no particles 'bal' take this file - did you mean 'ball'? (ball, ore)",
      path + ":3: error: class: no particles '' take this file (ball, ore)"};
  EXPECT_EQ(read_of_ore(path, {"ball", "ore"}).errors, expected);
}

TEST(ParticleCsv, NeedsClassesWhereSeveralSpeciesShareIt) {
  const TestFolder folder;
  const std::string path = folder.write("p.csv", "x,y,z,diameter\n0,0,1,0.01\n");
  EXPECT_EQ(
      read_of_ore(path, {"ball", "ore"}).errors,
      Lines{path + ":1: error: the header needs a column 'class': several particles take this "
                   "file (ball, ore)"});
}

// The good scene with its ore and balls from one file.
std::string scene_of_mixture() {
  return changed(changed(kGoodScene, "diameter = \"13.75 mm\"\ncount = 300", "csv = \"p.csv\""),
                 "diameter = \"18 mm\"\ncount = 80", "csv = \"./p.csv\"");
}

TEST(ParticleCsv, IsSharedByTheSpeciesOfAScene) {
  const TestFolder folder;
  folder.write("p.csv", kMixture);
  const SceneResult result = parse_scene(scene_of_mixture(), "mill.toml", folder.path.string());
  ASSERT_EQ(result.errors, Lines{});
  ASSERT_EQ(result.scene.particles[0].name, "ore");
  EXPECT_EQ(result.scene.particles.front().explicit_particles.size(), 2u);
  ASSERT_EQ(result.scene.particles.back().explicit_particles.size(), 1u);
  EXPECT_EQ(result.scene.particles.back().explicit_particles[0].diameter, 0.02);
}

TEST(ParticleCsv, SaysOnceWhatIsWrongInASharedFile) {
  const TestFolder folder;
  const std::string path = folder.write("p.csv", changed(kMixture, "ball", "steel"));
  const SceneResult wrong = parse_scene(scene_of_mixture(), "mill.toml", folder.path.string());
  EXPECT_EQ(wrong.errors,
            Lines{path + ":3: error: class: no particles 'steel' take this file (ore, ball)"});
  folder.write("p.csv", "x,y,z,diameter,class\n0,0,1,0.01,ore\n");
  const SceneResult none = parse_scene(scene_of_mixture(), "mill.toml", folder.path.string());
  ASSERT_EQ(none.errors.size(), 1u);
  EXPECT_TRUE(
      none.errors[0].ends_with(": error: 'csv': './p.csv' has no particles of class 'ball'"))
      << none.errors[0];
}

}  // namespace
}  // namespace quern
