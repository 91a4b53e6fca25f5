// Polyhedra: every body of a run that is no sphere, and its contacts.
//
// They are few beside the spheres, and dear. They live apart from Particles, in order of identity for
// life, so that a scene without them holds and does nothing for them. Identities follow those of the
// spheres: body k is particle first_id + k.
//
//   body          its place, half-step velocity, orientation (body to world), angular momentum
//   pairs         two polyhedra; the lower index is j, the other i; the normal points from j to i
//   walls         contacts of polyhedra with walls, sorted by body
//   sphere_batch  spheres near a polyhedron, grouped by tile of the sphere and by polyhedron
//
// Poses, momenta and narrow phase are f64 in every precision.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "soa/collisions.h"
#include "soa/column.h"
#include "soa/report.h"
#include "soa/shapes.h"
#include "soa/state.h"
#include "soa/wall_spring.h"

// X(type, name, unit, doc); see soa/fields.h.
#define QUERN_POLYHEDRON_FIELDS(X)                                                          \
  X(double, x, "m", "place of the centroid")                                                \
  X(double, y, "m", "place of the centroid")                                                \
  X(double, z, "m", "place of the centroid")                                                \
  X(double, vx, "m/s", "half-step velocity")                                                \
  X(double, vy, "m/s", "half-step velocity")                                                \
  X(double, vz, "m/s", "half-step velocity")                                                \
  X(double, qw, "1", "orientation, body to world")                                          \
  X(double, qx, "1", "orientation, body to world")                                          \
  X(double, qy, "1", "orientation, body to world")                                          \
  X(double, qz, "1", "orientation, body to world")                                          \
  X(double, lx, "kg m^2/s", "half-step angular momentum, world frame")                      \
  X(double, ly, "kg m^2/s", "half-step angular momentum, world frame")                      \
  X(double, lz, "kg m^2/s", "half-step angular momentum, world frame")                      \
  X(double, wx, "rad/s", "spin of that momentum in the orientation of now, world frame")    \
  X(double, wy, "rad/s", "spin of that momentum in the orientation of now, world frame")    \
  X(double, wz, "rad/s", "spin of that momentum in the orientation of now, world frame")    \
  X(double, scale, "m", "equivalent radius")                                                \
  X(double, inverse_mass, "1/kg", "")                                                       \
  X(double, inverse_ix, "1/(kg m^2)", "inverse principal moment of inertia")                \
  X(double, inverse_iy, "1/(kg m^2)", "inverse principal moment of inertia")                \
  X(double, inverse_iz, "1/(kg m^2)", "inverse principal moment of inertia")                \
  X(Index, shape, "1", "row of the world's shapes")                                         \
  X(std::uint32_t, material, "1", "row of the scene's materials")                           \
  X(std::uint16_t, species, "1", "row of the scene's [[particles]]")                        \
  X(std::uint32_t, contacts, "1", "contacts of the last step")                              \
  X(double, list_x, "m", "place when the lists were built")                                 \
  X(double, list_y, "m", "place when the lists were built")                                 \
  X(double, list_z, "m", "place when the lists were built")                                 \
  X(float, list_vx, "m/s", "velocity the lists were built with")                            \
  X(float, list_vy, "m/s", "velocity the lists were built with")                            \
  X(float, list_vz, "m/s", "velocity the lists were built with")                            \
  X(float, list_allowance, "m", "how far it may leave its line before the lists are stale") \
  X(double, list_qw, "1", "orientation when the lists were built")                          \
  X(double, list_qx, "1", "orientation when the lists were built")                          \
  X(double, list_qy, "1", "orientation when the lists were built")                          \
  X(double, list_qz, "1", "orientation when the lists were built")                          \
  X(float, list_turn, "m", "how far its points may turn before the lists are stale")

