#include "scheduler/snapshot.h"

#include <cmath>

namespace quern {

template <class Real>
ParticleFrame particle_frame(const World<Real>& world) {
  const Particles<Real>& p = world.particles;
  const std::size_t n = p.size();
  ParticleFrame f;
  f.time = world.moving_walls ? world.time() : -1;
  f.position.resize(3 * n);
  f.velocity.resize(3 * n);
  f.spin.resize(3 * n);
  f.radius.resize(n);
  f.id.resize(n);
  f.species.resize(n);
  f.contacts.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Record<Real>& r = p.record[k];
    const std::size_t at = p.id[k];
    double x[3] = {r.x, r.y, r.z};
    for (int a = 0; a < 3; ++a) {
      if (!world.periodic[static_cast<std::size_t>(a)]) continue;
      const double length = world.high[a] - world.low[a];
      x[a] -= length * std::floor((x[a] - world.low[a]) / length);
    }
    const double v[3] = {r.vx, r.vy, r.vz}, w[3] = {p.spin_x[k], p.spin_y[k], p.spin_z[k]};
    for (std::size_t a = 0; a < 3; ++a) {
      f.position[3 * at + a] = x[a];
      f.velocity[3 * at + a] = static_cast<float>(v[a]);
      f.spin[3 * at + a] = static_cast<float>(w[a]);
    }
    f.radius[at] = static_cast<float>(r.radius);
    f.id[at] = p.id[k];
    f.species[at] = p.species[k];
    f.contacts[at] = static_cast<std::uint16_t>(tag_contacts(p.traits[k].tag));
  }
  return f;
}

template <class Real>
WallFrame wall_frame(const World<Real>& world) {
  WallFrame f;
  for (const Body& body : world.bodies) {
    const Facets& facets = body.facets;
    const std::uint32_t base = static_cast<std::uint32_t>(f.vertex.size() / 3);
    for (const Vec3& v : facets.vertex) {
      const Vec3 x = body.pose.rotation * v + body.pose.shift;
      for (int a = 0; a < 3; ++a) f.vertex.push_back(static_cast<float>(x[a]));
    }
    for (Index t = 0; t < facets.triangles(); ++t) {
      Vec3 centre = Vec3::Zero();
      for (Index k = 0; k < 3; ++k) {
        const Index v = facets.corner[3 * t + k];
        f.triangle.push_back(base + v);
        centre += facets.vertex[v] / 3;
      }
      const Vec3 x = body.pose.rotation * centre + body.pose.shift;
      f.wall.push_back(static_cast<std::uint16_t>(facets.wall[t]));
      f.speed.push_back(static_cast<float>(body.velocity.at(x).norm()));
    }
  }
  return f;
}

template ParticleFrame particle_frame(const World<float>&);
template ParticleFrame particle_frame(const World<double>&);
template WallFrame wall_frame(const World<float>&);
template WallFrame wall_frame(const World<double>&);

}  // namespace quern
