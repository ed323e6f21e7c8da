// Codes of triangles in a given order, and of the best order for very few.
#pragma once

#include <vector>

#include "quadloom/strips.hpp"

namespace quadloom::strips {

/// The shortest code (kRepeat or kRestart) that draws the triangles in this order: each triangle is
/// drawn from the best of its six states, by dynamic programming. The order must have each triangle
/// once. O(n).
StripResult encode_order(const Triangulation& mesh, const std::vector<TriangleId>& order,
                         StripEncoding encoding);

inline constexpr std::size_t kMostExact = 12;

/// An order with the shortest code of all (kSwap: with the fewest strips), for at most kMostExact
/// triangles. O(2^n n^2).
std::vector<TriangleId> shortest_order(const Triangulation& mesh, StripEncoding encoding);

/// The paths of an order: cut where the next triangle is not beside the last one.
PathPartition paths_of_order(const Triangulation& mesh, const std::vector<TriangleId>& order);

}  // namespace quadloom::strips
