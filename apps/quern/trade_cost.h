// What a setting costs: time for a second of the mill over that of the default, interleaved.
//
// Both runs go on from where they ended, in turns of the same simulated time, so that whatever else
// the machine does falls on both. Their states are not written back.
#pragma once

#include <memory>
#include <string>

namespace quern {

// A finished run that can be taken on.
class TimedRun {
 public:
  virtual ~TimedRun() = default;
  // Takes the run on for `time` (s); returns the wall clock it took (s), without a warm-up before
  // it that the clock of the run does not see. Throws UserError where it goes wrong.
  virtual double take(double time) = 0;
};
std::unique_ptr<TimedRun> open_run(const std::string& folder, int threads);

struct TradeCost {
  double ratio = 1, low = 1, high = 1;  // median of the turns, and its quartiles
  double seconds = 0;                   // wall clock for a second of the mill, median
};

// `folder`/cost.json, measured if it is not there. `segment`: s, what a turn of the default takes.
TradeCost cost_of(const std::string& folder, const std::string& default_folder, int threads,
                  double segment);

}  // namespace quern
