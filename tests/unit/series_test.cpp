// The series of a run: readable at any moment, continued without a seam, units always there.
#include "io/series.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/support/temp_folder.h"

namespace quern {
namespace {

const std::vector<Quantity> kQuantities = {
    {"time", "s", "time after the mill starts"},
    {"power", "W", "power drawn by the mill"},
    {"kinetic_energy", "J", "of translation and rotation"},
};

void append_rows(SeriesWriter& series, int from, int to) {
  for (int i = from; i < to; ++i) {
    series.append(std::vector<double>{0.1 * i, 1000.0 + i, -1.0 * i});
  }
}

std::vector<double> read_back(const std::string& path, const std::string& name) {
  Hdf5File file("series", path, FileMode::kRead);
  return file.read_series(file.open_series("series/" + name));
}

TEST(Series, HoldsWhatWasAppendedWithUnits) {
  const TempFolder folder;
  const std::string path = folder / "run.h5";
  SeriesWriter series(path, kQuantities, SeriesMode::kNew);
  append_rows(series, 0, 1200);  // several chunks
  series.close();
  const std::vector<double> power = read_back(path, "power");
  ASSERT_EQ(power.size(), 1200u);
  for (int i = 0; i < 1200; ++i) EXPECT_EQ(power[static_cast<std::size_t>(i)], 1000.0 + i);
  const Hdf5File file("series", path, FileMode::kRead);
  EXPECT_EQ(file.text_attribute("series/power", "unit"), "W");
  EXPECT_EQ(file.text_attribute("series/power", "doc"), "power drawn by the mill");
}

// Of this process, bytes.
std::size_t memory() {
  std::ifstream file("/proc/self/statm");
  std::size_t all = 0, pages = 0;
  file >> all >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// Snapshots over a long run: of 2400 arrays HDF5 would remember 14 MB while the file stays open; it
// is opened anew before that, and rows go on through it.
TEST(Series, OfAnyLengthTakesLittleMemory) {
  const TempFolder folder;
  SeriesWriter series(folder / "run.h5", kQuantities, SeriesMode::kNew);
  const std::vector<double> values(30, 1.5);
  std::size_t start = 0;
  for (int k = 0; k < 400; ++k) {
    if (k == 200) start = memory();
    std::vector<TableColumn> columns;
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"}) {
      columns.push_back(table_column<double>({name, "m", "a length"}, values));
    }
    series.write_table(fmt::format("snapshots/{}", k), columns);
    append_rows(series, k, k + 1);
  }
  EXPECT_LT(memory(), start + 5'000'000);
  series.close();
  EXPECT_EQ(read_back(folder / "run.h5", "power").size(), 400u);
  const Hdf5File file("series", folder / "run.h5", FileMode::kRead);
  EXPECT_EQ(file.datasets("snapshots").size(), 4800u);
  std::vector<double> last(30);
  file.read("snapshots/399/l", {ElementType::kF64, 30, 1}, last.data());
  EXPECT_EQ(last, values);
}

// What another process finds: no lock in its way, and a file that opens as it lies on the disk.
TEST(Series, CanBeReadWhileTheRunGoesOn) {
  const TempFolder folder;
  SeriesWriter series(folder / "run.h5", kQuantities, SeriesMode::kNew);
  for (int rows = 1; rows < 600; rows += 100) {
    append_rows(series, static_cast<int>(series.rows()), rows);
    write_bytes(folder / "seen.h5", read_bytes(folder / "run.h5"));
    EXPECT_EQ(read_back(folder / "seen.h5", "power").size(), static_cast<std::size_t>(rows));
  }
  const int descriptor = open((folder / "run.h5").c_str(), O_RDONLY);
  EXPECT_EQ(flock(descriptor, LOCK_SH | LOCK_NB), 0);
  close(descriptor);
}

TEST(Series, ContinuesWithoutASeam) {
  const TempFolder folder;
  const std::string path = folder / "run.h5";
  {
    SeriesWriter series(path, kQuantities, SeriesMode::kNew);
    append_rows(series, 0, 700);
  }
  {
    SeriesWriter series(path, kQuantities, SeriesMode::kAppend);
    series.truncate_after(0.1 * 600);  // equal times stay
    EXPECT_EQ(series.rows(), 601u);
    append_rows(series, 601, 900);
    EXPECT_EQ(series.read("power").size(), 900u);
  }
  const std::vector<double> energy = read_back(path, "kinetic_energy");
  ASSERT_EQ(energy.size(), 900u);
  for (int i = 0; i < 900; ++i) EXPECT_EQ(energy[static_cast<std::size_t>(i)], -1.0 * i);
}

// A run that wrote 300 rows, kept them, wrote 100 more and was killed.
void leave_kept_rows(const std::string& path) {
  SeriesWriter series(path, kQuantities, SeriesMode::kNew);
  append_rows(series, 0, 300);
  series.keep();
  append_rows(series, 300, 400);
}

void tear(const std::string& path) {
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 3);
}

// Whether a kill has torn the file since or not: a torn one may open, and crash HDF5 inside.
TEST(Series, GoesOnFromTheKeptCopy) {
  for (const bool torn : {false, true}) {
    const TempFolder folder;
    const std::string path = folder / "run.h5";
    leave_kept_rows(path);
    if (torn) tear(path);
    {
      SeriesWriter series(path, kQuantities, SeriesMode::kAppend);
      EXPECT_EQ(series.rows(), 300u);
      append_rows(series, 300, 500);
    }
    EXPECT_EQ(read_back(path, "power").size(), 500u);
  }
}

TEST(Series, GoesOnAsItIsIfTheKeptCopyCannotBeRead) {
  const TempFolder folder;
  const std::string path = folder / "run.h5";
  leave_kept_rows(path);
  tear(folder / "run.previous.h5");
  const SeriesWriter series(path, kQuantities, SeriesMode::kAppend);
  EXPECT_EQ(series.rows(), 400u);
}

TEST(Series, AppendingToNothingMakesANewFile) {
  const TempFolder folder;
  SeriesWriter series(folder / "run.h5", kQuantities, SeriesMode::kAppend);
  series.truncate_after(1);
  EXPECT_EQ(series.rows(), 0u);
  append_rows(series, 0, 1);
  EXPECT_EQ(series.rows(), 1u);
}

TEST(Series, RefusesToContinueOtherQuantities) {
  const TempFolder folder;
  const std::string path = folder / "run.h5";
  { SeriesWriter series(path, kQuantities, SeriesMode::kNew); }
  std::vector<Quantity> fewer = {kQuantities[0], kQuantities[1]}, more = kQuantities,
                        other_unit = kQuantities;
  more.push_back({"torque", "N m", "of the mill"});
  other_unit[1].unit = "kW";
  EXPECT_THROW(SeriesWriter(path, fewer, SeriesMode::kAppend), SystemError);
  EXPECT_THROW(SeriesWriter(path, more, SeriesMode::kAppend), SystemError);
  EXPECT_THROW(SeriesWriter(path, other_unit, SeriesMode::kAppend), SystemError);
}

TEST(Series, KeepsTextProvenanceAndTables) {
  const TempFolder folder;
  const std::string path = folder / "run.h5";
  const std::vector<double> position = {1, 2, 3, 4, 5, 6};
  const std::vector<std::uint32_t> id = {7, 8};
  {
    SeriesWriter series(path, kQuantities, SeriesMode::kNew);
    for (const char* scene : {"draft", "[run]\nseed = 1\n"}) series.text("scene", scene);
    for (const char* version : {"0.0", "0.1.0"}) series.provenance("version", version);
    for (int twice = 0; twice < 2; ++twice) {  // a resumed run writes them again
      series.write_table("particles",
                         std::vector<TableColumn>{
                             table_column<double>({"position", "m", "at the end"}, position, 3),
                             table_column<std::uint32_t>({"id", "1", "0 ... n-1"}, id)});
    }
  }
  const Hdf5File file("series", path, FileMode::kRead);
  EXPECT_EQ(file.read_text("scene"), "[run]\nseed = 1\n");
  EXPECT_EQ(file.text_attribute("provenance", "version"), "0.1.0");
  EXPECT_EQ(file.text_attribute("particles/position", "unit"), "m");
  std::vector<double> found(6);
  file.read("particles/position", {ElementType::kF64, 2, 3}, found.data());
  EXPECT_EQ(found, position);
}

// Killed again and again, continued each time: every row is there and right; the one being written
// when the kill came may be missing or NaN.
TEST(Series, SurvivesKills) {
  const TempFolder folder;
  const std::string path = folder / "run.h5";
  for (int round = 0; round < 25; ++round) {
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
      SeriesWriter series(path, kQuantities, SeriesMode::kAppend);
      append_rows(series, static_cast<int>(series.rows()), static_cast<int>(series.rows()) + 1);
      if (write(ready[1], "x", 1) != 1) _exit(1);
      append_rows(series, static_cast<int>(series.rows()), 1 << 30);
      _exit(0);
    }
    char byte = 0;
    ASSERT_EQ(read(ready[0], &byte, 1), 1);
    usleep(static_cast<useconds_t>(37 * round * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(ready[0]);
    close(ready[1]);
    const std::vector<double> power = read_back(path, "power"), time = read_back(path, "time");
    ASSERT_LE(std::max(power.size(), time.size()) - std::min(power.size(), time.size()), 1u);
    for (std::size_t i = 0; i < power.size(); ++i) {
      const bool torn = i + 1 == power.size() && std::isnan(power[i]);
      ASSERT_TRUE(torn || power[i] == 1000.0 + static_cast<double>(i)) << round << " " << i;
    }
  }
  const SeriesWriter series(path, kQuantities, SeriesMode::kAppend);
  EXPECT_GT(series.rows(), 25u);
  for (const double time : series.read("time")) EXPECT_FALSE(std::isnan(time));
}

TEST(Series, NamesPathAndReasonWhenItCannotBeWritten) {
  try {
    SeriesWriter series("/nonexistent/run.h5", kQuantities, SeriesMode::kNew);
    FAIL();
  } catch (const SystemError& error) {
    EXPECT_STREQ(error.what(),
                 "cannot write series '/nonexistent/run.h5': open: No such file or directory");
  }
}

}  // namespace
}  // namespace quern
