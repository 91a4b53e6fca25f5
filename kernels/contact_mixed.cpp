// The kernels in `mixed` and `single` precision, compiled once for every SIMD target and chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/contact_mixed.cpp"
#include <hwy/foreach_target.h>

#include "kernels/body_contacts-inl.h"
#include "kernels/integrate-inl.h"
#include "kernels/laws/hertz_mindlin-inl.h"
#include "kernels/laws/linear_spring_dashpot-inl.h"
#include "kernels/pairs/sphere_facet-inl.h"
#include "kernels/pairs/sphere_sphere-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

template <class Springs>
Kernels<float> kernels_of() {
  return {&find_pairs<InRecords<float>>, &push_pairs<float, Springs>, &sphere_facet<float, Springs>,
          &move_spheres<float>,          &gather_spheres<float>,      &push_spheres<float, Springs>,
          &push_bodies<Springs>,         hwy::TargetName(HWY_TARGET)};
}

Kernels<float> kernels_mixed(ForceLaw law, Precision precision) {
  Kernels<float> kernels =
      law == ForceLaw::kHertzMindlin ? kernels_of<HertzMindlin>() : kernels_of<LinearSprings>();
  if (precision == Precision::kSingle) kernels.find_pairs = &find_pairs<OnGrid>;
  return kernels;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(kernels_mixed);

template <>
Kernels<float> choose_kernels<float>(ForceLaw law, Precision precision) {
  return HWY_DYNAMIC_DISPATCH(kernels_mixed)(law, precision);
}

}  // namespace quern
#endif
