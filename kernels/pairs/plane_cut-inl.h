// A convex shape cut by one plane, from its edges, on one SIMD target; see wall_patch.h.
//
// Heights of the vertices, lanes over vertices, choose the edges: those with an end behind the
// plane, of which those with one end only cross it. Lanes over edges then cut them and sum
// tetrahedra
//
//   between a corner r of the section, a point of each face, and the piece of an edge around it.
//
// The point is where the face's trace on the plane starts, so that traces add nothing, and all
// tetrahedra lie in the part behind the plane: a flat part keeps its digits. Seen from outside, the
// way along an edge out of the plane's back has a face to its left whose trace starts at the
// crossing, and one to its right whose trace ends there; that orders the section's corners. Only
// the signs of heights decide, each vertex has one height: if starts and ends do not make one ring,
// rounding has decided against geometry and the polygons are asked.
#if defined(QUERN_KERNELS_PAIRS_PLANE_CUT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_KERNELS_PAIRS_PLANE_CUT_INL_H_
#undef QUERN_KERNELS_PAIRS_PLANE_CUT_INL_H_
#else
#define QUERN_KERNELS_PAIRS_PLANE_CUT_INL_H_
#endif

#include <limits>

#include "kernels/pairs/polyhedron_axis-inl.h"
#include "kernels/pairs/wall_patch.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// Pieces of edges in the direction in which the shape stores them.
struct CutPieces {
  HWY_ALIGN double from[3][kMaxCutEdges], to[3][kMaxCutEdges];
  HWY_ALIGN double height[2][kMaxCutEdges];
  HWY_ALIGN double left[3][kMaxCutEdges], right[3][kMaxCutEdges];  // points of the faces there
  std::uint8_t face[2][kMaxCutEdges];
  std::size_t count = 0;
};

// Where edges cross the plane, by the face whose trace starts there.
struct CutRing {
  double at[3][kMaxCutEdges];
  std::uint8_t before[kMaxCutEdges];  // the face whose trace ends there
  std::uint64_t started = 0, ended = 0;
};

// Returns the vertices that are not before the plane.
HWY_INLINE std::uint64_t find_heights(const Shape& shape, const Plane& plane, double* height,
                                      FaceSides& sides) {
  const D64 d;
  const Vec3V<VD> normal = broadcast(plane.normal);
  const VD offset = hn::Set(d, plane.offset), zero = hn::Zero(d);
  VD low = hn::Set(d, std::numeric_limits<double>::max()), high = hn::Neg(low);
  std::uint64_t behind = 0;
  for (std::size_t k = 0; k < shape.vertices; k += hn::Lanes(d)) {
    const VD h =
        hn::Sub(dot(normal, load3(shape.x.data(), shape.y.data(), shape.z.data(), k)), offset);
    hn::StoreU(h, d, height + k);
    low = hn::Min(low, h);
    high = hn::Max(high, h);
    behind |= bits_of(d, hn::Le(h, zero)) << k;
  }
  sides.deepest = hn::GetLane(hn::MinOfLanes(d, low));
  sides.highest = hn::GetLane(hn::MaxOfLanes(d, high));
  return shape.vertices == 64 ? behind : behind & ((std::uint64_t{1} << shape.vertices) - 1);
}

HWY_INLINE void gather_pieces(const Shape& shape, const double* height, std::uint64_t edges,
                              CutPieces& out) {
  const double* const at[3] = {shape.x.data(), shape.y.data(), shape.z.data()};
  std::size_t n = 0;
  for (; edges != 0; edges &= edges - 1) {
    const std::size_t e = static_cast<std::size_t>(__builtin_ctzll(edges));
    const std::size_t p = shape.edge_vertex[2 * e], q = shape.edge_vertex[2 * e + 1];
    for (int a = 0; a < 3; ++a) {
      out.from[a][n] = at[a][p];
      out.to[a][n] = at[a][q];
    }
    out.height[0][n] = height[p];
    out.height[1][n] = height[q];
    out.face[0][n] = static_cast<std::uint8_t>(shape.edge_face[2 * e]);
    out.face[1][n++] = static_cast<std::uint8_t>(shape.edge_face[2 * e + 1]);
  }
  out.count = n;
  const D64 d;
  for (; n % hn::Lanes(d) != 0; ++n) {  // lanes of nothing
    for (int a = 0; a < 3; ++a) out.from[a][n] = out.to[a][n] = out.from[a][0];
    out.height[0][n] = out.height[1][n] = 0;
  }
}

// Cuts the ends off that are before the plane, as crossing() does.
HWY_INLINE void cut_pieces(CutPieces& pieces) {
  const D64 d;
  const VD zero = hn::Zero(d), one = hn::Set(d, 1.0);
  for (std::size_t k = 0; k < pieces.count; k += hn::Lanes(d)) {
    const VD ha = hn::Load(d, pieces.height[0] + k), hb = hn::Load(d, pieces.height[1] + k);
    const auto out_a = hn::Gt(ha, zero), out_b = hn::Gt(hb, zero);
    const VD in = hn::IfThenElse(out_a, hb, ha), out = hn::IfThenElse(out_a, ha, hb);
    const VD t = hn::Div(in, hn::IfThenElse(hn::Or(out_a, out_b), hn::Sub(in, out), one));
    for (int a = 0; a < 3; ++a) {
      const VD p = hn::Load(d, pieces.from[a] + k), q = hn::Load(d, pieces.to[a] + k);
      const VD inside = hn::IfThenElse(out_a, q, p), outside = hn::IfThenElse(out_a, p, q);
      const VD x = hn::Add(inside, hn::Mul(t, hn::Sub(outside, inside)));
      hn::Store(hn::IfThenElse(out_a, x, p), d, pieces.from[a] + k);
      hn::Store(hn::IfThenElse(out_b, x, q), d, pieces.to[a] + k);
    }
  }
}

