// A graph with weights for LEMON's matchings, for sources in C++17 alone: LEMON does not compile as C++20.
#pragma once

#include <lemon/matching.h>
#include <lemon/smart_graph.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/lemon_matching.hpp"

namespace quadloom::test {

struct LemonGraph {
  using Graph = lemon::SmartGraph;
  using Weights = Graph::EdgeMap<long long>;
  using Maximum = lemon::MaxMatching<Graph>;
  using MaximumWeight = lemon::MaxWeightedMatching<Graph, Weights>;
  using Perfect = lemon::MaxWeightedPerfectMatching<Graph, Weights>;

  Graph graph;
  Weights weight{graph};

  LemonGraph(std::size_t nodes, const std::vector<LemonEdge>& edges) {
    graph.reserveNode(static_cast<int>(nodes));
    graph.reserveEdge(static_cast<int>(edges.size()));
    for (std::size_t i = 0; i < nodes; ++i) graph.addNode();
    for (const LemonEdge& e : edges) {
      const auto edge = graph.addEdge(Graph::nodeFromId(static_cast<int>(e.from)),
                                      Graph::nodeFromId(static_cast<int>(e.to)));
      weight[edge] = e.weight;
    }
  }

  /// What an algorithm that has run found.
  template <class Algorithm>
  LemonResult result_of(const Algorithm& algorithm) const {
    LemonResult result;
    for (Graph::EdgeIt e(graph); e != lemon::INVALID; ++e) {
      if (!algorithm.matching(e)) continue;
      ++result.size;
      result.weight += weight[e];
    }
    return result;
  }
};

}  // namespace quadloom::test
