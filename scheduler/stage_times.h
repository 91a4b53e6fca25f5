// Where the time of a step goes.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace quern {

// What tasks of a step do; each belongs to one of the threads.
enum class Stage : std::uint8_t {
  kSphereWalls,
  kSpherePairs,
  kPolyhedronSpheres,
  kPolyhedronPairs,
  kPolyhedronWalls,
  kMotion,
};
inline constexpr std::array<const char*, 6> kStageNames = {
    "sphere_walls",     "sphere_pairs",     "polyhedron_spheres",
    "polyhedron_pairs", "polyhedron_walls", "motion",
};

struct StageTimes {
  double rebuild = 0, tasks = 0, totals = 0;      // s, of the clock
  double shared = 0;  // s, of the clock: the part of these that more threads could share
  std::uint64_t rebuilds = 0;
  std::array<double, kStageNames.size()> busy{};  // s, of all threads: the tasks by stage
};

class Stopwatch {
 public:
  // Seconds since it was made or last asked.
  double lap() {
    const Clock::time_point now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

// What one thread has spent; on a cache line of its own.
struct alignas(64) BusyTimes {
  std::array<double, kStageNames.size()> busy{};
  void add(Stage stage, Stopwatch& watch) { busy[static_cast<std::size_t>(stage)] += watch.lap(); }
};

}  // namespace quern
