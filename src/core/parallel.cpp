#include "core/parallel.hpp"

#include <algorithm>
#include <exception>
#include <vector>

#include "quadloom/core.hpp"

#ifdef QUADLOOM_THREADS
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_group.h>
#endif

namespace quadloom {

#ifdef QUADLOOM_THREADS

// One task a thread has not begun can be taken by another: tasks are long, so none are put together. The
// context is isolated: where an exception ends tasks that these are inside of, ours or the caller's, a
// bound one would leave tasks out and return as if all were done.
void parallel_tasks(std::size_t count, const std::function<void(std::size_t)>& task) {
  if (count == 1) return task(0);
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_for(std::size_t{0}, count, task, tbb::simple_partitioner(), context);
}

struct ThreadLimit::Control {
  static constexpr std::size_t kMost = std::size_t{1} << 16;  // oneTBB counts in 32 bits

  explicit Control(std::size_t threads)
      : limit(tbb::global_control::max_allowed_parallelism, std::min(threads, kMost)) {}
  tbb::global_control limit;
};

#else

void parallel_tasks(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = 0; i < count; ++i) task(i);
}

struct ThreadLimit::Control {
  explicit Control(std::size_t) {}
};

#endif

void parallel_tasks_in_order(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::vector<std::exception_ptr> errors(count);
  parallel_tasks(count, [&](std::size_t i) {
    try {
      task(i);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

ThreadLimit::ThreadLimit(std::size_t threads) {
  if (threads == 0) throw Error(ErrorCode::kBadOption, "there must be at least one thread, not 0");
  control_ = std::make_unique<Control>(threads);
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace quadloom
