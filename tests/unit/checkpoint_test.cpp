// Checkpoints: what is read is what was written, bit for bit, and no accident goes unnoticed.
//
// Accidents are made for real: every kind of byte flipped, files cut, the writer killed by SIGKILL
// at random moments, a file system that is full.
#include "io/checkpoint.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "io/file_commit.h"
#include "io/hdf5_file.h"
#include "io/seal.h"
#include "tests/support/temp_folder.h"

#if defined(__SANITIZE_ADDRESS__)
// HDF5 1.10 loses some 400 bytes for each damaged object it meets; our own leaks still show.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
#endif

namespace quern {
namespace {

struct Record {
  std::uint32_t partner;
  float spring[2];
};

// A small state with a column of every type, a record, rows of three, and loose values.
struct State {
  Column<double> position;
  Column<float> radius;
  Column<std::uint64_t> key;
  Column<std::uint32_t> id;
  Column<std::uint16_t> species;
  Column<std::uint8_t> flag;
  Column<std::int64_t> image;
  Column<Record> history;
  Column<double> empty;
  double clock[2] = {0, 0};
  std::uint64_t step = 0;

  explicit State(std::size_t n = 0, std::uint64_t seed = 0) : step(seed) {
    for (ColumnBase* column : columns()) fill(*column, n, seed);
    fill(position, 3 * n, seed + 1);
    empty.reset(0);
    clock[0] = static_cast<double>(seed) * 0.1;
    clock[1] = std::bit_cast<double>(0x7ff4dead0000beefu);  // a signalling NaN with a payload
  }
  std::vector<ColumnBase*> columns() {
    return {&position, &radius, &key, &id, &species, &flag, &image, &history};
  }
  // All bit patterns may occur: infinities, NaN payloads, denormals.
  static void fill(ColumnBase& column, std::size_t n, std::uint64_t seed) {
    column.reset(n);
    auto* bytes = static_cast<unsigned char*>(column.raw());
    std::uint64_t random = seed * 2 + 1;
    for (std::size_t i = 0; i < n * column.element_bytes(); ++i) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      bytes[i] = static_cast<unsigned char>(random >> 56);
    }
  }
  void visit(StateVisitor& visitor) {
    visitor.column("particles/position", "m", position, 3);
    visitor.column("particles/radius", "m", radius, 1);
    visitor.column("particles/key", "1", key, 1);
    visitor.column("particles/id", "1", id, 1);
    visitor.column("particles/species", "1", species, 1);
    visitor.column("particles/flag", "1", flag, 1);
    visitor.column("particles/image", "1", image, 1);
    visitor.column("pairs/sphere_sphere/history", "m", history, 1);
    visitor.column("pairs/empty", "J", empty, 1);
    visitor.values("clock", "s", ElementType::kF64, clock, 2);
    visitor.values("step", "1", ElementType::kU64, &step, 1);
  }
};

bool same_bits(State& a, State& b) {
  const auto left = a.columns(), right = b.columns();
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i]->size() != right[i]->size()) return false;
    if (left[i]->size() > 0 && std::memcmp(left[i]->raw(), right[i]->raw(),
                                           left[i]->size() * left[i]->element_bytes()) != 0) {
      return false;
    }
  }
  return a.empty.size() == b.empty.size() && a.step == b.step &&
         std::memcmp(a.clock, b.clock, sizeof a.clock) == 0;
}

CheckpointHeader header_of(std::uint64_t step) {
  return {"[run]\nduration = \"1 s\"  # \u00b5\n", "lab_mill", "AVX2", "mixed", "0.1.0",
          0.1 * static_cast<double>(step),         step};
}

void write(const std::string& folder, State& state) {
  write_checkpoint(folder, header_of(state.step), [&](StateVisitor& v) { state.visit(v); });
}

void read(const std::string& path, State& state) {
  read_checkpoint(path, [&](StateVisitor& v) { state.visit(v); });
}

