// Precision: with how many bits what is computed of contacts; one for all contacts of a scene. What
// is stored is the same in `mixed` and `single`.
#pragma once

#include <cstdint>

namespace quern {

enum class Precision : std::uint8_t {
  kMixed,   // who touches and how deep in f64, the rest of the force in f32
  kDouble,  // f64
  kSingle   // who touches in f32, by places on a grid (soa/grid_place.h), the rest as in `mixed`
};
inline constexpr const char* kPrecisionWords[] = {"mixed", "double", "single"};  // in scenes, files
constexpr const char* word_of(Precision p) { return kPrecisionWords[static_cast<int>(p)]; }

}  // namespace quern
