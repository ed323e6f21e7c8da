#include "core/large_array.hpp"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace quadloom {

void* large_memory(std::size_t bytes) {
  constexpr std::size_t kHugePage = std::size_t{1} << 21, kCacheLine = 64;
  const bool large = bytes >= 2 * kHugePage;
  const std::size_t unit = large ? kHugePage : kCacheLine;
  void* const memory = std::aligned_alloc(unit, (bytes / unit + 1) * unit);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (large) madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: what it answers does not matter
#endif
  return memory;
}

}  // namespace quadloom
