// What the machine allows at this moment: memory, its bandwidth, peak of its arithmetic.
#pragma once

#include <string>

namespace quern {

// B/s by the triad of STREAM (McCalpin 1995): a = b + s c over three arrays of 64 MiB, far larger
// than the caches, each thread its own part, 24 bytes counted for an element; best of ten passes.
double triad_bandwidth(int threads);

// Floating-point operations a second of multiply-adds in registers at the kernels' SIMD target,
// each thread the same; best of ten passes.
template <class Real>
double peak_arithmetic(int threads);

std::string processor_name();

// Bytes that a process can take before the machine swaps or ends it: what the system calls
// available, no more than a limit of its control group or of the process.
double available_memory();

}  // namespace quern
