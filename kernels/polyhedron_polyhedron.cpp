// Pairs of polyhedra, compiled once for every SIMD target and chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/polyhedron_polyhedron.cpp"
#include <hwy/foreach_target.h>

#include "kernels/pairs/polyhedron_polyhedron-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

bool touch_polyhedra_here(const ShapePose& a, const ShapePose& b, const PatchOptions& options,
                          PairAxis& axis, PolyhedronTouch& out) {
  return touch_pair(a, b, options, axis, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(touch_polyhedra_here);

bool touch_polyhedra(const ShapePose& a, const ShapePose& b, const PatchOptions& options,
                     PairAxis& axis, PolyhedronTouch& out) noexcept {
  return HWY_DYNAMIC_DISPATCH(touch_polyhedra_here)(a, b, options, axis, out);
}

}  // namespace quern
#endif
