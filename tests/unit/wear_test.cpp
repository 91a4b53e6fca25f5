// Cells of facets, the terms of the wear models, and what is made of the sums.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "io/scene_reader.h"
#include "kernels/wear_profile.h"
#include "scheduler/wear_setup.h"
#include "tests/support/build_world.h"
#include "tests/support/mill_of_spheres.h"
#include "tests/support/small_scene.h"
#include "tests/support/trap_fp.h"

namespace quern::test {
namespace {

Facets one_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return build_facets({{{Triangle{{a, b, c}}}, 0}}, 1);
}

std::vector<WearCell> cells_of(const Facets& facets, const WearGrid& grid) {
  std::vector<WearCell> cells;
  grid.append_cells(facets, 0, cells);
  return cells;
}

TEST(WearCells, FillTheirFacetAndAreNoLongerThanAsked) {
  const Vec3 corners[][3] = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                             {{0, 0, 0}, {9, 0.1, 1}, {9, 0.3, 1.2}},
                             {{1, 2, 3}, {1, 2.7, 3}, {-4, 2, 6}}};
  for (const auto& c : corners) {
    for (const double size : {0.11, 0.5, 20.0}) {
      const Facets facets = one_triangle(c[0], c[1], c[2]);
      const WearGrid grid(facets, size, 5);
      const std::vector<WearCell> cells = cells_of(facets, grid);
      EXPECT_EQ(grid.first_cell(), 5u);
      ASSERT_EQ(grid.end_cell() - grid.first_cell(), cells.size());
      double area = 0, longest = 0;
      for (const WearCell& cell : cells) {
        area += cell.area();
        const Vec3 n = (cell.corner[1] - cell.corner[0]).cross(cell.corner[2] - cell.corner[0]);
        EXPECT_GT(n.dot(facets.normal[0]), 0);
        for (std::size_t k = 0; k < 3; ++k) {
          longest = std::max(longest, (cell.corner[k] - cell.corner[(k + 1) % 3]).norm());
        }
      }
      const double whole = 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm();
      EXPECT_NEAR(area / whole, 1, 1e-12);
      EXPECT_LT(longest, 2 * size);  // the diagonal of a cell as wide and as high as asked
    }
  }
}

TEST(WearCells, APointIsFoundInTheCellThatHoldsIt) {
  const Facets facets = one_triangle({1, 2, 3}, {2, 2.7, 3}, {-4, 2, 6});
  const WearGrid grid(facets, 0.2, 7);
  const std::vector<WearCell> cells = cells_of(facets, grid);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    for (int n = 0; n < 20; ++n) {
      double u = unit(random), v = unit(random);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const double in = 1 - 1e-9;  // away from the sides
      const Vec3& a = cells[k].corner[0];
      const Vec3 middle = (a + cells[k].corner[1] + cells[k].corner[2]) / 3;
      const Vec3 x = a + u * (cells[k].corner[1] - a) + v * (cells[k].corner[2] - a);
      const Vec3 off = 0.01 * facets.normal[0];
      EXPECT_EQ(grid.cell_at(0, Vec3(middle + in * (x - middle) + off)), 7 + k);
    }
  }
  for (const Vec3& far : {Vec3(9, 9, 9), Vec3(-9, 0, 0), Vec3(1, 2, 3)}) {
    const Index cell = grid.cell_at(0, far);
    EXPECT_TRUE(cell >= grid.first_cell() && cell < grid.end_cell());
  }
}

TEST(WearCells, APointStaysInItsCellAsFarAsItHasRoomAndNoFarther) {
  const Facets facets = one_triangle({1, 2, 3}, {2, 2.7, 3}, {-4, 2, 6});
  const WearGrid grid(facets, 0.2, 7);
  const Vec3 a = facets.vertex[0], b = facets.vertex[1] - a, c = facets.vertex[2] - a;
  const Vec3 normal = facets.normal[0], first = b.normalized(), second = normal.cross(first);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0.1, 0.45);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 x = a + unit(random) * b + unit(random) * c;
    double room = -1;
    const Index cell = grid.cell_at(0, x, room);
    EXPECT_EQ(cell, grid.cell_at(0, x));
    ASSERT_GE(room, 0);
    EXPECT_LT(room, 0.1);
    bool leaves = false;
    for (int k = 0; k < 720; ++k) {
      const double angle = k * kPi / 360;
      const Vec3 way = std::cos(angle) * first + std::sin(angle) * second;
      EXPECT_EQ(grid.cell_at(0, Vec3(x + room * way + 0.3 * normal)), cell);
      leaves |= grid.cell_at(0, Vec3(x + 1.01 * room * way)) != cell;
    }
    EXPECT_TRUE(leaves) << n;
  }
  double room = -1;
  grid.cell_at(0, Vec3(a - b), room);
  EXPECT_EQ(room, 0) << "beside the facet";
}

