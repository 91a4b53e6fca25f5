// What of a polyhedron lies in the slab that a pair shares: planes, vertices and edges as lanes.
//
// Included once per Highway target. A face with a vertex in the slab is kept, and so is an edge
// with an end in it (whose faces are both kept then). Shapes of any size give short lists: sets are
// bits, a few words, and only what is in them is copied. B's part is copied in its own frame and
// placed in lanes; a vertex comes out the same in every edge that ends in it.
#if defined(QUERN_KERNELS_PAIRS_POLYHEDRON_SLAB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_KERNELS_PAIRS_POLYHEDRON_SLAB_INL_H_
#undef QUERN_KERNELS_PAIRS_POLYHEDRON_SLAB_INL_H_
#else
#define QUERN_KERNELS_PAIRS_POLYHEDRON_SLAB_INL_H_
#endif

#include <cmath>
#include <initializer_list>

#include "kernels/pairs/polyhedron_axis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

constexpr std::size_t kFastVertices = 512;  // of a shape
constexpr std::size_t kFastFaces = 512;
constexpr std::size_t kFastEdges = 1024;
constexpr std::size_t kKeptPlanes = 31;  // of a body in the slab; the 32nd means none
constexpr std::size_t kKeptPoints = 48;
constexpr std::size_t kKeptEdges = 63;  // bits of a word

// Lists are filled up to a full vector: planes with n = 0 and a far d, points with the first one,
// edges with zeros.
struct SlabPart {
  HWY_ALIGN double nx[kKeptPlanes + 9], ny[kKeptPlanes + 9], nz[kKeptPlanes + 9];
  HWY_ALIGN double d[kKeptPlanes + 9];
  HWY_ALIGN double x[kKeptPoints + 8], y[kKeptPoints + 8], z[kKeptPoints + 8];
  HWY_ALIGN double ax[kKeptEdges + 9], ay[kKeptEdges + 9], az[kKeptEdges + 9];
  HWY_ALIGN double bx[kKeptEdges + 9], by[kKeptEdges + 9], bz[kKeptEdges + 9];
  std::uint8_t left[kKeptEdges + 1], right[kKeptEdges + 1];  // of an edge: its planes here
  std::size_t planes, points, edges;
};

// u . v of all vertices; returns the highest.
HWY_INLINE double heights_along(const Shape& shape, const Vec3& u, double* heights) {
  const D64 d;
  const Vec3V<VD> axis = broadcast(u);
  const std::size_t count = shape.padded_vertices();
  VD best = dot(axis, load3(shape.x.data(), shape.y.data(), shape.z.data(), 0));
  hn::StoreU(best, d, heights);
  for (std::size_t k = hn::Lanes(d); k < count; k += hn::Lanes(d)) {
    const VD height = dot(axis, load3(shape.x.data(), shape.y.data(), shape.z.data(), k));
    hn::StoreU(height, d, heights + k);
    best = hn::Max(best, height);
  }
  return hn::GetLane(hn::MaxOfLanes(d, best));
}

struct SlabSets {
  std::uint64_t faces[kFastFaces / 64], edges[kFastEdges / 64];
};

// The vector of each column in which entry `count` lies, before the entries below are written.
HWY_INLINE void fill_last(double value, std::size_t count, std::initializer_list<double*> columns) {
  const D64 d;
  const std::size_t last = count / hn::Lanes(d) * hn::Lanes(d);
  for (double* column : columns) hn::Store(hn::Set(d, value), d, column + last);
}
HWY_INLINE std::size_t members(const std::uint64_t* set, std::size_t words) {
  std::size_t count = 0;
  for (std::size_t w = 0; w < words; ++w) {
    count += static_cast<std::size_t>(__builtin_popcountll(set[w]));
  }
  return count;
}

HWY_INLINE void keep_point(const Shape& shape, std::size_t v, SlabPart& out) {
  out.x[out.points] = shape.x[v];
  out.y[out.points] = shape.y[v];
  out.z[out.points++] = shape.z[v];
}

