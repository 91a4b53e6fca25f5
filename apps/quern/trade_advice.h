// What accuracy a scene's settings can be expected to give, by the tables of `quern trade` that
// ship with the program (bench/results/trade_*.csv). For `quern check`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quern {

struct ShippedTable {
  std::string_view scene, csv;
};
std::vector<ShippedTable> shipped_tables();

// What of a scene says how accurate it is.
struct JudgedScene {
  double steps_per_contact = 0, impact_overlap = 0;
  std::string precision;
};

// A line for each table and each of time step, softness and precision: the errors of the measured
// setting next to the scene's on the coarse side.
std::vector<std::string> expected_accuracy(const JudgedScene& scene,
                                           const std::vector<ShippedTable>& tables);

}  // namespace quern
