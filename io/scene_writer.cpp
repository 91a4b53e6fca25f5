// A scene back to TOML, and the list of all keys: the two other users of scene_fields.h.
#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <concepts>
#include <filesystem>
#include <functional>

#include "io/scene_fields.h"
#include "io/scene_reader.h"

namespace quern {
namespace {

std::string quote(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + "\"";
}

// Whole numbers stand as integers, unless they are too large for TOML's.
std::string value_text(const Key& key, double value) {
  const std::string text = format_quantity(value, key.dimension);
  if (si_unit(key.dimension)[0]) return quote(text);
  return std::abs(value) < 1e15 || text.find_first_of(".e") != std::string::npos ? text
                                                                                 : text + ".0";
}

std::string value_text(const Key& key, const Vec3& v) {
  return fmt::format("[{}, {}, {}]", value_text(key, v.x()), value_text(key, v.y()),
                     value_text(key, v.z()));
}

std::string value_text(const Key& key, const Schedule& schedule) {
  if (schedule.points.size() == 1 && schedule.points[0].time == 0)
    return value_text(key, schedule.points[0].value);
  const Key time{"time", "", Dimension::kTime};
  std::string rows;
  for (const Schedule::Point& point : schedule.points)
    rows += fmt::format("{}{{ time = {}, value = {} }}", rows.empty() ? "" : ", ",
                        value_text(time, point.time), value_text(key, point.value));
  return "[" + rows + "]";
}

std::string value_text(const Key&, const std::string& value) { return quote(value); }
std::string value_text(const Key&, bool value) { return value ? "true" : "false"; }
template <std::integral T>
std::string value_text(const Key&, T value) {
  return std::to_string(value);
}
template <class E>
requires std::is_enum_v<E> std::string value_text(const Key&, E value) {
  return quote(words_of(value)[static_cast<std::size_t>(value)]);
}

std::string axes_text(const bool (&value)[3]) {
  std::string list;
  for (int k = 0; k < 3; ++k)
    if (value[k]) list += (list.empty() ? "\"" : ", \"") + std::string(1, "xyz"[k]) + "\"";
  return "[" + list + "]";
}

std::string passing_text(const std::vector<std::pair<double, double>>& rows) {
  const Key diameter{"", "", Dimension::kLength};
  std::string list;
  for (const auto& [size, share] : rows)
    list += fmt::format("{}[{}, {}]", list.empty() ? "" : ", ", value_text(diameter, size),
                        format_number(share));
  return "[" + list + "]";
}

// A word that TOML takes as a bare key, else quoted.
std::string key_text(const std::string& name) {
  for (const char c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') return quote(name);
  return name.empty() ? "\"\"" : name;
}

class SceneWriter {
 public:
  static constexpr bool kWantsAll = false;

  // Inline: "{ a = 1, b = 2 }" on one line instead of one line a key.
  enum class Style { kLines, kInline };

  SceneWriter(std::string& out, std::string path, Style style = Style::kLines)
      : out_(out), path_(std::move(path)), style_(style) {}

  template <class T>
  void operator()(const Key& key, const T& value) {
    put(key, value_text(key, value));
  }
  template <class T>
  void operator()(const Key& key, const std::optional<T>& value) {
    if (value) put(key, value_text(key, *value));
  }
  void operator()(const Key& key, const std::string& value) {
    if (!value.empty()) put(key, value_text(key, value));
  }
  void word_or_quantity(const Key& key, Words words, int present, double value,
                        const std::function<void(int)>&) {
    put(key,
        present < 0 ? value_text(key, value) : quote(words[static_cast<std::size_t>(present)]));
  }
  void texts(const Key& key, const std::vector<std::string>& value) {
    std::string list;
    for (const std::string& text : value) list += (list.empty() ? "" : ", ") + quote(text);
    if (!value.empty()) put(key, value.size() == 1 ? list : "[" + list + "]");
  }
  void axes(const Key& key, const bool (&value)[3]) { put(key, axes_text(value)); }
  void pair(const Key& key, const std::string& a, const std::string& b) {
    put(key, fmt::format("[{}, {}]", quote(a), quote(b)));
  }
  void passing(const Key& key, const std::vector<std::pair<double, double>>& value) {
    if (!value.empty()) put(key, passing_text(value));
  }
  template <class T>
  void table(const Key& key, T& value) {
    if (style_ == Style::kInline) return put(key, inline_text(value));
    out_ += fmt::format("\n[{}]\n", member(key));
    SceneWriter inner(out_, member(key));
    fields(inner, value);
  }
  template <class T>
  void table(const Key& key, std::optional<T>& value) {
    if (value) table(key, *value);
  }
  void table(const Key& key, SizeDistribution& value) { put(key, inline_text(value)); }
  void table(const Key& key, Motion& value) {
    if (value.kind != MotionKind::kFixed) put(key, inline_text(value));
  }
  template <class T>
  void rows(const Key& key, std::vector<T>& value) {
    if (value.empty()) return;
    std::string list;
    for (T& row : value) list += "  " + inline_text(row) + ",\n";
    put(key, "[\n" + list + "]");
  }
  template <class T>
  void tables(const Key& key, std::vector<T>& value) {
    for (T& row : value) {
      out_ += fmt::format("\n[[{}]]\n", member(key));
      SceneWriter inner(out_, member(key));
      fields(inner, row);
    }
  }
  void named(const Key& key, std::vector<Material>& value) {
    for (Material& material : value) {
      const std::string path = member(key) + "." + key_text(material.name);
      out_ += fmt::format("\n[{}]\n", path);
      SceneWriter inner(out_, path);
      fields(inner, material);
    }
  }

 private:
  std::string member(const Key& key) const {
    return path_.empty() ? key.name : path_ + "." + key.name;
  }
  void put(const Key& key, const std::string& text) {
    if (style_ == Style::kLines)
      out_ += fmt::format("{} = {}\n", key.name, text);
    else
      out_ += fmt::format("{}{} = {}", out_.empty() ? "" : ", ", key.name, text);
  }
  template <class T>
  std::string inline_text(T& value) {
    std::string text;
    SceneWriter inner(text, path_, Style::kInline);
    fields(inner, value);
    return "{ " + text + " }";
  }

  std::string& out_;
  std::string path_;
  Style style_;
};

const char* range_note(Range range) {
  switch (range) {
    case Range::kPositive:
      return " > 0";
    case Range::kNotNegative:
      return " >= 0";
    case Range::kFraction:
      return " in (0, 1]";
    case Range::kShare:
      return " in [0, 1]";
    case Range::kPoisson:
      return " in [0, 0.5]";
    case Range::kAcute:
      return " in [0, 90 deg)";
    default:
      return "";
  }
}

std::string joined(Words words) {
  std::string list;
  for (const char* word : words) list += (list.empty() ? "" : " | ") + std::string(word);
  return list;
}

template <class T>
T zero_of() {
  if constexpr (std::is_same_v<T, Vec3>)
    return Vec3::Zero();
  else
    return T{};
}

class KeyLister {
 public:
  static constexpr bool kWantsAll = true;

  KeyLister(std::vector<SceneKey>& keys, std::string path) : keys_(keys), path_(std::move(path)) {}

  void operator()(const Key& key, const std::string& value) { add(key, "text", value); }
  void operator()(const Key& key, bool value) { add(key, "true | false", value_text(key, value)); }
  void operator()(const Key& key, double value) { add(key, kind(key), plain(key, value)); }
  void operator()(const Key& key, const Vec3& value) {
    add(key, "3 x " + kind(key),
        fmt::format("{} {} {} {}", format_number(value.x()), format_number(value.y()),
                    format_number(value.z()), si_unit(key.dimension)));
  }
  void operator()(const Key& key, const Schedule& value) {
    add(key, kind(key) + " or schedule", plain(key, value.points[0].value));
  }
  template <std::integral T>
  void operator()(const Key& key, T value) {
    const bool required = key.need == Need::kRequired;
    add(key, std::string("integer") + range_note(key.range), required ? "" : std::to_string(value));
  }
  template <class E>
  requires std::is_enum_v<E>
  void operator()(const Key& key, E value) {
    add(key, joined(words_of(value)), words_of(value)[static_cast<std::size_t>(value)]);
  }
  template <class T>
  void operator()(const Key& key, std::optional<T>&) {
    T value = zero_of<T>();
    (*this)(key, value);
    keys_.back().fallback.clear();
  }
  void word_or_quantity(const Key& key, Words words, int present, double&,
                        const std::function<void(int)>&) {
    add(key, joined(words) + " | " + kind(key), words[static_cast<std::size_t>(present)]);
  }
  void texts(const Key& key, const std::vector<std::string>&) {
    add(key, "text or list of texts", "");
  }
  void axes(const Key& key, const bool (&)[3]) { add(key, "list of axes", "none"); }
  void pair(const Key& key, const std::string&, const std::string&) { add(key, "2 x text", ""); }
  void passing(const Key& key, const std::vector<std::pair<double, double>>&) {
    add(key, "rows", "");
  }
  template <class T>
  void table(const Key& key, T& value) {
    into(member(key), value);
  }
  template <class T>
  void table(const Key& key, std::optional<T>&) {
    T value{};
    into(member(key), value);
  }
  template <class T>
  void rows(const Key& key, std::vector<T>&) {
    T value{};
    into(member(key) + "[]", value);
  }
  template <class T>
  void tables(const Key& key, std::vector<T>&) {
    T value{};
    const bool pair = std::is_same_v<T, PairCoefficients>;
    into(pair ? "contact.A-B" : member(key) + ".NAME", value);
  }
  void named(const Key& key, std::vector<Material>&) {
    Material value;
    into(member(key) + ".NAME", value);
  }

 private:
  std::string member(const Key& key) const {
    return path_.empty() ? key.name : path_ + "." + key.name;
  }
  static std::string kind(const Key& key) {
    return dimension_name(key.dimension) + std::string(range_note(key.range));
  }
  static std::string plain(const Key& key, double value) {
    return key.need == Need::kRequired ? "" : format_quantity(value, key.dimension);
  }
  void add(const Key& key, const std::string& type, const std::string& fallback) {
    keys_.push_back({member(key), type, fallback, key.doc, key.need == Need::kRequired});
  }
  template <class T>
  void into(const std::string& path, T& value) {
    KeyLister inner(keys_, path);
    fields(inner, value);
  }

  std::vector<SceneKey>& keys_;
  std::string path_;
};

SceneDraft draft_of(const Scene& scene) {
  SceneDraft draft;
  draft.scene = scene;
  // The domain that follows from a periodic mill is left to follow again.
  if (scene.mill && scene.mill->ends == EndKind::kPeriodic) {
    const Vec3 half(scene.mill->diameter / 2, scene.mill->diameter / 2, 0);
    DomainSpec& domain = draft.scene.domain;
    if (domain.low == Vec3(-half) && domain.high == Vec3(half + scene.mill->length * Vec3::UnitZ()))
      domain.low = domain.high = std::nullopt;
  }
  for (const MeshWallSpec& mesh : scene.meshes)
    draft.walls.push_back({mesh.name,
                           WallKind::kMesh,
                           mesh.path,
                           mesh.scale,
                           {},
                           {},
                           {},
                           {},
                           {},
                           mesh.material,
                           mesh.group,
                           mesh.motion});
  for (const PlaneSpec& plane : scene.planes)
    draft.walls.push_back({plane.name,
                           WallKind::kPlane,
                           "",
                           {},
                           plane.point,
                           plane.normal,
                           {},
                           {},
                           {},
                           plane.material,
                           plane.group,
                           plane.motion});
  for (const BoxSpec& box : scene.boxes)
    draft.walls.push_back({box.name,
                           WallKind::kBox,
                           "",
                           {},
                           {},
                           {},
                           box.low,
                           box.high,
                           box.open_top,
                           box.material,
                           box.group,
                           box.motion});
  return draft;
}

bool needs_folder(const Scene& scene) {
  bool needs = !scene.meshes.empty() || !scene.run.start_file.empty();
  for (const ParticleSpec& species : scene.particles)
    needs = needs || !species.csv.empty() || !species.meshes.empty();
  return needs;
}

}  // namespace

std::string scene_to_toml(const Scene& scene) {
  SceneDraft draft = draft_of(scene);
  draft.scene.folder.clear();
  if (needs_folder(scene)) draft.scene.folder = std::filesystem::absolute(scene.folder).string();
  std::string text;
  SceneWriter writer(text, "");
  fields(writer, draft);
  return text;
}

std::vector<SceneKey> scene_keys() {
  std::vector<SceneKey> keys;
  KeyLister lister(keys, "");
  SceneDraft draft;
  fields(lister, draft);
  return keys;
}

}  // namespace quern
