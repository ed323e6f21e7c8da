#include "kernel/insertion_order.hpp"

#include <algorithm>
#include <utility>

#include "core/large_array.hpp"
#include "core/parallel.hpp"

namespace quadloom::kernel {
namespace {

/// Of so many neighbours along the curve one belongs to an earlier round.
constexpr std::size_t kRatio = 8;
constexpr std::size_t kFirstRound = 64;
constexpr std::size_t kBlock = std::size_t{1} << 14;  // a multiple of kRatio

/// A fixed hash, so that the choice of the early points owes nothing to their order.
std::uint64_t hash(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// Parts the points number(0) to number(size - 1): the chosen ones are returned, the others go to
/// `round`. What is left of kRatio in the end has no chosen one.
template <typename Number>
std::vector<std::uint32_t> part_round(std::size_t size, const Number& number,
                                      std::uint32_t* round) {
  std::vector<std::uint32_t> chosen(size / kRatio);
  parallel_for_blocks(size, kBlock, [&](std::size_t begin, std::size_t end) {
    std::uint32_t* to = round + (begin - begin / kRatio);
    for (std::size_t group = begin; group < end; group += kRatio) {
      const bool whole = group + kRatio <= size;
      const std::size_t earlier = whole ? group + hash(group + size) % kRatio : size;
      for (std::size_t i = group; i < std::min(group + kRatio, size); ++i) {
        if (i != earlier) *to++ = number(i);
      }
      if (whole) chosen[group / kRatio] = number(earlier);
    }
  });
  return chosen;
}

}  // namespace

InsertionOrder insertion_order(std::size_t n) {
  InsertionOrder order;
  order.point = large_vector<std::uint32_t>(n);
  order.round_begin = {n};
  const auto round = [&](std::size_t size, const auto& number) {
    order.round_begin.push_back(size / kRatio);
    return part_round(size, number, order.point.data() + size / kRatio);
  };
  std::vector<std::uint32_t> left;
  const auto of_left = [&](std::size_t i) { return left[i]; };
  const auto itself = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
  std::size_t size = n;
  for (; size > kFirstRound; size /= kRatio) {
    left = size == n ? round(size, itself) : round(size, of_left);
  }
  for (std::size_t i = 0; i < size; ++i) order.point[i] = size == n ? itself(i) : left[i];
  order.round_begin.push_back(0);
  std::reverse(order.round_begin.begin(), order.round_begin.end());
  return order;
}

}  // namespace quadloom::kernel
