// What a sweep is to run: its cases, and the fillings that they start from.
//
//   OUT/CASE/               a run like any other, with log.txt
//   OUT/fillings/HASH/      a charge that came to rest; its settled/ is what cases start from
//   OUT/fillings/HASH.toml  its scene
//
// Two cases share a filling if their scenes are the same once all is set to fixed values that
// matters only after the mill has begun to turn: rotation, durations, output, records, wear. Every
// case of a scene that settles starts from a filling, shared or not, so that its results do not
// depend on which other cases there are.
#pragma once

#include <string>
#include <vector>

#include "apps/quern/load.h"
#include "apps/quern/run_folder.h"
#include "io/sweep_reader.h"

namespace quern {

struct SweepFilling {
  std::string folder;
  Scene scene;
};

struct SweepRun {
  SweepCase place;  // in the design
  std::string folder;
  Scene scene;                                  // as its folder is to have it
  std::vector<std::string> set;                 // all of it, the start too
  int filling = -1;                             // row of SweepPlan::fillings; -1: none
  double steps = 0, particles = 0, memory = 0;  // of the run; B
};

struct SweepPlan {
  SweepSpec spec;
  std::string out;
  std::vector<SweepFilling> fillings;
  std::vector<SweepRun> cases;
};

// Reads the sweep and every case's scene. Throws InputErrors with all mistakes.
SweepPlan plan_sweep(const std::string& file, const std::string& out);

RunOutcome outcome_of(const SweepFilling& filling);
RunOutcome outcome_of(const SweepRun& run);

// Why a run ended badly twice that could not say so in its summary.json; gone once it runs again.
std::string failed_file(const std::string& folder);

// The command line that makes it, or goes on with it; the folder is locked.
std::vector<std::string> command_of(const SweepFilling& filling, int threads);
std::vector<std::string> command_of(const SweepPlan& plan, const SweepRun& run, int threads);

}  // namespace quern
