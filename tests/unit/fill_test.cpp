// Filling: no overlap, inside the walls, where the method says, the same for the same seed.
//
// Overlaps are looked for by a sweep along x over all pairs, which shares nothing with the grid
// that the fill uses; walls of a mill by the scene's own numbers (circle and trapezoids).
#include "scheduler/fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "scheduler/fill_region.h"
#include "scheduler/rain.h"
#include "scheduler/random.h"
#include "scheduler/sphere_grid.h"

namespace quern {
namespace {

Scene base_scene() {
  Scene scene;
  scene.materials = {{"steel", 7800, 0}, {"ore", 4500, 0}};
  return scene;
}

ParticleSpec spheres(const char* name, double diameter, long count) {
  ParticleSpec spec;
  spec.name = name;
  spec.material = "ore";
  spec.diameter = diameter;
  spec.count = count;
  return spec;
}

Facets facets_of(const std::vector<Triangle>& triangles, double cell) {
  std::vector<FacetComponent> components(1);
  components[0].triangles = triangles;
  return build_facets(components, cell);
}

// A twentieth of the SAG charge in a mill of a twentieth of the cross-section.
Scene small_sag() {
  Scene scene = base_scene();
  MillSpec mill;
  mill.material = "steel";
  mill.diameter = 2.18;
  mill.length = 0.5;
  mill.ends = EndKind::kPeriodic;
  mill.lifters = LifterSpec{13, 0.152, 14 * kPi / 180, 0.152};
  scene.mill = mill;
  scene.particles = {spheres("ball", 0.125, 125)};
  ParticleSpec ore;
  ore.name = "ore";
  ore.material = "ore";
  const double edge[] = {0.015, 0.025, 0.035, 0.045, 0.075, 0.105, 0.150};
  const long count[] = {14920, 3311, 1181, 334, 103, 26};
  for (int k = 0; k < 6; ++k) {
    SizeClass c;
    c.from = edge[k];
    c.to = edge[k + 1];
    c.count = count[k];
    ore.sizes.push_back(c);
  }
  scene.particles.push_back(ore);
  return scene;
}

Scene open_box(long count) {
  Scene scene = base_scene();
  BoxSpec box;
  box.high = Vec3(0.08, 0.2, 0.08);
  box.open_top = true;
  scene.boxes = {box};
  scene.particles = {spheres("ore", 0.01375, count)};
  return scene;
}

// Smallest gap between two spheres over all pairs, in nearest images; negative: overlap.
double smallest_gap(const std::vector<ParticleSeed>& particles, const PeriodicAxes& periodic) {
  std::vector<ParticleSeed> sorted = particles;
  for (ParticleSeed& p : sorted) p.position = periodic.wrapped(p.position);
  if (periodic.on[0]) {  // images beyond the upper end close the sweep
    for (const ParticleSeed& p : particles) {
      ParticleSeed image = p;
      image.position = periodic.wrapped(p.position) + Vec3(periodic.length[0], 0, 0);
      if (image.position.x() < periodic.low[0] + 1.3 * periodic.length[0]) sorted.push_back(image);
    }
  }
  std::sort(sorted.begin(), sorted.end(), [](const ParticleSeed& a, const ParticleSeed& b) {
    return a.position.x() < b.position.x();
  });
  double largest = 0;
  for (const ParticleSeed& p : sorted) largest = std::max(largest, p.radius);
  double gap = 1e9;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = i + 1; j < sorted.size(); ++j) {
      Vec3 d = sorted[j].position - sorted[i].position;
      if (d.x() > sorted[i].radius + largest) break;
      for (int a = 1; a < 3; ++a) {
        if (!periodic.on[static_cast<std::size_t>(a)]) continue;
        d[a] -= periodic.length[a] * std::nearbyint(d[a] / periodic.length[a]);
      }
      gap = std::min(gap, d.norm() - sorted[i].radius - sorted[j].radius);
    }
  }
  return gap;
}

bool same_places(const std::vector<ParticleSeed>& a, const std::vector<ParticleSeed>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ParticleSeed& p, const ParticleSeed& q) {
                      return p.position == q.position && p.radius == q.radius;
                    });
}

