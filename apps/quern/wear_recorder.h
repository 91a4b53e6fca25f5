// What a run with [wear] leaves: tables /wear, /wear_profile and /wear_of_groups of run.h5, figures
// of the summary, a line of the log. All from the sums that are state of the world, so that a
// resumed run writes what one run would have.
#pragma once

#include <string>

#include "io/series.h"
#include "io/summary.h"
#include "soa/world.h"

namespace quern {

// Returns the line. The world's wear is asked for.
template <class Real>
std::string write_wear(const World<Real>& world, const Scene& scene, SeriesWriter& series,
                       Summary& summary);

}  // namespace quern
