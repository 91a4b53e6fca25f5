// Spheres near one polyhedron, a lane each: a sieve of three stages over packed lanes.
//
//   1 planes   the highest plane over each centre. Farther than the radius: apart. This stage is
//   all
//              that most listed pairs cost.
//   2 foot     the foot of the centre on that plane. In the body: it is the closest point, for the
//              distance to a half-space that holds the body is never more than that to the body, so
//              that a face can be closest only if its plane is the highest.
//   3 edges    what remains is closest to an edge or its end: the least over all edges.
//
// Survivors of a stage are packed before the next, so that its lanes are full whatever the group
// looks like. Planes and edges are the same for all lanes: plain loads, no gathers but that of the
// highest plane, no branch on features. Chunks of kChunk lanes keep the scratch on the stack.
#if defined(QUERN_POLYHEDRON_SPHERE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_POLYHEDRON_SPHERE_INL_H_
#undef QUERN_POLYHEDRON_SPHERE_INL_H_
#else
#define QUERN_POLYHEDRON_SPHERE_INL_H_
#endif

#include <cmath>

#include "kernels/pairs/polyhedron_sphere.h"
#include "kernels/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

constexpr std::size_t kChunk = 64;
constexpr double kOnTheSurface = 1e-12;  // of the radius: below, the face's normal is taken

// Lanes that a stage lets through: centre and radius in the body frame over the scale, the height
// over the highest plane, that plane, and where the lane came from.
struct PackedLanes {
  static constexpr std::size_t kRoom = kChunk + kShapePad;
  HWY_ALIGN double center[3][kRoom];
  HWY_ALIGN double radius[kRoom];
  HWY_ALIGN double height[kRoom];
  HWY_ALIGN std::int64_t face[kRoom];
  HWY_ALIGN std::int64_t from[kRoom];
  std::size_t count;
};

// Body-frame normal and distance of the closest point, by packed lane of stage 1.
struct FoundLanes {
  HWY_ALIGN double normal[3][PackedLanes::kRoom];
  HWY_ALIGN double distance[PackedLanes::kRoom];
};

template <class V>
struct PlaneV {
  V height;
  hn::Vec<D64I> face;
};

template <class V>
HWY_INLINE V height_over(const Shape& s, std::size_t f, const Vec3V<V>& at) {
  const D64 d;
  return hn::MulAdd(
      hn::Set(d, s.nx.data()[f]), at.x,
      hn::MulAdd(hn::Set(d, s.ny.data()[f]), at.y,
                 hn::MulSub(hn::Set(d, s.nz.data()[f]), at.z, hn::Set(d, s.d.data()[f]))));
}

template <class V>
HWY_INLINE PlaneV<V> highest_plane(const Shape& s, const Vec3V<V>& at) {
  const D64I di;
  PlaneV<V> best{height_over(s, 0, at), hn::Zero(di)};
  for (std::size_t f = 1; f < s.faces; ++f) {
    const V height = height_over(s, f, at);
    const auto higher = hn::Gt(height, best.height);
    best.height = hn::IfThenElse(higher, height, best.height);
    best.face = hn::IfThenElse(hn::RebindMask(di, higher),
                               hn::Set(di, static_cast<std::int64_t>(f)), best.face);
  }
  return best;
}

template <class V>
struct LaneV {
  Vec3V<V> center;
  V radius;
  PlaneV<V> plane;
  hn::Vec<D64I> from;
};

// The kept lanes moved to the front, one instruction with AVX-512. (Highway 1.0.3 has two ways of its
// own: a store that takes 140 cycles on Zen 4, and one that copies a table of 4 KiB.)
template <class V, class M>
HWY_INLINE V to_front(V v, M keep) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  const D64 d;
  const auto bits = hn::BitCast(d, v);
  return hn::BitCast(hn::DFromV<V>(), hn::Vec<D64>{_mm512_maskz_compress_pd(keep.raw, bits.raw)});
#else
  return hn::Compress(v, hn::RebindMask(hn::DFromV<V>(), keep));
#endif
}