template <class Action>
std::string complaint_of(Action&& action) {
  try {
    action();
  } catch (const SystemError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Runs `action` in a child process; its return value is the exit status. The child exits as a
// program does, so that a clean-up at exit that crashes would show.
template <class Action>
pid_t in_child(Action&& action) {
  const pid_t child = fork();
  if (child == 0) std::exit(action());
  return child;
}

int exit_status(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Checkpoint, ReturnsEveryBit) {
  const TempFolder folder;
  for (const std::size_t n : {0u, 1u, 1000u, 100000u}) {
    State written(n, n + 7), found(5, 1);
    write(folder.path(), written);
    read(folder / "checkpoint.h5", found);
    EXPECT_TRUE(same_bits(written, found)) << n;
  }
}

TEST(Checkpoint, ReturnsItsHeader) {
  const TempFolder folder;
  State state(3, 12345678901234567u);
  write(folder.path(), state);
  const CheckpointHeader want = header_of(state.step);
  const CheckpointHeader found = read_checkpoint_header(folder / "checkpoint.h5");
  EXPECT_EQ(found.scene_text, want.scene_text);
  EXPECT_EQ(found.scene_name, want.scene_name);
  EXPECT_EQ(found.simd_target, want.simd_target);
  EXPECT_EQ(found.precision, want.precision);
  EXPECT_EQ(found.version, want.version);
  EXPECT_EQ(found.time, want.time);
  EXPECT_EQ(found.step, want.step);
}

TEST(Checkpoint, TakesALongSceneAndAnEmptyOne) {
  const TempFolder folder;
  for (const std::size_t length : {std::size_t{0}, std::size_t{300000}}) {
    State state(1, 1);
    CheckpointHeader header = header_of(1);
    header.scene_text.assign(length, 'x');
    write_checkpoint(folder.path(), header, [&](StateVisitor& v) { state.visit(v); });
    EXPECT_EQ(read_checkpoint_header(folder / "checkpoint.h5").scene_text, header.scene_text);
  }
}

TEST(Checkpoint, IsTheSameFileForTheSameState) {
  const TempFolder a, b;
  State state(1000, 3);
  write(a.path(), state);
  usleep(1100000);  // a time of day in the file would show
  write(b.path(), state);
  EXPECT_TRUE(read_bytes(a / "checkpoint.h5") == read_bytes(b / "checkpoint.h5"));
}

TEST(Checkpoint, KeepsThePreviousOne) {
  const TempFolder folder;
  State first(10, 1), second(20, 2), found;
  write(folder.path(), first);
  EXPECT_FALSE(std::filesystem::exists(folder / "checkpoint.previous.h5"));
  write(folder.path(), second);
  read(folder / "checkpoint.previous.h5", found);
  EXPECT_TRUE(same_bits(first, found));
  std::string warning = "old";
  EXPECT_EQ(usable_checkpoint(folder.path(), &warning), folder / "checkpoint.h5");
  EXPECT_EQ(warning, "");
  EXPECT_FALSE(std::filesystem::exists(folder / "checkpoint.h5.tmp"));
}

// Who waits for a run's checkpoint may look at any moment.
TEST(Checkpoint, IsThereWhileItIsReplaced) {
  const TempFolder folder;
  const std::string path = folder / "file", kept = folder / "kept";
  write_text_file("file", path, "text", Durability::kKill);
  std::atomic<bool> ended = false;
  std::atomic<std::size_t> looks = 0, absent = 0;
  std::thread watcher([&] {
    for (; !ended; ++looks) absent += ::access(path.c_str(), F_OK) != 0;
  });
  while (looks == 0) std::this_thread::yield();
  for (int n = 0; n < 3000; ++n) {
    PendingFile pending("file", path);
    std::ofstream(pending.temporary()) << n;
    pending.commit(Durability::kKill, kept);
    EXPECT_EQ(read_text_file("file", kept), n == 0 ? "text" : std::to_string(n - 1));
  }
  ended = true;
  watcher.join();
  EXPECT_EQ(absent, 0);
  EXPECT_FALSE(std::filesystem::exists(kept + ".tmp"));
}

TEST(Checkpoint, NoticesEveryFlippedByte) {
  const TempFolder folder;
  State state(40, 3);
  write(folder.path(), state);
  const std::string path = folder / "checkpoint.h5", whole = read_bytes(path);
  ASSERT_GT(whole.size(), 4000u);
  for (std::size_t i = 0; i < whole.size(); i += 3) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
    write_bytes(path, damaged);
    EXPECT_FALSE(complaint_of([&] { verify_checkpoint(path); }).empty()) << "byte " << i;
  }
}

// What the seal does not know of: it is of the file as written, this is wrong before. Of HDF5 too,
// whose checksum of zeros is zero, so that blocks which never reached the disk pass it.
TEST(Checkpoint, NoticesDataThatBecameZeros) {
  const TempFolder folder;
  State state(4000, 3);
  write(folder.path(), state);
  const std::string path = folder / "checkpoint.h5";
  std::string bytes = read_bytes(path);
  const std::string needle(static_cast<const char*>(state.position.raw()), 64);
  const std::size_t at = bytes.find(needle), size = state.position.size() * 8 + 4;
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, size, size, '\0');
  write_bytes(path, bytes);
  seal_file("checkpoint", path);
  const std::string complaint = complaint_of([&] { verify_checkpoint(path); });
  EXPECT_TRUE(contains(complaint, "wrong hash")) << complaint;
}

