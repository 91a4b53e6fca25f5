// The map of the charge against exact volumes, and the angles found on charges whose shoulder and
// toe are known: random spheres below a sloping chord, still or with others in the air above.
#include "kernels/charge_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace quern {
namespace {

constexpr double kDegree = kPi / 180;

// A charge below the chord that rises by `slope` at the distance `depth` under the axis.
struct Segment {
  double shell = 0.15, size = 0.01;  // m: radius of the shell, diameter of all spheres
  double slope = 30 * kDegree, depth = 0;
  double length = 0.04;
  int snapshots = 60;
  double airborne = 0;  // number density above the chord over that below
  bool clockwise = false;
  std::uint64_t seed = 1;
};

struct Snapshot {
  std::vector<double> position;
  std::vector<float> radius;
};

// Places are independent and uniform, so the solid fraction is 0.6 within a diameter of the edges.
Snapshot random_snapshot(const Segment& s, std::mt19937_64& random) {
  constexpr double kFraction = 0.6;
  std::uniform_real_distribution<double> anywhere(-1, 1), share(0, 1);
  const double reach = s.shell - 0.5 * s.size;
  const double tries = kFraction * 4 * reach * reach * s.length / (kPi / 6 * std::pow(s.size, 3));
  Snapshot out;
  for (int k = 0; k < static_cast<int>(tries); ++k) {
    const double x = reach * anywhere(random), y = reach * anywhere(random);
    if (std::hypot(x, y) > reach) continue;
    const double over = y * std::cos(s.slope) - x * std::sin(s.slope) + s.depth;
    if (over > 0 && share(random) >= s.airborne) continue;
    out.position.insert(out.position.end(), {s.clockwise ? -x : x, y, 0.5 * s.length});
    out.radius.push_back(static_cast<float>(0.5 * s.size));
  }
  return out;
}

ChargeMap map_of(const Segment& s, const PolarGrid& grid) {
  ChargeMap map = make_charge_map(grid, s.length);
  std::mt19937_64 random(s.seed);
  for (int k = 0; k < s.snapshots; ++k) {
    const Snapshot snapshot = random_snapshot(s, random);
    deposit(snapshot.position, snapshot.radius, map);
  }
  return map;
}

ChargeQuery query_of(const Segment& s) {
  ChargeQuery query;
  query.direction = s.clockwise ? -1 : 1;
  query.particle_size = s.size;
  return query;
}

ChargeShape shape_of(const Segment& s) {
  return find_charge_shape(map_of(s, choose_polar_grid(s.shell, s.size)), query_of(s));
}

// Where the chord meets the circles of the outermost centres and of the middle of the toe's ring.
double true_shoulder(const Segment& s) {
  return s.slope - std::asin(s.depth / (s.shell - 0.5 * s.size));
}
double true_toe(const Segment& s) {
  return kPi + s.slope + std::asin(s.depth / (s.shell - s.size));
}

// A crossing between two cells is known to half a cell. Toward the shell the spheres' own size
// thins the ring: the toe moves by up to a radius. The tip of the bulk is rounded over a diameter,
// and its highest point may be anywhere on it. Noise (some ten spheres a cell and 60 snapshots) is
// a few hundredths of a cell.
double toe_tolerance(const Segment& s) {
  return 0.5 * s.size / s.shell + 0.5 * choose_polar_grid(s.shell, s.size).angle_step();
}
double shoulder_tolerance(const Segment& s) {
  return s.size / s.shell + 0.5 * choose_polar_grid(s.shell, s.size).angle_step();
}

void expect_angles(const Segment& s) {
  const ChargeShape shape = shape_of(s);
  ASSERT_TRUE(shape.found);
  ASSERT_TRUE(shape.toe_found);
  const double shoulder = s.clockwise ? kPi - shape.shoulder : shape.shoulder;
  const double toe = s.clockwise ? kPi - shape.bulk_toe : shape.bulk_toe;
  EXPECT_NEAR(principal_angle(shoulder) / kDegree, true_shoulder(s) / kDegree,
              shoulder_tolerance(s) / kDegree);
  EXPECT_NEAR(principal_angle(toe) / kDegree, true_toe(s) / kDegree, toe_tolerance(s) / kDegree);
}

double total(const ChargeMap& map) {
  return std::accumulate(map.volume.begin(), map.volume.end(), 0.0);
}

TEST(PolarGridChoice, IsOneDegreeInAnIndustrialAndFourInALaboratoryMill) {
  const PolarGrid large = choose_polar_grid(4.875, 0.05), small = choose_polar_grid(0.15, 0.018);
  EXPECT_EQ(large.angles, 360);
  EXPECT_NEAR(large.ring_width(), 0.025, 0.025 / 195);  // 195 whole cells fill the radius
  EXPECT_EQ(small.angles, 90);
  EXPECT_EQ(small.rings, 17);
  const PolarGrid given = choose_polar_grid(0.15, 0.018, 3 * kDegree, 0.005);
  EXPECT_EQ(given.angles, 120);
  EXPECT_EQ(given.rings, 30);
}

TEST(MedianDiameter, HalvesTheVolume) {
  // Volumes of 8 x 1 and 1 x 27: the large one holds more than half.
  const std::vector<float> radius = {1, 1, 3, 1, 1, 1, 1, 1, 1};
  EXPECT_EQ(median_diameter(radius), 6);
  const std::vector<float> many(28, 1.0F);
  EXPECT_EQ(median_diameter(many), 2);
  EXPECT_EQ(median_diameter({}), 0);
}

// Each volume is split into some hundred parts, each rounded once.
TEST(ChargeMap, KeepsTheVolumeWhereverASphereIs) {
  const PolarGrid grid = choose_polar_grid(0.15, 0.01);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-0.1, 0.1), size(0.0005, 0.04);
  ChargeMap map = make_charge_map(grid, 0.04);
  double expected = 0;
  for (int k = 0; k < 500; ++k) {
    const std::vector<double> x = k == 0 ? std::vector<double>{0, 0, 0}
                                         : std::vector<double>{place(random), place(random), 0};
    const std::vector<float> r = {static_cast<float>(size(random))};
    deposit(x, r, map);
    expected += 4.0 / 3.0 * kPi * std::pow(static_cast<double>(r[0]), 3);
  }
  EXPECT_NEAR(total(map), expected, 1e-12 * expected);
  EXPECT_EQ(map.snapshots, 500);
}

