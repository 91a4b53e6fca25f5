// Walls of the report's moving picture: their surface once, their pose in each frame, their wear.
//
// The surface comes from a frame of the liner, turned back to t = 0 by the motion that the scene
// gives each wall; the wear cells of run.h5 lie there already. Layout of the packed arrays:
// io/report_view.h.
#pragma once

#include <string>
#include <vector>

#include "soa/scene.h"

namespace quern {

struct WallQuery {
  std::string folder, frames;  // of the run, of its frames
  std::vector<double> times;   // s, of the frames shown
  std::size_t first_blob = 0;  // number of the first packed array
  bool closed = false;         // run.h5, by who wrote it
};

struct WallsOfView {
  std::string json = "[]";
  std::vector<std::string> packed, notes;
};

WallsOfView read_walls(const WallQuery& query, const Scene& scene);

struct NamedMotion {
  std::string name;
  Motion motion;
};

// Walls in the order in which frames number them.
std::vector<NamedMotion> walls_of(const Scene& scene);

}  // namespace quern
