#include "kernels/simd_target.h"

#include <hwy/targets.h>

#include <algorithm>

#include "soa/base.h"

namespace quern {

std::vector<std::string> simd_targets() {
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    names.emplace_back(hwy::TargetName(target));
  }
  return names;
}

void use_simd_target(const std::string& name) {
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  const auto chosen = std::find_if(targets.begin(), targets.end(),
                                   [&](auto t) { return name == hwy::TargetName(t); });
  QUERN_CHECK(chosen != targets.end());
  hwy::SetSupportedTargetsForTest(*chosen);
  hwy::GetChosenTarget().Update(*chosen);
}

}  // namespace quern
