// The report page from inside: what is packed comes back, what is chosen is chosen evenly, what a
// run calls itself stays text, and what is missing is told.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <set>

#include "io/frames.h"
#include "io/html_report.h"
#include "io/packed.h"
#include "io/report_assets.h"
#include "io/report_tables.h"
#include "io/report_walls.h"
#include "io/series.h"
#include "tests/support/temp_folder.h"

namespace quern {
namespace {

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string from_base64(const std::string& text) {
  static const std::string kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6 | static_cast<std::uint32_t>(kDigits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    out += static_cast<char>(group >> bits & 255);
  }
  return out;
}

std::string unpacked(const std::string& text) {
  const std::string bytes = from_base64(text);
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = const_cast<Bytef*>(bytes_of(bytes).data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string out(std::size_t{16} << 20, '\0');
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  inflateEnd(&stream);
  return out;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// RFC 4648, section 10.
TEST(Packed, WritesBase64AsTheStandardDoes) {
  EXPECT_EQ(base64(bytes_of("")), "");
  EXPECT_EQ(base64(bytes_of("f")), "Zg==");
  EXPECT_EQ(base64(bytes_of("fo")), "Zm8=");
  EXPECT_EQ(base64(bytes_of("foo")), "Zm9v");
  EXPECT_EQ(base64(bytes_of("foobar")), "Zm9vYmFy");
}

TEST(Packed, ComesBackAndIsTheSameEachTime) {
  std::string text;
  for (int k = 0; k < 100000; ++k) text += static_cast<char>(k * k % 251);
  EXPECT_EQ(unpacked(packed(text)), text);
  EXPECT_EQ(packed(text), packed(text));
  EXPECT_EQ(unpacked(packed(std::string_view())), "");
}

TEST(Packed, EscapesWhatWouldEndAStringOrAnElement) {
  EXPECT_EQ(json_string("a\"b\\c\n</script>"), "\"a\\\"b\\\\c\\u000a\\u003c/script>\"");
  EXPECT_EQ(html_text("<b title='x'>\"&"), "&lt;b title=&#39;x&#39;&gt;&quot;&amp;");
  EXPECT_EQ(json_number(std::nan("")), "null");
  EXPECT_EQ(json_number(INFINITY), "null");
  EXPECT_EQ(json_number(0.1), "0.1");
}

TEST(ChosenParticles, AreTheLargestAndAnEvenSampleOfTheRest) {
  std::vector<float> radii;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t k = 0; k < 10000; ++k) {
    radii.push_back(k % 100 == 0 ? 2.0f : 1.0f);
    ids.push_back(k);
  }
  const std::vector<std::size_t> chosen = choose_particles(radii, ids, 1000);
  ASSERT_EQ(chosen.size(), 1000u);
  std::size_t large = 0, below = 0;
  for (const std::size_t row : chosen) {
    if (radii[row] > 1) ++large;
    if (row < 5000) ++below;
  }
  EXPECT_EQ(large, 100u);
  // Binomial of 1000: a standard deviation is 16.
  EXPECT_NEAR(static_cast<double>(below), 500, 64);
  EXPECT_EQ(choose_particles(radii, ids, 1000), chosen);
  EXPECT_EQ(choose_particles(radii, ids, 20000).size(), 10000u);
}

TEST(ChosenFrames, HaveTheFirstAndTheLastAndEvenSteps) {
  EXPECT_EQ(choose_evenly(10, 4), (std::vector<std::size_t>{0, 3, 6, 9}));
  EXPECT_EQ(choose_evenly(3, 10), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(choose_evenly(10, 1), (std::vector<std::size_t>{9}));
  EXPECT_TRUE(choose_evenly(0, 4).empty());
}

TEST(WallsOfAPage, AreNumberedAsInFrames) {
  Scene scene;
  scene.mill.emplace();
  scene.meshes.resize(1);
  scene.meshes[0].name = "paddle";
  scene.boxes.resize(1);
  scene.boxes[0].name = "box";
  scene.planes.resize(1);
  scene.planes[0].name = "floor";
  std::vector<std::string> names;
  for (const NamedMotion& wall : walls_of(scene)) names.push_back(wall.name);
  EXPECT_EQ(names, (std::vector<std::string>{"liner", "ends", "paddle", "box", "floor"}));
}

constexpr const char* kScene = R"(format = 1
[run]
title = "</script><script>alert(1)</script> & co"
duration = "1 s"
[materials.resin]
density = "1000 kg/m^3"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
restitution = 0.7
sliding_friction = 0.3
[[particles]]
name = "ball"
material = "resin"
diameter = "10 mm"
count = 10
[domain]
low = ["0 m", "0 m", "0 m"]
high = ["1 m", "1 m", "1 m"]
)";

// A run of `rows` records without frames.
void write_results(const TempFolder& folder, int rows, const std::string& name = "run.h5") {
  SeriesWriter series(folder / name, {{"time", "s", "time"}, {"power", "W", "of the mill"}},
                      SeriesMode::kNew);
  for (int k = 0; k < rows; ++k) series.append(std::vector<double>{0.1 * k, 2.0 * k});
  series.text("scene", kScene);
  series.close();
}

ParticleFrame charge(std::size_t n, double time) {
  ParticleFrame f;
  f.time = time;
  f.spheres = n;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i * 7919 % 1009) / 1009;
    f.position.insert(f.position.end(), {x, x * x, 0.5 + 0.1 * time});
    f.radius.push_back(0.001f * static_cast<float>(1 + i % 7));
    f.velocity.insert(f.velocity.end(), {1.0f, static_cast<float>(x), 0});
    f.spin.insert(f.spin.end(), {0, 0, 2.0f});
    f.id.push_back(static_cast<std::uint32_t>(i));
    f.species.push_back(0);
    f.size_class.push_back(0);
    f.contacts.push_back(0);
  }
  return f;
}

TEST(Report, KeepsTitlesAsText) {
  const TempFolder folder;
  write_results(folder, 5);
  const std::string page = html_report({{folder.path(), ""}}, {});
  EXPECT_NE(
      page.find("<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt; &amp; co</title>"),
      std::string::npos);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(count(page, "</script>"), 2u);  // of the data and of the program
  EXPECT_EQ(report_program().find("</script"), std::string_view::npos);
}

TEST(Report, IsTheSameEachTime) {
  const TempFolder folder;
  write_results(folder, 5);
  EXPECT_EQ(html_report({{folder.path(), ""}}, {}), html_report({{folder.path(), ""}}, {}));
}

TEST(Report, SaysWhatIsMissing) {
  const TempFolder folder;
  EXPECT_THROW(html_report({{folder / "none", ""}}, {}), SystemError);
  EXPECT_THROW(html_report({{folder.path(), ""}}, {}), SystemError);
  write_bytes(folder / "run.h5", "no HDF5");
  EXPECT_THROW(html_report({{folder.path(), ""}}, {}), SystemError);
}

TEST(Report, OfADamagedFileIsAsOfTheLastCheckpoint) {
  const TempFolder folder;
  write_results(folder, 3, "run.previous.h5");
  write_bytes(folder / "run.h5", "no HDF5");
  const RunTables tables = read_run_tables(folder.path());
  EXPECT_NE(tables.arrays.find("\"data\":[0,2,4]"), std::string::npos) << tables.arrays;
  ASSERT_EQ(tables.notes.size(), 1u);
  EXPECT_NE(tables.notes[0].find("run.previous.h5"), std::string::npos);
}

// HDF5 does so on some files that a kill has torn.
TEST(Report, OfAFileThatCrashesItsReaderIsAsOfTheLastCheckpoint) {
  const TempFolder folder;
  write_results(folder, 3);
  write_results(folder, 2, "run.previous.h5");
  std::vector<std::size_t> rows;
  const auto read = [&](const Hdf5File& file) {
    rows.push_back(file.layout("series/time").rows);
    if (rows.back() == 3) raise(SIGSEGV);
  };
  const std::string as_of = read_results(folder.path(), read, false);
  EXPECT_EQ(rows, std::vector<std::size_t>{2});
  EXPECT_NE(as_of.find("crashes"), std::string::npos) << as_of;
  EXPECT_NE(as_of.find("run.previous.h5"), std::string::npos) << as_of;
}

TEST(Report, ReadsSeriesThatAreBeingWritten) {
  const TempFolder folder;
  SeriesWriter series(folder / "run.h5", {{"time", "s", "time"}, {"power", "W", "of the mill"}},
                      SeriesMode::kNew);
  series.text("scene", kScene);
  for (int k = 0; k < 7; ++k) series.append(std::vector<double>{0.1 * k, 2.0 * k});
  const RunTables tables = read_run_tables(folder.path());
  EXPECT_NE(tables.arrays.find("\"data\":[0,2,4,6,8,10,12]"), std::string::npos) << tables.arrays;
  EXPECT_EQ(tables.scene, kScene);
}

// A kill between two series leaves one a row longer.
TEST(Report, CutsSeriesToTheirCommonRows) {
  const TempFolder folder;
  write_results(folder, 4);
  {
    Hdf5File file("series", folder / "run.h5", FileMode::kUpdate);
    file.append_series(file.open_series("series/time"), 0.4);
  }
  const RunTables tables = read_run_tables(folder.path());
  EXPECT_NE(tables.arrays.find("\"data\":[0,0.1,0.2,0.3]"), std::string::npos) << tables.arrays;
}

TEST(Report, ThinsLongSeriesAndKeepsTheirEnd) {
  const TempFolder folder;
  write_results(folder, 25001);
  const RunTables tables = read_run_tables(folder.path());
  EXPECT_NE(tables.arrays.find("\"rows\":12501,\"columns\":1,\"every\":2,\"data\":[0,4,8,"),
            std::string::npos);
  EXPECT_NE(tables.arrays.find(",49996,50000]"), std::string::npos);
}

TEST(View, OfMoreThanThereIsRoomForIsSampledAndSaysSo) {
  const TempFolder folder;
  FrameWriter frames(folder / "frames");
  for (int k = 1; k <= 30; ++k) frames.write(k, charge(5000, 0.1 * k), {});
  ViewBudget budget;
  budget.bytes = 200000;
  budget.wanted_frames = 10;
  const RunView view = read_run_view(folder.path(), Scene(), budget, 0);
  std::size_t bytes = 0;
  for (const std::string& blob : view.packed) bytes += blob.size();
  EXPECT_LT(bytes, 250000u);
  ASSERT_EQ(view.notes.size(), 1u);
  EXPECT_NE(view.notes[0].find("of 5000 particles"), std::string::npos) << view.notes[0];
  EXPECT_NE(view.notes[0].find("of 30 frames"), std::string::npos) << view.notes[0];
}

// 16 bits over the span of all frames: half a step is 1 / 131070 of it.
TEST(View, PlacesParticlesToSixteenBits) {
  const TempFolder folder;
  FrameWriter frames(folder / "frames");
  const ParticleFrame f = charge(100, 0.1);
  frames.write(1, f, {});
  const RunView view = read_run_view(folder.path(), Scene(), {}, 0);
  ASSERT_EQ(view.packed.size(), 2u);
  const std::string bytes = unpacked(view.packed[1]);
  ASSERT_EQ(bytes.size(), 800u);
  double low = 1, high = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    low = std::min(low, f.position[3 * i]);
    high = std::max(high, f.position[3 * i]);
  }
  for (std::size_t i = 0; i < 100; ++i) {
    const int q =
        256 * static_cast<std::uint8_t>(bytes[i]) + static_cast<std::uint8_t>(bytes[100 + i]);
    EXPECT_NEAR(low + (high - low) * q / 65535, f.position[3 * i], (high - low) / 131070 + 1e-7);
  }
}

TEST(View, IsAbsentWithoutFrames) {
  const TempFolder folder;
  EXPECT_EQ(read_run_view(folder.path(), Scene(), {}, 0).json, "null");
}

}  // namespace
}  // namespace quern
