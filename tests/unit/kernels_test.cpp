// The contact kernels against their scalar f64 twins, on every SIMD target of this CPU, in both
// precisions, for every switch of the law and every state of a contact.
//
// Tolerances: kernel_checks.h. The largest error met lies between 3 and 5 units.
#include <gtest/gtest.h>

#include <bit>

#include "kernels/contact.h"
#include "kernels/wear.h"
#include "tests/support/kernel_checks.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

using test::all_options;
using test::CaseOptions;
using test::expect_vector;
using test::for_each_target;
using test::kEps;
using test::kUnits;
using test::PairCases;
using test::RandomLaw;
using test::Rows;
using test::TallyTwin;

// Three f32 vectors (8 lanes beside 8 f64 lanes) and one more.
constexpr std::size_t kMostContacts = 3 * kPairPad + 1 * 8 + 1;

// Kernel and twin over the first `own` slots as the tile's own, the rest as imported.
template <class Real>
void check_pairs(const CaseOptions& o, std::size_t count, std::size_t own, unsigned seed) {
  const RandomLaw<Real> law(o, seed);
  PairCases<Real> cases(count, o, law, seed);
  const StepConstants<Real> step = test::constants(o, law);
  std::vector<twin::Contact> contact;
  std::vector<twin::Response> expected;
  TallyTwin tally;
  tally.cap = o.overlap_cap;
  for (std::size_t k = 0; k < count; ++k) {
    const Index i = cases.i[k], j = cases.j[k];
    contact.push_back(twin::sphere_sphere(step, cases.particles(), i, j));
    expected.push_back(
        twin::respond(twin::coefficients(step.law, tag_material(cases.traits[i].tag),
                                         tag_material(cases.traits[j].tag)),
                      contact[k], cases.history(k),
                      {step.dt, o.clamped, o.rolling, kEps<Real>, 0, o.overlap_cap}));
    if (k < own) tally.add(contact[k], expected[k]);
  }
  Rows rows(2 * count);
  ContactTally got;
  cases.push(own, step, rows.tile(0, static_cast<Index>(2 * count)), got);
  for (std::size_t k = 0; k < count; ++k) {
    const twin::Response& r = expected[k];
    const twin::History now = cases.history_now(k);
    expect_vector("spring", now.spring, r.spring, r.spring_error);
    expect_vector("rest", now.rest, Vec3::Zero(), r.spring_error);
    expect_vector("force", now.force, r.force, r.force_error);
    if (o.rolling) expect_vector("moment", now.moment, r.moment, r.moment_error);
    expect_vector("torque on j", rows.torque(2 * k + 1), r.torque_j, r.torque_error);
    EXPECT_EQ(rows.force(2 * k + 1), Vec3(-now.force)) << "the stored force is the one applied";
    EXPECT_EQ(rows.touches(2 * k + 1), contact[k].touching ? 1 : 0);
    if (k >= own) continue;  // i belongs to another tile
    expect_vector("torque on i", rows.torque(2 * k), r.torque_i, r.torque_error);
    EXPECT_EQ(rows.force(2 * k), now.force) << "opposite to the last bit";
    EXPECT_EQ(rows.touches(2 * k), contact[k].touching ? 1 : 0);
  }
  tally.expect(got, kEps<Real>);
}

template <class Real>
class KernelTwins : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(KernelTwins, Precisions);

TYPED_TEST(KernelTwins, OfSphereSphereAgreeOnEveryTarget) {
  for_each_target<TypeParam>([](const std::string& target) {
    unsigned seed = 1;
    for (const CaseOptions& o : all_options()) {
      for (std::size_t count = 1; count <= kMostContacts; ++count) {
        SCOPED_TRACE(target + ", " + test::name_of(o) + ", " + std::to_string(count));
        const std::size_t slots = (count + kPairPad - 1) / kPairPad * kPairPad;
        check_pairs<TypeParam>(o, count, count % 3 == 0 ? slots / (2 * kPairPad) * kPairPad : slots,
                               ++seed);
        if (testing::Test::HasFailure()) return;
      }
    }
  });
}

