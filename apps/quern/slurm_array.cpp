#include "apps/quern/slurm_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quern {

namespace {

constexpr double kMebi = 1 << 20;
constexpr double kLongestNotice = 120;  // s: for a step, a checkpoint and the page of a large mill

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

// "1-3,7%2"
std::string numbers_text(const std::vector<int>& numbers, int at_once) {
  std::string text;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::size_t first = k;
    while (k + 1 < numbers.size() && numbers[k + 1] == numbers[k] + 1) ++k;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[first]);
    if (k > first) text += fmt::format("-{}", numbers[k]);
  }
  return at_once > 0 ? fmt::format("{}%{}", text, at_once) : text;
}

std::string option_line(const std::string& option) {
  const std::size_t equals = option.find('=');
  if (equals == std::string::npos) return fmt::format("#SBATCH --{}\n", option);
  return fmt::format("#SBATCH --{}={}\n", option.substr(0, equals),
                     sbatch_word(option.substr(equals + 1)));
}

// A case that was told and ends without a fault goes back into the queue, one that was just done
// too: it ends at once then. An array's last task has the array's own number as SLURM_JOB_ID: by
// that all tasks would be queued again.
constexpr const char* kTask = R"(
told=
trap 'told=yes; kill -USR1 $!' USR1
{} "$SLURM_ARRAY_TASK_ID" &
wait $!
code=$?
if [ "$told" ]; then
  wait $!
  code=$?
  [ $code -ne 0 ] || exec scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID"
fi
exit $code
)";

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string slurm_array_text(const SlurmArray& array) {
  const double minutes = std::max(1.0, std::ceil(array.time_limit / 60));
  const double notice = std::min(kLongestNotice, 60 * minutes / 4);
  std::string command, options;
  for (const std::string& word : array.command) {
    if (!command.empty()) command += ' ';
    command += shell_word(word);
  }
  for (const std::string& option : array.options) options += option_line(option);
  return "#!/bin/bash\n" + fmt::format("#SBATCH --job-name={}\n", sbatch_word(array.name)) +
         fmt::format("#SBATCH --array={}\n", numbers_text(array.cases, array.at_once)) +
         fmt::format("#SBATCH --nodes=1 --ntasks=1 --cpus-per-task={}\n", array.threads) +
         fmt::format("#SBATCH --mem={:.0f}M\n", std::max(1.0, std::ceil(array.memory / kMebi))) +
         fmt::format("#SBATCH --time={:.0f}\n", minutes) +
         fmt::format("#SBATCH --requeue --signal=B:USR1@{:.0f}\n", notice) +
         fmt::format("#SBATCH --open-mode=append --output={}\n",
                     sbatch_word(percent_doubled(array.log) + "%a.log")) +
         options + fmt::format(kTask, command);
}

}  // namespace quern
