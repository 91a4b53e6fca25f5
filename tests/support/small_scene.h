// Small scenes built by hand: one material, a few spheres, plates.
//
// Lengths are chosen by the tests as powers of two where a radius must be the same number in f32
// and f64. Spheres get identities in the order in which they are added. There is no gravity unless
// a test sets it.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "soa/scene.h"
#include "tests/support/build_world.h"
#include "tests/support/trap_fp.h"

namespace quern::test {

inline constexpr double kDensity = 4500;  // kg/m^3

struct Law {
  double kn = 2e7, kt = 8e6;  // N/m
  double restitution = 0.5, sliding = 0.5, rolling = 0;
  NormalForce normal_force = NormalForce::kClamped;
  bool tangential_damping = true;
  ForceLaw springs = ForceLaw::kLinearSpringDashpot;
  double young = 1e9, poisson = 0.3;  // Pa, of Hertz-Mindlin
};

inline Law hertz_law() {
  Law law;
  law.springs = ForceLaw::kHertzMindlin;
  return law;
}

// The law of LAMMPS' and LIGGGHTS' linear springs: pulls at the end, no tangential damping.
inline Law peer_law(double restitution, double sliding) {
  Law law;
  law.restitution = restitution;
  law.sliding = sliding;
  law.normal_force = NormalForce::kUnclamped;
  law.tangential_damping = false;
  return law;
}

inline Scene small_scene(const Law& law, double dt, double half_size = 8) {
  Scene scene;
  scene.run.time_step = dt;
  scene.run.duration = 1;
  scene.run.gravity = Vec3::Zero();
  scene.domain.low = Vec3::Constant(-half_size);
  scene.domain.high = Vec3::Constant(half_size);
  scene.materials = {{"ore", kDensity, 0}};
  scene.contact.normal_force = law.normal_force;
  scene.contact.tangential_damping = law.tangential_damping;
  scene.contact.law = law.springs;
  if (law.springs == ForceLaw::kHertzMindlin) {
    scene.materials[0].young_modulus = law.young;
    scene.materials[0].poisson_ratio = law.poisson;
  } else {
    scene.contact.normal_stiffness = law.kn;
    scene.contact.tangential_stiffness = law.kt;
  }
  scene.contact.restitution = law.restitution;
  scene.contact.sliding_friction = law.sliding;
  scene.contact.rolling_friction = law.rolling;
  ParticleSpec spheres;
  spheres.name = "sphere";
  spheres.material = "ore";
  scene.particles = {spheres};
  return scene;
}

inline void add_sphere(Scene& scene, double diameter, const Vec3& position,
                       const Vec3& velocity = Vec3::Zero(), const Vec3& spin = Vec3::Zero()) {
  scene.particles[0].explicit_particles.push_back({position, velocity, spin, diameter});
}

inline void add_plane(Scene& scene, const Vec3& point, const Vec3& normal,
                      const Motion& motion = Motion(), const std::string& name = "floor") {
  scene.planes.push_back({name, "ore", point, normal.normalized(), motion});
}

inline void add_mesh(Scene& scene, const std::string& name, const Motion& motion = Motion()) {
  scene.meshes.push_back({name, "", "ore", 1, motion});
}

inline double sphere_mass(double diameter, double density = kDensity) {
  return density * kPi / 6 * diameter * diameter * diameter;
}

// pi sqrt(m_e / kn), the unit of "steps per contact".
inline double normal_contact_time(double reduced_mass, double kn) {
  return kPi * std::sqrt(reduced_mass / kn);
}

// 4/3 E* of two spheres of one material, Pa.
inline double hertz_modulus(double young, double poisson) {
  return 4.0 / 3 * young / (2 * (1 - poisson * poisson));
}
// The deepest overlap of Hertz' springs without damping, 2/5 k d^(5/2) = 1/2 m v^2, and how long
// the contact takes.
inline double hertz_depth(double reduced_mass, double reduced_radius, double modulus,
                          double speed) {
  const double k = modulus * std::sqrt(reduced_radius);
  return std::pow(5 * reduced_mass * speed * speed / (4 * k), 0.4);
}
inline double hertz_contact_time(double reduced_mass, double reduced_radius, double modulus,
                                 double speed) {
  return 2.94328 * hertz_depth(reduced_mass, reduced_radius, modulus, speed) / speed;
}

template <class Real>
void run_steps(World<Real>& world, Stepper<Real>& stepper, int steps) {
  for (int k = 0; k < steps; ++k) {
    const StepReport report = stepper.step();
    ASSERT_EQ(report.bits & kFatalBits, 0u)
        << "at t = " << world.time() << ", particle " << report.first.id;
  }
}

// Typed tests run in both precisions, by name.
struct Names {
  template <class Real>
  static std::string GetName(int) {
    return sizeof(Real) == 4 ? "mixed" : "double";
  }
};
using Precisions = testing::Types<float, double>;

}  // namespace quern::test
