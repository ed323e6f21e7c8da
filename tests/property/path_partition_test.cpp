// Partitions of triangles into paths, against brute force.
#include <gtest/gtest.h>

#include <string>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/strips.hpp"
#include "support/matching_checks.hpp"
#include "support/path_checks.hpp"

namespace quadloom {
namespace {

using test::brute_force_paths;
using test::random_forest;

TEST(PathPartition, RandomForests) {
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const DualGraph forest =
        random_forest(static_cast<TriangleId>(random.below(13)), random.below(2) == 0, random);
    const PathPartition paths = minimum_path_partition(forest);
    ASSERT_TRUE(is_path_partition(forest, paths));
    ASSERT_EQ(paths.count(), brute_force_paths(forest));
    ASSERT_EQ(path_partition(forest).count(), paths.count());
  }
}

TEST(PathPartition, APathOfAMillionNodes) {
  constexpr TriangleId kNodes = 1'000'001;
  DualGraph path{std::vector<HalfedgeId>(3 * std::size_t{kNodes}, kNone)};
  for (TriangleId t = 1; t < kNodes; ++t) test::add_edge(path, 3 * t, 3 * (t - 1) + 1);
  const PathPartition paths = minimum_path_partition(path);
  EXPECT_TRUE(is_path_partition(path, paths));
  EXPECT_EQ(paths.count(), 1U);
}

// Half of the nodes of odd degree, lemma 5.1's count, would be three.
TEST(PathPartition, TwoStarsInTwoPaths) {
  DualGraph stars{std::vector<HalfedgeId>(18, kNone)};
  test::add_edge(stars, 0, 3);
  test::add_edge(stars, 1, 6);
  test::add_edge(stars, 2, 9);
  test::add_edge(stars, 4, 12);
  test::add_edge(stars, 5, 15);
  EXPECT_EQ(minimum_path_partition(stars).count(), 2U);
}

TEST(PathPartition, CyclesAreNoForests) {
  DualGraph cycle{std::vector<HalfedgeId>(9, kNone)};
  test::add_edge(cycle, 0, 3);
  test::add_edge(cycle, 4, 6);
  test::add_edge(cycle, 7, 1);
  EXPECT_THROW(minimum_path_partition(cycle), Error);
  EXPECT_EQ(path_partition(cycle).count(), 1U);
}

TEST(PathPartition, SmallMeshesAgainstBruteForce) {
  std::size_t more = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Triangulation mesh =
        delaunay(generate_points(seed % 2 == 0 ? "uniform" : "clusters", 4 + seed % 6, seed)).mesh;
    const DualGraph graph = dual_graph(mesh);
    const std::size_t least = brute_force_paths(graph);
    for (const PathGoal goal : {PathGoal::kFewestPaths, PathGoal::kFewestIndices}) {
      for (const PathEffort effort :
           {PathEffort::kFast, PathEffort::kStandard, PathEffort::kThorough}) {
        PathOptions options;
        options.goal = goal;
        options.effort = effort;
        options.seed = seed;
        const PathPartition paths = path_partition(graph, options);
        ASSERT_TRUE(is_path_partition(graph, paths));
        ASSERT_GE(paths.count(), least);
        if (goal == PathGoal::kFewestIndices || effort == PathEffort::kFast) continue;
        ++all;
        more += paths.count() > least;
      }
    }
  }
  EXPECT_LE(20 * more, all);  // found in 95 of 100
}

TEST(PathPartition, MeshesOfAllKinds) {
  for (const Generator& g : generators()) {
    SCOPED_TRACE(std::string(g.name) + " 3000, seed 7");
    const DualGraph graph = dual_graph(delaunay(generate_points(g.name, 3000, 7)).mesh);
    std::size_t fast = graph.node_count();
    for (const PathEffort effort :
         {PathEffort::kFast, PathEffort::kStandard, PathEffort::kThorough}) {
      PathOptions options;
      options.effort = effort;
      const PathPartition paths = path_partition(graph, options);
      ASSERT_TRUE(is_path_partition(graph, paths));
      if (effort == PathEffort::kFast) fast = paths.count();
      EXPECT_LE(paths.count(), fast);
    }
  }
}

// Two triangles that share all three edges.
TEST(PathPartition, ParallelEdges) {
  DualGraph pillow{{3, 4, 5, 0, 1, 2}};
  const PathPartition paths = path_partition(pillow);
  EXPECT_TRUE(is_path_partition(pillow, paths));
  EXPECT_EQ(paths.count(), 1U);
}

TEST(PathPartition, FaultsAreSeen) {
  const DualGraph graph = dual_graph(delaunay(generate_points("uniform", 50)).mesh);
  const PathPartition good = path_partition(graph);
  ASSERT_TRUE(is_path_partition(graph, good));
  PathPartition bad = good;
  bad.leave.pop_back();
  EXPECT_FALSE(is_path_partition(graph, bad));
  --bad.begin.back();
  EXPECT_FALSE(is_path_partition(graph, bad));  // a triangle is missing
  bad = good;
  bad.leave.back() = bad.leave.front();
  EXPECT_FALSE(is_path_partition(graph, bad));
  for (std::size_t i = 0; i < good.leave.size(); ++i) {
    bad = good;
    bad.leave[i] = next_halfedge(bad.leave[i]);
    const bool last = std::find(good.begin.begin(), good.begin.end(), i + 1) != good.begin.end();
    if (!last) {
      EXPECT_FALSE(is_path_partition(graph, bad)) << i;
    }
  }
}

TEST(PathPartition, TheSeedDecides) {
  const DualGraph graph = dual_graph(delaunay(generate_points("uniform", 20000)).mesh);
  PathOptions options;
  const PathPartition one = path_partition(graph, options), again = path_partition(graph, options);
  EXPECT_EQ(one.leave, again.leave);
  options.seed = 2;
  EXPECT_NE(one.leave, path_partition(graph, options).leave);
}

TEST(PathPartition, CanBeStopped) {
  const DualGraph graph = dual_graph(delaunay(generate_points("uniform", 1000)).mesh);
  PathOptions options;
  options.progress = [](std::string_view, double) { return false; };
  EXPECT_THROW(path_partition(graph, options), Error);
}

}  // namespace
}  // namespace quadloom