// Cells much smaller than the sphere: what they hold is the chord through the sphere, to what a
// patches resolve: they are a fifth of a cell wide, and a cell sees a slope of the chord across it.
TEST(ChargeMap, ShowsAnyCellTheChordOfASphere) {
  const double radius = 0.03, length = 0.1;
  const PolarGrid grid = choose_polar_grid(0.15, 0.01, kDegree, 0.003);
  ChargeMap map = make_charge_map(grid, length);
  const std::vector<double> x = {0.08, 0.03, 0};
  deposit(x, std::vector<float>{static_cast<float>(radius)}, map);
  const std::vector<double> fraction = solid_fraction(map);
  for (int ring = 0; ring < grid.rings; ++ring) {
    for (int a = 0; a < grid.angles; ++a) {
      const double r = grid.middle_radius(ring), angle = grid.middle_angle(a);
      const double off = std::hypot(r * std::cos(angle) - x[0], r * std::sin(angle) - x[1]);
      if (off > 0.8 * radius && off < 1.1 * radius) continue;  // the chord is steep at the rim
      const double chord = off < radius ? 2 * std::sqrt(radius * radius - off * off) : 0;
      EXPECT_NEAR(fraction[grid.cell(ring, a)], chord / length, 0.1 * 2 * radius / length)
          << r << " " << angle;
    }
  }
}

// The smaller a move, the smaller the change: no cell wins or loses a lump.
TEST(ChargeMap, ChangesSmoothlyWithThePlaces) {
  const PolarGrid grid = choose_polar_grid(0.15, 0.01);
  const float radius = 0.005F;
  const double volume = 4.0 / 3.0 * kPi * std::pow(static_cast<double>(radius), 3);
  const auto moved = [&](double by) {
    ChargeMap map = make_charge_map(grid, 0.04);
    deposit(std::vector<double>{0.1 + by, 0.02, 0}, std::vector<float>{radius}, map);
    return map;
  };
  const ChargeMap before = moved(0);
  for (const double by : {1e-5, 1e-6, 1e-7}) {
    const ChargeMap after = moved(by);
    double change = 0;
    for (std::size_t k = 0; k < after.volume.size(); ++k) {
      change += std::abs(after.volume[k] - before.volume[k]);
    }
    // A patch is 0.22 diameters wide: a move carries by / width of it over each of its two edges
    // along the move, at most.
    EXPECT_LE(change, 2 * volume * by / (0.22 * 2 * static_cast<double>(radius))) << by;
    EXPECT_GT(change, 0) << by;
  }
}

TEST(ChargeShape, FindsShoulderAndToeOfASegment) {
  for (const double slope : {10.0, 30.0, 50.0}) {
    for (const double depth : {0.0, 0.03, 0.06}) {
      Segment s;
      s.slope = slope * kDegree;
      s.depth = depth;
      SCOPED_TRACE(testing::Message() << "slope " << slope << " depth " << depth);
      expect_angles(s);
    }
  }
}

