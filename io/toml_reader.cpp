// toml++ behind a plain tree; the scan for what it cannot bear; spelling suggestions.
#include "io/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <tuple>

#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 0
#endif
#include <toml++/toml.h>

namespace quern {
namespace {

Place place_of(const toml::source_region& source) {
  Place place;
  if (source.begin) {
    place.line = static_cast<int>(source.begin.line);
    place.column = static_cast<int>(source.begin.column);
  }
  return place;
}

Node copy_node(const toml::node& from);

void copy_table(const toml::table& from, Node& to) {
  to.kind = NodeKind::kTable;
  for (const auto& [key, value] : from)
    to.entries.push_back({std::string(key.str()), place_of(key.source()), copy_node(value)});
  std::stable_sort(to.entries.begin(), to.entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.key_place.line, a.key_place.column) <
           std::tie(b.key_place.line, b.key_place.column);
  });
}

Node copy_node(const toml::node& from) {
  Node to;
  to.place = place_of(from.source());
  switch (from.type()) {
    case toml::node_type::table:
      copy_table(*from.as_table(), to);
      break;
    case toml::node_type::array:
      to.kind = NodeKind::kArray;
      for (const auto& item : *from.as_array()) to.items.push_back(copy_node(item));
      break;
    case toml::node_type::string:
      to.kind = NodeKind::kString;
      to.text = from.as_string()->get();
      break;
    case toml::node_type::integer:
      to.kind = NodeKind::kInteger;
      to.integer = from.as_integer()->get();
      break;
    case toml::node_type::floating_point:
      to.kind = NodeKind::kFloat;
      to.number = from.as_floating_point()->get();
      break;
    case toml::node_type::boolean:
      to.kind = NodeKind::kBool;
      to.flag = from.as_boolean()->get();
      break;
    default:
      to.kind = NodeKind::kDate;
  }
  return to;
}

// Walks over TOML text, knows whether it is in a comment, a string or an array, and reports what
// toml++ 3.3.0 must not see: non-ASCII letters outside strings, table headers without a name
// ("[="), and brackets closed by braces.
class TextScan {
 public:
  TextScan(std::string_view text, Messages& messages) : text_(text), messages_(messages) {}

  void run() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a byte order mark is allowed
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        while (at_ < text_.size() && text_[at_] != '\n') step();
      } else if (c == '"' || c == '\'') {
        line_begun_ = true;
        skip_string(c);
      } else if (static_cast<unsigned char>(c) >= 0x80) {
        line_begun_ = true;
        report_letters();
      } else {
        if (c == '[' && open_.empty() && !line_begun_) check_header();
        track_brackets(c);
        if (c != ' ' && c != '\t') line_begun_ = c != '\n';
        step();
      }
    }
  }

 private:
  static bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

  void step() {
    const char c = text_[at_++];
    if (c == '\n') {
      ++line_;
      column_ = 1;
    } else if (!continues(c)) {
      ++column_;
    }
  }

  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool multiline = text_.substr(at_).starts_with(three);
    for (int i = 0; i < (multiline ? 3 : 1); ++i) step();
    while (at_ < text_.size()) {
      if (multiline ? text_.substr(at_).starts_with(three) : text_[at_] == quote) {
        for (int i = 0; i < (multiline ? 3 : 1); ++i) step();
        // Up to two more quotes belong to the text before the closing three.
        for (int i = 0; multiline && i < 2 && at_ < text_.size() && text_[at_] == quote; ++i)
          step();
        return;
      }
      if (!multiline && text_[at_] == '\n') return;  // not closed: the parser says so
      if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size()) step();
      step();
    }
  }

  void track_brackets(char c) {
    if (c == '[' || c == '{') open_ += c;
    if ((c != ']' && c != '}') || open_.empty()) return;
    if (open_.back() != (c == ']' ? '[' : '{'))
      messages_.error({line_, column_, -1},
                      fmt::format("syntax: '{}' cannot close '{}'", c, open_.back()));
    open_.pop_back();
  }

  void check_header() {
    std::size_t next = at_ + (text_.substr(at_).starts_with("[[") ? 2 : 1);
    while (next < text_.size() && (text_[next] == ' ' || text_[next] == '\t')) ++next;
    if (next == text_.size()) return;  // the parser says so
    const char c = text_[next];
    if (!std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 0x80 &&
        std::string_view("_-\"']").find(c) == std::string_view::npos)
      messages_.error({line_, column_, -1}, "syntax: a table header needs a name, as in [mill]");
  }

  // One message for a run of such letters.
  void report_letters() {
    const Place place{line_, column_, -1};
    const std::size_t begin = at_;
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) >= 0x80) step();
    messages_.error(place, fmt::format("'{}' may only stand in a string or a comment (keys and "
                                       "numbers are plain ASCII)",
                                       text_.substr(begin, at_ - begin)));
  }

  std::string_view text_;
  Messages& messages_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  std::string open_;         // brackets and braces that are not closed yet
  bool line_begun_ = false;  // something but blanks stood in this line
};

