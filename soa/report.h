// StepReport: what a step found, as bits with the first offender.
//
// Kernels set bits, the scheduler merges them in tile order, and only apps/ acts on them: write a
// checkpoint from before, say which particle, where and when, stop or warn.
#pragma once

#include <array>

#include "soa/base.h"

namespace quern {

enum StepBit : std::uint32_t {
  kNotFinite = 1u << 0,     // NaN or infinity in what is known of a particle or a contact
  kDeepOverlap = 1u << 1,   // overlap above the particle's radius; not while overlaps are capped
  kOutside = 1u << 2,       // centre outside the domain
  kOverlapWarning = 1u << 3,  // above half the radius: counted, does not stop; likewise
  kTooFast = 1u << 4,  // moves by more than its radius (a polyhedron: inner one) in a step, at a wall
};
inline constexpr std::uint32_t kFatalBits = kNotFinite | kDeepOverlap | kOutside | kTooFast;

struct Offender {
  Index id = kNoIndex;
  Index partner = kNoIndex;    // particle id, or wall number if partner_is_wall
  bool partner_is_wall = false;
  std::array<double, 3> position{};
  double overlap = 0;       // relative, as max_overlap
};

// Contacts of polyhedra whose force is not what the method defines, in a step or summed over many.
struct Fallbacks {
  std::uint64_t contained = 0;   // one body within the other: along the last normal or the centres
  std::uint64_t bounded = 0;     // a limit of the narrow phase was met: overlap is a lower bound
  std::uint64_t wall_depth = 0;  // deeper in a wall than it is thick: overlap is that thickness
  void add(const Fallbacks& o) {
    contained += o.contained;
    bounded += o.bounded;
    wall_depth += o.wall_depth;
  }
  bool any() const { return contained + bounded + wall_depth > 0; }
};

struct StepReport {
  std::uint32_t bits = 0;
  Offender first;             // of the fatal bits
  std::uint64_t warnings = 0; // contacts above half a radius in this step
  std::uint64_t capped = 0;   // contacts that were pushed at the cap, where the scene has one
  Fallbacks fallbacks;        // likewise; not while overlaps are capped
  double max_overlap = 0;     // relative to the smaller radius
  bool rebuilt = false;
};

}  // namespace quern
