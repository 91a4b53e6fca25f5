// `quern shape FILE.stl`: what a file gives as a shape, in words and as a frame to look at.
#pragma once

#include <string>

namespace quern {

struct ShapeCommand {
  std::string file;
  std::string out;    // folder of the frame
  bool hull = false;  // take the convex hull
};

int shape_command(const ShapeCommand& command);

}  // namespace quern