// False if the crossings do not pair up.
HWY_INLINE bool find_ring(const CutPieces& pieces, CutRing& ring) {
  for (std::size_t k = 0; k < pieces.count; ++k) {
    const bool leaves = pieces.height[1][k] > 0;
    if (!leaves && !(pieces.height[0][k] > 0)) continue;
    const std::size_t left = pieces.face[leaves ? 0 : 1][k], right = pieces.face[leaves ? 1 : 0][k];
    const std::uint64_t l = std::uint64_t{1} << left, r = std::uint64_t{1} << right;
    if ((ring.started & l) != 0 || (ring.ended & r) != 0) return false;
    ring.started |= l;
    ring.ended |= r;
    for (int a = 0; a < 3; ++a) ring.at[a][left] = (leaves ? pieces.to : pieces.from)[a][k];
    ring.before[left] = static_cast<std::uint8_t>(right);
  }
  return ring.started != 0 && ring.started == ring.ended;
}

// The section, counterclockwise about the plane's normal; false if there is more than one ring.
HWY_INLINE bool walk_ring(const CutRing& ring, ClipBuffers& buffers) {
  const std::size_t first = static_cast<std::size_t>(__builtin_ctzll(ring.started));
  const int all = __builtin_popcountll(ring.started);
  std::size_t face = first;
  buffers.start();
  do {
    buffers.add({ring.at[0][face], ring.at[1][face], ring.at[2][face]}, ring.before[face]);
    face = ring.before[face];
  } while (face != first && buffers.now->corners < all);
  return face == first && buffers.now->corners == all;
}

// A point of the face of each piece: where its trace starts, or else a corner behind the plane.
HWY_INLINE void give_points(const CutPieces& pieces, const CutRing& ring,
                            double (*left)[kMaxCutEdges], double (*right)[kMaxCutEdges]) {
  double at[3][kMaxCutEdges];
  std::uint64_t known = ring.started;
  for (std::uint64_t faces = known; faces != 0; faces &= faces - 1) {
    const std::size_t f = static_cast<std::size_t>(__builtin_ctzll(faces));
    for (int a = 0; a < 3; ++a) at[a][f] = ring.at[a][f];
  }
  for (std::size_t k = 0; k < pieces.count; ++k) {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t f = pieces.face[side][k];
      if ((known >> f & 1) == 0) {
        for (int a = 0; a < 3; ++a) at[a][f] = pieces.from[a][k];
        known |= std::uint64_t{1} << f;
      }
      for (int a = 0; a < 3; ++a) (side == 0 ? left : right)[a][k] = at[a][f];
    }
  }
}

HWY_INLINE void sum_cut(CutPieces& pieces, const Vec3& reference, PlaneCut& cut) {
  const D64 d;
  for (std::size_t k = pieces.count; k % hn::Lanes(d) != 0; ++k) {
    for (int a = 0; a < 3; ++a) {
      pieces.from[a][k] = pieces.to[a][k] = reference[a];
      pieces.left[a][k] = pieces.right[a][k] = reference[a];
    }
  }
  const Vec3V<VD> from = broadcast(reference);
  const auto load = [&](const double(&at)[3][kMaxCutEdges], std::size_t k) HWY_ATTR {
    return Vec3V<VD>{hn::Load(d, at[0] + k), hn::Load(d, at[1] + k), hn::Load(d, at[2] + k)} - from;
  };
  const VD zero = hn::Zero(d);
  VD volume = zero, reach2 = zero;
  Vec3V<VD> first = {zero, zero, zero};
  for (std::size_t k = 0; k < pieces.count; k += hn::Lanes(d)) {
    const Vec3V<VD> p = load(pieces.from, k), q = load(pieces.to, k);
    const Vec3V<VD> left = load(pieces.left, k), right = load(pieces.right, k);
    const Vec3V<VD> turn = cross(p, q), both = p + q;
    const VD in = dot(left, turn), out = hn::Neg(dot(right, turn));
    volume = hn::Add(volume, hn::Add(in, out));
    first = add_scaled(add_scaled(first, in, left + both), out, right + both);
    reach2 = hn::Max(reach2, hn::Max(dot(p, p), dot(q, q)));
  }
  const auto sum = [&](VD v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
  cut.volume = sum(volume) / 6;
  cut.reach2 = hn::GetLane(hn::MaxOfLanes(d, reach2));
  cut.centroid = reference;
  if (cut.volume > 0) {
    cut.centroid += Vec3(sum(first.x), sum(first.y), sum(first.z)) / (24 * cut.volume);
  }
}

HWY_INLINE bool cut_shape(const Shape& shape, const Plane& plane, ClipBuffers& buffers,
                          PlaneCut& cut) {
  HWY_ALIGN double height[kMaxCutEdges];
  const std::uint64_t behind = find_heights(shape, plane, height, cut.sides);
  if (!(cut.sides.deepest < 0 && cut.sides.highest > 0)) return false;
  std::uint64_t edges = 0, faces = 0;
  for (std::uint64_t v = behind; v != 0; v &= v - 1) {
    const std::size_t k = static_cast<std::size_t>(__builtin_ctzll(v));
    edges |= shape.vertex_edges[k];
    faces |= shape.vertex_faces[k];
  }
  cut.sides.behind[0] = faces;
  CutPieces pieces;
  CutRing ring;
  gather_pieces(shape, height, edges, pieces);
  cut_pieces(pieces);
  if (!find_ring(pieces, ring) || !walk_ring(ring, buffers)) return false;
  give_points(pieces, ring, pieces.left, pieces.right);
  sum_cut(pieces, buffers.now->corner[0], cut);
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
