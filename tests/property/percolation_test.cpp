// Percolation on random trees, against brute force and against the general algorithm.
#include <gtest/gtest.h>

#include <string>

#include "core/random.hpp"
#include "quadloom/dual.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/matching_checks.hpp"

namespace quadloom {
namespace {

using test::brute_force_unmatched;
using test::random_forest;

int degree(const DualGraph& graph, TriangleId t) {
  int edges = 0;
  for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) edges += graph.twin[h] != kNone;
  return edges;
}

void expect_percolations_are_maximum(const DualGraph& forest) {
  const DualMatching up = percolate_up(forest), down = percolate_up_and_down(forest);
  ASSERT_TRUE(is_matching(forest, up));
  ASSERT_TRUE(is_matching(forest, down));
  const std::size_t least = forest.node_count() <= 14 ? brute_force_unmatched(forest)
                                                      : maximum_matching(forest).matching.unmatched;
  ASSERT_EQ(up.unmatched, least);
  ASSERT_EQ(down.unmatched, least);
  for (TriangleId t = 0; t < forest.node_count(); ++t) {
    ASSERT_TRUE(down.mate[t] != kNone || degree(forest, t) <= 1);
  }
}

TEST(Percolation, RandomForests) {
  for (std::uint64_t seed = 1; seed <= 6000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto n = static_cast<TriangleId>(seed % 20 == 0 ? random.below(2000) : random.below(15));
    expect_percolations_are_maximum(random_forest(n, random.below(2) == 0, random));
    if (HasFatalFailure()) return;
  }
}

TEST(Percolation, APathOfAMillionNodes) {
  constexpr TriangleId kNodes = 1'000'001;
  DualGraph path{std::vector<HalfedgeId>(3 * std::size_t{kNodes}, kNone)};
  for (TriangleId t = 1; t < kNodes; ++t) test::add_edge(path, 3 * t, 3 * (t - 1) + 1);
  expect_percolations_are_maximum(path);
  EXPECT_EQ(percolate_up(path).unmatched, 1U);
}

TEST(Percolation, SpanningForestsOfDuals) {
  for (const Generator& g : generators()) {
    SCOPED_TRACE(std::string(g.name) + " 2000, seed 4");
    const Triangulation mesh = delaunay(generate_points(g.name, 2000, 4)).mesh;
    const DualGraph graph = dual_graph(mesh), forest = spanning_forest(graph);
    std::size_t edges = 0;
    for (HalfedgeId h = 0; h < forest.twin.size(); ++h) {
      ASSERT_TRUE(forest.twin[h] == kNone || forest.twin[h] == graph.twin[h]);
      edges += forest.twin[h] != kNone;
    }
    ASSERT_EQ(edges, 2 * (mesh.triangle_count() - 1));  // the dual is connected
    expect_percolations_are_maximum(forest);            // and a cycle would throw
    if (HasFatalFailure()) return;
  }
}

TEST(Percolation, RefusesCycles) {
  DualGraph cycle{std::vector<HalfedgeId>(9, kNone)};
  for (TriangleId t = 0; t < 3; ++t) test::add_edge(cycle, 3 * t, 3 * ((t + 1) % 3) + 1);
  EXPECT_THROW(percolate_up(cycle), Error);
  EXPECT_THROW(percolate_up_and_down(cycle), Error);
  cycle.twin.resize(12, kNone);
  test::add_edge(cycle, 2, 9);  // with a tail
  EXPECT_THROW(percolate_up(cycle), Error);
  DualGraph double_edge{{3, 4, kNone, 0, 1, kNone}};
  EXPECT_THROW(percolate_up(double_edge), Error);
}

}  // namespace
}  // namespace quadloom
