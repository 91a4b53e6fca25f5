// Facets: the surfaces of walls as welded triangles, with the topology that contact needs.
//
// One Facets object holds all meshes of a scene that share one rigid motion as one `body`; its
// coordinates are in the body frame (world frame at t = 0) and never change. Built once at set-up
// by build_facets(): weld, drop zero-area triangles, split long edges at T-junctions, classify
// edges, group coplanar connected triangles. A uniform grid over the triangles answers "which
// triangles lie within a distance of this point".
//
//   triangle t:  corner[3t..3t+2] -> vertex;  edge_of[3t+k] joins corners k and k+1;  group[t]
//   feature ids: coplanar group g -> g;  edge e -> groups + e;  vertex v -> groups + edges + v
//   a flat edge, and a vertex all of whose edges are flat, stand for the group they lie in
//
// The triangles, edges and vertices of a component are contiguous and shared with no other. What
// the narrow phase needs of a triangle is repeated in one record of two cache lines.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "soa/scene.h"

namespace quern {

struct Triangle {
  std::array<Vec3, 3> corner;  // counter-clockwise seen from the charge
};

enum class EdgeKind : std::uint8_t { kBoundary, kFlat, kConvex, kConcave, kNonManifold };

struct FacetReport {  // what welding and checking found, for `check` and for messages
  Index triangles_read = 0, zero_area = 0, split_edges = 0;
  Index duplicates = 0;       // triangles dropped because another has the same three vertices
  Index welded_vertices = 0;  // triangle corners that were moved onto a vertex nearby
  Index non_manifold_edges = 0, boundary_edges = 0;
  Index flipped_edges = 0;  // edges whose two triangles are oriented against each other
};

// One triangle for the narrow phase. Ids of edges and vertices that lie inside a coplanar group
// carry kInsideGroup.
inline constexpr Index kInsideGroup = 0x80000000u;
struct alignas(kAlignment) FacetRecord {
  std::array<Vec3, 3> corner;
  Vec3 normal;  // unit; bit-equal within a group that is plane to rounding
  std::array<Index, 3> vertex, edge;
  Index group = 0, wall = 0;
};
static_assert(sizeof(FacetRecord) == 128, "a facet record is two cache lines");

struct Facets {
  std::vector<Vec3> vertex;
  std::vector<Index> corner;        // 3 per triangle
  std::vector<Index> edge_of;       // 3 per triangle
  std::vector<Vec3> normal;         // unit, per triangle
  std::vector<Index> group;         // coplanar group, per triangle
  std::vector<Index> wall;          // wall (component) the triangle belongs to, per triangle
  std::vector<EdgeKind> edge_kind;  // per edge
  std::vector<std::uint16_t> edge_valence;    // triangles on the edge
  std::vector<std::uint16_t> vertex_valence;  // triangles around the vertex
  Index groups = 0;
  std::vector<FacetRecord> record;  // per triangle
  FacetReport report;

  // Grid over the triangles: cell c lists cell_triangle[cell_begin[c] .. cell_begin[c+1]).
  Vec3 grid_low = Vec3::Zero();
  double grid_cell = 0;
  std::array<int, 3> grid_count = {0, 0, 0};
  std::vector<Index> cell_begin, cell_triangle;

  Index triangles() const { return static_cast<Index>(corner.size() / 3); }
  Index edges() const { return static_cast<Index>(edge_kind.size()); }
  Index vertices() const { return static_cast<Index>(vertex.size()); }
};

// One component to be built: its triangles and the wall they are booked on.
struct FacetComponent {
  std::vector<Triangle> triangles;
  Index wall = 0;
};

// Components are welded each for itself (walls are independent of one another). `cell` is the
// wanted grid cell (m), usually the reach of a query; it is enlarged where memory would not allow
// it.
Facets build_facets(const std::vector<FacetComponent>& components, double cell);

// Sorts the triangles into the grid; build_facets() calls it.
void build_facet_grid(Facets& facets, double cell);

// Appends to `out` every triangle within `reach` of x (body frame), ascending and without repeats.
void find_facets(const Facets& facets, const Vec3& x, double reach, std::vector<Index>& out);

// Distance from x to the nearest facet, or `limit` if none is nearer.
double distance_to_facets(const Facets& facets, const Vec3& x, double limit);

// Closest point of triangle t to x.
Vec3 closest_point(const Facets& facets, Index t, const Vec3& x);

// Walls by their numbers, facing inwards; mill conventions: axis +z, lifter k centred at
// 2 pi k / count from +x. z from low to high (a periodic mill's shell reaches beyond its slice).
std::vector<Triangle> mill_shell(const MillSpec& mill, double z_low, double z_high);
std::vector<Triangle> mill_ends(const MillSpec& mill);
// A square patch of the plane, centred at the foot of `center`, half its side `half_width`.
std::vector<Triangle> plane_patch(const PlaneSpec& plane, const Vec3& center, double half_width);
std::vector<Triangle> box_faces(const BoxSpec& box, const Vec3& gravity);
// The shell's cross-section with its lifters: a simple polygon, counterclockwise, from the first
// base corner of lifter 0 on. Without lifters: pieces_per_arc corners all around, the first on +x.
std::vector<Eigen::Vector2d> mill_profile(const MillSpec& mill);
// Area enclosed by the profile (m^2), and whether (x, y) is inside it.
double mill_inner_area(const MillSpec& mill);
bool profile_contains(const std::vector<Eigen::Vector2d>& profile, double x, double y);

}  // namespace quern
