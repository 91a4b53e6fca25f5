#include "scheduler/not_finite.h"

#include <cmath>
#include <type_traits>

namespace quern {

namespace {

template <class T>
bool is_odd(const T& value) {
  if constexpr (std::is_floating_point_v<T>) return !std::isfinite(value);
  return false;
}
template <class Real>
bool is_odd(const Record<Real>& r) {
  const double places = r.x + r.y + r.z + r.vx + r.vy + r.vz;
  return !std::isfinite(places) || is_odd(r.radius) || !std::isfinite(r.wx + r.wy + r.wz);
}
template <class Real>
bool is_odd(const Traits<Real>& traits) {
  return is_odd(traits.inverse_mass);
}
bool is_odd(const BodyNow& b) {
  const BodyState& s = b.state;
  const double numbers = s.inverse_mass + s.mobility + s.radius + b.orientation.coeffs().sum();
  return !s.place.allFinite() || !s.velocity.allFinite() || !s.spin.allFinite() ||
         !std::isfinite(numbers);
}

template <class Columns>
bool has_odd_line(const Columns& p, std::size_t k) {
  return !std::isfinite(p.list_x[k] + p.list_y[k] + p.list_z[k]) ||
         !std::isfinite(p.list_vx[k] + p.list_vy[k] + p.list_vz[k]) || is_odd(p.list_allowance[k]);
}

template <class Real>
bool has_odd_column(const Particles<Real>& p, std::size_t k) {
  bool odd = false;
#define QUERN_LOOK(type, name, unit, doc) odd = odd || is_odd(p.name[k]);
  QUERN_PARTICLE_FIELDS(QUERN_LOOK)
#undef QUERN_LOOK
  return odd;
}

template <class Real>
bool has_odd_column(const Polyhedra<Real>& p, std::size_t k) {
  bool odd = false;
#define QUERN_LOOK(type, name, unit, doc) odd = odd || is_odd(p.name[k]);
  QUERN_POLYHEDRON_FIELDS(QUERN_LOOK)
#undef QUERN_LOOK
  return odd;
}

// What no step writes.
template <class Real>
bool has_odd_constant(const Polyhedra<Real>& p, std::size_t k) {
  const double of_lists = p.list_qw[k] + p.list_qx[k] + p.list_qy[k] + p.list_qz[k];
  return has_odd_line(p, k) || is_odd(p.list_turn[k]) || !std::isfinite(of_lists) ||
         !std::isfinite(p.scale[k] + p.inverse_mass[k]) || !p.inverse_inertia(k).allFinite();
}

template <class Real, class Odd>
bool find_sphere(const World<Real>& world, const Odd& odd, Offender& found) {
  const Particles<Real>& p = world.particles;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p.id[k] >= found.id || !odd(k)) continue;
    found.id = p.id[k];
    found.position = {p.record[k].x, p.record[k].y, p.record[k].z};
  }
  return found.id != kNoIndex;
}

template <class Real, class Odd>
bool find_body(const World<Real>& world, const Odd& odd, Offender& found) {
  const Polyhedra<Real>& p = world.polyhedra;
  for (std::size_t k = 0; k < p.size() && found.id == kNoIndex; ++k) {
    if (!odd(k)) continue;
    found.id = p.first_id + static_cast<Index>(k);
    found.position = {p.x[k], p.y[k], p.z[k]};
  }
  return found.id != kNoIndex;
}

}  // namespace

template <class Real>
Offender find_not_finite(const World<Real>& world, const BeforeStep<Real>& before) {
  const Particles<Real>& p = world.particles;
  const Polyhedra<Real>& b = world.polyhedra;
  Offender found;
  const auto sphere_before = [&](std::size_t k) {
    return is_odd((*before.records)[k]) || is_odd((*before.traits)[k]) || has_odd_line(p, k);
  };
  const auto body_before = [&](std::size_t k) {
    return has_odd_constant(b, k) || (before.bodies && is_odd(before.bodies->body[k]));
  };
  if (find_sphere(world, sphere_before, found) || find_body(world, body_before, found)) {
    return found;
  }
  if (before.contact.id != kNoIndex) return before.contact;
  if (find_sphere(
          world, [&](std::size_t k) { return has_odd_column(p, k); }, found))
    return found;
  find_body(
      world, [&](std::size_t k) { return has_odd_column(b, k); }, found);
  return found;
}

template <class Real>
bool is_listable(const World<Real>& world) {
  double sum = 0;
  for (const Record<Real>& r : world.particles.record) {
    sum += r.x + r.y + r.z + r.vx + r.vy + r.vz + static_cast<double>(r.radius);
  }
  const Polyhedra<Real>& p = world.polyhedra;
  for (std::size_t k = 0; k < p.size(); ++k) {
    sum += p.place(k).sum() + p.velocity(k).sum() + p.spin(k).sum() + p.scale[k];
    sum += p.orientation(k).coeffs().sum();
  }
  return std::isfinite(sum);
}

template Offender find_not_finite(const World<float>&, const BeforeStep<float>&);
template Offender find_not_finite(const World<double>&, const BeforeStep<double>&);
template bool is_listable(const World<float>&);
template bool is_listable(const World<double>&);

}  // namespace quern