// A contact at rest but for a slip of a third of a rounding of its spring a step: added to the
// spring alone it would be lost every time.
TYPED_TEST(KernelTwins, OfASlowSlipLoseNoneOfIt) {
  using Real = TypeParam;
  for_each_target<TypeParam>([](const std::string& target) {
    for (const CaseOptions& o : all_options()) {
      SCOPED_TRACE(target + ", " + test::name_of(o));
      const RandomLaw<Real> law(o, 3);
      const StepConstants<Real> step = test::constants(o, law);
      PairCases<Real> cases(1, o, law, 3);
      Record<Real>&a = cases.record[0], &b = cases.record[1];
      const double radius_a = static_cast<double>(a.radius);
      const double radius_b = static_cast<double>(b.radius), overlap = 1e-3 * radius_a;
      const auto at =
          twin::at_overlap(twin::coefficients(step.law, tag_material(cases.traits[0].tag),
                                              tag_material(cases.traits[1].tag)),
                           overlap, radius_a * radius_b / (radius_a + radius_b));
      const double length = 0.2 * at.mu * at.kn / at.kt * overlap;
      const double slip = kEps<Real> * length / 3, arms = radius_a + radius_b - overlap;
      const Vec3 spin(0, 0, slip / (step.dt * arms));  // of both: they slip and turn no contact
      a = test::record_of<Real>(Vec3::UnitX() * arms, Vec3::Zero(), spin, radius_a);
      b = test::record_of<Real>(Vec3::Zero(), Vec3::Zero(), spin, radius_b);
      cases.set_history(0, {Vec3::UnitY() * -length, Vec3::UnitX() * at.kn * overlap, Vec3::Zero(),
                            Vec3::Zero()});
      const double start = cases.history(0).spring.y();
      constexpr int kSteps = 1000;
      for (int k = 0; k < kSteps; ++k) {
        Rows rows(2);
        ContactTally tally;
        cases.push(cases.slots, step, rows.tile(0, 2), tally);
        cases.set_history(0, cases.history_now(0));
      }
      const twin::History& h = cases.history(0);
      EXPECT_NEAR((h.spring.y() - start + h.rest.y()) / (kSteps * slip), -1, 1e-4);
    }
  });
}

// The tests above are worth what their cases are: all of these must occur among them.
TEST(KernelCases, CoverEveryStateOfAContact) {
  int fresh = 0, held = 0, slid = 0, lost = 0, apart = 0, pulling = 0, capped = 0;
  unsigned seed = 1;
  for (const CaseOptions& o : all_options()) {
    const RandomLaw<double> law(o, ++seed);
    const PairCases<double> cases(kMostContacts, o, law, seed);
    const StepConstants<double> step = test::constants(o, law);
    for (std::size_t k = 0; k < kMostContacts; ++k) {
      const Index i = cases.i[k], j = cases.j[k];
      const twin::Contact c = twin::sphere_sphere(step, cases.particles(), i, j);
      const twin::Response r =
          twin::respond(twin::coefficients(step.law, tag_material(cases.traits[i].tag),
                                           tag_material(cases.traits[j].tag)),
                        c, cases.history(k), {step.dt, o.clamped, o.rolling, 0, 0, o.overlap_cap});
      fresh += r.fresh;
      held += c.touching && !r.fresh && !r.slides;
      slid += c.touching && !r.fresh && r.slides;
      lost += !c.touching && cases.history(k).force.norm() > 0;
      apart += !c.touching && cases.history(k).force.norm() == 0;
      pulling += c.touching && !o.clamped && r.force.dot(c.normal) < 0;
      capped += o.overlap_cap > 0 && c.overlap > o.overlap_cap;
    }
  }
  for (const int seen : {fresh, held, slid, lost, apart, pulling, capped}) EXPECT_GT(seen, 5);
}

