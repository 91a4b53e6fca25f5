#include "io/sweep_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/file_commit.h"
#include "io/quantity.h"
#include "io/table_reader.h"

namespace quern {
namespace {

constexpr long kMostCases = 100000;
constexpr const char* kDesignWords[] = {"grid", "list", "latin-hypercube"};

struct FactorDraft {
  std::optional<std::string> key;
  std::vector<std::string> keys;
  const Node* values = nullptr;
  const Node* from = nullptr;
  const Node* to = nullptr;
};

struct SweepDraft {
  int format = 1;
  SweepSpec spec;
  std::vector<FactorDraft> factors;
  const Node* set = nullptr;
};

std::string quoted_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

// The node as TOML.
std::string toml_text(const Node& node) {
  std::string parts;
  const auto add = [&](const std::string& part) { parts += (parts.empty() ? "" : ", ") + part; };
  switch (node.kind) {
    case NodeKind::kString:
      return quoted_text(node.text);
    case NodeKind::kInteger:
      return std::to_string(node.integer);
    case NodeKind::kFloat:
      return format_number(node.number);
    case NodeKind::kBool:
      return node.flag ? "true" : "false";
    case NodeKind::kArray:
      for (const Node& item : node.items) add(toml_text(item));
      return "[" + parts + "]";
    default:
      for (const Entry& entry : node.entries) add(entry.key + " = " + toml_text(entry.value));
      return "{ " + parts + " }";
  }
}

// As one would type it after --set key=: texts without quotes where they stay texts.
std::string override_value(const Node& node) {
  const bool bare = node.kind == NodeKind::kString && !node.text.empty() &&
                    parse_override_value(node.text, 0).kind == NodeKind::kString;
  return bare ? node.text : toml_text(node);
}

class Reader {
 public:
  Reader(SweepDraft& draft, ReadContext& context) : draft_(draft), context_(context) {}

  void finish() {
    SweepSpec& spec = draft_.spec;
    if (draft_.set != nullptr) read_set(*draft_.set, "");
    for (std::size_t k = 0; k < draft_.factors.size(); ++k) {
      path_ = fmt::format("factors[{}]", k);
      spec.factors.push_back(factor_of(draft_.factors[k]));
    }
    check_keys();
    check_design();
  }

 private:
  void fail(const Place& place, const std::string& what) { context_.messages.error(place, what); }
  void fail(const std::string& what) { fail(context_.trace.place(path_), what); }

  void note(const std::string& key, const std::string& value, const Place& place) {
    draft_.spec.places[key + "=" + value] = context_.messages.prefix(place);
  }

  void read_set(const Node& table, const std::string& before) {
    for (const Entry& entry : table.entries) {
      const std::string key = before + entry.key;
      if (entry.value.kind == NodeKind::kTable) {
        read_set(entry.value, key + ".");
        continue;
      }
      const std::string value = override_value(entry.value);
      draft_.spec.set.push_back(key + "=" + value);
      note(key, value, entry.value.place);
    }
  }

  SweepFactor factor_of(const FactorDraft& draft) {
    SweepFactor factor;
    factor.place = context_.messages.prefix(context_.trace.place(path_));
    if (draft.key.has_value() == !draft.keys.empty()) {
      fail("a factor needs 'key', or 'keys' that vary together");
      return factor;
    }
    factor.keys = draft.key ? std::vector<std::string>{*draft.key} : draft.keys;
    const bool range = draft.from != nullptr || draft.to != nullptr;
    if (range == (draft.values != nullptr)) {
      fail("a factor needs 'values = [...]', or 'from' and 'to' of a Latin hypercube");
    } else if (!range) {
      read_values(*draft.values, draft.key.has_value(), factor);
    } else if (draft.from == nullptr || draft.to == nullptr) {
      fail("'from' and 'to' go together");
    } else {
      read_range(draft, factor);
    }
    return factor;
  }

  // One for each key; complains if there are not as many.
  std::vector<const Node*> parts_of(const Node& node, bool single, const SweepFactor& factor) {
    if (single) return {&node};
    if (node.kind != NodeKind::kArray || node.items.size() != factor.keys.size()) {
      fail(node.place, fmt::format("must be an array of {} values, one for each of 'keys'",
                                   factor.keys.size()));
      return {};
    }
    std::vector<const Node*> parts;
    for (const Node& item : node.items) parts.push_back(&item);
    return parts;
  }

  void read_values(const Node& values, bool single, SweepFactor& factor) {
    if (values.kind != NodeKind::kArray || values.items.empty())
      return fail(values.place, "'values' must be an array of at least one value");
    for (const Node& level : values.items) {
      std::vector<std::string> texts;
      for (const Node* part : parts_of(level, single, factor)) {
        texts.push_back(override_value(*part));
        note(factor.keys[texts.size() - 1], texts.back(), part->place);
      }
      if (texts.empty()) continue;
      if (std::find(factor.values.begin(), factor.values.end(), texts) != factor.values.end())
        fail(level.place, fmt::format("'{}' is there twice", fmt::join(texts, ", ")));
      factor.values.push_back(std::move(texts));
    }
  }

  void read_range(const FactorDraft& draft, SweepFactor& factor) {
    const std::vector<const Node*> from = parts_of(*draft.from, draft.key.has_value(), factor),
                                   to = parts_of(*draft.to, draft.key.has_value(), factor);
    for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k) {
      double low = 0, high = 0;
      std::string unit, same;
      if (!split_quantity(override_value(*from[k]), low, unit))
        fail(from[k]->place, "'from' must be a number, or a text with a unit");
      else if (!split_quantity(override_value(*to[k]), high, same) || same != unit)
        fail(to[k]->place, unit.empty()
                               ? "'to' must be a number without a unit, as 'from' is"
                               : fmt::format("'to' must be in the unit of 'from' ({})", unit));
      else if (low == high)
        fail(to[k]->place, "'to' must differ from 'from'");
      factor.from.push_back(low);
      factor.to.push_back(high);
      factor.units.push_back(unit);
      factor.whole.push_back(from[k]->kind == NodeKind::kInteger &&
                             to[k]->kind == NodeKind::kInteger);
    }
  }