// Vertices at least `least` high, and the faces and edges around them. False if they are too many,
// or if rounding leaves none.
template <bool kOneWord>
HWY_INLINE bool gather_points(const Shape& shape, const double* heights, double least,
                              SlabSets& sets, SlabPart& out) {
  const D64 d;
  const std::size_t face_words = kOneWord ? 1 : shape.face_words;
  const std::size_t edge_words = kOneWord ? 1 : shape.edge_words;
  const std::uint64_t *vertex_faces = shape.vertex_faces.data(),
                      *vertex_edges = shape.vertex_edges.data();
  std::uint64_t all_faces = 0, all_edges = 0;
  if (!kOneWord) sets = SlabSets{};
  const VD limit = hn::Set(d, least);
  out.points = 0;
  for (std::size_t k = 0; k < shape.vertices; k += hn::Lanes(d)) {
    std::uint64_t bits = bits_of(d, hn::Ge(hn::LoadU(d, heights + k), limit));
    if (k + hn::Lanes(d) > shape.vertices) bits &= (1ull << (shape.vertices - k)) - 1;
    for (; bits != 0; bits &= bits - 1) {
      if (out.points == kKeptPoints) return false;
      const std::size_t v = k + static_cast<std::size_t>(__builtin_ctzll(bits));
      keep_point(shape, v, out);
      if (kOneWord) {
        all_faces |= vertex_faces[v];
        all_edges |= vertex_edges[v];
        continue;
      }
      for (std::size_t w = 0; w < face_words; ++w)
        sets.faces[w] |= vertex_faces[v * face_words + w];
      for (std::size_t w = 0; w < edge_words; ++w)
        sets.edges[w] |= vertex_edges[v * edge_words + w];
    }
  }
  if (kOneWord) {
    sets.faces[0] = all_faces;
    sets.edges[0] = all_edges;
  }
  if (out.points == 0) return false;
  hn::StoreU(hn::Set(d, out.x[0]), d, out.x + out.points);
  hn::StoreU(hn::Set(d, out.y[0]), d, out.y + out.points);
  hn::StoreU(hn::Set(d, out.z[0]), d, out.z + out.points);
  return true;
}

HWY_INLINE bool gather_planes(const Shape& shape, const SlabSets& sets, std::uint8_t* slot,
                              SlabPart& out) {
  out.planes = members(sets.faces, shape.face_words);
  if (out.planes > kKeptPlanes) return false;
  fill_last(0, out.planes, {out.nx, out.ny, out.nz});
  fill_last(kFarPlane, out.planes, {out.d});
  std::size_t count = 0;
  for (std::size_t w = 0; w < shape.face_words; ++w) {
    for (std::uint64_t bits = sets.faces[w]; bits != 0; bits &= bits - 1) {
      const std::size_t f = 64 * w + static_cast<std::size_t>(__builtin_ctzll(bits));
      slot[f] = static_cast<std::uint8_t>(count);
      out.nx[count] = shape.nx[f];
      out.ny[count] = shape.ny[f];
      out.nz[count] = shape.nz[f];
      out.d[count++] = shape.d[f];
    }
  }
  return true;
}

HWY_INLINE bool gather_edges(const Shape& shape, const SlabSets& sets, const std::uint8_t* slot,
                             SlabPart& out) {
  const double *x = shape.x.data(), *y = shape.y.data(), *z = shape.z.data();
  out.edges = members(sets.edges, shape.edge_words);
  if (out.edges > kKeptEdges) return false;
  fill_last(0, out.edges, {out.ax, out.ay, out.az, out.bx, out.by, out.bz});
  std::size_t count = 0;
  for (std::size_t w = 0; w < shape.edge_words; ++w) {
    for (std::uint64_t bits = sets.edges[w]; bits != 0; bits &= bits - 1) {
      const std::size_t e = 64 * w + static_cast<std::size_t>(__builtin_ctzll(bits));
      const std::size_t p = shape.edge_vertex[2 * e], q = shape.edge_vertex[2 * e + 1];
      out.ax[count] = x[p];
      out.ay[count] = y[p];
      out.az[count] = z[p];
      out.bx[count] = x[q];
      out.by[count] = y[q];
      out.bz[count] = z[q];
      out.left[count] = slot[shape.edge_face[2 * e]];
      out.right[count++] = slot[shape.edge_face[2 * e + 1]];
    }
  }
  return true;
}