namespace quern {

// A listed pair of polyhedra: what it keeps from step to step. Plain data, saved as bytes; vectors in
// the world frame.
struct PolyhedronPair {
  Index j = 0, i = 0;           // j < i
  float axis[3] = {0, 0, 0};    // of the narrow phase, see kernels/pairs/polyhedron_polyhedron.h
  float gap = 0;
  std::uint32_t axis_flags = 0;
  std::uint32_t touching = 0;
  Vec3 spring = Vec3::Zero();   // tangential spring, m
  Vec3 force = Vec3::Zero();    // on i, N
  Vec3 moment = Vec3::Zero();   // patch moment on i, N m
  Vec3 normal = Vec3::Zero();   // unit, from j to i
  Vec3 arm_i = Vec3::Zero();    // contact point from the place of i, m
  Vec3 arm_j = Vec3::Zero();    // and of j
  double overlap = 0;           // m
  double elastic_force = 0;     // N, of the normal spring, before damping's reduction
  double stored = 0;            // J, likewise
  Vec3 couple = Vec3::Zero();   // N m on i, of the volume model, likewise
};
static_assert(sizeof(PolyhedronPair) == 8 + 24 + 7 * 24 + 24, "saved as bytes: no hidden padding");

// An open contact of a polyhedron with a wall; `particle` is the body, `moment` the patch's.
struct PolyhedronWall : WallSpring {
  double elastic_force = 0, stored = 0;  // as above
  Vec3 couple = Vec3::Zero();
  Vec3 arm = Vec3::Zero();  // contact point from the place of the body, m
};
static_assert(sizeof(PolyhedronWall) == sizeof(WallSpring) + 64, "saved as bytes");
static_assert(sizeof(Fallbacks) == 3 * 8, "saved as a block");

// Spheres near polyhedra. Groups of a tile: [tile_begin[t] .. tile_begin[t+1]); group g holds `count[g]`
// spheres in slots [begin[g] .. begin[g+1]), padded to kShapePad by repeating the first sphere.
// History of a slot, in one piece because few slots of a group have one: spring x y z, force on the
// sphere x y z, normal x y z and overlap of the last step, contact point from the polyhedron's place
// x y z, and the episode as spheres have it (zeros unless collisions are recorded).
//
// Sums and flags spare work, they change no result: they are not saved.
template <class Real>
struct PolyhedronSphereBatch {
  static constexpr std::size_t kHistory = 13, kHistoryStride = 16;
  static constexpr std::size_t kForceEnd = 6, kOverlap = 9, kEpisode = 13;
  Column<Index> tile_begin, polyhedron, count, begin, sphere;
  Column<Real> numbers;
  // Not saved:
  Column<double> sums;  // kSums a group: force and torque on the polyhedron, contacts
  static constexpr std::size_t kSums = 8;
  Column<std::uint8_t> has_sums;  // of each group: its sums are not all zero
  Column<std::uint8_t> open;      // a bit for each slot, see is_open()

  Real& number(std::size_t slot, std::size_t k) { return numbers[slot * kHistoryStride + k]; }
  Real number(std::size_t slot, std::size_t k) const { return numbers[slot * kHistoryStride + k]; }
  // Touching, or with a last force whose work is still to be booked.
  bool is_open(std::size_t slot) const {
    for (std::size_t k = 0; k < kForceEnd; ++k) {
      if (number(slot, k) != 0) return true;
    }
    return number(slot, kOverlap) > 0;
  }
  // For so many groups and slots.
  void reset(std::size_t groups, std::size_t slots) {
    polyhedron.reset(groups);
    count.reset(groups);
    begin.reset(groups + 1);
    sphere.reset(slots);
    numbers.reset(slots * kHistoryStride);
  }
  // After the groups and their history have been set.
  void set_unsaved() {
    const std::size_t groups = polyhedron.size();
    sums.reset(groups * kSums);
    sums.fill(0);
    has_sums.reset(groups);
    has_sums.fill(0);
    open.reset(sphere.size() / kShapePad);
    open.fill(0);
    for (std::size_t slot = 0; slot < sphere.size(); ++slot) {
      if (is_open(slot)) open[slot / kShapePad] |= static_cast<std::uint8_t>(1u << slot % kShapePad);
    }
  }
  void visit(StateVisitor& v) {
    v.column("polyhedra/spheres/tile_begin", "1", tile_begin, 1);
    v.column("polyhedra/spheres/polyhedron", "1", polyhedron, 1);
    v.column("polyhedra/spheres/count", "1", count, 1);
    v.column("polyhedra/spheres/begin", "1", begin, 1);
    v.column("polyhedra/spheres/sphere", "1", sphere, 1);
    v.column("polyhedra/spheres/history", "m, N, 1, m, m", numbers, kShapePad);
    QUERN_CHECK(numbers.size() == sphere.size() * kHistoryStride);
    set_unsaved();
  }
};

template <class Real>
struct Polyhedra {
  Index first_id = 0;
#define QUERN_DECLARE(type, name, unit, doc) Column<type> name;
  QUERN_POLYHEDRON_FIELDS(QUERN_DECLARE)
#undef QUERN_DECLARE
  std::vector<PolyhedronPair> pairs;   // sorted by (j, i)
  std::vector<PolyhedronWall> walls;   // open contacts, by body
  std::vector<Episode> pair_episodes, wall_episodes;  // of each, while collisions are recorded
  std::vector<Index> wall_candidate_begin, wall_candidate_body, wall_candidate_facet_begin,
      wall_candidate_facet;  // entries of body k: [wall_candidate_begin[k] .. [k+1]), one a wall body
  PolyhedronSphereBatch<Real> spheres;
  Fallbacks fallbacks;  // summed over steps

