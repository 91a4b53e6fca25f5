// World: the whole state of a run, and nothing else.
//
// scheduler/setup makes it from a Scene, scheduler/step advances it, visit() enumerates it for
// checkpoints. What can be recomputed from the scene (materials, facets, tables) is not saved; what
// the next bit of the run depends on is, list order included, so that a resumed run is the same run.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "soa/collisions.h"
#include "soa/facets.h"
#include "soa/force_law.h"
#include "soa/groups.h"
#include "soa/ledger.h"
#include "soa/motion.h"
#include "soa/pairs.h"
#include "soa/particles.h"
#include "soa/polyhedra.h"
#include "soa/precision.h"
#include "soa/report.h"
#include "soa/size_classes.h"
#include "soa/wall_spring.h"
#include "soa/wear.h"

namespace quern {

// A wall is what forces are booked on; walls with one motion share a body and its facets.
struct Wall {
  std::string name;
  std::uint32_t material = 0;
  Index body = 0;
  std::uint8_t group = 0;  // of Groups
};

struct Body {
  Motion motion;
  Facets facets;
  Pose pose;               // now
  WallVelocity velocity;   // over the last step
};

// Symmetric coefficients of every ordered pair of materials, see LawTable in kernels/contact.h.
template <class Real>
struct LawColumns {
  std::vector<Real> normal_stiffness, tangential_stiffness, normal_damping, tangential_damping,
      sliding_friction, rolling_friction;
};

// How polyhedra push on each other and on walls.
struct PatchLaw {
  OverlapMeasure overlap = OverlapMeasure::kChord;
  NormalModel model = NormalModel::kStiffness;
  double volume_stiffness = 0;  // Pa, kVolume; 0: normal stiffness over the smaller equivalent radius
  bool damping = true;          // of rocking and drilling
};

// Which facets a particle may meet before the next rebuild.
struct WallCandidates {
  std::vector<Index> particle, body;  // one entry per particle and body
  std::vector<Index> first;           // entries + 1, into facet
  std::vector<Index> facet;
};

struct TileWalls {
  WallCandidates candidates;
  std::vector<WallSpring> springs;  // open contacts, by particle
  std::vector<Episode> episodes;    // of each spring, while collisions are recorded
};

// Force and torque (about the wall's motion centre) of the charge on a wall, and the wall's power.
struct WallTotal {
  std::array<double, 3> force{}, torque{};
  double work = 0;  // J, by the wall on the charge in the last step
};

// Everything a step adds up over the scene. Energies in J.
struct StepTotals {
  double pair_work = 0, wall_contact_work = 0;  // contact forces on relative motion, last step
  double elastic = 0;
  double slide = 0, tangential_damping = 0, numerical_loss = 0, model_work = 0;
  double pair_contacts = 0, wall_contacts = 0, warnings = 0, max_overlap = 0;
  double translational = 0, rotational = 0, drag_loss = 0;
  std::array<double, 3> momentum{}, moment_of_mass{};
  double max_deviation2 = 0, strays = 0, bad = 0;
  // Of pair_contacts and wall_contacts, those of polyhedra.
  double polyhedron_sphere_contacts = 0, polyhedron_pair_contacts = 0, polyhedron_wall_contacts = 0;
};

// Sums over steps since the last series row.
struct Window {
  double steps = 0;
  double torque = 0, power = 0;  // about the mill axis
  double translational = 0, rotational = 0, elastic = 0;
  double pair_contacts = 0, wall_contacts = 0, max_overlap = 0, warnings = 0;
  std::array<double, 3> moment_of_mass{};
  double polyhedron_sphere_contacts = 0, polyhedron_pair_contacts = 0, polyhedron_wall_contacts = 0;
};

enum class Phase : std::uint32_t { kSoft, kStiffen, kRelax, kSettle, kRun };

// Plain numbers of the run, most of which the next step depends on; saved as one block.
struct Clock {
  std::uint64_t step = 0;        // of this phase
  std::uint64_t total_steps = 0; // of all phases
  std::uint64_t phase = 0;       // row of the run's list of phases
  double dt = 0;                 // s, of this phase
  std::uint64_t list_step = 0;   // total_steps when the lists were built
  std::uint64_t list_window = 20;  // steps the lists were built for
  std::uint64_t list_stale = 1;
  std::uint64_t rebuilds = 0;
  double slack = 0;              // m, of the lists: two particles may stray by half of it at most
  std::uint64_t fixed_slack = 0;  // the scene gave it: never adapted
  std::uint64_t first_kick = 1;  // the next step starts from full-step velocities
  std::uint64_t inserted = 0;    // particles inserted so far (rain)
  std::uint64_t warnings = 0;    // contacts deeper than half the smaller radius, summed over steps
  double fall = 0;               // m, how far the charge may fall while it settles
};

template <class Real>
struct World {
  // From the scene; constant.
  Index tile_size = 1024;
  double smallest_radius = 0, largest_radius = 0;  // m
  Vec3 gravity = Vec3::Zero();
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // domain, as far as it was filled; saved
  std::array<bool, 3> periodic{};
  Index materials = 1;
  ForceLaw force_law = ForceLaw::kLinearSpringDashpot;
  Precision precision = Precision::kMixed;
  LawColumns<Real> law;
  LawColumns<double> wall_law;
  bool clamped = true, rolling = false, damped = true;
  std::vector<Wall> walls;
  std::vector<Body> bodies;
  double total_mass = 0;
  SizeClasses size_classes;
  Groups groups;
  CollisionsAsked collisions_asked;
  std::vector<Shape> shapes;    // of the polyhedra
  PatchLaw patch;
  double drag = 1;              // velocity factor of the soft phase
  double overlap_cap = 0;       // m; contacts of polyhedra push as if no deeper than this; 0: none
  bool caps_spheres = false;    // and those of spheres

