// Shapes cut by a plane, compiled once for every SIMD target and chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/plane_cut.cpp"
#include <hwy/foreach_target.h>

#include "kernels/pairs/plane_cut-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

bool cut_by_edges_here(const Shape& shape, const Plane& plane, ClipBuffers& buffers,
                       PlaneCut& cut) {
  return cut_shape(shape, plane, buffers, cut);
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {

HWY_EXPORT(cut_by_edges_here);

bool cut_by_edges(const Shape& shape, const Plane& plane, ClipBuffers& buffers,
                  PlaneCut& cut) noexcept {
  return HWY_DYNAMIC_DISPATCH(cut_by_edges_here)(shape, plane, buffers, cut);
}

}  // namespace quern
#endif
