// ClassRecorder: what each size class does over the recorded window, in the whole mill and in the
// zones of its cross-section that the scene names.
//
// Each snapshot's sums go into run.h5 (snapshot_clock.h says why):
//   /class_snapshots/000001/time                                              s
//       /count, spin, kinetic_energy, rotational_energy     classes x (1 + zones), the whole first
// At the end /classes and /zones/NAME hold means over the snapshots with standard errors from ten
// blocks of consecutive ones.
#pragma once

#include <vector>

#include "apps/quern/snapshot_clock.h"
#include "io/series.h"
#include "kernels/class_sums.h"
#include "soa/output.h"
#include "soa/scene.h"
#include "soa/size_classes.h"

namespace quern {

class ClassRecorder {
 public:
  ClassRecorder(const Scene& scene, const SnapshotClock& clock);

  static bool asked(const Scene& scene) {
    return scene.record.classes || !scene.record.zones.empty();
  }

  void take(std::uint64_t step, const ParticleFrame& frame, const EnergyFrame& energy,
            SeriesWriter& series) const;

  // At the end or at a stop: the tables, if there was a snapshot.
  void finish(std::uint64_t step, SeriesWriter& series) const;

 private:
  struct Sums;  // all snapshots
  Sums read(std::uint64_t step, const SeriesWriter& series) const;
  void write_classes(const Sums& sums, SeriesWriter& series) const;
  void write_zone(const Sums& sums, std::size_t zone, SeriesWriter& series) const;

  Scene scene_;
  SnapshotClock clock_;
  SizeClasses classes_;
};

}  // namespace quern
