// Strictly convex quads along the spiral's path on every generator, under exact maps, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "support/convex_checks.hpp"
#include "support/grid_points.hpp"

namespace quadloom {
namespace {

using testing::Room;

void expect_strictly_convex(const std::vector<Point>& points, Room room = Room::kEnough) {
  constexpr std::size_t kSlow = 100;  // where places are scarce each search tries all there are
  for (const ConvexMethod method : {ConvexMethod::kSpiral, ConvexMethod::kPentagons}) {
    if (room == Room::kScarce && points.size() > kSlow && method == ConvexMethod::kPentagons)
      continue;
    SCOPED_TRACE(method == ConvexMethod::kSpiral ? "spiral" : "pentagons");
    for (const OddBoundary odd : {OddBoundary::kTriangle, OddBoundary::kOutside}) {
      ConvexOptions options;
      options.method = method;
      options.odd_boundary = odd;
      testing::expect_convex_quads(points, options, convex_quadrangulation(points, options), room);
    }
  }
}

TEST(ConvexSpiral, OnEveryGenerator) {
  for (const Generator& generator : generators()) {
    for (const std::size_t n : {10U, 57U, 1000U}) {
      SCOPED_TRACE(::testing::Message() << generator.name << " " << n);
      const auto points = distinct_points(generator.make(n, 3)).points;
      if (testing::all_collinear(points)) continue;
      // Rows of points that rounding has bent by a last bit: no doubles are between them.
      const bool scarce = generator.name == "near-line" || generator.name == "rotated-grid";
      expect_strictly_convex(points, scarce ? Room::kScarce : Room::kEnough);
      if (HasFailure()) return;
    }
  }
}

TEST(ConvexSpiral, OnRandomSetsAndTheirExactMaps) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    auto points = testing::uniform_points(random, 4 + random.below(60));
    expect_strictly_convex(points);
    for (Point& p : points) p = {-p.y, std::ldexp(p.x, -30)};
    expect_strictly_convex(points);
    for (Point& p : points) p = {std::ldexp(p.x, 1000), std::ldexp(p.y, 1000)};
    expect_strictly_convex(points);
    if (HasFailure()) return;
  }
}

/// Triangles ABD, BED, BCE, CAE around ADE: a union of two quads that touches itself in A. A hull of
/// four points, then nested triangles, gives the path many chances to go around one.
TEST(ConvexSpiral, OnNestedTriangles) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    std::vector<Point> points = {{-60, -50}, {60, -50}, {50, 70}};
    if (random.below(2) == 0) points.push_back({-50, 60});
    double size = 40;
    for (int layer = 0; layer < 6; ++layer, size *= 0.45) {
      const double turn = 6.28 * random.uniform();
      for (int i = 0; i < 3; ++i) {
        const double angle = turn + 2.0944 * i;
        points.push_back({size * std::cos(angle), size * std::sin(angle)});
      }
    }
    expect_strictly_convex(points);
    if (HasFailure()) return;
  }
}

TEST(ConvexSpiral, FewPoints) {
  const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(convex_quadrangulation(square, {.method = ConvexMethod::kSpiral}).steiner.size(), 0U);
  const std::vector<Point> flat = {{0, 0}, {1, 0}, {2, 0}, {0, 1}};
  EXPECT_EQ(convex_quadrangulation(flat, {.method = ConvexMethod::kSpiral}).steiner.size(), 4U);
  expect_strictly_convex(flat);
  expect_strictly_convex({{0, 0}, {1, 0}, {0, 1}});
  expect_strictly_convex({{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0.25, 0.25}});
}

TEST(ConvexSpiral, RefusesAPointOnAnEdge) {
  ConvexOptions options;
  options.odd_boundary = OddBoundary::kOnEdge;
  const std::vector<Point> points = {{0, 0}, {1, 0}, {0, 1}};
  try {
    convex_quadrangulation(points, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
  }
}

}  // namespace
}  // namespace quadloom
