// Dotted keys to places in the tree; names of array entries.
#include "io/scene_overrides.h"

#include <fmt/format.h>

#include <algorithm>

namespace quern {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos) return parts;
    begin = end + 1;
  }
}

std::string string_at(const Node& table, std::string_view key) {
  const Node* node = table.find(key);
  return node && node->kind == NodeKind::kString ? node->text : "";
}

std::vector<std::string> names_in(const Node* list) {
  std::vector<std::string> names;
  if (list && list->kind == NodeKind::kArray)
    for (const Node& item : list->items) names.push_back(string_at(item, "name"));
  return names;
}

void name_entries(Node& root, const char* key, const char* source, const char* fallback) {
  Node* list = root.find(key);
  if (!list || list->kind != NodeKind::kArray) return;
  int number = 0;
  for (Node& item : list->items) {
    ++number;
    if (item.kind != NodeKind::kTable || item.find("name")) continue;
    std::string base = source ? string_at(item, source) : "";
    std::string name = base.empty() ? fmt::format("{}_{}", fallback, number) : base;
    const std::vector<std::string> taken = names_in(list);
    for (int n = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++n)
      name = fmt::format("{}_{}", base.empty() ? fallback : base, n);
    Node text;
    text.kind = NodeKind::kString;
    text.text = name;
    text.place = item.place;
    item.set("name", text);
  }
}

// The ways to say one thing of which a scene uses one: setting one drops the others.
constexpr const char* kAlternatives[][3] = {{"duration", "revolutions", ""},
                                            {"record_from", "record_from_revolution", ""},
                                            {"diameter", "equivalent_diameter", ""},
                                            {"mesh", "polyhedron_mesh", ""},
                                            {"count", "mass", "filling_level"}};

void drop_alternatives(Node& table, const std::string& key) {
  for (const auto& group : kAlternatives) {
    if (std::find(std::begin(group), std::end(group), key) == std::end(group)) continue;
    for (const char* other : group) {
      const Node* node = table.find(other);
      if (node && other != key && node->place.override_index < 0) table.erase(other);
    }
  }
}

Node string_node(const std::string& text, const Place& place) {
  Node node;
  node.kind = NodeKind::kString;
  node.text = text;
  node.place = place;
  return node;
}

class Override {
 public:
  Override(Node& root, Messages& messages, int index) : root_(root), messages_(messages) {
    place_.override_index = index;
  }

  void apply(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string key = text.substr(0, equals);
    if (equals == std::string::npos || key.empty() || equals + 1 == text.size())
      return fail("must be key=value, for example run.duration=2");
    const std::vector<std::string> parts = split(key, '.');
    for (const std::string& part : parts)
      if (part.empty()) return fail(fmt::format("'{}' is no dotted key", key));
    const Node value = parse_override_value(text.substr(equals + 1), place_.override_index);
    if (parts[0] == "particles" || parts[0] == "walls")
      set_in_entry(root_, parts, 0, value);
    else if (parts[0] == "record" && parts.size() > 1 && parts[1] == "zones")
      set_in_zone(parts, value);
    else if (parts[0] == "contact" && parts.size() == 3)
      set_in_pair(parts, value);
    else
      set_below(root_, parts, 0, value);
  }

 private:
  void fail(const std::string& what) { messages_.error(place_, what); }

  void set_below(Node& table, const std::vector<std::string>& parts, std::size_t at,
                 const Node& value) {
    if (table.kind != NodeKind::kTable)
      return fail(fmt::format("'{}' is {}, not a table", parts[at - 1], describe(table.kind)));
    if (at + 1 == parts.size()) {
      drop_alternatives(table, parts[at]);
      table.set(parts[at], value);
      return;
    }
    Node* next = table.find(parts[at]);
    if (!next) {
      Node fresh;
      fresh.place = place_;
      next = &table.set(parts[at], fresh);
    }
    set_below(*next, parts, at + 1, value);
  }

  void set_in_zone(const std::vector<std::string>& parts, const Node& value) {
    Node none;
    Node* record = root_.find("record");
    set_in_entry(record ? *record : none, parts, 1, value);
  }

  // parts[at] is the list in `table`, parts[at + 1] the entry's name.
  void set_in_entry(Node& table, const std::vector<std::string>& parts, std::size_t at,
                    const Node& value) {
    if (parts.size() < at + 3)
      return fail(fmt::format("address an entry by its name: {}.NAME.key=value",
                              at == 0 ? parts[0] : "record.zones"));
    Node* list = table.find(parts[at]);
    const std::vector<std::string> names = names_in(list);
    const auto found = std::find(names.begin(), names.end(), parts[at + 1]);
    if (found == names.end())
      return fail(fmt::format("no {} named '{}'{} ({})", parts[at], parts[at + 1],
                              did_you_mean(parts[at + 1], names),
                              names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    set_below(list->items[static_cast<std::size_t>(found - names.begin())], parts, at + 2, value);
  }

  void set_in_pair(const std::vector<std::string>& parts, const Node& value) {
    std::vector<std::string> materials;
    if (const Node* table = root_.find("materials"))
      for (const Entry& entry : table->entries) materials.push_back(entry.key);
    for (const std::string& a : materials)
      for (const std::string& b : materials)
        if (parts[1] == a + "-" + b) return set_below(pair_of(a, b), parts, 2, value);
    fail(fmt::format("'{}' is no pair of materials, write contact.A-B.key=value with two of ({})",
                     parts[1], fmt::join(materials, ", ")));
  }

  // The entry of [[contact.pair]], made if there is none.
  Node& pair_of(const std::string& a, const std::string& b) {
    Node table;
    table.place = place_;
    Node* contact = root_.find("contact");
    if (!contact) contact = &root_.set("contact", table);
    Node* list = contact->find("pair");
    if (!list) {
      Node array;
      array.kind = NodeKind::kArray;
      array.place = place_;
      list = &contact->set("pair", array);
    }
    for (Node& pair : list->items) {
      const Node* between = pair.find("between");
      if (!between || between->items.size() != 2) continue;
      const std::string &c = between->items[0].text, &d = between->items[1].text;
      if ((a == c && b == d) || (a == d && b == c)) return pair;
    }
    Node between;
    between.kind = NodeKind::kArray;
    between.place = place_;
    between.items = {string_node(a, place_), string_node(b, place_)};
    table.set("between", between);
    list->items.push_back(table);
    return list->items.back();
  }

  Node& root_;
  Messages& messages_;
  Place place_;
};

}  // namespace

void give_names(Node& root) {
  name_entries(root, "particles", "material", "particles");
  name_entries(root, "walls", nullptr, "wall");
  if (Node* record = root.find("record"); record && record->kind == NodeKind::kTable)
    name_entries(*record, "zones", nullptr, "zone");
}

void apply_overrides(Node& root, const std::vector<std::string>& overrides, Messages& messages) {
  for (std::size_t i = 0; i < overrides.size(); ++i)
    Override(root, messages, static_cast<int>(i)).apply(overrides[i]);
}

}  // namespace quern
