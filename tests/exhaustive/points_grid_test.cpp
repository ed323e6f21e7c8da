// Every subset of the 4 x 4 grid, and random subsets of bigger grids, through every method and both
// kinds of added point: all certified, none fell back.
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "support/certified.hpp"
#include "support/grid_points.hpp"

namespace quadloom {
namespace {

void check_all_odd_boundaries(const std::vector<Point>& points, PointMethod method) {
  if (points.size() < 3 || testing::all_collinear(points)) return;
  for (const OddBoundary odd : kAllOddBoundaries) {
    quadrangulate_checked(points, {.method = method, .odd_boundary = odd});
    if (has_quadrangulation(points)) return;  // even: the option plays no part
  }
}

class EveryMethod : public ::testing::TestWithParam<PointMethod> {};

TEST_P(EveryMethod, AllSubsetsOfTheFourByFourGrid) {
  for (std::uint64_t mask = 0; mask < 1U << 16; ++mask) {
    SCOPED_TRACE("subset " + std::to_string(mask));
    check_all_odd_boundaries(testing::grid_subset(4, mask), GetParam());
    if (HasFailure()) return;
  }
}

void check_random_subsets(unsigned columns, unsigned rows, PointMethod method) {
  constexpr int kSubsets = 10'000;
  Random random(20261122);
  for (int i = 0; i < kSubsets; ++i) {
    const unsigned cells = columns * rows;
    const std::uint64_t density =
        random.below(3);  // about an eighth, a half or seven eighths of the cells
    std::uint64_t mask = random.next();
    if (density == 0) mask &= random.next() & random.next();
    if (density == 2) mask |= random.next() | random.next();
    mask &= (std::uint64_t{1} << cells) - 1;
    SCOPED_TRACE("seed 20261122, subset number " + std::to_string(i) + ": " + std::to_string(mask));
    check_all_odd_boundaries(testing::grid_subset(columns, mask), method);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST_P(EveryMethod, RandomSubsetsOfTheSixBySixGrid) { check_random_subsets(6, 6, GetParam()); }
TEST_P(EveryMethod, RandomSubsetsOfThreeLongRows) { check_random_subsets(20, 3, GetParam()); }

std::string method_name(const ::testing::TestParamInfo<PointMethod>& info) {
  return std::array{"Delaunay", "Spiral", "Insertion",
                    "Subdivide"}[static_cast<std::size_t>(info.param)];
}
INSTANTIATE_TEST_SUITE_P(Points, EveryMethod, ::testing::ValuesIn(kAllMethods), method_name);

}  // namespace
}  // namespace quadloom