TEST(WearCells, CutAMillsLongFacetsIntoPiecesAsWideAsHigh) {
  Scene scene = scene_of(kMillOfSpheres);
  scene.wear = WearSpec();
  scene.wear->cell_size = 0.002;
  World<float> world;
  world.walls.resize(1);
  world.bodies.push_back(
      {Motion(), build_facets({{mill_shell(*scene.mill, 0, 0.06), 0}}, 0.02), Pose(), {}});
  set_wear(world, scene);
  double area = 0;
  for (const Triangle& t : mill_shell(*scene.mill, 0, 0.06)) {
    area += 0.5 * (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).norm();
  }
  const double squares = area / (0.002 * 0.002);
  EXPECT_NEAR(static_cast<double>(world.wear.cell_count()) / (2 * squares), 1.2, 0.2);
}

// 10 N of friction at 0.5 m/s; a normal force of 100 N.
WearContact sliding() {
  WearContact c;
  c.normal = Vec3::UnitZ();
  c.force = {-10, 0, 100};
  c.velocity = c.at_point = c.braked = {0.5, 0, 0};
  c.slide = 5e-5;
  c.friction = 0.1;
  c.mass = 2;
  c.touching = true;
  c.first_touch = false;
  return c;
}

Material steel() { return {"steel", 7800, 370}; }

TEST(WearModels, SiemTakes00230CubicMillimetresOfHv370In01Seconds) {
  const WearRow sum = wear_of(sliding(), 1e-5, 2);
  EXPECT_NEAR(sum[kSiemEnergy], 5e-5, 1e-18);
  const WearRow factors = wear_factors(WearSpec(), steel());
  const double energy = 1e4 * sum[kSiemEnergy], p = 1.5 * 370 * 9.80665e6;
  EXPECT_NEAR(energy * factors[kSiemEnergy] / (0.5 / (4 * p)), 1, 1e-12);
  EXPECT_NEAR(energy * factors[kSiemEnergy] * 1e9, 0.0230, 5e-5);
  EXPECT_NEAR(factors[kSiemEnergy] * 1e9, 0.0459, 5e-5);  // mm^3 a joule
  EXPECT_EQ(sum[kNormalImpulse], 100 * 1e-5);
  EXPECT_EQ(sum[kShearImpulse], 10 * 1e-5);
  EXPECT_NEAR(sum[kArchardWork], 100 * 0.5 * 1e-5, 1e-16);
}

TEST(WearModels, SiemTakesNothingWhereTheSpringGivesBackOrTheSpinDrives) {
  WearContact c = sliding();
  c.at_point = {-0.5, 0, 0};  // friction works on the particle
  EXPECT_EQ(wear_of(c, 1e-5, 2)[kSiemEnergy], 0);
  c = sliding();
  c.braked = {-0.5, 0, 0};  // friction speeds the centre up
  EXPECT_EQ(wear_of(c, 1e-5, 2)[kSiemEnergy], 0);
  c = sliding();
  c.at_point += Vec3(0, 0, -3);  // what is along the normal is no part of it
  EXPECT_NEAR(wear_of(c, 1e-5, 2)[kSiemEnergy], 5e-5, 1e-18);
  c.touching = false;
  EXPECT_EQ(wear_of(c, 1e-5, 2)[kSiemEnergy], 0);
  EXPECT_EQ(wear_of(c, 1e-5, 2)[kSlidingEnergy], 5e-5);  // what was left in the spring
}

TEST(WearModels, ArchardCountsSlidingOnly) {
  WearContact c = sliding();
  c.friction = 0.2;  // 20 N could be carried: it sticks
  EXPECT_EQ(wear_of(c, 1e-5, 2)[kArchardWork], 0);
  WearSpec spec;
  spec.archard_coefficient = 1e-3;
  spec.archard_factor = 3;
  const double k = 3e-3 / (370 * 9.80665e6);
  EXPECT_NEAR(wear_factors(spec, steel())[kArchardWork] / k, 1, 1e-12);
  EXPECT_TRUE(std::isnan(wear_factors(WearSpec(), steel())[kArchardWork]));
}

