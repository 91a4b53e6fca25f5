// The STL reader against broken files, each with its message, and good ones in both forms.
#include "io/mesh_reader.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

namespace quern {
namespace {

using Lines = std::vector<std::string>;

constexpr const char* kGood =
    "solid plate\n"
    "facet normal 0 0 1\n"
    " outer loop\n"
    "  vertex 0 0 0\n"
    "  vertex 1 0 0\n"
    "  vertex 0 1 0\n"
    " endloop\n"
    "endfacet\n"
    "endsolid plate\n";

std::string changed(std::string text, const std::string& find, const std::string& replace) {
  const std::size_t at = text.find(find);
  EXPECT_NE(at, std::string::npos) << find;
  return at == std::string::npos ? text : text.replace(at, find.size(), replace);
}

std::string cut(const std::string& text, const std::string& before) {
  return text.substr(0, text.find(before));
}

void append(std::string& bytes, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> 8 * k & 0xff);
}

// `announced` triangles in the header, as many as `corners` holds in the body.
std::string binary(std::uint32_t announced, const std::vector<float>& corners,
                   std::string header = "made for a test") {
  header.resize(80, '\0');
  append(header, announced);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 9 == 0) header.append(12, '\0');  // normal
    std::uint32_t bits;
    std::memcpy(&bits, &corners[i], sizeof bits);
    append(header, bits);
    if (i % 9 == 8) header.append(2, '\0');  // attribute
  }
  return header;
}

const std::vector<float> kCorners = {0, 0, 0, 1, 0, 0, 0, 1, 0};

std::vector<float> with(std::size_t index, float value) {
  std::vector<float> corners = kCorners;
  corners[index] = value;
  return corners;
}

struct File {
  std::filesystem::path path;
  explicit File(const std::string& bytes) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("quern_") + test->test_suite_name() + test->name() + ".stl";
    for (char& c : name)
      if (c == '/') c = '_';
    path = std::filesystem::path(testing::TempDir()) / name;
    std::ofstream(path, std::ios::binary) << bytes;
  }
  ~File() { std::filesystem::remove(path); }
};

struct BadMesh {
  const char* name;
  std::string bytes;
  Lines messages;  // all of them, without the file's name
};

const float kInf = std::numeric_limits<float>::infinity();

const BadMesh kBadMeshes[] = {
    {"Empty", "", {": error: the file is empty"}},
    {"TooShort",
     std::string("\0\1\2", 3),
     {": error: no STL file: 3 bytes are too few for a binary one, and an ASCII one begins with "
      "'solid'"}},
    {"SomeOtherText",
     "v 0 0 0\nv 1 0 0\nf 1 2 3\n",
     {":1:1: error: expected 'solid' or the end of the file, found 'v'"}},
    {"Garbage",
     std::string(200, '\x07'),
     {": error: as binary STL it announces 117901063 triangles, 5895053234 bytes, but the file has "
      "200 bytes: cut off, or no STL file"}},
    {"BinaryCutOff",
     binary(1, kCorners).substr(0, 120),
     {": error: as binary STL it announces 1 triangles, 134 bytes, but the file has 120 bytes: cut "
      "off, or no STL file"}},
    {"BinaryHugeCount",
     binary(0xffffffffu, kCorners),
     {": error: as binary STL it announces 4294967295 triangles, 214748364834 bytes, but the file "
      "has 134 bytes: cut off, or no STL file"}},
    {"BinaryTooLong",
     binary(1, kCorners) + "x",
     {": error: as binary STL it announces 1 triangles, 134 bytes, but the file has 135 bytes: cut "
      "off, or no STL file"}},
    {"BinaryCutOffThatBeginsWithSolid",
     binary(2, kCorners, "solid made by a CAD program"),
     {": error: as binary STL it announces 2 triangles, 184 bytes, but the file has 134 bytes: cut "
      "off, or no STL file"}},
    {"BinaryWithoutTriangles", binary(0, {}), {": error: the mesh has no triangles"}},
    {"BinaryNaN",
     binary(1, with(4, std::numeric_limits<float>::quiet_NaN())),
     {": error: triangle 1, corner 2: y is NaN, not a finite number"}},
    {"BinaryInfinity",
     binary(1, with(8, -kInf)),
     {": error: triangle 1, corner 3: z is infinite, not a finite number"}},
    {"AsciiNaN",
     changed(kGood, "vertex 1 0 0", "vertex nan 0 0"),
     {":5:10: error: 'nan' is not a finite number"}},
    {"AsciiInfinity",
     changed(kGood, "vertex 1 0 0", "vertex 1 -inf 0"),
     {":5:12: error: '-inf' is not a finite number"}},
    {"AsciiOverflow",
     changed(kGood, "vertex 1 0 0", "vertex 1e999 0 0"),
     {":5:10: error: expected a number, found '1e999'"}},
    {"DecimalComma",
     changed(kGood, "vertex 1 0 0", "vertex 1,5 0 0"),
     {":5:10: error: '1,5' has a comma: decimals need a point, numbers a space between them"}},
    {"CommasBetweenNumbers",
     changed(kGood, "vertex 1 0 0", "vertex 1,0,0"),
     {":5:10: error: '1,0,0' has a comma: decimals need a point, numbers a space between them"}},
    {"NumberThatIsNone",
     changed(kGood, "vertex 1 0 0", "vertex 1 0.0.0 0"),
     {":5:12: error: expected a number, found '0.0.0'"}},
    {"NumberMissing",
     changed(kGood, "vertex 1 0 0", "vertex 1 0"),
     {":6:3: error: expected a number, found 'vertex'"}},
    {"NormalIncomplete",
     changed(kGood, "normal 0 0 1", "normal 0 0"),
     {":3:2: error: expected a number, found 'outer'"}},
    {"Quad",
     changed(kGood, " endloop", "  vertex 1 1 0\n endloop"),
     {":7:3: error: a facet must be a triangle, this one has more than 3 corners"}},
    {"TwoCorners",
     changed(kGood, "  vertex 1 0 0\n", ""),
     {":6:2: error: expected 'vertex', found 'endloop'"}},
    {"NoEndloop",
     changed(kGood, " endloop\n", ""),
     {":7:1: error: expected 'endloop', found 'endfacet'"}},
    {"NoOuter",
     changed(kGood, "outer loop", "loop"),
     {":3:2: error: expected 'outer', found 'loop'"}},
    {"UnknownWord",
     changed(kGood, "facet normal", "face normal"),
     {":2:1: error: expected 'facet', found 'face'"}},
    {"CutOffInAFacet",
     cut(kGood, " endloop"),
     {":7:1: error: the file ends inside a facet, where 'endloop' should stand: is it cut off?",
      ":7:1: error: the file ends without 'endsolid': is it cut off?"}},
    {"CutOffInANumber",
     cut(kGood, " 0\n  vertex 0 1 0"),
     {":5:13: error: the file ends inside a facet, where a number should stand: is it cut off?",
      ":5:13: error: the file ends without 'endsolid': is it cut off?"}},
    {"NoEndsolid",
     cut(kGood, "endsolid"),
     {":9:1: error: the file ends without 'endsolid': is it cut off?"}},
    {"AsciiWithoutFacets",
     "solid nothing\nendsolid nothing\n",
     {": error: the mesh has no triangles"}},
    {"TextAfterTheEnd",
     std::string(kGood) + "and more\n",
     {":10:1: error: expected 'solid' or the end of the file, found 'and'"}},
};

