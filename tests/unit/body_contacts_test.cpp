// The law kernels of polyhedra against their scalar f64 twins, on every SIMD target of this CPU, in
// both precisions: spheres near polyhedra (gathered, pushed, summed into the rows of the spheres)
// and contacts of polyhedra among themselves and with walls.
//
// All of the law is f64; in `mixed` the particles are rounded beforehand and histories are stored
// in f32, so that old springs and normals are right to that only (history_eps). Tolerances:
// kernel_checks.h; the largest error met is below 2 units.
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/body_cases.h"
#include "tests/support/trap_fp.h"

namespace quern::test {
namespace {

// A value that was stored as Real.
template <class Real>
void expect_stored(const char* what, const Vec3& got, const Vec3& expected, double error) {
  const double rounding = sizeof(Real) == 4 ? kEps<float> * expected.norm() : 0;
  EXPECT_LE((got - expected).norm(), kUnits * error + rounding)
      << what << ": " << got.transpose() << " for " << expected.transpose();
}

// Sums of the rows of the spheres beside what was there before.
template <class Real>
void expect_rows(const NearCases<Real>& cases, const Rows& before, const Rows& rows) {
  for (Index s = 0; s < cases.spheres(); ++s) {
    Vec3 force = before.force(s), torque = before.torque(s);
    double touches = before.touches(s), force_error = 0, torque_error = 0;
    for (std::size_t k = 0; k < cases.count; ++k) {
      if (cases.sphere[k] != NearCases<Real>::kFirst + s) continue;
      const twin::Response& r = cases.expected[k];
      force += r.force;
      torque += r.torque_i;
      touches += cases.contact[k].touching ? 1 : 0;
      force_error += r.force_error + kEps<double> * force.norm();
      torque_error += r.torque_error + kEps<double> * torque.norm();
    }
    expect_vector("row: force", rows.force(s), force, force_error);
    expect_vector("row: torque", rows.torque(s), torque, torque_error);
    EXPECT_EQ(rows.touches(s), touches);
  }
  // The idle sphere of the padding, and the row of other tiles' particles.
  for (std::size_t k = (cases.spheres() - 1) * kRowWidth; k < rows.rows.size(); ++k) {
    EXPECT_EQ(rows.rows[k], before.rows[k]);
  }
}

// What each group does to its polyhedron.
template <class Real>
void expect_sums(const NearCases<Real>& cases) {
  for (std::size_t first = 0; first < cases.count; first += cases.kGroup) {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    double touches = 0, force_error = 0, torque_error = 0;
    for (std::size_t k = first; k < std::min(cases.count, first + cases.kGroup); ++k) {
      const twin::Response& r = cases.expected[k];
      force -= r.force;
      torque += r.torque_j;
      touches += cases.contact[k].touching ? 1 : 0;
      force_error += r.force_error + kEps<double> * r.force.norm();
      torque_error += r.torque_error + kEps<double> * r.torque_j.norm();
    }
    expect_vector("force on polyhedron", cases.sum(0, first), force, force_error);
    expect_vector("torque on polyhedron", cases.sum(3, first), torque, torque_error);
    EXPECT_EQ(cases.sums_of[first][6], touches);
  }
}

void expect_told(const NearTold& told, const twin::Contact& c, const twin::Response& r) {
  EXPECT_NEAR(told.work, r.work, kUnits * r.work_error);
  EXPECT_NEAR(told.elastic, r.elastic, kUnits * r.elastic_error);
  EXPECT_NEAR(told.slide, r.slide, kUnits * r.slide_error);
  EXPECT_NEAR(told.tangential_damping, r.tangential_damping, kUnits * r.damping_error);
  EXPECT_EQ(told.overlap_old > 0, c.overlap_old > 0);
  EXPECT_GE(told.impact, told.approach * (1 - 1e-12));
}

template <class Real>
void check_near(NearCases<Real>& cases, unsigned seed) {
  Rows before(cases.spheres()), rows(cases.spheres());
  Random random(seed);
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    before.rows[k] = rows.rows[k] = k % kRowWidth < 6 ? random(-10, 10) : 3;
  }
  TallyTwin tally;
  tally.cap = cases.cap;
  for (std::size_t k = 0; k < cases.count; ++k) tally.add(cases.contact[k], cases.expected[k]);
  ContactTally got;
  std::vector<NearTold> told(padded(cases.count));
  NearContacts<Real> contacts = cases.view();
  contacts.told = told.data();
  for (std::size_t k = 0; k < cases.count; ++k) cases.history_of[k][13] = Real(k + 1);
  choose_kernels<Real>(cases.step.law.kind)
      .push_spheres(cases.step, cases.particles(), contacts,
                    rows.tile(cases.kFirst, cases.spheres()), got);
  for (std::size_t k = 0; k < cases.count; ++k) {
    const twin::Response& r = cases.expected[k];
    const twin::Contact& c = cases.contact[k];
    expect_stored<Real>("spring", cases.stored(0, k), r.spring, r.spring_error);
    expect_stored<Real>("force", cases.stored(3, k), r.force, r.force_error);
    const double open = c.touching ? 1 : 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto e = static_cast<Eigen::Index>(a);
      EXPECT_EQ(cases.history_of[k][6 + a], static_cast<Real>(open * c.normal[e]));
      EXPECT_EQ(cases.history_of[k][10 + a], static_cast<Real>(open * c.j.lever[e]));
    }
    EXPECT_EQ(cases.history_of[k][9], static_cast<Real>(open * c.overlap));
    EXPECT_EQ(cases.history_of[k][13], Real(k + 1)) << "an episode is left to who records it";
    expect_told(told[k], c, r);
  }
  expect_sums(cases);
  expect_rows(cases, before, rows);
  tally.expect(got, kEps<double>);
  EXPECT_GE(cases.odd, cases.all) << "all is finite";
  for (std::size_t k = cases.count; k < cases.all; ++k) {
    const double idle = k < padded(cases.count) ? 0 : kUntouched;
    for (std::size_t h = 0; h < cases.kHistory; ++h) {
      EXPECT_EQ(cases.history_of[k][h], static_cast<Real>(idle));
    }
    for (std::size_t h = 0; h < cases.kSums; ++h) EXPECT_EQ(cases.sums_of[k][h], idle);
  }
}

