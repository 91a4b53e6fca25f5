// What a sweep will cost: time from a short stretch of its middle case, disk from a few steps of
// it.
#pragma once

#include "apps/quern/sweep_jobs.h"

namespace quern {

struct SweepSpeed {
  SweepWidth width;
  double per_second = 0;  // particle steps of all processes together, charge loose
};

// Widths that are worth a try on this machine, narrow first: powers of two of threads up to all
// cores, as many processes as cores, memory and `cases` allow.
std::vector<SweepWidth> widths_of(const SweepPlan& plan, std::size_t cases);

// The speeds of these widths, in the order given; a second of each, or as long as is worth while
// for so many particle steps.
std::vector<SweepSpeed> measure_widths(const SweepPlan& plan, const std::vector<SweepWidth>& widths,
                                       double work);

// Seconds of one process for a particle step of the settled charge.
double seconds_per_step(const SweepSpeed& speed);

// Bytes of all cases, from a run of a few steps that is made in OUT and removed.
double measure_disk(const SweepPlan& plan);

int machine_cores();

}  // namespace quern
