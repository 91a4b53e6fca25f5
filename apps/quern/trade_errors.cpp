#include "apps/quern/trade_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soa/base.h"

namespace quern {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

TradeError profile_error(const TradeProfile& of, const TradeProfile& against) {
  TradeError error{"wear_profile", "profile", "%", kUnknown, kUnknown};
  const std::size_t n = of.depth.size();
  if (n == 0 || against.depth.size() != n) return error;
  // The mean size of a normal number of standard deviation 1.
  const double mean_size = std::sqrt(2 / kPi);
  double off = 0, chance = 0, depth = 0;
  for (std::size_t k = 0; k < n; ++k) {
    off += std::abs(of.depth[k] - against.depth[k]);
    chance += mean_size * std::hypot(of.error[k], against.error[k]);
    depth += against.depth[k];
  }
  if (depth == 0) return error;
  error.value = 100 * off / depth;
  error.standard_error = 100 * chance / depth;
  return error;
}

}  // namespace

bool TradeError::known() const { return std::isfinite(value) && std::isfinite(standard_error); }

bool TradeError::below() const { return known() && std::abs(value) < 2 * standard_error; }

double TradeError::bound() const { return below() ? 2 * standard_error : std::abs(value); }

std::vector<TradeError> errors_of(const TradeFigures& of, const TradeFigures& against) {
  std::vector<TradeError> errors;
  for (const TradeFigure& f : of.figures) {
    const auto same = [&](const TradeFigure& other) { return other.name == f.name; };
    const auto found = std::find_if(against.figures.begin(), against.figures.end(), same);
    const double base = found == against.figures.end() ? kUnknown : found->value;
    const double base_error = found == against.figures.end() ? kUnknown : found->standard_error;
    const double scale = !f.relative ? 1 : base != 0 ? 100 / std::abs(base) : kUnknown;
    errors.push_back({f.name, f.label, f.relative ? "%" : f.unit, scale * (f.value - base),
                      scale * std::hypot(f.standard_error, base_error)});
  }
  errors.push_back(profile_error(of.profile, against.profile));
  return errors;
}

std::vector<TradeError> no_errors(const TradeFigures& of) {
  std::vector<TradeError> errors = errors_of(of, of);
  for (TradeError& error : errors) error.value = error.standard_error = 0;
  return errors;
}

}  // namespace quern