// The parser's words in ours.
std::string syntax_text(const std::string& what) {
  const std::string lead = "Error while parsing ";
  if (what.find("unescaped control characters") != std::string::npos)
    return "syntax: a string is not closed in its line, or holds a control character";
  return "syntax: " + (what.starts_with(lead) ? what.substr(lead.size()) : what);
}

// Edit distance where a swap of neighbours counts once.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

Entry* Node::find_entry(std::string_view key) {
  for (Entry& entry : entries)
    if (entry.key == key) return &entry;
  return nullptr;
}

Node* Node::find(std::string_view key) {
  Entry* entry = find_entry(key);
  return entry ? &entry->value : nullptr;
}

const Node* Node::find(std::string_view key) const { return const_cast<Node*>(this)->find(key); }

Node& Node::set(std::string_view key, Node value) {
  if (Entry* present = find_entry(key)) {
    present->key_place = value.place;
    present->value = std::move(value);
    return present->value;
  }
  Entry entry{std::string(key), value.place, {}};
  entry.value = std::move(value);
  entries.push_back(std::move(entry));
  return entries.back().value;
}

void Node::erase(std::string_view key) {
  std::erase_if(entries, [&](const Entry& entry) { return entry.key == key; });
}

void Messages::error(const Place& place, const std::string& text) {
  errors_.push_back({place, "error: " + text});
}

void Messages::warning(const Place& place, const std::string& text) {
  warnings_.push_back({place, text});
}

void Messages::other_file(const std::string& line) {
  if (std::find(other_files_.begin(), other_files_.end(), line) == other_files_.end())
    other_files_.push_back(line);
}

std::string Messages::prefix(const Place& place) const {
  if (place.override_index >= 0)
    return "--set " + overrides_[static_cast<std::size_t>(place.override_index)];
  return fmt::format("{}:{}:{}", file_, place.line, place.column);
}

std::vector<std::string> Messages::sorted(std::vector<Message> messages) const {
  std::stable_sort(messages.begin(), messages.end(), [](const Message& a, const Message& b) {
    const Place &p = a.place, &q = b.place;
    if (p.override_index >= 0 || q.override_index >= 0) return p.override_index < q.override_index;
    return std::tie(p.line, p.column) < std::tie(q.line, q.column);
  });
  std::vector<std::string> lines;
  for (const Message& message : messages) {
    std::string line = prefix(message.place) + ": " + message.text;
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> Messages::errors() const {
  std::vector<std::string> lines = sorted(errors_);
  lines.insert(lines.end(), other_files_.begin(), other_files_.end());
  return lines;
}

Node parse_toml(const std::string& text, Messages& messages) {
  Node root;
  TextScan(text, messages).run();
  if (messages.any_error()) return root;
  try {
    const toml::table table = toml::parse(std::string_view(text));
    copy_table(table, root);
  } catch (const toml::parse_error& problem) {
    messages.error(place_of(problem.source()), syntax_text(std::string(problem.description())));
  }
  return root;
}

Node parse_override_value(const std::string& text, int override_index) {
  struct Mark {
    int index;
    void operator()(Node& node) const {
      node.place.override_index = index;
      for (Node& item : node.items) (*this)(item);
      for (Entry& entry : node.entries) {
        entry.key_place.override_index = index;
        (*this)(entry.value);
      }
    }
  };
  Node node;
  node.kind = NodeKind::kString;
  node.text = text;
  Messages ignored("", {});
  if (text.find('\n') == std::string::npos) {
    const Node table = parse_toml("value = " + text + "\n", ignored);
    if (!ignored.any_error() && table.find("value")) node = *table.find("value");
  }
  Mark{override_index}(node);
  if (node.kind != NodeKind::kArray && node.kind != NodeKind::kTable && node.text.empty())
    node.text = text;
  return node;
}

const char* describe(NodeKind kind) {
  switch (kind) {
    case NodeKind::kTable:
      return "a table";
    case NodeKind::kArray:
      return "an array";
    case NodeKind::kString:
      return "a string";
    case NodeKind::kInteger:
      return "an integer";
    case NodeKind::kFloat:
      return "a number";
    case NodeKind::kBool:
      return "true or false";
    default:
      return "a date";
  }
}

std::string closest(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  if (word.size() > 60) return best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t d = distance(word, candidate);
    if (d >= least || d >= candidate.size()) continue;
    least = d;
    best = candidate;
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates,
                         char quote) {
  const std::string best = closest(word, candidates);
  return best.empty() ? "" : fmt::format(" - did you mean {}{}{}?", quote, best, quote);
}

}  // namespace quern