// A contact between two tiles: each tile has it in another place among other contacts, and knows
// one of the partners only. Both must find the same bits, and apply opposite ones.
TYPED_TEST(KernelTwins, OfACrossTileContactHaveTheSameBitsInBothTiles) {
  using Real = TypeParam;
  for_each_target<TypeParam>([](const std::string& target) {
    unsigned seed = 100;
    for (const CaseOptions& o : all_options()) {
      SCOPED_TRACE(target + ", " + test::name_of(o));
      const RandomLaw<Real> law(o, ++seed);
      const StepConstants<Real> step = test::constants(o, law);
      PairCases<Real> here(kMostContacts, o, law, seed), there(kMostContacts, o, law, seed);
      std::vector<std::size_t> slot(kMostContacts);  // in the other tile: turned by 5
      for (std::size_t k = 0; k < kMostContacts; ++k) {
        slot[k] = (k + 5) % kMostContacts;
        there.i[slot[k]] = here.i[k];
        there.j[slot[k]] = here.j[k];
        there.set_history(slot[k], here.history(k));
      }
      // Each tile holds all particles of which it sees one partner: the rows of the others are
      // those of the very last row. Tile `here` begins at 0, tile `there` at particle 1.
      Rows rows_here(2 * kMostContacts), rows_there(2 * kMostContacts);
      ContactTally tally_here, tally_there;
      const Index size = 2 * kMostContacts;
      here.push(here.slots, step, rows_here.tile(0, size), tally_here);
      there.push(0, step, rows_there.tile(1, size - 1), tally_there);
      EXPECT_EQ(tally_there.contacts, 0) << "imported contacts are not tallied";
      for (std::size_t k = 0; k < kMostContacts; ++k) {
        const twin::History a = here.history_now(k), b = there.history_now(slot[k]);
        EXPECT_EQ(a.spring, b.spring);
        EXPECT_EQ(a.rest, b.rest);
        EXPECT_EQ(a.force, b.force);
        EXPECT_EQ(a.moment, b.moment);
        EXPECT_EQ(rows_there.force(2 * k), Vec3(-rows_here.force(2 * k)));
        EXPECT_EQ(rows_there.torque(2 * k), rows_here.torque(2 * k + 1));
      }
    }
  });
}

// A row more with the same pairs and histories: owners and partners feel exactly twice as much.
TYPED_TEST(KernelTwins, OfBlocksOfTwoRowsAddUp) {
  using Real = TypeParam;
  for_each_target<TypeParam>([](const std::string& target) {
    unsigned seed = 300;
    for (const CaseOptions& o : all_options()) {
      SCOPED_TRACE(target + ", " + test::name_of(o));
      const RandomLaw<Real> law(o, ++seed);
      const StepConstants<Real> step = test::constants(o, law);
      PairCases<Real> cases(kMostContacts, o, law, seed);
      Rows rows(2 * kMostContacts), rows_twice(2 * kMostContacts);
      ContactTally tally, tally_twice;
      cases.push(cases.slots, step, rows.tile(0, 2 * kMostContacts), tally);
      const PairBatch<Real>& once = cases.batch;
      PairBatch<Real> twice;
      twice.rolling = o.rolling;
      twice.reset(once.blocks(), 2 * once.blocks());
      twice.begin.reset(2);
      twice.own_end.reset(1);
      twice.begin[0] = 0;
      twice.own_end[0] = twice.begin[1] = static_cast<Index>(once.blocks());
      std::copy(once.owner.begin(), once.owner.end(), twice.owner.begin());
      for (std::size_t b = 0; b <= once.blocks(); ++b) {
        twice.row_begin[b] = static_cast<Index>(2 * b);
      }
      std::vector<twin::History> histories(2 * once.slots());
      for (std::size_t slot = 0; slot < once.slots(); ++slot) {
        const std::size_t to = slot / kPairPad * 2 * kPairPad + slot % kPairPad;
        for (const std::size_t copy : {to, to + kPairPad}) {
          twice.partner[copy] = once.partner[slot];
          histories[copy] = cases.history(slot);
        }
      }
      test::set_histories(twice, histories);
      PairScratch<Real> scratch;
      push_tile_pairs(choose_kernels<Real>(step.law.kind), step, cases.particles(), twice, 0,
                      rows_twice.tile(0, 2 * kMostContacts), scratch, tally_twice);
      for (std::size_t k = 0; k < 2 * kMostContacts * kRowWidth; ++k) {
        EXPECT_EQ(rows_twice.rows[k], 2 * rows.rows[k]);
      }
      EXPECT_EQ(tally_twice.contacts, 2 * tally.contacts);
    }
  });
}

