#include "apps/quern/trade_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/quern/run.h"
#include "io/file_commit.h"
#include "io/log.h"
#include "scheduler/phases.h"

namespace quern {

namespace {

namespace fs = std::filesystem;
using Keys = std::vector<std::string>;

// Whether the folder's run is over, and of this very scene.
bool is_made(const TradeOptions& options, const std::string& folder, const Keys& keys) {
  return outcome_of(folder).state != RunState::kStopped &&
         holds_scene(folder, load_scene(options.scene, keys).scene);
}

// One run in one folder. What the scene itself forbids (too long a step) is a failure of the
// setting.
RunOutcome make_run(const TradeOptions& options, const std::string& folder, const Keys& keys) {
  RunOptions run;
  run.scene = options.scene;
  run.out = folder;
  run.threads = options.threads;
  run.overrides = keys;
  try {
    if (is_made(options, folder, keys)) return outcome_of(folder);
    log_info(fmt::format("\n# {}", folder));
    std::error_code ignored;
    fs::remove(folder + "/cost.json", ignored);
    const bool same = holds_scene(folder, load_scene(options.scene, keys).scene);
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

// A setting's scene and the states it starts from.
class StateMaker {
 public:
  StateMaker(const TradeOptions& options, const LoadedScene& base, const TradeSetting& setting)
      : options_(options), base_(base), keys_(options.overrides), own_(setting.state) {
    append(keys_, setting.set);
    scene_ = load_scene(options.scene, keys_).scene;
    folder_ = folder_of_setting(options, setting.name);
    polyhedra_ = std::any_of(scene_.particles.begin(), scene_.particles.end(), has_polyhedra);
  }

  const Keys& keys() const { return keys_; }
  const Scene& scene() const { return scene_; }

  // Folder of the state that the setting starts from.
  std::string state() const {
    if (!polyhedra_) return spheres();
    return (own_ == SteadyState::kShared ? options_.out : folder_) + "/steady";
  }

  RunOutcome make() const {
    const RunOutcome made = make_spheres();
    if (made.state != RunState::kFinished || !polyhedra_) return made;
    Keys keys = state_set(own_ != SteadyState::kShared);
    append(keys, state_keys(options_, scene_));
    append(keys, start_keys(spheres()));
    keys.push_back(fmt::format("run.relax={:g}", kExchangeRelax));
    return make_run(options_, state(), keys);
  }

 private:
  bool own_spheres() const { return own_ == SteadyState::kOwnCharge; }

  std::string spheres() const {
    if (own_spheres()) return folder_ + "/steady_spheres";
    return options_.spheres.empty() ? options_.out + "/steady_spheres" : options_.spheres;
  }

  RunOutcome make_spheres() const {
    if (!own_spheres() && !options_.spheres.empty()) return {};
    Keys keys = state_set(own_spheres());
    append(keys, as_spheres(own_spheres() ? scene_ : base_.scene));
    append(keys, state_keys(options_, scene_));
    return make_run(options_, spheres(), keys);
  }

  // The scene's keys, or the setting's: a state needs its particles, and not its short steps.
  Keys state_set(bool own) const {
    Keys keys = options_.overrides;
    if (!own) return keys;
    for (std::size_t k = keys.size(); k < keys_.size(); ++k) {
      if (!keys_[k].starts_with("run.time_step=")) keys.push_back(keys_[k]);
    }
    return keys;
  }

  const TradeOptions& options_;
  const LoadedScene& base_;
  Keys keys_;  // the user's, then the setting's
  SteadyState own_;
  Scene scene_;
  std::string folder_;
  bool polyhedra_ = false;
};

}  // namespace

std::string folder_of_setting(const TradeOptions& options, const std::string& name) {
  return options.out + "/" + name;
}

RunOutcome run_setting(const TradeOptions& options, const LoadedScene& base,
                       const TradeSetting& setting) {
  try {
    const StateMaker maker(options, base, setting);
    const std::string folder = folder_of_setting(options, setting.name);
    Keys keys = maker.keys();
    append(keys, record_keys(options, maker.scene()));
    // Asked without the state, which is not needed any more and may have been deleted.
    Keys made_keys = keys;
    append(made_keys, start_keys(folder));
    if (fs::exists(folder) && is_made(options, folder, made_keys)) return outcome_of(folder);
    const RunOutcome state = maker.make();
    if (state.state != RunState::kFinished) return state;
    append(keys, start_keys(maker.state()));
    return make_run(options, folder, keys);
  } catch (const InputErrors& errors) {
    return {RunState::kFailed, errors.lines.front()};
  } catch (const UserError& error) {
    return {RunState::kFailed, error.what()};
  }
}

}  // namespace quern
