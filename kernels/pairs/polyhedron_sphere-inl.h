// Spheres near one polyhedron, in three stages. Lanes are spheres but for edges.
//
//   1 planes  the highest plane over each centre, the same planes for all lanes. Farther than the
//             radius: apart, and that is all that most listed pairs cost. What is left is put side
//             by side.
//   2 foot    of the centre on its highest plane. It is the closest point if it lies in the body:
//             the distance to a half-space that holds the body is never more than that to the body,
//             so that no other face can be closest.
//   3 edges   else the closest point lies on an edge: the least over all, one sphere at a time,
//             lanes are edges. Few spheres of a group come here, edges always fill the lanes.
//
// What a sphere gets depends on it and the polyhedron alone, not on its place in the group.
#if defined(QUERN_POLYHEDRON_SPHERE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_POLYHEDRON_SPHERE_INL_H_
#undef QUERN_POLYHEDRON_SPHERE_INL_H_
#else
#define QUERN_POLYHEDRON_SPHERE_INL_H_
#endif

#include <cmath>

#include "kernels/contact.h"
#include "kernels/pairs/polyhedron_sphere.h"
#include "kernels/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

constexpr std::size_t kChunk = 64;  // spheres between the two stages; a multiple of kShapePad
constexpr double kFootUnits = 8;    // rounding of a foot's height over a plane, in units of 2^-52
constexpr double kOnTheSurface = 1e-12;  // of the radius: below, the face's normal is taken

constexpr std::size_t kLeftRoom = kChunk + hn::MaxLanes(D64());

// What stage 1 leaves of a chunk, side by side.
struct LeftSpheres {
  HWY_ALIGN double away[3][kLeftRoom];       // m, centre in world axes
  HWY_ALIGN double radius[kLeftRoom];        // m
  HWY_ALIGN double height[kLeftRoom];        // over the highest plane, over the scale
  HWY_ALIGN std::uint64_t which[kLeftRoom];  // that plane; in the high half its slot of the group
  std::size_t count;
};

template <class V>
struct LeftV {
  Vec3V<V> away;
  V radius, height;
  hn::Vec<D64I> which;
};
// Some of them as lanes with their faces, zeros behind the end.
template <class V = hn::Vec<D64>>
HWY_INLINE LeftV<V> load_left(const LeftSpheres& left, std::size_t at) {
  const D64 d;
  const D64U du;
  const auto there = hn::FirstN(d, left.count - at);
  const auto load = [&](const double* from)
                        HWY_ATTR { return hn::IfThenElseZero(there, hn::LoadU(d, from + at)); };
  const auto face = hn::And(hn::LoadU(du, left.which + at), hn::Set(du, 0xffffffffu));
  return {{load(left.away[0]), load(left.away[1]), load(left.away[2])},
          load(left.radius),
          load(left.height),
          hn::BitCast(D64I(), hn::IfThenElseZero(hn::FirstN(du, left.count - at), face))};
}

// Towards the centre, over the scale, body axes; one sphere or lanes of them.
template <class V>
struct NearestV {
  Vec3V<V> normal;
  V distance;
};

// The transposed turn as broadcast vectors: from the world to the body, over the scale.
template <class V>
struct IntoBodyV {
  V at[3][3];
  explicit IntoBodyV(const ShapePose& pose) {
    const double inverse = 1 / pose.scale;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) at[r][c] = hn::Set(D64(), inverse * pose.turn(c, r));
    }
  }
  HWY_INLINE Vec3V<V> operator()(const Vec3V<V>& a) const {
    return {dot({at[0][0], at[0][1], at[0][2]}, a), dot({at[1][0], at[1][1], at[1][2]}, a),
            dot({at[2][0], at[2][1], at[2][2]}, a)};
  }
};

HWY_INLINE std::uint32_t mask_bits(hn::Mask<D64> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(D64(), mask, bytes);
  return bytes[0];
}
// For TableLookupLanes: lanes whose bit is set, side by side at the front.
HWY_INLINE auto lanes_to_front(std::uint32_t bits) {
  const auto lanes = hn::LoadU(hn::Rebind<std::uint8_t, D64>(), kSetBits.lane[bits]);
  return hn::IndicesFromVec(D64(), hn::PromoteTo(D64I(), hn::PromoteTo(D32I(), lanes)));
}

