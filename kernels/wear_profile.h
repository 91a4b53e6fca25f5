// Wear along one pitch of a mill with lifters, from the middle of the shell before a lifter to that
// behind it, averaged over the lifters, which are alike.
//
//      bins, none over a corner            A cell's volume is spread over the bins as its area is;
//         .-------.                        what lies beyond the mill's length (the shell of a
//   -----/         \-----                  periodic mill does) counts, since the charge is as long
//                                          as the mill.
#pragma once

#include "kernels/wear_report.h"

namespace quern {

struct WearProfile {
  std::vector<double> arc, width;  // m, of the bins' middles from the start of the pitch; of bins
  std::vector<double> x, y;        // m, of the bins' middles on the section of lifter 0 at t = 0
  // Of each bin: mm per 1000 h of a model, Pa of the impulses; and their standard deviation between
  // the lifters.
  std::vector<WearRow> mean, spread;
};

// `liner` is the wear of the mill's shell; bins are about `size` (m) wide. The mill has lifters.
WearProfile wear_profile(const MillSpec& mill, const WallWear& liner, double size);

}  // namespace quern
