// The table of a sweep: a row for each case, with what its summary.json says of the responses.
//
// It is made from the folders alone, in the order of the design, and holds nothing of the machine
// or the clock: the same after any interruption, for any number of threads.
#pragma once

#include "apps/quern/sweep_plan.h"

namespace quern {

struct SweepResponse {
  std::string name;                  // in summary.json
  std::string unit;                  // "1": none
  std::vector<double> value, error;  // of each case; NaN: unknown
};

struct SweepColumn {               // a factor
  std::string key, unit;           // unit: "1" none
  std::vector<std::string> texts;  // of each case
  std::vector<double> numbers;     // empty where not all texts are numbers of one unit
};

struct SweepTable {
  std::vector<SweepColumn> factors;
  // "finished"; "running"; "failed: WHY"; "stopped": begun, nobody works on it now; "missing"
  std::vector<std::string> status;
  std::vector<SweepResponse> responses;
};

SweepTable table_of(const SweepPlan& plan);

// OUT/sweep.csv, sweep.h5, sweep.html.
void write_results(const SweepPlan& plan, const SweepTable& table);

// "power_W" -> "W"
std::string unit_of_response(const std::string& name);

// OUT/sweep.html (sweep_page.cpp).
void write_sweep_page(const SweepPlan& plan, const SweepTable& table);

}  // namespace quern
