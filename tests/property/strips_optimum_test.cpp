// Codes of small meshes against the shortest ones.
#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/strips.hpp"
#include "strips/encode_order.hpp"
#include "strips/encode_walk.hpp"
#include "support/matching_checks.hpp"
#include "support/path_checks.hpp"
#include "support/strip_checks.hpp"

namespace quadloom {
namespace {

StripResult encode(const Triangulation& mesh, StripEncoding encoding, PathEffort effort) {
  StripOptions options;
  options.encoding = encoding;
  options.effort = effort;
  StripResult result = encode_strips(mesh, options);
  EXPECT_TRUE(same_triangles(decode_strips(result.code), mesh.tri_vertex));
  return result;
}

/// Some triangles of a Delaunay triangulation: parts, holes and bow-ties, too.
Triangulation some_triangles(std::uint64_t seed, std::size_t most) {
  Random random(seed);
  const Triangulation whole = delaunay(generate_points("uniform", 4 + random.below(8), seed)).mesh;
  std::vector<VertexId> corners;
  for (TriangleId t = 0; t < whole.triangle_count() && corners.size() < 3 * most; ++t) {
    if (random.below(4) == 0) continue;
    corners.insert(corners.end(), &whole.tri_vertex[3 * t], &whole.tri_vertex[3 * t] + 3);
  }
  return triangles_with_twins(whole.points, corners);
}

TEST(StripsOptimum, UpToSixTrianglesAgainstBruteForce) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Triangulation mesh = some_triangles(seed, 6);
    for (const StripEncoding encoding : {StripEncoding::kRepeat, StripEncoding::kRestart}) {
      const std::size_t least =
          test::brute_force_indices(mesh, encoding == StripEncoding::kRestart);
      ASSERT_EQ(encode(mesh, encoding, PathEffort::kStandard).code.index.size(), least);
    }
  }
}

TEST(StripsOptimum, ATetrahedronAndACube) {
  const Triangulation tetrahedron =
      triangles_with_twins(std::vector<Point>(4), {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});
  EXPECT_EQ(encode(tetrahedron, StripEncoding::kRestart, PathEffort::kStandard).code.index.size(),
            test::brute_force_indices(tetrahedron, true));
  // The cube whose diagonals let one strip go around without a swap.
  const std::vector<VertexId> cube =
      decode_strips({StripEncoding::kRepeat, {3, 2, 6, 7, 4, 2, 0, 3, 1, 6, 5, 4, 1, 0}, {}});
  ASSERT_EQ(cube.size(), 36U);
  const StripResult strips = encode(triangles_with_twins(std::vector<Point>(8), cube),
                                    StripEncoding::kRepeat, PathEffort::kStandard);
  EXPECT_EQ(strips.code.index.size(), 14U);
  EXPECT_EQ(strips.strips, 1U);
}

TEST(StripsOptimum, FewestStrips) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Triangulation mesh = some_triangles(seed, 10);
    EXPECT_EQ(encode(mesh, StripEncoding::kSwap, PathEffort::kStandard).strips,
              test::brute_force_paths(dual_graph(mesh)));
  }
}

// Theorem 5.3's bound, and what the ways for greater meshes come to, against the shortest code.
TEST(StripsOptimum, OtherWaysAgainstTheShortestCode) {
  std::size_t shortest = 0, walks = 0, paths = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Triangulation mesh = some_triangles(seed, 9);
    const DualGraph graph = dual_graph(mesh);
    for (const StripEncoding encoding : {StripEncoding::kRepeat, StripEncoding::kRestart}) {
      const std::size_t least = encode(mesh, encoding, PathEffort::kStandard).code.index.size();
      const StripResult walk =
          strips::encode_order(mesh, strips::christofides_order(graph), encoding);
      EXPECT_TRUE(same_triangles(decode_strips(walk.code), mesh.tri_vertex));
      EXPECT_GE(walk.code.index.size(), least);
      EXPECT_LE(4 * walk.code.index.size(), 9 * least + 8);
      PathOptions search;
      search.goal = PathGoal::kFewestIndices;
      const StripResult fast = encode_paths(mesh, path_partition(graph, search), encoding);
      EXPECT_GE(fast.code.index.size(), least);
      shortest += least;
      walks += walk.code.index.size();
      paths += fast.code.index.size();
    }
  }
  EXPECT_LE(100 * walks, 130 * shortest) << walks << " of " << shortest;
  EXPECT_LE(100 * paths, 110 * shortest) << paths << " of " << shortest;
}

TEST(StripsOptimum, GivenOrders) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Triangulation mesh = some_triangles(seed, 30);
    std::vector<TriangleId> order(mesh.triangle_count());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (const StripEncoding encoding : {StripEncoding::kRepeat, StripEncoding::kRestart}) {
      const StripResult result = strips::encode_order(mesh, order, encoding);
      const std::vector<VertexId> drawn = decode_strips(result.code);
      ASSERT_EQ(drawn.size(), mesh.tri_vertex.size());
      for (std::size_t i = 0; i < order.size(); ++i) {  // in this order
        ASSERT_TRUE(same_triangles(std::span(drawn).subspan(3 * i, 3),
                                   std::span(mesh.tri_vertex).subspan(3 * order[i], 3)));
      }
    }
  }
}

// ---- Joins. ----

/// The least number of edges with those parities, by trying every set.
std::size_t brute_force_join(const DualGraph& graph, const std::vector<std::uint8_t>& odd) {
  std::vector<HalfedgeId> edges;
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (graph.twin[h] != kNone && graph.twin[h] < h) edges.push_back(h);
  }
  std::size_t least = edges.size() + 1;
  for (std::size_t set = 0; set < std::size_t{1} << edges.size(); ++set) {
    std::vector<std::uint8_t> parity(odd.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if ((set >> i & 1) == 0) continue;
      ++count;
      parity[triangle_of(edges[i])] ^= 1;
      parity[graph.across(edges[i])] ^= 1;
    }
    if (parity == odd) least = std::min(least, count);
  }
  return least;
}

TEST(StripsOptimum, SmallestJoins) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const DualGraph graph = dual_graph(some_triangles(seed, 9));
    std::vector<std::uint8_t> odd(graph.node_count());
    for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {  // an even number in each component
      if (graph.twin[h] == kNone || graph.twin[h] < h || random.below(2) == 0) continue;
      odd[triangle_of(h)] ^= 1;
      odd[graph.across(h)] ^= 1;
    }
    const std::vector<std::uint8_t> join = strips::minimum_join(graph, odd);
    std::vector<std::uint8_t> parity(odd.size());
    std::size_t sides = 0;
    for (HalfedgeId h = 0; h < join.size(); ++h) {
      if (join[h] == 0) continue;
      ASSERT_EQ(join[graph.twin[h]], 1);
      parity[triangle_of(h)] ^= 1;
      ++sides;
    }
    ASSERT_EQ(parity, odd);
    ASSERT_EQ(sides / 2, brute_force_join(graph, odd));
  }
}

}  // namespace
}  // namespace quadloom
