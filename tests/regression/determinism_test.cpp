// Same binary, same scene: the same bits for any number of threads, any order of the tiles, with or
// without a restart, even after a kill.
//
// Three scenes: the laboratory mill in tiles of 4, with linear springs and with those of Hertz and
// Mindlin, and a small cut of the SAG slice (periodic, two materials, sizes 1:4) in tiles of 16:
// all are about 100 tiles, more than eight for each of eight threads. The slice in `single` as
// well: its places on a grid are saved nowhere. Runs start from a charge that has fallen and
// tumbled for 0.15 s.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "scheduler/check_lists.h"
#include "tests/support/hashed_runs.h"

namespace quern {
namespace {

constexpr std::uint64_t kWarmUp = 15000;

Scene lab_mill(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides = {"run.settle=none", "run.tile_size=4"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return shipped_scene("lab_mill_spheres", overrides);
}

Scene lab_mill_hertz(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides = {"run.settle=none", "run.tile_size=4"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return shipped_scene("lab_mill_hertz", overrides);
}

Scene sag_slice(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides = {
      "run.settle=none", "run.tile_size=16", "mill.length=0.32 m", "particles.ball.count=125",
      "particles.ore.sizes=[{ from = \"35 mm\", to = \"45 mm\", count = 1180 }, { from = \"45 "
      "mm\", "
      "to = \"75 mm\", count = 334 }, { from = \"75 mm\", to = \"150 mm\", count = 128 }]"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return shipped_scene("sag_slice_small_sp", overrides);
}

Scene sag_slice_in_single(const std::vector<std::string>& more) {
  std::vector<std::string> overrides = more;
  overrides.push_back("run.precision=single");
  return sag_slice(overrides);
}

struct Case {
  const char* name;
  Scene (*scene)(const std::vector<std::string>&);
};
void PrintTo(const Case& c, std::ostream* to) { *to << c.name; }
class Determinism : public testing::TestWithParam<Case> {
 protected:
  Start start(const std::vector<std::string>& more = {}) const {
    return Start(GetParam().scene(more), kWarmUp);
  }
};

TEST_P(Determinism, GivesTheSameBitsForAnyNumberOfThreads) {
  const Start s = start();
  const std::uint64_t one = s.hash_after({});
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(s.hash_after({.threads = threads}), one) << threads << " threads";
  }
}

TEST_P(Determinism, GivesTheSameBitsForAnyOrderOfTheTiles) {
  const Start s = start();
  const std::uint64_t one = s.hash_after({});
  EXPECT_EQ(s.hash_after({.threads = 1, .shuffle = 1}), one);
  EXPECT_EQ(s.hash_after({.threads = 3, .shuffle = 99}), one);
}

TEST_P(Determinism, GivesTheSameBitsWithARestartInBetween) {
  const Start s = start();
  const std::uint64_t one = s.hash_after({});
  EXPECT_EQ(s.hash_after({.resume_at = 1000}), one);
  EXPECT_EQ(s.hash_after({.threads = 2, .resume_at = 1371}), one) << "with two threads";
  EXPECT_EQ(s.hash_after({.resume_at = 1}), one);
}

TEST_P(Determinism, IsNotDisturbedByWritingACheckpoint) {
  const Start s = start();
  EXPECT_EQ(s.hash_after({.checkpoint_at = 777}), s.hash_after({}));
}

// The tests above must be able to fail.
TEST_P(Determinism, GivesOtherBitsForAnotherSeedAndAnotherStep) {
  const Start s = start();
  const std::uint64_t one = s.hash_after({}, 100);
  EXPECT_NE(start({"run.seed=2"}).hash_after({}, 100), one);
  EXPECT_NE(s.hash_after({}, 101), one);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism,
                         testing::Values(Case{"LabMill", lab_mill},
                                         Case{"LabMillHertz", lab_mill_hertz},
                                         Case{"SagSlice", sag_slice},
                                         Case{"SagSliceInSingle", sag_slice_in_single}),
                         [](const auto& test) { return test.param.name; });

// Restored bits: every column and number of a world read back is the world that was written.
TEST(Restart, RestoresAStateWithTheSameHashAndLists) {
  const Scene s = lab_mill();
  TempFolder folder;
  World<float> world = world_of<float>(s);
  advance(world, {}, 1234);
  write_state(world, folder.path());
  World<float> other = std::move(*read_state(s, folder.path()));
  // Poses are no state: the next step computes them from the time.
  for (std::size_t b = 0; b < world.bodies.size(); ++b) other.bodies[b].pose = world.bodies[b].pose;
  EXPECT_EQ(state_hash(other), state_hash(world));
  EXPECT_TRUE(missed_contacts(other).empty());
  EXPECT_TRUE(unequal_twins(other).empty());
}

// The program, killed for real ------------------------------------------------------------------

pid_t start_program(const std::vector<std::string>& arguments) {
  std::vector<char*> argv;
  static const std::string program = QUERN_PROGRAM;
  argv.push_back(const_cast<char*>(program.c_str()));
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child;
  for (const int file : {STDOUT_FILENO, STDERR_FILENO}) {
    if (freopen("/dev/null", "w", file == STDOUT_FILENO ? stdout : stderr) == nullptr) _exit(126);
  }
  execv(argv[0], argv.data());
  _exit(127);
}

int exit_code(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

// The value of a key of summary.json; empty if the file or the key is not there.
std::string summary_value(const std::string& folder, const std::string& key) {
  const std::string text = read_bytes(folder + "/summary.json");
  const std::size_t at = text.find("\"" + key + "\":");
  if (at == std::string::npos) return "";
  const std::size_t begin = text.find_first_not_of(" \"", at + key.size() + 3);
  return text.substr(begin, text.find_first_of("\",\n}", begin) - begin);
}

std::vector<std::string> program_run(const std::string& folder) {
  return {"run",   QUERN_SOURCE_DIR "/apps/scenes/lab_mill_spheres.toml",
          "--out", folder,
          "--set", "run.settle=none",
          "--set", "run.duration=0.2",
          "--set", "run.record_from=0.05",
          "--set", "run.tile_size=16",
          "--set", "output.checkpoint_every=0.02"};
}

class KilledRun : public testing::TestWithParam<int> {};

TEST_P(KilledRun, GoesOnToTheBitsOfTheStraightRun) {
  if (!std::filesystem::exists(QUERN_PROGRAM)) GTEST_SKIP() << "no program " << QUERN_PROGRAM;
  const int signal = GetParam();
  TempFolder straight, killed;
  std::vector<std::string> arguments = program_run(straight.path());
  arguments.insert(arguments.end(), {"--threads", "1"});
  ASSERT_EQ(exit_code(start_program(arguments)), 0);
  const std::string expected = summary_value(straight.path(), "state_hash");
  ASSERT_EQ(expected.size(), 16u);

  arguments = program_run(killed.path());
  arguments.insert(arguments.end(), {"--threads", "2"});
  int kills = 0;
  for (int attempt = 0; attempt < 6 && summary_value(killed.path(), "state_hash") != expected;
       ++attempt) {
    const pid_t child = start_program(arguments);
    // Kill the first three once there is a checkpoint to go on from, each a little later in its
    // run.
    if (attempt < 3) {
      for (int wait = 0; wait < 2000; ++wait) {
        if (std::filesystem::exists(killed / "checkpoint.h5")) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(40 + 60 * attempt));
      kill(child, signal);
    }
    const int code = exit_code(child);
    const std::string finished = summary_value(killed.path(), "finished");
    if (code == 1000 + signal || (code == 0 && finished == "false")) ++kills;
    EXPECT_TRUE(code == 0 || code == 1000 + signal) << code;
    arguments = {"resume", killed.path(), "--threads", attempt % 2 == 0 ? "1" : "3"};
  }
  EXPECT_GT(kills, 0) << "the run ended before it could be killed";
  EXPECT_EQ(summary_value(killed.path(), "state_hash"), expected);
}

INSTANTIATE_TEST_SUITE_P(Signals, KilledRun, testing::Values(SIGTERM, SIGKILL),
                         [](const auto& test) {
                           return test.param == SIGTERM ? "Terminated" : "Killed";
                         });

// The full slice, 35,000 spheres in 70 tiles: more than eight for each of eight threads.
TEST(SlowDeterminism, GivesTheSameBitsInAFullSlice) {
  const Start s(shipped_scene("sag_slice_small_sp", {"run.settle=none", "run.tile_size=512"}),
                3000);
  const std::uint64_t one = s.hash_after({});
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(s.hash_after({.threads = threads, .shuffle = 5}), one) << threads << " threads";
  }
  EXPECT_EQ(s.hash_after({.threads = 2, .resume_at = 1000}), one);
}

}  // namespace
}  // namespace quern
