// Tables of the law, particles into columns.
#include "scheduler/setup.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "kernels/laws/damping.h"
#include "kernels/rotate.h"
#include "scheduler/phases.h"
#include "scheduler/wear_setup.h"

namespace quern {

namespace {

template <class Real>
LawColumns<Real> law_columns(const Scene& scene, const std::vector<PairValues>& pairs,
                             const LawChange& change) {
  LawColumns<Real> law;
  for (const PairValues& p : pairs) {
    const double zeta = damping_ratio(p.restitution, scene.contact.normal_force);
    const double kn = change.stiffness * p.normal_stiffness;
    const double kt = change.stiffness * p.tangential_stiffness;
    const bool damped = change.damped || scene.contact.tangential_damping;
    // What of the stiffness is under the root: laws/linear_spring_dashpot-inl.h and
    // hertz_mindlin-inl.h.
    const bool hertz = scene.contact.law == ForceLaw::kHertzMindlin;
    const double under_n = hertz ? kn * 5 / 4 : kn, under_t = hertz ? kt * 5 / 6 : kt * 2 / 7;
    const double at = damped ? 2 * zeta * std::sqrt(under_t) : 0;
    law.normal_stiffness.push_back(static_cast<Real>(kn));
    law.tangential_stiffness.push_back(static_cast<Real>(kt));
    law.normal_damping.push_back(static_cast<Real>(2 * zeta * std::sqrt(under_n)));
    law.tangential_damping.push_back(static_cast<Real>(at));
    law.sliding_friction.push_back(static_cast<Real>(change.friction * p.sliding_friction));
    law.rolling_friction.push_back(static_cast<Real>(p.rolling_friction));
  }
  return law;
}

// What rains in while the account is open has the velocity it is given now; the world keeps those
// of half a step before. A charge that starts, or is exchanged, brings them as they are kept.
template <class Real>
Vec3 stored_velocity(const World<Real>& world, const ParticleSeed& seed) {
  if (world.ledger.open == 0) return seed.velocity;
  return seed.velocity - 0.5 * world.clock.dt * world.gravity;
}

// It brings its energy along; gravity works on it from now on, though the next step counts the
// whole step that ends now.
template <class Real>
void open_account(World<Real>& world, const ParticleSeed& seed, double mass, double spinning) {
  if (world.ledger.open == 0) return;
  const Vec3 stored = stored_velocity(world, seed);
  world.ledger.start_kinetic += 0.5 * mass * stored.dot(2 * seed.velocity - stored) + spinning;
  world.ledger.gravity_work -= world.clock.dt * mass * world.gravity.dot(stored);
}

template <class Real>
void append_sphere(World<Real>& world, const Scene& scene, const ParticleSeed& seed,
                   std::size_t k) {
  Particles<Real>& p = world.particles;
  const Real radius = static_cast<Real>(seed.radius);
  const Vec3 velocity = stored_velocity(world, seed);
  p.record[k] = {seed.position.x(),
                 seed.position.y(),
                 seed.position.z(),
                 radius,
                 static_cast<Real>(seed.spin.x()),
                 velocity.x(),
                 velocity.y(),
                 velocity.z(),
                 static_cast<Real>(seed.spin.y()),
                 static_cast<Real>(seed.spin.z())};
  const double mass =
      scene.materials[seed.material].density * sphere_volume(static_cast<double>(radius));
  p.traits[k].inverse_mass = static_cast<Real>(1 / mass);
  world.total_mass += 1 / static_cast<double>(p.traits[k].inverse_mass);
  open_account(world, seed, mass, 0.2 * mass * seed.radius * seed.radius * seed.spin.squaredNorm());
  p.traits[k].tag = make_tag(seed.material, 0, world.groups.of_species(seed.species));
  p.id[k] = static_cast<Index>(k);
  p.species[k] = seed.species;
  p.spin_x[k] = seed.spin.x();
  p.spin_y[k] = seed.spin.y();
  p.spin_z[k] = seed.spin.z();
  p.rest_x[k] = p.rest_y[k] = p.rest_z[k] = 0;
  p.list_x[k] = p.list_y[k] = p.list_z[k] = 0;
  p.list_vx[k] = p.list_vy[k] = p.list_vz[k] = 0;
  p.pair_first[k] = p.pair_count[k] = 0;
}

Index row_of(const std::vector<Shape>& shapes, const Shape* shape) {
  for (std::size_t row = 0; row < shapes.size(); ++row) {
    if (&shapes[row] == shape) return static_cast<Index>(row);
  }
  throw InvariantError("a polyhedron whose shape is not among those of the world");
}

// Three columns take the components of a vector.
void put(const Vec3& v, double& x, double& y, double& z) {
  x = v.x();
  y = v.y();
  z = v.z();
}

template <class Real>
void append_polyhedron(World<Real>& world, const Scene& scene, const ParticleSeed& seed,
                       std::size_t k) {
  Polyhedra<Real>& p = world.polyhedra;
  const double mass = scene.materials[seed.material].density * sphere_volume(seed.radius);
  const Vec3 inertia = mass * seed.radius * seed.radius * seed.shape->inertia;
  const Mat3 turn = seed.orientation.toRotationMatrix();
  const Vec3 momentum = turn * inertia.cwiseProduct(turn.transpose() * seed.spin);
  put(seed.position, p.x[k], p.y[k], p.z[k]);
  put(stored_velocity(world, seed), p.vx[k], p.vy[k], p.vz[k]);
  p.qw[k] = seed.orientation.w();
  put(seed.orientation.vec(), p.qx[k], p.qy[k], p.qz[k]);
  put(momentum, p.lx[k], p.ly[k], p.lz[k]);
  put(seed.spin, p.wx[k], p.wy[k], p.wz[k]);
  p.scale[k] = seed.radius;
  p.inverse_mass[k] = 1 / mass;
  put(inverse_inertia_of(inertia), p.inverse_ix[k], p.inverse_iy[k], p.inverse_iz[k]);
  p.shape[k] = row_of(world.shapes, seed.shape);
  p.material[k] = seed.material;
  p.species[k] = seed.species;
  p.contacts[k] = 0;
  p.list_x[k] = p.list_y[k] = p.list_z[k] = 0;
  p.list_vx[k] = p.list_vy[k] = p.list_vz[k] = 0;
  world.total_mass += mass;
  open_account(world, seed, mass, 0.5 * momentum.dot(seed.spin));
}

std::size_t count_spheres(std::span<const ParticleSeed> seeds) {
  return static_cast<std::size_t>(std::count_if(
      seeds.begin(), seeds.end(), [](const ParticleSeed& seed) { return seed.is_sphere(); }));
}

// Large tiles share fewer contacts with others, and cost less; small scenes need several to run
// beside each other. Independent of the number of threads, or bits would depend on it.
Index choose_tile_size(std::size_t particles) {
  return static_cast<Index>(std::clamp<std::size_t>(particles / 32, 512, 2048));
}

// 4/3 E* and 8 G* of two materials, Pa.
void set_moduli(const Material& a, const Material& b, PairValues& to) {
  const auto give = [](const Material& m, double& normal, double& along) {
    const double e = m.young_modulus.value_or(0), nu = m.poisson_ratio.value_or(0);
    normal = (1 - nu * nu) / e;
    along = 2 * (2 - nu) * (1 + nu) / e;
    return e > 0;
  };
  double normal_a = 0, normal_b = 0, along_a = 0, along_b = 0;
  if (!give(a, normal_a, along_a) || !give(b, normal_b, along_b)) return;  // they never touch
  to.normal_stiffness = 4.0 / 3 / (normal_a + normal_b);
  to.tangential_stiffness = 8 / (along_a + along_b);
}

}  // namespace

std::size_t material_row(const Scene& scene, const std::string& name) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (scene.materials[m].name == name) return m;
  }
  throw UserError("material '" + name + "' is not defined");
}

