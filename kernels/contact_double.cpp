// The kernels in `double` precision, compiled once for every SIMD target and chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/contact_double.cpp"
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
Kernels<double> kernels_of() {
  return {&find_pairs<InRecords<double>>, &push_pairs<double, Springs>,
          &sphere_facet<double, Springs>, &move_spheres<double>,
          &gather_spheres<double>,        &push_spheres<double, Springs>,
          &push_bodies<Springs>,          hwy::TargetName(HWY_TARGET)};
}

Kernels<double> kernels_double(ForceLaw law) {
  return law == ForceLaw::kHertzMindlin ? kernels_of<HertzMindlin>() : kernels_of<LinearSprings>();
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(kernels_double);

template <>
Kernels<double> choose_kernels<double>(ForceLaw law, Precision) {
  return HWY_DYNAMIC_DISPATCH(kernels_double)(law);
}

}  // namespace quern
#endif