// Size 0.8 % of the radius, as in an industrial mill: a diameter is 0.46, half a cell 0.5 degrees.
TEST(ChargeShape, IsRightToADegreeForSmallParticles) {
  Segment s;
  s.shell = 1;
  s.size = 0.008;
  s.length = 0.02;
  s.snapshots = 12;
  s.depth = 0.3;
  EXPECT_LT(shoulder_tolerance(s) / kDegree, 1);
  expect_angles(s);
}

TEST(ChargeShape, IgnoresParticlesInTheAir) {
  Segment s;
  s.depth = 0.04;
  s.airborne = 0.15;
  expect_angles(s);
}

TEST(ChargeShape, OfAClockwiseMillIsTheMirrorImage) {
  Segment s;
  s.depth = 0.04;
  s.airborne = 0.1;
  const ChargeShape plain = shape_of(s);
  s.clockwise = true;
  expect_angles(s);
  const ChargeShape mirrored = shape_of(s);
  // The patches of a sphere lie on a spiral that is not mirrored: a small part of a cell.
  const double part = 0.05 * choose_polar_grid(s.shell, s.size).angle_step();
  EXPECT_NEAR(principal_angle(kPi - mirrored.shoulder), plain.shoulder, part);
  EXPECT_NEAR(principal_angle(kPi - mirrored.bulk_toe), plain.bulk_toe, part);
}

TEST(ChargeShape, StaysWhenTheCellsAreRefined) {
  Segment s;
  s.depth = 0.04;
  const PolarGrid coarse = choose_polar_grid(s.shell, s.size);
  const ChargeShape reference = find_charge_shape(map_of(s, coarse), query_of(s));
  for (const int finer : {2, 3}) {
    const PolarGrid grid =
        choose_polar_grid(s.shell, s.size, coarse.angle_step() / finer, 0.5 * s.size / finer);
    const ChargeShape shape = find_charge_shape(map_of(s, grid), query_of(s));
    EXPECT_NEAR(shape.shoulder, reference.shoulder, 0.5 * coarse.angle_step()) << finer;
    EXPECT_NEAR(shape.bulk_toe, reference.bulk_toe, 0.5 * coarse.angle_step()) << finer;
  }
}

// A second heap, apart from the first and smaller, belongs to nothing.
TEST(ChargeShape, TakesTheLargestConnectedSet) {
  Segment s;
  s.depth = 0.05;
  const PolarGrid grid = choose_polar_grid(s.shell, s.size);
  ChargeMap map = map_of(s, grid);
  const ChargeShape alone = find_charge_shape(map, query_of(s));
  for (int ring = grid.rings - 8; ring < grid.rings; ++ring) {
    for (int a = 40; a < 55; ++a) {  // 80 ... 110 degrees, higher than the shoulder
      map.volume[grid.cell(ring, a)] = 0.6 * grid.area(ring) * map.length * map.snapshots;
    }
  }
  const ChargeShape both = find_charge_shape(map, query_of(s));
  EXPECT_NEAR(both.shoulder, alone.shoulder, 0.1 * grid.angle_step());
  EXPECT_NEAR(both.bulk_toe, alone.bulk_toe, 0.1 * grid.angle_step());
}

TEST(ChargeShape, OfNothingIsNotFound) {
  const ChargeMap empty = make_charge_map(choose_polar_grid(0.15, 0.01), 0.04);
  const ChargeShape shape = find_charge_shape(empty, ChargeQuery());
  EXPECT_FALSE(shape.found);
  EXPECT_FALSE(shape.toe_found);
}

// Centrifuging: a layer all around the shell has no toe.
TEST(ChargeShape, OfALayerAllAroundHasNoToe) {
  const PolarGrid grid = choose_polar_grid(0.15, 0.01);
  ChargeMap map = make_charge_map(grid, 0.04);
  map.snapshots = 1;
  for (int ring = grid.rings - 6; ring < grid.rings; ++ring) {
    for (int a = 0; a < grid.angles; ++a) {
      map.volume[grid.cell(ring, a)] = 0.6 * grid.area(ring) * map.length;
    }
  }
  ChargeQuery query;
  query.particle_size = 0.01;
  const ChargeShape shape = find_charge_shape(map, query);
  EXPECT_TRUE(shape.found);
  EXPECT_FALSE(shape.toe_found);
}

// Bins of one degree: contact time 1 from the toe at 230 degrees to 60 degrees, then falling to 0
// at 80; hits of 1 J a bin between 200 and 220 degrees, and much more inside the bulk.
struct Liner {
  LinerHistogram histogram;
  ChargeShape shape;
  ChargeQuery query;

