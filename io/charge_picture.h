// The charge drawn: the map of solid fraction over the mill's cross-section with the liner, the
// outline of the bulk and a ray for each angle, as an SVG that needs nothing else.
//
// One path a colour holds all cells of it, neighbours around the axis joined, and rings thinner
// than two pixels are drawn in groups: a map of 70,000 cells is a file of one to three megabytes.
#pragma once

#include <string>
#include <vector>

#include "soa/charge_shape.h"

namespace quern {

struct ChargePicture {
  std::string title;
  std::vector<std::string> notes;  // lines below the title
  PolarGrid grid;
  ChargeShape shape;
  double direction = 1;                  // 1: the mill turns counterclockwise, -1: clockwise
  std::vector<Eigen::Vector2d> profile;  // of the liner, m; a simple polygon

  struct Ray {
    std::string name;
    double angle = 0, error = 0;  // rad; the error NaN: unknown
    double radius = 0;            // m, of a point to mark on it; 0: none
  };
  std::vector<Ray> rays;
};

std::string charge_svg(const ChargePicture& picture);

}  // namespace quern
