// The angles of the charge with their errors: shoulder, toe, head, impact toe of a recorded window
// that was cut into blocks of time, ten in a run.
//
// The value of an angle is found in the map and the histogram of the whole window; its standard
// error is the scatter of what the blocks show over the root of their number; how much it hangs on
// the definition is seen with the bulk cut at 0.4 and at 0.6 of the bed's solid fraction.
#pragma once

#include <span>

#include "soa/charge_shape.h"

namespace quern {

// `maps`: of consecutive blocks, on one grid, at least one. `liner`: the histograms of the same
// blocks, or none. A run that stopped early has as many maps as ever and empty histograms at the
// end: then each histogram is read with the shape of the whole window.
ChargeAngles find_charge_angles(std::span<const ChargeMap> maps,
                                std::span<const LinerHistogram> liner, const ChargeQuery& query);

// Of values that may be NaN (not found) and may lie on any turn: standard deviation and standard
// error about their mean, on the turn nearest to `value`; NaN for fewer than two.
double angle_spread(double value, std::span<const double> found);
double angle_error(double value, std::span<const double> found);

}  // namespace quern
