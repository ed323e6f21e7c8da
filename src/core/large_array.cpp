#include "core/large_array.hpp"

#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace quadloom {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21, kPage = 4096, kCacheLine = 64;
constexpr std::size_t kLarge = 2 * kHugePage;  // bytes

}  // namespace

void* large_memory(std::size_t bytes) {
  const std::size_t unit = bytes >= kLarge ? kHugePage : kCacheLine;
  void* const memory = std::aligned_alloc(unit, (bytes / unit + 1) * unit);
  if (memory == nullptr) throw std::bad_alloc();
  wish_huge_pages(memory, bytes);
  return memory;
}

// The system takes whole pages; of larger ones than these it does not take some, and answers so.
void wish_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  if (bytes < kLarge) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::size_t skip = (kPage - begin % kPage) % kPage;
  madvise(static_cast<char*>(memory) + skip, (bytes - skip) / kPage * kPage, MADV_HUGEPAGE);
#endif
}

}  // namespace quadloom
