// Recorder: everything a run leaves in its folder while and after it runs.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "apps/quern/block_recorder.h"
#include "apps/quern/charge_recorder.h"
#include "apps/quern/class_recorder.h"
#include "apps/quern/collision_recorder.h"
#include "apps/quern/window_figures.h"
#include "io/frames.h"
#include "io/series.h"
#include "io/summary.h"
#include "kernels/tally.h"
#include "scheduler/stage_times.h"
#include "soa/world.h"

namespace quern {

struct RunFigures {              // of the program, not of the charge
  double wall_seconds = 0;       // all of this process
  double step_seconds = 0;       // inside steps of the run phase
  std::uint64_t run_steps = 0;   // of the run phase, by this process
  StageTimes times;              // of the run phase
  double steps_per_contact = 0;  // of the pair that has the fewest
  int threads = 1;
  std::string simd_target;
  bool finished = false;
  std::string error;  // of a run that went wrong
};

class Recorder {
 public:
  // `resumed_at`: time of the checkpoint a resumed run continues from.
  Recorder(const std::string& folder, const Scene& scene, double dt, const std::vector<Wall>& walls,
           const Groups& groups, std::optional<double> resumed_at);

  // Before a step of the run phase: recording may begin.
  template <class Real>
  void before_step(World<Real>& world) const {
    world.wear.recording = world.clock.step >= first_step_;
    if (!world.collisions_asked.any() || world.clock.step + 1 < first_step_) return;
    if (!world.collisions.on()) world.begin_recording();
    if (!snapshots_) return;
    const std::uint64_t block = snapshots_->block(world.clock.step + 1, kLinerBlocks);
    world.collisions.liner_block = std::min<std::size_t>(block, kLinerBlocks - 1);
  }
  // After a step of the run phase: writes the series row, the frame and the snapshot of the charge
  // that are due.
  template <class Real>
  void after_step(World<Real>& world);

  void keep() const { series_.keep(); }  // with each checkpoint

  // The figures and tables of the run so far; also before a checkpoint, so that a kill leaves them.
  template <class Real>
  void write_summary(World<Real>& world, const RunFigures& figures);

  double last_power() const { return last_power_; }
  double recorded_power() const { return recorded_power_; }  // after write_summary()
  const std::optional<ChargeRecorder>& charge() const { return charge_; }
  const WindowLines& window_lines() const { return window_lines_; }  // after write_summary()
  const std::string& wear_line() const { return wear_line_; }        // likewise; empty: not asked

 private:
  template <class Real>
  void take_snapshots(const World<Real>& world);
  template <class Real>
  void write_tables(const World<Real>& world, const ParticleFrame& frame);

  std::string folder_;
  Scene scene_;
  double record_from_ = 0;
  std::vector<TallyRow> tallies_;
  std::optional<CollisionRecorder> collisions_;
  std::uint64_t first_step_ = 0;  // of the recorded window
  std::uint64_t series_steps_ = 1, frame_steps_ = 0;
  SeriesWriter series_;
  std::optional<FrameWriter> frames_;
  std::optional<SnapshotClock> snapshots_;  // of charge_ and classes_, if there is either
  std::optional<ChargeRecorder> charge_;
  std::optional<ClassRecorder> classes_;
  BlockRecorder blocks_;
  WindowLines window_lines_;
  double last_power_ = 0, recorded_power_ = 0;
  std::string wear_line_;
};

const char* precision_name(const Scene& scene);

// Start of the recorded window, s.
double record_start(const Scene& scene);

// Peak resident memory of this process in bytes.
std::uint64_t peak_memory();

}  // namespace quern