TEST(Checkpoint, DamagedLeadsToThePreviousOne) {
  const TempFolder folder;
  State first(500, 1), second(500, 2), found;
  write(folder.path(), first);
  write(folder.path(), second);
  const std::string path = folder / "checkpoint.h5";
  std::string bytes = read_bytes(path);
  const std::string needle(static_cast<const char*>(second.position.raw()), 64);
  bytes[bytes.find(needle) + 100] ^= 4;
  write_bytes(path, bytes);
  std::string warning;
  const std::string usable = usable_checkpoint(folder.path(), &warning);
  EXPECT_EQ(usable, folder / "checkpoint.previous.h5");
  EXPECT_TRUE(contains(warning, "previous") && contains(warning, "cannot read checkpoint '" + path))
      << warning;
  read(usable, found);
  EXPECT_TRUE(same_bits(first, found));
}

TEST(Checkpoint, CutAnywhereLeadsToThePreviousOne) {
  const TempFolder folder;
  State first(500, 1), second(500, 2);
  write(folder.path(), first);
  write(folder.path(), second);
  const std::string path = folder / "checkpoint.h5", whole = read_bytes(path);
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{7}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    write_bytes(path, whole.substr(0, size));
    EXPECT_EQ(usable_checkpoint(folder.path()), folder / "checkpoint.previous.h5") << size;
  }
}

TEST(Checkpoint, NoneUsableSaysWhyForBoth) {
  const TempFolder folder;
  const std::string complaint = complaint_of([&] { usable_checkpoint(folder.path()); });
  EXPECT_TRUE(contains(complaint, "checkpoint.h5") && contains(complaint, "previous") &&
              contains(complaint, "No such file"))
      << complaint;
}

TEST(Checkpoint, RefusesAnotherElementType) {
  const TempFolder folder;
  Column<float> narrow;
  narrow.reset(4);
  narrow.fill(1);
  write_checkpoint(folder.path(), header_of(1),
                   [&](StateVisitor& v) { v.column("x", "m", narrow, 1); });
  const auto complaint = [&](ColumnBase& column, std::size_t components) {
    return complaint_of([&] {
      read_checkpoint(folder / "checkpoint.h5",
                      [&](StateVisitor& v) { v.column("x", "m", column, components); });
    });
  };
  Column<double> wide;
  Column<Record> record;
  EXPECT_TRUE(contains(complaint(wide, 1), "'state/x': holds 4 of f32, expected 4 of f64"))
      << complaint(wide, 1);
  EXPECT_NE(complaint(narrow, 2), "");
  EXPECT_NE(complaint(record, 1), "");
  EXPECT_EQ(complaint(narrow, 1), "");
}

TEST(Checkpoint, RefusesARecordOfAnotherSize) {
  struct Longer {
    Record record;
    float more;
  };
  const TempFolder folder;
  Column<Record> written;
  Column<Longer> found;
  State::fill(written, 6, 1);
  write_checkpoint(folder.path(), header_of(1),
                   [&](StateVisitor& v) { v.column("x", "m", written, 1); });
  EXPECT_THROW(read_checkpoint(folder / "checkpoint.h5",
                               [&](StateVisitor& v) { v.column("x", "m", found, 1); }),
               SystemError);
}

TEST(Checkpoint, RefusesValuesOfAnotherCount) {
  const TempFolder folder;
  double values[3] = {1, 2, 3};
  write_checkpoint(folder.path(), header_of(1),
                   [&](StateVisitor& v) { v.values("x", "m", ElementType::kF64, values, 3); });
  EXPECT_THROW(
      read_checkpoint(folder / "checkpoint.h5",
                      [&](StateVisitor& v) { v.values("x", "m", ElementType::kF64, values, 2); }),
      SystemError);
}

TEST(Checkpoint, RefusesWhatIsMissingAndWhatIsLeftOver) {
  const TempFolder folder;
  double a = 1, b = 2;
  const auto visit_a = [&](StateVisitor& v) { v.values("a", "m", ElementType::kF64, &a, 1); };
  const auto visit_both = [&](StateVisitor& v) {
    visit_a(v);
    v.values("group/b", "m", ElementType::kF64, &b, 1);
  };
  const std::string path = folder / "checkpoint.h5";
  write_checkpoint(folder.path(), header_of(1), visit_a);
  EXPECT_TRUE(contains(complaint_of([&] { read_checkpoint(path, visit_both); }),
                       "'state/group/b': missing"));
  write_checkpoint(folder.path(), header_of(1), visit_both);
  EXPECT_TRUE(contains(complaint_of([&] { read_checkpoint(path, visit_a); }),
                       "'state/group/b': this scene has no such state"));
}

