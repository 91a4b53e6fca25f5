// The overlap of two polyhedra from their edges: each edge as an interval inside the other body.
//
// Included once per Highway target. The surface of the overlap is bounded by pieces of edges of A
// and of B, and by traces, where a face of A cuts a face of B. An edge's interval [t0, t1] comes
// from the planes of the other body, lanes over edges; an end that plane g has cut off is also an
// end of the traces of g on both faces at that edge. Every trace has exactly one start and one end:
//
//       on face f of A (counterclockwise):   edge of A ... leaves B through g
//                                            trace (f, g)  start = that point
//                                            trace (f, g)  end   = where an edge of A enters,
//                                                            or an edge of B at g pierces f
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

#include "kernels/pairs/polyhedron_slab-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

constexpr std::size_t kFastPieces = 2 * kKeptEdges + 64;
constexpr std::size_t kNoPlane = kKeptPlanes;  // an end that is a vertex

// The kept edges of one body inside the other.
struct Intervals {
  HWY_ALIGN double px[kKeptEdges + 9], py[kKeptEdges + 9], pz[kKeptEdges + 9];  // where they begin
  HWY_ALIGN double qx[kKeptEdges + 9], qy[kKeptEdges + 9], qz[kKeptEdges + 9];  // and end
  HWY_ALIGN double cut0[kKeptEdges + 9], cut1[kKeptEdges + 9];  // plane there, or kNoPlane
  std::uint64_t inside = 0;  // edges with a piece in the other body
};

// The part of each edge of `own` behind all planes of `other`.
HWY_NOINLINE void clip_edges(const SlabPart& other, const SlabPart& own, Intervals& out) {
  const D64 d;
  const VD zero = hn::Zero(d), one = hn::Set(d, 1.0), minus = hn::Set(d, -1.0);
  const VD none = hn::Set(d, static_cast<double>(kNoPlane));
  for (std::size_t k = 0; k < own.edges; k += hn::Lanes(d)) {
    const Vec3V<VD> a = load3(own.ax, own.ay, own.az, k);
    const Vec3V<VD> b = load3(own.bx, own.by, own.bz, k);
    VD t0 = zero, t1 = one, cut0 = none, cut1 = none;
    for (std::size_t g = 0; g < other.planes; ++g) {
      const Vec3V<VD> n = {hn::Set(d, other.nx[g]), hn::Set(d, other.ny[g]),
                           hn::Set(d, other.nz[g])};
      const VD offset = hn::Set(d, other.d[g]), label = hn::Set(d, static_cast<double>(g));
      const VD ha = hn::Sub(dot(n, a), offset), hb = hn::Sub(dot(n, b), offset);
      const auto out_a = hn::Gt(ha, zero), out_b = hn::Gt(hb, zero);
      const auto enters = hn::AndNot(out_b, out_a), leaves = hn::AndNot(out_a, out_b);
      const VD t = hn::Div(ha, hn::IfThenElse(hn::Or(enters, leaves), hn::Sub(ha, hb), one));
      const auto later = hn::And(enters, hn::Gt(t, t0));
      const auto sooner = hn::And(leaves, hn::Lt(t, t1));
      t0 = hn::IfThenElse(later, t, t0);
      cut0 = hn::IfThenElse(later, label, cut0);
      t1 = hn::IfThenElse(sooner, t, t1);
      cut1 = hn::IfThenElse(sooner, label, cut1);
      t1 = hn::IfThenElse(hn::And(out_a, out_b), minus, t1);
    }
    // Without fusing, as the plain way: its corners are the same to the bit.
    const Vec3V<VD> along = b - a, p = a + scale(t0, along), q = a + scale(t1, along);
    hn::StoreU(p.x, d, out.px + k);
    hn::StoreU(p.y, d, out.py + k);
    hn::StoreU(p.z, d, out.pz + k);
    hn::StoreU(q.x, d, out.qx + k);
    hn::StoreU(q.y, d, out.qy + k);
    hn::StoreU(q.z, d, out.qz + k);
    hn::StoreU(cut0, d, out.cut0 + k);
    hn::StoreU(cut1, d, out.cut1 + k);
    out.inside |= bits_of(d, hn::Lt(t0, t1)) << k;
  }
  out.inside &= (1ull << own.edges) - 1;
}

// Planes about the reference: its foot on a plane is c n.
struct FeetOf {
  HWY_ALIGN double c[kKeptPlanes + 9];
};
HWY_INLINE void find_feet(const SlabPart& part, const Vec3& reference, FeetOf& out) {
  const D64 d;
  for (std::size_t k = 0; k < part.planes; k += hn::Lanes(d)) {
    const VD along = dot(load3(part.nx, part.ny, part.nz, k), broadcast(reference));
    hn::StoreU(hn::Sub(hn::LoadU(d, part.d + k), along), d, out.c + k);
  }
}

