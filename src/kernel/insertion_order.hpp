// Step 3 of the algorithm in delaunay.cpp: in which order the points are inserted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadloom::kernel {

/// Rounds, the coarsest first, each about eight times as long as the one before. In a round the points
/// follow the curve.
struct InsertionOrder {
  std::vector<std::uint32_t> point;
  std::vector<std::size_t> round_begin;  // and in the end the number of points
};

/// Of `n` points numbered along a curve.
InsertionOrder insertion_order(std::size_t n);

}  // namespace quadloom::kernel
