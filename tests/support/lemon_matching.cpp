#include "support/lemon_graph.hpp"

namespace quadloom::test {

LemonResult lemon_maximum(std::size_t nodes, const std::vector<LemonEdge>& edges) {
  const LemonGraph input(nodes, edges);
  LemonGraph::Maximum algorithm(input.graph);
  algorithm.run();
  return input.result_of(algorithm);
}

LemonResult lemon_maximum_weight(std::size_t nodes, const std::vector<LemonEdge>& edges) {
  const LemonGraph input(nodes, edges);
  LemonGraph::MaximumWeight algorithm(input.graph, input.weight);
  algorithm.run();
  return input.result_of(algorithm);
}

LemonResult lemon_perfect(std::size_t nodes, const std::vector<LemonEdge>& edges) {
  const LemonGraph input(nodes, edges);
  LemonGraph::Perfect algorithm(input.graph, input.weight);
  if (!algorithm.run()) return {false};
  return input.result_of(algorithm);
}

}  // namespace quadloom::test
