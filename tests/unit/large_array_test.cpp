#include "core/large_array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

namespace quadloom {
namespace {

// Some megabytes are asked for in huge pages, and begin and end where they like.
TEST(LargeVector, HoldsWhatIsWrittenAtAnySize) {
  for (const std::size_t count : {0UL, 1UL, (1UL << 20) - 3, 1UL << 20, (3UL << 20) + 5}) {
    auto numbers = large_vector<std::uint32_t>(count, 7);
    ASSERT_EQ(numbers.size(), count);
    EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0}), 7 * count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    EXPECT_TRUE(numbers.empty() || numbers.back() == count - 1);
  }
}

TEST(LargeVector, HasRoomForAFewMore) {
  std::vector<std::uint32_t> numbers;
  reserve_large(numbers, with_room(1 << 21));
  numbers.resize(1 << 21);
  const std::uint32_t* const before = numbers.data();
  for (std::uint32_t i = 0; i < (1 << 21) / 64; ++i) numbers.push_back(i);
  EXPECT_EQ(numbers.data(), before);
}

TEST(LargeMemory, IsAlignedAndWritable) {
  for (const std::size_t count : {1UL, 1UL << 20, (1UL << 20) + 1}) {
    const LargeArray<double> numbers = large_array<double>(count);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.get()) % 64, 0U);
    numbers[count - 1] = 5;
    EXPECT_EQ(numbers[count - 1], 5);
  }
}

}  // namespace
}  // namespace quadloom
