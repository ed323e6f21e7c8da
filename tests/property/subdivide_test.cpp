// The subdivision method: every quad strictly convex, on every kind of points.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/points_subdivide.hpp"
#include "support/grid_points.hpp"

namespace quadloom {
namespace {

PointResult subdivide(const std::vector<Point>& points) {
  return quadrangulate::subdivide_quadrangulation(delaunay(points).mesh, {});
}

/// Counts by Euler's formula, vertices in their order, parents next to their points.
void expect_counts(const PointResult& result) {
  const std::size_t n = result.input_vertices;
  const std::size_t h = result.statistics.hull_points;
  const std::size_t triangles = 2 * n - 2 - h;
  const std::size_t edges = 3 * n - 3 - h;
  ASSERT_EQ(result.mesh.quad_count(), 3 * triangles);
  ASSERT_EQ(result.mesh.triangle_count(), 0U);
  ASSERT_EQ(result.steiner.size(), edges + triangles);
  ASSERT_EQ(result.mesh.points.size(), n + edges + triangles);
  for (std::size_t i = 0; i < result.steiner.size(); ++i) {
    const SteinerPoint& s = result.steiner[i];
    ASSERT_EQ(s.vertex, n + i);
    ASSERT_LT(s.parents[0], n);
    ASSERT_LT(s.parents[1], n);
    ASSERT_EQ(s.parents[2] == kNone, i < edges);
    ASSERT_TRUE(s.parents[2] == kNone || s.parents[2] < n);
  }
}

/// What kind of place each added point has, decided again from the hull.
void expect_kinds(const PointResult& result) {
  std::size_t on_boundary = 0;
  for (const SteinerPoint& s : result.steiner) {
    if (s.kind == SteinerKind::kInner) continue;
    ++on_boundary;
    const int side =
        orient2d(result.mesh.points[s.parents[0]], result.mesh.points[s.parents[1]],
                 result.mesh.points[s.vertex]);
    ASSERT_EQ(side, s.kind == SteinerKind::kOnEdge ? 0 : -1);
  }
  ASSERT_EQ(on_boundary, result.statistics.hull_points);
}

void expect_strictly_convex(const std::vector<Point>& points) {
  const PointResult result = subdivide(points);
  ASSERT_NO_FATAL_FAILURE(expect_counts(result));
  ASSERT_NO_FATAL_FAILURE(expect_kinds(result));
  const Certificate verdict =
      certify_points(to_polygon_mesh(result.mesh), points, {.strictly_convex = true});
  ASSERT_TRUE(verdict.ok()) << verdict.sentence;
}

TEST(Subdivide, EveryGenerator) {
  for (const Generator& kind : generators()) {
    for (const std::size_t n : {3U, 5U, 10U, 100U, 2000U}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        if (n < kind.min_points || kind.name == "near-line") continue;
        SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(n) + " seed " +
                     std::to_string(seed));
        ASSERT_NO_FATAL_FAILURE(expect_strictly_convex(kind.make(n, seed)));
      }
    }
  }
}

TEST(Subdivide, SubsetsOfSmallGrids) {
  Random random(11);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE("case " + std::to_string(i) + " of seed 11");
    const auto points = testing::random_grid_points(random, 3 + random.below(14), 6, 4);
    if (!testing::all_collinear(points)) {
      ASSERT_NO_FATAL_FAILURE(expect_strictly_convex(points));
    }
  }
}

}  // namespace
}  // namespace quadloom