template <class V, class M>
HWY_INLINE void pack(const LaneV<V>& lane, M keep, PackedLanes& to) {
  const D64 d;
  const D64I di;
  const std::size_t at = to.count;
  hn::StoreU(to_front(lane.center.x, keep), d, to.center[0] + at);
  hn::StoreU(to_front(lane.center.y, keep), d, to.center[1] + at);
  hn::StoreU(to_front(lane.center.z, keep), d, to.center[2] + at);
  hn::StoreU(to_front(lane.radius, keep), d, to.radius + at);
  hn::StoreU(to_front(lane.plane.height, keep), d, to.height + at);
  hn::StoreU(to_front(lane.plane.face, keep), di, to.face + at);
  hn::StoreU(to_front(lane.from, keep), di, to.from + at);
  to.count += hn::CountTrue(d, keep);
}

// The last vector is filled up with a sphere of radius 0 in the centroid, which raises nothing.
HWY_INLINE void fill_up(PackedLanes& lanes) {
  const D64 d;
  const D64I di;
  for (auto& axis : lanes.center) hn::StoreU(hn::Zero(d), d, axis + lanes.count);
  hn::StoreU(hn::Zero(d), d, lanes.radius + lanes.count);
  hn::StoreU(hn::Zero(d), d, lanes.height + lanes.count);
  hn::StoreU(hn::Zero(di), di, lanes.face + lanes.count);
  hn::StoreU(hn::Zero(di), di, lanes.from + lanes.count);
}

HWY_INLINE LaneV<hn::Vec<D64>> load_lane(const PackedLanes& p, std::size_t at) {
  const D64 d;
  const D64I di;
  return {
      {hn::Load(d, p.center[0] + at), hn::Load(d, p.center[1] + at), hn::Load(d, p.center[2] + at)},
      hn::Load(d, p.radius + at),
      {hn::Load(d, p.height + at), hn::Load(di, p.face + at)},
      hn::Load(di, p.from + at)};
}

// Rows of the turn as broadcast vectors; its transpose leads from the world to the body.
template <class V>
struct TurnV {
  V at[3][3];
  explicit TurnV(const Mat3& m) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) at[r][c] = hn::Set(D64(), m(r, c));
    }
  }
  HWY_INLINE Vec3V<V> to_world(const Vec3V<V>& a) const {
    return {dot({at[0][0], at[0][1], at[0][2]}, a), dot({at[1][0], at[1][1], at[1][2]}, a),
            dot({at[2][0], at[2][1], at[2][2]}, a)};
  }
  HWY_INLINE Vec3V<V> to_body(const Vec3V<V>& a) const {
    return {dot({at[0][0], at[1][0], at[2][0]}, a), dot({at[0][1], at[1][1], at[2][1]}, a),
            dot({at[0][2], at[1][2], at[2][2]}, a)};
  }
};

// Stage 1 for lanes [begin, end): overlaps of all, survivors packed. Overlaps of lanes that are
// apart are final; the others stay what the plane says until store_found() has the true ones.
template <class V>
HWY_INLINE void sieve_planes(const PolyhedronSphereGroup& g, const TurnV<V>& turn,
                             std::size_t begin, std::size_t end, PackedLanes& near) {
  const D64 d;
  const D64I di;
  const V zero = hn::Zero(d);
  const V scale_v = hn::Set(d, g.pose.scale), inverse = hn::Set(d, 1 / g.pose.scale);
  near.count = 0;
  for (std::size_t at = begin; at < end; at += hn::Lanes(d)) {
    LaneV<V> lane;
    lane.center =
        scale(inverse, turn.to_body({hn::LoadU(d, g.center[0] + at), hn::LoadU(d, g.center[1] + at),
                                     hn::LoadU(d, g.center[2] + at)}));
    const V radius = hn::LoadU(d, g.radius + at);
    lane.radius = hn::Mul(inverse, radius);
    lane.plane = highest_plane(*g.pose.shape, lane.center);
    const V overlap = hn::NegMulAdd(scale_v, lane.plane.height, radius);
    hn::StoreU(overlap, d, g.overlap + at);
    for (int k = 0; k < 3; ++k) {
      hn::StoreU(zero, d, g.normal[k] + at);
      hn::StoreU(zero, d, g.point[k] + at);
    }
    lane.from = hn::Iota(di, static_cast<std::int64_t>(at));
    const auto listed = hn::FirstN(d, end - at);
    const auto keep = hn::And(listed, hn::Gt(overlap, zero));
    if (!hn::AllFalse(d, keep)) pack(lane, keep, near);
  }
  fill_up(near);
}

