// Phases: how a charge gets from where it was placed to t = 0, and then through the run.
//
//   soft      stiffness * soft_stiffness, a longer step, a drag; until it rests
//   stiffen   stiffness back to the scene's in many small stages, slower than sound crosses the bed,
//             so that the overlaps of the soft phase are given back without a jump of the charge; then
//             the calm (`run.calm`): full stiffness under the same drag. Both take longer, and the
//             drag is less, where the bed is so deep that it swings slower than that
//   relax     of a start with deep overlaps, as after an exchange of shapes (scheduler/exchange):
//             contacts push as if no deeper than a cap, under drag. A contact comes apart no faster than cap sqrt(k / m) over
//             twice its damping ratio, where spring and dashpot cancel, however deep it was; so the
//             cap grows in many stages, by a hundred times, to what carries the charge: the scene's
//             overlap_cap, or a hundredth of the smallest polyhedron's radius, for polyhedra alone
//   settle    the true law and step, no drag: the last 0.1 s of every settling, 0.05 s of a relaxing
//   run       the walls move; time, ledger and records start
#pragma once

#include <vector>

#include "soa/world.h"

namespace quern {

struct PhasePlan {
  Phase kind = Phase::kRun;
  double stiffness = 1;       // factor on all stiffnesses
  double dt = 0;              // s
  double drag = 0;            // 1/s, rate at which velocities decay
  std::uint64_t steps = 0;    // at most
  double rest_energy = 0;     // J, kinetic: the phase ends early below it; 0: runs all its steps
  double overlap_cap = 0;     // share of the cap at the end of relaxing; 0: none
};

inline constexpr double kExchangeRelax = 0.2;  // s, of a charge whose shapes were exchanged

// How long the walls move, s.
double run_time(const Scene& scene);

// The phases of a scene; the last one is the run. `dt` is the true step, `depth` how far particles
// may fall (m).
std::vector<PhasePlan> plan_phases(const Scene& scene, double dt, double depth, double mass,
                                   double smallest_radius);

// Makes the world ready for phase `row`: tables, step, drag, and at the run's start clock and ledger.
template <class Real>
void enter_phase(World<Real>& world, const Scene& scene, const std::vector<PhasePlan>& plan,
                 std::size_t row);

// Whether the phase the world is in has come to its end.
template <class Real>
bool phase_is_over(const World<Real>& world, const PhasePlan& plan);

}  // namespace quern
