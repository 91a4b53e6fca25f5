// The assembler takes the shipped tables in. QUERN_TRADE_TABLES is their folder; CMake builds this
// anew when they change.
#include "apps/quern/trade_advice.h"

// clang-format off
__asm__(
    ".section .rodata\n"
    "quern_trade_lab_mill_begin: .incbin \"" QUERN_TRADE_TABLES "/trade_lab_mill.csv\"\n"
    "quern_trade_lab_mill_end:\n"
    "quern_trade_sag_slice_begin: .incbin \"" QUERN_TRADE_TABLES "/trade_sag_slice_small_sp.csv\"\n"
    "quern_trade_sag_slice_end:\n"
    ".global quern_trade_lab_mill_begin\n.global quern_trade_lab_mill_end\n"
    ".global quern_trade_sag_slice_begin\n.global quern_trade_sag_slice_end\n"
    ".text\n");
// clang-format on

extern "C" {
extern const char quern_trade_lab_mill_begin[], quern_trade_lab_mill_end[];
extern const char quern_trade_sag_slice_begin[], quern_trade_sag_slice_end[];
}

namespace quern {

std::vector<ShippedTable> shipped_tables() {
  return {
      {"lab_mill", {quern_trade_lab_mill_begin, quern_trade_lab_mill_end}},
      {"sag_slice_small_sp", {quern_trade_sag_slice_begin, quern_trade_sag_slice_end}},
  };
}

}  // namespace quern
