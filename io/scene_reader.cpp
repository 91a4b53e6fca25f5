// Reading a scene: text -> tree -> overrides -> keys -> checks.
#include "io/scene_reader.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/scene_checks.h"
#include "io/scene_overrides.h"
#include "io/table_reader.h"

namespace quern {
namespace {

std::string absolute_folder(const std::string& folder) {
  std::filesystem::path path = std::filesystem::absolute(folder.empty() ? "." : folder);
  path = path.lexically_normal();
  if (!path.has_filename()) path = path.parent_path();  // drops a slash at the end
  return path.string();
}

std::vector<std::string> all_paths() {
  std::vector<std::string> paths;
  for (const SceneKey& key : scene_keys()) paths.push_back(key.path);
  return paths;
}

}  // namespace

SceneResult parse_scene(const std::string& text, const std::string& display_name,
                        const std::string& folder, const std::vector<std::string>& overrides,
                        StartFile start_file) {
  SceneResult result;
  Messages messages(display_name, overrides);
  Node root = parse_toml(text, messages);
  if (!messages.any_error()) {
    give_names(root);
    apply_overrides(root, overrides, messages);
    ReadContext context{messages, {}, all_paths()};
    SceneDraft draft;
    draft.start_file = start_file;
    TableReader reader(context, &root, "");
    fields(reader, draft);
    reader.finish();
    draft.scene.folder = absolute_folder(
        (std::filesystem::path(absolute_folder(folder)) / draft.scene.folder).string());
    check_scene(draft, context);
    result.scene = std::move(draft.scene);
    result.scene.text = text;
    result.wall_mesh_places = std::move(draft.wall_mesh_places);
    result.shape_mesh_places = std::move(draft.shape_mesh_places);
  }
  result.errors = messages.errors();
  result.warnings = messages.warnings();
  return result;
}

SceneResult read_scene(const std::string& path, const std::vector<std::string>& overrides) {
  SceneResult result;
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  const bool folder = std::filesystem::is_directory(path, ignored);
  if (!file || folder) {
    result.errors.push_back(path + ": error: cannot read the scene: " +
                            (folder ? "it is a folder" : std::strerror(errno)));
    return result;
  }
  std::ostringstream text;
  text << file.rdbuf();
  const std::string parent = std::filesystem::path(path).parent_path().string();
  return parse_scene(text.str(), path, parent, overrides);
}

}  // namespace quern