// In the steel of a lifter: the trapezoid on the lifter's mid-plane, top at R - height.
bool inside_a_lifter(const MillSpec& mill, const Vec3& x) {
  const double pitch = 2 * kPi / mill.lifters->count;
  const double angle = std::atan2(x.y(), x.x());
  const double off = angle - pitch * std::nearbyint(angle / pitch);
  const double r = x.head<2>().norm(),
               depth = r * std::cos(off) - 0.5 * mill.diameter + mill.lifters->height;
  return depth > 0 && std::abs(r * std::sin(off)) < 0.5 * mill.lifters->top_width +
                                                        depth * std::tan(mill.lifters->face_angle);
}

TEST(Fill, PlacesASagMixDenselyInTheLowerSegment) {
  const Scene scene = small_sag();
  const Facets shell = facets_of(mill_shell(*scene.mill, -0.3, 0.8), 0.1);
  const Facets* walls[] = {&shell};
  auto particles = draw_sizes(scene);
  const FillReport report = place_particles(scene, walls, particles);
  EXPECT_GE(smallest_gap(particles, periodic_axes(scene)), -1e-12);
  double top = -1, solid = 0;
  for (const ParticleSeed& p : particles) {
    EXPECT_GE(distance_to_facets(shell, p.position, p.radius), p.radius);
    EXPECT_LT(p.position.head<2>().norm(), 1.09);
    EXPECT_FALSE(inside_a_lifter(*scene.mill, p.position));
    EXPECT_GE(p.position.z(), 0);
    EXPECT_LE(p.position.z(), 0.5);
    top = std::max(top, p.position.y());
    solid += sphere_volume(p.radius);
  }
  // The circle's segment below the highest centre, less the lifters' share of it.
  const double r = 1.09, segment = r * r * std::acos(-top / r) + top * std::sqrt(r * r - top * top);
  const double share = mill_inner_area(*scene.mill) / (kPi * r * r);
  EXPECT_NEAR(solid / (0.5 * segment * share), 0.42, 0.02);  // lifters are not spread evenly
  EXPECT_NEAR(report.fraction, 0.42, 1e-12);
  EXPECT_GT(particles.size(), 19000u);
}

TEST(Fill, IsAFunctionOfTheSeed) {
  Scene scene = open_box(300);
  const Facets box = facets_of(box_faces(scene.boxes[0], scene.run.gravity), 0.02);
  const Facets* walls[] = {&box};
  auto a = draw_sizes(scene), b = a, c = a;
  place_particles(scene, walls, a);
  place_particles(scene, walls, b);
  scene.run.seed = 2;
  place_particles(scene, walls, c);
  EXPECT_TRUE(same_places(a, b));
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NE(a[i].position, c[i].position);
}

TEST(Fill, RaisesTheLevelUntilSpheresOfOneSizeFit) {
  Scene scene = base_scene();
  scene.run.gravity = Vec3(0, 0, -9.81);
  scene.domain.low = Vec3(-1, 0, 0);
  scene.domain.high = Vec3(-0.4, 0.3, 5);
  scene.domain.periodic[0] = scene.domain.periodic[1] = true;
  scene.planes.resize(1);
  scene.particles = {spheres("ore", 0.02, 4000)};
  const Facets floor = facets_of(plane_patch(scene.planes[0], Vec3::Zero(), 5), 0.1);
  const Facets* walls[] = {&floor};
  auto particles = draw_sizes(scene);
  const FillReport report = place_particles(scene, walls, particles);
  EXPECT_GE(smallest_gap(particles, periodic_axes(scene)), -1e-12);
  EXPECT_GT(report.fraction, 0.25);
  EXPECT_LT(report.fraction, 0.385);  // saturation of equal spheres
  int across = 0;
  for (const ParticleSeed& p : particles) {
    EXPECT_GE(p.position.z(), 0.01);
    across += p.position.x() < -0.99 || p.position.y() < 0.01 ? 1 : 0;
  }
  EXPECT_GT(across, 50);  // some reach through the periodic faces
}

TEST(Fill, RainsIntoAnOpenBoxFromAboveItsRim) {
  Scene scene = open_box(300);
  scene.fill.method = FillMethod::kRain;
  scene.fill.velocity = Vec3(0, -1, 0);
  const Facets box = facets_of(box_faces(scene.boxes[0], scene.run.gravity), 0.02);
  const Facets* walls[] = {&box};
  auto particles = draw_sizes(scene);
  const FillReport report = place_particles(scene, walls, particles);
  EXPECT_GE(smallest_gap(particles, {}), -1e-12);
  EXPECT_GE(report.low.y(), 0.2);
  EXPECT_LT(report.high.y(), 0.9);
  for (const double low : {report.low.x(), report.low.z()}) EXPECT_GE(low, 0);
  for (const double high : {report.high.x(), report.high.z()}) EXPECT_LE(high, 0.08);
  for (const ParticleSeed& p : particles) EXPECT_EQ(p.velocity, Vec3(0, -1, 0));
}

