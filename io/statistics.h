// Means of recorded series with their uncertainty.
//
// Samples of a run follow one another closely and are correlated, so their own spread says too
// little. Means of blocks longer than the correlation are nearly independent: the spread of the
// block means gives the standard error (Flyvbjerg and Petersen 1989, with one fixed block length).
#pragma once

#include <span>

namespace quern {

struct Mean {
  double mean = 0;
  double standard_error = 0;  // NaN where it cannot be told (fewer than two samples)
};

// Mean of all samples; the standard error from `blocks` >= 2 blocks of nearly equal length, or from
// the samples themselves where there are fewer than blocks. No samples: both NaN.
Mean block_mean(std::span<const double> samples, int blocks = 10);

}  // namespace quern
