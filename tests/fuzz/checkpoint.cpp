// Checkpoints: any bytes are a state or an error that names the reason.
//
// Bytes that begin as an HDF5 file does are taken as a file. The seal turns away nearly all that
// becomes of one by chance, so other bytes are a recipe: a whole file with the arrays, types, texts
// and attributes that they ask for, some right, some wrong, some missing.
#include "io/checkpoint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/hdf5_file.h"
#include "io/seal.h"
#include "tests/fuzz/fuzz.h"

extern "C" const char* __lsan_default_suppressions() {
  return "leak:libhdf5";  // it loses some 400 bytes for each damaged object
}

namespace quern {
namespace {

// What a reader asks for: every kind of column and values.
struct State {
  Column<double> position;
  Column<std::uint32_t> id;
  Column<std::uint8_t> flag;
  struct Record {
    float spring[3];
  };
  Column<Record> history;
  double clock[2] = {0, 0};
  std::uint64_t step = 0;

  void visit(StateVisitor& v) {
    v.column("position", "m", position, 3);
    v.column("id", "1", id, 1);
    v.column("flag", "1", flag, 1);
    v.column("pairs/history", "m", history, 1);
    v.values("clock", "s", ElementType::kF64, clock, 2);
    v.later_values("step", "1", ElementType::kU64, &step, 1);
  }
};
constexpr const char* kNames[] = {"position", "id",   "flag", "pairs/history",
                                  "clock",    "step", "more"};
constexpr ArrayLayout kRight[] = {{ElementType::kF64, 4, 3}, {ElementType::kU32, 4, 1},
                                  {ElementType::kU8, 4, 1},  {ElementType::kU8, 4, 12},
                                  {ElementType::kF64, 2, 1}, {ElementType::kU64, 1, 1}};

class Recipe {
 public:
  Recipe(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool more() const { return at_ < size_; }
  std::uint8_t byte() { return more() ? data_[at_++] : 0; }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

void cook(Recipe& recipe, const std::string& path) {
  Hdf5File file("checkpoint", path, FileMode::kCreate);
  const std::uint8_t header = recipe.byte();
  file.set_attribute("/", "format", header % 8u == 7 ? 99 : kCheckpointFormat);
  if (header & 8) file.set_attribute("/", "time", 0.5);
  if (header & 16) file.set_attribute("/", "step", std::uint64_t{recipe.byte()});
  for (const char* name : {"scene_name", "simd_target", "precision", "version"}) {
    if (header & 32)
      file.set_attribute("/", name, std::string(recipe.byte(), 'x'));
    else if (header & 64)
      file.set_attribute("/", name, 1.0);
  }
  file.write_text("header/scene_text", std::string(recipe.byte(), 'y'));
  file.set_attribute("header/scene_text", "hash", std::uint64_t{recipe.byte()});
  file.make_group("state");
  for (std::size_t k = 0; recipe.more(); ++k) {
    const std::size_t row = recipe.byte() % std::size(kNames);
    const std::string name = std::string("state/") + kNames[row];
    if (file.exists(name)) continue;
    const std::uint8_t kind = recipe.byte();
    if (kind == 0) {
      file.write_text(name, "text");
      continue;
    }
    ArrayLayout layout = row < std::size(kRight) ? kRight[row] : ArrayLayout{};
    if (kind & 1) layout.rows = recipe.byte();
    if (kind & 2) layout.components = 1 + recipe.byte() % 20u;
    if (kind & 4) layout.type = static_cast<ElementType>(recipe.byte() % 7u);
    std::vector<std::uint8_t> contents(layout.bytes());
    std::generate(contents.begin(), contents.end(), [&] { return recipe.byte(); });
    file.write(name, layout, contents.data());
    if (kind & 8) file.set_attribute(name, "hash", std::uint64_t{recipe.byte()});
    if (kind & 16) file.set_attribute(name, "hash", 0.5);
  }
  file.close();
  seal_file("checkpoint", path);
}

// Empty if there is none.
template <class Action>
std::string error_of(Action&& action) {
  try {
    action();
    return {};
  } catch (const SystemError& error) {
    return error.what();
  }
}

void look_at(const std::string& path) {
  const std::string damaged = error_of([&] { verify_checkpoint(path); });
  State state;
  const std::string refused =
      error_of([&] { read_checkpoint(path, [&](StateVisitor& v) { state.visit(v); }); });
  for (const std::string& error : {damaged, refused}) {
    fuzz::must(error.empty() || error.find(path) != error.npos);
  }
  fuzz::must(damaged.empty() || !refused.empty());
  if (damaged.empty()) read_checkpoint_header(path);
}

}  // namespace
}  // namespace quern

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quern;
  if (size > 0 && data[0] == 0x89) {
    look_at(fuzz::InputFile(data, size).path());
    return 0;
  }
  const fuzz::InputFile file(nullptr, 0);
  Recipe recipe(data, size);
  cook(recipe, file.path());
  look_at(file.path());
  return 0;
}
