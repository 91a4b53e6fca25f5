// The figures by which settings are compared, read from the folder of a finished run.
#pragma once

#include <string>

#include "apps/quern/load.h"
#include "apps/quern/trade_errors.h"

namespace quern {

// `length`: of the mill of the default; what grows with the length is told for it.
TradeFigures read_figures(const std::string& folder, const LoadedScene& loaded, double length);

}  // namespace quern
