// Scenes: any text is read or refused with messages; what is read is written and read back to the
// same scene. Lines that begin with "#!" are values for --set.
#include <vector>

#include "io/scene_reader.h"
#include "tests/fuzz/fuzz.h"

namespace quern {
namespace {

std::vector<std::string> overrides_in(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (text.compare(at, 2, "#!") == 0) found.push_back(text.substr(at + 2, end - at - 2));
    at = end + 1;
  }
  return found;
}

}  // namespace
}  // namespace quern

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quern;
  const std::string text(reinterpret_cast<const char*>(data), size), folder = "/nowhere";
  const SceneResult first =
      parse_scene(text, "scene.toml", folder, overrides_in(text), StartFile::kReadBefore);
  for (const std::string& line : first.errors) fuzz::must(line.find("error: ") != line.npos);
  if (!first.errors.empty()) return 0;
  const std::string written = scene_to_toml(first.scene);
  const SceneResult second = parse_scene(written, "again", folder, {}, StartFile::kReadBefore);
  fuzz::must(second.errors.empty() && scene_to_toml(second.scene) == written);
  return 0;
}
