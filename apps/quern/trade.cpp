#include "apps/quern/trade.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "apps/quern/machine.h"
#include "apps/quern/recorder.h"
#include "apps/quern/trade_figures.h"
#include "apps/quern/trade_table.h"
#include "io/file_commit.h"
#include "io/html_report.h"
#include "io/log.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

// What a setting's folder holds once its run is over.
struct Measured {
  RunOutcome outcome;
  std::string precision;
  TradeCost cost;
  TradeFigures figures;
};

bool is_wanted(const TradeOptions& options, const TradeRow& row) {
  if (options.only.empty() || row.setting.name == kDefaultSetting) return true;
  return std::any_of(options.only.begin(), options.only.end(), [&](const std::string& name) {
    return name == row.dial || name == row.setting.name;
  });
}

std::vector<TradeRow> wanted_rows(const TradeOptions& options, const LoadedScene& loaded) {
  std::vector<TradeRow> rows = trade_rows(loaded);
  for (const std::string& name : options.only) {
    const bool known = std::any_of(rows.begin(), rows.end(), [&](const TradeRow& row) {
      return name == row.dial || name == row.setting.name;
    });
    if (!known)
      throw UserError(
          fmt::format("--only '{}': no dial and no setting of this scene; "
                      "--list shows them",
                      name));
  }
  std::erase_if(rows, [&](const TradeRow& row) { return !is_wanted(options, row); });
  return rows;
}

std::string command_text(const TradeOptions& o) {
  std::string text = fmt::format(
      "quern trade {} --threads {} --steady {:g} --lead {:g} "
      "--revolutions {:g} --segment {:g}",
      o.scene, o.threads, o.steady, o.lead, o.revolutions, o.segment);
  if (!o.spheres.empty()) text += " --spheres " + o.spheres;
  for (const std::string& key : o.overrides) text += " --set '" + key + "'";
  for (const std::string& name : o.only) text += " --only '" + name + "'";
  return text;
}

void print_list(const std::vector<TradeRow>& rows) {
  for (const TradeRow& row : rows) {
    log_info(fmt::format("{:<20} {:<14} {:<22} {}", row.dial, row.value, row.setting.name,
                         fmt::join(row.setting.set, " ")));
  }
}

class Trade {
 public:
  Trade(const TradeOptions& options, LoadedScene loaded)
      : options_(options), loaded_(std::move(loaded)), rows_(wanted_rows(options, loaded_)) {}

  const std::vector<TradeRow>& rows() const { return rows_; }

  int go() {
    make_folder("results", options_.out);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const TradeSetting& setting = rows_[k].setting;
      if (measured_.contains(setting.name) || (options_.table && !is_over(setting))) continue;
      log_info(fmt::format("row          {} of {}: {}", k + 1, rows_.size(), setting.name));
      if (!measure(setting)) {
        log_info("stopped; the same command goes on");
        return 0;
      }
      write();  // so that what is there can be looked at
    }
    log_info("\n" + terminal_text(table()));
    log_info(fmt::format("results      {0}/trade.csv, {0}/trade.json\npage         {0}/trade.html",
                         options_.out));
    return 0;
  }

 private:
  bool is_over(const TradeSetting& setting) const {
    return outcome_of(folder_of_setting(options_, setting.name)).state != RunState::kStopped;
  }

  bool measure(const TradeSetting& setting) {
    Measured m;
    m.outcome = options_.table ? outcome_of(folder_of_setting(options_, setting.name))
                               : run_setting(options_, loaded_, setting);
    if (m.outcome.state == RunState::kStopped) return false;
    if (m.outcome.state == RunState::kFinished) {
      try {
        read(setting, m);
      } catch (const UserError& error) {  // it went wrong while it was timed
        m.outcome = {RunState::kFailed, error.what()};
      }
    }
    if (m.outcome.state == RunState::kFailed) {
      log_warn(fmt::format("{}: {}", setting.name, m.outcome.reason));
    }
    measured_[setting.name] = std::move(m);
    return true;
  }

  void read(const TradeSetting& setting, Measured& m) const {
    const std::string folder = folder_of_setting(options_, setting.name);
    std::vector<std::string> keys = options_.overrides;
    keys.insert(keys.end(), setting.set.begin(), setting.set.end());
    const LoadedScene own = load_scene(options_.scene, keys);
    m.precision = precision_name(own.scene);
    m.figures = read_figures(folder, own, loaded_.scene.mill->length);
    m.cost = cost_of(folder, folder_of_setting(options_, kDefaultSetting), options_.threads,
                     options_.segment);
  }

  bool finished(const std::string& setting) const {
    const auto found = measured_.find(setting);
    return found != measured_.end() && found->second.outcome.state == RunState::kFinished;
  }

  // What the row names; where that has not been run, for the finest of the numerics the one with
  // most steps a contact, else the default.
  std::string against(const TradeRow& row) const {
    if (finished(row.against) || !finished(kDefaultSetting))
      return finished(row.against) ? row.against : "";
    std::string best = kDefaultSetting;
    for (const TradeRow& other : rows_) {
      if (row.against != kFinestSetting || other.dial != kStepsDial) continue;
      if (!finished(other.setting.name)) continue;
      const auto steps = [&](const std::string& name) {
        return measured_.at(name).figures.steps_per_contact;
      };
      if (steps(other.setting.name) > steps(best)) best = other.setting.name;
    }
    return best;
  }

  TradeTable table() const {
    TradeTable table;
    table.scene = options_.scene;
    table.title = loaded_.scene.run.title;
    table.command = command_text(options_);
    table.machine = processor_name();
    table.commit = QUERN_VERSION " " QUERN_COMMIT;
    table.threads = options_.threads;
    table.lead = options_.lead;
    table.revolutions = options_.revolutions;
    for (const TradeRow& row : rows_) {
      const auto found = measured_.find(row.setting.name);
      if (found == measured_.end()) continue;
      const Measured& m = found->second;
      TradeResult result{row,   against(row), m.precision, m.outcome.reason,
                         false, m.cost,       m.figures,   {}};
      if (result.status.empty() && !result.against.empty()) {
        result.errors = result.against == row.setting.name
                            ? no_errors(m.figures)
                            : errors_of(m.figures, measured_.at(result.against).figures);
      }
      table.rows.push_back(std::move(result));
    }
    mark_front(table);
    return table;
  }

  void write() const {
    const TradeTable now = table();
    const std::string json = json_text(now);
    write_text_file("table", options_.out + "/trade.csv", csv_text(now), Durability::kKill);
    write_text_file("table", options_.out + "/trade.json", json, Durability::kKill);
    write_text_file("table", options_.out + "/trade.txt", terminal_text(now), Durability::kKill);
    write_text_file("page", options_.out + "/trade.html",
                    html_page({"Speed against accuracy: " + now.title, "trade", json, {}}),
                    Durability::kKill);
  }

  const TradeOptions& options_;
  LoadedScene loaded_;
  std::vector<TradeRow> rows_;
  std::map<std::string, Measured> measured_;
};

}  // namespace

int trade_command(const TradeOptions& options) {
  LoadedScene loaded = load_scene(options.scene, options.overrides);
  if (!loaded.scene.mill) throw UserError("quern trade compares turning mills: there is no [mill]");
  judge_time_step(loaded);
  Trade trade(options, std::move(loaded));
  if (options.list) {
    print_list(trade.rows());
    return 0;
  }
  return trade.go();
}

}  // namespace quern
