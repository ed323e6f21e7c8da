// The trees of a forest from their roots down. Cost: O(n), no recursion.
#include "dual/rooted_forest.hpp"

namespace quadloom::dual {
namespace {

/// Appends the tree of `root` to the order.
void append_tree(const DualGraph& forest, TriangleId root, RootedForest& out,
                 std::vector<std::uint8_t>& seen) {
  std::size_t next = out.order.size();
  seen[root] = 1;
  for (out.order.push_back(root); next < out.order.size(); ++next) {
    const TriangleId t = out.order[next];
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (forest.twin[h] == kNone || h == out.upward[t]) continue;
      const TriangleId child = forest.across(h);
      if (seen[child] != 0) {
        throw Error(ErrorCode::kBadMesh, "the graph is not a forest: a cycle ends here",
                    {t, child});
      }
      seen[child] = 1;
      out.upward[child] = forest.twin[h];
      out.order.push_back(child);
    }
  }
}

}  // namespace

int degree(const DualGraph& graph, TriangleId t) {
  int edges = 0;
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) edges += graph.twin[h] != kNone;
  return edges;
}

RootedForest order_from_roots(const DualGraph& forest) {
  RootedForest out;
  out.order.reserve(forest.node_count());
  out.upward.assign(forest.node_count(), kNone);
  std::vector<std::uint8_t> seen(forest.node_count());
  for (TriangleId t = 0; t < forest.node_count(); ++t) {
    if (seen[t] == 0 && degree(forest, t) <= 1) append_tree(forest, t, out, seen);
  }
  for (TriangleId t = 0; t < forest.node_count(); ++t) {
    if (seen[t] == 0) {
      throw Error(ErrorCode::kBadMesh, "the graph is not a forest: a component has no leaf", {t});
    }
  }
  return out;
}

}  // namespace quadloom::dual