// Appends the lanes whose bit is set.
template <class V>
HWY_INLINE void append(const LeftV<V>& lanes, std::uint32_t bits, LeftSpheres& left) {
  const D64 d;
  const D64U du;
  const auto first = lanes_to_front(bits);
  const auto keep = [&](V v, double* to) HWY_ATTR {
    hn::StoreU(hn::TableLookupLanes(v, first), d, to + left.count);
  };
  keep(lanes.away.x, left.away[0]);
  keep(lanes.away.y, left.away[1]);
  keep(lanes.away.z, left.away[2]);
  keep(lanes.radius, left.radius);
  keep(lanes.height, left.height);
  const V which = hn::TableLookupLanes(hn::BitCast(d, lanes.which), first);
  hn::StoreU(hn::BitCast(du, which), du, left.which + left.count);
  left.count += static_cast<std::size_t>(__builtin_popcount(bits));
}

// Which lanes of the group from `at` on were open a step ago.
HWY_INLINE hn::Mask<D64> open_lanes(const PolyhedronSphereGroup& g, std::size_t at) {
  const std::uint8_t bits[8] = {static_cast<std::uint8_t>(g.open[at / 8] >> at % 8)};
  return hn::LoadMaskBits(D64(), bits);
}

// Stage 1 for spheres [begin, end) of the group. What was open is left too.
template <class V>
HWY_INLINE void sieve_planes(const PolyhedronSphereGroup& g, const IntoBodyV<V>& into_body,
                             std::size_t begin, std::size_t end, LeftSpheres& left) {
  const D64 d;
  const D64I di;
  const Shape& s = *g.pose->shape;
  const double *nx = s.nx.data(), *ny = s.ny.data(), *nz = s.nz.data(), *offset = s.d.data();
  const V zero = hn::Zero(d), scale_v = hn::Set(d, g.pose->scale);
  left.count = 0;
  for (std::size_t at = begin; at < end; at += hn::Lanes(d)) {
    const Vec3V<V> away = {hn::LoadU(d, g.center[0] + at), hn::LoadU(d, g.center[1] + at),
                           hn::LoadU(d, g.center[2] + at)};
    const Vec3V<V> c = into_body(away);
    V highest = hn::Set(d, -kFarPlane);
    auto face = hn::Zero(di);
    for (std::size_t f = 0; f < s.faces; ++f) {
      const Vec3V<V> n = {hn::Set(d, nx[f]), hn::Set(d, ny[f]), hn::Set(d, nz[f])};
      const V height = hn::Sub(dot(n, c), hn::Set(d, offset[f]));
      const auto higher = hn::Gt(height, highest);
      highest = hn::Max(height, highest);
      face = hn::IfThenElse(hn::RebindMask(di, higher), hn::Set(di, static_cast<std::int64_t>(f)),
                            face);
    }
    const V radius = hn::LoadU(d, g.radius + at);
    const auto near = hn::Gt(hn::NegMulAdd(scale_v, highest, radius), zero);
    const auto stay = hn::And(hn::Or(near, open_lanes(g, at)), hn::FirstN(d, end - at));
    const auto slot = hn::Iota(di, static_cast<std::int64_t>(at));
    append(LeftV<V>{away, radius, highest, hn::Or(face, hn::ShiftLeft<32>(slot))}, mask_bits(stay),
           left);
  }
}

// Which feet lie outside. One that does by rounding only counts as on the face: its distance to the
// body is then of that order.
template <class V>
HWY_INLINE hn::Mask<D64> foot_outside(const Shape& s, const Vec3V<V>& foot, V height) {
  const D64 d;
  V outside = hn::Zero(d);
  for (std::size_t f = 0; f < s.faces; ++f) {
    const Vec3V<V> n = {hn::Set(d, s.nx.data()[f]), hn::Set(d, s.ny.data()[f]),
                        hn::Set(d, s.nz.data()[f])};
    outside = hn::Max(outside, hn::Sub(dot(n, foot), hn::Set(d, s.d.data()[f])));
  }
  const V size = hn::Add(hn::Set(d, s.bound_radius), height);
  return hn::Gt(outside, hn::Mul(hn::Set(d, kFootUnits * 0x1p-52), size));
}

