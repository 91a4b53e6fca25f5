// Random numbers as a function of (seed, stream, number): no state that threads or order could
// touch.
//
// The n-th value of a stream is mix(key + n * golden), where key hashes seed, stream and number (of
// the particle, usually). mix is the finalizer of SplitMix64 (Steele, Lea and Flood, "Fast
// splittable pseudorandom number generators", OOPSLA 2014, constants of Stafford's variant 13), so
// a generator walks SplitMix64's sequence from its own key. Only integer arithmetic and one exact
// conversion to double: the same bits on every machine, unlike the distributions of the standard
// library.
#pragma once

#include <cstdint>

namespace quern {

// One per purpose, so that a change in how many numbers one purpose takes leaves the others alone.
enum class RandomStream : std::uint64_t {
  kSize = 1,
  kPlace = 2,
  kRainOrder = 3,
  kRainPlace = 4,
  kOrientation = 5,
  kSweep = 6
};

inline constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;

// A bijection of 64 bits in which every input bit reaches every output bit.
constexpr std::uint64_t mix_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

class CounterRandom {
 public:
  // The plain SplitMix64 sequence from `key`.
  explicit constexpr CounterRandom(std::uint64_t key) : state_(key) {}

  constexpr CounterRandom(std::uint64_t seed, RandomStream stream, std::uint64_t number)
      : state_(mix_bits(mix_bits(mix_bits(seed + kGolden) + static_cast<std::uint64_t>(stream)) +
                        number)) {}

  constexpr std::uint64_t bits() { return mix_bits(state_ += kGolden); }

  // In [0, 1), a multiple of 2^-53.
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  // In [low, high]; `high` itself only by rounding.
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::uint64_t state_;
};

}  // namespace quern