// Pieces of the overlap's edges, from p to q, each with the planes to its left and right.
struct Pieces {
  HWY_ALIGN double px[kFastPieces + 8], py[kFastPieces + 8], pz[kFastPieces + 8];
  HWY_ALIGN double qx[kFastPieces + 8], qy[kFastPieces + 8], qz[kFastPieces + 8];
  HWY_ALIGN double lx[kFastPieces + 8], ly[kFastPieces + 8], lz[kFastPieces + 8];
  HWY_ALIGN double lc[kFastPieces + 8];
  HWY_ALIGN double rx[kFastPieces + 8], ry[kFastPieces + 8], rz[kFastPieces + 8];
  HWY_ALIGN double rc[kFastPieces + 8];
  std::size_t count = 0, of_a = 0, of_edges = 0;  // edges of A, of both, then traces

  HWY_INLINE void set_planes(const SlabPart& left, const FeetOf& left_feet, std::size_t l,
                             const SlabPart& right, const FeetOf& right_feet, std::size_t r) {
    lx[count] = left.nx[l];
    ly[count] = left.ny[l];
    lz[count] = left.nz[l];
    lc[count] = left_feet.c[l];
    rx[count] = right.nx[r];
    ry[count] = right.ny[r];
    rz[count] = right.nz[r];
    rc[count] = right_feet.c[r];
  }
};

// Where traces start and end, as ends of pieces (2 piece, or 2 piece + 1 for its q), by the slots
// of A's and B's face. Each cut is one start and one end, so both are equally many; they pair up if
// every start finds an end of its own.
struct TraceEnds {
  static constexpr std::size_t kRow = kKeptPlanes + 1;
  std::uint32_t ended[kRow] = {};  // bits of B's slots; what belongs to kNoPlane counts for nothing
  std::uint8_t end[kRow * kRow];
  std::uint16_t start_at[4 * kKeptEdges + 2];
  std::uint8_t start[4 * kKeptEdges + 2];
  std::size_t starts = 0;

  HWY_INLINE void put_end(std::size_t f, std::size_t g, std::size_t piece_end) {
    ended[f] |= 1u << g;
    end[f * kRow + g] = static_cast<std::uint8_t>(piece_end);
  }
  HWY_INLINE void put_start(std::size_t f, std::size_t g, std::size_t piece_end, bool real) {
    start_at[starts] = static_cast<std::uint16_t>(f * kRow + g);
    start[starts] = static_cast<std::uint8_t>(piece_end);
    starts += real ? 1 : 0;
  }
};

// Pieces of A's edges (side 0) or B's (side 1), and the ends of traces they mark.
template <int side>
HWY_INLINE void collect_pieces(const SlabPart& part, const FeetOf& feet, const Intervals& in,
                               Pieces& pieces, TraceEnds& traces) {
  for (std::uint64_t bits = in.inside; bits != 0; bits &= bits - 1) {
    const std::size_t k = static_cast<std::size_t>(__builtin_ctzll(bits));
    const std::size_t left = part.left[k], right = part.right[k], piece = 2 * pieces.count;
    pieces.set_planes(part, feet, left, part, feet, right);
    pieces.px[pieces.count] = in.px[k];
    pieces.py[pieces.count] = in.py[k];
    pieces.pz[pieces.count] = in.pz[k];
    pieces.qx[pieces.count] = in.qx[k];
    pieces.qy[pieces.count] = in.qy[k];
    pieces.qz[pieces.count++] = in.qz[k];
    const std::size_t cut0 = static_cast<std::size_t>(static_cast<int>(in.cut0[k]));
    const std::size_t cut1 = static_cast<std::size_t>(static_cast<int>(in.cut1[k]));
    if (side == 0) {
      traces.put_end(left, cut0, piece);
      traces.put_start(right, cut0, piece, cut0 != kNoPlane);
      traces.put_start(left, cut1, piece + 1, cut1 != kNoPlane);
      traces.put_end(right, cut1, piece + 1);
    } else {
      traces.put_start(cut0, left, piece, cut0 != kNoPlane);
      traces.put_end(cut0, right, piece);
      traces.put_end(cut1, left, piece + 1);
      traces.put_start(cut1, right, piece + 1, cut1 != kNoPlane);
    }
  }
}

// False if ends do not pair up or are too many.
HWY_INLINE bool collect_traces(const SlabPart& a, const FeetOf& a_feet, const SlabPart& b,
                               const FeetOf& b_feet, TraceEnds& traces, Pieces& pieces) {
  if (pieces.count + traces.starts > kFastPieces) return false;
  for (std::size_t k = 0; k < traces.starts; ++k) {
    const std::size_t at = traces.start_at[k], f = at / TraceEnds::kRow, g = at % TraceEnds::kRow;
    if ((traces.ended[f] >> g & 1) == 0) return false;
    traces.ended[f] ^= 1u << g;
    const std::size_t from = traces.start[k], to = traces.end[at];
    const auto take = [&](const double* p, const double* q, std::size_t end) {
      return (end & 1) != 0 ? q[end >> 1] : p[end >> 1];
    };
    pieces.set_planes(a, a_feet, f, b, b_feet, g);
    const double px = take(pieces.px, pieces.qx, from), py = take(pieces.py, pieces.qy, from),
                 pz = take(pieces.pz, pieces.qz, from);
    const double qx = take(pieces.px, pieces.qx, to), qy = take(pieces.py, pieces.qy, to),
                 qz = take(pieces.pz, pieces.qz, to);
    pieces.px[pieces.count] = px;
    pieces.py[pieces.count] = py;
    pieces.pz[pieces.count] = pz;
    pieces.qx[pieces.count] = qx;
    pieces.qy[pieces.count] = qy;
    pieces.qz[pieces.count++] = qz;
  }
  return true;
}

