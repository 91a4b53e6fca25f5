// What the tests of scenes share: a good scene, changes to texts, a folder for files.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/scene_reader.h"
#include "tests/unit/bad_scenes.h"

namespace quern {

using Lines = std::vector<std::string>;

inline SceneResult parse(const std::string& text, const Lines& overrides = {}) {
  return parse_scene(text, "mill.toml", "/nowhere", overrides);
}

inline std::string changed(std::string text, const std::string& find, const std::string& replace) {
  const std::size_t at = text.find(find);
  EXPECT_NE(at, std::string::npos) << find;
  return at == std::string::npos ? text : text.replace(at, find.size(), replace);
}

// A folder of the running test, removed at its end.
struct TestFolder {
  std::filesystem::path path;
  TestFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path = std::filesystem::path(testing::TempDir()) / (std::string("quern_") + test->name());
    std::filesystem::create_directories(path);
  }
  ~TestFolder() { std::filesystem::remove_all(path); }
  std::string write(const char* name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return (path / name).string();
  }
};

}  // namespace quern
