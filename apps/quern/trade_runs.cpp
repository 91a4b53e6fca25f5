#include "apps/quern/trade_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/quern/run.h"
#include "io/file_commit.h"
#include "io/log.h"

namespace quern {

namespace {

namespace fs = std::filesystem;
using Keys = std::vector<std::string>;

// One run in one folder. What the scene itself forbids (too long a step) is a failure of the
// setting.
RunOutcome make_run(const TradeOptions& options, const std::string& folder, const Keys& keys) {
  RunOptions run;
  run.scene = options.scene;
  run.out = folder;
  run.threads = options.threads;
  run.overrides = keys;
  try {
    const LoadedScene loaded = load_scene(options.scene, keys);
    judge_time_step(loaded);
    const bool same = holds_scene(folder, loaded.scene);
    if (same) {
      const RunOutcome there = outcome_of(folder);
      if (there.state != RunState::kStopped) return there;
    }
    log_info(fmt::format("\n# {}", folder));
    std::error_code ignored;
    fs::remove(folder + "/cost.json", ignored);
    if (same && fs::exists(folder + "/checkpoint.h5")) {
      resume_command(run);
    } else {
      run_command(run);
    }
  } catch (const InputErrors& errors) {
    return {RunState::kFailed, errors.lines.front()};
  }
  return outcome_of(folder);
}

// Not recorded; as many turns as `steady`, to a whole pitch.
Keys state_keys(const TradeOptions& options, const Scene& scene) {
  const double lifters = scene.mill->lifters ? scene.mill->lifters->count : 1;
  const double turns = std::max(1.0, std::round(options.steady * lifters)) / lifters;
  return {fmt::format("run.revolutions={:.15g}", turns),
          "run.record_from=0",
          "output.frames_every=0",
          "record.collisions=false",
          "record.charge_shape=false",
          "record.classes=false"};
}

Keys start_keys(const std::string& state) {
  return {"run.start=file", "run.start_file=" + fs::absolute(state).lexically_normal().string(),
          "run.settle=none"};
}

// What the table is made from: power by kind, spectra, the shape of the charge, wear.
Keys record_keys(const TradeOptions& options, const Scene& scene) {
  Keys keys = {fmt::format("run.revolutions={:.15g}", options.lead + options.revolutions),
               fmt::format("run.record_from_revolution={:.15g}", options.lead),
               "output.frames_every=0", "record.collisions=true", "record.charge_shape=true"};
  if (scene.wear) return keys;
  constexpr double kCells = 30;          // across the mill
  constexpr double kFlowPressure = 5e9;  // Pa: settings are compared, its size does not matter
  keys.push_back(fmt::format("wear.cell_size={:.6g}", scene.mill->diameter / kCells));
  keys.push_back(fmt::format("wear.flow_pressure={:g}", kFlowPressure));
  return keys;
}

void append(Keys& keys, const Keys& more) { keys.insert(keys.end(), more.begin(), more.end()); }

class StateMaker {
 public:
  StateMaker(const TradeOptions& options, const TradeSetting& setting)
      : options_(options), keys_(options.overrides), own_(setting.state) {
    append(keys_, setting.set);
    scene_ = load_scene(options.scene, keys_).scene;
    folder_ = folder_of_setting(options, setting.name);
  }

  const Keys& keys() const { return keys_; }
  const Scene& scene() const { return scene_; }

  // Sets `state` to the folder of the state the setting starts from.
  RunOutcome make(const LoadedScene& base, std::string& state) {
    const bool polyhedra =
        std::any_of(scene_.particles.begin(), scene_.particles.end(), has_polyhedra);
    const RunOutcome spheres = make_spheres(base, polyhedra, state);
    if (spheres.state != RunState::kFinished || !polyhedra) return spheres;
    const bool own = own_ != SteadyState::kShared;
    Keys keys = own ? keys_ : options_.overrides;
    append(keys, state_keys(options_, scene_));
    append(keys, start_keys(state));
    state = (own ? folder_ : options_.out) + "/steady";
    return make_run(options_, state, keys);
  }

 private:
  RunOutcome make_spheres(const LoadedScene& base, bool polyhedra, std::string& state) {
    const bool own = own_ == SteadyState::kOwnCharge;
    if (!own && !options_.spheres.empty()) {
      state = options_.spheres;
      return {};
    }
    Keys keys = own ? keys_ : options_.overrides;
    if (polyhedra || !own) append(keys, as_spheres(own ? scene_ : base.scene));
    append(keys, state_keys(options_, scene_));
    state = (own ? folder_ : options_.out) + "/steady_spheres";
    return make_run(options_, state, keys);
  }

  const TradeOptions& options_;
  Keys keys_;
  SteadyState own_;
  Scene scene_;
  std::string folder_;
};

}  // namespace

std::string folder_of_setting(const TradeOptions& options, const std::string& name) {
  return options.out + "/" + name;
}

RunOutcome run_setting(const TradeOptions& options, const LoadedScene& base,
                       const TradeSetting& setting) {
  try {
    StateMaker maker(options, setting);
    std::string state;
    const RunOutcome made = maker.make(base, state);
    if (made.state != RunState::kFinished) return made;
    Keys keys = maker.keys();
    append(keys, record_keys(options, maker.scene()));
    append(keys, start_keys(state));
    return make_run(options, folder_of_setting(options, setting.name), keys);
  } catch (const InputErrors& errors) {
    return {RunState::kFailed, errors.lines.front()};
  } catch (const UserError& error) {
    return {RunState::kFailed, error.what()};
  }
}

}  // namespace quern
