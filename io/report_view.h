// The moving picture of the report page: frames of the charge, small enough for a page.
//
// Reads OUT/frames as io/frames writes them. What is kept is chosen once for all frames: of very
// many particles the largest half of the places and an even sample of the rest, of very many frames
// an even choice with the first and the last. Packed arrays are planes (all x, then all y ...),
// little-endian:
//   statics  u32 id, f32 radius, u16 species, class, shape (0xffff: sphere); spheres first
//   frame    u8 high bytes of x, low bytes of x, the same of y and z (low + q / 65535 (high -
//   low));
//            u8 speed and spin, (q / 254)^2 of the largest, 255: the particle is not there;
//            of the polyhedra u8 high, low bytes of the quaternion w, x, y, z, (q - 32767) / 32767
//   walls    f32 corners of triangles, 9 each, wall by wall, at t = 0
//   wear     f32 corners of cells, 9 each, at t = 0, then f32 values, field by field
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "soa/scene.h"

namespace quern {

struct ViewBudget {
  std::size_t bytes = 20u << 20;  // of all frames, packed
  std::size_t most_particles = 120000;
  std::size_t wanted_frames = 60;  // particles are left out rather than go below these
  std::size_t most_frames = 240;
};

struct RunView {
  std::string json;                 // "null" where there are no frames
  std::vector<std::string> packed;  // what `json` refers to by number, from `first_blob` on
  std::vector<std::string> notes;
};

// `scene` tells how walls move and what they are called; `first_blob`: number of the first of
// `packed` on the page.
RunView read_run_view(const std::string& folder, const Scene& scene, const ViewBudget& budget,
                      std::size_t first_blob, bool closed = false);

// Which of `radii` (in order of identity) are shown when there is room for `places` < size: the
// largest, and of the rest those whose identity hashes lowest. Sorted rows.
std::vector<std::size_t> choose_particles(const std::vector<float>& radii,
                                          const std::vector<std::uint32_t>& ids,
                                          std::size_t places);

// `places` of `count` numbers from 0, evenly, the first and the last among them.
std::vector<std::size_t> choose_evenly(std::size_t count, std::size_t places);

}  // namespace quern
