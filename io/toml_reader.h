// A TOML text as a tree that knows where everything stands, and the messages about it.
//
// toml_reader.cpp is the only code that includes toml++. It copies the parsed document into plain
// nodes, tables in the order of the file, so that command-line overrides can be laid into the same
// tree and the scene reader needs no library. toml++ 3.3.0 runs into undefined behaviour on bare
// non-ASCII letters, on headers like "[=" and on "[1, }" (found by fuzzing), so these are refused
// before it sees the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quern {

// Where a node comes from: line and column (in characters, from 1) of the file, or an override.
struct Place {
  int line = 1, column = 1;
  int override_index = -1;  // >= 0: came from this --set, line and column mean nothing
};

enum class NodeKind { kTable, kArray, kString, kInteger, kFloat, kBool, kDate };

struct Entry;

struct Node {
  NodeKind kind = NodeKind::kTable;
  std::string text;            // kString; of an override also what was typed for a number
  long long integer = 0;       // kInteger
  double number = 0;           // kFloat
  bool flag = false;           // kBool
  std::vector<Node> items;     // kArray
  std::vector<Entry> entries;  // kTable, in the order of the file
  Place place;

  const Node* find(std::string_view key) const;
  Node* find(std::string_view key);
  Entry* find_entry(std::string_view key);
  Node& set(std::string_view key, Node value);  // replaces or appends
  void erase(std::string_view key);
};

struct Entry {
  std::string key;
  Place key_place;
  Node value;
};

// Collects what is wrong; nothing is thrown, reading goes on.
class Messages {
 public:
  Messages(std::string file, std::vector<std::string> overrides)
      : file_(std::move(file)), overrides_(std::move(overrides)) {}
  void error(const Place& place, const std::string& text);
  void warning(const Place& place, const std::string& text);
  void other_file(const std::string& line);  // complete, as it is; once, if several say it
  bool any_error() const { return !errors_.empty() || !other_files_.empty(); }
  // In the order of the file, then overrides, then what is wrong in other files.
  std::vector<std::string> errors() const;
  // Without the word "warning", which log_warn() puts before them.
  std::vector<std::string> warnings() const { return sorted(warnings_); }
  // How a message about this place begins: file:line:column, or the override.
  std::string prefix(const Place& place) const;

 private:
  struct Message {
    Place place;
    std::string text;
  };
  std::vector<std::string> sorted(std::vector<Message> messages) const;

  std::string file_;
  std::vector<std::string> overrides_;
  std::vector<Message> errors_, warnings_;
  std::vector<std::string> other_files_;
};

// The document as a table; on a syntax error an empty table and a message.
Node parse_toml(const std::string& text, Messages& messages);

// One value as it may stand on a command line: TOML, or else the bare text as a string.
Node parse_override_value(const std::string& text, int override_index);

// "string", "integer" ... with its article, for messages.
const char* describe(NodeKind kind);

// The candidate that `word` was most likely meant to be, or "" if none is near.
std::string closest(std::string_view word, const std::vector<std::string>& candidates);
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates,
                         char quote = '\'');

}  // namespace quern
