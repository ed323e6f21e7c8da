// The same sizes and weights as LEMON's.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/dual.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/lemon_matching.hpp"
#include "support/matching_checks.hpp"

namespace quadloom {
namespace {

using test::LemonEdge;
using test::LemonResult;

std::vector<LemonEdge> lemon_edges(const DualGraph& graph,
                                   const std::vector<std::int32_t>& weight) {
  std::vector<LemonEdge> edges;
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] == kNone || graph.twin[h] < h) continue;
    edges.push_back({triangle_of(h), graph.across(h), weight[h]});
  }
  return edges;
}

void expect_the_same(const DualGraph& graph, const std::vector<std::int32_t>& weight) {
  const std::size_t nodes = graph.node_count();
  const std::vector<LemonEdge> edges = lemon_edges(graph, weight);
  const std::size_t size = test::lemon_maximum(nodes, edges).size;
  ASSERT_EQ(maximum_matching(graph).matching.unmatched, nodes - 2 * size);
  ASSERT_EQ(maximum_weight_matching(graph, weight, MatchingGoal::kWeight).weight,
            test::lemon_maximum_weight(nodes, edges).weight);
  const MaximumWeightMatching best =
      maximum_weight_matching(graph, weight, MatchingGoal::kSizeThenWeight);
  ASSERT_EQ(best.matching.unmatched, nodes - 2 * size);
  const LemonResult perfect = test::lemon_perfect(nodes, edges);
  ASSERT_EQ(perfect.found, best.matching.unmatched == 0);
  if (perfect.found) {
    ASSERT_EQ(best.weight, perfect.weight);
  }
}

TEST(MatchingAgainstLemon, DualsOfEveryGenerator) {
  for (const Generator& g : generators()) {
    for (const std::size_t n : {20UL, 500UL, 8000UL}) {
      for (std::uint64_t seed = 1; seed <= (n > 500 ? 1U : 5U); ++seed) {
        SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed " +
                     std::to_string(seed));
        const Triangulation mesh = delaunay(generate_points(g.name, n, seed)).mesh;
        const DualGraph graph = dual_graph(mesh);
        const std::vector<std::int32_t> shape = shape_weights(mesh);
        expect_the_same(graph, shape);
        expect_the_same(heavy_edges(graph, shape, 1), shape);
        Random random(seed);
        expect_the_same(graph, test::random_weights(graph, random));
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(MatchingAgainstLemon, RandomGraphs) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto n = static_cast<TriangleId>(2 + random.below(300));
    const DualGraph graph = test::random_graph(n, 0.5 + 0.5 * random.uniform(), random);
    expect_the_same(graph, test::random_weights(graph, random));
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace quadloom
