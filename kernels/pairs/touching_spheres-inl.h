// Which spheres touch: the first pass over the pairs of a tile.
//
// Lanes are owners: a block is 16 particles of a tile, a row of it one partner of each
// (soa/pairs.h). The owners' places stay in registers. Where places are read is a parameter:
// `InRecords`, half a cache line of each partner, R^2 - d^2 in f64; `OnGrid` (`single`), a quarter
// of a line, all in f32 lanes, which finds a few that are apart by less than 2e-6 R and four
// spacings of the grid as well: the law asks again. What is found or was a step ago is put side by
// side.
#if defined(QUERN_TOUCHING_SPHERES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_TOUCHING_SPHERES_INL_H_
#undef QUERN_TOUCHING_SPHERES_INL_H_
#else
#define QUERN_TOUCHING_SPHERES_INL_H_
#endif

#include "kernels/episodes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

HWY_INLINE hn::Vec<D64> nearest_image(hn::Vec<D64> dx, double period, double inverse_period) {
  const D64 d;
  const auto turns = hn::Round(hn::Mul(dx, hn::Set(d, inverse_period)));
  return hn::NegMulAdd(turns, hn::Set(d, period), dx);
}

// Where i is from j, f64. An image is nearer only where some pair lies further apart than half a
// period: next to never, so that lanes are asked together.
template <class Real>
HWY_INLINE Vec3V<hn::Vec<D64>> apart(const StepConstants<Real>& step, const PlaceV<Real>& i,
                                     const PlaceV<Real>& j, hn::Vec<D64>& d2) {
  const D64 d;
  Vec3V<hn::Vec<D64>> dx = i.place - j.place;
  d2 = dot(dx, dx);
  if (HWY_LIKELY(hn::AllFalse(d, hn::Gt(d2, hn::Set(d, step.nearest2))))) return dx;
  if (step.period[0] > 0) dx.x = nearest_image(dx.x, step.period[0], step.inverse_period[0]);
  if (step.period[1] > 0) dx.y = nearest_image(dx.y, step.period[1], step.inverse_period[1]);
  if (step.period[2] > 0) dx.z = nearest_image(dx.z, step.period[2], step.inverse_period[2]);
  d2 = dot(dx, dx);
  return dx;
}
template <class Real, std::size_t half, class V>
HWY_INLINE auto gap2_of(hn::Vec<D64> radius_i, V radius_j, hn::Vec<D64> d2) {
  const auto reach = hn::Add(radius_i, half_f64<Real, half>(radius_j));
  return to_real<Real>(hn::MulSub(reach, reach, d2));
}

// Owners in records, f64 places.
template <class Real>
struct OwnersV {
  PlaceV<Real> low, high;
  hn::Vec<D64> low_radius, high_radius;
  hn::Vec<hn::RebindToSigned<Lanes<Real>>> index;
};
template <class Real>
HWY_INLINE OwnersV<Real> load_owners(const ParticleView<Real>& p, const Index* owner) {
  constexpr std::size_t kLast = kHalves<Real> - 1;
  OwnersV<Real> o;
  o.index = load_index<Real>(owner);
  o.low = load_places(p, owner);
  o.high = load_places(p, owner + kLast * hn::MaxLanes(D64()));
  const auto radius = join_radius(o.low, o.high);
  o.low_radius = half_f64<Real, 0>(radius);
  o.high_radius = half_f64<Real, kLast>(radius);
  return o;
}

// A bit for each owner that touches its partner.
template <class Real>
HWY_INLINE std::uint32_t touching_bits(const StepConstants<Real>& step, const ParticleView<Real>& p,
                                       const OwnersV<Real>& owners, const Index* partner) {
  const Lanes<Real> d;
  constexpr std::size_t kLast = kHalves<Real> - 1;
  hn::Vec<D64> low_d2, high_d2;
  const PlaceV<Real> low = load_places(p, partner);
  apart(step, owners.low, low, low_d2);
  const PlaceV<Real> high = load_places(p, partner + kLast * hn::MaxLanes(D64()));
  apart(step, owners.high, high, high_d2);
  const auto radius = join_radius(low, high);
  const auto gap2 = join<Real>(gap2_of<Real, 0>(owners.low_radius, radius, low_d2),
                               gap2_of<Real, kLast>(owners.high_radius, radius, high_d2));
  // An empty lane pairs a particle with itself: gap = R^2 there, so ask for two distinct partners.
  const auto distinct = hn::RebindMask(d, hn::Ne(owners.index, load_index<Real>(partner)));
  return bits_of(d, hn::And(distinct, hn::Gt(gap2, hn::Zero(d))));
}

