// Meshes of k-gons of every subset of a small grid, within the bound of corollary 4.1.
#include <gtest/gtest.h>

#include <bit>

#include "support/grid_points.hpp"
#include "support/k_gon_checks.hpp"

namespace quadloom {
namespace {

using namespace testing;

TEST(KAngulation, EverySubsetOfThe4x4Grid) {
  for (std::uint64_t mask = 0; mask < (1U << 16); ++mask) {
    if (std::popcount(mask) < 3) continue;
    const std::vector<Point> points = grid_subset(4, mask);
    if (all_collinear(points)) continue;
    for (std::size_t k = 4; k <= 9; ++k) {
      SCOPED_TRACE(::testing::Message() << "mask " << mask << ", k " << k);
      const KAngulationResult result = k_angulate_points(points, k);
      expect_k_angulation(result, points, k);
      ASSERT_LE(result.steiner.size(), k - 3);
      if (HasFatalFailure()) return;
    }
    const KAngulationResult large = k_angulate_points(points, 2 * points.size());
    expect_k_angulation(large, points, 2 * points.size());
    ASSERT_LE(large.steiner.size(), 2 * points.size() - 3) << "mask " << mask;
    if (HasFatalFailure()) return;
  }
}

TEST(KAngulation, OnEdgesOfEverySubsetOfThe4x3Grid) {
  PointOptions options;
  options.odd_boundary = OddBoundary::kOnEdge;
  for (std::uint64_t mask = 0; mask < (1U << 12); ++mask) {
    if (std::popcount(mask) < 3) continue;
    const std::vector<Point> points = grid_subset(4, mask);
    if (all_collinear(points)) continue;
    for (std::size_t k = 4; k <= 12; ++k) {
      SCOPED_TRACE(::testing::Message() << "mask " << mask << ", k " << k);
      const KAngulationResult result = k_angulate_points(points, k, options);
      expect_k_angulation(result, points, k);
      ASSERT_LE(result.steiner.size(), k - 3);
      for (const SteinerPoint& s : result.steiner) ASSERT_NE(s.kind, SteinerKind::kOutside);
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace quadloom
