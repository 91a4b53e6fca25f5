// The arrays and texts of a run's run.h5 as JSON for the report page, under their own names.
//
// What the page cannot use is left out: snapshots, the last state, bodies' shapes (the view of the
// charge carries those), forces on walls. Long series are thinned to every k-th row, which the
// array says itself (`every`).
#pragma once

#include <string>
#include <vector>

namespace quern {

struct RunTables {
  std::string arrays =
      "{}";  // {"series/power": {"unit", "doc", "rows", "columns", "every", "data"}, ...}
  std::string texts = "{}";       // {"power_by_kind/kind": "ore-ore\n...", ...}
  std::string provenance = "{}";  // {"version": "0.1.0", ...}
  std::string scene;              // the scene's text
  std::vector<std::string> notes;
};

// Of the file as of its last flush. A run may be writing it: what is caught in the middle of a
// change is read again a few times, then from the copy of the last checkpoint (run.previous.h5).
// SystemError if there is no run.h5, or it stays unreadable.
RunTables read_run_tables(const std::string& folder);

}  // namespace quern
