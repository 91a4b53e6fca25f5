#include "kernels/near_lanes.h"

#include <algorithm>

namespace quern {

// Grows; lanes already there keep their numbers.
template <class Real>
void NearLanes<Real>::reserve(std::size_t n) {
  if (n <= stride_) return;
  const std::size_t wider = std::max<std::size_t>(2 * stride_, n + 256) / kShapePad * kShapePad;
  const auto widen = [&](auto& columns, std::size_t rows) {
    std::remove_reference_t<decltype(columns)> wide(rows * wider);
    for (std::size_t row = 0; row < rows; ++row) {
      const auto from = columns.begin() + static_cast<std::ptrdiff_t>(row * stride_);
      std::copy_n(from, stride_, wide.begin() + static_cast<std::ptrdiff_t>(row * wider));
    }
    columns = std::move(wide);
  };
  widen(numbers_, NearContacts<Real>::kRows);
  widen(history_, PolyhedronSphereBatch<Real>::kHistory);
  sphere_.resize(wider);
  material_.resize(wider);
  stride_ = wider;
}

template <class Real>
void NearLanes<Real>::clear(const PolyhedronSphereBatch<Real>& batch, Index first, Index last) {
  lanes_.clear();
  for (std::size_t block = batch.begin[first] / kShapePad; block < batch.begin[last] / kShapePad;
       ++block) {
    for (std::uint32_t bits = batch.open[block]; bits != 0; bits &= bits - 1) {
      const std::size_t slot = block * kShapePad + static_cast<std::size_t>(__builtin_ctz(bits));
      __builtin_prefetch(&batch.numbers[slot * batch.kHistoryStride], 1);
    }
  }
}

template <class Real>
void NearLanes<Real>::add(PolyhedronSphereBatch<Real>& batch, Index group, std::size_t count,
                          const BodyState& body, const GroupLanes& found) {
  using Batch = PolyhedronSphereBatch<Real>;
  using C = NearContacts<Real>;
  const Index first = batch.begin[group];
  bool any = false;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t slot = first + k;
    std::uint8_t& open = batch.open[slot / kShapePad];
    const std::uint8_t bit = static_cast<std::uint8_t>(1u << slot % kShapePad);
    const bool touching = found.overlap[k] > 0;
    if (!touching && (open & bit) == 0) continue;
    open = static_cast<std::uint8_t>(touching ? open | bit : open & ~bit);
    any = true;
    const std::size_t lane = lanes_.size();
    reserve(lane + 1 + kShapePad);
    lanes_.push_back({static_cast<Index>(slot), group});
    sphere_[lane] = batch.sphere[slot];
    material_[lane] = body.material;
    double* number = numbers_.data() + lane;
    const auto put = [&](int row, double v) { number[static_cast<std::size_t>(row) * stride_] = v; };
    put(C::kOverlap, found.overlap[k]);
    for (int a = 0; a < 3; ++a) {
      put(C::kNormal + a, found.normal[a][k]);
      put(C::kPoint + a, found.point[a][k]);
      put(C::kVelocity + a, body.velocity[a]);
      put(C::kSpin + a, body.spin[a]);
    }
    put(C::kInverseMass, body.inverse_mass);
    put(C::kMobility, body.mobility);
    put(C::kContacts, body.contacts);
    for (std::size_t h = 0; h < Batch::kHistory; ++h) {
      history_[h * stride_ + lane] = batch.number(slot, h);
    }
  }
  if (any || batch.has_sums[group] != 0) {
    std::fill_n(batch.sums.data() + group * Batch::kSums, Batch::kSums, 0.0);
  }
  batch.has_sums[group] = any ? 1 : 0;
}

template <class Real>
NearContacts<Real> NearLanes<Real>::view(Index idle, double overlap_cap) {
  const std::size_t padded = (lanes_.size() + kShapePad - 1) / kShapePad * kShapePad;
  for (std::size_t lane = lanes_.size(); lane < padded; ++lane) {
    for (std::size_t row = 0; row < NearContacts<Real>::kRows; ++row) {
      numbers_[row * stride_ + lane] = 0;
    }
    for (std::size_t h = 0; h < PolyhedronSphereBatch<Real>::kHistory; ++h) {
      history_[h * stride_ + lane] = 0;
    }
    sphere_[lane] = idle;
    material_[lane] = 0;
  }
  return {numbers_.data(),  history_.data(), stride_,    sphere_.data(),
          material_.data(), padded,          overlap_cap};
}

template <class Real>
void NearLanes<Real>::give_back(PolyhedronSphereBatch<Real>& batch) const {
  using Batch = PolyhedronSphereBatch<Real>;
  using C = NearContacts<Real>;
  for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
    const auto [slot, group] = lanes_[lane];
    for (std::size_t h = 0; h < Batch::kHistory; ++h) {
      batch.number(slot, h) = history_[h * stride_ + lane];
    }
    double* sums = batch.sums.data() + group * Batch::kSums;
    for (std::size_t k = 0; k < 6; ++k) sums[k] += numbers_[(C::kForce + k) * stride_ + lane];
    sums[6] += numbers_[C::kOverlap * stride_ + lane] > 0 ? 1 : 0;
  }
}

template class NearLanes<float>;
template class NearLanes<double>;

}  // namespace quern
