// Spheres near one polyhedron, in two stages with different lanes.
//
//   1 planes  lanes are spheres: the highest plane over each centre. Farther than the radius:
//   apart,
//             and that is all that most listed pairs cost. Planes are the same for all lanes.
//   2 point   the few that are left, one at a time; lanes are planes, then edges. The foot of the
//             centre on its highest plane is the closest point if it lies in the body: the distance
//             to a half-space that holds the body is never more than that to the body, so that no
//             other face can be closest. Else the closest point lies on an edge: the least over
//             all.
//
// With spheres as lanes stage 2 would have to move survivors together to fill its vectors and would
// still wait for the last; planes and edges always fill them. No gathers, no branches on features
// but one, and what a sphere gets depends on it and the polyhedron alone, not on its place in the
// group.
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

constexpr std::size_t kChunk = 64;  // spheres between the two stages; a multiple of kShapePad
constexpr double kFootUnits = 8;    // rounding of a foot's height over a plane, in units of 2^-52
constexpr double kOnTheSurface = 1e-12;  // of the radius: below, the face's normal is taken

// What stage 1 hands on: centres in the body frame over the scale, the height over the highest
// plane, that plane, and which of the chunk are left.
struct PlaneStage {
  HWY_ALIGN double center[3][kChunk];
  HWY_ALIGN double height[kChunk];
  HWY_ALIGN std::int64_t face[kChunk];
  std::uint32_t left[kChunk];
  std::size_t left_count;
};

// Towards the centre, over the scale, body axes.
struct NearestPoint {
  double normal[3];
  double distance;
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

// Stage 1 for spheres [begin, end) of the group. Overlaps of what is apart are final; padding gets
// 0.
template <class V>
HWY_INLINE void sieve_planes(const PolyhedronSphereGroup& g, const IntoBodyV<V>& into_body,
                             std::size_t begin, std::size_t end, PlaneStage& stage) {
  const D64 d;
  const D64I di;
  const Shape& s = *g.pose.shape;
  const double *nx = s.nx.data(), *ny = s.ny.data(), *nz = s.nz.data(), *offset = s.d.data();
  const V zero = hn::Zero(d), scale_v = hn::Set(d, g.pose.scale);
  for (std::size_t at = begin; at < end; at += hn::Lanes(d)) {
    const Vec3V<V> c = into_body({hn::LoadU(d, g.center[0] + at), hn::LoadU(d, g.center[1] + at),
                                  hn::LoadU(d, g.center[2] + at)});
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
    const V overlap = hn::NegMulAdd(scale_v, highest, hn::LoadU(d, g.radius + at));
    hn::StoreU(hn::IfThenElseZero(hn::FirstN(d, end - at), overlap), d, g.overlap + at);
    for (int k = 0; k < 3; ++k) {
      hn::StoreU(zero, d, g.normal[k] + at);
      hn::StoreU(zero, d, g.point[k] + at);
    }
    const std::size_t to = at - begin;
    hn::Store(c.x, d, stage.center[0] + to);
    hn::Store(c.y, d, stage.center[1] + to);
    hn::Store(c.z, d, stage.center[2] + to);
    hn::Store(highest, d, stage.height + to);
    hn::Store(face, di, stage.face + to);
  }
  stage.left_count = 0;
  for (std::size_t at = begin; at < end; ++at) {
    stage.left[stage.left_count] = static_cast<std::uint32_t>(at - begin);
    stage.left_count += g.overlap[at] > 0 ? 1 : 0;
  }
}

// Lanes are planes. A foot that is outside by rounding only counts as on the face: its distance to
// the body is then of that order.
template <class V>
HWY_INLINE bool foot_in_body(const Shape& s, const Vec3V<V>& foot, double height) {
  const D64 d;
  V outside = hn::Zero(d);
  for (std::size_t f = 0; f < s.faces; f += hn::Lanes(d)) {
    const Vec3V<V> n = {hn::Load(d, s.nx.data() + f), hn::Load(d, s.ny.data() + f),
                        hn::Load(d, s.nz.data() + f)};
    outside = hn::Max(outside, hn::Sub(dot(n, foot), hn::Load(d, s.d.data() + f)));
  }
  const V rounding = hn::Set(d, kFootUnits * 0x1p-52 * (s.bound_radius + height));
  return hn::AllFalse(d, hn::Gt(outside, rounding));
}

// The edges' closest point to a centre; lanes are edges.
template <class V>
HWY_INLINE NearestPoint nearest_on_edges(const Shape& s, const Vec3V<V>& center) {
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
  return {{row[0][lane], row[1][lane], row[2][lane]}, std::sqrt(hn::GetLane(distance2))};
}

// Stage 2 for sphere k of the chunk, `radius` over the scale.
HWY_INLINE NearestPoint nearest_point(const Shape& s, const PlaneStage& stage, std::size_t k,
                                      double radius) {
  const D64 d;
  using V = hn::Vec<D64>;
  const auto face = static_cast<std::size_t>(stage.face[k]);
  const double height = stage.height[k];
  const NearestPoint on_face = {{s.nx.data()[face], s.ny.data()[face], s.nz.data()[face]}, height};
  if (height <= 0) return on_face;
  const Vec3V<V> center = {hn::Set(d, stage.center[0][k]), hn::Set(d, stage.center[1][k]),
                           hn::Set(d, stage.center[2][k])};
  const Vec3V<V> normal = {hn::Set(d, on_face.normal[0]), hn::Set(d, on_face.normal[1]),
                           hn::Set(d, on_face.normal[2])};
  if (foot_in_body(s, add_scaled(center, hn::Set(d, -height), normal), height)) return on_face;
  NearestPoint on_edge = nearest_on_edges(s, center);
  if (!(on_edge.distance > kOnTheSurface * radius)) return on_face;
  const double inverse = 1 / on_edge.distance;
  for (double& axis : on_edge.normal) axis *= inverse;
  return on_edge;
}

// Overlap, normal and contact point of sphere `to` of the group, in the world; whether it touches.
HWY_INLINE bool store_touch(const PolyhedronSphereGroup& g, const NearestPoint& p, std::size_t to) {
  const double radius = g.radius[to], distance = g.pose.scale * p.distance;
  g.overlap[to] = radius - distance;
  if (!(g.overlap[to] > 0)) return false;
  const double* turn = g.pose.turn.data();  // by columns
  const double arm = 0.5 * (radius + distance);
  for (int k = 0; k < 3; ++k) {
    const double normal =
        turn[k] * p.normal[0] + turn[3 + k] * p.normal[1] + turn[6 + k] * p.normal[2];
    g.normal[k][to] = normal;
    g.point[k][to] = g.center[k][to] - arm * normal;
  }
  return true;
}

inline std::size_t polyhedron_sphere(const PolyhedronSphereGroup& g) noexcept {
  const IntoBodyV<hn::Vec<D64>> into_body(g.pose);
  const double inverse = 1 / g.pose.scale;
  std::size_t touching = 0;
  PlaneStage stage;
  for (std::size_t begin = 0; begin < g.count; begin += kChunk) {
    sieve_planes(g, into_body, begin, HWY_MIN(begin + kChunk, g.count), stage);
    for (std::size_t n = 0; n < stage.left_count; ++n) {
      const std::size_t k = stage.left[n], to = begin + k;
      const NearestPoint p = nearest_point(*g.pose.shape, stage, k, inverse * g.radius[to]);
      touching += store_touch(g, p, to) ? 1 : 0;
    }
  }
  return touching;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
