// Random polygons with holes and inner points, random segments, exact maps and permutations.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "support/constrained_checks.hpp"
#include "support/delaunay_checks.hpp"

namespace quadloom {
namespace {

PlanarInput of(const Polygon& polygon) {
  PlanarInput input;
  input.polygons.push_back(polygon);
  return input;
}

Point box_corner(const Polygon& polygon, bool upper) {
  Point out = polygon.rings[0][0];
  for (const Point p : polygon.rings[0]) {
    out.x = upper ? std::max(out.x, p.x) : std::min(out.x, p.x);
    out.y = upper ? std::max(out.y, p.y) : std::min(out.y, p.y);
  }
  return out;
}

/// Whole points in the box of the polygon.
std::vector<Point> points_in_box(const Polygon& polygon, std::size_t count, Random& random) {
  const Point low = box_corner(polygon, false), high = box_corner(polygon, true);
  std::vector<Point> out;
  for (std::size_t i = 0; i < count; ++i) {
    out.push_back(
        {low.x + static_cast<double>(random.below(static_cast<std::uint64_t>(high.x - low.x) + 1)),
         low.y +
             static_cast<double>(random.below(static_cast<std::uint64_t>(high.y - low.y) + 1))});
  }
  return out;
}

void reorder(Polygon& polygon, Random& random) {
  for (auto& ring : polygon.rings) {
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random.below(ring.size())),
                ring.end());
    if (random.below(2) == 0) std::reverse(ring.begin(), ring.end());
    if (random.below(2) == 0) ring.push_back(ring.front());
  }
  for (std::size_t i = polygon.rings.size(); i > 2; --i) {
    std::swap(polygon.rings[i - 1], polygon.rings[1 + random.below(i - 1)]);
  }
}

TEST(ConstrainedProperty, PolygonsOfEveryKindWithHolesAndInnerPoints) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const std::size_t n = g.min_corners + 2 * seed;
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed " +
                   std::to_string(seed));
      Random random(seed);
      PlanarInput input = of(g.make(n, seed));
      const ConstrainedResult bare = constrained_delaunay(input);
      ASSERT_NO_FATAL_FAILURE(expect_polygons(input, bare));
      ASSERT_EQ(bare.mesh.triangle_count(), input.polygons[0].rings[0].size() - 2);
      input.polygons[0] = with_holes(input.polygons[0], random.below(n), seed);
      input.points = points_in_box(input.polygons[0], random.below(3 * n), random);
      ASSERT_NO_FATAL_FAILURE(expect_polygons(input, constrained_delaunay(input)));
      ASSERT_NO_FATAL_FAILURE(expect_polygons(input, constrained_delaunay(input, Extent::kHull)));
    }
  }
}

TEST(ConstrainedProperty, LargerPolygons) {
  for (const PolygonGenerator& g : polygon_generators()) {
    SCOPED_TRACE(std::string(g.name) + " 1000, seed 7, 200 holes");
    const PlanarInput input = of(with_holes(g.make(1000, 7), 200, 7));
    ASSERT_NO_FATAL_FAILURE(expect_polygons(input, constrained_delaunay(input)));
  }
}

TEST(ConstrainedProperty, TheTrianglesDoNotDependOnTheOrder) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(std::string(g.name) + " 80, seed " + std::to_string(seed));
      Random random(seed);
      PlanarInput input = of(with_holes(g.make(80, seed), 20, seed));
      input.points = points_in_box(input.polygons[0], 60, random);
      const TriangleSet expected = triangle_set(constrained_delaunay(input).mesh);
      reorder(input.polygons[0], random);
      std::reverse(input.points.begin(), input.points.end());
      const ConstrainedResult again = constrained_delaunay(input);
      ASSERT_NO_FATAL_FAILURE(expect_polygons(input, again));
      ASSERT_EQ(triangle_set(again.mesh), expected);
    }
  }
}

bool cross_or_overlap(Point a, Point b, Point c, Point d) {
  const int o1 = orient2d(a, b, c), o2 = orient2d(a, b, d), o3 = orient2d(c, d, a),
            o4 = orient2d(c, d, b);
  if (o1 * o2 < 0 && o3 * o4 < 0) return true;
  if (o1 != 0 || o2 != 0) return false;
  if (lex_less(b, a)) std::swap(a, b);
  if (lex_less(d, c)) std::swap(c, d);
  return lex_less(std::max(a, c, lex_less), std::min(b, d, lex_less));
}

