// Supports of a shape by lanes over its vertices, and GJK, which finds an axis between two bodies.
//
// Included once per Highway target. GJK (Gilbert, Johnson, Keerthi 1988) works on the difference
// A - B in the frame of the pair and is asked for an axis only: whoever uses the axis tests it with
// two supports, so an early end or a degenerate simplex costs time, never a contact.
#if defined(QUERN_KERNELS_PAIRS_POLYHEDRON_AXIS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_KERNELS_PAIRS_POLYHEDRON_AXIS_INL_H_
#undef QUERN_KERNELS_PAIRS_POLYHEDRON_AXIS_INL_H_
#else
#define QUERN_KERNELS_PAIRS_POLYHEDRON_AXIS_INL_H_
#endif

#include <cmath>

#include "kernels/pairs/polyhedron_polyhedron.h"
#include "kernels/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

using VD = hn::Vec<D64>;

HWY_INLINE Vec3V<VD> broadcast(const Vec3& v) {
  const D64 d;
  return {hn::Set(d, v.x()), hn::Set(d, v.y()), hn::Set(d, v.z())};
}
HWY_INLINE Vec3V<VD> load3(const double* x, const double* y, const double* z, std::size_t k) {
  const D64 d;
  return {hn::LoadU(d, x + k), hn::LoadU(d, y + k), hn::LoadU(d, z + k)};
}
// Mask of one vector as bits.
template <class M>
HWY_INLINE std::uint64_t bits_of(const D64 d, M mask) {
  std::uint8_t bytes[8] = {0, 0, 0, 0, 0, 0, 0, 0};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0];
}

// max over the vertices of u . v
HWY_INLINE double support_height(const Shape& shape, const Vec3& u) {
  const D64 d;
  const Vec3V<VD> axis = broadcast(u);
  const std::size_t count = shape.padded_vertices();
  VD best = dot(axis, load3(shape.x.data(), shape.y.data(), shape.z.data(), 0));
  for (std::size_t k = hn::Lanes(d); k < count; k += hn::Lanes(d)) {
    best = hn::Max(best, dot(axis, load3(shape.x.data(), shape.y.data(), shape.z.data(), k)));
  }
  return hn::GetLane(hn::MaxOfLanes(d, best));
}

// The vertex of the greatest u . v.
HWY_INLINE Vec3 support_point(const Shape& shape, const Vec3& u) {
  const D64 d;
  const Vec3V<VD> axis = broadcast(u);
  const std::size_t lanes = hn::Lanes(d), count = shape.padded_vertices();
  VD best = dot(axis, load3(shape.x.data(), shape.y.data(), shape.z.data(), 0));
  VD where = hn::Zero(d);
  for (std::size_t k = lanes; k < count; k += lanes) {
    const VD height = dot(axis, load3(shape.x.data(), shape.y.data(), shape.z.data(), k));
    const auto higher = hn::Gt(height, best);
    best = hn::IfThenElse(higher, height, best);
    where = hn::IfThenElse(higher, hn::Set(d, static_cast<double>(k)), where);
  }
  HWY_ALIGN double at[hn::MaxLanes(D64())];
  hn::Store(where, d, at);
  const std::uint64_t top = bits_of(d, hn::Eq(best, hn::MaxOfLanes(d, best)));
  // Along no direction (NaN) none is farthest: the last lane.
  const auto lane = static_cast<std::size_t>(__builtin_ctzll(top | (1ull << (lanes - 1))));
  return shape.vertex(static_cast<std::size_t>(at[lane]) + lane);
}

// Corner of A - B farthest along u.
HWY_INLINE Vec3 support_difference(const PairFrame& frame, const Vec3& u) {
  return support_point(*frame.a, u) - frame.place +
         frame.ratio * (frame.turn * -support_point(*frame.b, -(frame.turn.transpose() * u)));
}

// Up to four corners of A - B; reduce() keeps those around the point nearest to the origin.
struct Simplex {
  Vec3 corner[4] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  int count = 0;
};