template <class M>
HWY_INLINE Vec3V<VD> load_first(M mask, const double* x, const double* y, const double* z,
                                std::size_t k) {
  const D64 d;
  return {hn::MaskedLoad(mask, d, x + k), hn::MaskedLoad(mask, d, y + k),
          hn::MaskedLoad(mask, d, z + k)};
}
// p x q is exactly -(q x p), so that what runs to and fro along a thin overlap cancels; fused,
// normals are a hundred times worse.
HWY_INLINE Vec3V<VD> cross_unfused(const Vec3V<VD>& p, const Vec3V<VD>& q) {
  return {hn::Sub(hn::Mul(p.y, q.z), hn::Mul(p.z, q.y)),
          hn::Sub(hn::Mul(p.z, q.x), hn::Mul(p.x, q.z)),
          hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x))};
}
HWY_INLINE double sum_lanes(VD v) { return hn::GetLane(hn::SumOfLanes(D64(), v)); }
HWY_INLINE Vec3 sum_lanes(const Vec3V<VD>& v) {
  return {sum_lanes(v.x), sum_lanes(v.y), sum_lanes(v.z)};
}

// Volume, first moment, vector area, surface, and with kVolume the moment of A's part, all about
// the reference. Pieces are lanes.
HWY_NOINLINE void sum_pieces(const Pieces& pieces, const Vec3& reference, NormalModel model,
                             PairOverlap& out) {
  const D64 d;
  const VD zero = hn::Zero(d);
  const Vec3V<VD> origin = broadcast(reference);
  const VD of_a = hn::Set(d, static_cast<double>(pieces.of_a));
  const VD of_edges = hn::Set(d, static_cast<double>(pieces.of_edges));
  VD volume = zero, surface = zero;
  Vec3V<VD> first = {zero, zero, zero}, area = first, moment = first;
  for (std::size_t k = 0; k < pieces.count; k += hn::Lanes(d)) {
    const auto there = hn::FirstN(d, pieces.count - k);
    const Vec3V<VD> p = load_first(there, pieces.px, pieces.py, pieces.pz, k) - origin;
    const Vec3V<VD> q = load_first(there, pieces.qx, pieces.qy, pieces.qz, k) - origin;
    const Vec3V<VD> left = load_first(there, pieces.lx, pieces.ly, pieces.lz, k);
    const Vec3V<VD> right = load_first(there, pieces.rx, pieces.ry, pieces.rz, k);
    const VD left_c = hn::MaskedLoad(there, d, pieces.lc + k);
    const VD right_c = hn::MaskedLoad(there, d, pieces.rc + k);
    const Vec3V<VD> both = p + q;
    const Vec3V<VD> turn = cross_unfused(p, q);
    const VD in = dot(left, turn), on_right = dot(right, turn);
    const VD left_cone = hn::Mul(left_c, in), right_cone = hn::Mul(right_c, on_right);
    volume = hn::Add(volume, hn::Sub(left_cone, right_cone));
    surface = hn::Add(surface, hn::Sub(in, on_right));
    first = add_scaled(first, left_cone, add_scaled(both, left_c, left));
    first = add_scaled(first, hn::Neg(right_cone), add_scaled(both, right_c, right));
    const VD at = hn::Iota(d, static_cast<double>(k));
    const auto trace = hn::Ge(at, of_edges);
    area = area + keep_if(trace, turn);
    if (model == NormalModel::kVolume) {
      const auto edge_of_a = hn::Lt(at, of_a);
      const VD on_left = hn::IfThenElseZero(hn::Or(trace, edge_of_a), in);
      moment = add_scaled(moment, on_left, cross(both, left));
      moment =
          add_scaled(moment, hn::IfThenElseZero(edge_of_a, hn::Neg(on_right)), cross(both, right));
    }
  }
  const double sum = sum_lanes(volume);
  out.volume = sum / 6;
  out.surface = sum_lanes(surface) / 2;
  out.vector_area = 0.5 * sum_lanes(area);
  out.centroid = sum > 0 ? Vec3(sum_lanes(first) / (4 * sum)) : Vec3::Zero();
  out.moment = model == NormalModel::kVolume ? Vec3(sum_lanes(moment) / 6) : Vec3::Zero();
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