constexpr double kCaps[] = {0, 3e-5};  // m

template <class Real>
class BodyTwins : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(BodyTwins, Precisions);

TYPED_TEST(BodyTwins, OfSpheresNearPolyhedraAgreeOnEveryTarget) {
  for_each_target<TypeParam>([](const std::string& target) {
    unsigned seed = 1;
    for (const CaseOptions& o : body_options()) {
      for (const double cap : kCaps) {
        for (std::size_t count = 1; count <= kMostBodyContacts; ++count) {
          SCOPED_TRACE(target + ", " + name_of(o) + ", cap " + std::to_string(cap) + ", " +
                       std::to_string(count));
          NearCases<TypeParam> cases(o, cap, count, ++seed);
          check_near(cases, seed);
          if (testing::Test::HasFailure()) return;
        }
      }
    }
  });
}

// The tests are worth what their cases are: all of these must occur among them.
TEST(BodyCases, CoverEveryStateOfAContact) {
  int fresh = 0, held = 0, slid = 0, lost = 0, pulling = 0, capped = 0, warned = 0;
  unsigned seed = 1;
  for (const CaseOptions& o : body_options()) {
    for (const double cap : kCaps) {
      const NearCases<double> cases(o, cap, 200, ++seed);
      for (std::size_t k = 0; k < cases.count; ++k) {
        const twin::Contact& c = cases.contact[k];
        const twin::Response& r = cases.expected[k];
        fresh += r.fresh;
        held += c.touching && !r.fresh && !r.slides;
        slid += c.touching && !r.fresh && r.slides;
        lost += !c.touching;
        pulling += c.touching && r.force.dot(c.normal) < 0;
        capped += cap > 0 && c.overlap > cap;
        warned += c.overlap > 0.5 * c.i.radius;
      }
    }
  }
  for (const int seen : {fresh, held, slid, lost, pulling, capped, warned}) EXPECT_GT(seen, 5);
}

