// TableReader: takes values out of one TOML table, marks the keys it was asked for, and reports the
// rest.
//
// It is the reading `Io` of scene_fields.h. A wrong value leaves the default in place and spoils
// its path, so that later checks do not complain about what follows from it. Paths are as in
// "particles[1].sizes[0].from"; the Trace remembers where each value stood.
#pragma once

#include <concepts>
#include <functional>
#include <map>
#include <set>
#include <type_traits>

#include "io/scene_fields.h"
#include "io/toml_reader.h"

namespace quern {

class Trace {
 public:
  void note(const std::string& path, const Place& place) { places_[path] = place; }
  void spoil(const std::string& path) { spoiled_.insert(path); }
  bool given(const std::string& path) const { return places_.count(path) > 0; }
  bool spoiled(const std::string& path) const { return spoiled_.count(path) > 0; }
  Place place(std::string path) const;  // of the path or of the nearest table around it

 private:
  std::map<std::string, Place> places_;
  std::set<std::string> spoiled_;
};

struct ReadContext {
  Messages& messages;
  Trace trace;
  std::vector<std::string> all_paths;  // of every scene key, for suggestions

  void error(const std::string& path, const Place& place, const std::string& text) {
    trace.spoil(path);
    messages.error(place, text);
  }
};

class TableReader {
 public:
  static constexpr bool kWantsAll = true;

  TableReader(ReadContext& context, const Node* table, std::string path);  // table: not null

  void operator()(const Key& key, std::string& value);
  void operator()(const Key& key, double& value);
  void operator()(const Key& key, bool& value);
  void operator()(const Key& key, Vec3& value);
  void operator()(const Key& key, Schedule& value);
  void operator()(const Key& key, int& value) { read_whole(key, value); }
  void operator()(const Key& key, long& value) { read_whole(key, value); }
  void operator()(const Key& key, Index& value) { read_whole(key, value); }
  void operator()(const Key& key, std::uint64_t& value) { read_whole(key, value); }

  template <class E>
  requires std::is_enum_v<E>
  void operator()(const Key& key, E& value) {
    int word = static_cast<int>(value);
    read_word(key, words_of(E{}), word);
    value = static_cast<E>(word);
  }
  template <class T>
  void operator()(const Key& key, std::optional<T>& value) {
    T read{};
    (*this)(key, read);
    if (usable(key)) value = read;
  }
  void operator()(const Key& key, std::optional<Vec3>& value);

  void word_or_quantity(const Key& key, Words words, int present, double& value,
                        const std::function<void(int)>& choose);
  void texts(const Key& key, std::vector<std::string>& value);  // one text, or a list of them
  void axes(const Key& key, bool (&value)[3]);
  void pair(const Key& key, std::string& a, std::string& b);
  void passing(const Key& key, std::vector<std::pair<double, double>>& value);

  template <class T>
  void table(const Key& key, T& value) {
    const Node* node = fetch(key, NodeKind::kTable);
    if (node) read_table(node, member(key), value);
  }
  template <class T>
  void table(const Key& key, std::optional<T>& value) {
    const Node* node = fetch(key, NodeKind::kTable);
    if (node) read_table(node, member(key), value.emplace());
  }
  template <class T>
  void rows(const Key& key, std::vector<T>& value) {
    const Node* node = fetch(key, NodeKind::kArray);
    if (!node) return;
    for (std::size_t i = 0; i < node->items.size(); ++i) {
      const std::string path = member(key) + "[" + std::to_string(i) + "]";
      if (!is_row(key, node->items[i], path)) continue;
      read_table(&node->items[i], path, value.emplace_back());
    }
  }
  template <class T>
  void tables(const Key& key, std::vector<T>& value) {
    rows(key, value);
  }
  void named(const Key& key, std::vector<Material>& value);

  // What stands there, for values of many kinds; null: nothing.
  const Node* raw(const Key& key) { return fetch(key); }

  // Reports the keys nobody asked for and the required ones that are not there.
  void finish();

 private:
  std::string member(const Key& key) const {
    return path_.empty() ? key.name : path_ + "." + key.name;
  }
  bool usable(const Key& key) const {
    return context_.trace.given(member(key)) && !context_.trace.spoiled(member(key));
  }
  void fail(const Key& key, const Node& node, const std::string& what) {
    context_.error(member(key), node.place, what);
  }
  const Node* fetch(const Key& key);
  const Node* fetch(const Key& key, NodeKind kind);
  bool is_row(const Key& key, const Node& node, const std::string& path);
  bool read_quantity(const Key& key, const Node& node, double& value);
  bool read_vector(const Key& key, const Node& node, Vec3& value);
  void read_schedule(const Key& key, const Node& node, Schedule& value);
  bool check_range(const Key& key, const Node& node, double value);
  void read_word(const Key& key, Words words, int& value);
  template <class T>
  void read_whole(const Key& key, T& value);
  bool spell_out(const Entry& entry);

  template <class T>
  void read_table(const Node* node, const std::string& path, T& value) {
    TableReader reader(context_, node, path);
    fields(reader, value);
    reader.finish();
  }

  ReadContext& context_;
  const Node* table_;
  std::string path_;
  std::vector<std::string> asked_;
  std::vector<Key> missing_;
};

}  // namespace quern
