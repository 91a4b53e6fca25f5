// Stepper: one step of a run, as a list of stages.
//
//   lists stale? rebuild -> move walls -> tiles { wall contacts, pair contacts, move, tally }
//   -> swap -> add up tiles in order -> ledger; polyhedra: scheduler/polyhedron_step.h
//
// What each stage reads and writes is in scheduler/README.md. The stepper owns scratch only: all
// state is in the World, and the result does not depend on the number of threads.
#pragma once

#include <optional>
#include <vector>

#include "kernels/contact.h"
#include "kernels/tile_pairs.h"
#include "kernels/wall_contacts.h"
#include "kernels/wear.h"
#include "scheduler/graph.h"
#include "scheduler/polyhedron_step.h"
#include "scheduler/rebuild.h"
#include "scheduler/relist.h"
#include "scheduler/stage_times.h"
#include "soa/world.h"

namespace quern {

template <class Real>
class Stepper {
 public:
  Stepper(World<Real>& world, int threads);

  StepReport step();

  Graph& graph() { return graph_; }
  // Since the stepper was made or this was last called.
  StageTimes take_times();
  const char* target() const { return kernels_.target; }
  // What it has made for polyhedra: null in a scene without them.
  const BodyStepper<Real>* bodies() const { return bodies_ ? &*bodies_ : nullptr; }

 private:
  struct Worker {
    Column<double> rows;
    PairScratch<Real> pairs;
    WallLanes lanes;
    BusyTimes times;
  };
  struct TileTotals {
    ContactTally pairs, walls;
    double near_bodies = 0;  // contacts among `pairs` of spheres with polyhedra
    MoveTally move;
    Offender odd;            // the first contact that brought in what is not finite
  };

  void prepare();
  void place_on_grid();
  void move_walls();
  void run_tile(std::size_t tile, int worker);
  void run_walls(std::size_t tile, Worker& worker, const TileRows& rows,
                 CollisionTally* collisions);
  void run_tasks(bool rebuilt);
  void add_tiles();
  void add_wear();
  void account();
  void account_collisions();
  StepReport judge() const;
  Offender find_odd() const;
  void note_odd_pair(std::size_t tile, const Worker& worker);
  void note_odd_wall(std::size_t tile);
  bool relist_strays();
  void judge_lists();

  World<Real>& world_;
  Graph graph_;
  Kernels<Real> kernels_;
  RebuildScratch<Real> rebuild_;
  Relister<Real> relister_;
  StepConstants<Real> constants_{};
  StepConstants<double> wall_constants_{};
  Column<GridPlace> on_grid_, on_grid_next_;  // `single`: of the records now and next
  std::vector<Worker> workers_;
  std::vector<TileTotals> tile_totals_;
  std::vector<WallTotal> tile_walls_;  // tiles x walls
  std::vector<WearList> tile_wear_;    // where wear is recorded
  std::vector<CollisionTally> tile_collisions_;  // while they are recorded
  std::vector<std::vector<KnownTouch>> known_touches_;  // of each tile's candidates for walls
  std::optional<BodyStepper<Real>> bodies_;
  double fast_ = 0;  // particles that moved by more than their radius in this step
  StageTimes times_;
};

// The first particle that makes `bits` true, found by looking at all of them: for error messages.
template <class Real>
Offender find_offender(const World<Real>& world, std::uint32_t bits);

// After a step: the first particle that moved in it by more than its radius (a polyhedron: its inner
// one) relative to a wall that was within its way, and so may have passed through; kNoIndex: none.
template <class Real>
Offender find_too_fast(const World<Real>& world);

}  // namespace quern
