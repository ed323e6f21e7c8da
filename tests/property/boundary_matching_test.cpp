// Matchings that leave over what may stay, against brute force.
#include "quadrangulate/boundary_matching.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/matching_checks.hpp"

namespace quadloom {
namespace {

/// Whether some matching covers all nodes but those that may stay.
bool can_cover(const DualGraph& graph, const std::vector<std::uint8_t>& may_stay) {
  const std::size_t n = graph.node_count();
  std::vector<std::uint8_t> can(std::size_t{1} << n);  // by set of nodes
  can[0] = 1;
  for (std::size_t set = 1; set < can.size(); ++set) {
    const auto t = static_cast<TriangleId>(__builtin_ctzll(set));
    const std::size_t rest = set & (set - 1);
    if (may_stay[t] != 0) can[set] = can[rest];
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (graph.twin[h] == kNone) continue;
      const std::size_t other = std::size_t{1} << graph.across(h);
      if ((rest & other) != 0 && can[rest & ~other] != 0) can[set] = 1;
    }
  }
  return can.back() != 0;
}

TEST(BoundaryMatching, RandomGraphs) {
  std::size_t possible = 0, impossible = 0;
  for (std::uint64_t seed = 1; seed <= 6000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto n = static_cast<TriangleId>(1 + random.below(12));
    const DualGraph graph = seed % 2 == 0
                                ? test::random_graph(n, 0.5 + random.uniform() / 2, random)
                                : test::random_forest(n, random.below(2) == 0, random);
    std::vector<std::uint8_t> may_stay(n);
    for (TriangleId t = 0; t < n; ++t) {
      int edges = 0;
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) edges += graph.twin[h] != kNone;
      may_stay[t] = edges < 3 && random.below(2) == 0 ? 1 : 0;
    }
    const DualMatching matching = quadrangulate::matching_inside_first(graph, may_stay);
    ASSERT_TRUE(is_matching(graph, matching));
    ASSERT_EQ(matching.unmatched, test::brute_force_unmatched(graph));
    bool covers = true;
    for (TriangleId t = 0; t < n; ++t) {
      covers = covers && (matching.mate[t] != kNone || may_stay[t] != 0);
    }
    ASSERT_EQ(covers, can_cover(graph, may_stay));
    ++(covers ? possible : impossible);
  }
  EXPECT_GT(possible, 1000U);
  EXPECT_GT(impossible, 1000U);
}

}  // namespace
}  // namespace quadloom
