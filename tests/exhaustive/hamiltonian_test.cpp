// Hamiltonian triangulations of every subset of the 4 x 4 grid; a path only where no triangulation has
// a cycle (all of them are looked at, for up to seven points).
#include <gtest/gtest.h>

#include <bit>

#include "support/grid_points.hpp"
#include "support/hamiltonian_checks.hpp"

namespace quadloom {
namespace {

using testing::all_collinear;
using testing::grid_subset;
using testing::has_hamiltonian_cycle_triangulation;

constexpr int kSearched = 7;  // points

TEST(Hamiltonian, EverySubsetOfThe4x4Grid) {
  std::size_t cycles = 0, paths = 0;
  for (std::uint64_t mask = 0; mask < 1U << 16; ++mask) {
    const std::vector<Point> points = grid_subset(4, mask);
    if (points.size() < 3 || all_collinear(points)) continue;
    SCOPED_TRACE(::testing::Message() << "subset " << mask);
    for (const Splitter splitter : {Splitter::kRandom, Splitter::kBalanced}) {
      const HamiltonianResult result =
          testing::hamiltonian_checked(points, {.splitter = splitter, .seed = mask});
      if (HasFatalFailure()) return;
      if (result.statistics.hull_points == points.size()) continue;
      const bool cycle = result.order == OrderKind::kCycle;
      ++(cycle ? cycles : paths);
      ASSERT_NE(result.cycle, Answer::kUnknown);
      if (cycle || points.size() > kSearched) continue;
      ASSERT_FALSE(has_hamiltonian_cycle_triangulation(points));
    }
  }
  EXPECT_EQ(paths, 2 * 72U);  // 44 of them of up to seven points
  EXPECT_EQ(cycles, 2 * 54'991U);
}

TEST(Hamiltonian, TheSearchOfAllTriangulationsFindsCycles) {
  for (std::uint64_t mask = 0; mask < 1U << 16; mask += 5) {
    const std::vector<Point> points = grid_subset(4, mask);
    if (points.size() < 3 || points.size() > kSearched - 1 || all_collinear(points)) continue;
    SCOPED_TRACE(::testing::Message() << "subset " << mask);
    ASSERT_EQ(has_hamiltonian_cycle_triangulation(points),
              hamiltonian_cycle_triangulation(points).order == OrderKind::kCycle);
  }
}

}  // namespace
}  // namespace quadloom
