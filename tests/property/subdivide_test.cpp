// The subdivision method: every quad strictly convex, on every kind of points.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "quadloom/quadloom.hpp"

namespace quadloom {
namespace {

PointResult subdivide(const std::vector<Point>& points) {
  return quadrangulate_points(points, {.method = PointMethod::kSubdivide});
}

struct Counts {
  std::size_t points, edges, triangles, caps;
};

/// By Euler's formula; what is left over are caps of bulges.
Counts counts_of(const PointResult& result) {
  const std::size_t n = result.input_vertices;
  const std::size_t h = result.statistics.hull_points;
  const std::size_t triangles = 2 * n - 2 - h;
  return {n, 3 * n - 3 - h, triangles, result.mesh.quad_count() - 3 * triangles};
}

/// Vertices in their order: points, one an edge, one a triangle, caps; parents that are points.
void expect_order(const PointResult& result) {
  const auto [n, edges, triangles, caps] = counts_of(result);
  ASSERT_EQ(result.mesh.triangle_count(), 0U);
  ASSERT_EQ(result.steiner.size(), edges + triangles + caps);
  ASSERT_EQ(result.mesh.points.size(), n + result.steiner.size());
  for (std::size_t i = 0; i < result.steiner.size(); ++i) {
    const SteinerPoint& s = result.steiner[i];
    ASSERT_EQ(s.vertex, n + i);
    ASSERT_LT(s.parents[0], n);
    ASSERT_LT(s.parents[1], n);
    ASSERT_EQ(s.parents[2] == kNone, i < edges);
    ASSERT_TRUE(s.parents[2] == kNone || s.parents[2] < n);
  }
}

/// On a hull edge, outside it, or inside: decided again from the parents.
void expect_kinds(const PointResult& result) {
  std::size_t on_boundary = 0;
  for (const SteinerPoint& s : result.steiner) {
    if (s.kind == SteinerKind::kInner) continue;
    ++on_boundary;
    const int side = orient2d(result.mesh.points[s.parents[0]], result.mesh.points[s.parents[1]],
                              result.mesh.points[s.vertex]);
    ASSERT_EQ(side, s.kind == SteinerKind::kOnEdge ? 0 : -1);
  }
  ASSERT_EQ(on_boundary, result.statistics.hull_points + counts_of(result).caps);
}

void expect_certified(const std::vector<Point>& points, const PointResult& result) {
  ASSERT_NO_FATAL_FAILURE(expect_order(result));
  ASSERT_NO_FATAL_FAILURE(expect_kinds(result));
  const Certificate verdict =
      certify_points(to_polygon_mesh(result.mesh), points, {.strictly_convex = true});
  ASSERT_TRUE(verdict.ok()) << verdict.sentence;
}

TEST(Subdivide, EveryGenerator) {
  for (const Generator& kind : generators()) {
    if (kind.name == "near-line") continue;  // see PointsNextToALine
    for (const std::size_t n : {3U, 5U, 10U, 50U, 2000U}) {
      for (std::uint64_t seed = 1; seed <= 10 && n >= kind.min_points; ++seed) {
        SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(n) + " seed " +
                     std::to_string(seed));
        const std::vector<Point> points = kind.make(n, seed);
        const PointResult result = subdivide(points);
        ASSERT_NO_FATAL_FAILURE(expect_certified(points, result));
        if (kind.name != "rotated-grid") {
          ASSERT_EQ(counts_of(result).caps, 0U);
        }
      }
    }
  }
}

// The origin, a and 2 a are in line, and between a and 2 a there is no double: the run bulges.
TEST(Subdivide, StraightRunsWithoutDoublesBulge) {
  const Point a = {-0x1.1a2b3c4d5e6f7p-1, 0x1.0b0a09080706fp-1};
  const std::vector<Point> points = {{0, 0}, a, {2 * a.x, 2 * a.y}, {3, 5}};
  const PointResult result = subdivide(points);
  ASSERT_NO_FATAL_FAILURE(expect_certified(points, result));
  EXPECT_EQ(result.statistics.hull_points, 4U);
  EXPECT_EQ(counts_of(result).caps, 1U);
}

// Triangles flatter than the rounding of their midpoints, one upon the other, at the hull.
TEST(Subdivide, NeedlesAreStraightened) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("rotated-grid of " + std::to_string(20 + 5 * seed) + ", seed " +
                 std::to_string(seed));
    const std::vector<Point> points = generate_points("rotated-grid", 20 + 5 * seed, seed);
    ASSERT_NO_FATAL_FAILURE(expect_certified(points, subdivide(points)));
  }
}

// A few units in the last place from a line there may be no room: certified, or a refusal that names
// the culprits.
TEST(Subdivide, PointsNextToALine) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<Point> points = generate_points("near-line", 3 + seed % 10, seed);
    try {
      ASSERT_NO_FATAL_FAILURE(expect_certified(points, subdivide(points)));
    } catch (const Error& error) {
      ++refused;
      ASSERT_EQ(error.code(), ErrorCode::kGuarantee) << error.what();
      ASSERT_GE(error.culprits().size(), 2U);
    }
  }
  EXPECT_LT(refused, 100);
}

TEST(Subdivide, NeighbouringDoublesHaveNoRoom) {
  const double next = 1 + 0x1p-52;
  try {
    subdivide({{1, 1}, {next, 1}, {1, next}, {next, next}});
    FAIL() << "no double lies between these points";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kGuarantee);
  }
}

TEST(Subdivide, EveryMagnitude) {
  for (const int exponent : {-1000, -900, -300, 300, 900, 1000}) {
    for (const char* kind : {"uniform", "grid", "lines", "circle"}) {
      SCOPED_TRACE(std::string(kind) + " times 2^" + std::to_string(exponent));
      std::vector<Point> points = generate_points(kind, 60, 5);
      for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      ASSERT_NO_FATAL_FAILURE(expect_certified(points, subdivide(points)));
    }
  }
}

}  // namespace
}  // namespace quadloom
