// Frames: the files that ParaView's VTKHDF 1.0 reader expects, and series that always match them.
//
// tests/regression/paraview_frames.py opens such files in ParaView itself.
#include "io/frames.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/hdf5_file.h"
#include "tests/support/temp_folder.h"

namespace quern {
namespace {

ParticleFrame particles_at(double time, std::size_t n) {
  ParticleFrame frame;
  frame.time = time;
  frame.spheres = n;
  for (std::size_t i = 0; i < n; ++i) {
    const float x = static_cast<float>(i);
    for (int axis = 0; axis < 3; ++axis) {
      frame.position.push_back(x + 0.25 * axis);
      frame.spin.push_back(-x);
    }
    for (const float v : {3 * x, 0.0f, 4 * x}) frame.velocity.push_back(v);
    frame.radius.push_back(0.01f * (x + 1));
    frame.id.push_back(static_cast<std::uint32_t>(i));
    frame.species.push_back(static_cast<std::uint16_t>(i % 2));
    frame.size_class.push_back(static_cast<std::uint16_t>(4 + i % 3));
    frame.contacts.push_back(static_cast<std::uint16_t>(i % 7));
  }
  return frame;
}

WallFrame square() {
  return {{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3}, {4, 4}, {0.5f, 1.5f}};
}

ContactFrame two_contacts() {
  ContactFrame f;
  f.point = {0, 0, 0.5, 1, 2, 3};
  f.force = {0, 3, 4, 0, -1, 0};
  f.normal = {0, 0, 1, 0, -1, 0};
  f.overlap = {1e-5f, 2e-5f};
  f.normal_force = {4, 1};
  f.tangential_force = {3, 0};
  f.first = {0, 2};
  f.second = {1, 0};
  f.wall = {0, 1};
  f.kind = {0, 2};
  return f;
}

template <class T>
std::vector<T> read_array(const Hdf5File& file, const std::string& name, std::size_t rows,
                          std::size_t components = 1) {
  std::vector<T> values(rows * components);
  file.read("VTKHDF/" + name, {element_type_of<T>(), rows, components}, values.data());
  return values;
}

using Int64s = std::vector<std::int64_t>;

TEST(Frames, ASurfaceIsTrianglesWithTheirFaces) {
  const TempFolder folder;
  write_surface(folder / "cube.hdf",
                {{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}, {0, 1, 2, 0, 2, 3}, {7, 9}});
  const Hdf5File file("frame", folder / "cube.hdf", FileMode::kRead);
  EXPECT_EQ(file.text_attribute("VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(read_array<std::int64_t>(file, "NumberOfPoints", 1), Int64s{4});
  EXPECT_EQ(read_array<std::int64_t>(file, "NumberOfCells", 1), Int64s{2});
  EXPECT_EQ(read_array<std::uint8_t>(file, "Types", 2), (std::vector<std::uint8_t>{5, 5}));
  EXPECT_EQ(read_array<std::int64_t>(file, "Connectivity", 6), (Int64s{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(read_array<double>(file, "Points", 4, 3)[11], 0.5);
  EXPECT_EQ(read_array<std::uint16_t>(file, "CellData/face", 2),
            (std::vector<std::uint16_t>{7, 9}));
}

TEST(Frames, ParticlesAreVertexCellsWithTheirFields) {
  const TempFolder folder;
  FrameWriter(folder / "frames").write(123, particles_at(0.5, 3), {});
  const Hdf5File file("frame", folder / "frames/particles_000123.hdf", FileMode::kRead);
  EXPECT_EQ(file.text_attribute("VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_TRUE(file.has_attribute("VTKHDF", "Version"));
  EXPECT_EQ(file.f64_attribute("/", "time"), 0.5);
  EXPECT_EQ(read_array<std::int64_t>(file, "NumberOfPoints", 1), Int64s{3});
  EXPECT_EQ(read_array<std::int64_t>(file, "NumberOfCells", 1), Int64s{3});
  EXPECT_EQ(read_array<std::int64_t>(file, "NumberOfConnectivityIds", 1), Int64s{3});
  EXPECT_EQ(read_array<std::int64_t>(file, "Offsets", 4), (Int64s{0, 1, 2, 3}));
  EXPECT_EQ(read_array<std::int64_t>(file, "Connectivity", 3), (Int64s{0, 1, 2}));
  EXPECT_EQ(read_array<std::uint8_t>(file, "Types", 3), (std::vector<std::uint8_t>{1, 1, 1}));
  EXPECT_EQ(read_array<double>(file, "Points", 3, 3)[5], 1.5);
  EXPECT_EQ(read_array<float>(file, "PointData/speed", 3), (std::vector<float>{0, 5, 10}));
  EXPECT_EQ(read_array<float>(file, "PointData/velocity", 3, 3)[8], 8);
  EXPECT_EQ(read_array<std::uint32_t>(file, "PointData/id", 3)[2], 2u);
  using Numbers = std::vector<std::uint16_t>;
  EXPECT_EQ(read_array<std::uint16_t>(file, "PointData/species", 3), (Numbers{0, 1, 0}));
  EXPECT_EQ(read_array<std::uint16_t>(file, "PointData/class", 3), (Numbers{4, 5, 6}));
}

TEST(Frames, LinerIsTrianglesWithCellData) {
  const TempFolder folder;
  FrameWriter(folder.path()).write(0, particles_at(0, 1), square());
  const Hdf5File file("frame", folder / "liner_000000.hdf", FileMode::kRead);
  EXPECT_EQ(read_array<std::uint8_t>(file, "Types", 2), (std::vector<std::uint8_t>{5, 5}));
  EXPECT_EQ(read_array<std::int64_t>(file, "Offsets", 3), (Int64s{0, 3, 6}));
  EXPECT_EQ(read_array<std::int64_t>(file, "Connectivity", 6), (Int64s{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(read_array<std::uint16_t>(file, "CellData/wall", 2)[1], 4);
  EXPECT_EQ(read_array<float>(file, "CellData/speed", 2)[1], 1.5f);
}

TEST(Frames, ContactsAreVertexCellsWithTheirForces) {
  const TempFolder folder;
  FrameWriter(folder.path()).write(4, particles_at(0.5, 3), {}, {}, two_contacts());
  const Hdf5File file("frame", folder / "contacts_000004.hdf", FileMode::kRead);
  EXPECT_EQ(file.f64_attribute("/", "time"), 0.5);
  EXPECT_EQ(read_array<std::int64_t>(file, "NumberOfPoints", 1), Int64s{2});
  EXPECT_EQ(read_array<std::int64_t>(file, "Offsets", 3), (Int64s{0, 1, 2}));
  EXPECT_EQ(read_array<std::uint8_t>(file, "Types", 2), (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(read_array<double>(file, "Points", 2, 3)[2], 0.5);
  EXPECT_EQ(read_array<float>(file, "PointData/force", 2, 3)[4], -1);
  EXPECT_EQ(read_array<float>(file, "PointData/normal", 2, 3)[2], 1);
  EXPECT_EQ(read_array<float>(file, "PointData/overlap", 2)[1], 2e-5f);
  EXPECT_EQ(read_array<float>(file, "PointData/normal_force", 2)[0], 4);
  EXPECT_EQ(read_array<float>(file, "PointData/tangential_force", 2)[0], 3);
  EXPECT_EQ(read_array<std::uint32_t>(file, "PointData/first", 2)[1], 2u);
  EXPECT_EQ(read_array<std::uint32_t>(file, "PointData/second", 2)[0], 1u);
  EXPECT_EQ(read_array<std::uint8_t>(file, "PointData/wall", 2)[1], 1);
  EXPECT_EQ(read_array<std::uint16_t>(file, "PointData/kind", 2)[1], 2);
  EXPECT_NE(read_bytes(folder / "contacts.hdf.series").find("contacts_000004.hdf"),
            std::string::npos);
}

TEST(Frames, ContactsAreWrittenWhereAskedForEvenIfNoneTouch) {
  const TempFolder folder;
  FrameWriter frames(folder.path());
  frames.write(0, particles_at(0, 1), {});
  EXPECT_FALSE(std::filesystem::exists(folder / "contacts_000000.hdf"));
  EXPECT_FALSE(std::filesystem::exists(folder / "contacts.hdf.series"));
  frames.write(1, particles_at(0.1, 1), {}, {}, ContactFrame());
  const Hdf5File file("frame", folder / "contacts_000001.hdf", FileMode::kRead);
  EXPECT_EQ(read_array<std::int64_t>(file, "NumberOfPoints", 1), Int64s{0});
}

TEST(Frames, EveryArrayCarriesItsUnit) {
  const TempFolder folder;
  FrameWriter(folder.path()).write(0, particles_at(0, 2), square(), {}, two_contacts());
  for (const char* name : {"particles_000000.hdf", "liner_000000.hdf", "contacts_000000.hdf"}) {
    const Hdf5File file("frame", folder / name, FileMode::kRead);
    for (const std::string& array : file.datasets("VTKHDF")) {
      EXPECT_NE(file.text_attribute("VTKHDF/" + array, "unit"), "") << array;
    }
  }
}

TEST(Frames, SeriesListsTheTimes) {
  const TempFolder folder;
  FrameWriter frames(folder.path());
  frames.write(0, particles_at(-0.1, 2), square());
  frames.write(1, particles_at(0.1 + 0.2, 2), {});
  EXPECT_EQ(read_bytes(folder / "particles.hdf.series"),
            "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n"
            "    {\"name\": \"particles_000000.hdf\", \"time\": -0.1},\n"
            "    {\"name\": \"particles_000001.hdf\", \"time\": 0.30000000000000004}\n"
            "  ]\n}\n");
  EXPECT_EQ(read_bytes(folder / "liner.hdf.series").find("000001"), std::string::npos);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_NE(entry.path().extension(), ".tmp");
  }
}

TEST(Frames, AResumedRunContinuesTheSeries) {
  const TempFolder once, resumed;
  {
    FrameWriter frames(once.path());
    for (int i = 0; i < 6; ++i) frames.write(i, particles_at(0.1 * i, 2), square());
  }
  {
    FrameWriter frames(resumed.path());
    for (int i = 0; i < 5; ++i) frames.write(i, particles_at(i < 3 ? 0.1 * i : 77, 2), square());
  }
  {
    FrameWriter frames(resumed.path());
    frames.write(3, particles_at(0.1 * 3, 2), square());
    EXPECT_FALSE(std::filesystem::exists(resumed / "particles_000004.hdf"));
    for (int i = 4; i < 6; ++i) frames.write(i, particles_at(0.1 * i, 2), square());
  }
  for (const char* name : {"particles.hdf.series", "liner.hdf.series", "particles_000004.hdf"}) {
    EXPECT_TRUE(read_bytes(once / name) == read_bytes(resumed / name)) << name;
  }
}

TEST(Frames, ADamagedSeriesIsReported) {
  const TempFolder folder;
  write_bytes(folder / "particles.hdf.series", "{ \"files\": [ {\"name\": \"x.hdf\"} ] }");
  EXPECT_THROW(FrameWriter{folder.path()}, SystemError);
}

TEST(Frames, AnEmptyChargeIsWritten) {
  const TempFolder folder;
  FrameWriter(folder.path()).write(0, particles_at(0, 0), square());
  const Hdf5File file("frame", folder / "particles_000000.hdf", FileMode::kRead);
  EXPECT_EQ(read_array<std::int64_t>(file, "NumberOfPoints", 1), Int64s{0});
}

}  // namespace
}  // namespace quern