HWY_INLINE Vec3 nearest_on_segment(Simplex& s) {
  const Vec3 a = s.corner[0], along = s.corner[1] - a;
  const double t = -a.dot(along), length2 = along.squaredNorm();
  if (t <= 0 || !(length2 > 0)) {
    s.count = 1;
    return a;
  }
  if (t >= length2) {
    s.corner[0] = s.corner[1];
    s.count = 1;
    return s.corner[0];
  }
  return a + (t / length2) * along;
}

// By regions of the triangle's plane (Ericson, Real-Time Collision Detection, 5.1.5).
HWY_INLINE Vec3 nearest_on_triangle(Simplex& s) {
  const Vec3 a = s.corner[0], b = s.corner[1], c = s.corner[2];
  const Vec3 n = (b - a).cross(c - a);
  const double n2 = n.squaredNorm();
  const double wa = n.dot(b.cross(c)), wb = n.dot(c.cross(a)), wc = n.dot(a.cross(b));
  if (n2 > 0 && wa > 0 && wb > 0 && wc > 0) return (a.dot(n) / n2) * n;
  Simplex best;
  Vec3 nearest = Vec3::Zero();
  double distance2 = std::numeric_limits<double>::max();
  for (int k = 0; k < 3; ++k) {
    Simplex edge;
    edge.count = 2;
    edge.corner[0] = s.corner[k];
    edge.corner[1] = s.corner[(k + 1) % 3];
    const Vec3 p = nearest_on_segment(edge);
    if (p.squaredNorm() < distance2) {
      distance2 = p.squaredNorm();
      nearest = p;
      best = edge;
    }
  }
  s = best;
  return nearest;
}

// Zero (with count 4) if the origin is inside.
HWY_INLINE Vec3 nearest_on_tetrahedron(Simplex& s) {
  Simplex best;
  Vec3 nearest = Vec3::Zero();
  double distance2 = std::numeric_limits<double>::max();
  bool outside = false;
  for (int k = 0; k < 4; ++k) {
    Simplex face;
    face.count = 3;
    for (int m = 0; m < 3; ++m) face.corner[m] = s.corner[(k + 1 + m) % 4];
    const Vec3 a = face.corner[0];
    const Vec3 n = (face.corner[1] - a).cross(face.corner[2] - a);
    const double inner = n.dot(s.corner[k] - a), origin = -n.dot(a);
    if (inner != 0 && inner * origin >= 0) continue;
    outside = true;
    const Vec3 p = nearest_on_triangle(face);
    if (p.squaredNorm() < distance2) {
      distance2 = p.squaredNorm();
      nearest = p;
      best = face;
    }
  }
  if (outside) s = best;
  return nearest;
}

HWY_INLINE Vec3 reduce(Simplex& s) {
  switch (s.count) {
    case 1:
      return s.corner[0];
    case 2:
      return nearest_on_segment(s);
    case 3:
      return nearest_on_triangle(s);
    default:
      return nearest_on_tetrahedron(s);
  }
}

// A direction in the frame of the pair from A to B along which the bodies are apart, or, where
// there is none, one along which they hardly overlap. `guess` starts the search. `gap` >= 0: apart
// by it.
inline Vec3 find_axis(const PairFrame& frame, const Vec3& guess, double& gap) noexcept {
  constexpr int kIterations = 32;
  constexpr double kGoodGap = 0.9;  // of the distance: worth keeping
  const double touching = 1e-12 * frame.reach;
  Simplex s;
  s.corner[0] = support_difference(frame, guess);
  s.count = 1;
  Vec3 nearest = s.corner[0], axis = guess;
  gap = -1;
  for (int k = 0; k < kIterations; ++k) {
    const double distance = nearest.norm();
    if (distance <= touching) return axis;
    // The origin is B seen from A - B: it lies beyond along -nearest.
    const Vec3 toward = -nearest / distance;
    const Vec3 corner = support_difference(frame, toward);
    const double apart = -toward.dot(corner);
    if (apart > gap) {
      gap = apart;
      axis = toward;
    } else if (gap < 0) {
      axis = toward;
    }
    if (gap >= kGoodGap * distance) return axis;
    if (s.count == 4) return axis;
    for (int m = 0; m < s.count; ++m) {
      if (corner == s.corner[m]) return axis;
    }
    s.corner[s.count++] = corner;
    nearest = reduce(s);
    if (s.count == 4) return axis;
  }
  return axis;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
