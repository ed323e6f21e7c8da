// Spiral polygons of every subset of small grids, certified and against the paper's procedure.
#include <gtest/gtest.h>

#include "support/grid_points.hpp"
#include "support/spiral_polygon_checks.hpp"

namespace quadloom {
namespace {

void expect_every_subset(unsigned width, unsigned height) {
  std::size_t sets = 0;
  for (std::uint64_t mask = 0; mask < 1ULL << (width * height); ++mask) {
    const std::vector<Point> points = testing::grid_subset(width, mask);
    if (points.size() < 3 || testing::all_collinear(points)) continue;
    SCOPED_TRACE(::testing::Message() << width << " x " << height << ", subset " << mask);
    ++sets;
    const SpiralPolygon spiral = spiral_polygon(points);
    testing::expect_spiral_polygon(points, spiral);
    testing::expect_paper_procedure(points, spiral);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(sets, 1ULL << (width * height - 1));
}

TEST(SpiralPolygon, EverySubsetOfThe4x4Grid) { expect_every_subset(4, 4); }
TEST(SpiralPolygon, EverySubsetOfThe3x5Grid) { expect_every_subset(3, 5); }
TEST(SpiralPolygon, EverySubsetOfThe7x2Grid) { expect_every_subset(7, 2); }

}  // namespace
}  // namespace quadloom
