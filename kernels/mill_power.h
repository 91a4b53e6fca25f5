// What the formulas of mill design say of a mill's power: Austin, Hogg and Fuerstenau, Morrell. Set
// beside a simulation they tell whether its power is of the right size.
//
// All three are for a dry charge here: no slurry, hence no pool, and one bulk density, the mass of
// the charge over its bulk volume. Bulk volumes are at a porosity of 0.4, as filling levels are
// everywhere in quern. Cones, trunnions, bearings and no-load power are left out: a simulation has
// none. Diameter and length are inside the liner.
#pragma once

#include <string>
#include <vector>

namespace quern {

struct MillLoad {
  double diameter = 0, length = 0;  // m
  double filling = 0;               // bulk volume at porosity 0.4 over the mill's
  double mass = 0;                  // kg
  double rate = 0;                  // rad/s, either sign
};

// 42.3 / sqrt(D) rpm, in rad/s: at which a small particle at the shell is held all around.
double critical_rate(double diameter) noexcept;

// L. G. Austin, A mill power equation for SAG mills, Minerals and Metallurgical Processing 7 (1990)
// 57-63, at the mill shell:
//   10.6 D^2.5 L (1 - 1.03 J) [(1 - e) (rho_s / w_c) J + 0.6 J_B (rho_B - rho_s / w_c)]
//     phi (1 - 0.1 / 2^(9 - 10 phi))   kW, m, t/m^3
// Dry (w_c = 1) and with the porosity e of 0.4 the square bracket is the mass of the charge over
// the volume of the mill, whatever of it is balls. Austin takes e = 0.3, of a bed that holds its
// fines, and w_c = 0.8.
double austin_power(const MillLoad& load) noexcept;  // W

// R. Hogg, D. W. Fuerstenau, Power relationships for tumbling mills, Trans. SME-AIME 252 (1972)
// 418-423, in the form of Moly-Cop's tools, net: a rigid charge whose flat surface stands at the
// dynamic angle alpha,
//   0.238 D^3.5 (L / D) N_c rho_ap (J - 1.065 J^2) sin alpha   kW, D and L in feet, t/m^3
double hogg_fuerstenau_power(const MillLoad& load, double dynamic_angle) noexcept;  // W, rad

// S. Morrell, Power draw of wet tumbling mills and its relationship to charge dynamics. Part 1: a
// continuum approach, Trans. IMM C 105 (1996) 43-53: a charge between toe and shoulder that slides
// in shells. Net power of the cylinder times the factor 1.26 for what the motion of the charge
// costs beyond it (heat, attrition, spin). Worked numbers of two chambers: A. S. Erdem, S. L.
// Ergun, A. H. Benzer, Physicochem. Probl. Miner. Process. 38 (2004) 221-230.
double morrell_net_power(const MillLoad& load) noexcept;  // W, without the factor
inline constexpr double kMorrellFactor = 1.26;

struct PowerFormula {
  std::string name, source, valid;
  double low = 0, high = 0;  // W; equal where the formula gives one number
};

// Empty where the formulas do not apply.
std::vector<PowerFormula> power_formulas(const MillLoad& load);

// Why they do not apply, in one line; empty where they do. They are fitted to industrial mills: the
// mills of the published surveys turn at 48 to 89 % of critical and are filled to 48 % at most
// (Proc. XXXI International Mineral Processing Congress, 2024, 3684-3685). A least filling of 5 %
// and a least diameter of 1 m are our own: below them nothing was published.
std::string why_no_formula(const MillLoad& load);

}  // namespace quern
