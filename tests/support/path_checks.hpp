// Paths of triangles by brute force.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "quadloom/strips.hpp"

namespace quadloom::test {

/// The fewest paths that part a graph of few edges: every set of edges is tried.
inline std::size_t brute_force_paths(const DualGraph& graph) {
  std::vector<HalfedgeId> edges;
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] != kNone && graph.twin[h] < h) edges.push_back(h);
  }
  std::size_t most = 0;
  std::vector<TriangleId> root(graph.node_count());
  std::vector<int> degree(graph.node_count());
  for (std::size_t set = 0; set < std::size_t{1} << edges.size(); ++set) {
    std::iota(root.begin(), root.end(), 0);
    std::fill(degree.begin(), degree.end(), 0);
    const auto find = [&](TriangleId t) {
      while (root[t] != t) t = root[t];
      return t;
    };
    std::size_t count = 0;
    bool paths = true;
    for (std::size_t i = 0; i < edges.size() && paths; ++i) {
      if ((set >> i & 1) == 0) continue;
      const TriangleId a = triangle_of(edges[i]), b = graph.across(edges[i]);
      paths = ++degree[a] <= 2 && ++degree[b] <= 2 && find(a) != find(b);
      root[find(a)] = find(b);
      ++count;
    }
    if (paths) most = std::max(most, count);
  }
  return graph.node_count() - most;
}

}  // namespace quadloom::test