class BadMeshTest : public testing::TestWithParam<BadMesh> {};

TEST_P(BadMeshTest, GivesExactlyItsMessages) {
  const File file(GetParam().bytes);
  Lines expected;
  for (const std::string& message : GetParam().messages)
    expected.push_back(file.path.string() + message);
  const MeshResult result = read_stl(file.path.string(), 1);
  EXPECT_EQ(result.errors, expected);
  EXPECT_TRUE(result.triangles.empty());
}

INSTANTIATE_TEST_SUITE_P(MeshReader, BadMeshTest, testing::ValuesIn(kBadMeshes),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(MeshReader, SaysThatAFileCannotBeRead) {
  EXPECT_EQ(read_stl("/nowhere/liner.stl", 1).errors,
            Lines{"/nowhere/liner.stl: error: cannot read the mesh: No such file or directory"});
  EXPECT_EQ(read_stl("/", 1).errors, Lines{"/: error: cannot read the mesh: it is a folder"});
}

TEST(MeshReader, RefusesAScaleThatIsNone) {
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(read_stl("liner.stl", scale).errors.size(), 1u);
}

TEST(MeshReader, ReportsEveryMistakeOfAFileAtOnce) {
  std::string text = kGood;
  text = text.substr(0, text.find("endsolid"));
  const std::string facet = text.substr(text.find("facet"));
  text += changed(facet, "vertex 0 0 0", "vertex x 0 0") + facet +
          changed(facet, "vertex 0 1 0", "vertex 0 1 nan") + "endsolid\n";
  const File file(text);
  const std::string path = file.path.string();
  const Lines expected = {path + ":11:10: error: expected a number, found 'x'",
                          path + ":27:14: error: 'nan' is not a finite number"};
  EXPECT_EQ(read_stl(path, 1).errors, expected);
}

TEST(MeshReader, ListsTwentyMistakesAndCountsTheRest) {
  std::vector<float> corners;
  for (int t = 0; t < 30; ++t)
    for (const float x : with(0, kInf)) corners.push_back(x);
  const File file(binary(30, corners));
  const MeshResult result = read_stl(file.path.string(), 1);
  ASSERT_EQ(result.errors.size(), 21u);
  EXPECT_EQ(result.errors.back(), file.path.string() + ": error: ... and 10 more");
}

void expect_plate(const std::string& bytes, double scale) {
  const File file(bytes);
  const MeshResult result = read_stl(file.path.string(), scale);
  ASSERT_EQ(result.errors, Lines{});
  ASSERT_EQ(result.triangles.size(), 1u);
  EXPECT_EQ(result.triangles[0].corner[0], Vec3(0, 0, 0));
  EXPECT_EQ(result.triangles[0].corner[1], Vec3(scale, 0, 0));
  EXPECT_EQ(result.triangles[0].corner[2], Vec3(0, scale, 0));
}

TEST(MeshReader, ReadsBothFormsToTheSameTriangles) {
  expect_plate(kGood, 0.001);
  expect_plate(binary(1, kCorners), 0.001);
}

TEST(MeshReader, TakesBinaryThatBeginsWithSolid) {
  expect_plate(binary(1, kCorners, "solid made by a CAD program"), 1);
}

TEST(MeshReader, TakesAnyCaseAndAnyBlanks) {
  std::string text = kGood;
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_plate(text, 1);
  expect_plate(changed(kGood, "  vertex 1 0 0\n", "\tvertex  +1.0 0.0\r\n 0e0\r\n"), 1);
}

TEST(MeshReader, TakesNormalsThatAreNoNumbersAsTheyAreNotUsed) {
  expect_plate(changed(kGood, "normal 0 0 1", "normal nan nan nan"), 1);
}

TEST(MeshReader, TakesSeveralSolidsInAFile) {
  const File file(std::string(kGood) + kGood);
  EXPECT_EQ(read_stl(file.path.string(), 1).triangles.size(), 2u);
}

}  // namespace
}  // namespace quern
