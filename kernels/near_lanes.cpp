#include "kernels/near_lanes.h"

#include <algorithm>

namespace quern {

template <class Real>
void NearLanes<Real>::clear(const PolyhedronSphereBatch<Real>& batch, Index first, Index last) {
  count_ = 0;
  odd_ = kNone;
  const std::size_t room = batch.begin[last] - batch.begin[first] + kShapePad;
  if (touch_.size() < room) {
    touch_.resize(room);
    slot_.resize(room);
    sphere_.resize(room);
    motion_.resize(room);
    material_.resize(room);
    group_.resize(room);
    radius_.resize(room);
    history_.resize(room);
    sums_.resize(room);
  }
}

template <class Real>
void NearLanes<Real>::set(std::size_t lane, Index sphere, const BodyState& body, Real* history,
                          double* sums) {
  sphere_[lane] = sphere;
  motion_[lane] = body.motion();
  material_[lane] = body.material;
  group_[lane] = static_cast<std::uint8_t>(body.group);
  radius_[lane] = body.radius;
  history_[lane] = history;
  sums_[lane] = sums;
}

template <class Real>
void NearLanes<Real>::add(const PolyhedronSphereKernel& narrow, PolyhedronSphereBatch<Real>& batch,
                          Index group, const BodyState& body, const ShapePose& pose,
                          const GroupLanes& spheres) {
  using Batch = PolyhedronSphereBatch<Real>;
  const Index first = batch.begin[group], count = batch.count[group];
  std::uint8_t* open = batch.open.data() + first / kShapePad;
  PolyhedronSphereGroup g;
  g.pose = &pose;
  g.count = count;
  g.contacts = body.contacts;
  for (int a = 0; a < 3; ++a) g.center[a] = spheres.center[a];
  g.radius = spheres.radius;
  g.open = open;
  g.touch = touch_.data() + count_;
  g.slot = slot_.data() + count_;
  const std::size_t told = narrow.touch(g);
  double* sums = batch.sums.data() + group * Batch::kSums;
  for (std::size_t at = 0; at < count; at += kShapePad) open[at / kShapePad] = 0;
  for (std::size_t k = 0; k < told; ++k) {
    const Index slot = g.slot[k];
    open[slot / kShapePad] |=
        static_cast<std::uint8_t>((g.touch[k].overlap > 0 ? 1u : 0u) << slot % kShapePad);
    Real* history = &batch.number(first + slot, 0);
    __builtin_prefetch(history, 1);
    set(count_ + k, batch.sphere[first + slot], body, history, sums);
  }
  count_ += told;
  if (told > 0 || batch.has_sums[group] != 0) std::fill_n(sums, Batch::kSums, 0.0);
  batch.has_sums[group] = told > 0 ? 1 : 0;
}

template <class Real>
NearContacts<Real> NearLanes<Real>::view(Index idle, double overlap_cap, Recording recording) {
  std::size_t padded = count_;
  for (; padded % kShapePad != 0; ++padded) {
    touch_[padded] = NearTouch{};
    set(padded, idle, idle_body_, idle_history_, idle_sums_);
  }
  const bool tells = recording != Recording::kOff;
  if (tells && told_.size() < padded) told_.resize(touch_.size());
  return {touch_.data(),  sphere_.data(),
          motion_.data(), material_.data(),
          radius_.data(), history_.data(),
          sums_.data(),   padded,
          overlap_cap,    tells ? told_.data() : nullptr,
          &odd_};
}

template <class Real>
std::optional<std::pair<Index, Index>> NearLanes<Real>::odd(
    const PolyhedronSphereBatch<Real>& batch) const {
  if (odd_ >= count_) return std::nullopt;
  const auto slot =
      static_cast<Index>((history_[odd_] - batch.numbers.data()) / batch.kHistoryStride);
  const auto group = std::upper_bound(batch.begin.begin(), batch.begin.end(), slot) - 1;
  return std::pair(sphere_[odd_],
                   batch.polyhedron[static_cast<std::size_t>(group - batch.begin.begin())]);
}

template <class Real>
void NearLanes<Real>::record(const ParticleView<Real>& spheres, Recording recording,
                             CollisionTally& tally) {
  const Groups& groups = tally.groups();
  for (std::size_t k = 0; k < count_; ++k) {
    const NearTold& told = told_[k];
    const std::size_t kind = groups.kind(tag_group(spheres.traits[sphere_[k]].tag), group_[k]);
    tally.add(kind, {told.work, told.elastic, told.slide, told.tangential_damping});
    Real* const episode = history_[k] + PolyhedronSphereBatch<Real>::kEpisode;
    const bool touches = touch_[k].overlap > 0;
    double energy = told.elastic;
    if (recording == Recording::kOn) {
      energy = static_cast<double>(episode[0]) + static_cast<double>(episode[1]) - told.work;
      if (!(told.overlap_old > 0)) {
        episode[2] = static_cast<Real>(told.approach);
        tally.begin_episode(kind, told.impact);
      }
      if (!touches) tally.end_episode(kind, energy, static_cast<double>(episode[2]));
    }
    if (!touches) energy = 0;
    episode[0] = static_cast<Real>(energy);
    episode[1] = static_cast<Real>(energy - static_cast<double>(episode[0]));
    if (!touches) episode[2] = 0;
  }
}

template class NearLanes<float>;
template class NearLanes<double>;

}  // namespace quern