std::vector<PairValues> resolve_pairs(const Scene& scene) {
  const std::size_t n = scene.materials.size();
  const ContactSpec& c = scene.contact;
  PairValues base;
  base.normal_stiffness = c.normal_stiffness.value_or(0);
  base.tangential_stiffness = c.tangential_stiffness.value_or(0);
  base.restitution = c.restitution.value_or(1);
  base.sliding_friction = c.sliding_friction.value_or(0);
  base.rolling_friction = c.rolling_friction;
  std::vector<PairValues> table(n * n, base);
  for (const PairCoefficients& p : c.pairs) {
    const std::size_t a = material_row(scene, p.a), b = material_row(scene, p.b);
    for (PairValues* v : {&table[a * n + b], &table[b * n + a]}) {
      v->normal_stiffness = p.normal_stiffness.value_or(base.normal_stiffness);
      v->tangential_stiffness = p.tangential_stiffness.value_or(base.tangential_stiffness);
      v->restitution = p.restitution.value_or(base.restitution);
      v->sliding_friction = p.sliding_friction.value_or(base.sliding_friction);
      v->rolling_friction = p.rolling_friction.value_or(base.rolling_friction);
    }
  }
  if (c.law == ForceLaw::kHertzMindlin) {
    for (std::size_t row = 0; row < n * n; ++row) {
      set_moduli(scene.materials[row / n], scene.materials[row % n], table[row]);
    }
  }
  return table;
}