// The edges' closest point to a centre, from there, and its distance squared; lanes are edges.
template <class V>
HWY_INLINE NearestV<double> nearest_on_edges(const Shape& s, const Vec3V<V>& center) {
  const D64 d;
  V least = hn::Set(d, kFarPlane);
  Vec3V<V> apart = center;
  for (std::size_t e = 0; e < s.edges; e += hn::Lanes(d)) {
    const auto edge = [&](const Column<double>(&c)[3]) HWY_ATTR {
      return Vec3V<V>{hn::Load(d, c[0].data() + e), hn::Load(d, c[1].data() + e),
                      hn::Load(d, c[2].data() + e)};
    };
    const Vec3V<V> side = edge(s.edge_side), arm = center - edge(s.edge_at);
    const V along = hn::Mul(dot(side, arm), hn::Load(d, s.edge_inverse2.data() + e));
    const V t = hn::Min(hn::Max(along, hn::Zero(d)), hn::Set(d, 1));
    const Vec3V<V> here = {hn::NegMulAdd(t, side.x, arm.x), hn::NegMulAdd(t, side.y, arm.y),
                           hn::NegMulAdd(t, side.z, arm.z)};
    const V distance2 = dot(here, here);
    const auto nearer = hn::Lt(distance2, least);
    least = hn::Min(distance2, least);
    apart = {hn::IfThenElse(nearer, here.x, apart.x), hn::IfThenElse(nearer, here.y, apart.y),
             hn::IfThenElse(nearer, here.z, apart.z)};
  }
  const V distance2 = hn::MinOfLanes(d, least);
  const auto lane = static_cast<std::size_t>(hn::FindFirstTrue(d, hn::Eq(least, distance2)));
  HWY_ALIGN double row[3][hn::MaxLanes(D64())];
  hn::Store(apart.x, d, row[0]);
  hn::Store(apart.y, d, row[1]);
  hn::Store(apart.z, d, row[2]);
  return {{row[0][lane], row[1][lane], row[2][lane]}, hn::GetLane(distance2)};
}

// Stage 3 for the lanes `outside`.
template <class V>
HWY_INLINE void take_edges(const Shape& s, const Vec3V<V>& center, hn::Mask<D64> outside,
                           V on_the_surface, NearestV<V>& nearest) {
  const D64 d;
  std::uint32_t bits = mask_bits(outside);
  if (bits == 0) return;
  HWY_ALIGN double of[3][hn::MaxLanes(D64())];
  hn::Store(center.x, d, of[0]);
  hn::Store(center.y, d, of[1]);
  hn::Store(center.z, d, of[2]);
  HWY_ALIGN double row[4][hn::MaxLanes(D64())] = {};
  for (; bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(bits));
    const NearestV<double> p = nearest_on_edges(
        s, Vec3V<V>{hn::Set(d, of[0][lane]), hn::Set(d, of[1][lane]), hn::Set(d, of[2][lane])});
    row[0][lane] = p.normal.x;
    row[1][lane] = p.normal.y;
    row[2][lane] = p.normal.z;
    row[3][lane] = p.distance;
  }
  const V distance = hn::Sqrt(hn::Load(d, row[3]));
  const auto on_edge = hn::Gt(distance, on_the_surface);
  const V one = hn::Set(d, 1);
  const V inverse = hn::Div(one, hn::IfThenElse(on_edge, distance, one));
  const auto take = [&](V edge, V face) HWY_ATTR { return hn::IfThenElse(on_edge, edge, face); };
  nearest.normal = {take(hn::Mul(hn::Load(d, row[0]), inverse), nearest.normal.x),
                    take(hn::Mul(hn::Load(d, row[1]), inverse), nearest.normal.y),
                    take(hn::Mul(hn::Load(d, row[2]), inverse), nearest.normal.z)};
  nearest.distance = take(distance, nearest.distance);
}

