// Every generator's points, extremes of magnitude, permutations and exact maps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "kernel/delaunay_in_order.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/delaunay_checks.hpp"

namespace quadloom {
namespace {

void shuffle(std::vector<Point>& points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
}

template <typename Map>
std::vector<Point> mapped(std::vector<Point> points, Map map) {
  for (Point& p : points) p = map(p);
  return points;
}

TEST(DelaunayProperty, EveryGeneratorAtManySizes) {
  for (const Generator& g : generators()) {
    for (const std::size_t size : {8UL, 20UL, 64UL, 65UL, 200UL, 1000UL, 4000UL}) {
      const std::size_t n = std::max(size, g.min_points);
      SCOPED_TRACE(std::string(g.name) + " " + std::to_string(n) + ", seed 1");
      std::vector<Point> points = generate_points(g.name, n, 1);
      ASSERT_NO_FATAL_FAILURE(expect_delaunay(points, delaunay(points)));
    }
  }
}

TEST(DelaunayProperty, TheHardInputsAtSize) {
  for (const std::string kind : {"circle", "rotated-grid", "near-line", "decades", "two-clusters",
                                 "offset", "raster", "collinear-but-one", "lines", "grid"}) {
    SCOPED_TRACE(kind + " 40000, seed 2, shuffled with seed 3");
    std::vector<Point> points = generate_points(kind, 40000, 2);
    shuffle(points, 3);
    ASSERT_NO_FATAL_FAILURE(expect_delaunay(points, delaunay(points)));
  }
}

TEST(DelaunayProperty, TheTrianglesDoNotDependOnTheOrder) {
  for (const Generator& g : generators()) {
    std::vector<Point> points = generate_points(g.name, 700, 4);
    const TriangleSet expected = triangle_set(delaunay(points).mesh);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(std::string(g.name) + " 700, shuffled with seed " + std::to_string(seed));
      shuffle(points, seed);
      ASSERT_EQ(triangle_set(delaunay(points).mesh), expected);
    }
  }
}

TEST(DelaunayProperty, SubsetsOfSmallGrids) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<Point> points = {{0, 0}, {1, 0}, {0, 1}};
    const std::uint64_t width = 2 + random.below(8), count = random.below(40);
    for (std::uint64_t i = 0; i < count; ++i) {
      points.push_back(
          {static_cast<double>(random.below(width)), static_cast<double>(random.below(4))});
    }
    shuffle(points, seed);
    ASSERT_NO_FATAL_FAILURE(expect_delaunay(points, delaunay(points)));
  }
}

// Magnitudes where the filters are silent, up to the ends of the doubles' range.
TEST(DelaunayProperty, EveryMagnitude) {
  for (const std::string kind : {"uniform", "grid", "cocircular", "lines", "decades"}) {
    std::vector<Point> points = generate_points(kind, 300, 5);
    double extent = 0;
    for (const Point& p : points) extent = std::max({extent, std::fabs(p.x), std::fabs(p.y)});
    const int exponent = std::ilogb(extent);
    for (const int to : {-1060, -1000, -500, -150, 150, 500, 1000, 1023}) {
      SCOPED_TRACE(kind + " 300, seed 5, at 2^" + std::to_string(to));
      const auto scaled = mapped(points, [&](Point p) {
        return Point{std::ldexp(p.x, to - exponent), std::ldexp(p.y, to - exponent)};
      });
      const DelaunayResult result = delaunay(scaled);
      ASSERT_NO_FATAL_FAILURE(expect_delaunay(scaled, result));
      // Where scaling is exact the same triangles come out, under the same numbers.
      if (to > -500 && kind != "decades") {
        EXPECT_EQ(result.mesh.tri_vertex, delaunay(points).mesh.tri_vertex);
      }
    }
  }
  SCOPED_TRACE("any exponent, seed 6");
  Random random(6);
  std::vector<Point> points(800);
  for (Point& p : points) {
    for (double* c : {&p.x, &p.y}) {
      const double m = random.uniform() - 0.5;
      *c = std::ldexp(m, static_cast<int>(random.below(2098)) - 1074);
    }
  }
  ASSERT_NO_FATAL_FAILURE(expect_delaunay(points, delaunay(points)));
}

// Without cocircular points the triangulation is unique, so it turns with its points.

TEST(DelaunayProperty, InOrderTheTrianglesAreTheSame) {
  for (const Generator& g : generators()) {
    SCOPED_TRACE(std::string(g.name) + " 900, seed 8, shuffled with seed 9");
    std::vector<Point> points = generate_points(g.name, 900, 8);
    shuffle(points, 9);
    const DelaunayResult given = delaunay(points);
    const kernel::DelaunayInOrder in_order = kernel::delaunay_in_order(points);
    ASSERT_EQ(in_order.input_to_vertex, given.input_to_vertex);
    ASSERT_EQ(triangle_set(in_order.mesh), triangle_set(given.mesh));
    for (VertexId v = 0; v < in_order.vertex.size(); ++v) {
      ASSERT_EQ(in_order.mesh.points[v], given.mesh.points[in_order.vertex[v]]);
    }
    VertexId before = 0;
    for (HalfedgeId h = 0; h < in_order.mesh.twin.size(); ++h) {
      const HalfedgeId twin = in_order.mesh.twin[h];
      if (twin != kNone) {
        ASSERT_EQ(in_order.mesh.twin[twin], h);
        ASSERT_EQ(in_order.mesh.origin(twin), in_order.mesh.target(h));
      }
      if (h % 3 != 0) continue;
      const auto* v = &in_order.mesh.tri_vertex[h];
      const VertexId first = std::min({v[0], v[1], v[2]});
      ASSERT_GE(first, before);
      before = first;
    }
  }
}

TEST(DelaunayProperty, TurnsAndMirrorImages) {
  for (const std::string kind : {"uniform", "gaussian", "clusters"}) {
    SCOPED_TRACE(kind + " 2000, seed 7");
    const std::vector<Point> points = generate_points(kind, 2000, 7);
    const auto quarter = [](Point p) { return Point{-p.y, p.x}; };
    Triangulation turned = delaunay(points).mesh;
    turned.points = mapped(turned.points, quarter);
    ASSERT_EQ(triangle_set(turned), triangle_set(delaunay(mapped(points, quarter)).mesh));
    const auto mirror = [](Point p) { return Point{p.y, p.x}; };
    Triangulation mirrored = delaunay(points).mesh;
    mirrored.points = mapped(mirrored.points, mirror);
    for (std::size_t h = 0; h < mirrored.tri_vertex.size(); h += 3) {
      std::swap(mirrored.tri_vertex[h], mirrored.tri_vertex[h + 1]);
    }
    ASSERT_EQ(triangle_set(mirrored), triangle_set(delaunay(mapped(points, mirror)).mesh));
  }
}

}  // namespace
}  // namespace quadloom