TEST(Fill, PilesUpAboveAnOpenBoxThatIsTooSmall) {
  const Scene scene = open_box(400);
  const Facets box = facets_of(box_faces(scene.boxes[0], scene.run.gravity), 0.02);
  const Facets* walls[] = {&box};
  auto particles = draw_sizes(scene);
  const FillReport report = place_particles(scene, walls, particles);
  EXPECT_GE(smallest_gap(particles, {}), -1e-12);
  EXPECT_TRUE(check_overlaps(scene, walls, particles, 0).empty());
  EXPECT_LT(report.low.y(), 0.01);
  EXPECT_GT(report.high.y(), 0.2);
  EXPECT_LT(report.high.y(), 0.35);
}

TEST(Fill, SpreadsOverTheWholeRegionAtRandom) {
  Scene scene = base_scene();
  scene.fill.method = FillMethod::kRandom;
  scene.fill.low = Vec3(1, 2, 3);
  scene.fill.high = Vec3(2, 4, 4);
  scene.particles = {spheres("ore", 0.02, 4000)};
  auto particles = draw_sizes(scene);
  place_particles(scene, {}, particles);
  Vec3 mean = Vec3::Zero();
  for (const ParticleSeed& p : particles) {
    EXPECT_GE((p.position - *scene.fill.low).minCoeff(), 0.01);
    EXPECT_GE((*scene.fill.high - p.position).minCoeff(), 0.01);
    mean += p.position / 4000;
  }
  const double sigma = 1 / std::sqrt(12 * 4000.0);  // of a mean, per metre of extent
  EXPECT_NEAR(mean.x(), 1.5, 4 * sigma);
  EXPECT_NEAR(mean.y(), 3.0, 8 * sigma);
  EXPECT_NEAR(mean.z(), 3.5, 4 * sigma);
}

TEST(Fill, FollowsATiltedGravity) {
  Scene scene = base_scene();
  scene.run.gravity = Vec3(3, -9, 1);
  scene.fill.low = Vec3(0, 0, 0);
  scene.fill.high = Vec3(1, 1, 1);
  scene.fill.max_fraction = 0.2;
  scene.particles = {spheres("ore", 0.03, 3000)};
  auto particles = draw_sizes(scene);
  const FillReport report = place_particles(scene, {}, particles);
  EXPECT_NEAR(report.fraction, 0.2, 1e-12);
  const Vec3 up = -scene.run.gravity.normalized();
  double top = -10, bottom = 10;
  for (const ParticleSeed& p : particles) {
    top = std::max(top, up.dot(p.position));
    bottom = std::min(bottom, up.dot(p.position));
  }
  // 0.21 of the cube's volume lies below the level; the cube is 1.36 high along this direction.
  EXPECT_LT(top - bottom, 0.6);
  EXPECT_NEAR(smallest_gap(particles, {}), 0, 1e-3);
}

TEST(Fill, LeavesExplicitParticlesAndAvoidsThem) {
  Scene scene = open_box(200);
  ParticleSpec big;
  big.material = "steel";
  big.explicit_particles = {{Vec3(0.04, 0.03, 0.04), Vec3::Zero(), Vec3::Zero(), 0.05}};
  scene.particles.insert(scene.particles.begin(), big);
  const Facets box = facets_of(box_faces(scene.boxes[0], scene.run.gravity), 0.02);
  const Facets* walls[] = {&box};
  auto particles = draw_sizes(scene);
  place_particles(scene, walls, particles);
  EXPECT_EQ(particles[0].position, Vec3(0.04, 0.03, 0.04));
  EXPECT_GE(smallest_gap(particles, {}), -1e-12);
  EXPECT_TRUE(check_overlaps(scene, walls, particles, 0).empty());
}

