// Sums by size class and zone against the plain way: every particle asked by itself.
#include "kernels/class_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "soa/size_classes.h"

namespace quern {
namespace {

constexpr double kDegree = kPi / 180;

ZoneSpec zone_of(double radius_from, std::optional<double> radius_to, double from, double to) {
  return {"zone", radius_from, radius_to, from * kDegree, to * kDegree};
}

struct Charge {
  ParticleFrame frame;
  EnergyFrame energy;
};

Charge random_charge(std::size_t n, std::size_t classes) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  Charge c;
  for (std::size_t k = 0; k < n; ++k) {
    for (int a = 0; a < 3; ++a) {
      c.frame.position.push_back(anywhere(random));
      c.frame.velocity.push_back(static_cast<float>(anywhere(random)));
      c.frame.spin.push_back(static_cast<float>(anywhere(random)));
    }
    c.frame.radius.push_back(0.01F);
    c.frame.size_class.push_back(static_cast<std::uint16_t>(random() % classes));
    c.energy.mass.push_back(1.5 + anywhere(random));
    c.energy.rotational_energy.push_back(1.5 + anywhere(random));
  }
  c.frame.size_class[0] = SizeClasses::kUnknown;
  return c;
}

// The zone's words in degrees, one after the other.
bool plainly_inside(double from, double to, double low, double high, double x, double y) {
  double angle = std::atan2(y, x) / kDegree;
  if (angle < 0) angle += 360;
  const double radius = std::sqrt(x * x + y * y);
  const bool within = from < to ? angle >= from && angle < to : angle >= from || angle < to;
  return within && radius >= low && radius < high;
}

TEST(ClassSums, OfAZoneAreThoseOfTheParticlesInIt) {
  constexpr std::size_t kClasses = 3;
  const Charge c = random_charge(3000, kClasses);
  struct Case {
    double from, to, low, high;
  };
  for (const Case& zone : {Case{205, 245, 0.7, 9}, Case{330, 30, 0.2, 0.8}, Case{0, 90, 0, 0.5}}) {
    const ZoneSpec spec = zone_of(zone.low, zone.high, zone.from, zone.to);
    const ClassSums found = sum_classes(c.frame, c.energy, kClasses, &spec);
    for (std::size_t row = 0; row < kClasses; ++row) {
      double count = 0, spin = 0, kinetic = 0, rotational = 0;
      for (std::size_t i = 0; i < c.frame.radius.size(); ++i) {
        if (c.frame.size_class[i] != row) continue;
        if (!plainly_inside(zone.from, zone.to, zone.low, zone.high, c.frame.position[3 * i],
                            c.frame.position[3 * i + 1]))
          continue;
        const Eigen::Vector3f v(&c.frame.velocity[3 * i]), w(&c.frame.spin[3 * i]);
        count += 1;
        spin += w.cast<double>().norm();
        kinetic += 0.5 * c.energy.mass[i] * v.cast<double>().squaredNorm();
        rotational += c.energy.rotational_energy[i];
      }
      EXPECT_GT(count, 10);
      EXPECT_EQ(found.count[row], count);
      EXPECT_NEAR(found.spin[row], spin, 1e-12 * spin);
      EXPECT_NEAR(found.kinetic_energy[row], kinetic, 1e-12 * kinetic);
      EXPECT_NEAR(found.rotational_energy[row], rotational, 1e-12 * rotational);
    }
  }
}

TEST(ClassSums, CountEachParticleOfAClassOnce) {
  const Charge c = random_charge(500, 4);
  const ClassSums all = sum_classes(c.frame, c.energy, 4, nullptr);
  EXPECT_EQ(all.count[0] + all.count[1] + all.count[2] + all.count[3], 499);  // one has no class
  // Zones that share the mill share its particles.
  const ZoneSpec parts[] = {zone_of(0, 0.5, 0, 360), zone_of(0.5, {}, -90, 90),
                            zone_of(0.5, {}, 90, 270)};
  for (std::size_t row = 0; row < 4; ++row) {
    double count = 0;
    for (const ZoneSpec& part : parts) count += sum_classes(c.frame, c.energy, 4, &part).count[row];
    EXPECT_EQ(count, all.count[row]);
  }
}

TEST(Zone, HoldsItsLowerBoundsAndWrapsAround) {
  const ZoneSpec zone = zone_of(1, 2, 0, 90);
  EXPECT_TRUE(inside(zone, 1, 0));
  EXPECT_FALSE(inside(zone, 2, 0));
  EXPECT_FALSE(inside(zone, 0, 1.5));
  const ZoneSpec wrapped = zone_of(0, {}, 300, 400);
  EXPECT_TRUE(inside(wrapped, 1, 0.5));
  EXPECT_TRUE(inside(wrapped, 1, -1));
  EXPECT_FALSE(inside(wrapped, 0, 1));
  const ZoneSpec turned = zone_of(0, {}, 300, 40);
  EXPECT_TRUE(inside(turned, 1, 0.5));
  EXPECT_FALSE(inside(turned, -1, 0));
  const ZoneSpec whole = zone_of(0, {}, -180, 180);
  for (int degree = 0; degree < 360; degree += 45)
    EXPECT_TRUE(inside(whole, std::cos(degree * kDegree), std::sin(degree * kDegree)));
}

}  // namespace
}  // namespace quern
