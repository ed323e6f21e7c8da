// LEMON's matchings for bench/compare: `cardinality`, `weight` and `perfect` (of the greatest weight among the perfect
// ones) of the graph INPUT.dual. Its graph is built before the clock starts.
#include <lemon/matching.h>
#include <lemon/smart_graph.h>

#include <memory>

#include "measure.hpp"

namespace {

using Graph = lemon::SmartGraph;
using Weights = Graph::EdgeMap<long long>;

struct Input {
  Graph graph;
  Weights weight{graph};

  explicit Input(const std::vector<double>& edges) {
    const auto add_up_to = [&](double node) {
      while (graph.nodeNum() <= static_cast<int>(node)) graph.addNode();
      return Graph::nodeFromId(static_cast<int>(node));
    };
    for (std::size_t i = 0; i < edges.size(); i += 3) {
      const auto from = add_up_to(edges[i]), to = add_up_to(edges[i + 1]);
      weight[graph.addEdge(from, to)] = static_cast<long long>(edges[i + 2]);
    }
  }
};

template <class Algorithm, bool must_be_perfect = false, class... Arguments>
void match(bench::Report& report, const Input& input, const Arguments&... arguments) {
  const auto algorithm = bench::measure(report, [&] {
    auto run = std::make_unique<Algorithm>(input.graph, arguments...);
    run->run();
    return run;
  });
  long long pairs = 0, weight = 0;
  for (Graph::EdgeIt e(input.graph); e != lemon::INVALID; ++e) {
    if (!algorithm->matching(e)) continue;
    ++pairs;
    weight += input.weight[e];
  }
  if (must_be_perfect && 2 * pairs < input.graph.nodeNum())
    throw std::runtime_error("no perfect matching");
  report.add("pairs", pairs).add("weight", weight);
}

void run(const bench::Call& call, bench::Report& report) {
  report.add_words("version", LEMON_VERSION);
  const Input input(bench::read_doubles(call.input + ".dual"));
  if (call.task == "cardinality") {
    match<lemon::MaxMatching<Graph>>(report, input);
  } else if (call.task == "weight") {
    match<lemon::MaxWeightedMatching<Graph, Weights>>(report, input, input.weight);
  } else if (call.task == "perfect") {
    match<lemon::MaxWeightedPerfectMatching<Graph, Weights>, true>(report, input, input.weight);
  } else {
    bench::unknown_task(call);
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run_program(argc, argv, run); }
