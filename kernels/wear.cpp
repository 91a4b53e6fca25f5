#include "kernels/wear.h"

#include <cmath>
#include <limits>

#include "soa/facet_closest.h"

namespace quern {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// m v^2 times Finnie's function of the angle, of the velocity's two parts.
double finnie_energy(double mass, double in, double along, double force_ratio) {
  if (!(in > 0)) return 0;
  if (6 * in < force_ratio * along) return mass * (2 * in * along - 6 / force_ratio * in * in);
  return mass * force_ratio * along * along / 6;
}

Index nearest_facet(const Facets& facets, Index wall, const Vec3& x, double reach,
                    std::vector<Index>& near) {
  near.clear();
  find_facets(facets, x, reach, near);
  Index nearest = kNoIndex;
  double least = HUGE_VAL;
  for (const Index t : near) {
    if (facets.record[t].wall != wall) continue;
    const double distance2 = closest_on_facet(facets.record[t], x).distance2;
    if (distance2 >= least) continue;
    least = distance2;
    nearest = t;
  }
  return nearest;
}

Vec3 in_body(const Body& body, const Vec3& point) {
  return body.pose.rotation.transpose() * (point - body.pose.shift);
}

// Of the contact of a lane whose cell is not known; kNoIndex without a facet.
template <class Real>
Index find_cell(const World<Real>& world, const WallLanes& lanes, std::size_t k, Index particle,
                std::vector<Index>& near) {
  const Index wall = lanes.wall(k), on = world.walls[wall].body;
  const Vec3 x = in_body(world.bodies[on], lanes.point(k));
  Index facet = lanes.facet(k);
  if (facet == kNoIndex) {
    const double reach = static_cast<double>(world.particles.record[particle].radius);
    facet = nearest_facet(world.bodies[on].facets, wall, x, reach, near);
  }
  return facet == kNoIndex ? kNoIndex : world.wear.grids[on].cell_at(facet, x);
}

}  // namespace

WearRow wear_of(const WearContact& c, double dt, double force_ratio) noexcept {
  WearRow sum{};
  sum[kSlidingEnergy] = c.slide;
  if (!c.touching) return sum;
  const double push = c.normal.dot(c.force), in = -c.normal.dot(c.velocity);
  const Vec3 friction = c.force - push * c.normal;
  const Vec3 along = c.at_point - c.normal.dot(c.at_point) * c.normal;
  const double power = friction.dot(along), size = friction.norm();
  if (power < 0 && friction.dot(c.braked) < 0) sum[kSiemEnergy] = -dt * power;
  if (push > 0 && size >= kAtTheCone * c.friction * push) {
    sum[kArchardWork] = push * along.norm() * dt;
  }
  if (c.first_touch) {
    const double speed_along = (c.velocity + in * c.normal).norm();
    sum[kFinnieEnergy] = finnie_energy(c.mass, in, speed_along, force_ratio);
  }
  sum[kNormalImpulse] = push * dt;
  sum[kShearImpulse] = size * dt;
  return sum;
}

double flow_pressure_of(const WearSpec& wear, const Material& material) {
  if (wear.flow_pressure) return *wear.flow_pressure;
  return material.hardness > 0 ? 1.5 * kVickers * material.hardness : kUnknown;
}

WearRow wear_factors(const WearSpec& wear, const Material& material) {
  const double p = flow_pressure_of(wear, material);
  const double hardness = material.hardness > 0 ? kVickers * material.hardness : p / 1.5;
  const double k = wear.archard_coefficient > 0 ? wear.archard_coefficient : kUnknown;
  WearRow factor;
  factor[kSiemEnergy] = wear.siem_factor / (4 * p);
  factor[kSlidingEnergy] = wear.siem_factor / (4 * p);
  factor[kArchardWork] = wear.archard_factor * k / hardness;
  factor[kFinnieEnergy] =
      wear.finnie_factor / (p * wear.finnie_depth_ratio * wear.finnie_force_ratio);
  factor[kNormalImpulse] = factor[kShearImpulse] = 1;
  return factor;
}

template <class Real>
void add_wear(const World<Real>& world, const WearContact& contact, Index wall, const Vec3& point,
              double reach, std::uint16_t species, WearList& list) {
  if (!contact.touching && contact.slide == 0) return;
  const Index on = world.walls[wall].body;
  const Vec3 x = in_body(world.bodies[on], point);
  const Index facet = nearest_facet(world.bodies[on].facets, wall, x, reach, list.near);
  if (facet == kNoIndex) return;
  list.entries.push_back({world.wear.grids[on].cell_at(facet, x), static_cast<std::uint16_t>(wall),
                          species,
                          wear_of(contact, world.clock.dt, world.wear.finnie_force_ratio)});
}

template <class Real>
void list_wear(const World<Real>& world, const WallContacts& contacts, const WallLanes& lanes,
               WearList& list) {
  list.entries.resize(lanes.size());
  WearEntry* entry = list.entries.data();
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    if (!lanes.is_open(k) && contacts.wear[kSlidingEnergy][k] == 0) continue;
    const Index particle = contacts.particle[k];
    Index cell = lanes.wear_cell(k);
    if (cell == kNoIndex) cell = find_cell(world, lanes, k, particle, list.near);
    if (cell == kNoIndex) continue;
    entry->cell = cell;
    entry->wall = static_cast<std::uint16_t>(lanes.wall(k));
    entry->species = world.particles.species[particle];
    for (std::size_t sum = 0; sum < kWearSums; ++sum) entry->sum[sum] = contacts.wear[sum][k];
    ++entry;
  }
  list.entries.resize(static_cast<std::size_t>(entry - list.entries.data()));
}

template void add_wear(const World<float>&, const WearContact&, Index, const Vec3&, double,
                       std::uint16_t, WearList&);
template void add_wear(const World<double>&, const WearContact&, Index, const Vec3&, double,
                       std::uint16_t, WearList&);
template void list_wear(const World<float>&, const WallContacts&, const WallLanes&, WearList&);
template void list_wear(const World<double>&, const WallContacts&, const WallLanes&, WearList&);

}  // namespace quern
