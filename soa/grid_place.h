// GridPlace: where a sphere is, in a quarter of a record. What asks who touches in `single` reads
// this.
//
// A place is a number of steps of a grid with 2^32 points an axis; on a periodic axis they cover
// one period, elsewhere the domain and a bit. Numbers wrap around, and so do their differences:
// those of partners across a periodic face are those of the nearest images. It is a function of the
// record, kept beside it by the stepper and saved nowhere.
//
//   bytes   0  4  8  12      16
//           x  y  z  radius
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "soa/base.h"

namespace quern {

struct alignas(16) GridPlace {
  std::int32_t x, y, z;
  float radius;  // m
};
static_assert(sizeof(GridPlace) == 16);

struct PlaceGrid {
  // Added to a number below 2^51 it leaves the nearest integer in the lowest bits.
  static constexpr double kToInteger = 0x1.8p52;

  double spacing[3] = {1, 1, 1};  // m
  double inverse[3] = {1, 1, 1};  // 1/m

  PlaceGrid() = default;
  // Two that are in the domain and look near each other by their numbers are: those in its far
  // corners look four radii of the largest apart.
  PlaceGrid(const Vec3& low, const Vec3& high, const std::array<bool, 3>& periodic,
            double largest_radius) {
    for (std::size_t a = 0; a < 3; ++a) {
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      const double span = high[e] - low[e] + (periodic[a] ? 0 : 4 * largest_radius);
      inverse[a] = 0x1p32 / span;
      spacing[a] = 1 / inverse[a];
    }
  }
  double coarsest() const { return std::max({spacing[0], spacing[1], spacing[2]}); }

  // The bits that the motion kernel writes.
  GridPlace at(double x, double y, double z, float radius) const {
    const auto number = [this](double v, std::size_t axis) {
      const double moved = v * inverse[axis] + kToInteger;
      return static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(moved));
    };
    return {number(x, 0), number(y, 1), number(z, 2), radius};
  }
};

}  // namespace quern
