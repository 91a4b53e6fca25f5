// The leapfrog kernel against its scalar twin, on every SIMD target of this CPU, in both
// precisions.
//
// All of it is f64. Tolerances: at most ten roundings stand between input and result, so 10 units
// in the last place of the magnitudes that are added; sums over a tile have as many terms as
// particles.
#include <gtest/gtest.h>

#include <limits>

#include "kernels/contact.h"
#include "tests/support/contact_cases.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

constexpr double kUlps = 10 * std::numeric_limits<double>::epsilon();
constexpr std::size_t kFirst = 3;  // of the tile; a tile need not begin at a multiple of a vector

// Of `single`; periodic in y, beyond which most of the crowd is.
const PlaceGrid kGrid(Vec3(-4, -0.5, -4), Vec3(4, 0.5, 4), {false, true, false}, 0.05);
constexpr GridPlace kUnwritten = {1, 2, 3, 4};

bool same(const GridPlace& a, const GridPlace& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.radius == b.radius;
}

template <class Real>
struct Crowd {
  Column<Record<Real>> now, next;
  Column<Traits<Real>> traits, traits_next;
  Column<double> spin[3], place[3], rows;
  Column<float> velocity[3], rest[3], allowance;
  Column<GridPlace> on_grid;
  std::size_t size;

  Crowd(std::size_t count, unsigned seed) : size(count) {
    test::Random random(seed);
    const std::size_t n = kFirst + count + 2;  // neighbours in other tiles on both sides
    now.reset(n);
    next.reset(n);
    traits.reset(n);
    traits_next.reset(n);
    traits_next.fill({});
    for (int a = 0; a < 3; ++a) {
      spin[a].reset(n);
      place[a].reset(n);
      velocity[a].reset(n);
      rest[a].reset(n);
    }
    allowance.reset(n);
    on_grid.reset(n);
    for (GridPlace& p : on_grid) p = kUnwritten;
    rows.reset((count + 16) * kRowWidth);
    for (double& r : rows) r = random(-10, 10);
    for (std::size_t k = 0; k < n; ++k) {
      const Vec3 x = random.in_cube(4), v = random.in_cube(5), w = random.in_cube(50);
      now[k] = test::record_of<Real>(x, v, w, random(0.005, 0.05));
      next[k] = now[k];
      allowance[k] = static_cast<float>(random(0, 8e-3));
      traits[k].inverse_mass = static_cast<Real>(1 / random(0.01, 5));
      traits[k].tag = make_tag(static_cast<std::uint32_t>(random.below(5)), 77);
      for (int a = 0; a < 3; ++a) {
        spin[a][k] = w[a];
        place[a][k] = x[a] - 0.1 * v[a] + random(-1e-3, 1e-3);
        velocity[a][k] = static_cast<float>(v[a]);
        rest[a][k] = static_cast<float>(random(-1e-6, 1e-6));  // far more than a rounding
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      rows[k * kRowWidth + 6] = static_cast<double>(random.below(20));
    }
  }

  MoveView<Real> view(double dt) {
    MoveView<Real> m{};
    m.now = now.data();
    m.next = next.data();
    m.traits_now = traits.data();
    m.traits_next = traits_next.data();
    for (int a = 0; a < 3; ++a) {
      m.spin[a] = spin[a].data();
      m.rest[a] = rest[a].data();
      m.list_place[a] = place[a].data();
      m.list_velocity[a] = velocity[a].data();
      m.gravity[a] = a == 1 ? -9.81 : 0.3;
      m.low[a] = -3;
      m.high[a] = a == 2 ? 1e30 : 3;
    }
    m.list_allowance = allowance.data();
    m.list_time = 0.1;
    m.kick = 0.5 * dt;
    m.drag = 0.999;
    m.on_grid_next = on_grid.data();
    m.grid = &kGrid;
    return m;
  }
};

// Whether a row of the world outside the tile is untouched.
template <class Real>
bool is_kept(const Crowd<Real>& crowd, std::size_t k) {
  return std::memcmp(&crowd.next[k], &crowd.now[k], sizeof(Record<Real>)) == 0 &&
         crowd.traits_next[k].tag == 0;
}

template <class Real>
void check_move(std::size_t count, unsigned seed) {
  constexpr double dt = 1e-3;
  Crowd<Real> crowd(count, seed);
  const MoveView<Real> view = crowd.view(dt);
  std::vector<twin::Moved> expected;
  MoveTally sum, scale;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = kFirst + k;
    expected.push_back(twin::move_sphere(view, at, crowd.rows.data() + k * kRowWidth, dt));
    const twin::Moved& e = expected.back();
    const double mass = 1 / static_cast<double>(crowd.traits[at].inverse_mass);
    const Record<Real>& r = crowd.now[at];
    sum.translational += e.translational;
    scale.translational += mass * (5 + e.velocity.norm()) * (5 + e.velocity.norm());
    sum.rotational += e.rotational;
    const double turned = 100 + e.spin.norm();
    scale.rotational += mass * 1e-2 * turned * turned;
    sum.drag_loss += e.drag_loss;
    sum.momentum[1] += mass * r.vy;
    scale.momentum[1] += mass * 5;
    sum.moment_of_mass[2] += mass * r.z;
    scale.moment_of_mass[2] += mass * 4;
    sum.max_deviation2 = std::max(sum.max_deviation2, e.deviation2);
    const double allowed = static_cast<double>(crowd.allowance[at]);
    sum.strays += e.deviation2 > allowed * allowed;
    sum.fast += dt * e.velocity.norm() > static_cast<double>(r.radius);
    sum.bad += std::abs(e.place.x()) > 3 || std::abs(e.place.y()) > 3 || e.place.z() < -3;
  }
  MoveTally got;
  choose_kernels<Real>().move(
      view, {crowd.rows.data(), static_cast<Index>(kFirst), static_cast<Index>(count)}, dt, got);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = kFirst + k;
    const Record<Real>& r = crowd.next[at];
    const twin::Moved& e = expected[k];
    // Places within 4 m, velocities within some 10 m/s + kicks of 5 m/s.
    EXPECT_LE((Vec3(r.x, r.y, r.z) - e.place).norm(), kUlps * 8);
    EXPECT_LE((Vec3(r.vx, r.vy, r.vz) - e.velocity).norm(), kUlps * (10 + e.velocity.norm()));
    const Vec3 spin(crowd.spin[0][at], crowd.spin[1][at], crowd.spin[2][at]);
    EXPECT_LE((spin - e.spin).norm(), kUlps * (100 + e.spin.norm()));
    EXPECT_EQ(r.wx, static_cast<Real>(spin.x()));
    EXPECT_EQ(r.wy, static_cast<Real>(spin.y()));
    EXPECT_EQ(r.wz, static_cast<Real>(spin.z()));
    EXPECT_EQ(r.radius, crowd.now[at].radius);
    EXPECT_EQ(tag_material(crowd.traits_next[at].tag), tag_material(crowd.traits[at].tag));
    EXPECT_EQ(tag_contacts(crowd.traits_next[at].tag), crowd.rows[k * kRowWidth + 6]);
  }
  for (std::size_t k = 0; k < crowd.now.size(); ++k) {
    const Record<Real>& r = crowd.next[k];
    const bool own = k >= kFirst && k < kFirst + count;
    EXPECT_TRUE(same(crowd.on_grid[k],
                     own ? kGrid.at(r.x, r.y, r.z, static_cast<float>(r.radius)) : kUnwritten));
  }
  for (std::size_t k = 0; k < kFirst; ++k) EXPECT_TRUE(is_kept(crowd, k));
  for (std::size_t k = kFirst + count; k < crowd.now.size(); ++k) EXPECT_TRUE(is_kept(crowd, k));
  EXPECT_NEAR(got.translational, sum.translational, kUlps * scale.translational);
  EXPECT_NEAR(got.rotational, sum.rotational, kUlps * scale.rotational);
  EXPECT_NEAR(got.drag_loss, sum.drag_loss, kUlps * (scale.translational + scale.rotational));
  EXPECT_NEAR(got.momentum[1], sum.momentum[1], kUlps * scale.momentum[1]);
  EXPECT_NEAR(got.moment_of_mass[2], sum.moment_of_mass[2], kUlps * scale.moment_of_mass[2]);
  EXPECT_NEAR(got.max_deviation2, sum.max_deviation2, kUlps * 10);
  EXPECT_EQ(got.strays, sum.strays);
  EXPECT_EQ(got.bad, sum.bad);
  EXPECT_EQ(got.fast, sum.fast);
}

