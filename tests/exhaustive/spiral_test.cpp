// Every subset of small grids: spiral, serpentine triangulation, quads of the spiral method.
#include <gtest/gtest.h>

#include <bit>

#include "support/grid_points.hpp"
#include "support/quad_checks.hpp"
#include "support/serpentine_checks.hpp"

namespace quadloom {
namespace {

using testing::all_collinear;
using testing::expect_area_of_hull;
using testing::expect_quadrangulation;
using testing::expect_serpentine;
using testing::grid_subset;

void expect_spiral_method(const std::vector<Point>& points) {
  const SerpentineResult serpentine = serpentine_triangulation(points);
  expect_serpentine(serpentine);
  if (::testing::Test::HasFatalFailure()) return;
  expect_area_of_hull(serpentine.mesh);
  for (const OddBoundary wish :
       {OddBoundary::kOutside, OddBoundary::kOnEdge, OddBoundary::kTriangle}) {
    PointOptions options;
    options.method = PointMethod::kSpiral;
    options.odd_boundary = wish;
    const PointResult result = quadrangulate_points(points, options);
    expect_quadrangulation(result, points, wish);
    if (::testing::Test::HasFatalFailure()) return;
    const bool even = result.statistics.hull_points % 2 == 0;
    ASSERT_EQ(has_quadrangulation(points), even);
    if (even) return;  // the wish makes no difference
    if (wish == OddBoundary::kOnEdge) {
      ASSERT_EQ(result.steiner[0].kind, SteinerKind::kOnEdge);
    }
  }
}

void expect_every_subset(unsigned width, unsigned height) {
  std::size_t sets = 0;
  for (std::uint64_t mask = 0; mask < (1ULL << (width * height)); ++mask) {
    if (std::popcount(mask) < 3) continue;
    const std::vector<Point> points = grid_subset(width, mask);
    if (all_collinear(points)) continue;
    SCOPED_TRACE(::testing::Message() << width << " x " << height << ", mask " << mask);
    ++sets;
    expect_spiral_method(points);
    if (::testing::Test::HasFatalFailure()) return;
  }
  ASSERT_GT(sets, (1ULL << (width * height)) / 2);
}

TEST(SpiralMethod, EverySubsetOfThe4x4Grid) { expect_every_subset(4, 4); }
TEST(SpiralMethod, EverySubsetOfThe3x6Grid) { expect_every_subset(3, 6); }
TEST(SpiralMethod, EverySubsetOfThe5x3Grid) { expect_every_subset(5, 3); }
TEST(SpiralMethod, EverySubsetOfThe2x8Grid) { expect_every_subset(2, 8); }

}  // namespace
}  // namespace quadloom
