// Boost.Graph's matchings for bench/compare: `cardinality` and `weight` of the graph INPUT.dual. Its graph is built before
// the clock starts.
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <boost/graph/maximum_weighted_matching.hpp>

#include "measure.hpp"

namespace {

using Weight = boost::property<boost::edge_weight_t, long long>;
using Graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Weight>;
using Mates = std::vector<Graph::vertex_descriptor>;

Graph read_graph(const std::string& input) {
  const std::vector<double> edges = bench::read_doubles(input + ".dual");
  Graph graph;
  for (std::size_t i = 0; i < edges.size(); i += 3) {
    boost::add_edge(static_cast<std::size_t>(edges[i]), static_cast<std::size_t>(edges[i + 1]),
                    Weight(static_cast<long long>(edges[i + 2])), graph);
  }
  return graph;
}

void count(const Graph& graph, const Mates& mates, bench::Report& report) {
  long long pairs = 0, weight = 0;
  for (const auto& edge : boost::make_iterator_range(boost::edges(graph))) {
    if (mates[boost::source(edge, graph)] != boost::target(edge, graph)) continue;
    ++pairs;
    weight += boost::get(boost::edge_weight, graph, edge);
  }
  report.add("pairs", pairs).add("weight", weight);
}

void run(const bench::Call& call, bench::Report& report) {
  report.add_words("version", BOOST_LIB_VERSION);
  const Graph graph = read_graph(call.input);
  const auto match = [&](auto algorithm) {
    count(graph,
          bench::measure(report,
                         [&] {
                           Mates mates(boost::num_vertices(graph));
                           algorithm(mates);
                           return mates;
                         }),
          report);
  };
  if (call.task == "cardinality") {
    match([&](Mates& mates) { boost::edmonds_maximum_cardinality_matching(graph, mates.data()); });
  } else if (call.task == "weight") {
    match([&](Mates& mates) { boost::maximum_weighted_matching(graph, mates.data()); });
  } else {
    bench::unknown_task(call);
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run_program(argc, argv, run); }
