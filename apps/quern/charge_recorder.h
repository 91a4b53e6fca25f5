// ChargeRecorder: the maps of the charge over the recorded window, its angles with their errors,
// and the picture OUT/charge_shape.svg.
//
// Maps are summed from the snapshots in run.h5 (snapshot_clock.h says why). Errors come from ten
// blocks of consecutive snapshots, each with a map of its own; the spread is the standard deviation
// of the angles that single snapshots show. Head and impact toe need what the liner felt in every
// step: whoever has it hands over ten histograms, one for each tenth of the window.
#pragma once

#include <string>

#include "apps/quern/charge_snapshots.h"
#include "apps/quern/snapshot_clock.h"
#include "io/charge_picture.h"
#include "io/summary.h"

namespace quern {

class ChargeRecorder {
 public:
  static constexpr std::size_t kBlocks = 10;

  // The scene has a mill.
  ChargeRecorder(const Scene& scene, const SnapshotClock& clock);

  void take(std::uint64_t step, const ParticleFrame& frame, SeriesWriter& series) const {
    snapshots_.write(clock_.number(step), frame, series);
  }

  // Before finish(): kBlocks histograms of equal bins (liner_histogram.h), of the blocks of time
  // that SnapshotClock::block(step, kBlocks) tells apart; those still to come are zero. Without
  // them no head and no impact toe are reported.
  void set_liner(std::vector<LinerHistogram> blocks) { liner_ = std::move(blocks); }

  // At the end or at a stop: rows of the summary, tables of run.h5,
  // the picture.
  void finish(std::uint64_t step, const ParticleFrame& frame, SeriesWriter& series,
              Summary& summary);
  void write_picture(const std::string& path) const;  // if there was a snapshot

  std::string line() const;  // for the log, after finish()

 private:
  struct Seen {  // in each snapshot; rad, NaN where not found
    std::vector<double> time, shoulder, toe;
  };
  std::vector<ChargeMap> read_blocks(std::uint64_t step, const ChargeMap& empty,
                                     const ChargeQuery& query, const SeriesWriter& series);
  void describe(const PolarGrid& grid, double time, double direction);
  void report(Summary& summary) const;
  void write_tables(const ChargeMap& all, SeriesWriter& series) const;
  void write_angles(SeriesWriter& series) const;

  Scene scene_;
  SnapshotClock clock_;
  ChargeSnapshots snapshots_;
  std::vector<LinerHistogram> liner_;
  ChargePicture picture_;
  ChargeAngles angles_;
  Seen seen_;
  double count_ = 0;
};

}  // namespace quern
