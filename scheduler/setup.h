// Setup: Scene -> World. Walls and their bodies, the table of coefficients, the domain, the time
// step and what it means for every pair of sizes.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scheduler/sizes.h"
#include "soa/world.h"

namespace quern {

// Coefficients of every ordered pair of materials, row-major. What stiffnesses are multiplied with
// at an overlap is the law's (kernels/laws/stiffness.h).
struct PairValues {
  double normal_stiffness = 0, tangential_stiffness = 0;  // N/m; of Hertz-Mindlin 4/3 E*, 8 G*, Pa
  double restitution = 1, sliding_friction = 0, rolling_friction = 0;
};
std::vector<PairValues> resolve_pairs(const Scene& scene);

// Throws UserError if the scene has no such material.
std::size_t material_row(const Scene& scene, const std::string& name);

// The least that is solid of any particle, and the farthest that one reaches (m). Throws UserError if
// there are none.
std::pair<double, double> radius_range(std::span<const ParticleSeed> particles);

// Walls and bodies at t = 0. `meshes` has the triangles of each row of scene.meshes.
struct SceneGeometry {
  std::vector<Wall> walls;
  std::vector<Body> bodies;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // domain
  std::array<bool, 3> periodic{};
  std::vector<const Facets*> facets() const;
};
SceneGeometry build_geometry(const Scene& scene, std::span<const std::vector<Triangle>> meshes,
                             std::span<const ParticleSeed> particles);

// How many steps a contact takes, for one pair of size classes (or a class and a wall). A
// polyhedron counts with the least mass that a corner of it opposes to a push, since it turns away;
// and where overlap is a width, two of its contacts push like three springs.
//
// Springs that stiffen have no contact time of their own: theirs is that of an impact at
// typical_speed(), and their tangential one is at the overlap which that reaches. Beside it stands
// the Rayleigh time, in which a wave runs around the smaller of the two.
struct StepAdvice {
  std::string a, b;                 // "ore 15-25 mm", "liner"
  double contact_time = 0, tangential_time = 0;  // s
  double steps_normal = 0, steps_tangential = 0;
  double rayleigh_time = 0;  // s; 0: not asked of the law
};
std::vector<StepAdvice> advise_steps(const Scene& scene, std::span<const ParticleSeed> particles,
                                     double dt);

inline constexpr double kRefusedSteps = 4.0, kWarnedSteps = 10.0, kAdvisedSteps = 20.0;
// The step over the Rayleigh time.
inline constexpr double kRefusedRayleigh = 1.0, kWarnedRayleigh = 0.4, kAdvisedRayleigh = 0.2;

// m/s: the scene's impact_speed, or the fastest of its walls, of a fall through the mill, a box or
// the domain, and of the velocities that particles begin with; 1 if all are 0. A factor of two in
// it changes contact times by 13 %.
double typical_speed(const Scene& scene);

// Of normal_model = "volume", whose force on a flat face jumps to k_V A at the first touch: how high
// the push of one step throws the polyhedron that it throws highest, over its diameter. Much of
// that is energy from nowhere. 0 for the other model.
double flat_face_toss(const Scene& scene, std::span<const ParticleSeed> particles, double dt);

inline constexpr double kWarnedToss = 1e-3;

// The scene's step, or a 25th of the shortest contact, or the advised share of the Rayleigh time.
double choose_time_step(const Scene& scene, std::span<const ParticleSeed> particles);

// Widens an automatic domain to hold a fill.
void include_fill(const Scene& scene, const Vec3& low, const Vec3& high, SceneGeometry& geometry);

// The same for a charge that another run has left.
template <class Real>
void include_charge(const Scene& scene, World<Real>& world);

// `all` are the particles of the scene, `present` those there from the start; polyhedra among them
// point into `shapes`, which the world takes over.
template <class Real>
World<Real> make_world(const Scene& scene, SceneGeometry geometry,
                       std::span<const ParticleSeed> all, std::span<const ParticleSeed> present,
                       std::vector<Shape> shapes = {});

// Adds particles to a running world, whose shapes the polyhedra among them point into. Identities:
// spheres get the next from 0 on, polyhedra the next behind all spheres of the scene. The lists go
// stale.
template <class Real>
void append_particles(World<Real>& world, const Scene& scene,
                      std::span<const ParticleSeed> particles);

// How the law of a phase differs from the scene's.
struct LawChange {
  double stiffness = 1;  // factor on all stiffnesses
  bool damped = false;   // tangential damping even if the scene has none
  double friction = 1;   // factor of sliding friction
};
// Fills the tables of the law, changed so.
template <class Real>
void set_law(World<Real>& world, const Scene& scene, const LawChange& change);

}  // namespace quern