// Who is called i is a convention: exchanged partners feel the same within rounding.
TYPED_TEST(KernelTwins, OfExchangedPartnersAreOpposite) {
  using Real = TypeParam;
  for_each_target<TypeParam>([](const std::string& target) {
    unsigned seed = 200;
    for (const CaseOptions& o : all_options()) {
      SCOPED_TRACE(target + ", " + test::name_of(o));
      const RandomLaw<Real> law(o, ++seed);
      const StepConstants<Real> step = test::constants(o, law);
      PairCases<Real> one(kMostContacts, o, law, seed), two(kMostContacts, o, law, seed);
      std::vector<double> error(kMostContacts);
      for (std::size_t k = 0; k < kMostContacts; ++k) {
        std::swap(two.i[k], two.j[k]);
        const twin::History h = one.history(k);
        two.set_history(k, {-h.spring, -h.force, -h.rest, -h.moment});
        const auto coefficients = twin::coefficients(step.law, tag_material(one.traits[2 * k].tag),
                                                     tag_material(one.traits[2 * k + 1].tag));
        const auto contact = twin::sphere_sphere(step, one.particles(), one.i[k], one.j[k]);
        error[k] = twin::respond(coefficients, contact, one.history(k),
                                 {step.dt, o.clamped, o.rolling, kEps<Real>, 0, o.overlap_cap})
                       .force_error;
      }
      Rows rows(2 * kMostContacts);
      ContactTally tally;
      for (PairCases<Real>* cases : {&one, &two}) {
        cases->push(cases->slots, step, rows.tile(0, 2 * kMostContacts), tally);
      }
      for (std::size_t k = 0; k < kMostContacts; ++k) {
        expect_vector("force", two.history_now(k).force, -one.history_now(k).force, 2 * error[k]);
      }
    }
  });
}

// What lane k of the walls has worn off, against wear_of() with the force that the kernel wrote.
template <class Real>
void expect_wear(const StepConstants<double>& step, const ParticleView<Real>& p,
                 const WallContacts& walls, std::size_t k, double friction) {
  const auto row = [&](int from) {
    return Vec3(walls.geometry[from][k], walls.geometry[from + 1][k], walls.geometry[from + 2][k]);
  };
  const Record<Real>& r = p.record[walls.particle[k]];
  const Vec3 velocity(r.vx, r.vy, r.vz), spin(r.wx, r.wy, r.wz);
  WearContact c;
  c.normal = row(0);
  c.force = {walls.force[0][k], walls.force[1][k], walls.force[2][k]};
  c.velocity = velocity - row(8);
  const double arm = static_cast<double>(r.radius) - 0.5 * walls.geometry[3][k];
  c.at_point = c.velocity - arm * spin.cross(c.normal);
  c.braked = step.wear_absolute ? velocity : c.velocity;
  c.slide = walls.energies[2][k];
  c.friction = friction;
  c.mass = 1 / static_cast<double>(p.traits[walls.particle[k]].inverse_mass);
  c.touching = walls.geometry[3][k] > 0;
  c.first_touch = c.touching && !(walls.geometry[7][k] > 0);
  const WearRow expected = wear_of(c, step.dt, step.finnie_force_ratio);
  const double unit = kUnits * kEps<double>, impulse = step.dt * c.force.norm();
  const double speed = c.velocity.norm() + arm * spin.norm();
  const WearRow scale = {impulse * speed,        0,       impulse * speed,
                         c.mass * speed * speed, impulse, impulse};
  for (std::size_t sum = 0; sum < kWearSums; ++sum) {
    EXPECT_NEAR(walls.wear[sum][k], expected[sum], unit * scale[sum]) << "sum " << sum;
  }
}

