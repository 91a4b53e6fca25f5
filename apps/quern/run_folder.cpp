#include "apps/quern/run_folder.h"

#include <filesystem>
#include <sstream>

#include "io/file_commit.h"
#include "io/scene_reader.h"
#include "io/summary.h"

namespace quern {

namespace fs = std::filesystem;

RunOutcome outcome_of(const std::string& folder) {
  const std::string path = folder + "/summary.json";
  if (!fs::exists(path)) return {RunState::kStopped, ""};
  const SummaryFile summary(path);
  if (summary.flag("finished")) return {};
  const std::string error = summary.text("error");
  return {error.empty() ? RunState::kStopped : RunState::kFailed, error};
}

std::string without_places(const std::string& text) {
  std::istringstream in(text);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("folder = ") || line.starts_with("start_file = ")) continue;
    out += line + "\n";
  }
  return out;
}

bool holds_scene(const std::string& folder, const Scene& scene) {
  const std::string path = folder + "/scene.toml";
  return fs::exists(path) &&
         without_places(read_text_file("scene", path)) == without_places(scene_to_toml(scene));
}

}  // namespace quern
