// The assembler takes the files in: at once and of any size, where a compiler would take seconds
// over an array. QUERN_REPORT_DIST is their folder; CMake builds this anew when they change.
#include "io/report_assets.h"

// clang-format off
__asm__(
    ".section .rodata\n"
    "quern_report_program_begin: .incbin \"" QUERN_REPORT_DIST "/report.js\"\n"
    "quern_report_program_end:\n"
    "quern_report_style_begin: .incbin \"" QUERN_REPORT_DIST "/report.css\"\n"
    "quern_report_style_end:\n"
    ".global quern_report_program_begin\n.global quern_report_program_end\n"
    ".global quern_report_style_begin\n.global quern_report_style_end\n"
    ".text\n");
// clang-format on

extern "C" {
extern const char quern_report_program_begin[], quern_report_program_end[];
extern const char quern_report_style_begin[], quern_report_style_end[];
}

namespace quern {

std::string_view report_program() { return {quern_report_program_begin, quern_report_program_end}; }

std::string_view report_style() { return {quern_report_style_begin, quern_report_style_end}; }

}  // namespace quern
