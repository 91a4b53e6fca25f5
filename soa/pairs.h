// PairBatch: the listed pairs of one pair type, tile by tile, with their spring history.
//
//   tile t:  [begin[t] ............ own_end[t]) [own_end[t] ......... begin[t+1])
//             own: i is in this tile, sorted      imported: j is in this tile, i in another;
//             by (i, j); tallied here             evaluated here too, from the same bits
//
// Both parts are padded to kPairPad slots with i == j, so kernels have no tails. i is the partner with
// the smaller radius, ties by lower identity, for life. History of a slot: tangential spring and the
// force on i in the last step (and the rolling moment, if the scene has rolling friction).
#pragma once

#include <vector>

#include "soa/column.h"
#include "soa/state.h"

namespace quern {

template <class Real>
struct PairBatch {
  Column<Index> i, j;
  Column<Real> spring[3], force[3], moment[3];
  Column<Index> begin, own_end;
  bool rolling = false;

  void reset(std::size_t slots) {
    i.reset(slots);
    j.reset(slots);
    for (int k = 0; k < 3; ++k) {
      spring[k].reset(slots);
      force[k].reset(slots);
      moment[k].reset(rolling ? slots : 0);
    }
  }
  void visit(StateVisitor& v) {
    v.column("pairs/i", "1", i, 1);
    v.column("pairs/j", "1", j, 1);
    v.column("pairs/begin", "1", begin, 1);
    v.column("pairs/own_end", "1", own_end, 1);
    const char* springs[] = {"pairs/spring_x", "pairs/spring_y", "pairs/spring_z"};
    const char* forces[] = {"pairs/force_x", "pairs/force_y", "pairs/force_z"};
    const char* moments[] = {"pairs/moment_x", "pairs/moment_y", "pairs/moment_z"};
    for (int k = 0; k < 3; ++k) {
      v.column(springs[k], "m", spring[k], 1);
      v.column(forces[k], "N", force[k], 1);
      v.column(moments[k], "N m", moment[k], 1);
    }
  }
};

}  // namespace quern
