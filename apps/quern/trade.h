// The command `quern trade`: speed against accuracy, one dial of a scene at a time.
#pragma once

#include "apps/quern/trade_runs.h"

namespace quern {

// Exit codes: 0 done, or stopped by a signal (the same command goes on); settings that go wrong are
// told in the table.
int trade_command(const TradeOptions& options);

}  // namespace quern
