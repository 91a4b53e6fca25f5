#include "kernels/near_lanes.h"

#include <algorithm>

namespace quern {

template <class Real>
void NearLanes<Real>::clear(const PolyhedronSphereBatch<Real>& batch, Index first, Index last) {
  touch_.clear();
  sphere_.clear();
  motion_.clear();
  material_.clear();
  radius_.clear();
  history_.clear();
  sums_.clear();
  for (std::size_t block = batch.begin[first] / kShapePad; block < batch.begin[last] / kShapePad;
       ++block) {
    for (std::uint32_t bits = batch.open[block]; bits != 0; bits &= bits - 1) {
      const std::size_t slot = block * kShapePad + static_cast<std::size_t>(__builtin_ctz(bits));
      __builtin_prefetch(&batch.numbers[slot * batch.kHistoryStride], 1);
    }
  }
}

template <class Real>
void NearLanes<Real>::push(const NearTouch& touch, Index sphere, const BodyState& body,
                           Real* history, double* sums) {
  touch_.push_back(touch);
  sphere_.push_back(sphere);
  motion_.push_back(body.motion());
  material_.push_back(body.material);
  radius_.push_back(body.radius);
  history_.push_back(history);
  sums_.push_back(sums);
}

template <class Real>
void NearLanes<Real>::add(PolyhedronSphereBatch<Real>& batch, Index group, std::size_t count,
                          const BodyState& body, const GroupLanes& found) {
  using Batch = PolyhedronSphereBatch<Real>;
  const Index first = batch.begin[group];
  double* sums = batch.sums.data() + group * Batch::kSums;
  bool any = false;
  for (std::size_t at = 0; at < count; at += kShapePad) {
    std::uint32_t touching = 0;
    for (std::size_t k = 0; k < std::min(kShapePad, count - at); ++k) {
      touching |= static_cast<std::uint32_t>(found.overlap[at + k] > 0) << k;
    }
    std::uint8_t& open = batch.open[(first + at) / kShapePad];
    std::uint32_t todo = touching | open;
    open = static_cast<std::uint8_t>(touching);
    any = any || todo != 0;
    for (; todo != 0; todo &= todo - 1) {
      const std::size_t k = at + static_cast<std::size_t>(__builtin_ctz(todo));
      const NearTouch touch = {{found.normal[0][k], found.normal[1][k], found.normal[2][k]},
                               found.overlap[k],
                               {found.point[0][k], found.point[1][k], found.point[2][k]},
                               body.contacts};
      push(touch, batch.sphere[first + k], body, &batch.number(first + k, 0), sums);
    }
  }
  if (any || batch.has_sums[group] != 0) std::fill_n(sums, Batch::kSums, 0.0);
  batch.has_sums[group] = any ? 1 : 0;
}

template <class Real>
NearContacts<Real> NearLanes<Real>::view(Index idle, double overlap_cap) {
  while (sphere_.size() % kShapePad != 0) {
    push(NearTouch{}, idle, idle_body_, idle_history_, idle_sums_);
  }
  return {touch_.data(),   sphere_.data(), motion_.data(), material_.data(), radius_.data(),
          history_.data(), sums_.data(),   sphere_.size(), overlap_cap};
}

template class NearLanes<float>;
template class NearLanes<double>;

}  // namespace quern
