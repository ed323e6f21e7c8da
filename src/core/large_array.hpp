// Memory for large arrays, not touched before it is written.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <type_traits>
#include <vector>

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

/// Asks for huge pages for memory that has not been touched yet, if it is some megabytes.
void wish_huge_pages(void* memory, std::size_t bytes);

/// As array.reserve(count), in huge pages: for arrays that are filled once, and are large if the input is.
template <typename T>
void reserve_large(std::vector<T>& array, std::size_t count) {
  array.reserve(count);
  wish_huge_pages(array.data(), array.capacity() * sizeof(T));
}

/// Room for one in 64 more, for arrays to which some elements will be added: growing would copy them all. What is
/// not written to takes no memory.
constexpr std::size_t with_room(std::size_t count) { return count + count / 64; }

/// An array of so many.
template <typename T>
std::vector<T> large_vector(std::size_t count, const T& value = T()) {
  std::vector<T> array;
  reserve_large(array, count);
  array.resize(count, value);
  return array;
}

template <typename T>
LargeArray<T> large_array(std::size_t count) {
  static_assert(std::is_trivial_v<T>);
  return LargeArray<T>(static_cast<T*>(large_memory(count * sizeof(T))));
}

}  // namespace quadloom
