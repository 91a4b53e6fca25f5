// Tallies: the quantities a run reports over time, one row of a table each.
//
// A row's value is computed from sums that the step has made anyway: means over the steps since the
// last record (window), energies now (totals), and the ledger since it was opened. To report another
// quantity, add a function and a row in tally.cpp.
#pragma once

#include <vector>

#include "soa/output.h"
#include "soa/world.h"

namespace quern {

// What a tally may look at; independent of precision.
struct TallyInput {
  double time = 0;       // s
  double mass = 0;       // kg, of all particles
  double particles = 0;  // of any shape
  Vec3 gravity = Vec3::Zero();
  const Window* window = nullptr;
  const StepTotals* totals = nullptr;
  const Ledger* ledger = nullptr;
};

struct TallyRow {
  Quantity quantity;
  double (*value)(const TallyInput&);
  bool of_polyhedra = false;  // reported of scenes that have polyhedra only
};

const std::vector<TallyRow>& tally_rows();
// Those that a scene reports.
std::vector<TallyRow> tally_rows_of(bool polyhedra);

// |W_wall + W_gravity - change of (K + U) - dissipation| over the largest of them.
double ledger_error(const Ledger& ledger);
// Share of the dissipation that is error of the time step.
double numerical_loss_share(const Ledger& ledger);
// Work of normal forces of polyhedra that have no potential, over the dissipation; signed.
double model_work_share(const Ledger& ledger);

}  // namespace quern
