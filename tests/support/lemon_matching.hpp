// LEMON's matchings, for tests alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadloom::test {

/// An edge of a graph for LEMON, which needs C++17 and so a source file of its own.
struct LemonEdge {
  std::uint32_t from, to;
  std::int32_t weight;
};

/// The size and weight of a matching. `found` is false if there is no perfect matching.
struct LemonResult {
  bool found = true;
  std::size_t size = 0;
  std::int64_t weight = 0;
};

LemonResult lemon_maximum(std::size_t nodes, const std::vector<LemonEdge>& edges);
LemonResult lemon_maximum_weight(std::size_t nodes, const std::vector<LemonEdge>& edges);
LemonResult lemon_perfect(std::size_t nodes, const std::vector<LemonEdge>& edges);

}  // namespace quadloom::test