template <class Real>
void set_law(World<Real>& world, const Scene& scene, const LawChange& change) {
  const std::vector<PairValues> pairs = resolve_pairs(scene);
  world.law = law_columns<Real>(scene, pairs, change);
  world.wall_law = law_columns<double>(scene, pairs, change);
  world.patch.volume_stiffness = change.stiffness * scene.contact.volume_stiffness.value_or(0);
  world.damped = change.damped || scene.contact.tangential_damping;
}

template <class Real>
void append_particles(World<Real>& world, const Scene& scene, std::span<const ParticleSeed> seeds) {
  std::size_t sphere = world.particles.size(), polyhedron = world.polyhedra.size();
  const std::size_t spheres = count_spheres(seeds);
  world.particles.resize(sphere + spheres);
  if (spheres < seeds.size()) world.polyhedra.resize(polyhedron + seeds.size() - spheres);
  for (const ParticleSeed& seed : seeds) {
    if (seed.is_sphere()) {
      append_sphere(world, scene, seed, sphere++);
    } else {
      append_polyhedron(world, scene, seed, polyhedron++);
    }
  }
  world.clock.list_stale = 1;
}

template <class Real>
void include_charge(const Scene& scene, World<Real>& world) {
  Vec3 low = world.low, high = world.high;
  const auto include = [&](const Vec3& x, double reach) {
    low = low.cwiseMin(Vec3(x - Vec3::Constant(reach)));
    high = high.cwiseMax(Vec3(x + Vec3::Constant(reach)));
  };
  for (const Record<Real>& r : world.particles.record) {
    include(Vec3(r.x, r.y, r.z), static_cast<double>(r.radius));
  }
  const Polyhedra<Real>& p = world.polyhedra;
  for (std::size_t k = 0; k < p.size(); ++k) {
    include(p.place(k), p.scale[k] * world.shapes[p.shape[k]].bound_radius);
  }
  for (int a = 0; a < 3; ++a) {
    if (world.periodic[static_cast<std::size_t>(a)]) continue;
    if (!scene.domain.low) world.low[a] = low[a];
    if (!scene.domain.high) world.high[a] = high[a];
  }
}

template <class Real>
World<Real> make_world(const Scene& scene, SceneGeometry geometry,
                       std::span<const ParticleSeed> all, std::span<const ParticleSeed> present,
                       std::vector<Shape> shapes) {
  World<Real> world;
  world.tile_size = scene.run.tile_size.value_or(choose_tile_size(all.size()));
  world.gravity = scene.run.gravity;
  world.low = geometry.low;
  world.high = geometry.high;
  world.periodic = geometry.periodic;
  world.materials = static_cast<Index>(scene.materials.size());
  world.force_law = scene.contact.law;
  world.precision = scene.run.precision;
  world.clamped = scene.contact.normal_force == NormalForce::kClamped;
  for (const PairValues& p : resolve_pairs(scene)) {
    world.rolling = world.rolling || p.rolling_friction > 0;
  }
  world.walls = std::move(geometry.walls);
  world.bodies = std::move(geometry.bodies);
  world.size_classes = SizeClasses(scene);
  world.groups = Groups(scene);
  world.collisions_asked.kinds = scene.record.collisions;
  if (scene.mill && scene.record.charge_shape) {
    world.collisions_asked.liner = 0;  // the mill's walls come first
    world.collisions_asked.mill_radius = 0.5 * scene.mill->diameter;
  }
  world.shapes = std::move(shapes);
  world.patch = {scene.contact.overlap, scene.contact.normal_model,
                 scene.contact.volume_stiffness.value_or(0), scene.contact.patch_damping};
  world.polyhedra.first_id = static_cast<Index>(count_spheres(all));
  std::tie(world.smallest_radius, world.largest_radius) = radius_range(all);
  world.clock.slack = scene.run.list_slack.value_or(0.2 * world.smallest_radius);
  world.clock.fixed_slack = scene.run.list_slack ? 1 : 0;
  world.clock.dt = choose_time_step(scene, all);
  world.pairs.rolling = world.rolling;
  set_law(world, scene, {});
  append_particles(world, scene, present);
  set_wear(world, scene);
  return world;
}

template World<float> make_world(const Scene&, SceneGeometry, std::span<const ParticleSeed>,
                                 std::span<const ParticleSeed>, std::vector<Shape>);
template World<double> make_world(const Scene&, SceneGeometry, std::span<const ParticleSeed>,
                                  std::span<const ParticleSeed>, std::vector<Shape>);
template void include_charge(const Scene&, World<float>&);
template void include_charge(const Scene&, World<double>&);
template void append_particles(World<float>&, const Scene&, std::span<const ParticleSeed>);
template void append_particles(World<double>&, const Scene&, std::span<const ParticleSeed>);
template void set_law(World<float>&, const Scene&, const LawChange&);
template void set_law(World<double>&, const Scene&, const LawChange&);

}  // namespace quern
