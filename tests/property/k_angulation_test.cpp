// Meshes of k-gons of random sets.
#include <gtest/gtest.h>

#include "support/grid_points.hpp"
#include "support/k_gon_checks.hpp"

namespace quadloom {
namespace {

using namespace testing;

/// The faces are right for every k; the bound is met where the method's file promises it.
void expect_k_angulations(const std::vector<Point>& points, std::size_t largest_k) {
  const std::size_t h = convex_hull(points).size();
  const std::size_t triangles = 2 * points.size() - 2 - h;
  for (std::size_t k = 4; k <= largest_k; k += 1 + k / 4) {
    SCOPED_TRACE(::testing::Message() << "k " << k);
    const KAngulationResult result = k_angulate_points(points, k);
    expect_k_angulation(result, points, k);
    if (::testing::Test::HasFatalFailure()) return;
    if (k <= 5 || 2 * (k - 2) >= triangles || h == points.size()) {
      ASSERT_LE(result.steiner.size(), k - 3);
    }
    if (k == 4) {
      ASSERT_EQ(result.steiner.size(), h % 2);
    }
  }
}

TEST(KAngulation, OnRandomSetsInGeneralPosition) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const auto points = uniform_points(random, 3 + random.below(60));
    expect_k_angulations(points, 2 * points.size());
    if (HasFatalFailure()) return;
  }
}

TEST(KAngulation, OnRandomSubsetsOfGrids) {
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const auto points =
        random_grid_points(random, 3 + random.below(40), 2 + random.below(7), 2 + random.below(7));
    if (all_collinear(points)) continue;
    expect_k_angulations(points, 2 * points.size());
    if (HasFatalFailure()) return;
  }
}

TEST(KAngulation, OnEveryGenerator) {
  for (const Generator& generator : generators()) {
    SCOPED_TRACE(generator.name);
    const auto points = distinct_points(generator.make(300, 5)).points;
    if (all_collinear(points)) continue;
    expect_k_angulations(points, 12);
    if (HasFatalFailure()) return;
  }
}

TEST(KAngulation, MakesTwoPentagonsOfATriangleWithAPointInside) {
  const std::vector<Point> points = {{0, 0}, {9, 0}, {0, 9}, {3, 3}};
  const KAngulationResult result = k_angulate_points(points, 5);
  expect_k_angulation(result, points, 5);
  EXPECT_EQ(result.mesh.face_count(), 2U);
  EXPECT_EQ(result.steiner.size(), 2U);
}

TEST(KAngulation, RefusesWhatMakesNoSense) {
  const std::vector<Point> points = {{0, 0}, {9, 0}, {0, 9}, {3, 3}};
  EXPECT_THROW(k_angulate_points(points, 3), Error);
  PointOptions options;
  options.odd_boundary = OddBoundary::kTriangle;
  EXPECT_THROW(k_angulate_points(points, 5, options), Error);
}

}  // namespace
}  // namespace quadloom
