// The overlap of two polyhedra from their edges: each edge as an interval inside the other body.
//
// Included once per Highway target. The surface of the overlap is bounded by pieces of edges of A
// and of B, and by traces, where a face of A cuts a face of B. An edge's interval [t0, t1] comes
// from the planes of the other body, lanes over edges; an end that plane g has cut off is also an
// end of the traces of g on both faces at that edge. Every trace has exactly one start and one end:
//
//       on face f of A (counterclockwise):   edge of A ... leaves B through g
//                                            trace (f, g)  start = that point
//                                            trace (f, g)  end   = where an edge of A enters, or
//                                            where
//                                                                  an edge of B at g pierces f
// If the ends do not pair up, rounding has decided against geometry somewhere and the polygons are
// asked instead. Sums need each piece once, with the feet c of the reference point on both its
// planes:
//   6 V = sum (c_left - c_right) . (p x q),   2 S = sum over traces of p x q.
#if defined(QUERN_KERNELS_PAIRS_POLYHEDRON_EDGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_KERNELS_PAIRS_POLYHEDRON_EDGES_INL_H_
#undef QUERN_KERNELS_PAIRS_POLYHEDRON_EDGES_INL_H_
#else
#define QUERN_KERNELS_PAIRS_POLYHEDRON_EDGES_INL_H_
#endif

#include <cmath>

#include "kernels/pairs/polyhedron_axis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

constexpr std::size_t kFastVertices = 64;  // one word of bits
constexpr std::size_t kFastFaces = 64;
constexpr std::size_t kFastKept = 24;   // planes of one body after the cull
constexpr std::size_t kFastEdges = 63;  // edges of one body in the slab
constexpr std::size_t kFastPieces = 2 * kFastEdges + 64;

struct KeptPlanes {
  HWY_ALIGN double nx[kFastKept], ny[kFastKept], nz[kFastKept], d[kFastKept];
  std::size_t count = 0;
  std::uint8_t slot[kFastFaces];  // of a face that was kept
  Vec3 normal(std::size_t k) const { return {nx[k], ny[k], nz[k]}; }
};

struct EdgeLanes {
  HWY_ALIGN double ax[kFastEdges + 9], ay[kFastEdges + 9], az[kFastEdges + 9];
  HWY_ALIGN double bx[kFastEdges + 9], by[kFastEdges + 9], bz[kFastEdges + 9];
  HWY_ALIGN double t0[kFastEdges + 9], t1[kFastEdges + 9];
  HWY_ALIGN double cut0[kFastEdges + 9], cut1[kFastEdges + 9];  // plane at that end; -1: a vertex
  std::uint8_t left[kFastEdges], right[kFastEdges];             // slots of the faces at the edge
  std::size_t count = 0;
  std::uint64_t inside = 0;  // edges with a piece in the other body
};

// A piece of the overlap's edges: from, to relative to the reference; planes count A's, then B's
// from kFastKept on.
struct Pieces {
  Vec3 from[kFastPieces], to[kFastPieces];
  std::uint8_t left[kFastPieces], right[kFastPieces];
  std::size_t count = 0, of_a = 0, of_edges = 0;  // edges of A, of both, then traces
};

// Faces around the vertices in `vertices`.
HWY_INLINE std::uint64_t faces_around(const Shape& shape, std::uint64_t vertices) {
  std::uint64_t faces = 0;
  for (; vertices != 0; vertices &= vertices - 1) {
    faces |= shape.vertex_faces[static_cast<std::size_t>(__builtin_ctzll(vertices))];
  }
  return faces;
}

// Vertices of the shape with u . v >= least.
HWY_INLINE std::uint64_t vertices_above(const Shape& shape, const Vec3& u, double least) {
  const D64 d;
  const Vec3V<VD> axis = broadcast(u);
  const VD limit = hn::Set(d, least);
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < shape.vertices; k += hn::Lanes(d)) {
    const VD height = dot(axis, load3(shape.x.data(), shape.y.data(), shape.z.data(), k));
    bits |= bits_of(d, hn::Ge(height, limit)) << k;
  }
  return shape.vertices == 64 ? bits : bits & ((1ull << shape.vertices) - 1);
}

