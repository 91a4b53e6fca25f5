#include "scheduler/graph.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <numeric>

#include "scheduler/random.h"
#include "scheduler/stage_times.h"

namespace quern {

struct Graph::Arena {
  explicit Arena(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        arena(threads) {}
  tbb::global_control control;
  tbb::task_arena arena;
};

Graph::Graph(int threads)
    : threads_(threads > 0 ? threads : tbb::info::default_concurrency()),
      arena_(threads_ > 1 ? std::make_unique<Arena>(threads_) : nullptr) {}

Graph::~Graph() = default;

void Graph::for_each(std::size_t count, const std::function<void(std::size_t, int)>& task) {
  if (shuffle_seed_ != 0) {
    queue_.resize(count);
    std::iota(queue_.begin(), queue_.end(), std::size_t{0});
    CounterRandom random(shuffle_seed_);
    for (std::size_t k = count; k > 1; --k) std::swap(queue_[k - 1], queue_[random.bits() % k]);
    ++shuffle_seed_;
  }
  const auto run = [&](std::size_t k, int worker) {
    task(shuffle_seed_ != 0 ? queue_[k] : k, worker);
  };
  if (count < 2) {
    if (count == 1) run(0, 0);
    return;
  }
  Stopwatch watch;
  if (!arena_) {
    for (std::size_t k = 0; k < count; ++k) run(k, 0);
  } else {
    arena_->arena.execute([&] {
      tbb::parallel_for(
          std::size_t{0}, count,
          [&](std::size_t k) { run(k, tbb::this_task_arena::current_thread_index()); },
          tbb::simple_partitioner());
    });
  }
  shared_time_ += watch.lap();
}

void Graph::sort(std::vector<CurveKey>& keys) {
  Stopwatch watch;
  if (!arena_) {
    std::sort(keys.begin(), keys.end());
  } else {
    arena_->arena.execute([&] { tbb::parallel_sort(keys.begin(), keys.end()); });
  }
  shared_time_ += watch.lap();
}

}  // namespace quern
