// The program and the style of the report page, as io/report/dist has them, inside our binary.
#pragma once

#include <string_view>

namespace quern {

std::string_view report_program();
std::string_view report_style();

}  // namespace quern
