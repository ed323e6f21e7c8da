// Every subset of the 4 x 4 grid, and random subsets of bigger grids, in strictly convex quads:
// certified within the bound.
#include <gtest/gtest.h>

#include <iostream>

#include "core/random.hpp"
#include "support/convex_checks.hpp"
#include "support/grid_points.hpp"

namespace quadloom {
namespace {

struct Totals {
  std::size_t sets = 0, outer = 0, patches = 0, kept = 0, steiner = 0;
  std::array<std::size_t, 5> by_points = {};
};

void check_both_odd_boundaries(const std::vector<Point>& points, ConvexMethod method,
                               Totals& totals) {
  if (points.size() < 3 || testing::all_collinear(points)) return;
  for (const OddBoundary odd : {OddBoundary::kTriangle, OddBoundary::kOutside}) {
    ConvexOptions options;
    options.method = method;
    options.odd_boundary = odd;
    const ConvexResult result = convex_quadrangulation(points, options);
    testing::expect_convex_quads(points, options, result);
    ++totals.sets;
    totals.kept += result.statistics.kept;
    totals.patches += result.statistics.patches;
    totals.steiner += result.steiner.size();
    for (std::size_t k = 0; k < 5; ++k) {
      totals.by_points[k] += result.statistics.patches_by_points[k];
    }
    for (const SteinerPoint& s : result.steiner) {
      if (s.kind == SteinerKind::kOutside) ++totals.outer;
    }
    if (has_quadrangulation(points)) return;  // even: the option plays no part
  }
}

void print(const Totals& totals) {
  std::cout << totals.sets << " runs, " << totals.outer << " with a point outside, "
            << totals.steiner << " points, " << totals.kept << " quads kept, " << totals.patches
            << " patches, by points:";
  for (const std::size_t count : totals.by_points) std::cout << " " << count;
  std::cout << "\n";
}

TEST(ConvexPoints, AllSubsetsOfTheFourByFourGrid) {
  Totals totals;
  for (std::uint64_t mask = 0; mask < 1U << 16; ++mask) {
    SCOPED_TRACE("subset " + std::to_string(mask));
    check_both_odd_boundaries(testing::grid_subset(4, mask), ConvexMethod::kSpiral, totals);
    if (HasFailure()) return;
  }
  print(totals);
  EXPECT_GT(totals.outer, 0U);
  for (const std::size_t k : {0U, 1U, 2U, 3U, 4U}) EXPECT_GT(totals.by_points[k], 0U) << k;
}

TEST(ConvexPoints, AllSubsetsOfTheFourByFourGridByPentagons) {
  Totals totals;
  for (std::uint64_t mask = 0; mask < 1U << 16; ++mask) {
    SCOPED_TRACE("subset " + std::to_string(mask));
    check_both_odd_boundaries(testing::grid_subset(4, mask), ConvexMethod::kPentagons, totals);
    if (HasFailure()) return;
  }
  print(totals);
}

TEST(ConvexPoints, AllSubsetsOfTheFourByFourGridByDelaunay) {
  Totals totals;
  for (std::uint64_t mask = 0; mask < 1U << 16; ++mask) {
    SCOPED_TRACE("subset " + std::to_string(mask));
    check_both_odd_boundaries(testing::grid_subset(4, mask), ConvexMethod::kDelaunay, totals);
    if (HasFailure()) return;
  }
  print(totals);
}

void check_random_subsets(std::uint64_t columns, std::uint64_t rows, std::size_t most,
                          ConvexMethod method) {
  Random random(20261122);
  Totals totals;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("seed 20261122, set " + std::to_string(i));
    const auto points =
        testing::random_grid_points(random, 3 + random.below(most - 2), columns, rows);
    check_both_odd_boundaries(points, method, totals);
    if (::testing::Test::HasFailure()) return;
  }
  print(totals);
}

TEST(ConvexPoints, RandomSubsetsOfGrids) {
  for (const ConvexMethod method :
       {ConvexMethod::kSpiral, ConvexMethod::kPentagons, ConvexMethod::kDelaunay}) {
    check_random_subsets(6, 6, 36, method);
    check_random_subsets(20, 3, 40, method);
    check_random_subsets(2, 30, 40, method);
    check_random_subsets(40, 40, 60, method);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace quadloom
