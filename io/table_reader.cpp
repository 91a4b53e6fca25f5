// Values out of a TOML table, one by one, and what can be wrong with each.
#include "io/table_reader.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <limits>

namespace quern {
namespace {

// "particles[2].sizes[0]" -> "particles.sizes"
std::string without_indices(const std::string& path) {
  std::string plain;
  bool inside = false;
  for (const char c : path) {
    if (c == '[') inside = true;
    if (!inside) plain += c;
    if (c == ']') inside = false;
  }
  return plain;
}

// The table as its header would stand in a file.
std::string label_of(const std::string& path) {
  if (path.empty()) return "the file";
  const std::string plain = without_indices(path);
  return path.ends_with(']') ? "[[" + plain + "]]" : "[" + plain + "]";
}

std::string quoted(const Node& node) {
  switch (node.kind) {
    case NodeKind::kString:
      return "\"" + node.text + "\"";
    case NodeKind::kInteger:
      return std::to_string(node.integer);
    case NodeKind::kFloat:
      return format_number(node.number);
    default:
      return describe(node.kind);
  }
}

std::string list_of(Words words) {
  std::string list;
  for (const char* word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  return list;
}

std::vector<std::string> strings_of(Words words) { return {words.begin(), words.end()}; }

bool in_range(double value, Range range) {
  switch (range) {
    case Range::kPositive:
      return value > 0;
    case Range::kNotNegative:
      return value >= 0;
    case Range::kFraction:
      return value > 0 && value <= 1;
    case Range::kShare:
      return value >= 0 && value <= 1;
    case Range::kPoisson:
      return value >= 0 && value <= 0.5;
    case Range::kAcute:
      return value >= 0 && value < kPi / 2;
    default:
      return true;
  }
}

const char* range_text(Range range) {
  switch (range) {
    case Range::kPositive:
      return "must be greater than 0";
    case Range::kNotNegative:
      return "must not be negative";
    case Range::kFraction:
      return "must be greater than 0 and at most 1";
    case Range::kShare:
      return "must be between 0 and 1";
    case Range::kPoisson:
      return "must be between 0 and 0.5";
    case Range::kAcute:
      return "must be at least 0 deg and less than 90 deg";
    default:
      return "";
  }
}

struct PointRow {
  double time = 0, value = 0;
  Dimension dimension = Dimension::kNumber;
};

void fields(TableReader& io, PointRow& row) {
  io({"time", "s", Dimension::kTime, Range::kAny, Need::kRequired}, row.time);
  io({"value", "rate", row.dimension, Range::kAny, Need::kRequired}, row.value);
}

}  // namespace

Place Trace::place(std::string path) const {
  while (true) {
    const auto found = places_.find(path);
    if (found != places_.end()) return found->second;
    const std::size_t cut = path.find_last_of(".[");
    if (cut == std::string::npos) return {};
    path.resize(cut);
  }
}

TableReader::TableReader(ReadContext& context, const Node* table, std::string path)
    : context_(context), table_(table), path_(std::move(path)) {
  if (!path_.empty()) context_.trace.note(path_, table_->place);
}

const Node* TableReader::fetch(const Key& key) {
  asked_.emplace_back(key.name);
  const Node* node = table_->find(key.name);
  if (node)
    context_.trace.note(member(key), node->place);
  else if (key.need == Need::kRequired)
    missing_.push_back(key);
  return node;
}

const Node* TableReader::fetch(const Key& key, NodeKind kind) {
  const Node* node = fetch(key);
  if (!node || node->kind == kind) return node;
  const bool typed = node->place.override_index >= 0 && !node->text.empty();
  if (kind == NodeKind::kString && typed) return node;  // --set run.title=2
  std::string hint;
  if (kind == NodeKind::kTable) hint = fmt::format(": write {}", label_of(member(key)));
  if (kind == NodeKind::kArray && node->kind == NodeKind::kTable)
    hint = fmt::format(": write [{}]", label_of(member(key)));
  fail(key, *node,
       fmt::format("'{}' must be {}{}, found {}", key.name, describe(kind), hint,
                   describe(node->kind)));
  return nullptr;
}

bool TableReader::is_row(const Key& key, const Node& node, const std::string& path) {
  if (node.kind == NodeKind::kTable) return true;
  context_.error(path, node.place,
                 fmt::format("'{}' must hold tables, found {}", key.name, describe(node.kind)));
  context_.trace.spoil(member(key));
  return false;
}

bool TableReader::check_range(const Key& key, const Node& node, double value) {
  if (in_range(value, key.range)) return true;
  fail(key, node,
       fmt::format("'{}': {} is not allowed ({})", key.name, quoted(node), range_text(key.range)));
  return false;
}

bool TableReader::read_quantity(const Key& key, const Node& node, double& value) {
  const bool plain = key.dimension == Dimension::kNumber;
  const bool unit_free = plain || key.dimension == Dimension::kShare;
  const bool number = node.kind == NodeKind::kInteger || node.kind == NodeKind::kFloat;
  const double given =
      node.kind == NodeKind::kInteger ? static_cast<double>(node.integer) : node.number;
  if (number && !std::isfinite(given)) {
    fail(key, node, fmt::format("'{}' must be finite", key.name));
  } else if (number && (unit_free || node.place.override_index >= 0)) {
    value = given;
    return true;
  } else if (number) {
    fail(key, node,
         fmt::format("'{}' needs a unit, for example \"{}\"", key.name,
                     example_of(key.dimension, given)));
  } else if (node.kind == NodeKind::kString && !plain) {
    const QuantityResult result = parse_quantity(node.text, key.dimension);
    value = result.value;
    if (result.error.empty()) return true;
    const char* colon = result.error.starts_with("needs") ? "" : ":";
    fail(key, node, fmt::format("'{}'{} {}", key.name, colon, result.error));
  } else {
    const std::string wanted = plain ? std::string("a number")
                                     : fmt::format("a string with a unit, for example \"{}\"",
                                                   example_of(key.dimension, 1));
    fail(key, node,
         fmt::format("'{}' must be {}, found {}", key.name, wanted, describe(node.kind)));
  }
  return false;
}

void TableReader::operator()(const Key& key, double& value) {
  const Node* node = fetch(key);
  double read = 0;
  if (node && read_quantity(key, *node, read) && check_range(key, *node, read)) value = read;
}

void TableReader::operator()(const Key& key, std::string& value) {
  const Node* node = fetch(key, NodeKind::kString);
  if (!node) return;
  if (node->text.empty())
    fail(key, *node, fmt::format("'{}' must not be empty", key.name));
  else
    value = node->text;
}

void TableReader::operator()(const Key& key, bool& value) {
  const Node* node = fetch(key, NodeKind::kBool);
  if (node) value = node->flag;
}

template <class T>
void TableReader::read_whole(const Key& key, T& value) {
  const Node* node = fetch(key);
  if (!node) return;
  if (node->kind != NodeKind::kInteger) {
    fail(key, *node,
         fmt::format("'{}' must be an integer, found {}", key.name,
                     node->kind == NodeKind::kFloat ? quoted(*node) : describe(node->kind)));
    return;
  }
  if (!check_range(key, *node, static_cast<double>(node->integer))) return;
  const long long most =
      sizeof(T) < 8 ? std::numeric_limits<T>::max() : std::numeric_limits<long long>::max();
  if (node->integer > most)
    fail(key, *node,
         fmt::format("'{}': {} is too large (at most {})", key.name, node->integer, most));
  else
    value = static_cast<T>(node->integer);
}

template void TableReader::read_whole(const Key&, int&);
template void TableReader::read_whole(const Key&, long&);
template void TableReader::read_whole(const Key&, Index&);
template void TableReader::read_whole(const Key&, std::uint64_t&);

bool TableReader::read_vector(const Key& key, const Node& node, Vec3& value) {
  if (node.kind != NodeKind::kArray || node.items.size() != 3) {
    const std::string found = node.kind == NodeKind::kArray
                                  ? fmt::format("{} values", node.items.size())
                                  : std::string(describe(node.kind));
    fail(key, node, fmt::format("'{}' must be an array of 3 values, found {}", key.name, found));
    return false;
  }
  bool good = true;
  for (int k = 0; k < 3; ++k)
    good = read_quantity(key, node.items[static_cast<std::size_t>(k)], value[k]) && good;
  return good;
}

void TableReader::operator()(const Key& key, Vec3& value) {
  const Node* node = fetch(key);
  Vec3 read = Vec3::Zero();
  if (node && read_vector(key, *node, read)) value = read;
}

void TableReader::operator()(const Key& key, std::optional<Vec3>& value) {
  Vec3 read = Vec3::Zero();
  (*this)(key, read);
  if (usable(key)) value = read;
}

void TableReader::operator()(const Key& key, Schedule& value) {
  if (const Node* node = fetch(key)) read_schedule(key, *node, value);
}

void TableReader::read_schedule(const Key& key, const Node& node, Schedule& value) {
  const Node* list = &node;
  if (node.kind == NodeKind::kTable && node.find("schedule") && node.entries.size() == 1)
    list = node.find("schedule");
  if (list->kind != NodeKind::kArray) {
    double rate = 0;
    if (read_quantity(key, *list, rate)) value.points = {{0, rate}};
    return;
  }
  Schedule read;
  read.points.clear();
  for (const Node& item : list->items) {
    const std::string path = fmt::format("{}[{}]", member(key), read.points.size());
    if (!is_row(key, item, path)) return;
    PointRow row;
    row.dimension = key.dimension;
    read_table(&item, path, row);
    if (!read.points.empty() && row.time <= read.points.back().time)
      context_.error(member(key), item.place,
                     fmt::format("'{}': the times of a schedule must increase", key.name));
    read.points.push_back({row.time, row.value});
  }
  if (read.points.empty())
    fail(key, node, fmt::format("'{}': a schedule needs at least one {{ time, value }}", key.name));
  else
    value = read;
}

void TableReader::read_word(const Key& key, Words words, int& value) {
  const Node* node = fetch(key, NodeKind::kString);
  if (!node) return;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (node->text == words[i]) {
      value = static_cast<int>(i);
      return;
    }
  fail(key, *node,
       fmt::format("'{}': \"{}\" is not known{} ({})", key.name, node->text,
                   did_you_mean(node->text, strings_of(words), '"'), list_of(words)));
}

void TableReader::word_or_quantity(const Key& key, Words words, int, double& value,
                                   const std::function<void(int)>& choose) {
  const Node* node = table_->find(key.name);
  double ignored = 0;
  const std::string text = node && node->kind == NodeKind::kString ? node->text : "";
  const bool is_word = !text.empty() &&
                       std::string_view("0123456789+-.").find(text[0]) == std::string_view::npos &&
                       !parse_number(text, ignored);
  if (is_word) {
    int word = -1;
    read_word(key, words, word);
    if (word >= 0) choose(word);
  } else {
    (*this)(key, value);
    if (usable(key)) choose(-1);
  }
}

void TableReader::texts(const Key& key, std::vector<std::string>& value) {
  const Node* node = table_->find(key.name);
  if (!node || node->kind != NodeKind::kArray) {
    std::string text;
    (*this)(key, text);
    if (!text.empty()) value = {text};
    return;
  }
  fetch(key);
  if (node->items.empty()) fail(key, *node, fmt::format("'{}' must not be empty", key.name));
  for (const Node& item : node->items) {
    context_.trace.note(fmt::format("{}[{}]", member(key), value.size()), item.place);
    if (item.kind == NodeKind::kString && !item.text.empty())
      value.push_back(item.text);
    else
      fail(key, item, fmt::format("'{}' must hold texts, found {}", key.name, quoted(item)));
  }
}

void TableReader::axes(const Key& key, bool (&value)[3]) {
  const Node* node = fetch(key, NodeKind::kArray);
  if (!node) return;
  for (const Node& item : node->items) {
    const bool axis = item.kind == NodeKind::kString && item.text.size() == 1 &&
                      item.text[0] >= 'x' && item.text[0] <= 'z';
    if (axis)
      value[item.text[0] - 'x'] = true;
    else
      fail(key, item,
           fmt::format("'{}': {} is no axis (\"x\", \"y\", \"z\")", key.name, quoted(item)));
  }
}

void TableReader::pair(const Key& key, std::string& a, std::string& b) {
  const Node* node = fetch(key, NodeKind::kArray);
  if (!node) return;
  const std::vector<Node>& items = node->items;
  if (items.size() == 2 && items[0].kind == NodeKind::kString &&
      items[1].kind == NodeKind::kString) {
    a = items[0].text;
    b = items[1].text;
  } else {
    fail(key, *node,
         fmt::format("'{}' must name two materials, for example [\"ore\", \"steel\"]", key.name));
  }
}

void TableReader::passing(const Key& key, std::vector<std::pair<double, double>>& value) {
  const Node* node = fetch(key, NodeKind::kArray);
  if (!node) return;
  const Key diameter{key.name, "", Dimension::kLength, Range::kPositive};
  const Key share{key.name, "", Dimension::kShare, Range::kShare};
  for (const Node& row : node->items) {
    std::pair<double, double> point;
    if (row.kind != NodeKind::kArray || row.items.size() != 2) {
      fail(key, row,
           fmt::format("'{}' must hold rows of [diameter, share passing], for example [\"10 mm\", "
                       "0.1]",
                       key.name));
    } else if (read_quantity(diameter, row.items[0], point.first) &&
               check_range(diameter, row.items[0], point.first) &&
               read_quantity(share, row.items[1], point.second) &&
               check_range(share, row.items[1], point.second)) {
      if (!value.empty() &&
          (point.first <= value.back().first || point.second < value.back().second))
        fail(key, row,
             fmt::format("'{}': diameters must increase, shares must not fall", key.name));
      value.push_back(point);
    }
  }
}

void TableReader::named(const Key& key, std::vector<Material>& value) {
  const Node* node = fetch(key, NodeKind::kTable);
  if (!node) return;
  for (const Entry& entry : node->entries) {
    const std::string path = member(key) + "." + entry.key;
    if (!is_row(key, entry.value, path)) continue;
    Material material;
    material.name = entry.key;
    read_table(&entry.value, path, material);
    value.push_back(material);
  }
}

// Reports an unknown key; true if it is likely a misspelt required one.
bool TableReader::spell_out(const Entry& entry) {
  const std::string plain = without_indices(path_.empty() ? entry.key : path_ + "." + entry.key);
  const std::string meant = closest(entry.key, asked_);
  std::string hint = meant.empty() ? "" : fmt::format(" - did you mean '{}'?", meant);
  if (meant.empty()) {
    std::string home;
    for (const std::string& path : context_.all_paths)
      if (path.ends_with("." + entry.key)) home = home.empty() ? path : "several";
    if (!home.empty() && home != "several") hint = fmt::format(" here - it is '{}'", home);
  }
  std::string name = entry.key.substr(0, 60);
  context_.messages.error(entry.key_place, fmt::format("unknown key '{}'{}", name, hint));
  if (meant.empty()) return false;
  context_.trace.spoil(path_.empty() ? meant : path_ + "." + meant);
  return true;
}

void TableReader::finish() {
  for (const Entry& entry : table_->entries) {
    bool known = false;
    for (const std::string& key : asked_) known = known || key == entry.key;
    if (!known) spell_out(entry);
  }
  for (const Key& key : missing_) {
    if (context_.trace.spoiled(member(key))) continue;
    context_.error(member(key), table_->place,
                   fmt::format("{} needs '{}' ({})", label_of(path_), key.name, key.doc));
  }
}

}  // namespace quern
