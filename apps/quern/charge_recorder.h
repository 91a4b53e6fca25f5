// ChargeRecorder: the map of the charge over the recorded window, its angles with their errors, and
// the picture OUT/charge_shape.svg.
//
// Each snapshot goes into run.h5 as it is taken (charge_snapshots/000001 ...), and the map is
// summed from there at the end. So nothing of it is state of the run: a resumed run writes the
// snapshots after its checkpoint anew, to the same bits, and finds those before it in the file.
// Errors come from ten blocks of consecutive snapshots, each with a map of its own; the spread is
// the standard deviation of the angles that single snapshots show.
#pragma once

#include <string>

#include "io/charge_picture.h"
#include "io/series.h"
#include "io/statistics.h"
#include "io/summary.h"
#include "soa/output.h"
#include "soa/scene.h"

namespace quern {

class ChargeRecorder {
 public:
  // The scene has a mill; steps count from the start of the run phase.
  ChargeRecorder(const Scene& scene, double dt, std::uint64_t first_step, std::uint64_t last_step);

  bool due(std::uint64_t step) const {
    return step > first_step_ && (step - first_step_) % every_ == 0;
  }
  void take(std::uint64_t step, const ParticleFrame& frame, SeriesWriter& series) const;

  // At the end or at a stop: rows of the summary, tables of run.h5, the picture.
  void finish(std::uint64_t step, const ParticleFrame& frame, SeriesWriter& series,
              Summary& summary);
  void write_picture(const std::string& path) const;  // if there was a snapshot

  std::string line() const;  // for the log, after finish()

 private:
  struct Angle {
    double value, error, spread;  // rad; NaN: unknown
  };
  struct Found {  // in maps of a part of the window; rad, NaN where not found
    std::vector<double> shoulder, toe;
    void add(const ChargeShape& shape);
  };
  ChargeQuery query(double particle_size, double time) const;
  ChargeMap empty_map(const ParticleFrame& frame) const;
  std::vector<ChargeMap> read_blocks(std::uint64_t step, const ChargeMap& empty,
                                     const ChargeQuery& query, const SeriesWriter& series);
  void find_angles(const ChargeMap& all, const std::vector<ChargeMap>& blocks,
                   const ChargeQuery& query);
  void describe(const PolarGrid& grid, double time, double direction);
  void report(const ChargeMap& all, const ChargeQuery& asked, Summary& summary) const;
  void write_tables(SeriesWriter& series) const;

  Scene scene_;
  double dt_;
  std::uint64_t first_step_, every_;
  ChargePicture picture_;
  Angle shoulder_{}, toe_{};
  Found in_blocks_, in_snapshots_;
  double snapshots_ = 0;
};

}  // namespace quern
