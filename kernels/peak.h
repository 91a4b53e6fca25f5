// Peak arithmetic: multiply-adds in registers and nothing else, at the SIMD target that the contact
// kernels run with. What a kernel's arithmetic is measured against.
#pragma once

#include "soa/base.h"

namespace quern {

struct PeakRun {
  double operations;  // floating-point, a multiply-add is two
  double sum;         // of the results: they must not be left out
};

// Of one thread; `rounds` of 12 independent vectors of Real.
template <class Real>
PeakRun run_multiply_adds(std::size_t rounds);
template <>
PeakRun run_multiply_adds<float>(std::size_t rounds);
template <>
PeakRun run_multiply_adds<double>(std::size_t rounds);

}  // namespace quern
