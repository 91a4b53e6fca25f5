#include "scheduler/snapshot.h"

#include <algorithm>
#include <cmath>

namespace quern {

template <class Real>
Vec3 wrapped(const World<Real>& world, Vec3 x) {
  for (Eigen::Index a = 0; a < 3; ++a) {
    if (!world.periodic[static_cast<std::size_t>(a)]) continue;
    const double length = world.high[a] - world.low[a];
    x[a] -= length * std::floor((x[a] - world.low[a]) / length);
  }
  return x;
}

namespace {

void resize(ParticleFrame& f, std::size_t n) {
  f.position.resize(3 * n);
  f.velocity.resize(3 * n);
  f.spin.resize(3 * n);
  f.radius.resize(n);
  f.id.resize(n);
  f.species.resize(n);
  f.size_class.resize(n);
  f.contacts.resize(n);
}

void set_motion(ParticleFrame& f, std::size_t at, const Vec3& x, const Vec3& v, const Vec3& w) {
  for (std::size_t a = 0; a < 3; ++a) {
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    f.position[3 * at + a] = x[e];
    f.velocity[3 * at + a] = static_cast<float>(v[e]);
    f.spin[3 * at + a] = static_cast<float>(w[e]);
  }
}

}  // namespace

template <class Real>
ParticleFrame particle_frame(const World<Real>& world) {
  const Particles<Real>& p = world.particles;
  const Polyhedra<Real>& q = world.polyhedra;
  ParticleFrame f;
  f.time = world.moving_walls ? world.time() : -1;
  f.spheres = p.size();
  resize(f, p.size() + q.size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Record<Real>& r = p.record[k];
    const std::size_t at = p.id[k];
    set_motion(f, at, wrapped(world, {r.x, r.y, r.z}), {r.vx, r.vy, r.vz},
               {p.spin_x[k], p.spin_y[k], p.spin_z[k]});
    f.radius[at] = static_cast<float>(r.radius);
    f.id[at] = p.id[k];
    f.species[at] = p.species[k];
    f.size_class[at] =
        world.size_classes.of(p.species[k], ShapeKind::kSphere, 2 * static_cast<double>(r.radius));
    f.contacts[at] = static_cast<std::uint16_t>(tag_contacts(p.traits[k].tag));
  }
  for (std::size_t k = 0; k < q.size(); ++k) {
    const std::size_t at = p.size() + k;
    set_motion(f, at, wrapped(world, q.place(k)), q.velocity(k), q.spin(k));
    f.radius[at] = static_cast<float>(q.scale[k]);
    f.id[at] = q.first_id + static_cast<Index>(k);
    f.species[at] = q.species[k];
    f.size_class[at] = world.size_classes.of(q.species[k], ShapeKind::kPolyhedron, 2 * q.scale[k]);
    f.contacts[at] = static_cast<std::uint16_t>(std::min(q.contacts[k], 0xffffu));
  }
  return f;
}

template <class Real>
EnergyFrame energy_frame(const World<Real>& world) {
  constexpr double kSphere = 0.4;  // moment of inertia over m r^2
  const Particles<Real>& p = world.particles;
  const Polyhedra<Real>& q = world.polyhedra;
  EnergyFrame f;
  f.mass.resize(p.size() + q.size());
  f.rotational_energy.resize(p.size() + q.size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double mass = 1 / static_cast<double>(p.traits[k].inverse_mass);
    const double radius = static_cast<double>(p.record[k].radius);
    const Vec3 spin(p.spin_x[k], p.spin_y[k], p.spin_z[k]);
    f.mass[p.id[k]] = mass;
    f.rotational_energy[p.id[k]] = 0.5 * kSphere * mass * radius * radius * spin.squaredNorm();
  }
  for (std::size_t k = 0; k < q.size(); ++k) {
    f.mass[p.size() + k] = 1 / q.inverse_mass[k];
    f.rotational_energy[p.size() + k] = 0.5 * q.spin(k).dot(q.momentum(k));
  }
  return f;
}

SurfaceFrame shape_surface(const Shape& shape) {
  SurfaceFrame f;
  for (std::size_t v = 0; v < shape.vertices; ++v) {
    for (int a = 0; a < 3; ++a) f.vertex.push_back(shape.vertex(v)[a]);
  }
  for (std::size_t face = 0; face < shape.faces; ++face) {
    const std::size_t first = shape.face_begin[face], last = shape.face_begin[face + 1];
    for (std::size_t k = first + 1; k + 1 < last; ++k) {
      for (const std::size_t corner : {first, k, k + 1}) {
        f.triangle.push_back(shape.face_vertex[corner]);
      }
      f.face.push_back(static_cast<std::uint16_t>(face));
    }
  }
  return f;
}

template <class Real>
std::optional<PolyhedronFrame> polyhedron_frame(const World<Real>& world) {
  if (world.shapes.empty()) return std::nullopt;
  std::vector<SurfaceFrame> surfaces;
  for (const Shape& shape : world.shapes) surfaces.push_back(shape_surface(shape));
  const Polyhedra<Real>& q = world.polyhedra;
  PolyhedronFrame f;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const SurfaceFrame& surface = surfaces[q.shape[k]];
    const std::uint32_t base = static_cast<std::uint32_t>(f.vertex.size() / 3);
    const Vec3 place = wrapped(world, q.place(k));
    const Mat3 turn = q.orientation(k).toRotationMatrix();
    for (std::size_t v = 0; v < surface.vertex.size(); v += 3) {
      const Vec3 body(surface.vertex[v], surface.vertex[v + 1], surface.vertex[v + 2]);
      const Vec3 x = place + q.scale[k] * (turn * body);
      for (int a = 0; a < 3; ++a) f.vertex.push_back(static_cast<float>(x[a]));
    }
    for (const std::uint32_t v : surface.triangle) f.triangle.push_back(base + v);
    f.body.insert(f.body.end(), surface.face.size(), static_cast<std::uint32_t>(k));
    for (const double c : {q.qw[k], q.qx[k], q.qy[k], q.qz[k]}) f.orientation.push_back(c);
    f.shape.push_back(q.shape[k]);
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

template Vec3 wrapped(const World<float>&, Vec3);
template Vec3 wrapped(const World<double>&, Vec3);
template ParticleFrame particle_frame(const World<float>&);
template ParticleFrame particle_frame(const World<double>&);
template EnergyFrame energy_frame(const World<float>&);
template EnergyFrame energy_frame(const World<double>&);
template std::optional<PolyhedronFrame> polyhedron_frame(const World<float>&);
template std::optional<PolyhedronFrame> polyhedron_frame(const World<double>&);
template WallFrame wall_frame(const World<float>&);
template WallFrame wall_frame(const World<double>&);

}  // namespace quern
