// What a run tells of its collisions: each episode with its energies, sums by kind, the same bits
// for any number of threads and after a restart.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "kernels/collision_tally.h"
#include "scheduler/open_episodes.h"
#include "tests/support/contact_cases.h"
#include "tests/support/hashed_runs.h"
#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

template <class Real>
class CollisionsOf : public testing::Test {};
TYPED_TEST_SUITE(CollisionsOf, Precisions, Names);

double total(const std::array<double, kEnergyBins>& bins) {
  double sum = 0;
  for (const double bin : bins) sum += bin;
  return sum;
}

// The one entry of a spectrum: its energy, and that it lies in the bin of that energy.
double only_entry(const EnergySpectrum& spectrum) {
  EXPECT_EQ(total(spectrum.count), 1);
  const double energy = total(spectrum.energy);
  EXPECT_EQ(spectrum.count[energy_bin(energy)], 1);
  return energy;
}

template <class Real>
double kinetic_energy(const World<Real>& world) {
  double sum = 0;
  for (std::size_t k = 0; k < world.particles.size(); ++k) {
    const Record<Real>& r = world.particles.record[k];
    const double mass = 1 / static_cast<double>(world.particles.traits[k].inverse_mass);
    const double radius = static_cast<double>(r.radius);
    const Vec3 spin(world.particles.spin_x[k], world.particles.spin_y[k],
                    world.particles.spin_z[k]);
    sum += 0.5 * mass * Vec3(r.vx, r.vy, r.vz).squaredNorm() +
           0.2 * mass * radius * radius * spin.squaredNorm();
  }
  return sum;
}

// All of a window is in the bins or in what goes on, and all kinds are all that is dissipated.
template <class Real>
void expect_complete(const World<Real>& world, double tolerance) {
  const Collisions& c = world.collisions;
  const std::vector<OpenEpisodes> open = open_episodes(world);
  const double of_ledger = world.ledger.dissipated() - c.start.dissipated();
  double of_kinds = 0, of_slide = 0, of_spectra = 0;
  for (std::size_t kind = 0; kind < c.kinds.size(); ++kind) {
    of_kinds += c.dissipated(kind);
    of_slide += c.kinds[kind].slide;
    of_spectra += total(c.spectra[kind].dissipated.energy) + open[kind].dissipated;
  }
  EXPECT_GT(of_ledger, 0);
  EXPECT_NEAR(of_kinds, of_ledger, tolerance * of_ledger);
  EXPECT_NEAR(of_slide, world.ledger.slide - c.start.slide, tolerance * of_ledger);
  EXPECT_NEAR(of_spectra, of_ledger, tolerance * of_ledger);
}

TEST(EnergyBins, AreTenADecadeAndHoldTheirLowerEdge) {
  EXPECT_EQ(energy_bin_from(1), 1e-12);
  EXPECT_EQ(energy_bin_from(kEnergyBins - 1), 1e3);
  for (std::size_t bin = 1; bin < kEnergyBins; ++bin) {
    const double from = energy_bin_from(bin);
    EXPECT_NEAR(std::log10(from), -12 + 0.1 * (static_cast<double>(bin) - 1), 1e-12);
    EXPECT_EQ(energy_bin(from), bin);
    EXPECT_EQ(energy_bin(std::nextafter(from, 0)), bin - 1);
  }
  for (const double below : {0.0, -1.0, -HUGE_VAL, std::nan(""), 9.99e-13}) {
    EXPECT_EQ(energy_bin(below), 0u);
  }
  EXPECT_EQ(energy_bin(HUGE_VAL), kEnergyBins - 1);
}

// Without gravity what a hit dissipates is what the motion has lost.
TYPED_TEST(CollisionsOf, ASphereAgainstAWallAreOneEpisodeWithItsLoss) {
  const double diameter = 1.0 / 64, mass = sphere_mass(diameter), speed = 1.5;
  const double dt = normal_contact_time(mass, Law().kn) / 30;
  Scene scene = small_scene(Law(), dt);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  add_sphere(scene, diameter, {0, 0, 0.51 * diameter}, {0, 0, -speed});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  world.begin_recording();
  run_steps(world, stepper, 200);
  const double loss = 0.5 * mass * speed * speed - kinetic_energy(world);
  const std::size_t kind = world.groups.kind(0, 1);
  EXPECT_EQ(world.groups.kind_name(kind), "sphere-liner");
  const KindSpectra& s = world.collisions.spectra[kind];
  const double rounding = sizeof(TypeParam) == 4 ? 1e-6 : 1e-12;
  EXPECT_NEAR(only_entry(s.dissipated), loss, rounding * loss);
  EXPECT_NEAR(only_entry(s.approach), 0.5 * mass * speed * speed, rounding * loss);
  EXPECT_NEAR(only_entry(s.impact), 0.5 * mass * speed * speed, rounding * loss);
  EXPECT_NEAR(world.collisions.dissipated(kind), loss, rounding * loss);
  EXPECT_EQ(total(world.collisions.spectra[world.groups.kind(0, 0)].dissipated.count), 0);
}

