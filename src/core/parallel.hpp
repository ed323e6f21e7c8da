// Work on several threads. Results must not depend on how many there are: blocks have a size of their
// own, each writes what is its alone, and what is summed up is summed in the order of the blocks.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace quadloom {

/// Calls task(0) to task(count - 1), each once, on this thread and others, and returns when all are
/// done. If one throws, those not begun are left out and the exception comes through; of several, any
/// one does. Inside of a task that is no longer wanted all are done likewise. A task must neither wait for
/// another one nor report progress.
void parallel_tasks(std::size_t count, const std::function<void(std::size_t)>& task);

/// The same, but none is left out, and of several exceptions that of the first task comes through, as if the
/// tasks were done one after the other.
void parallel_tasks_in_order(std::size_t count, const std::function<void(std::size_t)>& task);

/// Calls work(begin, end) for [0, block), [block, 2 block), ... up to `count`. One block is done at
/// once, on this thread.
template <typename Work>
void parallel_for_blocks(std::size_t count, std::size_t block, const Work& work) {
  const auto task = [&](std::size_t i) { work(i * block, std::min(count, (i + 1) * block)); };
  parallel_tasks(count / block + (count % block != 0 ? 1 : 0), std::cref(task));
}

inline constexpr std::size_t kPartOfPass = std::size_t{1}
                                           << 14;  // elements, for a task of a pass over many

/// Calls work(i) for each 32-bit number i below `count`, a block at once on this thread.
template <typename Work>
void parallel_for(std::size_t count, const Work& work, std::size_t block = kPartOfPass) {
  parallel_for_blocks(count, block, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) work(i);
  });
}

/// Those of the numbers below `count` of which `has` is true, in order.
template <typename Has>
std::vector<std::uint32_t> parallel_find(std::size_t count, const Has& has,
                                         std::size_t block = kPartOfPass) {
  std::vector<std::vector<std::uint32_t>> found(count / block + 1);
  parallel_for_blocks(count, block, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
      if (has(i)) found[begin / block].push_back(i);
    }
  });
  std::vector<std::uint32_t> all;
  for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Calls each of them.
template <typename... Works>
void parallel_invoke(const Works&... works) {
  const std::array<std::function<void()>, sizeof...(Works)> all = {std::cref(works)...};
  parallel_tasks(all.size(), [&](std::size_t i) { all[i](); });
}

}  // namespace quadloom
