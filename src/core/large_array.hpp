// Memory for large arrays, not touched before it is written.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <type_traits>

namespace quadloom {

struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};

/// Objects without values until they are written; pages are first touched by whoever writes them.
template <typename T>
using LargeArray = std::unique_ptr<T[], FreeMemory>;

/// Throws std::bad_alloc. On Linux the memory of some megabytes is in huge pages if the system has
/// them: one fault for 2 MiB instead of 512, a tenth of the time of delaunay().
void* large_memory(std::size_t bytes);

template <typename T>
LargeArray<T> large_array(std::size_t count) {
  static_assert(std::is_trivial_v<T>);
  return LargeArray<T>(static_cast<T*>(large_memory(count * sizeof(T))));
}

}  // namespace quadloom
