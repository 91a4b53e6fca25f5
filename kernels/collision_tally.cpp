#include "kernels/collision_tally.h"

#include <bit>
#include <cmath>

namespace quern {

namespace {

// Lower edges of the bins, and where to begin to look for an energy by its binary exponent: a
// factor of two spans 3.01 bins.
struct Bins {
  std::array<double, kEnergyBins> from{};
  static constexpr int kLowest = -42, kHighest = 10;  // exponents of 1e-12 less one, of 1e3 and one
  std::array<std::uint16_t, kHighest - kLowest + 1> first{};
  Bins() {
    for (std::size_t bin = 1; bin < kEnergyBins; ++bin) {
      const int tenth = static_cast<int>(bin) - 1;
      // Whole decades exactly as they are written.
      const double decade = std::pow(10.0, kFirstDecade + tenth / kBinsPerDecade);
      from[bin] = decade * std::pow(10.0, tenth % kBinsPerDecade / double{kBinsPerDecade});
    }
    for (int e = kLowest; e <= kHighest; ++e) {
      std::size_t bin = 0;
      while (bin + 1 < kEnergyBins && from[bin + 1] <= std::ldexp(1.0, e)) ++bin;
      first[static_cast<std::size_t>(e - kLowest)] = static_cast<std::uint16_t>(bin);
    }
  }
};
const Bins kBins;

void count(EnergySpectrum& spectrum, std::size_t bin, double energy) {
  spectrum.count[bin] += 1;
  spectrum.energy[bin] += energy;
}

}  // namespace

std::size_t energy_bin(double energy) noexcept {
  if (!std::isgreaterequal(energy, kBins.from[1])) return 0;
  if (energy >= kBins.from[kEnergyBins - 1]) return kEnergyBins - 1;
  const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(energy) >> 52) - 1023;
  std::size_t bin = kBins.first[static_cast<std::size_t>(exponent - Bins::kLowest)];
  while (energy >= kBins.from[bin + 1]) ++bin;
  return bin;
}

double energy_bin_from(std::size_t bin) noexcept { return kBins.from[bin]; }

void CollisionTally::begin_episode(std::size_t kind, double impact) {
  begun_.push_back({static_cast<std::uint32_t>(kind),
                    static_cast<std::uint16_t>(energy_bin(impact)), 0, impact, 0});
}

void CollisionTally::end_episode(std::size_t kind, double dissipated, double approach) {
  ended_.push_back({static_cast<std::uint32_t>(kind),
                    static_cast<std::uint16_t>(energy_bin(dissipated)),
                    static_cast<std::uint16_t>(energy_bin(approach)), dissipated, approach});
}

void CollisionTally::add_to(Collisions& all) const {
  const bool opening = all.recording == Recording::kOpening;
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
    if (opening) {
      all.start_elastic[kind] += kinds_[kind].elastic;
      all.kinds[kind].elastic += kinds_[kind].elastic;
    } else {
      all.kinds[kind].add(kinds_[kind]);
    }
  }
  for (const Binned& e : ended_) {
    count(all.spectra[e.kind].dissipated, e.bin, e.energy);
    count(all.spectra[e.kind].approach, e.approach_bin, e.approach);
  }
  for (const Binned& e : begun_) count(all.spectra[e.kind].impact, e.bin, e.energy);
  if (all.liner.empty()) return;
  LinerHistogram& liner = all.liner[all.liner_block];
  for (const OnLiner& t : liner_) {
    add_to_liner(t.bin, liner_time_, t.normal_dissipation, t.touch, liner);
  }
}

}  // namespace quern
