// Graph: runs the tasks of a step over the tiles; the only code that includes oneTBB is graph.cpp.
//
// Tiles are the unit of work: nobody shares a write, so the order in which tiles run can't change a
// bit of the result. shuffle(seed) makes the queue run in another order, to prove it in tests.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "soa/base.h"

namespace quern {

// A particle's place on the space-filling curve; no two are equal.
struct CurveKey {
  std::uint64_t curve;
  Index id, row;
  auto operator<=>(const CurveKey&) const = default;
};

class Graph {
 public:
  // threads 0: all that this process may use.
  explicit Graph(int threads);
  ~Graph();
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  int threads() const { return threads_; }
  void shuffle(std::uint64_t seed) { shuffle_seed_ = seed; }

  // Runs task(k, worker) for k = 0 ... count-1; worker is below threads() and belongs to one thread
  // at a time. Returns when all are done; the first exception of a task is rethrown.
  void for_each(std::size_t count, const std::function<void(std::size_t, int)>& task);
  void sort(std::vector<CurveKey>& keys);  // ascending

  // s of the clock in the above where there was work for more than one thread, however many there
  // are; since the graph was made or this was last called.
  double take_shared_time() { return std::exchange(shared_time_, 0.0); }

 private:
  struct Arena;
  int threads_;
  std::uint64_t shuffle_seed_ = 0;
  double shared_time_ = 0;
  std::vector<std::size_t> queue_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace quern
