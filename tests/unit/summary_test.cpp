// The summary: JSON that any reader takes, in order, with nothing lost.
#include "io/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/statistics.h"
#include "soa/base.h"
#include "tests/support/temp_folder.h"

namespace quern {
namespace {

TEST(Summary, KeepsTheOrderAndTheKinds) {
  Summary summary;
  summary.set("scene", "lab_mill");
  summary.set("particles", 380);
  summary.set("step", std::uint64_t{18446744073709551615u});
  summary.set("power", 12.5);
  summary.set("finished", true);
  EXPECT_EQ(summary.text(),
            "{\n  \"scene\": \"lab_mill\",\n  \"particles\": 380,\n"
            "  \"step\": 18446744073709551615,\n  \"power\": 12.5,\n  \"finished\": true\n}\n");
}

TEST(Summary, SettingAgainReplacesInPlace) {
  Summary summary;
  summary.set("a", 1);
  summary.set("b", 2);
  summary.set("a", std::string("x"));
  EXPECT_EQ(summary.text(), "{\n  \"a\": \"x\",\n  \"b\": 2\n}\n");
}

TEST(Summary, MeansCarryTheirStandardError) {
  Summary summary;
  summary.set_mean("power", Mean{10.0, 0.25});
  summary.set_mean("torque", 1, std::nan(""));
  EXPECT_EQ(summary.text(),
            "{\n  \"power\": 10,\n  \"power_standard_error\": 0.25,\n"
            "  \"torque\": 1,\n  \"torque_standard_error\": null\n}\n");
}

TEST(Summary, WhatIsNotFiniteIsNull) {
  Summary summary;
  summary.set("a", std::numeric_limits<double>::infinity());
  summary.set("b", std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(summary.text(), "{\n  \"a\": null,\n  \"b\": null\n}\n");
}

TEST(Summary, DoublesReadBackAsTheSameBits) {
  for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0, 1e21}) {
    Summary summary;
    summary.set("x", value);
    const std::string text = summary.text();
    const double found = std::strtod(text.c_str() + text.find(':') + 1, nullptr);
    EXPECT_EQ(std::signbit(found), std::signbit(value));
    EXPECT_EQ(found, value);
  }
}

TEST(Summary, EscapesText) {
  Summary summary;
  summary.set("say \"x\"", "a\\b\n\t\x01\u00b5");
  EXPECT_EQ(summary.text(), "{\n  \"say \\\"x\\\"\": \"a\\\\b\\n\\t\\u0001\u00b5\"\n}\n");
}

TEST(Summary, EmptyIsAnObject) { EXPECT_EQ(Summary().text(), "{}\n"); }

TEST(Summary, IsWrittenWholeOrNotAtAll) {
  const TempFolder folder;
  Summary summary;
  summary.set("a", 1);
  summary.write(folder / "summary.json");
  EXPECT_EQ(read_bytes(folder / "summary.json"), summary.text());
  try {
    summary.write(folder / "none/summary.json");
    FAIL();
  } catch (const SystemError& error) {
    EXPECT_EQ(std::string(error.what()), "cannot write summary '" + (folder / "none/summary.json") +
                                             "': open: No such file or directory");
  }
}

}  // namespace
}  // namespace quern
