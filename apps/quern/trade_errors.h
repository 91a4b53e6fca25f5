// What settings of `quern trade` are compared by, and how far two of them are apart.
#pragma once

#include <string>
#include <vector>

namespace quern {

struct TradeFigure {
  std::string name;                      // in files: "power_W"
  std::string label;                     // in tables
  std::string unit;                      // of the value
  bool relative = true;                  // its error is told in percent; else in its unit
  double value = 0, standard_error = 0;  // NaN: unknown
};

// What the run wore off along the section of the liner, mean of the lifters with its standard
// error.
struct TradeProfile {
  std::vector<double> arc, depth, error;
};

struct TradeFigures {
  std::vector<TradeFigure> figures;
  TradeProfile profile;
  // Of the setting itself, whatever it is compared with.
  double time_step = 0, steps_per_contact = 0, impact_overlap = 0;
  double restitution_asked = 1, restitution_delivered = 1, restitution_scatter = 0;
  double ledger_error = 0, numerical_loss = 0;
};

struct TradeError {
  std::string name, label, unit;         // unit "%" where relative
  double value = 0, standard_error = 0;  // of the difference
  bool known() const;                    // both are numbers
  // No more than chance shows: below two standard errors.
  bool below() const;
  // What the error is at most, as far as this can tell: |value|, or two standard errors.
  double bound() const;
};

// Figure by figure, in the order of `of`, then "wear_profile": the mean difference of depths over
// the mean depth; its standard error is what two runs of one setting would show.
std::vector<TradeError> errors_of(const TradeFigures& of, const TradeFigures& against);

// Against itself a setting has no error, by chance either.
std::vector<TradeError> no_errors(const TradeFigures& of);

}  // namespace quern
