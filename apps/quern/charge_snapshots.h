// Snapshots of the charge on its polar map: from particles to run.h5 and back.
//
//   /charge_snapshots/000001/volume            m^3, rings x angles
//                           /volume_velocity_x, volume_velocity_y, volume_speed    m^4/s
//                           /volume_of_GROUP   m^3, where there are two groups of particles or more
//                           /time              s
// f32: seven digits of a sum over particles, of which a hundred are averaged.
#pragma once

#include <string>
#include <vector>

#include "io/series.h"
#include "soa/charge_shape.h"
#include "soa/output.h"
#include "soa/scene.h"

namespace quern {

class ChargeSnapshots {
 public:
  explicit ChargeSnapshots(const Scene& scene);  // has a mill

  ChargeMap empty_map(const ParticleFrame& frame) const;
  void write(std::uint64_t number, const ParticleFrame& frame, SeriesWriter& series) const;
  // Into a map like empty_map(), which is overwritten; false if the snapshot is not there.
  bool read(std::uint64_t number, const SeriesWriter& series, ChargeMap& map, double& time) const;

  // The means that a sum of snapshots holds, as /charge_map has them; `columns` refer to `data`.
  struct Means {
    std::vector<Quantity> quantities;
    std::vector<std::vector<double>> data;
  };
  Means means(const ChargeMap& map) const;

 private:
  std::size_t amounts() const { return columns_.size(); }
  std::vector<float> amounts_of(const ParticleFrame& frame) const;

  Scene scene_;
  std::vector<std::string> groups_;     // of particles
  std::vector<std::uint8_t> group_of_;  // of each species
  std::vector<Quantity> columns_;       // of each amount, in a snapshot
};

}  // namespace quern