template <class Number>
struct InRecords {
  using Real = Number;
  using Owners = OwnersV<Real>;
  static HWY_INLINE Owners load(const ParticleView<Real>& p, const Index* owner) {
    return load_owners(p, owner);
  }
  static HWY_INLINE std::uint32_t touching(const StepConstants<Real>& step,
                                           const ParticleView<Real>& p, const Owners& owners,
                                           const Index* partner) {
    return touching_bits(step, p, owners, partner);
  }
  static HWY_INLINE const void* line(const ParticleView<Real>& p, Index k) { return p.record + k; }
};

// Places on a grid as lanes.
struct GridPlaceV {
  hn::Vec<hn::RebindToSigned<Lanes<float>>> x, y, z;
  hn::Vec<Lanes<float>> radius;
};

#if HWY_TARGET != HWY_SCALAR
// Four numbers of each fourth lane from the first one on, side by side.
template <std::size_t kNumbers>
HWY_INLINE auto load_each_fourth(const GridPlace* places, const Index* lane) {
  const hn::FixedTag<float, kNumbers> d;
  if constexpr (kNumbers == 4) {
    return hn::LoadU(d, reinterpret_cast<const float*>(places + *lane));
  } else {
    const auto low = load_each_fourth<kNumbers / 2>(places, lane);
    return hn::Combine(d, load_each_fourth<kNumbers / 2>(places, lane + kNumbers / 2), low);
  }
}
#endif
HWY_INLINE GridPlaceV load_on_grid(const GridPlace* places, const Index* lane) {
  const Lanes<float> d;
  const hn::RebindToSigned<Lanes<float>> di;
#if HWY_TARGET == HWY_SCALAR
  const GridPlace& p = places[*lane];
  return {hn::Set(di, p.x), hn::Set(di, p.y), hn::Set(di, p.z), hn::Set(d, p.radius)};
#else
  const hn::Repartition<double, Lanes<float>> pairs;
  hn::Vec<Lanes<float>> c[4];
  for (std::size_t k = 0; k < 4; ++k) {
    c[k] = load_each_fourth<hn::MaxLanes(d)>(places, lane + k);
  }
  const auto two = [&](auto v) HWY_ATTR { return hn::BitCast(pairs, v); };
  const auto xy_low = two(hn::InterleaveLower(d, c[0], c[1]));
  const auto zr_low = two(hn::InterleaveUpper(d, c[0], c[1]));
  const auto xy_high = two(hn::InterleaveLower(d, c[2], c[3]));
  const auto zr_high = two(hn::InterleaveUpper(d, c[2], c[3]));
  return {hn::BitCast(di, hn::InterleaveLower(pairs, xy_low, xy_high)),
          hn::BitCast(di, hn::InterleaveUpper(pairs, xy_low, xy_high)),
          hn::BitCast(di, hn::InterleaveLower(pairs, zr_low, zr_high)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, zr_low, zr_high))};
#endif
}

struct OnGrid {
  using Real = float;
  using V = hn::Vec<Lanes<Real>>;
  struct Owners {
    GridPlaceV place;
    hn::Vec<hn::RebindToSigned<Lanes<Real>>> index;
  };
  static HWY_INLINE Owners load(const ParticleView<Real>& p, const Index* owner) {
    return {load_on_grid(p.on_grid, owner), load_index<Real>(owner)};
  }
  // Numbers wrap around, so that their difference is that of the nearest images. Who touches is
  // always found: d^2 and the limit are off by 16 halves of an f32 unit of R^2 at most, places on
  // the grid by sqrt(3) spacings.
  static HWY_INLINE std::uint32_t touching(const StepConstants<Real>& step,
                                           const ParticleView<Real>& p, const Owners& owners,
                                           const Index* partner) {
    const Lanes<Real> d;
    const GridPlaceV other = load_on_grid(p.on_grid, partner);
    const auto apart = [&](auto a, auto b, std::size_t axis) HWY_ATTR {
      return hn::Mul(hn::Set(d, static_cast<Real>(step.grid.spacing[axis])),
                     hn::ConvertTo(d, hn::Sub(a, b)));
    };
    const Vec3V<V> dx = {apart(owners.place.x, other.x, 0), apart(owners.place.y, other.y, 1),
                         apart(owners.place.z, other.z, 2)};
    const V reach = hn::Add(owners.place.radius, other.radius);
    const V wider = hn::MulAdd(reach, hn::Set(d, 1 + 0x1p-19f),
                               hn::Set(d, static_cast<Real>(4 * step.grid.coarsest())));
    const auto distinct = hn::RebindMask(d, hn::Ne(owners.index, load_index<Real>(partner)));
    return bits_of(d, hn::And(distinct, hn::Lt(dot(dx, dx), hn::Mul(reach, wider))));
  }
  static HWY_INLINE const void* line(const ParticleView<Real>& p, Index k) { return p.on_grid + k; }
};

