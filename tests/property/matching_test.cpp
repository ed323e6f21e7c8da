// Maximum matchings: the witness on every graph, brute force on the small ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "dual/greedy_matching.hpp"
#include "dual/pair_shape.hpp"
#include "kernel/squareness.hpp"
#include "quadloom/dual.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/matching_checks.hpp"

namespace quadloom {
namespace {

using test::add_edge;
using test::brute_force_unmatched;
using test::random_graph;

/// The greedy matching by definition: all pairs, sorted by shape and number.
DualMatching sorted_greedy(const Triangulation& mesh) {
  std::vector<std::pair<float, HalfedgeId>> pairs;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone || mesh.twin[h] < h) continue;
    const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
    const Point c = mesh.points[mesh.apex(h)], d = mesh.points[mesh.apex(mesh.twin[h])];
    if (orient2d(c, a, d) <= 0 || orient2d(d, b, c) <= 0) continue;
    pairs.emplace_back(static_cast<float>(kernel::worst_squared_cosine(a, d, b, c)), h);
  }
  std::sort(pairs.begin(), pairs.end());
  DualMatching matching{std::vector<HalfedgeId>(mesh.triangle_count(), kNone),
                        mesh.triangle_count()};
  for (const auto& [weight, h] : pairs) {
    const TriangleId t = triangle_of(h), u = triangle_of(mesh.twin[h]);
    if (matching.mate[t] != kNone || matching.mate[u] != kNone) continue;
    matching.mate[t] = h;
    matching.mate[u] = mesh.twin[h];
    matching.unmatched -= 2;
  }
  return matching;
}

TEST(GreedyMatching, TakesTheBestPairsFirst) {
  for (const Generator& g : generators()) {
    SCOPED_TRACE(std::string(g.name) + " 600, seed 3");
    const Triangulation mesh = delaunay(generate_points(g.name, 600, 3)).mesh;
    const DualMatching greedy = greedy_shape_matching(mesh), sorted = sorted_greedy(mesh);
    ASSERT_EQ(greedy.mate, sorted.mate);
    ASSERT_EQ(greedy.unmatched, sorted.unmatched);
  }
}

TEST(GreedyMatching, PutsScarceTrianglesFirst) {
  for (const Generator& g : generators()) {
    SCOPED_TRACE(std::string(g.name) + " 3000, seed 4");
    const Triangulation mesh = delaunay(generate_points(g.name, 3000, 4)).mesh;
    const DualMatching shape = greedy_shape_matching(mesh);
    const DualMatching scarce = dual::greedy_matching(mesh, dual::GreedyOrder::kShapeAndScarcity);
    EXPECT_TRUE(is_matching(dual_graph(mesh), scarce));
    for (TriangleId t = 0; t < scarce.mate.size(); ++t) {
      if (scarce.mate[t] != kNone) {
        EXPECT_GE(dual::pair_squareness(mesh, scarce.mate[t]), 0);
      }
    }
    if (std::string(g.name) == "uniform") {
      EXPECT_LT(4 * scarce.unmatched, 3 * shape.unmatched);
    }
  }
}

/// A maximal matching, edges in random order.
DualMatching random_maximal_matching(const DualGraph& graph, Random& random) {
  DualMatching matching{std::vector<HalfedgeId>(graph.node_count(), kNone), graph.node_count()};
  for (std::size_t i = 0; i < graph.twin.size(); ++i) {
    const auto h = static_cast<HalfedgeId>(random.below(graph.twin.size()));
    if (graph.twin[h] == kNone || matching.mate[triangle_of(h)] != kNone ||
        matching.mate[graph.across(h)] != kNone) {
      continue;
    }
    matching.mate[triangle_of(h)] = h;
    matching.mate[graph.across(h)] = graph.twin[h];
    matching.unmatched -= 2;
  }
  return matching;
}

void expect_maximum_from_both_starts(const DualGraph& graph, Random& random) {
  const MaximumMatching own = maximum_matching(graph);
  ASSERT_TRUE(verify_tutte_berge(graph, own));
  const DualMatching start = random_maximal_matching(graph, random);
  const MaximumMatching from = maximum_matching(graph, start);
  ASSERT_TRUE(verify_tutte_berge(graph, from));
  ASSERT_EQ(from.matching.unmatched, own.matching.unmatched);
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    ASSERT_TRUE(start.mate[t] == kNone || from.matching.mate[t] != kNone);
  }
  ASSERT_TRUE(own.matching.unmatched > 0 || own.barrier.empty());
  if (graph.node_count() <= 14) {
    ASSERT_EQ(own.matching.unmatched, brute_force_unmatched(graph));
  }
}

TEST(MaximumMatching, RandomGraphsOfEveryDensity) {
  for (std::uint64_t seed = 1; seed <= 6000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto n = static_cast<TriangleId>(random.below(15));
    expect_maximum_from_both_starts(random_graph(n, 0.3 + 0.7 * random.uniform(), random), random);
    if (HasFatalFailure()) return;
  }
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto n = static_cast<TriangleId>(50 + random.below(3000));
    expect_maximum_from_both_starts(random_graph(n, 0.6 + 0.4 * random.uniform(), random), random);
    if (HasFatalFailure()) return;
  }
}

TEST(MaximumMatching, DualsOfSmallTriangulations) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<Point> points = {{0, 0}, {1, 0}, {0, 1}};
    for (std::uint64_t i = random.below(7); i > 0; --i) {
      points.push_back(
          {static_cast<double>(random.below(6)), static_cast<double>(random.below(6))});
    }
    const Triangulation mesh = delaunay(points).mesh;
    std::vector<std::uint8_t> forbidden(mesh.twin.size());
    for (auto& f : forbidden) f = random.below(8) == 0 ? 1 : 0;
    expect_maximum_from_both_starts(dual_graph(mesh), random);
    expect_maximum_from_both_starts(dual_graph(mesh, forbidden), random);
    if (HasFatalFailure()) return;
  }
}