TEST(WearModels, FinnieHasHisTwoBranchesAndNoJumpBetween) {
  const double ratio = 2, mass = 2, speed = 3;
  const auto energy = [&](double angle) {
    WearContact c = sliding();
    c.first_touch = true;
    c.velocity = speed * Vec3(std::cos(angle), 0, -std::sin(angle));
    return wear_of(c, 1e-5, ratio)[kFinnieEnergy];
  };
  const double scale = mass * speed * speed, bend = std::atan(ratio / 6);
  for (const double a : {0.05, 0.2, 0.3}) {
    const double s = std::sin(a);
    EXPECT_NEAR(energy(a) / scale, std::sin(2 * a) - 6 / ratio * s * s, 1e-14) << a;
  }
  for (const double a : {0.4, 0.8, 1.5}) {
    EXPECT_NEAR(energy(a) / scale, ratio * std::cos(a) * std::cos(a) / 6, 1e-14) << a;
  }
  EXPECT_NEAR(energy(bend - 1e-9), energy(bend + 1e-9), 1e-8 * scale);
  EXPECT_EQ(energy(-0.3), 0);  // on the way out
  const double p = flow_pressure_of(WearSpec(), steel());
  EXPECT_NEAR(wear_factors(WearSpec(), steel())[kFinnieEnergy] * 4 * p, 1, 1e-12);
}

// A mill whose cells all have worn by the same depth, and those of one lifter twice.
TEST(WearProfileOfAPitch, IsFlatWhereWearIsAndTellsTheLiftersSpread) {
  for (const int pieces : {1, 4}) {
    Scene scene = scene_of(kMillOfSpheres, {"mill.pieces_per_arc=" + std::to_string(pieces)});
    scene.wear = WearSpec();
    scene.wear->flow_pressure = 1e9;
    World<float> world = world_of<float>(scene);
    const int lifters = scene.mill->lifters->count;
    const double depth = 1e-6, time = 10;
    WallWear liner = wall_wear(world, scene, 0);
    // All that lies beyond the mill's length counts: here, as much as the mill's length is of it.
    const double whole = scene.mill->length + 2 * 2.5 * 0.003;
    for (std::size_t k = 0; k < liner.cells.size(); ++k) {
      const Vec3 middle =
          (liner.cells[k].corner[0] + liner.cells[k].corner[1] + liner.cells[k].corner[2]) / 3;
      const bool first = std::abs(std::atan2(middle.y(), middle.x())) < kPi / lifters;
      liner.made[k] = WearRow{};
      liner.made[k][kSiemEnergy] =
          (first ? 2 : 1) * depth * liner.area[k] * scene.mill->length / whole;
    }
    liner.time = time;
    const WearProfile profile = wear_profile(*scene.mill, liner, 0.002);
    const double one = depth / time * kMmPer1000Hours, n = lifters;
    double length = 0;
    for (std::size_t b = 0; b < profile.arc.size(); ++b) {
      EXPECT_NEAR(profile.mean[b][kSiemEnergy] / (one * (n + 1) / n), 1, 1e-6) << b;
      // Of one piece the middle runs through a cell that is worn as a whole.
      if (pieces % 2 == 0) {
        EXPECT_NEAR(profile.spread[b][kSiemEnergy] / (one / std::sqrt(n)), 1, 1e-5) << b;
      }
      EXPECT_NEAR(profile.arc[b], length + 0.5 * profile.width[b], 1e-12);
      length += profile.width[b];
    }
    // From the middle of the shell before lifter 0 to that behind it.
    const double half = kPi / lifters, radius = 0.5 * scene.mill->diameter;
    const auto angle = [&](std::size_t b) { return std::atan2(profile.y[b], profile.x[b]); };
    EXPECT_NEAR(angle(0), -half, profile.width[0] / radius);
    EXPECT_NEAR(angle(profile.arc.size() - 1), half, profile.width[0] / radius);
    double least = 1;
    for (std::size_t b = 0; b < profile.x.size(); ++b) least = std::min(least, profile.x[b]);
    EXPECT_NEAR(least, radius - scene.mill->lifters->height, 1e-12);
  }
}

TEST(WearScene, NeedsAHardnessOrAFlowPressureOfItsWalls) {
  const std::string text = std::string(kMillOfSpheres) + "[wear]\ncell_size = \"2 mm\"\n";
  const SceneResult bad = parse_scene(text, "mill.toml", ".");
  ASSERT_EQ(bad.errors.size(), 1u);
  EXPECT_NE(bad.errors[0].find("mill.toml:31:"), std::string::npos) << bad.errors[0];
  EXPECT_NE(bad.errors[0].find("materials.ore.hardness"), std::string::npos) << bad.errors[0];
  EXPECT_TRUE(parse_scene(text + "flow_pressure = \"5 GPa\"\n", "mill.toml", ".").errors.empty());
  EXPECT_TRUE(parse_scene(text, "mill.toml", ".", {"materials.ore.hardness=160"}).errors.empty());
}

TEST(WearScene, WithoutATableThereAreNoCellsAndNoState) {
  const World<float> world = world_of<float>(scene_of(kMillOfSpheres));
  EXPECT_FALSE(world.wear.asked());
  EXPECT_EQ(world.wear.cells.capacity_bytes(), 0u);
}

}  // namespace
}  // namespace quern::test
