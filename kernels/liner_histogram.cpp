#include "kernels/liner_histogram.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace quern {

namespace {

// The turn in four quarters that are straight in y / (|x| + |y|), and those in slots, each with the
// bin that it begins in. A slot is half as wide as a bin at most: the bin of a point is that or the
// next one.
constexpr std::size_t kQuarter = 256;  // slots

struct Edges {
  std::array<double, kLinerBins> x{}, y{};  // of the bins' ends, unit
  std::array<std::uint16_t, 4 * kQuarter> first{};
  Edges() {
    const double bin = 2 * kPi / kLinerBins;
    for (std::size_t k = 0; k < kLinerBins; ++k) {
      x[k] = std::cos(bin * static_cast<double>(k + 1));
      y[k] = std::sin(bin * static_cast<double>(k + 1));
    }
    for (std::size_t slot = 0; slot < first.size(); ++slot) {
      const double part = static_cast<double>(slot % kQuarter) / kQuarter;
      const double angle = std::atan2(part, 1 - part) + 0.5 * kPi * double(slot / kQuarter);
      first[slot] = static_cast<std::uint16_t>(std::max(0.0, angle / bin - 1e-6));
    }
  }
};
const Edges kEdges;

}  // namespace

std::size_t liner_bin(double x, double y) noexcept {
  const double sum = std::abs(x) + std::abs(y);
  if (!(sum > 0)) return 0;
  const double part = y / sum;
  const double quarters = x < 0 ? 2 - part : y < 0 ? 4 + part : part;
  const auto slot = static_cast<std::size_t>(quarters * kQuarter);
  const std::size_t bin = kEdges.first[std::min(slot, 4 * kQuarter - 1)];
  const bool is_past = kEdges.x[bin] * y - kEdges.y[bin] * x >= 0;
  return bin + (is_past && bin + 1 < kLinerBins ? 1 : 0);
}

}  // namespace quern
