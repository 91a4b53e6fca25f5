// Contact forces of one tile: what the kernels read and write, and the entry points that dispatch
// to the best SIMD target of this CPU at run time.
//
// A kernel is a pure function over columns: no allocation, no threads, no I/O. The pair kernels add
// force and torque into the tile's accumulator rows, in the order of the list; a row is
//   fx fy fz  tx ty tz  contacts  unused      (f64, one cache line)
// The last row (index tile_size) takes what belongs to partners of other tiles and is thrown away:
// those tiles compute the same contact from the same bits.
#pragma once

#include "soa/base.h"
#include "soa/collisions.h"
#include "soa/force_law.h"
#include "soa/grid_place.h"
#include "soa/groups.h"
#include "soa/motion.h"
#include "soa/pairs.h"
#include "soa/precision.h"
#include "soa/record.h"
#include "soa/wear.h"

namespace quern {

inline constexpr std::size_t kRowWidth = 8;

// Constants of the law for every ordered pair of materials (row i * materials + j), symmetric.
// Damping enters as a = 2 zeta sqrt(k), so that c = a sqrt(m). Those of linear springs; laws whose
// stiffness is the table's times a power of the overlap have their own units, see laws/.
template <class Real>
struct LawTable {
  const Real* normal_stiffness;      // N/m
  const Real* tangential_stiffness;  // N/m
  const Real* normal_damping;        // 2 zeta sqrt(kn)
  const Real* tangential_damping;    // 2 zeta sqrt(kt 2/7); 0: off. c_t = this * sqrt(m_e)
  const Real* sliding_friction;
  const Real* rolling_friction;
  Index materials;
  ForceLaw kind = ForceLaw::kLinearSpringDashpot;  // whose table it is
};

template <class Real>
struct StepConstants {
  LawTable<Real> law;
  double dt;
  bool clamped;              // normal force never pulls
  bool rolling;              // any rolling friction in the table
  bool damped;               // any tangential damping in the table
  double period[3];          // m; 0: not periodic
  double inverse_period[3];  // 1/m; 0: not periodic
  double nearest2 = 0;       // m^2, least half period: of two that are nearer none is an image
  PlaceGrid grid;            // `single`
  double overlap_cap = 0;    // m, spheres push as if no deeper; 0: none
  Recording recording = Recording::kOff;
  Index groups = 0;            // of particles
  bool wears = false;          // contacts with walls write what they wear off
  bool wear_absolute = false;  // by the velocity of the particle itself, see WearVelocity
  double finnie_force_ratio = 2;
};

// Particles of the whole scene as the last step left them.
template <class Real>
struct ParticleView {
  const Record<Real>* record;
  const Traits<Real>* traits;
  const GridPlace* on_grid = nullptr;  // `single`: of the records
};

// One tile's slice of a pair batch, see soa/pairs.h; blocks from `own` on are imported ones.
template <class Real>
struct PairView {
  const Index* owner;      // kPairPad a block
  const Index* row_begin;  // blocks + 1, into the rows of the batch
  const Index* partner;    // kPairPad a row
  std::uint16_t* open;     // of each row, bits of lanes: who was found a step ago; on return, now
  Index* first_contact;    // of each row, out
  std::size_t own, all;    // blocks
};

// Pairs of a tile that touch or did so in the last step, in the order of its rows and lanes;
// `single` finds some that are next to touching as well, whose histories are zeros. Own ones come
// first; each part is padded to kPairPad by lanes of a particle with itself. Room for all slots of
// the tile and kPairPad more.
struct FoundPairs {
  Index *i, *j, *state;  // state: kTouches, kDidTouch
  std::size_t own = 0, imported = 0;
  std::size_t touching = 0;  // of both parts
  std::size_t imported_begin() const { return (own + kPairPad - 1) / kPairPad * kPairPad; }
};
inline constexpr Index kTouches = 1, kDidTouch = 2;

// What is told of the collisions of a tile's own contacts while they are recorded. Kinds are pairs
// of groups of particles, see pair_kind(). Columns have room for all contacts of the tile and a
// vector more.
template <class Real>
struct PairCollisions {
  double* energies;             // ContactEnergies of each kind; added to
  Real *dissipated, *approach;  // J, of episodes that ended
  Index* ended_kind;
  Real* impact;  // J, of those that began
  Index* begun_kind;
  std::size_t ended = 0, begun = 0;
};
// Of groups a <= b among so many.
inline std::size_t pair_kind(std::size_t groups, std::size_t a, std::size_t b) {
  return a * groups - a * (a + 1) / 2 + b;
}
inline constexpr std::size_t pair_kinds_among(std::size_t groups) {
  return groups * (groups + 1) / 2;
}
inline constexpr std::size_t kMostPairKinds = pair_kinds_among(kMostGroups);

// The numbers of the bits that are set in a byte, ascending; then zeros.
struct SetBits {
  std::uint8_t lane[256][8] = {};
  constexpr SetBits() {
    for (int byte = 0; byte < 256; ++byte) {
      for (std::uint8_t bit = 0, count = 0; bit < 8; ++bit) {
        if ((byte >> bit & 1) != 0) lane[byte][count++] = bit;
      }
    }
  }
};
inline constexpr SetBits kSetBits;

// Sums over the contacts of a tile in one step, and the worst overlap found.
struct ContactTally {
  double work = 0;                // J, work of contact forces on the relative motion, last step
  double elastic = 0;             // J, spring energy now
  double slide = 0;               // J, dissipated by sliding
  double tangential_damping = 0;  // J
  double numerical_loss = 0;      // J, part of the dissipation that is error of the time step
  double model_work = 0;          // J, put into tangential springs by stiffnesses that changed
  double contacts = 0;            // touching pairs
  double warnings = 0;            // contacts deeper than half the smaller radius, or than the cap
  double max_overlap = 0;         // over the smaller radius
  void add(const ContactTally& o) {
    work += o.work;
    elastic += o.elastic;
    slide += o.slide;
    tangential_damping += o.tangential_damping;
    numerical_loss += o.numerical_loss;
    model_work += o.model_work;
    contacts += o.contacts;
    warnings += o.warnings;
    max_overlap = max_overlap > o.max_overlap ? max_overlap : o.max_overlap;
  }
};

// Accumulator rows of a tile whose first particle is `first`.
struct TileRows {
  double* rows;  // (tile_size + 1) x kRowWidth, aligned
  Index first;
  Index size;
};

// Wall contacts of a tile as the narrow phase found them, one lane each, all f64. An entry whose
// overlap is not positive closes a contact (its last force still does work).
struct WallContacts {
  static constexpr int kGeometry = 17;
  // n(3), overlap, n_old(3), overlap_old, wall velocity at the contact point(3), wall spin(3), wall
  // velocity at the contact point of a step ago(3)
  double* geometry[kGeometry];
  Index* particle;
  std::uint32_t* material;  // of the wall
  double* spring[3];
  double* force[3];   // on the particle: last step's on entry, this step's on return
  double* moment[3];  // rolling
  double* wall_work;  // J, out: work of the wall on the particle in this contact and step
  // J, out, of the contact: work on the relative motion, springs, sliding, tangential damping
  double* energies[4];
  double* wear[kWearSums];  // out, if the step wears: of the contact in this step, see wear.h
  std::size_t count;        // padded to kPairPad by the caller; padding has overlap 0 and no force
};

// Moves the particles of one tile by a step.
template <class Real>
struct MoveView {
  const Record<Real>* now;
  Record<Real>* next;
  const Traits<Real>* traits_now;
  Traits<Real>* traits_next;
  GridPlace* on_grid_next;  // `single`, else null
  const PlaceGrid* grid;
  double* spin[3];              // f64 spin, rad/s
  float* rest[3];               // m, what rounding has left of the places
  const double* list_place[3];  // position when the lists were built
  const float* list_velocity[3];
  const float* list_allowance;  // m, allowed distance from the straight line
  double list_time;             // s since the lists were built, at the end of this step
  double kick;                  // s, of the velocities: dt, or dt/2 on the first step
  double gravity[3];
  double low[3], high[3];  // a centre outside is an error
  double drag;             // factor on velocities in settling's soft phase; 1: none
};

struct MoveTally {
  double translational = 0;              // J, 1/2 m v(n-1/2) . v(n+1/2)
  double rotational = 0;                 // J
  double momentum[3] = {0, 0, 0};        // kg m/s, of v(n-1/2)
  double moment_of_mass[3] = {0, 0, 0};  // kg m, sum of m x
  double drag_loss = 0;                  // J, taken out by settling's drag
  double max_deviation2 = 0;             // m^2, from the straight lines of the lists
  double strays = 0;                     // particles that left their lines by more than they may
  double bad = 0;                        // particles not finite or outside
  double fast = 0;                       // particles that move by more than their radius
};

template <class Real>
struct NearContacts;
struct GroupLanes;
struct BodyContacts;

template <class Real>
struct Kernels {
  void (*find_pairs)(const StepConstants<Real>&, const ParticleView<Real>&, const PairView<Real>&,
                     FoundPairs&);
  // The last: null unless collisions are recorded.
  void (*push_pairs)(const StepConstants<Real>&, const ParticleView<Real>&, const FoundPairs&,
                     const HistoryView<Real>& old, const HistoryView<Real>& now, const TileRows&,
                     ContactTally&, PairCollisions<Real>*);
  void (*walls)(const StepConstants<double>&, const ParticleView<Real>&, const WallContacts&,
                const TileRows&, ContactTally&);
  void (*move)(const MoveView<Real>&, const TileRows&, double dt, MoveTally&);
  // Of polyhedra, see body_contacts.h.
  void (*gather_spheres)(const StepConstants<double>&, const ParticleView<Real>&, const Vec3& from,
                         const Index* sphere, std::size_t count, const GroupLanes&);
  void (*push_spheres)(const StepConstants<double>&, const ParticleView<Real>&,
                       const NearContacts<Real>&, const TileRows&, ContactTally&);
  void (*push_bodies)(const StepConstants<double>&, const BodyContacts&);
  const char* target;
};

// The kernels for the best target this CPU and `use_simd_target` allow. Each law is compiled for
// itself: what one costs is nothing to scenes of another. Those of float are of `mixed` or
// `single`.
template <class Real>
Kernels<Real> choose_kernels(ForceLaw law = ForceLaw::kLinearSpringDashpot,
                             Precision precision = Precision::kMixed);
template <>
Kernels<float> choose_kernels<float>(ForceLaw law, Precision precision);
template <>
Kernels<double> choose_kernels<double>(ForceLaw law, Precision);

}  // namespace quern
