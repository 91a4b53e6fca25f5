// The table of `quern trade`: cost against error, on the terminal, as CSV, as JSON for the page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/quern/trade_cost.h"
#include "apps/quern/trade_errors.h"
#include "apps/quern/trade_runs.h"

namespace quern {

// A row and what its setting came to.
struct TradeResult {
  TradeRow row;
  std::string against;  // the setting it was measured against; empty: none was finished
  std::string precision;
  std::string status;  // "" of a finished one; else why it has no figures
  bool front = false;  // no other is both cheaper and nearer in power
  TradeCost cost;
  TradeFigures figures;
  std::vector<TradeError> errors;
};

struct TradeTable {
  std::string scene, title, command, machine, commit;
  int threads = 0;
  double lead = 0, revolutions = 0;
  std::vector<TradeResult> rows;
};

void mark_front(TradeTable& table);

std::string error_text(const TradeError& error);  // "+1.2 +- 0.4", "< 0.8", "-"
std::string terminal_text(const TradeTable& table);
std::string csv_text(const TradeTable& table);
std::string json_text(const TradeTable& table);

}  // namespace quern
