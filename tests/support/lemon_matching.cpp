#include "support/lemon_matching.hpp"

#include <lemon/matching.h>
#include <lemon/smart_graph.h>

#include <ctime>

namespace quadloom::test {
namespace {

using Graph = lemon::SmartGraph;
using Weights = Graph::EdgeMap<long long>;

struct Input {
  Graph graph;
  Weights weight{graph};

  Input(std::size_t nodes, const std::vector<LemonEdge>& edges) {
    graph.reserveNode(static_cast<int>(nodes));
    graph.reserveEdge(static_cast<int>(edges.size()));
    for (std::size_t i = 0; i < nodes; ++i) graph.addNode();
    for (const LemonEdge& e : edges) {
      const auto edge = graph.addEdge(Graph::nodeFromId(static_cast<int>(e.from)),
                                      Graph::nodeFromId(static_cast<int>(e.to)));
      weight[edge] = e.weight;
    }
  }
};

template <class Algorithm, class Run>
LemonResult timed(Input& input, Algorithm& algorithm, Run run) {
  const std::clock_t start = std::clock();
  LemonResult out;
  out.found = run(algorithm);
  out.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!out.found) return out;
  for (Graph::EdgeIt e(input.graph); e != lemon::INVALID; ++e) {
    if (!algorithm.matching(e)) continue;
    ++out.size;
    out.weight += input.weight[e];
  }
  return out;
}

}  // namespace

LemonResult lemon_maximum(std::size_t nodes, const std::vector<LemonEdge>& edges) {
  Input input(nodes, edges);
  lemon::MaxMatching<Graph> algorithm(input.graph);
  return timed(input, algorithm, [](auto& a) {
    a.run();
    return true;
  });
}

LemonResult lemon_maximum_weight(std::size_t nodes, const std::vector<LemonEdge>& edges) {
  Input input(nodes, edges);
  lemon::MaxWeightedMatching<Graph, Weights> algorithm(input.graph, input.weight);
  return timed(input, algorithm, [](auto& a) {
    a.run();
    return true;
  });
}

LemonResult lemon_perfect(std::size_t nodes, const std::vector<LemonEdge>& edges) {
  Input input(nodes, edges);
  lemon::MaxWeightedPerfectMatching<Graph, Weights> algorithm(input.graph, input.weight);
  return timed(input, algorithm, [](auto& a) { return a.run(); });
}

}  // namespace quadloom::test
