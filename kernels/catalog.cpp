// Rows of the catalog that kernels/ answers for.
#include "soa/catalog.h"

namespace quern {

std::vector<CatalogEntry> contact_catalog() {
  return {
      {"law",
       "linear-spring-dashpot",
       "linear springs with tangential history, Coulomb friction, implicit damping (Xie et al. "
       "2021, "
       "Eqs 3-7)",
       {{"normal_stiffness", "N/m", "", "> 0", "k_n of the pair of materials"},
        {"tangential_stiffness", "N/m", "", "> 0", "k_t of the pair"},
        {"restitution", "1", "", "(0, 1]", "delivered normal coefficient of restitution"},
        {"sliding_friction", "1", "", ">= 0", "Coulomb coefficient mu"},
        {"rolling_friction", "1", "0", ">= 0", "mu_r, spheres only (Zhou et al. 1999)"},
        {"normal_force", "", "clamped", "clamped | unclamped", "whether the force may pull"},
        {"tangential_damping", "", "true", "true | false",
         "dashpot beside the tangential spring"}}},
      {"law",
       "hertz-mindlin",
       "springs of elastic spheres with Tsuji's damping, tangential history, Coulomb friction; "
       "polyhedra push as spheres of their volume (Tsuji et al. 1992)",
       {{"young_modulus", "Pa", "", "> 0", "E of the material"},
        {"poisson_ratio", "1", "", "[0, 0.5]", "nu of the material"},
        {"impact_speed", "m/s", "of walls, falls, first velocities", "> 0",
         "that steps are advised for"},
        {"restitution", "1", "", "(0, 1]", "the same at all speeds"},
        {"sliding_friction", "1", "", ">= 0", "Coulomb coefficient mu"},
        {"rolling_friction", "1", "0", ">= 0", "mu_r, spheres only (Zhou et al. 1999)"},
        {"normal_force", "", "clamped", "clamped | unclamped", "whether the force may pull"},
        {"tangential_damping", "", "true", "true | false",
         "dashpot beside the tangential spring"}}},
      {"pair type", "sphere-sphere", "spheres by overlap along the line of centres", {}},
      {"pair type", "sphere-facet", "spheres on triangles by local minima of the distance", {}},
      {"pair type",
       "polyhedron-sphere",
       "closest point of the polyhedron to the centre of the sphere",
       {}},
      {"pair type",
       "polyhedron-polyhedron",
       "overlap of convex bodies by their deepest point (Xie et al. 2021, Eqs 10-12, in 3D)",
       {{"overlap", "", "chord", "chord | width",
         "way out along the normal, or extent of the overlap"},
        {"normal_model", "", "stiffness", "stiffness | volume",
         "force = stiffness x overlap, or the gradient of the overlap volume"},
        {"volume_stiffness", "Pa", "stiffness / smaller radius", "> 0",
         "force = this x area; normal_model volume only"},
        {"patch_damping", "", "true", "true | false", "dashpots against rocking and drilling"}}},
      {"pair type",
       "polyhedron-facet",
       "polyhedron on triangles: one contact for each patch it presses into; parameters as above",
       {}},
      {"wall", "mill", "shell polygon with lifters and flat or periodic ends, from numbers", {}},
      {"wall", "mesh", "triangles of an STL file", {}},
      {"wall", "plane", "a plane through a point, one side", {}},
      {"wall", "box", "a box, closed or open at the top, facing inwards", {}},
  };
}

}  // namespace quern