  // State.
  Particles<Real> particles;
  PairBatch<Real> pairs;
  Polyhedra<Real> polyhedra;
  std::vector<TileWalls> tile_walls;
  std::vector<WallTotal> wall_totals;
  StepTotals totals;
  Ledger ledger;
  Window window;
  Clock clock;
  Wear wear;
  Collisions collisions;
  std::uint64_t capped_contacts = 0;  // pushed at the cap that the scene gives, summed over steps

  std::size_t bodies_of_charge() const { return particles.size() + polyhedra.size(); }
  std::size_t tiles() const { return (particles.size() + tile_size - 1) / tile_size; }
  // t = 0 when the walls start to move; settling has its own clock before it.
  double time() const { return static_cast<double>(clock.step) * clock.dt; }

  // Collisions are recorded from after the next step on.
  void begin_recording() {
    collisions.begin(groups.kinds(), collisions_asked);
    polyhedra.pair_episodes.assign(polyhedra.pairs.size(), Episode());
  }
  void end_recording() {
    collisions = Collisions();
    pairs.episodes = false;
    for (TileWalls& tile : tile_walls) tile.episodes.clear();
    polyhedra.pair_episodes.clear();
    polyhedra.wall_episodes.clear();
    PolyhedronSphereBatch<Real>& near = polyhedra.spheres;
    for (std::size_t slot = 0; slot < near.sphere.size(); ++slot) {
      for (std::size_t k = near.kEpisode; k < near.kHistoryStride; ++k) near.number(slot, k) = 0;
    }
  }

  // The clock of the walls: they stand still while the charge settles.
  bool moving_walls = false;
  double wall_time() const { return moving_walls ? time() : 0; }

  // `pack` and `unpack` put tile_walls into columns and back; the lists of candidates are saved too.
  void visit(StateVisitor& v);

 private:
  struct PackedWalls {
    Column<std::uint8_t> spring_bytes;
    std::vector<Episode> episodes;  // of each spring, while collisions are recorded
    Column<Index> spring_tile, entry_tile, entry_particle, entry_body, entry_facets, facet;
  };
  PackedWalls pack_walls() const;
  void unpack_walls(const PackedWalls& packed);
};

}  // namespace quern
