// Meshes of k-gons of random sets.
#include <gtest/gtest.h>

#include "support/grid_points.hpp"
#include "support/k_gon_checks.hpp"

namespace quadloom {
namespace {

using namespace testing;

/// The faces are right and the bound is met.
void expect_k_angulations(const std::vector<Point>& points, std::size_t largest_k) {
  const std::size_t h = convex_hull(points).size();
  for (std::size_t k = 4; k <= largest_k; k += 1 + k / 4) {
    SCOPED_TRACE(::testing::Message() << "k " << k);
    const KAngulationResult result = k_angulate_points(points, k);
    expect_k_angulation(result, points, k);
    if (::testing::Test::HasFatalFailure()) return;
    ASSERT_LE(result.steiner.size(), k - 3);
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
    if (all_collinear(points) || generator.name == "near-line") continue;  // no room there
    expect_k_angulations(points, 12);
    if (HasFatalFailure()) return;
  }
}

TEST(KAngulation, OfAnyNumberOfCornersOnEveryGenerator) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const Generator& generator : generators()) {
      Random random(seed);
      const std::size_t n = generator.min_points + random.below(200);
      const auto points = distinct_points(generator.make(n, seed)).points;
      if (all_collinear(points) || generator.name == "near-line") continue;  // no room there
      for (int i = 0; i < 3; ++i) {
        const std::size_t k = 4 + random.below(points.size());
        SCOPED_TRACE(::testing::Message()
                     << generator.name << ", n " << n << ", seed " << seed << ", k " << k);
        const KAngulationResult result = k_angulate_points(points, k);
        expect_k_angulation(result, points, k);
        ASSERT_LE(result.steiner.size(), k - 3);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(KAngulation, BySpiralKeepsTheBoundToo) {
  PointOptions options;
  options.method = PointMethod::kSpiral;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const auto points = uniform_points(random, 10 + random.below(90));
    const std::size_t k = 4 + random.below(points.size());
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", k " << k);
    const KAngulationResult result = k_angulate_points(points, k, options);
    expect_k_angulation(result, points, k);
    ASSERT_LE(result.steiner.size(), k - 3);
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