// Edges with an end in `vertices`; x, y, z hold the vertices in the frame of the pair. False if
// they are too many.
HWY_NOINLINE bool gather_edges(const Shape& shape, std::uint64_t vertices, const double* x,
                               const double* y, const double* z, const std::uint8_t* slot,
                               EdgeLanes& out) {
  std::uint8_t chosen[3 * kFastVertices];
  const std::uint16_t* ends = shape.edge_vertex.data();
  std::size_t count = 0;
  for (std::size_t e = 0; e < shape.edges; ++e) {
    chosen[count] = static_cast<std::uint8_t>(e);
    count += ((vertices >> ends[2 * e]) | (vertices >> ends[2 * e + 1])) & 1;
  }
  if (count > kFastEdges) return false;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t e = chosen[k], p = ends[2 * e], q = ends[2 * e + 1];
    out.ax[k] = x[p];
    out.ay[k] = y[p];
    out.az[k] = z[p];
    out.bx[k] = x[q];
    out.by[k] = y[q];
    out.bz[k] = z[q];
    out.left[k] = slot[shape.edge_face[2 * e]];
    out.right[k] = slot[shape.edge_face[2 * e + 1]];
  }
  const D64 d;
  for (std::size_t k = count; k < count + hn::Lanes(d); ++k) {
    out.ax[k] = out.ay[k] = out.az[k] = out.bx[k] = out.by[k] = out.bz[k] = 0;
  }
  out.count = count;
  return true;
}

HWY_NOINLINE void clip_edges(const KeptPlanes& planes, EdgeLanes& edges) {
  const D64 d;
  const VD zero = hn::Zero(d), one = hn::Set(d, 1.0), none = hn::Set(d, -1.0);
  edges.inside = 0;
  for (std::size_t k = 0; k < edges.count; k += hn::Lanes(d)) {
    const Vec3V<VD> a = load3(edges.ax, edges.ay, edges.az, k);
    const Vec3V<VD> b = load3(edges.bx, edges.by, edges.bz, k);
    VD t0 = zero, t1 = one, cut0 = none, cut1 = none;
    for (std::size_t g = 0; g < planes.count; ++g) {
      const Vec3V<VD> n = {hn::Set(d, planes.nx[g]), hn::Set(d, planes.ny[g]),
                           hn::Set(d, planes.nz[g])};
      const VD offset = hn::Set(d, planes.d[g]), label = hn::Set(d, static_cast<double>(g));
      const VD ha = hn::Sub(dot(n, a), offset), hb = hn::Sub(dot(n, b), offset);
      const auto out_a = hn::Gt(ha, zero), out_b = hn::Gt(hb, zero);
      const auto enters = hn::AndNot(out_b, out_a), leaves = hn::AndNot(out_a, out_b);
      const VD drop = hn::IfThenElse(hn::Or(enters, leaves), hn::Sub(ha, hb), one);
      const VD t = hn::Div(ha, drop);
      const auto later = hn::And(enters, hn::Gt(t, t0));
      const auto sooner = hn::And(leaves, hn::Lt(t, t1));
      t0 = hn::IfThenElse(later, t, t0);
      cut0 = hn::IfThenElse(later, label, cut0);
      t1 = hn::IfThenElse(sooner, t, t1);
      cut1 = hn::IfThenElse(sooner, label, cut1);
      t1 = hn::IfThenElse(hn::And(out_a, out_b), none, t1);
    }
    hn::StoreU(t0, d, edges.t0 + k);
    hn::StoreU(t1, d, edges.t1 + k);
    hn::StoreU(cut0, d, edges.cut0 + k);
    hn::StoreU(cut1, d, edges.cut1 + k);
    edges.inside |= bits_of(d, hn::Lt(t0, t1)) << k;
  }
  edges.inside &= (1ull << edges.count) - 1;
}

// Where traces start and end, by (slot of A's face, slot of B's face).
struct TraceEnds {
  static constexpr std::size_t kWords = (kFastKept * kFastKept + 63) / 64;
  Vec3 start[kFastKept * kFastKept], end[kFastKept * kFastKept];
  std::uint64_t started[kWords] = {}, ended[kWords] = {};
  std::uint64_t twice = 0;
  HWY_INLINE void put_start(std::size_t f, std::size_t g, const Vec3& p) {
    put(f * kFastKept + g, p, start, started);
  }
  HWY_INLINE void put_end(std::size_t f, std::size_t g, const Vec3& p) {
    put(f * kFastKept + g, p, end, ended);
  }
  HWY_INLINE bool paired() const {
    std::uint64_t odd = twice;
    for (std::size_t word = 0; word < kWords; ++word) odd |= started[word] ^ ended[word];
    return odd == 0;
  }

 private:
  HWY_INLINE void put(std::size_t k, const Vec3& p, Vec3* where, std::uint64_t* bits) {
    const std::uint64_t bit = 1ull << (k & 63);
    twice |= bits[k >> 6] & bit;
    bits[k >> 6] |= bit;
    where[k] = p;
  }
};