// Asks for the places of a row: of partners some rows ahead (past the end of a tile's rows it is
// the next tile's), of the owners of the next block.
constexpr std::size_t kRowsAhead = 10;
template <class Places, class Real>
HWY_INLINE void prefetch_row(const ParticleView<Real>& p, const Index* row) {
  for (std::size_t k = 0; k < kPairPad; ++k) __builtin_prefetch(Places::line(p, row[k]));
}

// What is found of one part of a tile.
struct FoundPart {
  Index *owner, *partner, *state;
  std::size_t count;
};

// Appends those lanes of a row that touch or did so in the last step.
template <class Real>
HWY_INLINE void append(const Index* owner, const Index* partner, std::uint32_t touching,
                       std::uint32_t open, FoundPart& to) {
  const hn::Rebind<std::uint32_t, Lanes<Real>> d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  for (std::size_t k = 0; k < kPairPad; k += kLanes) {
    const std::uint32_t found = (touching | open) >> k & ((1u << kLanes) - 1);
    const auto bit = hn::Shl(hn::Set(d, 1u), hn::Iota(d, static_cast<std::uint32_t>(k)));
    const auto touches = hn::TestBit(hn::Set(d, touching), bit);
    const auto did_touch = hn::TestBit(hn::Set(d, open), bit);
    const auto state = hn::Or(hn::IfThenElseZero(touches, hn::Set(d, kTouches)),
                              hn::IfThenElseZero(did_touch, hn::Set(d, kDidTouch)));
    hn::StoreU(to_front(d, hn::LoadU(d, owner + k), found), d, to.owner + to.count);
    hn::StoreU(to_front(d, hn::LoadU(d, partner + k), found), d, to.partner + to.count);
    hn::StoreU(to_front(d, state, found), d, to.state + to.count);
    to.count += static_cast<std::size_t>(__builtin_popcount(found));
  }
}

// The first pass over one part. Vectors narrower than a block take it in pieces.
template <class Places, class Real>
HWY_INLINE void find_in_blocks(const StepConstants<Real>& step, const ParticleView<Real>& p,
                               const PairView<Real>& pairs, std::size_t first, std::size_t last,
                               FoundPart& found, std::size_t& touching_so_far) {
  constexpr std::size_t kLanes = hn::MaxLanes(Lanes<Real>()), kPieces = kPairPad / kLanes;
  const std::size_t end = pairs.row_begin[last];
  for (std::size_t block = first; block < last; ++block) {
    const Index* owner = pairs.owner + block * kPairPad;
    typename Places::Owners owners[kPieces];
    for (std::size_t k = 0; k < kPieces; ++k) owners[k] = Places::load(p, owner + k * kLanes);
    if (block + 1 < pairs.all) prefetch_row<Places>(p, owner + kPairPad);
    for (std::size_t row = pairs.row_begin[block]; row < pairs.row_begin[block + 1]; ++row) {
      const Index* partner = pairs.partner + row * kPairPad;
      if (row + kRowsAhead < end) prefetch_row<Places>(p, partner + kRowsAhead * kPairPad);
      std::uint32_t touching = 0;
      for (std::size_t k = 0; k < kPieces; ++k) {
        touching |= Places::touching(step, p, owners[k], partner + k * kLanes) << k * kLanes;
      }
      const std::uint32_t open = pairs.open[row];
      pairs.open[row] = static_cast<std::uint16_t>(touching);
      pairs.first_contact[row] = static_cast<Index>(touching_so_far);
      touching_so_far += static_cast<std::size_t>(__builtin_popcount(touching));
      if ((touching | open) != 0) append<Real>(owner, partner, touching, open, found);
    }
  }
  for (std::size_t k = found.count; k % kPairPad != 0; ++k) {
    found.owner[k] = found.partner[k] = found.owner[0];
    found.state[k] = 0;
  }
}
template <class Places, class Real = typename Places::Real>
void find_pairs(const StepConstants<Real>& step, const ParticleView<Real>& p,
                const PairView<Real>& pairs, FoundPairs& found) {
  found.touching = 0;
  FoundPart own = {found.i, found.j, found.state, 0};
  find_in_blocks<Places>(step, p, pairs, 0, pairs.own, own, found.touching);
  found.own = own.count;
  const std::size_t from = found.imported_begin();
  FoundPart imported = {found.j + from, found.i + from, found.state + from, 0};
  find_in_blocks<Places>(step, p, pairs, pairs.own, pairs.all, imported, found.touching);
  found.imported = imported.count;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
