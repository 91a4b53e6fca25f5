#include "kernels/mill_power.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "soa/base.h"

namespace quern {
namespace {

constexpr double kGravity = 9.81;  // of mills on earth: the formulas are fitted to them
constexpr double kFoot = 0.3048;
constexpr double kDegree = kPi / 180;
constexpr double kLeastAngle = 35 * kDegree, kMostAngle = 45 * kDegree;

constexpr double kLeastSpeed = 0.48, kMostSpeed = 0.89, kLeastFilling = 0.05, kMostFilling = 0.48;
constexpr double kLeastDiameter = 1;  // m

double speed_share(const MillLoad& load) noexcept {
  return std::abs(load.rate) / critical_rate(load.diameter);
}

double mill_volume(const MillLoad& load) noexcept {
  return 0.25 * kPi * load.diameter * load.diameter * load.length;
}

// t/m^3
double bulk_density(const MillLoad& load) noexcept {
  return 1e-3 * load.mass / (load.filling * mill_volume(load));
}

// Morrell's picture of the charge: angles in rad counterclockwise from +x of a mill that turns
// counterclockwise, the toe below its own -x axis.
struct ContinuumCharge {
  double toe, shoulder;
  double inner;    // m, radius of the charge's inner surface
  double packing;  // z: 1 would let the rate rise linearly from the inner surface to the shell
};

ContinuumCharge continuum_charge(const MillLoad& load) noexcept {
  const double filling = load.filling, radius = 0.5 * load.diameter, phi = speed_share(load);
  const double turns = std::abs(load.rate) / (2 * kPi);  // a second
  const double centrifuging = std::max(0.35 * (3.364 - filling), phi);
  ContinuumCharge charge{};
  charge.toe =
      0.5 * kPi + 2.5307 * (1.2796 - filling) * (1 - std::exp(-19.42 * (centrifuging - phi)));
  charge.shoulder = 0.5 * kPi - (charge.toe - 0.5 * kPi) *
                                    (0.3386 + 0.1041 * phi + (1.54 - 2.5673 * phi) * filling);
  const double way = 2 * kPi + charge.shoulder - charge.toe;  // through the charge
  const double mean = 0.5 * radius * (1 + std::sqrt(1 - 2 * kPi * filling / way));
  const double carried = way / (2 * kPi * 0.5 * turns);  // s, from toe to shoulder
  const double falling =
      std::sqrt(2 * mean * (std::sin(charge.shoulder) - std::sin(charge.toe)) / kGravity);
  const double active = carried / (carried + falling);  // the share of the charge not in flight
  charge.inner = radius * std::sqrt(1 - 2 * kPi * active * filling / way);
  charge.packing = std::pow(1 - filling, 0.4532);
  return charge;
}

[[gnu::format(printf, 1, 2)]] std::string line(const char* format, ...) {
  char text[160];
  va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return text;
}

}  // namespace

double critical_rate(double diameter) noexcept { return 42.3 / std::sqrt(diameter) * 2 * kPi / 60; }

double austin_power(const MillLoad& load) noexcept {
  const double phi = speed_share(load);
  const double mass = 1e-3 * load.mass / mill_volume(load);
  return 1e3 * 10.6 * std::pow(load.diameter, 2.5) * load.length * (1 - 1.03 * load.filling) *
         mass * phi * (1 - 0.1 / std::exp2(9 - 10 * phi));
}

double hogg_fuerstenau_power(const MillLoad& load, double dynamic_angle) noexcept {
  const double filling = load.filling;
  return 1e3 * 0.238 * std::pow(load.diameter / kFoot, 3.5) * (load.length / load.diameter) *
         speed_share(load) * bulk_density(load) * (filling - 1.065 * filling * filling) *
         std::sin(dynamic_angle);
}

double morrell_net_power(const MillLoad& load) noexcept {
  const ContinuumCharge charge = continuum_charge(load);
  const double r = 0.5 * load.diameter, ri = charge.inner, z = charge.packing;
  const double turns = std::abs(load.rate) / (2 * kPi);
  const double density = 1e3 * bulk_density(load), span = r - z * ri;
  const double lifted = kPi * kGravity * load.length * turns * r / (3 * span) *
                        (2 * r * r * r - 3 * z * r * r * ri + ri * ri * ri * (3 * z - 2)) *
                        density * (std::sin(charge.shoulder) - std::sin(charge.toe));
  const double thrown = load.length * density * std::pow(kPi * turns * r / span, 3) *
                        (std::pow(span, 4) - std::pow(ri, 4) * std::pow(z - 1, 4));
  return lifted + thrown;
}

std::string why_no_formula(const MillLoad& load) {
  const double phi = speed_share(load);
  if (!(load.rate != 0) || !(load.mass > 0)) return "it stands still or is empty";
  if (load.diameter < kLeastDiameter) {
    return line("its diameter of %.3g m is below %.3g m (they are of industrial mills)",
                load.diameter, kLeastDiameter);
  }
  if (phi < kLeastSpeed || phi > kMostSpeed) {
    return line("it turns at %.1f %% of critical, not at %.0f to %.0f %%", 100 * phi,
                100 * kLeastSpeed, 100 * kMostSpeed);
  }
  if (load.filling < kLeastFilling || load.filling > kMostFilling) {
    return line("it is filled to %.1f %%, not to %.0f to %.0f %%", 100 * load.filling,
                100 * kLeastFilling, 100 * kMostFilling);
  }
  return {};
}

std::vector<PowerFormula> power_formulas(const MillLoad& load) {
  if (!why_no_formula(load).empty()) return {};
  const std::string survey = "48 to 89 % of critical, filling to 48 %";
  const double austin = austin_power(load), morrell = kMorrellFactor * morrell_net_power(load);
  return {{"Austin", "Minerals and Metallurgical Processing 7 (1990) 57, dry, porosity 0.4",
           "SAG mills; " + survey, austin, austin},
          {"Hogg-Fuerstenau", "Trans. SME-AIME 252 (1972) 418, dynamic angle 35 to 45 degrees",
           "no flight, no slip; " + survey, hogg_fuerstenau_power(load, kLeastAngle),
           hogg_fuerstenau_power(load, kMostAngle)},
          {"Morrell C", "Trans. IMM C 105 (1996) 43, cylinder, dry, net power times 1.26",
           "ball, SAG and AG mills, 9.8 % (95 %, 82 data sets); " + survey, morrell, morrell}};
}

}  // namespace quern
