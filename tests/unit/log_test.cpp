// The progress line reads as documented, fits the terminal, and keeps log files short.
#include "io/log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/temp_folder.h"

namespace quern {
namespace {

ProgressLine example() {
  ProgressLine line;
  line.time = 3.2;
  line.until = 3.2 / 0.14;
  line.revolutions = 1.4;
  line.rate = 6.1e7;
  line.contacts = 1.9e6;
  line.max_overlap = 0.018;
  line.power = 812e3;
  line.energy_error = 1e-4;
  line.elapsed = 3700;
  line.eta = 1333;
  line.checkpoint_age = 190;
  return line;
}

TEST(Progress, ReadsAsDocumented) {
  EXPECT_EQ(format_progress(example()),
            " t 3.200 s 14.0% rev 1.40 | 6.1e7 particle-steps/s | contacts 1.9M | "
            "max overlap 1.8% r | power 812 kW | energy error 1e-4 | elapsed 1:01:40 ETA 22:13 | "
            "checkpoint 3m ago");
}

TEST(Progress, LeavesOutWhatIsNotKnown) {
  ProgressLine line;
  line.time = 0.5;
  line.elapsed = 61;
  EXPECT_EQ(format_progress(line), " t 0.500 s | elapsed 1:01");
}

TEST(Progress, SaysWhenItIsSettling) {
  ProgressLine line = example();
  line.settling = true;
  line.time = -0.25;
  EXPECT_EQ(format_progress(line).substr(0, 24), " settling t -0.250 s | 6");
}

TEST(Progress, FitsAnyWidthAndKeepsTheClockLongest) {
  const std::string whole = format_progress(example());
  const std::string shortest = " t 3.200 s 14.0% rev 1.40 | elapsed 1:01:40 ETA 22:13";
  for (std::size_t width = 1; width <= whole.size(); ++width) {
    const std::string line = format_progress(example(), width);
    EXPECT_LE(line.size(), width);
    EXPECT_EQ(line.find("ETA 22:13") != std::string::npos, width >= shortest.size()) << line;
  }
  EXPECT_EQ(format_progress(example(), whole.size()), whole);
}

TEST(Progress, PowerChoosesItsScale) {
  EXPECT_EQ(format_power(0), "0.00 W");
  EXPECT_EQ(format_power(-1.234), "-1.23 W");
  EXPECT_EQ(format_power(12.34), "12.3 W");
  EXPECT_EQ(format_power(999.6), "1.00 kW");
  EXPECT_EQ(format_power(812345), "812 kW");
  EXPECT_EQ(format_power(8.5e6), "8.50 MW");
}

TEST(Progress, CountsClocksAndAges) {
  EXPECT_EQ(format_count(0), "0");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_count(1234), "1.2k");
  EXPECT_EQ(format_count(1.9e6), "1.9M");
  EXPECT_EQ(format_clock(59.6), "1:00");
  EXPECT_EQ(format_clock(3700), "1:01:40");
  EXPECT_EQ(format_age(59.9), "59s");
  EXPECT_EQ(format_age(3 * 3600 + 5), "3h");
}

TEST(Progress, PrintsOneLineAPeriodIntoAFile) {
  const TempFolder folder;
  std::FILE* file = std::fopen((folder / "log").c_str(), "w");
  ASSERT_NE(file, nullptr);
  {
    Progress progress(file, 3600);
    EXPECT_TRUE(progress.due());
    for (int i = 0; i < 100; ++i) progress.show(example());
    EXPECT_FALSE(progress.due());
    progress.finish(example());
  }
  std::fclose(file);
  const std::string line = format_progress(example()) + "\n";
  EXPECT_EQ(read_bytes(folder / "log"), line + line);
}

TEST(Log, InformationGoesToOutputAndTroubleToErrors) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  log_info("done {braces}");
  log_warn("near");
  log_error("far");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "done {braces}\n");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: near\nerror: far\n");
}

}  // namespace
}  // namespace quern
