// The job script of an array: what it asks of Slurm, and, run here with a scontrol that only notes
// what it was told, when a task is queued again.
#include "apps/quern/slurm_array.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "tests/support/temp_folder.h"

namespace quern {
namespace {

SlurmArray six_cases() {
  SlurmArray array;
  array.name = "lifters";
  array.command = {"/opt/quern/bin/quern", "sweep", "/home/you/it's lifters.toml", "--case"};
  array.log = "/home/you/50% full/case-";
  array.cases = {1, 2, 3, 5, 7, 8};
  array.threads = 2;
  array.memory = 300.5e6;
  array.time_limit = 3601;
  return array;
}

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

TEST(SlurmArray, AsksForWhatATaskNeeds) {
  SlurmArray array = six_cases();
  array.options = {"partition=long", "exclusive"};
  const std::string text = slurm_array_text(array);
  EXPECT_EQ(text.rfind("#!/bin/bash\n", 0), 0u);
  for (const char* line :
       {"#SBATCH --job-name=\"lifters\"", "#SBATCH --array=1-3,5,7-8",
        "#SBATCH --nodes=1 --ntasks=1 --cpus-per-task=2", "#SBATCH --mem=287M", "#SBATCH --time=61",
        "#SBATCH --requeue --signal=B:USR1@120",
        "#SBATCH --open-mode=append --output=\"/home/you/50%% full/case-%a.log\"",
        "#SBATCH --partition=\"long\"", "#SBATCH --exclusive",
        "'/opt/quern/bin/quern' 'sweep' '/home/you/it'\\''s lifters.toml' '--case' "
        "\"$SLURM_ARRAY_TASK_ID\" &"}) {
    EXPECT_TRUE(has_line(text, line)) << line << "\nis not in\n" << text;
  }
}

TEST(SlurmArray, RunsNotMoreTasksAtOnceThanWanted) {
  SlurmArray array = six_cases();
  array.at_once = 2;
  EXPECT_TRUE(has_line(slurm_array_text(array), "#SBATCH --array=1-3,5,7-8%2"));
}

TEST(SlurmArray, TellsATaskAtMostAQuarterOfItsTimeAhead) {
  SlurmArray array = six_cases();
  array.time_limit = 100;
  EXPECT_TRUE(has_line(slurm_array_text(array), "#SBATCH --requeue --signal=B:USR1@30"));
}

// Runs the script as case 3 of array 7 with a case that is a line of bash. It finds the script's
// process as $PPID.
struct Outcome {
  int code = 0;
  std::string told;  // what scontrol, or the case itself, wrote into the file `told`
};

Outcome run_task(const std::string& line) {
  const TempFolder folder;
  SlurmArray array = six_cases();
  array.command = {"bash", "-c", line + "\n# it's the case"};
  write_bytes(folder / "job", slurm_array_text(array));
  write_bytes(folder / "scontrol", "#!/bin/sh\necho \"$@\" >>told\n");
  std::filesystem::permissions(folder / "scontrol", std::filesystem::perms::owner_all);
  const std::string command = "cd '" + folder.path() + "' && PATH=.:\"$PATH\" " +
                              "SLURM_ARRAY_JOB_ID=7 SLURM_JOB_ID=7 SLURM_ARRAY_TASK_ID=3 bash job";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_bytes(folder / "told")};
}

TEST(SlurmArray, EndsWithTheCodeOfItsCaseIfNothingWasTold) {
  // The case's number is its last word.
  for (const auto& [line, code] : {std::pair{"[ $0 = 3 ]", 0}, std::pair{"exit 4", 4}}) {
    const Outcome outcome = run_task(line);
    EXPECT_EQ(outcome.code, code) << line;
    EXPECT_EQ(outcome.told, "") << line;
  }
}

TEST(SlurmArray, QueuesATaskAgainOnceItsCaseHasEnded) {
  const Outcome outcome = run_task(
      "trap 'sleep 0.5; echo ended >told; exit' USR1; kill -USR1 $PPID; while true; do sleep 0.01; "
      "done");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.told, "ended\nrequeue 7_3\n");
}

TEST(SlurmArray, DoesNotQueueAFailedTaskAgain) {
  // 138: the signal itself has ended it.
  for (const auto& [trap, code] : {std::pair{"trap 'exit 4' USR1; ", 4}, std::pair{"", 138}}) {
    const Outcome outcome =
        run_task(std::string(trap) + "kill -USR1 $PPID; while true; do sleep 0.01; done");
    EXPECT_EQ(outcome.code, code) << trap;
    EXPECT_EQ(outcome.told, "") << trap;
  }
}

}  // namespace
}  // namespace quern