TEST(Checkpoint, RefusesAFileWithoutASeal) {
  const TempFolder folder;
  State state(1, 1);
  write(folder.path(), state);
  const std::string path = folder / "checkpoint.h5";
  { Hdf5File(std::string("checkpoint"), path, FileMode::kUpdate).set_attribute("/", "time", 1.0); }
  EXPECT_TRUE(contains(complaint_of([&] { read_checkpoint_header(path); }), "no seal"));
}

TEST(Checkpoint, RefusesAnotherFormat) {
  const TempFolder folder;
  State state(1, 1);
  write(folder.path(), state);
  {
    Hdf5File file("checkpoint", folder / "checkpoint.h5", FileMode::kUpdate);
    file.set_attribute("/", "format", std::uint64_t{99});
  }
  seal_file("checkpoint", folder / "checkpoint.h5");
  EXPECT_TRUE(contains(complaint_of([&] { read_checkpoint_header(folder / "checkpoint.h5"); }),
                       "format 99"));
}

// What a damaged or made-up file claims to hold is not asked of the memory.
TEST(Checkpoint, RefusesAnArrayLargerThanItsFile) {
  const TempFolder folder;
  const std::string path = folder / "checkpoint.h5";
  Column<double> x;
  x.reset(0);
  write_checkpoint(folder.path(), header_of(1), [&](StateVisitor& v) { v.column("x", "m", x, 1); });
  {
    Hdf5File file("checkpoint", path, FileMode::kUpdate);
    file.resize_series(file.create_series("state/y"), std::size_t{1} << 50);
  }
  seal_file("checkpoint", path);
  const std::string complaint = complaint_of([&] { verify_checkpoint(path); });
  EXPECT_TRUE(contains(complaint, "'state/y': it is larger than the file")) << complaint;
}

TEST(Checkpoint, NamesPathAndReasonWhenItCannotBeWritten) {
  const TempFolder folder;
  write_bytes(folder / "file", "x");
  State state(1, 1);
  const std::string complaint = complaint_of([&] { write(folder / "file", state); });
  EXPECT_TRUE(contains(complaint, "cannot write checkpoint '" + (folder / "file"))) << complaint;
}

// The child's file sizes are limited, which stands for a full disk; SIGXFSZ would kill it.
TEST(Checkpoint, FullDiskIsReportedAndHarmsNothing) {
  const TempFolder folder;
  State small(10, 1), large(100000, 2), found;
  write(folder.path(), small);
  const pid_t child = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit unlimited = {RLIM_INFINITY, RLIM_INFINITY}, limit = {100000, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string complaint = complaint_of([&] { write(folder.path(), large); });
    if (!contains(complaint, "cannot write checkpoint") || !contains(complaint, "too large")) {
      return 1;
    }
    if (std::filesystem::exists(folder / "checkpoint.h5.tmp")) return 3;
    State kept;
    read(folder / "checkpoint.h5", kept);
    if (!same_bits(small, kept)) return 2;
    setrlimit(RLIMIT_FSIZE, &unlimited);  // room again: the same process can go on
    write(folder.path(), large);
    return 0;
  });
  EXPECT_EQ(exit_status(child), 0);
  read(folder / "checkpoint.h5", found);
  EXPECT_TRUE(same_bits(large, found));
}

TEST(Checkpoint, KilledWriterLeavesAWholeOne) {
  const TempFolder folder;
  for (int round = 0; round < 12; ++round) {
    const pid_t child = in_child([&] {
      for (std::uint64_t step = 1;; ++step) {
        State state(20000, step);
        write(folder.path(), state);
      }
      return 0;
    });
    while (!std::filesystem::exists(folder / "checkpoint.h5")) usleep(1000);
    usleep(static_cast<useconds_t>(3000 + 2711 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::string usable = usable_checkpoint(folder.path());
    State found;
    read(usable, found);
    State want(20000, found.step);
    EXPECT_TRUE(same_bits(want, found)) << "round " << round;
    EXPECT_EQ(read_checkpoint_header(usable).step, found.step);
  }
}

}  // namespace
}  // namespace quern
