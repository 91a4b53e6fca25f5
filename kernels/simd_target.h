// Which SIMD targets this CPU offers to the kernels, and the choice of one. Without a choice every
// kernel takes the best.
#pragma once

#include <string>
#include <vector>

namespace quern {

// Names of the targets that this CPU can run and the kernels are compiled for, best first.
std::vector<std::string> simd_targets();

// From now on all kernels run at this one, a name of `simd_targets`; before any world is made.
void use_simd_target(const std::string& name);

}  // namespace quern
