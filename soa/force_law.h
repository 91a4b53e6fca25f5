// ForceLaw: which springs contacts push with; one for all contacts of a scene.
#pragma once

#include <cstdint>

namespace quern {

enum class ForceLaw : std::uint8_t {
  kLinearSpringDashpot,  // kernels/laws/linear_spring_dashpot-inl.h
  kHertzMindlin          // kernels/laws/hertz_mindlin-inl.h
};

}  // namespace quern