  std::size_t size() const { return x.size(); }
  bool empty() const { return x.empty(); }
  Vec3 place(std::size_t k) const { return {x[k], y[k], z[k]}; }
  Vec3 velocity(std::size_t k) const { return {vx[k], vy[k], vz[k]}; }
  Vec3 spin(std::size_t k) const { return {wx[k], wy[k], wz[k]}; }
  Vec3 momentum(std::size_t k) const { return {lx[k], ly[k], lz[k]}; }
  Quat orientation(std::size_t k) const { return Quat(qw[k], qx[k], qy[k], qz[k]); }
  Quat list_orientation(std::size_t k) const {
    return Quat(list_qw[k], list_qx[k], list_qy[k], list_qz[k]);
  }
  Vec3 inverse_inertia(std::size_t k) const { return {inverse_ix[k], inverse_iy[k], inverse_iz[k]}; }

  void visit(StateVisitor& v, bool episodes) {
#define QUERN_VISIT(type, name, unit, doc) v.column("polyhedra/" #name, unit, name, 1);
    QUERN_POLYHEDRON_FIELDS(QUERN_VISIT)
#undef QUERN_VISIT
    visit_bytes(v, "polyhedra/pairs", "m, N, N m, 1", pairs);
    visit_bytes(v, "polyhedra/walls", "m, N, N m", walls);
    if (episodes) {
      visit_rows(v, "polyhedra/pair_episodes", "J", pair_episodes);
      visit_rows(v, "polyhedra/wall_episodes", "J", wall_episodes);
    }
    visit_bytes(v, "polyhedra/wall_candidate_begin", "1", wall_candidate_begin);
    visit_bytes(v, "polyhedra/wall_candidate_body", "1", wall_candidate_body);
    visit_bytes(v, "polyhedra/wall_candidate_facet_begin", "1", wall_candidate_facet_begin);
    visit_bytes(v, "polyhedra/wall_candidate_facet", "1", wall_candidate_facet);
    v.values("polyhedra/first_id", "1", ElementType::kU32, &first_id, 1);
    v.later_values("polyhedra/fallbacks", "1", ElementType::kU64, &fallbacks, 3);
    spheres.visit(v);
  }
  void resize(std::size_t n) {
#define QUERN_RESIZE(type, name, unit, doc) name.resize(n);
    QUERN_POLYHEDRON_FIELDS(QUERN_RESIZE)
#undef QUERN_RESIZE
  }

 private:
  // A vector of plain rows as a column of bytes and back.
  template <class Row>
  static void visit_bytes(StateVisitor& v, const char* name, const char* unit,
                          std::vector<Row>& rows) {
    Column<std::uint8_t> bytes;
    bytes.reset(rows.size() * sizeof(Row));
    if (!rows.empty()) std::memcpy(bytes.data(), rows.data(), rows.size() * sizeof(Row));
    v.column(name, unit, bytes, sizeof(Row));
    rows.resize(bytes.size() / sizeof(Row));
    if (!rows.empty()) {
      std::memcpy(static_cast<void*>(rows.data()), bytes.data(), rows.size() * sizeof(Row));
    }
  }
};

}  // namespace quern