// A drum given as a mesh only: the corners of its bounding box are behind the nearest facet.
TEST(Fill, StaysOnTheInnerSideOfAMesh) {
  MillSpec drum;
  drum.diameter = 0.3;
  drum.length = 0.04;
  drum.pieces_per_arc = 36;
  std::vector<Triangle> triangles = mill_shell(drum, 0, drum.length);
  const std::size_t sides = triangles.size();
  for (std::size_t t = 0; t < sides; ++t) {  // a fan over each end, from the shell's own edges
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = triangles[t].corner[k], b = triangles[t].corner[(k + 1) % 3];
      if (a.z() == b.z()) triangles.push_back({{b, a, Vec3(0, 0, a.z())}});
    }
  }
  const Facets mesh = facets_of(triangles, 0.02);
  const Facets* walls[] = {&mesh};
  Scene scene = base_scene();
  scene.meshes.resize(1);
  scene.fill.method = FillMethod::kRandom;
  scene.particles = {spheres("ore", 0.008, 1500)};
  auto particles = draw_sizes(scene);
  place_particles(scene, walls, particles);
  for (const ParticleSeed& p : particles) EXPECT_LE(p.position.head<2>().norm() + 0.004, 0.15);
  EXPECT_GE(smallest_gap(particles, {}), -1e-12);
}

TEST(Fill, SaysHowFarItCameWhenItIsFull) {
  Scene scene = open_box(1);
  scene.boxes[0].open_top = false;
  scene.particles = {spheres("ball", 0.03, 8), spheres("ore", 0.015, 330)};
  const Facets box = facets_of(box_faces(scene.boxes[0], scene.run.gravity), 0.02);
  const Facets* walls[] = {&box};
  auto particles = draw_sizes(scene);
  try {
    place_particles(scene, walls, particles);
    FAIL() << "it fitted";
  } catch (const UserError& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("8 of 8 'ball'"), std::string::npos) << text;
    EXPECT_NE(text.find("of 330 'ore'"), std::string::npos) << text;
    EXPECT_NE(text.find("fill.high"), std::string::npos) << text;
  }
}

TEST(Fill, RefusesWithoutARegionOrBeyondThePeriod) {
  Scene scene = base_scene();
  scene.particles = {spheres("ore", 0.2, 2)};
  auto particles = draw_sizes(scene);
  EXPECT_THROW(place_particles(scene, {}, particles), UserError);
  scene.domain.low = Vec3::Zero();
  scene.domain.high = Vec3(0.1, 1, 1);
  scene.domain.periodic[0] = true;
  EXPECT_THROW(place_particles(scene, {}, particles), UserError);
}

TEST(CheckOverlaps, ReportsPairsAndWallsAboveTheAllowance) {
  Scene scene = open_box(1);
  ParticleSpec spec;
  spec.name = "probe";
  spec.material = "ore";
  const Vec3 rest = Vec3::Zero();
  spec.explicit_particles = {{Vec3(0.04, 0.0099, 0.04), rest, rest, 0.02},  // floor: 1 % of R
                             {Vec3(0.04, 0.0250, 0.04), rest, rest, 0.02},  // pair: 49 %
                             {Vec3(0.0770, 0.1, 0.04), rest, rest, 0.02}};  // side: 70 %
  scene.particles = {spec};
  const Facets box = facets_of(box_faces(scene.boxes[0], scene.run.gravity), 0.02);
  const Facets* walls[] = {&box};
  const auto particles = draw_sizes(scene);
  const auto lines = check_overlaps(scene, walls, particles);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].find("particle 2 ('probe') overlaps a wall"), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("0.7 of the smaller"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("particle 1 ('probe') overlaps particle 0"), std::string::npos);
  EXPECT_EQ(check_overlaps(scene, walls, particles, 0).size(), 3u);
  EXPECT_EQ(check_overlaps(scene, walls, particles, 0, 1).back(), "and 2 more overlaps");
}

