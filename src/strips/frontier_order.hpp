// An order of the nodes of a dual graph in which few edges lead from the first nodes to the rest.
#pragma once

#include <vector>

#include "quadloom/dual.hpp"

namespace quadloom::strips {

struct FrontierOrder {
  std::vector<TriangleId> node;
  std::size_t width = 0;  // the most edges that lead from a beginning of the order to the rest
};

/// The best of a few greedy orders of a connected graph. O(n log n).
FrontierOrder frontier_order(const DualGraph& graph, const Progress& progress = {});

}  // namespace quadloom::strips
