// What a run hands to the files: plain arrays in order of identity, independent of precision.
//
// scheduler/ fills these from the World, io/ writes them; neither includes the other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "soa/base.h"

namespace quern {

// One moment of the charge. Vectors are n x 3, row-major.
struct ParticleFrame {
  double time = 0;                   // s after the mill starts; negative while settling
  std::vector<double> position;      // m
  std::vector<float> radius;         // m
  std::vector<float> velocity;       // m/s
  std::vector<float> spin;           // rad/s
  std::vector<std::uint32_t> id;     // 0 ... n-1
  std::vector<std::uint16_t> species;   // row of the scene's [[particles]]
  std::vector<std::uint16_t> contacts;  // touching partners, walls included
};

// The walls at the same moment, in the world frame.
struct WallFrame {
  std::vector<float> vertex;            // m x 3
  std::vector<std::uint32_t> triangle;  // k x 3
  std::vector<std::uint16_t> wall;      // k: row of World's walls
  std::vector<float> speed;             // k: of the triangle's centre, m/s
};

// One body alone, its triangles coloured by the face they belong to.
struct SurfaceFrame {
  std::vector<double> vertex;           // m x 3
  std::vector<std::uint32_t> triangle;  // k x 3
  std::vector<std::uint16_t> face;      // k
};

struct Quantity {
  std::string name;  // the field's word, lower_snake
  std::string unit;  // "W", "N m", "1"
  std::string doc;   // one line
};

}  // namespace quern
