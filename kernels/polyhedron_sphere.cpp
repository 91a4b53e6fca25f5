// The polyhedron-sphere kernel, compiled once for every SIMD target and chosen at run time.
#include "kernels/pairs/polyhedron_sphere.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/polyhedron_sphere.cpp"
#include <hwy/foreach_target.h>

#include "kernels/pairs/polyhedron_sphere-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

PolyhedronSphereKernel polyhedron_sphere_kernel() {
  return {&polyhedron_sphere, hwy::TargetName(HWY_TARGET)};
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(polyhedron_sphere_kernel);

PolyhedronSphereKernel choose_polyhedron_sphere() {
  return HWY_DYNAMIC_DISPATCH(polyhedron_sphere_kernel)();
}

}  // namespace quern
#endif