// Stage 2: closest to the highest plane's own face, or inside, or left to stage 3. A foot that is
// outside the body by rounding only (kFoot units of the centre's distance) counts as on the face.
HWY_INLINE void sieve_feet(const Shape& s, const PackedLanes& near, FoundLanes& found,
                           PackedLanes& beside) {
  const D64 d;
  const D64I di;
  using V = hn::Vec<D64>;
  constexpr double kFoot = 8 * 0x1p-52;
  beside.count = 0;
  const V bound = hn::Set(d, kFoot * s.bound_radius), part = hn::Set(d, kFoot);
  for (std::size_t at = 0; at < near.count; at += hn::Lanes(d)) {
    LaneV<V> lane = load_lane(near, at);
    const Vec3V<V> normal = {hn::GatherIndex(d, s.nx.data(), lane.plane.face),
                             hn::GatherIndex(d, s.ny.data(), lane.plane.face),
                             hn::GatherIndex(d, s.nz.data(), lane.plane.face)};
    hn::Store(normal.x, d, found.normal[0] + at);
    hn::Store(normal.y, d, found.normal[1] + at);
    hn::Store(normal.z, d, found.normal[2] + at);
    hn::Store(lane.plane.height, d, found.distance + at);
    const Vec3V<V> foot = {hn::NegMulAdd(lane.plane.height, normal.x, lane.center.x),
                           hn::NegMulAdd(lane.plane.height, normal.y, lane.center.y),
                           hn::NegMulAdd(lane.plane.height, normal.z, lane.center.z)};
    V outside = height_over(s, 0, foot);
    for (std::size_t f = 1; f < s.faces; ++f) outside = hn::Max(outside, height_over(s, f, foot));
    const V rounding = hn::MulAdd(part, hn::Max(lane.plane.height, hn::Zero(d)), bound);
    auto keep = hn::And(hn::Gt(lane.plane.height, hn::Zero(d)), hn::Gt(outside, rounding));
    keep = hn::And(keep, hn::FirstN(d, near.count - at));
    lane.from = hn::Iota(di, static_cast<std::int64_t>(at));
    if (!hn::AllFalse(d, keep)) pack(lane, keep, beside);
  }
  fill_up(beside);
}

template <class V>
struct ClosestV {
  V distance2;
  Vec3V<V> apart;  // centre minus closest point
};

// Lowers each lane of `best` to the closest point of its own edge of those that begin at `at`.
template <class V>
HWY_INLINE void closest_on_edges(const Shape& s, std::size_t at, const Vec3V<V>& center,
                                 ClosestV<V>& best) {
  const D64 d;
  const Vec3V<V> side = {hn::Load(d, s.edge_side[0].data() + at),
                         hn::Load(d, s.edge_side[1].data() + at),
                         hn::Load(d, s.edge_side[2].data() + at)};
  const Vec3V<V> arm = center - Vec3V<V>{hn::Load(d, s.edge_at[0].data() + at),
                                         hn::Load(d, s.edge_at[1].data() + at),
                                         hn::Load(d, s.edge_at[2].data() + at)};
  const V along = hn::Mul(dot(side, arm), hn::Load(d, s.edge_inverse2.data() + at));
  const V t = hn::Min(hn::Max(along, hn::Zero(d)), hn::Set(d, 1));
  const Vec3V<V> apart = {hn::NegMulAdd(t, side.x, arm.x), hn::NegMulAdd(t, side.y, arm.y),
                          hn::NegMulAdd(t, side.z, arm.z)};
  const V distance2 = dot(apart, apart);
  const auto nearer = hn::Lt(distance2, best.distance2);
  best.distance2 = hn::IfThenElse(nearer, distance2, best.distance2);
  best.apart = {hn::IfThenElse(nearer, apart.x, best.apart.x),
                hn::IfThenElse(nearer, apart.y, best.apart.y),
                hn::IfThenElse(nearer, apart.z, best.apart.z)};
}

