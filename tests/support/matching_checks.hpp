// Small graphs of degree at most three, and their best matchings by brute force.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "quadloom/dual.hpp"

namespace quadloom::test {

inline void add_edge(DualGraph& graph, HalfedgeId h, HalfedgeId g) {
  graph.twin[h] = g;
  graph.twin[g] = h;
}

/// n nodes, about `edges` of the most possible edges (1.5 n) between random slots, double edges
/// included.
inline DualGraph random_graph(TriangleId n, double edges, Random& random) {
  DualGraph graph{std::vector<HalfedgeId>(3 * std::size_t{n}, kNone)};
  std::vector<HalfedgeId> slots(3 * std::size_t{n});
  for (HalfedgeId h = 0; h < slots.size(); ++h) slots[h] = h;
  for (std::size_t i = slots.size(); i > 1; --i) std::swap(slots[i - 1], slots[random.below(i)]);
  for (std::size_t i = 0; i + 1 < slots.size(); i += 2) {
    if (triangle_of(slots[i]) == triangle_of(slots[i + 1]) || random.uniform() > edges) continue;
    add_edge(graph, slots[i], slots[i + 1]);
  }
  return graph;
}

/// A forest of n nodes: each node but a few joins an earlier one that has a slot left. With
/// `stringy` the trees are deep.
inline DualGraph random_forest(TriangleId n, bool stringy, Random& random) {
  DualGraph graph{std::vector<HalfedgeId>(3 * std::size_t{n}, kNone)};
  std::vector<HalfedgeId> open;
  for (TriangleId t = 0; t < n; ++t) {
    HalfedgeId first = 3 * t;
    if (!open.empty() && random.below(12) != 0) {
      const std::size_t back = stringy ? std::min<std::size_t>(open.size(), 3) : open.size();
      const std::size_t at = open.size() - 1 - random.below(back);
      add_edge(graph, first++, open[at]);
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
    }
    for (; first < 3 * t + 3; ++first) open.push_back(first);
  }
  return graph;
}

/// The same weight on both sides of each edge, from small ranges (many ties) or large ones, some of
/// them negative.
inline std::vector<std::int32_t> random_weights(const DualGraph& graph, Random& random) {
  constexpr std::int32_t kWidth[] = {1, 2, 5, 40, 1000, 1 << 20};
  const std::int32_t width = kWidth[random.below(6)];
  const auto least = static_cast<std::int32_t>(random.below(3)) == 0 ? -width / 2 : 1;
  std::vector<std::int32_t> weight(graph.twin.size());
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] == kNone || graph.twin[h] < h) continue;
    weight[h] = least + static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(width)));
    weight[graph.twin[h]] = weight[h];
  }
  return weight;
}

/// The size and weight of the best matching: the greatest size first, or the greatest weight alone.
struct BestMatching {
  std::int64_t size = 0;
  std::int64_t weight = 0;
};

/// By brute force over the sets of nodes; at most about 16 nodes.
inline BestMatching brute_force_matching(const DualGraph& graph,
                                         const std::vector<std::int32_t>& weight, bool size_first) {
  const std::size_t n = graph.node_count(), all = std::size_t{1} << n;
  const auto better = [&](const BestMatching& a, const BestMatching& b) {
    if (size_first && a.size != b.size) return a.size > b.size;
    return a.weight > b.weight;
  };
  std::vector<BestMatching> best(all);  // among the nodes of the set
  for (std::size_t set = 1; set < all; ++set) {
    const auto t = static_cast<TriangleId>(__builtin_ctzll(set));
    const std::size_t rest = set & (set - 1);
    best[set] = best[rest];
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph.twin[h] == kNone) continue;
      const std::size_t other = std::size_t{1} << graph.across(h);
      if ((rest & other) == 0) continue;
      const BestMatching& inner = best[rest & ~other];
      const BestMatching with{inner.size + 1, inner.weight + (weight.empty() ? 1 : weight[h])};
      if (better(with, best[set])) best[set] = with;
    }
  }
  return best[all - 1];
}

inline std::size_t brute_force_unmatched(const DualGraph& graph) {
  return graph.node_count() -
         2 * static_cast<std::size_t>(brute_force_matching(graph, {}, true).size);
}

}  // namespace quadloom::test