TEST(SphereGrid, FindsTheOverlapsThatAllPairsFind) {
  PeriodicAxes periodic;
  periodic.on = {true, false, true};
  periodic.low = Vec3(-0.3, 0, 0.1);
  periodic.length = Vec3(1.0, 1.0, 0.35);  // z: barely wider than the largest
  CounterRandom random(11);
  std::vector<Vec3> position;
  std::vector<double> radius;
  for (int i = 0; i < 600; ++i) {
    position.emplace_back(random.uniform(-2, 2), random.uniform(-1, 1), random.uniform(-1, 1));
    radius.push_back(0.15 * std::pow(0.05, random.uniform()));
  }
  SphereGrid grid(periodic, radius);
  long found = 0, expected = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    bool overlaps = false;
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 d = position[i] - position[j];
      for (const int a : {0, 2}) {
        d[a] -= periodic.length[a] * std::nearbyint(d[a] / periodic.length[a]);
      }
      overlaps = overlaps || d.norm() < radius[i] + radius[j];
    }
    expected += overlaps ? 1 : 0;
    found += grid.is_free(position[i], radius[i]) ? 0 : 1;
    EXPECT_EQ(!grid.is_free(position[i], radius[i]), overlaps) << i;
    grid.insert(position[i], radius[i], static_cast<Index>(i));
  }
  EXPECT_EQ(found, expected);
  EXPECT_GT(expected, 100);
}

TEST(MillSection, ContainsWhatTheProfileContains) {
  CounterRandom random(5);
  for (const double face_angle : {0.0, 0.25, -0.2}) {
    MillSpec mill;
    mill.diameter = 2;
    mill.length = 0.1;
    mill.lifters = LifterSpec{7, 0.2, face_angle, 0.15};
    const MillSection section(mill);
    const auto profile = mill_profile(mill);
    int near_wall = 0;
    for (int k = 0; k < 20000; ++k) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const bool inside = profile_contains(profile, x, y);
      EXPECT_EQ(section.contains(x, y), inside) << x << " " << y;
      near_wall += inside && std::hypot(x, y) > section.clear_radius() ? 1 : 0;
    }
    EXPECT_GT(near_wall, 1000);
  }
}

class RainTest : public ::testing::Test {
 protected:
  RainTest() : scene_(open_box(300)) {
    scene_.fill.method = FillMethod::kRain;
    scene_.fill.over = 0.5;
    box_ = facets_of(box_faces(scene_.boxes[0], scene_.run.gravity), 0.02);
  }

  // Rains in free fall through the bottom; returns the times of arrival, in order of the list.
  std::vector<double> rain(std::vector<ParticleSeed>& particles, std::size_t restart_at) {
    const Facets* walls[] = {&box_};
    std::vector<double> arrived(particles.size(), -1);
    auto shower = std::make_unique<Rain>(scene_, walls, particles);
    for (int step = 1; step <= 200; ++step) {
      const double time = 0.005 * step;
      std::vector<PlacedSphere> present;
      std::vector<ParticleSeed> all;
      for (const std::size_t i : shower->arrivals()) {
        ParticleSeed p = particles[i];
        const double age = time - arrived[i];
        p.position.y() -= 0.5 * 9.81 * age * age;
        present.push_back({p.position, p.radius});
      }
      for (const std::size_t i : shower->insert(time, present, particles)) {
        arrived[i] = time;
        all.push_back(particles[i]);
      }
      for (const ParticleSeed& p : all) {
        EXPECT_GE(p.position.y() - p.radius, 0.2);
        for (const PlacedSphere& s : present) {
          EXPECT_GE((p.position - s.position).norm(), p.radius + s.radius);
        }
      }
      EXPECT_GE(smallest_gap(all, {}), 0);
      EXPECT_LE(shower->inserted(), shower->due(time));
      if (static_cast<std::size_t>(step) == restart_at) {
        const std::size_t inserted = shower->inserted();
        shower = std::make_unique<Rain>(scene_, walls, particles);
        shower->resume_after(inserted);
      }
    }
    EXPECT_EQ(shower->waiting(), 0u);
    return arrived;
  }

  Scene scene_;
  Facets box_;
};

TEST_F(RainTest, InsertsLinearlyInTimeAndWithoutOverlap) {
  auto particles = draw_sizes(scene_);
  const Facets* walls[] = {&box_};
  place_particles(scene_, walls, particles);  // leaves them to the rain
  const std::vector<double> arrived = rain(particles, 0);
  std::vector<double> sorted = arrived;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    EXPECT_NEAR(sorted[k], 0.5 * static_cast<double>(k + 1) / 300, 0.03) << k;  // 6 steps
  }
  EXPECT_FALSE(std::is_sorted(arrived.begin(), arrived.end()));  // shuffled
}

TEST_F(RainTest, ResumesFromTheNumberInserted) {
  auto through = draw_sizes(scene_), restarted = through;
  rain(through, 0);
  rain(restarted, 60);
  EXPECT_TRUE(same_places(through, restarted));
}

}  // namespace
}  // namespace quern