// Stages 2 and 3.
template <class V>
HWY_INLINE NearestV<V> nearest_point(const ShapePose& pose, const Vec3V<V>& center,
                                     const LeftV<V>& of) {
  const D64 d;
  const Shape& s = *pose.shape;
  const V height = of.height;
  NearestV<V> nearest = {
      {hn::GatherIndex(d, s.nx.data(), of.which), hn::GatherIndex(d, s.ny.data(), of.which),
       hn::GatherIndex(d, s.nz.data(), of.which)},
      height};
  const Vec3V<V> foot = add_scaled(center, hn::Neg(height), nearest.normal);
  const auto above = hn::Gt(height, hn::Zero(d));
  const auto near = hn::Gt(hn::NegMulAdd(hn::Set(d, pose.scale), height, of.radius), hn::Zero(d));
  const auto outside = hn::And(hn::And(above, near), foot_outside(s, foot, height));
  const V on_the_surface =
      hn::Mul(hn::Set(d, kOnTheSurface), hn::Mul(hn::Set(d, 1 / pose.scale), of.radius));
  take_edges(s, center, outside, on_the_surface, nearest);
  return nearest;
}

// Overlap, normal and contact point of the spheres from `at` on, in the world. Writes those that
// touch or were open as touches from `to` on; returns their number.
template <class V>
HWY_INLINE std::size_t store_touches(const PolyhedronSphereGroup& g, const LeftSpheres& left,
                                     const LeftV<V>& of, const NearestV<V>& p, std::size_t at,
                                     std::size_t to) {
  const D64 d;
  const double* turn = g.pose->turn.data();  // by columns
  const V distance = hn::Mul(hn::Set(d, g.pose->scale), p.distance);
  const V overlap = hn::Sub(of.radius, distance);
  const auto touching = hn::Gt(overlap, hn::Zero(d));
  const V arm = hn::Mul(hn::Set(d, 0.5), hn::Add(of.radius, distance));
  const V* away[3] = {&of.away.x, &of.away.y, &of.away.z};
  V touch[8];
  for (int k = 0; k < 3; ++k) {
    const V normal = hn::Add(hn::Add(hn::Mul(hn::Set(d, turn[k]), p.normal.x),
                                     hn::Mul(hn::Set(d, turn[3 + k]), p.normal.y)),
                             hn::Mul(hn::Set(d, turn[6 + k]), p.normal.z));
    touch[k] = hn::IfThenElseZero(touching, normal);
    const V point = hn::Sub(*away[k], hn::Mul(arm, normal));
    touch[4 + k] = hn::IfThenElseZero(touching, point);
  }
  touch[3] = overlap;
  touch[7] = hn::Set(d, g.contacts);
  const std::uint32_t touches = mask_bits(touching);
  HWY_ALIGN double idle[8];
  double* row[hn::MaxLanes(D64())];
  const std::size_t first = to;
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    row[lane] = idle;
    if (at + lane >= left.count) continue;
    const auto slot = static_cast<std::size_t>(left.which[at + lane] >> 32);
    const int told = static_cast<int>(touches >> lane |
                                      static_cast<std::uint32_t>(g.open[slot / 8] >> slot % 8)) &
                     1;
    row[lane] = told != 0 ? g.touch[to].normal : idle;
    g.slot[to] = static_cast<Index>(slot);
    to += static_cast<std::size_t>(told);
  }
  store_rows(touch, [&](std::size_t lane) { return row[lane]; });
  return to - first;
}

inline std::size_t polyhedron_sphere(const PolyhedronSphereGroup& g) noexcept {
  const IntoBodyV<hn::Vec<D64>> into_body(*g.pose);
  std::size_t told = 0;
  LeftSpheres left;
  for (std::size_t begin = 0; begin < g.count; begin += kChunk) {
    sieve_planes(g, into_body, begin, HWY_MIN(begin + kChunk, g.count), left);
    for (std::size_t at = 0; at < left.count; at += hn::Lanes(D64())) {
      const LeftV<hn::Vec<D64>> of = load_left(left, at);
      const NearestV<hn::Vec<D64>> nearest = nearest_point(*g.pose, into_body(of.away), of);
      told += store_touches(g, left, of, nearest, at, told);
    }
  }
  return told;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
