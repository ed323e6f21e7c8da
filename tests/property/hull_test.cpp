// The hull against the definition, by brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/grid_points.hpp"

namespace quadloom {
namespace {

using testing::all_collinear;
using testing::random_grid_points;
using testing::uniform_points;

/// p is on the boundary if some line through p and another point has no point on its right.
bool on_boundary(const std::vector<Point>& points, std::size_t p) {
  for (std::size_t q = 0; q < points.size(); ++q) {
    if (q == p) continue;
    const bool supports = std::all_of(points.begin(), points.end(), [&](Point r) {
      return orient2d(points[p], points[q], r) >= 0;
    });
    if (supports) return true;
  }
  return false;
}

void expect_hull(const std::vector<Point>& points) {
  const std::vector<VertexId> hull = convex_hull(points);
  std::vector<VertexId> expected;
  for (VertexId i = 0; i < points.size(); ++i) {
    if (on_boundary(points, i)) expected.push_back(i);
  }
  std::vector<VertexId> sorted = hull;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted, expected);
  for (const Point& p : points) ASSERT_FALSE(lex_less(p, points[hull[0]]));
  const std::size_t h = hull.size();
  if (all_collinear(points)) {
    for (std::size_t i = 1; i < h; ++i) {
      ASSERT_TRUE(lex_less(points[hull[i - 1]], points[hull[i]]));
    }
    return;
  }
  // Every edge supports the whole set, and equal directions are runs in order: once around.
  for (std::size_t i = 0; i < h; ++i) {
    const Point a = points[hull[i]], b = points[hull[(i + 1) % h]], c = points[hull[(i + 2) % h]];
    for (const Point& p : points) ASSERT_GE(orient2d(a, b, p), 0);
    if (orient2d(a, b, c) == 0) {
      ASSERT_EQ(dot_sign(a, b, b, c), 1);
    }
  }
}

TEST(ConvexHull, IsTheBoundaryOfSmallGridSets) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    expect_hull(
        random_grid_points(random, 2 + random.below(14), 1 + random.below(5), 2 + random.below(5)));
    if (HasFatalFailure()) return;
  }
}

TEST(ConvexHull, IsTheBoundaryOfRandomSets) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    expect_hull(uniform_points(random, 2 + random.below(40)));
    if (HasFatalFailure()) return;
  }
}

TEST(ConvexHull, OfNoneAndOne) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_EQ(convex_hull(std::vector<Point>{{1, 2}}), std::vector<VertexId>{0});
}

}  // namespace
}  // namespace quadloom
