// Convex layers against peeling, the spiral against the paper's spiraling procedure.
#include <gtest/gtest.h>

#include <cmath>

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
