// What a run's folder holds: of which scene, and whether the run is over. Used by commands that
// make many runs and go on where they were stopped (trade, sweep).
#pragma once

#include <string>

#include "soa/scene.h"

namespace quern {

enum class RunState { kFinished, kFailed, kStopped };

struct RunOutcome {
  RunState state = RunState::kFinished;
  std::string reason;  // of a failure
};

// Of the run in a folder: kStopped if it is not over, or there is none.
RunOutcome outcome_of(const std::string& folder);

// The scene's text without the places of files, which change when folders are moved.
std::string without_places(const std::string& text);

// Whether the folder is of this very scene, as load_scene() gives it.
bool holds_scene(const std::string& folder, const Scene& scene);

}  // namespace quern
