// What the files of the scene checks share. Private to io/scene_*.cpp.
#pragma once

#include <algorithm>
#include <initializer_list>

#include "io/table_reader.h"

namespace quern {

struct SceneCheck {
  SceneDraft& draft;
  Scene& scene;
  ReadContext& context;

  // None of these paths had an error of its own.
  bool good(std::initializer_list<std::string> paths) const {
    return std::none_of(paths.begin(), paths.end(),
                        [this](const std::string& path) { return context.trace.spoiled(path); });
  }
  void error(const std::string& path, const std::string& text) const;
  // How a message about the path begins.
  std::string place(const std::string& path) const {
    return context.messages.prefix(context.trace.place(path));
  }
  std::vector<std::string> material_names() const;
  void material(const std::string& path, const std::string& name) const;  // it must exist
  void name(const std::string& path, const std::string& name,
            std::vector<std::string>& taken) const;                   // plain and not taken
  void file(const std::string& path, const std::string& file) const;  // it must exist
  void corners(const std::string& table, const std::optional<Vec3>& low,
               const std::optional<Vec3>& high) const;
};

// Unit length; a vector that is one to rounding stays as it is, so that scenes read back the same.
// False for a vector of zero.
bool normalize(Vec3& v);

void check_walls(const SceneCheck& check);      // also sorts draft.walls into the scene
void check_particles(const SceneCheck& check);  // also reads CSV files

}  // namespace quern
