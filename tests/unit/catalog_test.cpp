// What the kernels say of their parameters is what the scene reader accepts for them.
#include "soa/catalog.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/quantity.h"
#include "io/scene_reader.h"

namespace quern {
namespace {

const SceneKey* find_key(const std::string& path) {
  static const std::vector<SceneKey> keys = scene_keys();
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const SceneKey& key) { return key.path == path; });
  return found == keys.end() ? nullptr : &*found;
}

// As scene_keys() words it: "stiffness > 0", "number in (0, 1]", "clamped | unclamped".
std::string type_of(const CatalogParameter& parameter) {
  if (parameter.unit.empty()) return parameter.range;
  const bool interval = parameter.range.starts_with('(') || parameter.range.starts_with('[');
  const std::string note = (interval ? "in " : "") + parameter.range;
  for (const Dimension dimension :
       {Dimension::kStiffness, Dimension::kPressure, Dimension::kSpeed}) {
    if (parameter.unit == si_unit(dimension)) return dimension_name(dimension) + (" " + note);
  }
  EXPECT_EQ(parameter.unit, "1");
  return "number " + note;
}

TEST(Catalog, GivesUnitRangeAndDefaultOfParametersAsTheSceneKeysDo) {
  int compared = 0;
  for (const CatalogEntry& entry : contact_catalog()) {
    for (const CatalogParameter& p : entry.parameters) {
      const SceneKey* key = find_key("contact." + p.name);
      if (key == nullptr) key = find_key("materials.NAME." + p.name);
      ASSERT_NE(key, nullptr) << p.name << " of " << entry.name << " is no key of a scene";
      EXPECT_EQ(key->type, type_of(p)) << p.name;
      // A default that is worked out stands in the key's line of text.
      if (p.fallback.empty() || !key->fallback.empty()) {
        EXPECT_EQ(key->fallback, p.fallback) << p.name;
      } else {
        EXPECT_TRUE(key->doc.ends_with("default: " + p.fallback)) << p.name << ": " << key->doc;
      }
      if (const SceneKey* of_pair = find_key("contact.A-B." + p.name)) {
        EXPECT_EQ(of_pair->type, key->type) << p.name;
      }
      ++compared;
    }
  }
  EXPECT_GE(compared, 19);
}

TEST(Catalog, NamesTheLawsAndWallsThatScenesCanAskFor) {
  std::string laws, walls;
  for (const CatalogEntry& entry : contact_catalog()) {
    std::string* const list = entry.kind == "law" ? &laws : entry.kind == "wall" ? &walls : nullptr;
    if (list == nullptr || entry.name == "mill") continue;  // a mill has a table of its own
    *list += (list->empty() ? "" : " | ") + entry.name;
  }
  ASSERT_NE(find_key("mill.diameter"), nullptr);
  ASSERT_NE(find_key("contact.law"), nullptr);
  EXPECT_EQ(find_key("contact.law")->type, laws);
  ASSERT_NE(find_key("walls.NAME.kind"), nullptr);
  EXPECT_EQ(find_key("walls.NAME.kind")->type, walls);
}

}  // namespace
}  // namespace quern
