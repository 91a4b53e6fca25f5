// The arrays and texts of a run's run.h5 as JSON for the report page, under their own names.
//
// What the page cannot use is left out: snapshots, the last state, bodies' shapes (the view of the
// charge carries those), forces on walls. Long series are thinned to every k-th row, which the
// array says itself (`every`).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/hdf5_file.h"

namespace quern {

struct RunTables {
  std::string arrays =
      "{}";  // {"series/power": {"unit", "doc", "rows", "columns", "every", "data"}, ...}
  std::string texts = "{}";       // {"power_by_kind/kind": "ore-ore\n...", ...}
  std::string provenance = "{}";  // {"version": "0.1.0", ...}
  std::string scene;              // the scene's text
  std::vector<std::string> notes;
};

using ReadResults = std::function<void(const Hdf5File& results)>;

// Reads a run's run.h5 as of its last flush. A run may be writing it, and a kill may have torn it:
// what cannot be read is tried again a few times, then `read` gets the copy of the last checkpoint
// (run.previous.h5). Empty, or what to say of that. SystemError if neither can be read.
// `read` may be called several times; what a call before has set must not show. `closed`: by who
// wrote it, so that it is not torn.
std::string read_results(const std::string& folder, const ReadResults& read, bool closed);

// SystemError if there is no run.h5, or it stays unreadable.
RunTables read_run_tables(const std::string& folder, bool closed = false);

}  // namespace quern
