#include "quadrangulate/odd_boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "kernel/point_on_segment.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

using kernel::point_on_segment;
using namespace quadrangulate;

bool strictly_inside(Point a, Point b, Point p) {
  if (lex_less(b, a)) std::swap(a, b);
  return orient2d(a, b, p) == 0 && lex_less(a, p) && lex_less(p, b);
}

TEST(PointOnSegment, IsTheMiddleWhereItIsADouble) {
  const auto p = point_on_segment({0, 0}, {2, 6});
  ASSERT_TRUE(p);
  EXPECT_EQ(*p, (Point{1, 3}));
  EXPECT_EQ(point_on_segment({5, 1}, {5, 4}), (Point{5, 2.5}));
}

TEST(PointOnSegment, FindsThePointAwayFromTheMiddle) {
  // Between 1 and 2 doubles step by u; the segment's only inner points are thirds of it.
  const double u = 0x1p-52;
  const Point a{1, 1};
  const Point b{1 + 3 * u, 1 + 6 * u};
  const auto p = point_on_segment(a, b);
  ASSERT_TRUE(p);
  EXPECT_TRUE(*p == (Point{1 + u, 1 + 2 * u}) || *p == (Point{1 + 2 * u, 1 + 4 * u}));
}

TEST(PointOnSegment, KnowsThatThereIsNone) {
  const double u = 0x1p-52;
  EXPECT_FALSE(point_on_segment({1, 1}, {1 + 2 * u, 1 + 3 * u}));
  EXPECT_FALSE(point_on_segment({1, 1}, {1, 1 + u}));
  EXPECT_FALSE(point_on_segment({0, 0}, {std::numeric_limits<double>::denorm_min(), 0}));
}

TEST(PointOnSegment, UsesTheFinerDoublesNearZero) {
  // The direction is (2, 3) units in both, but near zero half a unit is a double too.
  const double u = 0x1p-52;
  EXPECT_FALSE(point_on_segment({1 + 2 * u, 1 + 3 * u}, {1 + 4 * u, 1 + 6 * u}));
  EXPECT_TRUE(point_on_segment({-2 * u, 3 * u}, {0, 6 * u}));
}

TEST(PointOnSegment, SurvivesExtremeExponents) {
  const double big = std::numeric_limits<double>::max();
  const auto p = point_on_segment({-big, -big}, {big, big});
  ASSERT_TRUE(p);
  EXPECT_TRUE(strictly_inside({-big, -big}, {big, big}, *p));
  const auto q = point_on_segment({-1e300, 3e-300}, {1e300, 3e-300});
  ASSERT_TRUE(q);
  EXPECT_EQ(q->y, 3e-300);
}

TEST(PointOnSegment, AgreesWithBruteForceAcrossABinade) {
  // At 2^53 the spacing of the doubles changes from one to two.
  int found = 0;
  int none = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const double base = 0x1p53;
    const auto coordinate = [&] {
      const double below = static_cast<double>(random.below(16));
      return random.below(2) == 0 ? base - below : base + 2 * below;
    };
    const Point a{coordinate(), coordinate()};
    const Point b{coordinate(), coordinate()};
    if (a == b) continue;
    std::optional<Point> expected;
    double best = 1e300;
    for (int i = -16; i <= 16; ++i) {
      for (int j = -16; j <= 16; ++j) {
        const Point p{i < 0 ? base + i : base + 2 * i, j < 0 ? base + j : base + 2 * j};
        if (!strictly_inside(a, b, p)) continue;
        const double distance =
            std::fabs((p.x - a.x) - (b.x - p.x)) + std::fabs((p.y - a.y) - (b.y - p.y));
        if (distance < best) {
          best = distance;
          expected = p;
        }
      }
    }
    const auto p = point_on_segment(a, b);
    ASSERT_EQ(p.has_value(), expected.has_value());
    (p ? found : none) += 1;
    if (p) {
      ASSERT_TRUE(strictly_inside(a, b, *p));
    }
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(none, 50);
}

