// The runs of `quern trade`: each setting is the folder of a run, made by the code of `quern run`.
//
// A run that is finished is not run again, one that was stopped goes on from its checkpoint; a
// folder counts if it holds the very scene that is wanted now. Every setting starts from a steady
// state that it shares with the default as far as its particles allow:
//
//   steady_spheres   the charge as spheres: filled, settled, turned
//   steady           from it, with the scene's polyhedra: turned again (scenes with polyhedra)
//   SETTING/steady_spheres, SETTING/steady    the same of settings that cannot share these
//
// States end at whole pitches of the lifters, or these would stand in the charge at t = 0.
#pragma once

#include <string>
#include <vector>

#include "apps/quern/run_folder.h"
#include "apps/quern/trade_dials.h"

namespace quern {

struct TradeOptions {
  std::string scene, out;
  int threads = 0;
  std::vector<std::string> overrides;
  double steady = 1, lead = 0.25, revolutions = 1;  // turns of a state; not recorded; recorded
  std::string spheres;               // folder of a run to take as steady_spheres; empty: made
  std::vector<std::string> only;     // dials or settings; empty: all
  double segment = 1;                // s of wall clock, of a timed stretch of the default
  bool list = false, table = false;  // run nothing: show the settings; the table of what is there
};

// Makes the setting's run, and the states it needs, unless they are there.
RunOutcome run_setting(const TradeOptions& options, const LoadedScene& base,
                       const TradeSetting& setting);

std::string folder_of_setting(const TradeOptions& options, const std::string& name);

}  // namespace quern