template <class Real>
class MoveTwin : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(MoveTwin, Precisions);

TYPED_TEST(MoveTwin, AgreesOnEveryTargetAndWritesItsOwnTileOnly) {
  test::for_each_target<TypeParam>([](const std::string& target) {
    for (std::size_t count = 1; count <= 25; ++count) {
      for (unsigned seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(target + ", " + std::to_string(count) + " particles, seed " +
                     std::to_string(seed));
        check_move<TypeParam>(count, seed);
      }
    }
  });
}

// Of a tenth of a last place of where they are a step: added to the place alone it would be lost.
TYPED_TEST(MoveTwin, LosesNothingOfASlowMotion) {
  test::for_each_target<TypeParam>([](const std::string& target) {
    SCOPED_TRACE(target);
    constexpr double kPlace = 3, dt = 1e-5, kWay = 4e-17;
    constexpr std::size_t kCount = 3;
    Crowd<TypeParam> crowd(kCount, 1);
    crowd.rows.fill(0);
    for (std::size_t at = 0; at < crowd.now.size(); ++at) {
      crowd.now[at] = test::record_of<TypeParam>(Vec3::Constant(kPlace), Vec3::Constant(kWay / dt),
                                                 Vec3::Zero(), 0.01);
      for (auto& rest : crowd.rest) rest[at] = 0;
    }
    constexpr int kSteps = 1000;
    for (int k = 0; k < kSteps; ++k) {
      MoveView<TypeParam> view = crowd.view(dt);
      view.drag = 1;
      for (double& g : view.gravity) g = 0;
      MoveTally tally;
      choose_kernels<TypeParam>().move(
          view, {crowd.rows.data(), static_cast<Index>(kFirst), static_cast<Index>(kCount)}, dt,
          tally);
      std::copy_n(crowd.next.data() + kFirst, kCount, crowd.now.data() + kFirst);
    }
    for (std::size_t at = kFirst; at < kFirst + kCount; ++at) {
      const Record<TypeParam>& r = crowd.now[at];
      const double place[3] = {r.x, r.y, r.z};
      for (std::size_t a = 0; a < 3; ++a) {
        const double way = place[a] - kPlace + static_cast<double>(crowd.rest[a][at]);
        EXPECT_NEAR(way / (kSteps * kWay), 1, 1e-6);
      }
    }
  });
}

}  // namespace
}  // namespace quern
