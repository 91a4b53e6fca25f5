// Steps per contact: pi sqrt(m / k) over the step, m being the mass that the spring feels.
//
// A push along n at the point r of a body moves that point as if its mass were m_n, where
// 1/m_n = 1/m + (r x n) . I^-1 (r x n). Of a sphere m_n = m, and 2/7 m along its surface; of a
// polyhedron the least is taken over its corners and the normals that a contact there can have:
// those of the faces around it, of the edges between two of them, and along the surface any
// direction. A cube gets a quarter of its mass, a long square rod 1/5.5.
//
// Hertz' contact takes 2.94 d / v, of the largest overlap d: 2/5 k d^(5/2) = 1/2 m v^2 with
// k = 4/3 E* sqrt(R*). Rayleigh's wave: pi R sqrt(rho / G) / (0.8766 + 0.1631 nu).
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "kernels/laws/damping.h"
#include "kernels/laws/stiffness.h"
#include "kernels/rotate.h"
#include "scheduler/setup.h"

namespace quern {

namespace {

constexpr double kWidthStiffness = 3;  // of flat faces shifted in two directions

// How many times lighter than its mass a body is where it is pushed.
struct Lightness {
  double normal = 1, tangential = 3.5;
};

// Equivalent radius 1.
double face_area(const Shape& s, std::size_t f) {
  Vec3 twice = Vec3::Zero();
  const Vec3 first = s.vertex(s.face_vertex[s.face_begin[f]]);
  for (std::size_t k = s.face_begin[f] + 1; k + 1 < s.face_begin[f + 1]; ++k) {
    twice += (s.vertex(s.face_vertex[k]) - first).cross(s.vertex(s.face_vertex[k + 1]) - first);
  }
  return 0.5 * twice.norm();
}

// 1 + (r x n) . I^-1 (r x n) in units of 1/m, equivalent radius 1.
double lightness(const Vec3& r, const Vec3& n, const Vec3& inverse_inertia) {
  const Vec3 arm = r.cross(n);
  return 1 + arm.dot(inverse_inertia.cwiseProduct(arm));
}

Lightness lightness_of(const Shape& s) {
  const Vec3 inverse = inverse_inertia_of(s.inertia);
  Lightness most{1, 1};
  const auto push = [&](std::size_t vertex, const Vec3& normal) {
    most.normal = std::max(most.normal, lightness(s.vertex(vertex), normal, inverse));
  };
  for (std::size_t f = 0; f < s.faces; ++f) {
    for (std::size_t k = s.face_begin[f]; k < s.face_begin[f + 1]; ++k) {
      push(s.face_vertex[k], s.normal(f));
    }
  }
  for (std::size_t e = 0; e < s.edges; ++e) {
    const Vec3 normal =
        (s.normal(s.edge_face[2 * e]) + s.normal(s.edge_face[2 * e + 1])).normalized();
    push(s.edge_vertex[2 * e], normal);
    push(s.edge_vertex[2 * e + 1], normal);
  }
  for (std::size_t v = 0; v < s.vertices; ++v) {
    Mat3 cross;
    const Vec3 r = s.vertex(v);
    cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    const Mat3 form = cross.transpose() * inverse.asDiagonal() * cross;
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(form, Eigen::EigenvaluesOnly);
    most.tangential = std::max(most.tangential, 1 + solver.eigenvalues().maxCoeff());
  }
  return most;
}

// The classes of a scene by material and size, each with its lightest member.
struct AdviceClass {
  std::string name;
  std::size_t material = 0;
  double mass = 0, tangential_mass = 0;  // kg, as a contact feels them; 0: a wall
  double radius = 0;                     // m, equivalent; 0: a wall
  bool polyhedra = false;
};

std::string size_name(const Scene& scene, const ParticleSeed& p) {
  const ParticleSpec& spec = scene.particles[p.species];
  char text[96];
  for (const SizeClass& c : spec.sizes) {
    if (2 * p.radius < c.from * (1 - 1e-9) || 2 * p.radius > c.to * (1 + 1e-9)) continue;
    if ((shape_of(spec, c) == ShapeKind::kSphere) != p.is_sphere()) continue;
    std::snprintf(text, sizeof text, "%s %g-%g mm", spec.name.c_str(), 1e3 * c.from, 1e3 * c.to);
    return text;
  }
  if (spec.diameter) {
    std::snprintf(text, sizeof text, "%s %g mm", spec.name.c_str(), 2e3 * p.radius);
    return text;
  }
  return spec.name;
}

void add_walls(const Scene& scene, std::vector<AdviceClass>& classes) {
  std::vector<std::pair<std::string, std::string>> walls;
  if (scene.mill) {
    walls.emplace_back("liner", scene.mill->material);
    if (scene.mill->ends == EndKind::kWalls && !scene.mill->end_material.empty()) {
      walls.emplace_back("ends", scene.mill->end_material);
    }
  }
  for (const auto& w : scene.meshes) walls.emplace_back(w.name, w.material);
  for (const auto& w : scene.planes) walls.emplace_back(w.name, w.material);
  for (const auto& w : scene.boxes) walls.emplace_back(w.name, w.material);
  for (const auto& [name, material] : walls) {
    classes.push_back({name, material_row(scene, material), 0, 0, 0, false});
  }
}

std::vector<AdviceClass> advice_classes(const Scene& scene,
                                        std::span<const ParticleSeed> particles) {
  std::vector<AdviceClass> classes;
  std::map<std::string, std::size_t> row;
  std::map<const Shape*, Lightness> known = {{nullptr, Lightness()}};
  for (const ParticleSeed& p : particles) {
    const std::string name = size_name(scene, p);
    auto light = known.find(p.shape);
    if (light == known.end()) light = known.emplace(p.shape, lightness_of(*p.shape)).first;
    const double mass = scene.materials[p.material].density * sphere_volume(p.radius);
    const double normal = mass / light->second.normal, along = mass / light->second.tangential;
    const auto [at, fresh] = row.emplace(name, classes.size());
    if (fresh) classes.push_back({name, p.material, normal, along, p.radius, false});
    AdviceClass& to = classes[at->second];
    to.mass = std::min(to.mass, normal);
    to.tangential_mass = std::min(to.tangential_mass, along);
    to.radius = std::min(to.radius, p.radius);
    to.polyhedra = to.polyhedra || !p.is_sphere();
  }
  add_walls(scene, classes);
  return classes;
}

// Of two masses or radii, the second 0 for a wall.
double reduced(double a, double b) { return b == 0 ? a : a * b / (a + b); }

// s, of the wave around a sphere; none around a wall.
double rayleigh_time(const Scene& scene, const AdviceClass& c) {
  const Material& m = scene.materials[c.material];
  if (c.mass == 0) return HUGE_VAL;
  const double nu = m.poisson_ratio.value_or(0);
  const double shear = m.young_modulus.value_or(0) / (2 * (1 + nu));
  return kPi * c.radius * std::sqrt(m.density / shear) / (0.8766 + 0.1631 * nu);
}

// The largest overlap of two that meet at `speed`, m; `stiffness` is 4/3 E*.
double hertz_overlap(double mass, double radius, double stiffness, double speed) {
  return std::pow(1.25 * mass * speed * speed / (stiffness * std::sqrt(radius)), 0.4);
}

double fastest(const Schedule& rate) {
  double most = 0;
  for (const Schedule::Point& p : rate.points) most = std::max(most, std::abs(p.value));
  return most;
}

// m/s, of a wall that may be `reach` from the axis of its rotation.
double wall_speed(const Motion& motion, double reach) {
  switch (motion.kind) {
    case MotionKind::kRotation:
      return fastest(motion.rate) * reach;
    case MotionKind::kTranslation:
      return fastest(motion.rate);
    case MotionKind::kOscillation:
      return 2 * kPi * motion.frequency * motion.amplitude;
    default:
      return 0;
  }
}

// m along gravity: of the mill, of boxes, or else of the domain.
double fall_height(const Scene& scene) {
  const Vec3 down = scene.run.gravity.normalized().cwiseAbs();
  double height = scene.mill ? scene.mill->diameter : 0;
  for (const BoxSpec& box : scene.boxes) height = std::max(height, down.dot(box.high - box.low));
  if (height == 0 && scene.domain.low && scene.domain.high) {
    height = down.dot(*scene.domain.high - *scene.domain.low);
  }
  return height;
}

// Times of springs that stiffen.
void advise_hertz(const Scene& scene, const AdviceClass& a, const AdviceClass& b,
                  const PairValues& v, double normal_factor, StepAdvice& advice) {
  constexpr double kHertzTime = 2.9432750;  // 4/5 sqrt(pi) Gamma(2/5) / Gamma(9/10)
  const double speed = typical_speed(scene), radius = reduced(a.radius, b.radius);
  const double deepest = hertz_overlap(reduced(a.mass, b.mass), radius,
                                       v.normal_stiffness * std::pow(normal_factor, 1.5), speed);
  const double kt = v.tangential_stiffness * stiffness_factor(scene.contact.law, deepest, radius);
  advice.contact_time = kHertzTime * deepest / speed;
  advice.tangential_time = contact_time(reduced(a.tangential_mass, b.tangential_mass), kt);
  advice.rayleigh_time = std::min(rayleigh_time(scene, a), rayleigh_time(scene, b));
}

void advise_linear(const AdviceClass& a, const AdviceClass& b, const PairValues& v,
                   double normal_factor, StepAdvice& advice) {
  const double along = reduced(a.tangential_mass, b.tangential_mass);
  advice.contact_time = contact_time(reduced(a.mass, b.mass), v.normal_stiffness * normal_factor);
  advice.tangential_time =
      v.tangential_stiffness > 0 ? contact_time(along, v.tangential_stiffness) : HUGE_VAL;
}

}  // namespace

double typical_speed(const Scene& scene) {
  if (scene.contact.impact_speed) return *scene.contact.impact_speed;
  double speed = std::sqrt(2 * scene.run.gravity.norm() * fall_height(scene));
  const auto consider = [&](double other) { speed = std::max(speed, other); };
  if (scene.mill) consider(fastest(scene.mill->rotation) * 0.5 * scene.mill->diameter);
  const bool known = scene.domain.low && scene.domain.high;
  const double reach = known ? 0.5 * (*scene.domain.high - *scene.domain.low).norm() : 0;
  for (const MeshWallSpec& wall : scene.meshes) consider(wall_speed(wall.motion, reach));
  for (const PlaneSpec& wall : scene.planes) consider(wall_speed(wall.motion, reach));
  for (const BoxSpec& wall : scene.boxes) consider(wall_speed(wall.motion, reach));
  consider(scene.fill.velocity.norm());
  for (const ParticleSpec& species : scene.particles) {
    for (const ExplicitParticle& p : species.explicit_particles) consider(p.velocity.norm());
  }
  return speed > 0 ? speed : 1;
}

std::vector<StepAdvice> advise_steps(const Scene& scene, std::span<const ParticleSeed> particles,
                                     double dt) {
  const std::vector<AdviceClass> classes = advice_classes(scene, particles);
  const std::vector<PairValues> pairs = resolve_pairs(scene);
  const bool width = scene.contact.overlap == OverlapMeasure::kWidth;
  std::vector<StepAdvice> all;
  for (std::size_t row = 0; row < classes.size(); ++row) {
    for (std::size_t other = row; other < classes.size(); ++other) {
      const AdviceClass &a = classes[row], &b = classes[other];
      if (a.mass == 0) continue;
      const PairValues& v = pairs[a.material * scene.materials.size() + b.material];
      const bool flat = a.polyhedra && (b.polyhedra || b.mass == 0);
      const double normal_factor = width && flat ? kWidthStiffness : 1;
      StepAdvice advice;
      advice.a = a.name;
      advice.b = b.name;
      if (scene.contact.law == ForceLaw::kHertzMindlin) {
        advise_hertz(scene, a, b, v, normal_factor, advice);
      } else {
        advise_linear(a, b, v, normal_factor, advice);
      }
      advice.steps_normal = advice.contact_time / dt;
      advice.steps_tangential = advice.tangential_time / dt;
      all.push_back(advice);
    }
  }
  return all;
}

double flat_face_toss(const Scene& scene, std::span<const ParticleSeed> particles, double dt) {
  const double gravity = scene.run.gravity.norm();
  if (scene.contact.normal_model != NormalModel::kVolume || gravity == 0) return 0;
  double stiffest = 0;
  for (const PairValues& pair : resolve_pairs(scene)) {
    stiffest = std::max(stiffest, pair.normal_stiffness);
  }
  std::map<const Shape*, double> largest;
  double worst = 0;
  for (const ParticleSeed& p : particles) {
    if (p.is_sphere()) continue;
    const auto [known, fresh] = largest.try_emplace(p.shape, 0);
    for (std::size_t f = 0; fresh && f < p.shape->faces; ++f) {
      known->second = std::max(known->second, face_area(*p.shape, f));
    }
    const double stiffness = scene.contact.volume_stiffness.value_or(stiffest / p.radius);
    const double mass = scene.materials[p.material].density * sphere_volume(p.radius);
    const double speed = stiffness * known->second * p.radius * p.radius * dt / mass;
    worst = std::max(worst, speed * speed / (2 * gravity * 2 * p.radius));
  }
  return worst;
}

double choose_time_step(const Scene& scene, std::span<const ParticleSeed> particles) {
  if (scene.run.time_step) return *scene.run.time_step;
  double shortest = HUGE_VAL;
  for (const StepAdvice& a : advise_steps(scene, particles, 1)) {
    shortest = std::min(shortest, a.contact_time / 25);
    if (a.rayleigh_time > 0) shortest = std::min(shortest, kAdvisedRayleigh * a.rayleigh_time);
  }
  return shortest;
}

}  // namespace quern
