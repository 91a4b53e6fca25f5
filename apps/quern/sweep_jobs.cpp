#include "apps/quern/sweep_jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <map>

#include "apps/quern/child_run.h"
#include "io/file_commit.h"
#include "io/log.h"

namespace quern {

namespace {

volatile std::sig_atomic_t g_stop = 0;
void on_signal(int) { g_stop = 1; }
void on_child(int) {}

constexpr int kAttempts = 2;

// 50 ms, or until a run ends: no core waits for its next one.
void pause_a_little() {
  const timespec time{0, 50000000};
  nanosleep(&time, nullptr);
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// A case, or a filling.
struct Job {
  enum class State { kWaiting, kRunning, kFinished, kFailed };
  std::string name, folder;
  int filling = -1;     // row of the jobs; -1: needs none
  std::size_t row = 0;  // of the plan's cases or fillings
  bool is_filling = false;
  double work = 0;  // particle steps
  State state = State::kWaiting;
  int attempts = 0;
  std::optional<ChildRun> child = {};
};

class Jobs {
 public:
  Jobs(const SweepPlan& plan, const std::vector<std::size_t>& cases, const SweepWidth& width,
       double seconds_per_step, JobsPart part)
      : plan_(plan),
        width_(width),
        seconds_per_step_(seconds_per_step),
        part_(part),
        started_(now()) {
    std::map<int, int> rows;
    for (const std::size_t k : cases) {
      const SweepRun& run = plan.cases[k];
      int filling = -1;
      if (run.filling >= 0) {
        const auto [at, fresh] = rows.try_emplace(run.filling, static_cast<int>(jobs_.size()));
        if (fresh) {
          const auto row = static_cast<std::size_t>(run.filling);
          const std::string& folder = plan.fillings[row].folder;
          jobs_.push_back({folder.substr(plan.out.size() + 1), folder, -1, row, true});
        }
        filling = at->second;
      }
      if (part_ == JobsPart::kFillings) continue;
      jobs_.push_back({run.place.name, run.folder, filling, k, false, run.steps * run.particles});
    }
    for (Job& job : jobs_) look(job);
    for (const Job& job : jobs_) {
      count_ += counts(job);
      if (counts(job) && job.state == Job::State::kFinished) done_before_ += job.work;
    }
  }

  JobsResult go() {
    while (g_stop == 0 && step()) {
      show();
      pause_a_little();
    }
    if (g_stop != 0) stop_all();
    table_.clear();
    JobsResult result;
    result.stopped = g_stop != 0;
    for (const Job& job : jobs_) {
      if (!counts(job)) continue;
      if (job.state == Job::State::kFinished) ++result.finished;
      if (job.state == Job::State::kFailed) ++result.failed;
    }
    return result;
  }

 private:
  bool counts(const Job& job) const { return job.is_filling == (part_ == JobsPart::kFillings); }

  RunOutcome outcome(const Job& job) const {
    return job.is_filling ? outcome_of(plan_.fillings[job.row]) : outcome_of(plan_.cases[job.row]);
  }

  // What its folder says.
  void look(Job& job) {
    const RunOutcome there = outcome(job);
    if (there.state == RunState::kFinished) job.state = Job::State::kFinished;
    if (there.state == RunState::kFailed) fail(job, there.reason);
  }

  void fail(Job& job, const std::string& reason) {
    job.state = Job::State::kFailed;
    table_.clear();
    log_warn(fmt::format("{}: {}", job.name, reason));
  }

  // False: nothing is left to do.
  bool step() {
    int running = 0, waiting = 0;
    for (Job& job : jobs_) {
      if (job.state == Job::State::kRunning) end(job);
      running += job.state == Job::State::kRunning;
    }
    for (Job& job : jobs_) {
      if (job.state != Job::State::kWaiting) continue;
      const Job::State needed = job.filling < 0
                                    ? Job::State::kFinished
                                    : jobs_[static_cast<std::size_t>(job.filling)].state;
      if (needed == Job::State::kFailed) fail(job, "its filling failed");
      if (needed == Job::State::kFinished && running < width_.at_once) running += start(job);
      waiting += job.state == Job::State::kWaiting;
    }
    return running + waiting > 0;
  }

  // False: not now, another process works in the folder; or it has finished there.
  bool start(Job& job) {
    job.child = ChildRun::start(job.folder, [&]() -> std::vector<std::string> {
      if (outcome(job).state == RunState::kFinished) {
        job.state = Job::State::kFinished;
        return {};
      }
      return job.is_filling ? command_of(plan_.fillings[job.row], width_.threads)
                            : command_of(plan_, plan_.cases[job.row], width_.threads);
    });
    if (!job.child) return false;
    std::error_code ignored;
    std::filesystem::remove(failed_file(job.folder), ignored);
    job.state = Job::State::kRunning;
    ++job.attempts;
    return true;
  }

  void end(Job& job) {
    const std::optional<ChildRun::End> end = job.child->poll();
    if (!end) return;
    job.child.reset();
    const RunOutcome there = outcome(job);
    if (there.state == RunState::kFinished) {
      job.state = Job::State::kFinished;
      return;
    }
    const std::string reason = there.reason.empty()
                                   ? fmt::format("{}; see {}/log.txt", end->how, job.folder)
                                   : there.reason;
    job.state = Job::State::kWaiting;
    if (job.attempts >= kAttempts) {
      if (there.reason.empty())
        write_text_file("mark", failed_file(job.folder), end->how, Durability::kKill);
      return fail(job, reason);
    }
    table_.clear();
    log_warn(fmt::format("{}: {}; once more", job.name, reason));
  }

  void stop_all() {
    table_.clear();
    log_info("stopping: the runs write their checkpoints");
    for (const Job& job : jobs_) {
      if (job.child) job.child->stop();
    }
    for (Job& job : jobs_) {
      while (job.child) {
        if (job.child->poll()) {
          job.child.reset();
          job.state = Job::State::kWaiting;
          look(job);
        } else {
          pause_a_little();
        }
      }
    }
  }

  void show() {
    if (!table_.due()) return;
    std::size_t finished = 0, failed = 0, running = 0;
    double left = 0, done = -done_before_;
    std::vector<std::string> lines;
    for (const Job& job : jobs_) {
      if (job.state == Job::State::kRunning) {
        ++running;
        lines.push_back(fmt::format("  {} |{}", job.name, last_line_of_log(job.folder)));
      }
      if (!counts(job)) continue;
      finished += job.state == Job::State::kFinished;
      failed += job.state == Job::State::kFailed;
      const bool over = job.state == Job::State::kFinished || job.state == Job::State::kFailed;
      (over ? done : left) += job.work;
    }
    const double elapsed = now() - started_;
    const double each = done > 0 ? elapsed / done : seconds_per_step_ / width_.at_once;
    std::string head = fmt::format(
        "{} {} of {}", part_ == JobsPart::kFillings ? "fillings" : "cases", finished, count_);
    if (failed > 0) head += fmt::format(", {} failed", failed);
    head += fmt::format(" | {} running | elapsed {}", running, format_clock(elapsed));
    if (each > 0) head += " ETA " + format_clock(left * each);
    table_.show(head, lines);
  }

  const SweepPlan& plan_;
  SweepWidth width_;
  double seconds_per_step_;
  JobsPart part_;
  double started_, done_before_ = 0;
  std::size_t count_ = 0;
  std::vector<Job> jobs_;
  ProgressTable table_;
};

}  // namespace

void heed_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, on_signal);
}

JobsResult run_cases(const SweepPlan& plan, const std::vector<std::size_t>& cases,
                     const SweepWidth& width, double seconds_per_step, JobsPart part) {
  heed_signals();
  std::signal(SIGCHLD, on_child);
  return Jobs(plan, cases, width, seconds_per_step, part).go();
}

}  // namespace quern
