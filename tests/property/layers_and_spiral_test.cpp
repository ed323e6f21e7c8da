// Convex layers against peeling, the spiral against the paper's spiraling procedure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernel/layer_bands.hpp"
#include "kernel/lex_order.hpp"
#include "kernel/peel_layers.hpp"
#include "quadloom/generate.hpp"
#include "support/grid_points.hpp"

namespace quadloom {
namespace {

using testing::random_grid_points;
using testing::uniform_points;

/// Hull after hull: the definition.
ConvexLayers peel(const std::vector<Point>& points) {
  ConvexLayers layers;
  std::vector<VertexId> rest(points.size());
  for (VertexId i = 0; i < rest.size(); ++i) rest[i] = i;
  while (!rest.empty()) {
    std::vector<Point> left;
    for (const VertexId v : rest) left.push_back(points[v]);
    std::vector<char> on_hull(left.size(), 0);
    for (const VertexId i : convex_hull(left)) {
      layers.vertex.push_back(rest[i]);
      on_hull[i] = 1;
    }
    layers.begin.push_back(static_cast<std::uint32_t>(layers.vertex.size()));
    std::vector<VertexId> inner;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (!on_hull[i]) inner.push_back(rest[i]);
    }
    rest = inner;
  }
  return layers;
}

/// The paper's procedure: turn the ray clockwise to the next unmarked point, nearest first. The
/// unmarked points lie right of the ray or ahead on it.
std::vector<VertexId> turn_the_ray(const std::vector<Point>& points, VertexId start) {
  std::vector<VertexId> spiral = {start};
  std::vector<char> marked(points.size(), 0);
  marked[start] = 1;
  while (spiral.size() < points.size()) {
    const Point eye = points[spiral.back()];
    VertexId best = kNone;
    for (VertexId v = 0; v < points.size(); ++v) {
      if (marked[v]) continue;
      const int side = best == kNone ? 1 : orient2d(eye, points[best], points[v]);
      if (side > 0 || (side == 0 && dot_sign(points[v], eye, points[v], points[best]) < 0))
        best = v;
    }
    marked[best] = 1;
    spiral.push_back(best);
  }
  return spiral;
}

void expect_layers_and_spiral(const std::vector<Point>& points) {
  const ConvexLayers layers = convex_layers(points);
  const ConvexLayers expected = peel(points);
  ASSERT_EQ(layers.begin, expected.begin);
  ASSERT_EQ(layers.vertex, expected.vertex);
  const VertexId start = layers.vertex[0];
  ASSERT_EQ(convex_spiral(points), turn_the_ray(points, start));
}

TEST(ConvexLayers, AreTheHullsOfWhatIsLeftOnSmallGrids) {
  for (std::uint64_t seed = 1; seed <= 6000; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    expect_layers_and_spiral(
        random_grid_points(random, 1 + random.below(40), 1 + random.below(8), 1 + random.below(8)));
    if (HasFatalFailure()) return;
  }
}

TEST(ConvexLayers, AreTheHullsOfWhatIsLeftOnRandomSets) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    expect_layers_and_spiral(uniform_points(random, 1 + random.below(200)));
    expect_layers_and_spiral(random_grid_points(random, 1 + random.below(200), 20, 20));
    if (HasFatalFailure()) return;
  }
}

TEST(ConvexLayers, AreTheHullsOfWhatIsLeftForEveryGenerator) {
  for (const Generator& generator : generators()) {
    for (const std::size_t n : {10U, 50U, 300U}) {
      SCOPED_TRACE(::testing::Message() << generator.name << " " << n);
      const auto input = generator.make(n, 7);
      expect_layers_and_spiral(distinct_points(input).points);
      if (HasFatalFailure()) return;
    }
  }
}

void expect_layers_in_bands(const std::vector<Point>& points, kernel::PeelingSizes sizes) {
  const kernel::LexOrder order = kernel::lex_order(points);
  ConvexLayers layers = kernel::peel_layers(order.points, {}, sizes);
  for (VertexId& v : layers.vertex) v = order.index[v];
  const ConvexLayers expected = peel(points);
  ASSERT_EQ(layers.begin, expected.begin);
  ASSERT_EQ(layers.vertex, expected.vertex);
}

// Small bands, so that small sets have many: good ones, and such as have little to do with the layers.
TEST(ConvexLayers, DoNotDependOnTheBands) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const kernel::PeelingSizes sizes = {.band = 1 + random.below(20),
                                        .sample = 2 + random.below(5)};
    expect_layers_in_bands(uniform_points(random, 1 + random.below(300)), sizes);
    expect_layers_in_bands(random_grid_points(random, 1 + random.below(300), 1 + random.below(30),
                                              1 + random.below(30)),
                           sizes);
    if (HasFatalFailure()) return;
  }
}

TEST(ConvexLayers, DoNotDependOnTheBandsForAnyGenerator) {
  for (const Generator& generator : generators()) {
    for (const std::size_t n : {100U, 1500U}) {
      for (const std::size_t band : {16U, 100U}) {
        SCOPED_TRACE(::testing::Message() << generator.name << " " << n << " " << band);
        const auto points = distinct_points(generator.make(n, 7)).points;
        expect_layers_in_bands(points, {.band = band, .sample = 4});
        if (HasFatalFailure()) return;
      }
    }
  }
}