/// Segments between points of a small grid, many points on segments, tried against all others.
PlanarInput random_segments(Random& random, std::uint64_t width, std::size_t points,
                            std::size_t tries) {
  PlanarInput input;
  input.points = {{0, 0}, {1, 0}, {0, 1}};
  for (std::size_t i = 0; i < points; ++i) {
    input.points.push_back(
        {static_cast<double>(random.below(width)), static_cast<double>(random.below(width))});
  }
  for (std::size_t i = 0; i < tries; ++i) {
    const auto from = static_cast<VertexId>(random.below(input.points.size()));
    const auto to = static_cast<VertexId>(random.below(input.points.size()));
    const Point a = input.points[from], b = input.points[to];
    const bool free = std::none_of(input.segments.begin(), input.segments.end(), [&](Segment s) {
      return cross_or_overlap(a, b, input.points[s.from], input.points[s.to]);
    });
    if (free) input.segments.push_back({from, to});
  }
  return input;
}

void expect_segments(const PlanarInput& input, const ConstrainedResult& r) {
  ASSERT_EQ(expect_input_vertices(input, r), 0U);
  DelaunayResult as_points{r.mesh, r.input_to_vertex};
  ASSERT_NO_FATAL_FAILURE(expect_tiling(as_points.mesh));
  ASSERT_NO_FATAL_FAILURE(expect_positive_triangles_and_twins(r));
  ASSERT_NO_FATAL_FAILURE(expect_constrained_delaunay_edges(r));
  ASSERT_NO_FATAL_FAILURE(expect_forced_edges_on_input(input, r));
  ASSERT_NO_FATAL_FAILURE(expect_input_edges_forced(input, r, false));
}

TEST(ConstrainedProperty, SegmentsOnGrids) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::uint64_t width = 2 + random.below(12);
    PlanarInput input = random_segments(random, width, random.below(60), 80);
    const ConstrainedResult r = constrained_delaunay(input, Extent::kHull);
    ASSERT_NO_FATAL_FAILURE(expect_segments(input, r));
    std::reverse(input.segments.begin(), input.segments.end());
    ASSERT_EQ(triangle_set(constrained_delaunay(input, Extent::kHull).mesh), triangle_set(r.mesh));
  }
}

TEST(ConstrainedProperty, LongSegmentsAmongManyPoints) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    PlanarInput input = random_segments(random, std::uint64_t{1} << (4 + seed % 40), 400, 60);
    ASSERT_NO_FATAL_FAILURE(expect_segments(input, constrained_delaunay(input, Extent::kHull)));
  }
}

// One segment too many, put among those that are fine: found, and named with one that it meets.
TEST(ConstrainedProperty, ASegmentThatCrossesIsNamed) {
  std::size_t crossings = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    PlanarInput input = random_segments(random, 3 + random.below(12), 30, 40);
    const Segment extra{static_cast<VertexId>(random.below(input.points.size())),
                        static_cast<VertexId>(random.below(input.points.size()))};
    const auto place = static_cast<std::size_t>(random.below(input.segments.size() + 1));
    input.segments.insert(input.segments.begin() + static_cast<std::ptrdiff_t>(place), extra);
    const auto bad = [&](Segment s, Segment t) {
      const Point a = input.points[s.from], b = input.points[s.to], c = input.points[t.from],
                  d = input.points[t.to];
      const bool same = (a == c && b == d) || (a == d && b == c);
      // Where an input point is on both, they meet there and do not cross.
      const bool meet = orient2d(a, b, c) != orient2d(a, b, d) &&
                        std::any_of(input.points.begin(), input.points.end(), [&](Point p) {
                          return on_segment(a, b, p) && on_segment(c, d, p);
                        });
      return !same && !meet && cross_or_overlap(a, b, c, d);
    };
    const bool expected = std::any_of(input.segments.begin(), input.segments.end(),
                                      [&](Segment s) { return bad(s, extra); });
    try {
      (void)constrained_delaunay(input, Extent::kHull);
      ASSERT_FALSE(expected);
    } catch (const Error& error) {
      ++crossings;
      ASSERT_EQ(error.code(), ErrorCode::kCrossing) << error.what();
      ASSERT_TRUE(expected) << error.what();
      ASSERT_EQ(error.culprits().size(), 2U);
      ASSERT_TRUE(bad(input.segments[error.culprits()[0]], input.segments[error.culprits()[1]]));
    }
  }
  EXPECT_GT(crossings, 300U);
}

}  // namespace
}  // namespace quadloom
