// The spiral method on random sets with many collinear points and on every generator.
#include <gtest/gtest.h>

#include "support/grid_points.hpp"
#include "support/quad_checks.hpp"
#include "support/serpentine_checks.hpp"

namespace quadloom {
namespace {

using namespace testing;

void expect_spiral_method(const std::vector<Point>& points) {
  expect_serpentine(serpentine_triangulation(points));
  for (const OddBoundary wish :
       {OddBoundary::kOutside, OddBoundary::kOnEdge, OddBoundary::kTriangle}) {
    if (::testing::Test::HasFatalFailure()) return;
    PointOptions options;
    options.method = PointMethod::kSpiral;
    options.odd_boundary = wish;
    expect_quadrangulation(quadrangulate_points(points, options), points, wish);
  }
}

void expect_on_random_grid_sets(std::uint64_t width, std::uint64_t height, std::size_t most,
                                std::uint64_t seeds) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(::testing::Message() << width << " x " << height << ", seed " << seed);
    Random random(seed);
    const auto points = random_grid_points(random, 3 + random.below(most - 2), width, height);
    if (all_collinear(points)) continue;
    expect_spiral_method(points);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(SpiralMethod, OnRandomSubsetsOfGrids) {
  expect_on_random_grid_sets(5, 5, 25, 4000);
  expect_on_random_grid_sets(6, 6, 36, 4000);
  expect_on_random_grid_sets(3, 20, 40, 2000);
  expect_on_random_grid_sets(20, 3, 40, 2000);
  expect_on_random_grid_sets(2, 30, 40, 500);
  expect_on_random_grid_sets(40, 40, 300, 100);
}

TEST(SpiralMethod, OnRandomSetsInGeneralPosition) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    expect_spiral_method(uniform_points(random, 3 + random.below(100)));
    if (HasFatalFailure()) return;
  }
}

TEST(SpiralMethod, OnEveryGenerator) {
  for (const Generator& generator : generators()) {
    for (const std::size_t n : {10U, 57U, 1000U}) {
      SCOPED_TRACE(::testing::Message() << generator.name << " " << n);
      const auto points = distinct_points(generator.make(n, 3)).points;
      if (all_collinear(points)) continue;
      expect_spiral_method(points);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SpiralMethod, MergesDuplicatesAndRefusesLines) {
  PointOptions options;
  options.method = PointMethod::kSpiral;
  const std::vector<Point> points = {{0, 0}, {1, 0}, {0, 0}, {1, 1}, {0, 1}, {1, 1}};
  const PointResult result = quadrangulate_points(points, options);
  EXPECT_EQ(result.input_vertices, 4U);
  EXPECT_EQ(result.mesh.quad_count(), 1U);
  EXPECT_EQ(result.input_to_vertex, (std::vector<VertexId>{0, 1, 0, 2, 3, 2}));
  const auto code_of = [&](const std::vector<Point>& input) {
    try {
      quadrangulate_points(input, options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kFile;
  };
  EXPECT_EQ(code_of({{0, 0}, {1, 1}, {2, 2}}), ErrorCode::kAllCollinear);
  EXPECT_EQ(code_of({{0, 0}, {1, 1}, {0, 0}}), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code_of({}), ErrorCode::kTooFewPoints);
  EXPECT_FALSE(has_quadrangulation(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
}

}  // namespace
}  // namespace quadloom
