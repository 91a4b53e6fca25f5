#include "apps/quern/sweep_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "io/checkpoint.h"
#include "io/file_commit.h"
#include "io/scene_reader.h"
#include "scheduler/phases.h"
#include "scheduler/random.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

// FNV-1a.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return mix_bits(hash);
}

double design_random(std::uint64_t seed, std::size_t factor, std::size_t number) {
  return CounterRandom(mix_bits(seed + kGolden * (factor + 1)), RandomStream::kSweep, number)
      .uniform();
}

bool settles(const Scene& scene) {
  return scene.run.start == StartKind::kFill && scene.run.settle != SettleKind::kNone;
}

// All that matters only once the mill turns is the same in every filling.
Scene filling_of(Scene scene) {
  scene.run.title = "Filling";
  scene.run.duration = 1;
  scene.run.revolutions = scene.run.record_from = scene.run.record_from_revolution = std::nullopt;
  if (scene.mill) scene.mill->rotation.points = {{0, 0}};
  const double checkpoint_every = scene.output.checkpoint_every;
  scene.output = OutputSpec();
  scene.output.checkpoint_every = checkpoint_every;
  scene.record = RecordSpec();
  scene.wear.reset();
  return scene;
}

// Messages of the scene's reader name the override; here they name where the sweep has it.
std::string placed(const SweepSpec& spec, const std::string& line) {
  constexpr std::string_view kSet = "--set ";
  if (!line.starts_with(kSet)) return line;
  for (const auto& [text, place] : spec.places) {
    if (line.compare(kSet.size(), text.size() + 2, text + ": ") != 0) continue;
    constexpr std::string_view kError = "error: ";
    std::string rest = line.substr(kSet.size() + text.size() + 2);
    if (rest.starts_with(kError)) rest = rest.substr(kError.size());
    return fmt::format("{}: error: {}: {}", place, text, rest);
  }
  return line;
}

std::vector<std::string> placed(const SweepSpec& spec, std::vector<std::string> lines) {
  for (std::string& line : lines) line = placed(spec, line);
  return lines;
}

// run.seed of the scene as the sweep sets it. Tells the scene's warnings and mistakes, once.
std::uint64_t base_seed(const SweepSpec& spec) {
  try {
    return load_scene(spec.scene, spec.set).scene.run.seed;
  } catch (const InputErrors& problems) {
    throw InputErrors{placed(spec, problems.lines)};
  }
}

class Planner {
 public:
  Planner(SweepPlan& plan) : plan_(plan) {}

  void add(SweepCase place) {
    SweepRun& run = plan_.cases.emplace_back();
    run.folder = plan_.out + "/" + place.name;
    run.set = place.set;
    run.place = std::move(place);
    try {
      LoadedScene loaded = load_scene(plan_.spec.scene, run.set, say_nothing);
      judge_time_step(loaded, say_nothing);
      run.particles = static_cast<double>(loaded.seeds.size());
      run.steps = run_time(loaded.scene) / loaded.dt;
      run.memory = expected_memory(loaded.scene);
      run.scene = std::move(loaded.scene);
      if (settles(run.scene)) start_from_filling(run);
    } catch (const InputErrors& problems) {
      for (const std::string& text : placed(plan_.spec, problems.lines)) {
        if (std::find(errors_.begin(), errors_.end(), text) == errors_.end())
          errors_.push_back(text);
      }
    }
  }

  const std::vector<std::string>& errors() const { return errors_; }

 private:
  void start_from_filling(SweepRun& run) {
    const Scene scene = filling_of(run.scene);
    const std::string text = without_places(scene_to_toml(scene));
    const auto [at, fresh] = rows_.try_emplace(text, static_cast<int>(plan_.fillings.size()));
    if (fresh) {
      const std::string name = fmt::format("{:08x}", hash_of(text) >> 32);
      plan_.fillings.push_back({plan_.out + "/fillings/" + name, scene});
    }
    run.filling = at->second;
    const std::string& folder = plan_.fillings[static_cast<std::size_t>(run.filling)].folder;
    run.scene.run.start = StartKind::kFile;
    run.scene.run.start_file = folder + "/settled";
    run.scene.run.settle = SettleKind::kNone;
    run.set.insert(run.set.end(), {"run.start=file", "run.start_file=" + run.scene.run.start_file,
                                   "run.settle=none"});
  }

  SweepPlan& plan_;
  std::map<std::string, int> rows_;
  std::vector<std::string> errors_;
};

}  // namespace

SweepPlan plan_sweep(const std::string& file, const std::string& out) {
  SweepResult read = read_sweep(file);
  if (!read.errors.empty()) throw InputErrors{read.errors};
  SweepPlan plan;
  plan.spec = std::move(read.spec);
  plan.out = fs::absolute(out).lexically_normal().string();
  const auto random = [&](std::size_t factor, std::size_t number) {
    return design_random(plan.spec.seed, factor, number);
  };
  const std::vector<SweepCase> cases = sweep_cases(plan.spec, base_seed(plan.spec), random);
  Planner planner(plan);
  for (const SweepCase& place : cases) planner.add(place);
  if (!planner.errors().empty()) throw InputErrors{planner.errors()};
  return plan;
}

RunOutcome outcome_of(const SweepFilling& filling) {
  if (!holds_scene(filling.folder, filling.scene)) return {RunState::kStopped, ""};
  if (fs::exists(filling.folder + "/settled/checkpoint.h5")) return {};
  const RunOutcome there = outcome_of(filling.folder);
  return there.state == RunState::kFailed ? there : RunOutcome{RunState::kStopped, ""};
}

RunOutcome outcome_of(const SweepRun& run) {
  if (!holds_scene(run.folder, run.scene)) return {RunState::kStopped, ""};
  return outcome_of(run.folder);
}

std::string failed_file(const std::string& folder) { return folder + "/failed.txt"; }

// What is left of another scene in the folder is not taken for this one's.
std::vector<std::string> command_of(const SweepFilling& filling, int threads) {
  std::vector<std::string> command = {"resume", filling.folder};
  if (!holds_scene(filling.folder, filling.scene)) {
    std::error_code ignored;
    fs::remove_all(filling.folder + "/settled", ignored);
    const std::string scene = filling.folder + ".toml";
    write_text_file("scene", scene, scene_to_toml(filling.scene), Durability::kKill);
    command = {"run", scene, "--out", filling.folder};
  }
  command.insert(command.end(), {"--threads", std::to_string(threads), "--until", "0"});
  return command;
}

std::vector<std::string> command_of(const SweepPlan& plan, const SweepRun& run, int threads) {
  std::vector<std::string> command = {"resume", run.folder};
  if (!holds_scene(run.folder, run.scene)) command = {"run", plan.spec.scene, "--out", run.folder};
  command.insert(command.end(), {"--threads", std::to_string(threads)});
  if (command.front() == "run") {
    for (const std::string& set : run.set) command.insert(command.end(), {"--set", set});
  }
  return command;
}

}  // namespace quern