TEST(MaximumMatching, EveryGeneratorWithAndWithoutForbiddenEdges) {
  for (const Generator& g : generators()) {
    for (const std::size_t n : {10UL, 300UL, 5000UL}) {
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed 5");
      const Triangulation mesh = delaunay(generate_points(g.name, n, 5)).mesh;
      Random random(n);
      expect_maximum_from_both_starts(dual_graph(mesh), random);
      for (const std::uint64_t one_in : {3U, 20U}) {
        std::vector<std::uint8_t> forbidden(mesh.twin.size());
        for (auto& f : forbidden) f = random.below(one_in) == 0 ? 1 : 0;
        expect_maximum_from_both_starts(dual_graph(mesh, forbidden), random);
      }
      if (HasFatalFailure()) return;
    }
  }
}

// Cycles of odd length that hang on each other by their nodes: blossoms in blossoms.
TEST(MaximumMatching, ChainsOfOddCycles) {
  for (const TriangleId cycles : {1U, 2U, 7U, 30000U}) {
    SCOPED_TRACE(cycles);
    DualGraph graph{std::vector<HalfedgeId>(9 * std::size_t{cycles}, kNone)};
    for (TriangleId c = 0; c < cycles; ++c) {  // the triangle 3c, 3c + 1, 3c + 2
      for (TriangleId i = 0; i < 3; ++i) {
        add_edge(graph, 3 * (3 * c + i), 3 * (3 * c + (i + 1) % 3) + 1);
      }
      if (c > 0) add_edge(graph, 3 * (3 * c) + 2, 3 * (3 * c - 1) + 2);
    }
    const MaximumMatching result = maximum_matching(graph);
    EXPECT_EQ(result.matching.unmatched, cycles % 2);
    EXPECT_TRUE(verify_tutte_berge(graph, result));
  }
}

TEST(MaximumMatching, TheWitnessCanFail) {
  // A star: the middle node and three leaves.
  DualGraph star{std::vector<HalfedgeId>(12, kNone)};
  for (HalfedgeId h = 0; h < 3; ++h) add_edge(star, h, 3 * (h + 1));
  const MaximumMatching good = maximum_matching(star);
  EXPECT_EQ(good.matching.unmatched, 2U);
  EXPECT_EQ(good.barrier, std::vector<TriangleId>{0});
  EXPECT_TRUE(verify_tutte_berge(star, good));

  MaximumMatching bad = good;
  bad.barrier = {};
  EXPECT_FALSE(verify_tutte_berge(star, bad));
  bad.barrier = {1};
  EXPECT_FALSE(verify_tutte_berge(star, bad));
  bad.barrier = {0, 0};
  EXPECT_FALSE(verify_tutte_berge(star, bad));
  bad.barrier = {4};
  EXPECT_FALSE(verify_tutte_berge(star, bad));
  bad = good;
  bad.matching = {std::vector<HalfedgeId>(4, kNone), 4};
  EXPECT_FALSE(verify_tutte_berge(star, bad));
  bad = good;
  bad.matching.unmatched = 0;
  EXPECT_FALSE(verify_tutte_berge(star, bad));
  bad = good;
  bad.matching.mate[0] = good.matching.mate[0] == 0 ? 1 : 0;  // not mutual
  EXPECT_FALSE(verify_tutte_berge(star, bad));
  bad = good;
  bad.matching.mate[0] = 12;  // out of range
  EXPECT_FALSE(verify_tutte_berge(star, bad));
  bad = good;
  bad.matching.mate.pop_back();
  EXPECT_FALSE(verify_tutte_berge(star, bad));
}

TEST(MaximumMatching, RefusesAStartThatIsNoMatching) {
  DualGraph pair{{3, kNone, kNone, 0, kNone, kNone}};
  EXPECT_THROW(maximum_matching(pair, {{0, kNone}, 1}), Error);
  EXPECT_THROW(maximum_matching(pair, {{0, 4}, 0}), Error);
  EXPECT_EQ(maximum_matching(pair, {{0, 3}, 0}).matching.unmatched, 0U);
  EXPECT_EQ(maximum_matching(DualGraph{}).matching.unmatched, 0U);
}

TEST(DualGraph, DropsForbiddenEdgesFromBothSides) {
  const Triangulation mesh = delaunay(generate_points("uniform", 60, 3)).mesh;
  EXPECT_EQ(dual_graph(mesh).twin, mesh.twin);
  HalfedgeId inner = 0;
  while (mesh.twin[inner] == kNone) ++inner;
  std::vector<std::uint8_t> forbidden(mesh.twin.size());
  forbidden[inner] = 1;
  const DualGraph graph = dual_graph(mesh, forbidden);
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    EXPECT_EQ(graph.twin[h], h == inner || h == mesh.twin[inner] ? kNone : mesh.twin[h]);
  }
  forbidden.pop_back();
  EXPECT_THROW(dual_graph(mesh, forbidden), Error);
}

TEST(DualGraph, RefusesTwinsThatDoNotAgree) {
  Triangulation mesh = delaunay(generate_points("uniform", 20, 3)).mesh;
  Triangulation bad = mesh;
  bad.twin[0] = static_cast<HalfedgeId>(mesh.twin.size());
  EXPECT_THROW(dual_graph(bad), Error);
  bad = mesh;
  std::swap(bad.twin[0], bad.twin[1]);
  EXPECT_THROW(dual_graph(bad), Error);
  bad = mesh;
  bad.twin.pop_back();
  EXPECT_THROW(dual_graph(bad), Error);
}

}  // namespace
}  // namespace quadloom
