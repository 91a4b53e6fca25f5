// What the recorded window as a whole says: whether the run was steady, where the charge's centre
// hangs, and what the power formulas of mill design make of the mill.
#pragma once

#include <string>

#include "io/series.h"
#include "io/summary.h"
#include "soa/output.h"
#include "soa/scene.h"

namespace quern {

struct RecordedWindow {
  double from = 0, to = 0;    // s
  std::size_t first_row = 0;  // of the series
};

struct WindowLines {  // for the log; empty: nothing to say
  std::string steady, formulas, warning;
};

// Rows of the summary (steady, drifts, dynamic_angle_deg, power_formula_...) and the table
// /formulas. `mass` of the charge in kg; `frame` for its volume.
WindowLines report_window(const Scene& scene, const RecordedWindow& window,
                          const ParticleFrame& frame, double mass, SeriesWriter& series,
                          Summary& summary);

}  // namespace quern