  explicit Liner(double direction) {
    query.direction = direction;
    shape.found = shape.toe_found = true;
    shape.shoulder = place(50);
    shape.bulk_toe = place(230);
    histogram.contact_time.assign(360, 0);
    histogram.hit_dissipation.assign(360, 0);
    for (int degree = 0; degree < 360; ++degree) {
      const auto bin = static_cast<std::size_t>(direction > 0 ? degree : (539 - degree) % 360);
      const double at = degree + 0.5;
      const bool in_bulk = at < 60 || at > 230;
      if (in_bulk || at < 80) histogram.contact_time[bin] = in_bulk ? 1 : (80 - at) / 20;
      if (at > 200 && at < 220) histogram.contact_time[bin] = 0.05;  // by the hits
      if (at > 200 && at < 220) histogram.hit_dissipation[bin] = 1;
      if (at > 240) histogram.hit_dissipation[bin] = 50;
    }
  }
  double place(double degree) const {
    return principal_angle((query.direction > 0 ? degree : 180 - degree) * kDegree);
  }
};

TEST(LinerAngles, AreReadOffContactTimeAndHits) {
  for (const double direction : {1.0, -1.0}) {
    const Liner liner(direction);
    const LinerAngles found = find_liner_angles(liner.histogram, liner.shape, liner.query);
    ASSERT_TRUE(found.head_found);
    ASSERT_TRUE(found.impacts_found);
    // The ramp passes 0.02 at 79.6, where the last bin's middle, 79.5, holds 0.025 and the next 0:
    // linear between the two.
    EXPECT_NEAR(found.head, liner.place(79.5 + (0.025 - 0.02) / 0.025), 1e-12) << direction;
    // Twenty joules from 220 down to 200: 95 % lie below 201.
    EXPECT_NEAR(found.impact_toe, liner.place(201), 1e-12) << direction;
  }
}

TEST(LinerAngles, WithoutHitsTheImpactToeIsTheBulkToe) {
  Liner liner(1);
  liner.histogram.hit_dissipation.assign(360, 0);
  const LinerAngles found = find_liner_angles(liner.histogram, liner.shape, liner.query);
  EXPECT_FALSE(found.impacts_found);
  EXPECT_EQ(found.impact_toe, liner.shape.bulk_toe);
}

TEST(Angles, TheDynamicAngleGrowsTheWayTheMillTurns) {
  ChargeQuery query;
  EXPECT_NEAR(dynamic_angle(0, -2, query), 0, 1e-15);
  EXPECT_NEAR(dynamic_angle(1, -1, query), 45 * kDegree, 1e-15);  // lifted on the +x side
  query.direction = -1;
  EXPECT_NEAR(dynamic_angle(-1, -1, query), 45 * kDegree, 1e-15);
  query.up = 0;  // gravity along -x
  EXPECT_NEAR(dynamic_angle(-3, 3, query), 45 * kDegree, 1e-15);
}

// Two spheres of one cell, one moving and of a group of its own; a third elsewhere.
TEST(ChargeMap, CarriesAmountsWithTheVolume) {
  const PolarGrid grid = choose_polar_grid(0.15, 0.01);
  ChargeMap map = make_charge_map(grid, 0.04, 2);
  const std::vector<double> x = {0.1, 0.01, 0, 0.1, 0.01, 0, -0.05, 0.02, 0};
  const std::vector<float> r = {0.004F, 0.004F, 0.006F};
  const std::vector<float> amount = {3, 0, 5, 1, -2, 1};
  deposit(x, r, amount, map);
  ChargeMap sum = make_charge_map(grid, 0.04, 2);
  add_snapshots(map, sum);
  add_snapshots(map, sum);
  const std::vector<double> velocity = mean_amount(sum, 0), all = solid_fraction(sum);
  const std::vector<double> group = solid_fraction_carrying(sum, 1);
  double carried = 0;
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    const bool right =
        cell % static_cast<std::size_t>(grid.angles) < static_cast<std::size_t>(grid.angles) / 4;
    if (map.volume[cell] <= 0) {
      EXPECT_EQ(velocity[cell], 0);
      continue;
    }
    EXPECT_NEAR(velocity[cell], right ? 4 : -2, 1e-12);
    EXPECT_NEAR(group[cell], right ? 0.5 * all[cell] : all[cell], 1e-12 * all[cell]);
    carried += sum.carried[2 * cell];
  }
  const auto volume = [&](std::size_t k) {
    return 4.0 / 3.0 * kPi * std::pow(static_cast<double>(r[k]), 3);
  };
  EXPECT_NEAR(carried, 2 * (8 * volume(0) - 2 * volume(2)), 1e-12);
}

TEST(Angles, OfAMillLieBetweenMinus90And270Degrees) {
  EXPECT_NEAR(principal_angle(-100 * kDegree), 260 * kDegree, 1e-15 * 10);
  EXPECT_NEAR(principal_angle(300 * kDegree), -60 * kDegree, 1e-15 * 10);
  EXPECT_NEAR(angle_near(269 * kDegree, -89 * kDegree), -91 * kDegree, 1e-15 * 10);
}

}  // namespace
}  // namespace quern