// The place of a sphere from the polyhedron's: f64 differences, to a rounding of the nearest image.
TYPED_TEST(BodyTwins, OfGatheredSpheresAreTheNearestImages) {
  using Real = TypeParam;
  for_each_target<Real>([](const std::string& target) {
    unsigned seed = 1;
    for (int axes = 0; axes < 8; ++axes) {
      for (std::size_t count = 1; count <= kMostBodyContacts; ++count) {
        SCOPED_TRACE(target + ", periodic axes " + std::to_string(axes) + ", " +
                     std::to_string(count));
        NearCases<Real> cases({}, 0, 2 * kMostBodyContacts, ++seed);
        for (int a = 0; a < 3; ++a) {
          if ((axes >> a & 1) == 0) continue;
          cases.step.period[a] = 0.7 + 0.2 * a;
          cases.step.inverse_period[a] = 1 / cases.step.period[a];
        }
        Random random(seed);
        const Vec3 from = random.in_cube(4);
        Column<double> lane[4];
        for (Column<double>& column : lane) {
          column.reset(padded(count) + kShapePad);
          column.fill(kUntouched);
        }
        GroupLanes lanes{};
        for (int a = 0; a < 3; ++a) lanes.center[a] = lane[a].data();
        lanes.radius = lane[3].data();
        for (std::size_t k = count; k < padded(count); ++k) cases.sphere[k] = cases.sphere[0];
        choose_kernels<Real>().gather_spheres(cases.step, cases.particles(), from,
                                              cases.sphere.data(), count, lanes);
        for (std::size_t k = 0; k < count; ++k) {
          const Record<Real>& r = cases.record[cases.sphere[k]];
          const Vec3 dx = Vec3(r.x, r.y, r.z) - from;
          for (int a = 0; a < 3; ++a) {
            const double period = cases.step.period[a];
            const double nearest = period > 0 ? std::remainder(dx[a], period) : dx[a];
            const double rounding = period > 0 ? kEps<double> * std::abs(dx[a]) : 0;
            EXPECT_NEAR(lane[a][k], nearest, rounding);
          }
          EXPECT_EQ(lane[3][k], static_cast<double>(r.radius));
        }
        for (const Column<double>& column : lane) EXPECT_EQ(column[padded(count)], kUntouched);
      }
    }
  });
}

void check_bodies(BodyCases& cases) {
  using B = BodyContacts;
  for (std::size_t k = 0; k < cases.count; ++k) {
    const twin::Response& r = cases.expected[k];
    expect_vector("spring", cases.vector(B::kSpring, k), r.spring, r.spring_error);
    expect_vector("force", cases.vector(B::kForce, k), r.force, r.force_error);
    const auto near = [&](int row, double value, double error) {
      EXPECT_NEAR(cases.number(row, k), value, kUnits * error) << "row " << row;
    };
    near(B::kWork, r.work, r.work_error);
    near(B::kElastic, r.elastic, r.elastic_error);
    near(B::kSlide, r.slide, r.slide_error);
    near(B::kTangentialDamping, r.tangential_damping, r.damping_error);
    near(B::kNumericalLoss, r.numerical_loss, r.loss_error);
    near(B::kModelWork, r.model_work, r.model_error);
    near(B::kReduction, r.reduction, kEps<double>);
    near(B::kNormalForce, r.force.dot(cases.contact[k].normal), r.force_error);
  }
  for (std::size_t k = cases.count; k < cases.stride; ++k) {
    const double idle = k < padded(cases.count) ? 0 : kUntouched;
    for (int row = B::kSpring; row < B::kRows; ++row) {
      if (row == B::kReduction && k < padded(cases.count)) continue;
      EXPECT_EQ(cases.number(row, k), idle) << "row " << row << ", lane " << k;
    }
  }
}

TYPED_TEST(BodyTwins, OfPolyhedraAndWallsAgreeOnEveryTarget) {
  for_each_target<TypeParam>([](const std::string& target) {
    unsigned seed = 1000;
    for (const CaseOptions& o : body_options()) {
      for (int round = 0; round < 2; ++round) {
        for (std::size_t count = 1; count <= kMostBodyContacts; ++count) {
          SCOPED_TRACE(target + ", " + name_of(o) + ", " + std::to_string(count));
          BodyCases cases(o, count, ++seed);
          const std::vector<double> input(cases.numbers.begin(), cases.numbers.end());
          choose_kernels<TypeParam>(cases.step.law.kind).push_bodies(cases.step, cases.view());
          check_bodies(cases);
          for (std::size_t k = 0; k < BodyContacts::kSpring * cases.stride; ++k) {
            EXPECT_EQ(cases.numbers[k], input[k]);
          }
          if (testing::Test::HasFailure()) return;
        }
      }
    }
  });
}

}  // namespace
}  // namespace quern::test
