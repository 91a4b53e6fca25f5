// Ledger: the energy account of a run since it was opened; see scheduler/README.md.
#pragma once

namespace quern {

struct Ledger {
  double open = 0;  // 1 once the opening energies are known
  double start_kinetic = 0, start_elastic = 0;
  double kinetic = 0, elastic = 0;  // now
  double wall_work = 0, gravity_work = 0, contact_work = 0;
  double slide = 0, tangential_damping = 0, numerical_loss = 0;
  // By forces that have no potential (normal ones of polyhedra, tangential ones of springs whose
  // stiffness changes); in dissipated().
  double model_work = 0;
  double drag_loss = 0;   // taken by the drag of settling; not in dissipated()
  double abs_wall_work = 0;
  double dissipated() const { return -contact_work - (elastic - start_elastic); }
  double normal_damping() const { return dissipated() - slide - tangential_damping; }
};

}  // namespace quern
