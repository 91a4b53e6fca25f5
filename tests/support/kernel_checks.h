// What the tests of contact kernels share: rows of a tile, sums of twins, comparisons.
//
// Tolerances: the twin gives, beside each value, what an error of one unit in the last place in
// every intermediate result amounts to (sums of magnitudes, before any cancellation). The longest
// chain, of the tangential force, has some 45 roundings of half a unit each; 24 units cover all of
// them in the worst case.
#pragma once

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/contact_cases.h"

namespace quern::test {

inline constexpr double kUnits = 24;

template <class Real>
constexpr double kEps = static_cast<double>(std::numeric_limits<Real>::epsilon());

// Accumulator rows of a tile.
struct Rows {
  Column<double> rows;
  explicit Rows(std::size_t particles) {
    rows.reset((particles + 16) * kRowWidth);
    rows.fill(0);
  }
  TileRows tile(Index first, Index size) { return {rows.data(), first, size}; }
  Vec3 force(std::size_t row) const { return at(row, 0); }
  Vec3 torque(std::size_t row) const { return at(row, 3); }
  double touches(std::size_t row) const { return rows[row * kRowWidth + 6]; }

 private:
  Vec3 at(std::size_t row, std::size_t k) const {
    const double* r = rows.data() + row * kRowWidth + k;
    return {r[0], r[1], r[2]};
  }
};

// Sums of the twins, and of their errors.
struct TallyTwin {
  ContactTally sum, error;
  double cap = 0;  // m; 0: none. Deep is what is beyond it, else beyond half a radius
  void add(const twin::Contact& c, const twin::Response& r) {
    sum.work += r.work;
    error.work += r.work_error;
    sum.elastic += r.elastic;
    error.elastic += r.elastic_error;
    sum.slide += r.slide;
    error.slide += r.slide_error;
    sum.tangential_damping += r.tangential_damping;
    error.tangential_damping += r.damping_error;
    sum.numerical_loss += r.numerical_loss;
    error.numerical_loss += r.loss_error;
    sum.model_work += r.model_work;
    error.model_work += r.model_error;
    const double depth = c.overlap / c.least_radius();
    sum.contacts += c.touching ? 1 : 0;
    const double deep = cap > 0 ? cap : 0.5 * c.least_radius();
    sum.warnings += c.touching && c.overlap > deep ? 1 : 0;
    sum.max_overlap = std::max(sum.max_overlap, depth);
  }
  void expect(const ContactTally& got, double eps) const {
    EXPECT_NEAR(got.work, sum.work, kUnits * error.work);
    EXPECT_NEAR(got.elastic, sum.elastic, kUnits * error.elastic);
    EXPECT_NEAR(got.slide, sum.slide, kUnits * error.slide);
    EXPECT_NEAR(got.tangential_damping, sum.tangential_damping, kUnits * error.tangential_damping);
    EXPECT_NEAR(got.numerical_loss, sum.numerical_loss, kUnits * error.numerical_loss);
    EXPECT_NEAR(got.model_work, sum.model_work, kUnits * error.model_work);
    EXPECT_EQ(got.contacts, sum.contacts);
    EXPECT_EQ(got.warnings, sum.warnings);
    // Overlap over radius; the overlap is a difference of lengths some 5 radii long.
    EXPECT_NEAR(got.max_overlap, sum.max_overlap, kUnits * (eps * sum.max_overlap + 1e-14));
  }
};

inline void expect_vector(const char* what, const Vec3& got, const Vec3& expected, double error) {
  EXPECT_LE((got - expected).norm(), kUnits * error)
      << what << ": " << got.transpose() << " for " << expected.transpose();
}

}  // namespace quern::test