TEST(OddPlace, IsWellShapedAboveALongEdge) {
  const auto odd = place_odd_point({0, 4}, {0, 0}, {4, 0}, {4, 4}, OddBoundary::kOutside);
  ASSERT_TRUE(odd);
  EXPECT_EQ(odd->kind, SteinerKind::kOutside);
  EXPECT_EQ(odd->place, (Point{2, -2}));
}

TEST(OddPlace, StaysBelowTheApexOfItsRegion) {
  const auto s = place_outside({-1, 10}, {0, 0}, {4, 0}, {5, 10});  // apex far outside: 20 deep
  ASSERT_TRUE(s);
  EXPECT_EQ(*s, (Point{2, -2}));
  const auto t = place_outside({-8, 1}, {0, 0}, {4, 0}, {12, 1});  // apex (2, -1/4)
  ASSERT_TRUE(t);
  EXPECT_EQ(t->x, 2);
  EXPECT_LT(t->y, -0.05);
  EXPECT_GT(t->y, -0.2);
}

TEST(OddPlace, LeansWithASkewedRegion) {
  const Point before{-40, 1}, a{0, 0}, b{4, 0}, after{4 - 44, 1.2};
  const auto s = place_outside(before, a, b, after);
  ASSERT_TRUE(s);
  EXPECT_EQ(orient2d(before, a, *s), 1);
  EXPECT_EQ(orient2d(*s, b, after), 1);
  EXPECT_EQ(orient2d(a, b, *s), -1);
}

TEST(OddPlace, FallsBackToTheEdgeNextToAStraightRun) {
  const auto odd = place_odd_point({-4, 0}, {0, 0}, {4, 0}, {4, 4}, OddBoundary::kOutside);
  ASSERT_TRUE(odd);
  EXPECT_EQ(odd->kind, SteinerKind::kOnEdge);
  EXPECT_EQ(odd->place, (Point{2, 0}));
}

TEST(OddPlace, FallsBackToOutsideWhereTheEdgeHasNoDouble) {
  const double u = 0x1p-52;
  const Point a{1, 1 + 3 * u}, b{1 + 2 * u, 1}, c{2, 2};
  const auto odd = place_odd_point(c, a, b, c, OddBoundary::kOnEdge);
  ASSERT_TRUE(odd);
  EXPECT_EQ(odd->kind, SteinerKind::kOutside);
  EXPECT_EQ(orient2d(c, a, odd->place), 1);
}

TEST(OddPlace, SurvivesHugeAndTinyTriangles) {
  for (const double scale : {1e-320, 1e-300, 1.0, 1e300, 1.7e308}) {
    SCOPED_TRACE(scale);
    const Point a{-scale, -scale}, b{scale, -scale}, c{0, scale};
    for (const OddBoundary wish : {OddBoundary::kOutside, OddBoundary::kOnEdge}) {
      const auto odd = place_odd_point(c, a, b, c, wish);
      ASSERT_TRUE(odd);
      EXPECT_EQ(odd->kind == SteinerKind::kOnEdge,
                wish == OddBoundary::kOnEdge || !place_outside(c, a, b, c));
    }
  }
}

TEST(ChooseOddEdge, PrefersAnEdgeThatAdmitsTheWish) {
  // A rectangle with a point in the middle of three of its sides: only the right side is free.
  const std::vector<Point> points = {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}};
  const auto hull = convex_hull(points);
  const OddEdge edge = choose_odd_edge(points, hull, OddBoundary::kOutside);
  EXPECT_EQ(edge.odd.kind, SteinerKind::kOutside);
  EXPECT_EQ(points[hull[edge.index]], (Point{4, 0}));
  EXPECT_EQ(choose_odd_edge(points, hull, OddBoundary::kOnEdge).index, 0U);
}

TEST(ChooseOddEdge, TakesTheOtherKindIfNoEdgeHasADouble) {
  const double u = std::numeric_limits<double>::denorm_min();
  // The smallest triangle there is: no double lies inside an edge.
  const std::vector<Point> points = {{0, 0}, {u, 0}, {0, u}};
  const auto hull = convex_hull(points);
  const OddEdge edge = choose_odd_edge(points, hull, OddBoundary::kOnEdge);
  EXPECT_EQ(edge.odd.kind, SteinerKind::kOutside);
}

}  // namespace
}  // namespace quadloom