  void check_keys() {
    std::set<std::string> seen;
    for (std::size_t k = 0; k < draft_.spec.factors.size(); ++k) {
      path_ = fmt::format("factors[{}]", k);
      for (const std::string& key : draft_.spec.factors[k].keys) {
        if (!seen.insert(key).second) fail(fmt::format("'{}' is varied twice", key));
        if (key == "run.seed" && draft_.spec.replicates > 1)
          fail("'run.seed' is what replicates vary: take one or the other");
      }
    }
  }

  void check_design() {
    const SweepSpec& spec = draft_.spec;
    const bool hypercube = spec.design == SweepDesign::kLatinHypercube;
    for (const SweepFactor& factor : spec.factors) {
      path_ = fmt::format("factors[{}]", &factor - spec.factors.data());
      if (factor.ranges() && !hypercube)
        fail("'from' and 'to' need design = \"latin-hypercube\"; others take 'values'");
      if (spec.design == SweepDesign::kList &&
          factor.values.size() != spec.factors.front().values.size())
        fail(fmt::format("a list takes as many values of each factor: {} here, {} of the first",
                         factor.values.size(), spec.factors.front().values.size()));
    }
    path_ = "samples";
    if (hypercube && spec.samples < 2 && !context_.trace.spoiled(path_))
      fail("design = \"latin-hypercube\" needs 'samples', at least 2");
    if (!hypercube && context_.trace.given("samples"))
      fail("'samples' is of design = \"latin-hypercube\" only");
    if (!hypercube && context_.trace.given("seed")) {
      path_ = "seed";
      fail("'seed' is of design = \"latin-hypercube\" only (that of the filling: run.seed)");
    }
    path_ = "replicates";
    if (spec.replicates < 1) fail("'replicates' must be at least 1");
    double cases = static_cast<double>(spec.replicates);
    if (hypercube) cases *= static_cast<double>(spec.samples);
    if (spec.design == SweepDesign::kGrid)
      for (const SweepFactor& factor : spec.factors)
        cases *= static_cast<double>(factor.values.size());
    path_ = "factors";
    if (cases > kMostCases)
      fail(fmt::format("{:.3g} cases; at most {} are allowed", cases, kMostCases));
  }

  SweepDraft& draft_;
  ReadContext& context_;
  std::string path_;
};

}  // namespace

Words words_of(SweepDesign) { return kDesignWords; }

void fields(TableReader& io, FactorDraft& factor) {
  io({"key", "of the scene, as in --set"}, factor.key);
  io.texts({"keys", "that vary together"}, factor.keys);
  factor.values = io.raw({"values", "of the key, or for each of the keys one"});
  factor.from = io.raw({"from", "of a Latin hypercube"});
  factor.to = io.raw({"to", "of a Latin hypercube"});
}

void fields(TableReader& io, SweepDraft& draft) {
  SweepSpec& spec = draft.spec;
  io({"format", "of this file", Dimension::kNumber, Range::kAny, Need::kRequired}, draft.format);
  io({"scene", "the base scene", Dimension::kNumber, Range::kAny, Need::kRequired}, spec.scene);
  io({"design", "how values are combined"}, spec.design);
  io({"samples", "of a Latin hypercube", Dimension::kNumber, Range::kPositive}, spec.samples);
  io({"seed", "of a Latin hypercube", Dimension::kNumber, Range::kNotNegative}, spec.seed);
  io({"replicates", "runs of each point, by run.seed", Dimension::kNumber, Range::kPositive},
     spec.replicates);
  io.texts({"responses", "names of summary.json"}, spec.responses);
  draft.set = io.raw({"set", "keys and values of all cases"});
  io.tables({"factors", "what is varied", Dimension::kNumber, Range::kAny, Need::kRequired},
            draft.factors);
}

SweepResult parse_sweep(const std::string& text, const std::string& path) {
  namespace fs = std::filesystem;
  SweepResult result;
  Messages messages(path, {});
  const Node root = parse_toml(text, messages);
  if (!messages.any_error()) {
    ReadContext context{messages, {}, {}};
    SweepDraft draft;
    TableReader reader(context, &root, "");
    fields(reader, draft);
    reader.finish();
    if (draft.format != 1 && !context.trace.spoiled("format"))
      messages.error(context.trace.place("format"), "'format' must be 1");
    if (draft.set != nullptr && draft.set->kind != NodeKind::kTable)
      messages.error(draft.set->place, "'set' must be a table, as in [set]");
    if (context.trace.given("factors") && draft.factors.empty())
      messages.error(context.trace.place("factors"), "'factors' must not be empty");
    if (!messages.any_error()) Reader(draft, context).finish();
    result.spec = std::move(draft.spec);
    result.spec.file = path;
    result.spec.scene =
        (fs::absolute(path).parent_path() / result.spec.scene).lexically_normal().string();
  }
  result.errors = messages.errors();
  return result;
}

SweepResult read_sweep(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    SweepResult result;
    result.errors.push_back(path + ": error: cannot read the sweep: there is no such file");
    return result;
  }
  return parse_sweep(read_text_file("sweep", path), path);
}

}  // namespace quern
