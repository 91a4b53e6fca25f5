// StepReport: what a step found, as bits with the first offender.
//
// Kernels set bits, the scheduler merges them in tile order, and only apps/ acts on them: write a
// checkpoint from before, say which particle, where and when, stop or warn.
#pragma once

#include <array>

#include "soa/base.h"

namespace quern {

enum StepBit : std::uint32_t {
  kNotFinite = 1u << 0,     // NaN or infinity in position or velocity
  kDeepOverlap = 1u << 1,   // overlap above the particle's radius; not while overlaps are capped
  kOutside = 1u << 2,       // centre outside the domain
  kOverlapWarning = 1u << 3,  // above half the radius: counted, does not stop; likewise
};
inline constexpr std::uint32_t kFatalBits = kNotFinite | kDeepOverlap | kOutside;

struct Offender {
  Index id = kNoIndex;
  Index partner = kNoIndex;    // particle id, or wall number if partner_is_wall
  bool partner_is_wall = false;
  std::array<double, 3> position{};
  double overlap = 0;       // relative, as max_overlap
};

struct StepReport {
  std::uint32_t bits = 0;
  Offender first;             // of the fatal bits
  std::uint64_t warnings = 0; // contacts above half a radius in this step
  double max_overlap = 0;     // relative to the smaller radius
  bool rebuilt = false;
};

}  // namespace quern
