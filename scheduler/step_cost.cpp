#include "scheduler/step_cost.h"

#include "kernels/candidates.h"
#include "kernels/polyhedron_contacts.h"
#include "kernels/wall_contacts.h"
#include "scheduler/graph.h"
#include "scheduler/rebuild.h"

namespace quern {

namespace {

constexpr double kBoth = 2;  // read and written
constexpr double kIndex = sizeof(Index);

template <class Row>
double bytes_of(const std::vector<Row>& rows) {
  return static_cast<double>(rows.size() * sizeof(Row));
}
double bytes_of(const ColumnBase& column) {
  return static_cast<double>(column.size() * column.element_bytes());
}

void add(const Operations& each, double count, Operations& to) {
  to.real += each.real * count;
  to.f64 += each.f64 * count;
}

struct SlotCount {
  double listed = 0, open = 0;
};

// Slots with a pair, of own and imported blocks, and those of them that touch.
template <class Real>
SlotCount count_slots(const PairBatch<Real>& pairs) {
  SlotCount count;
  for (std::size_t block = 0; block < pairs.blocks(); ++block) {
    for (std::size_t row = pairs.row_begin[block]; row < pairs.row_begin[block + 1]; ++row) {
      for (std::size_t lane = 0; lane < kPairPad; ++lane) {
        const std::size_t slot = row * kPairPad + lane;
        if (pairs.owner[block * kPairPad + lane] == pairs.partner[slot]) continue;
        count.listed += 1;
        if (pairs.is_open(slot)) count.open += 1;
      }
    }
  }
  return count;
}

template <class Real>
void count_spheres(const World<Real>& world, StepCost& cost) {
  const auto bytes = [&](Stage stage) -> double& {
    return cost.bytes[static_cast<std::size_t>(stage)];
  };
  const auto listed = [&](Stage stage) -> double& {
    return cost.listed[static_cast<std::size_t>(stage)];
  };
  const Particles<Real>& p = world.particles;
  const PairBatch<Real>& pairs = world.pairs;
  const double n = static_cast<double>(p.size());
  for (const TileWalls& walls : world.tile_walls) {
    const WallCandidates& c = walls.candidates;
    listed(Stage::kSphereWalls) += static_cast<double>(c.facet.size());
    bytes(Stage::kSphereWalls) += bytes_of(c.particle) + bytes_of(c.body) + bytes_of(c.first) +
                                  bytes_of(c.facet) + kBoth * bytes_of(walls.springs) +
                                  static_cast<double>(c.particle.size() * sizeof(KnownTouch));
  }
  const SlotCount slots = count_slots(pairs);
  const double histories = slots.open * static_cast<double>(pairs.history() * sizeof(Real));
  for (const Index count : p.pair_count) listed(Stage::kSpherePairs) += count;
  cost.slots = static_cast<double>(pairs.slots());
  bytes(Stage::kSpherePairs) =
      bytes_of(pairs.owner) + bytes_of(pairs.row_begin) + bytes_of(pairs.partner) +
      kBoth * (bytes_of(pairs.open) + histories) + bytes_of(pairs.first_contact);
  bytes(Stage::kMotion) += kBoth * (bytes_of(p.record) + bytes_of(p.traits));
  for (const ColumnBase* column : std::initializer_list<const ColumnBase*>{
           &p.spin_x, &p.spin_y, &p.spin_z, &p.rest_x, &p.rest_y, &p.rest_z}) {
    bytes(Stage::kMotion) += kBoth * bytes_of(*column);
  }
  const bool on_grid = world.precision == Precision::kSingle;
  if (on_grid) {
    bytes(Stage::kSpherePairs) += n * sizeof(GridPlace);
    bytes(Stage::kMotion) += n * sizeof(GridPlace);
  }
  for (const ColumnBase* column :
       std::initializer_list<const ColumnBase*>{&p.list_x, &p.list_y, &p.list_z, &p.list_vx,
                                                &p.list_vy, &p.list_vz, &p.list_allowance}) {
    bytes(Stage::kMotion) += bytes_of(*column);
  }

  constexpr double kKeys = 2 * kBoth * sizeof(CurveKey) + kBoth * 2 * kIndex;  // sorted; orders
  constexpr double kLine = 3 * sizeof(double) + 4 * sizeof(float);
  constexpr double kEntry = 8 * sizeof(float) + kIndex;  // of the grid
  constexpr double kSearch = sizeof(SearchPoint) + sizeof(StagedEntry) + kEntry;
  double sorting = n * kKeys;
#define QUERN_COUNT(type, name, unit, doc) sorting += kBoth * bytes_of(p.name);
  QUERN_PARTICLE_FIELDS(QUERN_COUNT)
#undef QUERN_COUNT
  cost.rebuild_bytes += sorting / static_cast<double>(kSortEvery) +
                        n * (sizeof(Record<Real>) + kLine + kBoth * kSearch) +
                        kBoth * (slots.listed * sizeof(CandidatePair) + bytes_of(pairs.partner) +
                                 histories);

  add(on_grid ? kOfSlotOnGrid : kOfIdleSlot, slots.listed, cost.operations);
  add(kOfTouchingSlot, slots.open, cost.operations);
  if (world.damped) add(kOfDamping, slots.open, cost.operations);
  if (world.rolling) add(kOfRolling, slots.open, cost.operations);
  if (world.force_law == ForceLaw::kHertzMindlin) add(kOfHertzMindlin, slots.open, cost.operations);
  add(kOfMotion, n, cost.operations);
}

template <class Real>
void count_polyhedra(const World<Real>& world, StepCost& cost) {
  const auto bytes = [&](Stage stage) -> double& {
    return cost.bytes[static_cast<std::size_t>(stage)];
  };
  const auto listed = [&](Stage stage) -> double& {
    return cost.listed[static_cast<std::size_t>(stage)];
  };
  const Polyhedra<Real>& p = world.polyhedra;
  const PolyhedronSphereBatch<Real>& near = p.spheres;
  double open = 0, sums = 0, touching = 0;
  for (const Index count : near.count) listed(Stage::kPolyhedronSpheres) += count;
  for (const std::uint8_t flags : near.open) open += __builtin_popcount(flags);
  for (const std::uint8_t has : near.has_sums) sums += has;
  for (const PolyhedronPair& pair : p.pairs) touching += pair.touching != 0 ? 1 : 0;
  listed(Stage::kPolyhedronPairs) = static_cast<double>(p.pairs.size());
  listed(Stage::kPolyhedronWalls) = static_cast<double>(p.wall_candidate_facet.size());
  bytes(Stage::kPolyhedronSpheres) =
      bytes_of(near.polyhedron) + bytes_of(near.count) + bytes_of(near.begin) +
      bytes_of(near.sphere) + bytes_of(near.open) + bytes_of(near.has_sums) +
      kBoth * (sums * static_cast<double>(near.kSums * sizeof(double)) +
               open * static_cast<double>(near.kHistoryStride * sizeof(Real)));
  bytes(Stage::kPolyhedronPairs) = listed(Stage::kPolyhedronPairs) *
                                       static_cast<double>(sizeof(PairBodies) + sizeof(Apart) + 1) +
                                   kBoth * touching * sizeof(PolyhedronPair);
  bytes(Stage::kPolyhedronWalls) =
      bytes_of(p.wall_candidate_begin) + bytes_of(p.wall_candidate_body) +
      bytes_of(p.wall_candidate_facet_begin) + bytes_of(p.wall_candidate_facet) +
      static_cast<double>(p.wall_candidate_body.size() * sizeof(ApartFromWall)) +
      2 * kBoth * bytes_of(p.walls);
  // Place, velocity, orientation, momentum, spin and contacts; scale, mass, inertia, shape,
  // material and list_*.
  constexpr double kState = 16 * sizeof(double) + kIndex;
  constexpr double kRest = (1 + 4 + 7) * sizeof(double) + 5 * sizeof(float) + 2 * kIndex;
  bytes(Stage::kMotion) +=
      static_cast<double>(p.size()) * (kBoth * (kState + sizeof(BodyNow)) + kRest);
}

}  // namespace

void StepCost::add(const StepCost& o, double share) {
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    listed[k] += share * o.listed[k];
    bytes[k] += share * o.bytes[k];
  }
  slots += share * o.slots;
  rebuild_bytes += share * o.rebuild_bytes;
  operations.real += share * o.operations.real;
  operations.f64 += share * o.operations.f64;
}

template <class Real>
StepCost count_step(const World<Real>& world) {
  StepCost cost;
  count_spheres(world, cost);
  if (!world.polyhedra.empty()) count_polyhedra(world, cost);
  return cost;
}

template StepCost count_step(const World<float>&);
template StepCost count_step(const World<double>&);

}  // namespace quern