// False if the slab holds too much of the shape.
HWY_NOINLINE bool gather_part(const Shape& shape, const double* heights, double least,
                              SlabPart& out) {
  SlabSets sets;
  std::uint8_t slot[kFastFaces];  // of a face that was kept
  const bool one_word = shape.face_words == 1 && shape.edge_words == 1;
  return (one_word ? gather_points<true>(shape, heights, least, sets, out)
                   : gather_points<false>(shape, heights, least, sets, out)) &&
         gather_planes(shape, sets, slot, out) && gather_edges(shape, sets, slot, out);
}

HWY_INLINE void place_points(const Vec3V<VD>& place, const Vec3V<VD>& cx, const Vec3V<VD>& cy,
                             const Vec3V<VD>& cz, std::size_t count, double* x, double* y,
                             double* z) {
  const D64 d;
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const Vec3V<VD> v = load3(x, y, z, k);
    const Vec3V<VD> w = add_scaled(add_scaled(add_scaled(place, v.z, cz), v.y, cy), v.x, cx);
    hn::StoreU(w.x, d, x + k);
    hn::StoreU(w.y, d, y + k);
    hn::StoreU(w.z, d, z + k);
  }
}

// From B's frame to that of the pair. Planes bit by bit as the plain way has them: a rounding of
// theirs moves the corners of a small overlap by much more than any other.
HWY_NOINLINE void place_part(const PairFrame& frame, SlabPart& part) {
  for (std::size_t k = 0; k < part.planes; ++k) {
    const Vec3 normal = frame.turn * Vec3(part.nx[k], part.ny[k], part.nz[k]);
    part.nx[k] = normal.x();
    part.ny[k] = normal.y();
    part.nz[k] = normal.z();
    part.d[k] = frame.ratio * part.d[k] + normal.dot(frame.place);
  }
  const Vec3V<VD> place = broadcast(frame.place);
  const Mat3 turn = frame.ratio * frame.turn;
  const Vec3V<VD> cx = broadcast(turn.col(0)), cy = broadcast(turn.col(1)),
                  cz = broadcast(turn.col(2));
  place_points(place, cx, cy, cz, part.points, part.x, part.y, part.z);
  place_points(place, cx, cy, cz, part.edges, part.ax, part.ay, part.az);
  place_points(place, cx, cy, cz, part.edges, part.bx, part.by, part.bz);
}

// Two faces in one plane, normals alike: which of them bounds the overlap is the polygons' affair.
HWY_NOINLINE bool any_coincident(const PairFrame& frame, const SlabPart& a, const SlabPart& b) {
  const D64 d;
  const VD near = hn::Set(d, kCoincident * frame.reach);
  const VD alike = hn::Set(d, kCoincidentNormals * kCoincidentNormals);
  for (std::size_t g = 0; g < b.planes; ++g) {
    for (std::size_t f = 0; f < a.planes; f += hn::Lanes(d)) {
      const VD apart = hn::Abs(hn::Sub(hn::LoadU(d, a.d + f), hn::Set(d, b.d[g])));
      const auto close = hn::Le(apart, near);
      if (hn::AllFalse(d, close)) continue;
      const Vec3V<VD> turn =
          load3(a.nx, a.ny, a.nz, f) - broadcast(Vec3(b.nx[g], b.ny[g], b.nz[g]));
      if (!hn::AllFalse(d, hn::And(close, hn::Le(dot(turn, turn), alike)))) return true;
    }
  }
  return false;
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