// One bound does for all determinants of a set: below it, above it, and where they underflow or overflow.
TEST(ConvexLayers, AreTheSameAtAnyMagnitude) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const auto points = random_grid_points(random, 1 + random.below(200), 1 + random.below(40), 40);
    const kernel::LexOrder order = kernel::lex_order(points);
    const kernel::PeelingSizes sizes = {.band = 16, .sample = 4};
    const ConvexLayers expected = kernel::peel_layers(order.points, {}, sizes);
    const Point scales[] = {{0x1p-1074, 0x1p-1074}, {0x1p-500, 0x1p-503},  {0x1p500, 0x1p506},
                            {0x1p1018, 0x1p1018},   {0x1p-1074, 0x1p1018}, {0x1p1018, 0x1p-1074}};
    for (const Point scale : scales) {
      std::vector<Point> scaled = order.points;
      for (Point& p : scaled) p = {p.x * scale.x, p.y * scale.y};
      const ConvexLayers layers = kernel::peel_layers(scaled, {}, sizes);
      ASSERT_EQ(layers.begin, expected.begin);
      ASSERT_EQ(layers.vertex, expected.vertex);
    }
  }
}

// In a cross nearly all triangles share few corners: peeling goes on with hull trees.
TEST(ConvexLayers, AreTheHullsOfWhatIsLeftOfManyPoints) {
  for (const char* kind : {"uniform", "cross", "grid"}) {
    SCOPED_TRACE(kind);
    const auto points = distinct_points(generate_points(kind, 40'000, 3)).points;
    const ConvexLayers layers = convex_layers(points);
    std::vector<VertexId> rest(points.size());
    std::iota(rest.begin(), rest.end(), VertexId{0});
    for (std::size_t i = 0; i < std::min<std::size_t>(layers.count(), 150); ++i) {
      std::vector<Point> left;
      for (const VertexId v : rest) left.push_back(points[v]);
      std::vector<VertexId> hull = convex_hull(left);
      for (VertexId& v : hull) v = rest[v];
      const auto layer = layers.layer(i);
      ASSERT_EQ(hull, std::vector<VertexId>(layer.begin(), layer.end()));
      std::vector<char> gone(points.size(), 0);
      for (const VertexId v : hull) gone[v] = 1;
      rest.erase(std::remove_if(rest.begin(), rest.end(), [&](VertexId v) { return gone[v]; }),
                 rest.end());
    }
  }
}

TEST(LayerBands, AreAboutTheLayers) {
  Random random(1);
  const std::vector<Point> sorted = kernel::lex_order(uniform_points(random, 50'000)).points;
  std::vector<Point> sample;
  for (std::size_t i = 0; i < sorted.size(); i += 10) sample.push_back(sorted[i]);
  const kernel::LayerBands bands =
      kernel::layer_bands(sorted, sample, kernel::peel_layers(sample), 500);
  ASSERT_GE(bands.count, 8U);
  ASSERT_LE(bands.count, 11U);
  // The points of each band, peeled from the outside in, should be those of the next so many layers.
  std::vector<std::size_t> size(bands.count, 0);
  for (const std::uint32_t band : bands.of_point) ++size[band];
  const ConvexLayers layers = kernel::peel_layers(sorted);
  std::size_t band = 0, end = size[0], right = 0;
  for (std::size_t i = 0; i < layers.vertex.size(); ++i) {
    while (i >= end) end += size[++band];
    if (bands.of_point[layers.vertex[i]] == band) ++right;
  }
  ASSERT_GT(right, sorted.size() * 8 / 10);
}

TEST(LexOrder, IsThatOfTheCoordinates) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    std::vector<Point> points = seed % 2 == 0
                                    ? uniform_points(random, random.below(300))
                                    : random_grid_points(random, random.below(300), 9, 40);
    const double scales[] = {1, -1, 0x1p-1060, 0x1p1015, 0};
    for (Point& p : points) {
      const double scale = scales[random.below(1 + seed % 5)];
      p = {p.x * scale, p.y * scale};
    }
    std::vector<VertexId> expected(points.size());
    std::iota(expected.begin(), expected.end(), VertexId{0});
    std::stable_sort(expected.begin(), expected.end(),
                     [&](VertexId a, VertexId b) { return lex_less(points[a], points[b]); });
    const kernel::LexOrder order = kernel::lex_order(points);
    ASSERT_EQ(order.index, expected);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(order.points[i], points[expected[i]]);
    }
  }
}

TEST(ConvexSpiral, MayStartAtAnyCorner) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const auto points = random_grid_points(random, 3 + random.below(30), 6, 6);
    const auto hull = convex_hull(points);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point before = points[hull[(i + hull.size() - 1) % hull.size()]];
      if (orient2d(before, points[hull[i]], points[hull[(i + 1) % hull.size()]]) == 0) continue;
      ASSERT_EQ(convex_spiral(points, hull[i]), turn_the_ray(points, hull[i]));
    }
  }
}

TEST(ConvexSpiral, RefusesAStartInside) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {0, 4}, {1, 1}};
  EXPECT_THROW(convex_spiral(points, 3), Error);
}

}  // namespace
}  // namespace quadloom
