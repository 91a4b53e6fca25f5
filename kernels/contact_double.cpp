// The kernels in `double` precision, compiled once for every SIMD target and chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/contact_double.cpp"
#include <hwy/foreach_target.h>

#include "kernels/body_contacts-inl.h"
#include "kernels/integrate-inl.h"
#include "kernels/pairs/sphere_facet-inl.h"
#include "kernels/pairs/sphere_sphere-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

Kernels<double> kernels_double() {
  return {&find_pairs<double>, &push_pairs<double>, &sphere_facet<double>, &move_spheres<double>,
          &gather_spheres<double>, &push_spheres<double>, &push_bodies, hwy::TargetName(HWY_TARGET)};
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(kernels_double);

template <>
Kernels<double> choose_kernels<double>() {
  return HWY_DYNAMIC_DISPATCH(kernels_double)();
}

}  // namespace quern
#endif
