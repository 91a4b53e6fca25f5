#include "apps/quern/sweep_slurm.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "apps/quern/slurm_array.h"
#include "io/file_commit.h"
#include "io/log.h"
#include "io/quantity.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

// What a scene needs is an estimate, and pages and tables come on top.
constexpr double kMemoryShare = 1.5;
constexpr int kNoSuchProgram = 127;  // of a shell

double time_limit_of(const SweepOptions& options) {
  const QuantityResult limit = parse_quantity(options.time_limit, Dimension::kTime);
  if (!limit.error.empty())
    throw UserError(fmt::format("--time-limit {}: {}", options.time_limit, limit.error));
  if (!(limit.value > 0))
    throw UserError(fmt::format("--time-limit {}: must be above 0", options.time_limit));
  return limit.value;
}

// What is left to do: numbers of cases. Of a filling that is not there yet and that several of them
// start from the first stands for it.
struct Left {
  std::vector<int> cases, fillings;
};

Left left_of(const SweepPlan& plan) {
  Left left;
  std::map<int, std::vector<int>> users;
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    const SweepRun& run = plan.cases[k];
    if (outcome_of(run).state != RunState::kStopped) continue;
    left.cases.push_back(static_cast<int>(k + 1));
    if (run.filling >= 0) users[run.filling].push_back(left.cases.back());
  }
  for (const auto& [filling, numbers] : users) {
    const bool there =
        outcome_of(plan.fillings[static_cast<std::size_t>(filling)]).state != RunState::kStopped;
    if (!there && numbers.size() > 1) left.fillings.push_back(numbers.front());
  }
  std::sort(left.fillings.begin(), left.fillings.end());
  return left;
}

class Arrays {
 public:
  Arrays(const SweepPlan& plan, const SweepOptions& options)
      : folder_(plan.out + "/slurm"), name_(fs::path(options.file).stem().string()) {
    common_.command = {fs::read_symlink("/proc/self/exe").string(),
                       "sweep",
                       fs::absolute(options.file).lexically_normal().string(),
                       "--out",
                       plan.out,
                       "--threads",
                       std::to_string(std::max(1, options.threads))};
    common_.at_once = options.at_once;
    common_.threads = std::max(1, options.threads);
    common_.time_limit = time_limit_of(options);
    common_.options = options.sbatch;
    for (const SweepRun& run : plan.cases)
      common_.memory = std::max(common_.memory, kMemoryShare * run.memory);
    make_folder("job scripts", folder_);
  }

  std::string write_cases(const std::vector<int>& cases) const {
    return write("case", cases, {"--case"});
  }
  std::string write_fillings(const std::vector<int>& cases) const {
    return write("filling", cases, {"--filling", "--case"});
  }

 private:
  std::string write(const std::string& what, const std::vector<int>& cases,
                    const std::vector<std::string>& words) const {
    SlurmArray array = common_;
    array.name = name_ + " " + what + "s";
    array.cases = cases;
    array.log = folder_ + "/" + what + "-";
    array.command.insert(array.command.end(), words.begin(), words.end());
    const std::string path = folder_ + "/" + what + "s.sh";
    write_text_file("job script", path, slurm_array_text(array), Durability::kKill);
    return path;
  }

  std::string folder_, name_;
  SlurmArray common_;
};

// The number of the job.
std::string submit(const std::string& script, const std::string& after) {
  std::string command = "exec sbatch --parsable ";
  if (!after.empty()) command += "--dependency=afterany:" + after + " ";
  std::FILE* pipe = popen((command + shell_word(script) + " 2>&1").c_str(), "re");
  if (pipe == nullptr) throw SystemError("cannot start sbatch");
  std::string said;
  for (int c; (c = std::fgetc(pipe)) != EOF;) said += static_cast<char>(c);
  const int status = pclose(pipe), code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  while (said.ends_with('\n')) said.pop_back();
  if (code == kNoSuchProgram)
    throw SystemError(fmt::format("cannot submit '{}': there is no program sbatch here", script));
  if (code != 0) throw SystemError(fmt::format("sbatch refuses '{}': {}", script, said));
  // NUMBER, or NUMBER;CLUSTER, behind what it may warn of.
  const std::size_t line = said.find_last_of('\n') + 1;
  const std::string number = said.substr(line, said.find(';', line) - line);
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos)
    throw SystemError(fmt::format("sbatch does not tell the number of the job: {}", said));
  if (line > 0) log_warn("sbatch: " + said.substr(0, line - 1));
  return number;
}

// For a shell.
std::string by_hand(const std::string& fillings, const std::string& cases) {
  if (fillings.empty()) return "sbatch " + shell_word(cases);
  return fmt::format(
      "fillings=$(sbatch --parsable {}) && sbatch --dependency=afterany:$fillings {}",
      shell_word(fillings), shell_word(cases));
}

}  // namespace

int submit_sweep(const SweepPlan& plan, const SweepOptions& options) {
  const Arrays arrays(plan, options);
  const Left left = left_of(plan);
  log_info(
      fmt::format("cases        {}, {} of them left to do", plan.cases.size(), left.cases.size()));
  if (left.cases.empty()) return 0;
  const std::string fillings = left.fillings.empty() ? "" : arrays.write_fillings(left.fillings);
  const std::string cases = arrays.write_cases(left.cases);
  log_info(fmt::format("scripts      {}{}", fillings.empty() ? "" : fillings + ", ", cases));
  if (options.no_submit) {
    log_info("submit       " + by_hand(fillings, cases));
    return 0;
  }
  std::string before;
  try {
    if (!fillings.empty()) {
      before = submit(fillings, "");
      log_info(fmt::format("submitted    job {}: {} fillings", before, left.fillings.size()));
    }
    const std::string job = submit(cases, before);
    log_info(fmt::format("submitted    job {}: {} cases{}", job, left.cases.size(),
                         before.empty() ? "" : ", once job " + before + " has ended"));
  } catch (const SystemError&) {
    log_info("by hand      " + by_hand(before.empty() ? fillings : "", cases));
    throw;
  }
  log_info(fmt::format("then         quern sweep {} --out {} --collect", shell_word(options.file),
                       shell_word(plan.out)));
  return 0;
}

}  // namespace quern
