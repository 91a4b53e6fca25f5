#include "apps/quern/slurm_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quern {

namespace {

constexpr double kMebi = 1 << 20;
constexpr double kLongestNotice = 120;  // s: for a step, a checkpoint and the page of a large mill

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

// In a line of #SBATCH; in the names of files % begins a number that Slurm fills in.
std::string sbatch_word(const std::string& text) {
  std::string word = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') word += '\\';
    word += c;
  }
  return word + "\"";
}

std::string percent_doubled(const std::string& text) {
  std::string doubled;
  for (const char c : text) doubled += c == '%' ? "%%" : std::string(1, c);
  return doubled;
}

// An array's last task has the array's own number as SLURM_JOB_ID: by that all tasks would be
// queued again. 138 is a case that SIGUSR1 met before it heeds it (128 + 10).
constexpr const char* kTask = R"(
told=
trap 'told=yes; kill -USR1 $!' USR1
{} "$SLURM_ARRAY_TASK_ID" &
wait $!
code=$?
if [ "$told" ]; then
  wait $!
  code=$?
  case $code in
    0 | 138) exec scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID" ;;
  esac
fi
exit $code
)";

}  // namespace

std::string slurm_array_text(const SlurmArray& array) {
  const double minutes = std::max(1.0, std::ceil(array.time_limit / 60));
  const double notice = std::min(kLongestNotice, 60 * minutes / 4);
  std::string command;
  for (const std::string& word : array.command) {
    if (!command.empty()) command += ' ';
    command += shell_word(word);
  }
  return "#!/bin/bash\n" + fmt::format("#SBATCH --job-name={}\n", sbatch_word(array.name)) +
         fmt::format("#SBATCH --array=0-{}\n", array.cases - 1) +
         fmt::format("#SBATCH --nodes=1 --ntasks=1 --cpus-per-task={}\n", array.threads) +
         fmt::format("#SBATCH --mem={:.0f}M\n", std::max(1.0, std::ceil(array.memory / kMebi))) +
         fmt::format("#SBATCH --time={:.0f}\n", minutes) +
         fmt::format("#SBATCH --requeue --signal=B:USR1@{:.0f}\n", notice) +
         fmt::format("#SBATCH --open-mode=append --output={}\n",
                     sbatch_word(percent_doubled(array.log_folder) + "/slurm-%a.log")) +
         fmt::format(kTask, command);
}

}  // namespace quern