TYPED_TEST(CollisionsOf, AnObliqueHitKnowHowItCame) {
  const double diameter = 1.0 / 64, mass = sphere_mass(diameter), reduced = 0.5 * mass;
  const double dt = normal_contact_time(reduced, Law().kn) / 30;
  Scene scene = small_scene(Law(), dt);
  ParticleSpec balls = scene.particles[0];
  balls.name = "ball";
  balls.explicit_particles.clear();
  scene.particles.push_back(balls);
  add_sphere(scene, diameter, Vec3::Zero(), {0.2, 0, 0}, {0, 0, 30});
  const Vec3 line = Vec3(1, 0.3, 0.1).normalized();
  scene.particles[1].explicit_particles.push_back(
      {1.01 * diameter * line, -1.2 * line + Vec3(0, 0, 0.4), Vec3::Zero(), diameter});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  const double before = kinetic_energy(world);
  world.begin_recording();
  run_steps(world, stepper, 200);
  const double loss = before - kinetic_energy(world);
  const std::size_t kind = world.groups.kind(0, 1);
  EXPECT_EQ(world.groups.kind_name(kind), "sphere-ball");
  const KindSpectra& s = world.collisions.spectra[kind];
  const double rounding = sizeof(TypeParam) == 4 ? 3e-6 : 1e-12;
  EXPECT_NEAR(only_entry(s.dissipated), loss, rounding * before);
  // The normal has turned a little by the step in which they touch: (v dt / d)^2 of the energy of
  // the slip, and the same order in v_n itself times the slip.
  const Vec3 v = Vec3(0.2, 0, 0) - (-1.2 * line + Vec3(0, 0, 0.4));
  const Vec3 slip = v + Vec3(0, 0, 30).cross(0.5 * diameter * line);
  const double turned = 1.01 * v.norm() * 200 * dt / diameter + 0.02;
  const double along = v.dot(line);
  EXPECT_NEAR(only_entry(s.approach), 0.5 * reduced * along * along,
              turned * reduced * v.squaredNorm());
  EXPECT_NEAR(only_entry(s.impact), 0.5 * reduced * slip.squaredNorm(),
              turned * reduced * v.squaredNorm());
  expect_complete(world, rounding);
}

TYPED_TEST(CollisionsOf, ARollingSphereAreOneThatGoesOn) {
  const double diameter = 1.0 / 64;
  const double dt = normal_contact_time(sphere_mass(diameter), 1e5) / 30;
  Law law;
  law.kn = 1e5;
  law.kt = 4e4;
  law.rolling = 0.01;
  Scene scene = small_scene(law, dt);
  scene.run.gravity = Vec3(0, 0, -9.81);
  add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  const double sunk = sphere_mass(diameter) * 9.81 / law.kn;
  add_sphere(scene, diameter, {0, 0, 0.5 * diameter - sunk}, {0.5, 0, 0});
  World<TypeParam> world = world_of<TypeParam>(scene);
  Stepper<TypeParam> stepper(world, 1);
  world.begin_recording();
  run_until(world, stepper, 1);
  const std::size_t kind = world.groups.kind(0, 1);
  EXPECT_EQ(total(world.collisions.spectra[kind].dissipated.count), 0);
  EXPECT_EQ(open_episodes(world)[kind].count, 1);
  EXPECT_GT(world.collisions.dissipated(kind), 0);
  expect_complete(world, 1e-9);
}

// A mill with two species, recorded from the middle of its motion.
TYPED_TEST(CollisionsOf, AMillAddUpToWhatItDissipates) {
  World<TypeParam> world =
      world_of<TypeParam>(shipped_scene("lab_mill_spheres", {"run.settle=none"}));
  Stepper<TypeParam> stepper(world, 2);
  run_until(world, stepper, 0.1);
  world.begin_recording();
  run_until(world, stepper, 0.3);
  ASSERT_EQ(world.groups.kinds(), 5u);
  for (std::size_t kind = 0; kind < 5; ++kind) {
    EXPECT_GT(total(world.collisions.spectra[kind].dissipated.count), 100) << kind;
  }
  expect_complete(world, 1e-6);
}

TEST(Collisions, OfPolyhedraAddUpToWhatTheyDissipate) {
  World<float> world = world_of<float>(shipped_scene("lab_mill", {"run.settle=none"}));
  Stepper<float> stepper(world, 2);
  run_until(world, stepper, 0.1);
  world.begin_recording();
  run_until(world, stepper, 0.2);
  for (std::size_t kind = 0; kind < world.groups.kinds(); ++kind) {
    EXPECT_GT(total(world.collisions.spectra[kind].dissipated.count), 10) << kind;
  }
  expect_complete(world, 1e-6);
}