// Stage 3: the least over all edges, a lane each. On the surface to rounding, stage 2's answer stays.
HWY_INLINE void find_edges(const Shape& s, const PackedLanes& beside, FoundLanes& found) {
  const D64 d;
  using V = hn::Vec<D64>;
  for (std::size_t k = 0; k < beside.count; ++k) {
    const Vec3V<V> center = {hn::Set(d, beside.center[0][k]), hn::Set(d, beside.center[1][k]),
                             hn::Set(d, beside.center[2][k])};
    ClosestV<V> best{hn::Set(d, kFarPlane), {center.x, center.y, center.z}};
    for (std::size_t at = 0; at < s.edges; at += hn::Lanes(d)) {
      closest_on_edges(s, at, center, best);
    }
    HWY_ALIGN double row[4][hn::MaxLanes(D64())];
    hn::Store(best.apart.x, d, row[0]);
    hn::Store(best.apart.y, d, row[1]);
    hn::Store(best.apart.z, d, row[2]);
    hn::Store(best.distance2, d, row[3]);
    std::size_t least = 0;
    for (std::size_t lane = 1; lane < hn::Lanes(d); ++lane) {
      least = row[3][lane] < row[3][least] ? lane : least;
    }
    const double distance = std::sqrt(row[3][least]);
    if (!(distance > kOnTheSurface * beside.radius[k])) continue;
    const auto to = static_cast<std::size_t>(beside.from[k]);
    for (int axis = 0; axis < 3; ++axis) found.normal[axis][to] = row[axis][least] / distance;
    found.distance[to] = distance;
  }
}

// Turns what was found to the world and puts it where its lane came from; returns how many touch.
template <class V>
HWY_INLINE std::size_t store_found(const PolyhedronSphereGroup& g, const TurnV<V>& turn,
                                   const PackedLanes& near, const FoundLanes& found) {
  const D64 d;
  const V scale_v = hn::Set(d, g.pose.scale);
  std::size_t touching = 0;
  for (std::size_t at = 0; at < near.count; at += hn::Lanes(d)) {
    const Vec3V<V> normal =
        turn.to_world({hn::Load(d, found.normal[0] + at), hn::Load(d, found.normal[1] + at),
                       hn::Load(d, found.normal[2] + at)});
    HWY_ALIGN double row[4][hn::MaxLanes(D64())];
    hn::Store(normal.x, d, row[0]);
    hn::Store(normal.y, d, row[1]);
    hn::Store(normal.z, d, row[2]);
    hn::Store(hn::Mul(scale_v, hn::Load(d, found.distance + at)), d, row[3]);
    const std::size_t lanes = HWY_MIN(hn::Lanes(d), near.count - at);
    for (std::size_t k = 0; k < lanes; ++k) {
      const auto to = static_cast<std::size_t>(near.from[at + k]);
      const double overlap = g.radius[to] - row[3][k];
      g.overlap[to] = overlap;
      if (!(overlap > 0)) continue;
      ++touching;
      const double arm = 0.5 * (g.radius[to] + row[3][k]);
      for (int axis = 0; axis < 3; ++axis) {
        g.normal[axis][to] = row[axis][k];
        g.point[axis][to] = g.center[axis][to] - arm * row[axis][k];
      }
    }
  }
  return touching;
}

inline std::size_t polyhedron_sphere(const PolyhedronSphereGroup& g) noexcept {
  using V = hn::Vec<D64>;
  const TurnV<V> turn(g.pose.turn);
  std::size_t touching = 0;
  PackedLanes near, beside;
  FoundLanes found;
  for (std::size_t begin = 0; begin < g.count; begin += kChunk) {
    sieve_planes(g, turn, begin, HWY_MIN(begin + kChunk, g.count), near);
    if (near.count == 0) continue;
    sieve_feet(*g.pose.shape, near, found, beside);
    if (beside.count > 0) find_edges(*g.pose.shape, beside, found);
    touching += store_found(g, turn, near, found);
  }
  return touching;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
