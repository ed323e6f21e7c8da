// LEMON's matchings for bench/compare: `cardinality`, `weight` and `perfect` (of the greatest weight among the perfect
// ones) of the graph INPUT.dual. Its graph is built before the clock starts.
#include <algorithm>
#include <memory>

#include "measure.hpp"
#include "support/lemon_graph.hpp"

namespace {

using quadloom::test::LemonEdge;
using quadloom::test::LemonGraph;
using quadloom::test::LemonResult;

LemonGraph read_graph(const std::string& input) {
  const std::vector<double> values = bench::read_doubles(input + ".dual");
  std::vector<LemonEdge> edges;
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const auto from = static_cast<std::uint32_t>(values[i]);
    const auto to = static_cast<std::uint32_t>(values[i + 1]);
    edges.push_back({from, to, static_cast<std::int32_t>(values[i + 2])});
    nodes = std::max<std::size_t>(nodes, std::max(from, to) + 1);
  }
  return {nodes, edges};
}

/// The pairs of the matching.
template <class Algorithm, class... Arguments>
std::size_t match(bench::Report& report, const LemonGraph& input, const Arguments&... arguments) {
  const auto algorithm = bench::measure(report, [&] {
    auto run = std::make_unique<Algorithm>(input.graph, arguments...);
    run->run();
    return run;
  });
  const LemonResult result = input.result_of(*algorithm);
  report.add("pairs", result.size).add("weight", result.weight);
  return result.size;
}

void run(const bench::Call& call, bench::Report& report) {
  report.add_words("version", LEMON_VERSION);
  const LemonGraph input = read_graph(call.input);
  if (call.task == "cardinality") {
    match<LemonGraph::Maximum>(report, input);
  } else if (call.task == "weight") {
    match<LemonGraph::MaximumWeight>(report, input, input.weight);
  } else if (call.task == "perfect") {
    const std::size_t pairs = match<LemonGraph::Perfect>(report, input, input.weight);
    if (2 * pairs < static_cast<std::size_t>(input.graph.nodeNum()))
      throw std::runtime_error("no perfect matching");
  } else {
    bench::unknown_task(call);
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run_program(argc, argv, run); }