// Counted by hand: who touches after each step, by kind.
template <class Real>
std::map<std::size_t, std::set<std::uint64_t>> touching(const World<Real>& world) {
  std::map<std::size_t, std::set<std::uint64_t>> all;
  const Particles<Real>& p = world.particles;
  const auto group = [&](Index k) { return world.groups.of_species(p.species[k]); };
  for (std::size_t tile = 0; tile < world.pairs.tiles(); ++tile) {
    world.pairs.for_each(
        tile, PairBatch<Real>::Part::kOwn, [&](std::size_t slot, Index i, Index j) {
          if (!world.pairs.is_open(slot)) return;
          all[world.groups.kind(group(i), group(j))].insert(std::uint64_t{p.id[i]} << 32 | p.id[j]);
        });
  }
  return all;
}

void expect_counted(const std::string& target) {
  World<float> world =
      world_of<float>(shipped_scene("lab_mill_spheres", {"run.settle=none", "run.tile_size=32"}));
  Stepper<float> stepper(world, 1);
  run_until(world, stepper, 0.06);
  world.begin_recording();
  stepper.step();
  auto before = touching(world);
  std::map<std::size_t, double> begun, ended;
  for (int k = 0; k < 1500; ++k) {
    stepper.step();
    auto now = touching(world);
    for (std::size_t kind = 0; kind < world.groups.kinds(); ++kind) {
      for (const auto pair : now[kind]) begun[kind] += before[kind].contains(pair) ? 0 : 1;
      for (const auto pair : before[kind]) ended[kind] += now[kind].contains(pair) ? 0 : 1;
    }
    before = std::move(now);
  }
  for (const auto& [a, b] : {std::pair{0, 0}, {0, 1}, {1, 1}}) {
    const std::size_t kind =
        world.groups.kind(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    EXPECT_GT(ended[kind], 5) << target;
    const KindSpectra& s = world.collisions.spectra[kind];
    EXPECT_EQ(total(s.impact.count), begun[kind]) << target;
    EXPECT_EQ(total(s.dissipated.count), ended[kind]) << target;
    EXPECT_EQ(total(s.approach.count), ended[kind]) << target;
    EXPECT_EQ(open_episodes(world)[kind].count, static_cast<double>(before[kind].size()));
  }
  expect_complete(world, 1e-6);
}
TEST(Collisions, OfSpheresAreThoseThatBeginAndEndOnEveryTarget) {
  for_each_target<float>(expect_counted);
}

// All that is recorded, as numbers.
std::vector<double> numbers_of(const World<float>& world) {
  std::vector<double> all = {world.collisions.steps};
  for (const ContactEnergies& k : world.collisions.kinds) {
    all.insert(all.end(), {k.work, k.elastic, k.slide, k.tangential_damping});
  }
  for (const KindSpectra& s : world.collisions.spectra) {
    for (const EnergySpectrum* one : {&s.dissipated, &s.approach, &s.impact}) {
      all.insert(all.end(), one->count.begin(), one->count.end());
      all.insert(all.end(), one->energy.begin(), one->energy.end());
    }
  }
  for (const OpenEpisodes& open : open_episodes(world)) {
    all.insert(all.end(), {open.count, open.dissipated});
  }
  return all;
}

// A charge in motion, recorded from its first step on.
class RecordedRun {
 public:
  RecordedRun(const std::string& scene, std::vector<std::string> overrides) {
    overrides.push_back("run.settle=none");
    scene_ = shipped_scene(scene, overrides);
    World<float> world = world_of<float>(scene_);
    advance(world, {}, 8000);
    write_state(world, folder_.path());
    advance(world, {}, 9500);
    unrecorded_ = state_hash(world);
  }
  std::uint64_t unrecorded() const { return unrecorded_; }
  std::unique_ptr<World<float>> run(const RunOptions& o) const {
    std::unique_ptr<World<float>> world = read_state(scene_, folder_.path());
    world->begin_recording();
    if (o.resume_at != 0) {
      TempFolder between;
      advance(*world, o, 8000 + o.resume_at);
      write_state(*world, between.path());
      world = read_state(scene_, between.path());
    }
    advance(*world, o, 9500);
    return world;
  }

 private:
  Scene scene_;
  TempFolder folder_;
  std::uint64_t unrecorded_;
};

void expect_same_whatever(const RecordedRun& run) {
  const std::unique_ptr<World<float>> world = run.run({});
  const std::vector<double> one = numbers_of(*world);
  EXPECT_GT(world->clock.rebuilds, 3u);
  EXPECT_EQ(state_hash(*world), run.unrecorded()) << "recording must not change the motion";
  EXPECT_EQ(numbers_of(*run.run({.threads = 2, .shuffle = 7})), one);
  EXPECT_EQ(numbers_of(*run.run({.threads = 3})), one);
  EXPECT_EQ(numbers_of(*run.run({.threads = 2, .resume_at = 700})), one);
  EXPECT_EQ(numbers_of(*run.run({.resume_at = 1})), one);
}

TEST(Collisions, OfSpheresAreTheSameBitsWithThreadsAndRestarts) {
  expect_same_whatever(RecordedRun("lab_mill_spheres", {"run.tile_size=8"}));
}
TEST(Collisions, OfPolyhedraAreTheSameBitsWithThreadsAndRestarts) {
  expect_same_whatever(RecordedRun("lab_mill", {"run.tile_size=8"}));
}

}  // namespace
}  // namespace quern::test
