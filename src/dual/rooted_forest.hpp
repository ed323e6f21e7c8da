// The trees of a forest from their roots down.
#pragma once

#include <vector>

#include "quadloom/dual.hpp"

namespace quadloom::dual {

struct RootedForest {
  std::vector<TriangleId> order;   // parents before children
  std::vector<HalfedgeId> upward;  // the node's edge to its parent, kNone for a root
};

/// The number of edges of the node.
int degree(const DualGraph& graph, TriangleId t);

/// Breadth first, each tree from its leaf with the smallest number. Throws Error kBadMesh if the graph
/// has a cycle. O(n).
RootedForest order_from_roots(const DualGraph& forest);

}  // namespace quadloom::dual
