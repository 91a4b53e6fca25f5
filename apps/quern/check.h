// The command `quern check`: validates a scene and says what it holds and what it will cost.
#pragma once

#include "apps/quern/run.h"

namespace quern {

int check_command(const RunOptions& options);

}  // namespace quern
