// Points from left to right.
#pragma once

#include <span>
#include <vector>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// Points in lexicographic order, and where each was.
struct LexOrder {
  std::vector<Point> points;
  std::vector<VertexId> index;
};

/// Finite points; equal ones in the order of their indices. O(n log n), O(n) if they are spread over
/// their extent in x.
LexOrder lex_order(std::span<const Point> points);

}  // namespace quadloom::kernel
