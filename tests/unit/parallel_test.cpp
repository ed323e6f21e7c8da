#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "quadloom/core.hpp"
#include "support/on_threads.hpp"

#ifdef QUADLOOM_THREADS
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>
#endif

namespace quadloom {
namespace {

using Block = std::pair<std::size_t, std::size_t>;

std::set<Block> blocks(std::size_t count, std::size_t size) {
  std::vector<Block> found(count / size + 1);
  std::atomic<std::size_t> calls = 0;
  parallel_for_blocks(count, size, [&](std::size_t begin, std::size_t end) {
    found[begin / size] = {begin, end};
    ++calls;
  });
  found.resize(calls);
  return {found.begin(), found.end()};
}

TEST(ParallelForBlocks, HasTheSameBlocksOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 4}) {
    on_threads(threads, [] {
      EXPECT_EQ(blocks(0, 4), std::set<Block>{});
      EXPECT_EQ(blocks(3, 4), (std::set<Block>{{0, 3}}));
      EXPECT_EQ(blocks(8, 4), (std::set<Block>{{0, 4}, {4, 8}}));
      EXPECT_EQ(blocks(9, 4), (std::set<Block>{{0, 4}, {4, 8}, {8, 9}}));
    });
  }
}

TEST(ParallelForBlocks, DoesOneBlockOnTheThreadOfTheCaller) {
  std::thread::id worker;
  parallel_for_blocks(7, 8, [&](std::size_t, std::size_t) { worker = std::this_thread::get_id(); });
  EXPECT_EQ(worker, std::this_thread::get_id());
}

TEST(ParallelForBlocks, LetsAnExceptionThrough) {
  for (const int threads : {1, 2, 4}) {
    const auto work = [](std::size_t begin, std::size_t) {
      if (begin == 600) throw Error(ErrorCode::kNotFinite, "point 600", {begin});
    };
    try {
      on_threads(threads, [&] { parallel_for_blocks(10000, 6, work); });
      FAIL() << "nothing was thrown";
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kNotFinite);
      EXPECT_EQ(e.culprits(), std::vector<std::size_t>{600});
    }
  }
}

TEST(ParallelForBlocks, MayBeCalledInsideOfItself) {
  std::atomic<std::size_t> sum = 0;
  parallel_for_blocks(100, 10, [&](std::size_t begin, std::size_t end) {
    parallel_for_blocks(end - begin, 3, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) sum += begin + i;
    });
  });
  EXPECT_EQ(sum, 4950U);
}

#ifdef QUADLOOM_THREADS
TEST(ParallelForBlocks, LeavesNothingOutInsideOfWhatIsCancelled) {
  std::atomic<int> begun = 0, blocks = 0;
  tbb::task_group_context context;
  const auto outer = [&](int) {
    ++begun;
    context.cancel_group_execution();
    parallel_for_blocks(100, 10, [&](std::size_t, std::size_t) { ++blocks; });
  };
  tbb::parallel_for(0, 4, outer, tbb::simple_partitioner(), context);
  EXPECT_GE(begun, 1);
  EXPECT_EQ(blocks, 10 * begun);
}
#endif

TEST(ParallelTasksInOrder, DoAllAndThrowWhatTheFirstThrew) {
  for (const int threads : {1, 2, 4}) {
    std::atomic<int> calls = 0;
    const auto task = [&](std::size_t i) {
      ++calls;
      if (i % 10 == 7) throw Error(ErrorCode::kNotFinite, "task", {i});
    };
    try {
      on_threads(threads, [&] { parallel_tasks_in_order(100, task); });
      FAIL() << "nothing was thrown";
    } catch (const Error& e) {
      EXPECT_EQ(e.culprits(), std::vector<std::size_t>{7});
    }
    EXPECT_EQ(calls, 100);
  }
}

TEST(ParallelFor, CallsEachOnce) {
  for (const std::uint32_t count : {0U, 1U, 99U, 100U, 101U}) {
    std::vector<int> calls(count + 1);
    parallel_for(
        count, [&](std::uint32_t i) { ++calls[i]; }, 10);
    for (std::uint32_t i = 0; i <= count; ++i) EXPECT_EQ(calls[i], i < count ? 1 : 0);
  }
}

TEST(ParallelFind, FindsThemInOrder) {
  const auto seventh = [](std::uint32_t i) { return i % 7 == 6; };
  EXPECT_EQ(parallel_find(0, seventh, 10), std::vector<std::uint32_t>{});
  EXPECT_EQ(parallel_find(30, seventh, 10), (std::vector<std::uint32_t>{6, 13, 20, 27}));
  EXPECT_EQ(parallel_find(27, seventh, 30), (std::vector<std::uint32_t>{6, 13, 20}));
}

TEST(ParallelInvoke, CallsEachOnce) {
  int a = 0, b = 0, c = 0;
  parallel_invoke([&] { ++a; }, [&] { ++b; }, [&] { ++c; });
  EXPECT_EQ((std::vector{a, b, c}), (std::vector{1, 1, 1}));
}

/// The threads that take part in tasks which last until `wanted` of them have begun, or a while.
std::size_t threads_that_work(std::size_t wanted) {
  std::atomic<std::size_t> begun = 0;
  std::vector<std::thread::id> worker(wanted);
  parallel_tasks(wanted, [&](std::size_t i) {
    worker[i] = std::this_thread::get_id();
    ++begun;
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    while (begun < wanted && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  });
  return std::set(worker.begin(), worker.end()).size();
}

TEST(ThreadLimit, IsKept) {
  const ThreadLimit one(1);
  const ThreadLimit more(8);  // the least holds
  EXPECT_EQ(threads_that_work(3), 1U);
}

TEST(ThreadLimit, EndsWithItsLife) {
  { const ThreadLimit one(1); }
#ifdef QUADLOOM_THREADS
  if (std::thread::hardware_concurrency() > 1) {
    EXPECT_GT(threads_that_work(2), 1U);
  }
#endif
}

TEST(ThreadLimit, MayBeMoreThanThereCanBe) {
  constexpr auto most = std::numeric_limits<std::size_t>::max();
  for (const std::size_t threads : {most, most / 2 + 1}) {  // in 32 bits: -1 and 0
    const ThreadLimit limit(threads);
#ifdef QUADLOOM_THREADS
    if (std::thread::hardware_concurrency() > 1) {
      EXPECT_GT(threads_that_work(2), 1U);
    }
#endif
  }
}

TEST(ThreadLimit, RefusesNone) { EXPECT_THROW(ThreadLimit(0), Error); }

}  // namespace
}  // namespace quadloom