// Wall contacts are f64 in every precision.
template <class Real>
void check_walls(const CaseOptions& o, std::size_t count, unsigned seed) {
  const RandomLaw<double> law(o, seed);
  const RandomLaw<Real> pair_law(o, seed);
  PairCases<Real> cases(count, o, pair_law, seed);  // for its particles
  StepConstants<double> step = test::constants(o, law);
  step.wears = true;
  step.wear_absolute = seed % 2 == 0;
  step.finnie_force_ratio = 1.5;
  test::Random random(seed);
  const std::size_t padded = (count + kPairPad - 1) / kPairPad * kPairPad;
  Column<double> numbers;
  numbers.reset(padded * (WallContacts::kGeometry + 14 + kWearSums));
  numbers.fill(0);
  Column<Index> particle;
  Column<std::uint32_t> material;
  particle.reset(padded);
  material.reset(padded);
  particle.fill(0);
  material.fill(0);
  WallContacts walls{};
  double* row = numbers.data();
  for (double*& g : walls.geometry) g = std::exchange(row, row + padded);
  for (double*& s : walls.spring) s = std::exchange(row, row + padded);
  for (double*& f : walls.force) f = std::exchange(row, row + padded);
  for (double*& m : walls.moment) m = std::exchange(row, row + padded);
  walls.wall_work = std::exchange(row, row + padded);
  for (double*& e : walls.energies) e = std::exchange(row, row + padded);
  for (double*& w : walls.wear) w = std::exchange(row, row + padded);
  walls.particle = particle.data();
  walls.material = material.data();
  walls.count = padded;
  for (std::size_t k = 0; k < padded; ++k) walls.geometry[0][k] = walls.geometry[4][k] = 1;

  std::vector<twin::Contact> contact(count);
  std::vector<twin::Response> expected(count);
  std::vector<twin::History> before(count);
  TallyTwin tally;
  tally.cap = o.overlap_cap;
  for (std::size_t k = 0; k < count; ++k) {
    particle[k] = static_cast<Index>(2 * k);
    const Record<Real>& r = cases.record[2 * k];
    const double radius = static_cast<double>(r.radius);
    do {
      material[k] = static_cast<std::uint32_t>(random.below(o.materials));
      const auto coefficients =
          twin::coefficients(step.law, tag_material(cases.traits[2 * k].tag), material[k]);
      const bool lost = random.below(4) == 0, fresh = random.below(4) == 0;
      const Vec3 normal = random.in_cube(1).normalized();
      const Vec3 turned = (normal + random.in_cube(1e-3)).normalized();
      const Vec3 normal_old = fresh ? normal : turned;
      const double depth = radius * std::pow(10, random(-6, -1));
      const double approach = fresh ? depth / step.dt * random(0.9, 4) : random(-1, 1);
      const Vec3 wall_velocity = Vec3(r.vx, r.vy, r.vz) + approach * normal + random.in_cube(0.3);
      const Vec3 wall_spin = random.in_cube(3);
      before[k] = fresh ? twin::History()
                        : test::random_history(twin::at_overlap(coefficients, depth, radius),
                                               normal_old, depth, o.rolling, random);
      const double overlap = lost ? 0 : depth, overlap_old = fresh ? 0 : depth * random(0.5, 2);
      for (Eigen::Index a = 0; a < 3; ++a) {
        walls.geometry[0 + a][k] = lost ? normal_old[a] : normal[a];
        walls.geometry[4 + a][k] = normal_old[a];
        walls.geometry[8 + a][k] = wall_velocity[a];
        walls.geometry[14 + a][k] = wall_velocity[a] + 1e-3 * turned[a];
        walls.geometry[11 + a][k] = wall_spin[a];
        walls.spring[a][k] = before[k].spring[a];
        walls.force[a][k] = before[k].force[a];
        walls.moment[a][k] = before[k].moment[a];
      }
      walls.geometry[3][k] = overlap;
      walls.geometry[7][k] = overlap_old;
      contact[k] = twin::sphere_facet(cases.particles(), walls, k);
      expected[k] = twin::respond(coefficients, contact[k], before[k],
                                  {step.dt, o.clamped, o.rolling, kEps<double>, 0, o.overlap_cap});
    } while (expected[k].fresh_margin < 1e-3 || expected[k].slide_margin < 1e-3 ||
             std::abs(contact[k].overlap - o.overlap_cap) < 1e-3 * o.overlap_cap);
    tally.add(contact[k], expected[k]);
  }
  Rows rows(2 * count);
  ContactTally got;
  choose_kernels<Real>(step.law.kind)
      .walls(step, cases.particles(), walls, rows.tile(0, static_cast<Index>(2 * count)), got);
  const auto now = [&](double* const(&from)[3], std::size_t k) {
    return Vec3(from[0][k], from[1][k], from[2][k]);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const twin::Response& r = expected[k];
    expect_vector("spring", now(walls.spring, k), r.spring, r.spring_error);
    expect_vector("force", now(walls.force, k), r.force, r.force_error);
    expect_vector("moment", now(walls.moment, k), r.moment, r.moment_error);
    expect_vector("force on particle", rows.force(2 * k), r.force, r.force_error);
    expect_vector("torque on particle", rows.torque(2 * k), r.torque_i, r.torque_error);
    EXPECT_EQ(rows.touches(2 * k), contact[k].touching ? 1 : 0);
    const Vec3 velocity(walls.geometry[8][k], walls.geometry[9][k], walls.geometry[10][k]);
    const Vec3& spin = contact[k].j.spin;
    const Vec3 velocity_old(walls.geometry[14][k], walls.geometry[15][k], walls.geometry[16][k]);
    double work = 0.5 * step.dt * (before[k].force.dot(velocity_old) + r.force.dot(velocity));
    double error = velocity.norm() * (r.force_error + kEps<double> * before[k].force.norm());
    if (o.rolling) {
      work += 0.5 * step.dt * (before[k].moment + r.moment).dot(spin);
      error += spin.norm() * (r.moment_error + kEps<double> * before[k].moment.norm());
    }
    EXPECT_NEAR(walls.wall_work[k], work, kUnits * step.dt * error);
    EXPECT_NEAR(walls.energies[0][k], r.work, kUnits * r.work_error);
    EXPECT_NEAR(walls.energies[1][k], r.elastic, kUnits * r.elastic_error);
    EXPECT_NEAR(walls.energies[2][k], r.slide, kUnits * r.slide_error);
    EXPECT_NEAR(walls.energies[3][k], r.tangential_damping, kUnits * r.damping_error);
    const auto coefficients =
        twin::coefficients(step.law, tag_material(cases.traits[2 * k].tag), material[k]);
    expect_wear(step, cases.particles(), walls, k, coefficients.mu);
  }
  tally.expect(got, kEps<double>);
}

TYPED_TEST(KernelTwins, OfSphereFacetAgreeOnEveryTarget) {
  for_each_target<TypeParam>([](const std::string& target) {
    unsigned seed = 1;
    for (const CaseOptions& o : all_options()) {
      if (o.periodic) continue;  // walls do not ask
      for (std::size_t count = 1; count <= kMostContacts; ++count) {
        SCOPED_TRACE(target + ", " + test::name_of(o) + ", " + std::to_string(count));
        check_walls<TypeParam>(o, count, ++seed);
        if (testing::Test::HasFailure()) return;
      }
    }
  });
}

}  // namespace
}  // namespace quern
