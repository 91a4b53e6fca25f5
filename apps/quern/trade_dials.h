// The dials of `quern trade`: which settings of a scene stand against which.
//
// A setting is a list of "key=value" as `quern run --set` takes them. A row of the table is a
// setting seen as a value of one dial, with the setting it is measured against: the finest of the
// numerics (double precision, 50 steps per contact) for dials of the numerics, the dial's own
// finest value for what changes the charge. To add a dial: a function that appends its rows, and
// its line in trade_rows().
#pragma once

#include <string>
#include <vector>

#include "apps/quern/load.h"

namespace quern {

// What a setting can share with the default's steady state.
enum class SteadyState {
  kShared,     // all of it
  kOwnShapes,  // the charge of spheres; its polyhedra are put in and turned anew
  kOwnCharge,  // nothing: its particles, mill or precision are others
};

struct TradeSetting {
  std::string name;  // of its folder
  std::vector<std::string> set;
  SteadyState state = SteadyState::kShared;
};

struct TradeRow {
  std::string dial, value;
  TradeSetting setting;
  std::string against;  // name of a setting
};

inline constexpr const char* kDefaultSetting = "default";
inline constexpr const char* kFinestSetting = "finest";
inline constexpr const char* kStepsDial = "steps per contact";

// All rows of a scene, the default first. Dials that the scene has no use for are left out.
std::vector<TradeRow> trade_rows(const LoadedScene& loaded);

// Settings that make the charge one of spheres: the state from which polyhedra are put in.
std::vector<std::string> as_spheres(const Scene& scene);

}  // namespace quern