HWY_INLINE Vec3 edge_point(const EdgeLanes& edges, std::size_t k, double t) {
  const Vec3 a(edges.ax[k], edges.ay[k], edges.az[k]), b(edges.bx[k], edges.by[k], edges.bz[k]);
  return a + t * (b - a);
}

// Pieces of A's edges (side 0) or B's (side 1), and the ends of traces they mark.
HWY_NOINLINE void collect_pieces(const EdgeLanes& edges, std::size_t side, Vec3& reference,
                                 Pieces& pieces, TraceEnds& traces) {
  for (std::uint64_t bits = edges.inside; bits != 0; bits &= bits - 1) {
    const std::size_t k = static_cast<std::size_t>(__builtin_ctzll(bits));
    if (pieces.count == 0) reference = edge_point(edges, k, edges.t0[k]);
    const Vec3 from = edge_point(edges, k, edges.t0[k]) - reference;
    const Vec3 to = edge_point(edges, k, edges.t1[k]) - reference;
    const std::size_t left = edges.left[k], right = edges.right[k];
    const std::size_t base = side * kFastKept;
    pieces.from[pieces.count] = from;
    pieces.to[pieces.count] = to;
    pieces.left[pieces.count] = static_cast<std::uint8_t>(base + left);
    pieces.right[pieces.count++] = static_cast<std::uint8_t>(base + right);
    const int cut0 = static_cast<int>(edges.cut0[k]), cut1 = static_cast<int>(edges.cut1[k]);
    if (side == 0) {
      if (cut0 >= 0) {
        traces.put_end(left, std::size_t(cut0), from);
        traces.put_start(right, std::size_t(cut0), from);
      }
      if (cut1 >= 0) {
        traces.put_start(left, std::size_t(cut1), to);
        traces.put_end(right, std::size_t(cut1), to);
      }
    } else {
      if (cut0 >= 0) {
        traces.put_start(std::size_t(cut0), left, from);
        traces.put_end(std::size_t(cut0), right, from);
      }
      if (cut1 >= 0) {
        traces.put_end(std::size_t(cut1), left, to);
        traces.put_start(std::size_t(cut1), right, to);
      }
    }
  }
}

// False if there are too many.
HWY_INLINE bool collect_traces(const TraceEnds& traces, Pieces& pieces) {
  for (std::size_t word = 0; word < TraceEnds::kWords; ++word) {
    for (std::uint64_t bits = traces.started[word]; bits != 0; bits &= bits - 1) {
      if (pieces.count == kFastPieces) return false;
      const std::size_t k = 64 * word + static_cast<std::size_t>(__builtin_ctzll(bits));
      pieces.from[pieces.count] = traces.start[k];
      pieces.to[pieces.count] = traces.end[k];
      pieces.left[pieces.count] = static_cast<std::uint8_t>(k / kFastKept);
      pieces.right[pieces.count++] = static_cast<std::uint8_t>(kFastKept + k % kFastKept);
    }
  }
  return true;
}

// Volume, first moment, vector area, surface, and with `moment` the moment of A's part, all about
// the reference.
HWY_NOINLINE void sum_pieces(const Pieces& pieces, const Vec3* foot, const Vec3* normal,
                             NormalModel model, PairOverlap& out) {
  double volume = 0, surface = 0;
  Vec3 first = Vec3::Zero(), area = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t k = 0; k < pieces.count; ++k) {
    const Vec3 p = pieces.from[k], q = pieces.to[k], turn = p.cross(q), both = p + q;
    const std::size_t left = pieces.left[k], right = pieces.right[k];
    const double in = foot[left].dot(turn), out_right = foot[right].dot(turn);
    volume += in - out_right;
    surface += normal[left].dot(turn) - normal[right].dot(turn);
    first += in * (foot[left] + both) - out_right * (foot[right] + both);
    if (k >= pieces.of_edges) area += turn;
    if (model == NormalModel::kVolume && (k < pieces.of_a || k >= pieces.of_edges)) {
      moment += normal[left].dot(turn) * both.cross(normal[left]);
      if (k < pieces.of_a) moment -= normal[right].dot(turn) * both.cross(normal[right]);
    }
  }
  out.volume = volume / 6;
  out.surface = surface / 2;
  out.vector_area = 0.5 * area;
  out.centroid = volume > 0 ? Vec3(first / (4 * volume)) : Vec3::Zero();
  out.moment = moment / 6;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
