// Hamiltonian cycle triangulations: every generator, collinear sets, exact maps, the splitters' bounds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/random.hpp"
#include "quadloom/generate.hpp"
#include "strips/hamiltonian_search.hpp"
#include "strips/middle_third.hpp"
#include "support/bad_points.hpp"
#include "support/grid_points.hpp"
#include "support/hamiltonian_checks.hpp"

namespace quadloom {
namespace {

using testing::hamiltonian_checked;

constexpr Splitter kSplitters[] = {Splitter::kRandom, Splitter::kBalanced};

TEST(Hamiltonian, EveryGenerator) {
  for (const Generator& generator : generators()) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      const std::size_t n = generator.min_points + Random(seed).below(seed % 10 == 0 ? 2000 : 80);
      SCOPED_TRACE(::testing::Message() << generator.name << ", n = " << n << ", seed " << seed);
      const std::vector<Point> points = generator.make(n, seed);
      for (const Splitter splitter : kSplitters) {
        hamiltonian_checked(points, {.splitter = splitter, .seed = seed});
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(Hamiltonian, RandomSubsetsOfSmallGrids) {
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const auto points = testing::random_grid_points(random, 3 + random.below(60),
                                                    2 + random.below(9), 2 + random.below(9));
    if (points.size() < 3 || testing::all_collinear(points)) continue;
    hamiltonian_checked(points, {.splitter = kSplitters[seed % 2], .seed = seed});
    if (HasFatalFailure()) return;
  }
}

TEST(Hamiltonian, GeneralPositionAlwaysHasACycle) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const auto points = testing::uniform_points(random, 4 + random.below(300));
    const HamiltonianResult result = hamiltonian_checked(points, {.seed = seed});
    if (HasFatalFailure()) return;
    if (result.statistics.hull_points == points.size()) continue;
    ASSERT_EQ(result.order, OrderKind::kCycle);
    ASSERT_EQ(result.statistics.centres, 1U);
    ASSERT_EQ(result.statistics.chains, 0U);
  }
}

TEST(Hamiltonian, GridsAndFewLinesHaveACycle) {
  for (const char* kind : {"grid", "rotated-grid", "hex-grid", "raster", "lines", "cross",
                           "near-line", "circles", "bhrs-line"}) {
    for (const std::size_t n : {100U, 2000U, 20'000U}) {
      SCOPED_TRACE(::testing::Message() << kind << ", n = " << n);
      const std::vector<Point> points = generate_points(kind, n, 5);
      for (const Splitter splitter : kSplitters) {
        ASSERT_EQ(hamiltonian_checked(points, {.splitter = splitter}).order, OrderKind::kCycle);
      }
    }
  }
}

TEST(Hamiltonian, BalancedSplittersKeepTheNestingLow) {
  for (const char* kind :
       {"uniform", "gaussian", "clusters", "decades", "two-clusters", "spiral"}) {
    for (const std::size_t n : {50U, 1000U, 20'000U}) {
      SCOPED_TRACE(::testing::Message() << kind << ", n = " << n);
      const HamiltonianResult result =
          hamiltonian_checked(generate_points(kind, n, 11), {.splitter = Splitter::kBalanced});
      ASSERT_EQ(result.statistics.chains, 0U);
      const double bound = std::log(static_cast<double>(n)) / std::log(1.5) + 1;
      EXPECT_LE(static_cast<double>(result.statistics.levels), bound);
      EXPECT_LE(static_cast<double>(result.statistics.locations), static_cast<double>(n) * bound);
    }
  }
}

TEST(Hamiltonian, TheWorkGrowsSlowly) {
  for (const char* kind : {"uniform", "grid", "lines", "cross", "hex-grid", "near-line"}) {
    for (const Splitter splitter : kSplitters) {
      SCOPED_TRACE(kind);
      const std::size_t n = 50'000;
      const HamiltonianResult result =
          hamiltonian_cycle_triangulation(generate_points(kind, n, 3), {.splitter = splitter});
      EXPECT_LE(result.statistics.locations, 40 * n);  // the base-2 logarithm is 16
    }
  }
}

TEST(Hamiltonian, APinwheelHasAPathAndWithAPointInTheMiddleACycle) {
  std::vector<Point> points = {{4, 0}, {12, 4}, {0, 12}, {4, 4}, {8, 4}, {4, 8}};
  ASSERT_EQ(orient2d(points[0], points[3], points[5]), 0);
  ASSERT_EQ(orient2d(points[1], points[4], points[3]), 0);
  ASSERT_EQ(orient2d(points[2], points[5], points[4]), 0);
  EXPECT_EQ(hamiltonian_checked(points, {}).cycle, Answer::kNo);
  points.push_back({5, 6});
  EXPECT_EQ(hamiltonian_checked(points, {}).order, OrderKind::kCycle);
}

TEST(Hamiltonian, WhatTheStartMissesIsFoundBySearch) {
  const std::vector<Point> points = {{3, 3}, {0, 0}, {2, 2}, {1, 1},
                                     {4, 1}, {3, 1}, {0, 4}, {3, 4}};
  const HamiltonianResult searched = hamiltonian_checked(points, {});
  EXPECT_EQ(searched.cycle, Answer::kYes);
  EXPECT_EQ(searched.statistics.centres, 0U);
  EXPECT_EQ(hamiltonian_checked(points, {.work_at_most = 3}).cycle, Answer::kUnknown);
}

TEST(Hamiltonian, TheSearchAgreesWithAllTriangulations) {
  std::size_t yes = 0, no = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const auto points = testing::random_grid_points(random, 4 + random.below(5), 4, 4);
    if (testing::all_collinear(points)) continue;
    const strips::CycleSearch search = strips::search_cycle(points, 10'000'000);
    const bool expected = testing::has_hamiltonian_cycle_triangulation(points);
    ASSERT_EQ(search.answer, expected ? Answer::kYes : Answer::kNo);
    ++(expected ? yes : no);
  }
  EXPECT_GT(yes, 100U);
  EXPECT_GT(no, 100U);
}

TEST(Hamiltonian, ExactMapsChangeNothing) {
  Point (*const maps[])(Point) = {
      [](Point p) {
        return Point{-p.y, p.x};
      },
      [](Point p) {
        return Point{std::ldexp(p.x, -900), std::ldexp(p.y, -900)};
      },
      [](Point p) {
        return Point{std::ldexp(p.x, 900), std::ldexp(p.y, 900)};
      },
      [](Point p) {
        return Point{-std::ldexp(p.x, -1000), std::ldexp(p.y, 600)};
      },
  };
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    for (const char* kind : {"uniform", "grid", "lines", "cross"}) {
      SCOPED_TRACE(::testing::Message() << kind << ", seed " << seed);
      const std::vector<Point> points = generate_points(kind, 12 + seed, seed);
      const HamiltonianOptions options = {.splitter = kSplitters[seed % 2], .seed = seed};
      const OrderKind order = hamiltonian_checked(points, options).order;
      for (const auto map : maps) {
        std::vector<Point> mapped = points;
        std::transform(points.begin(), points.end(), mapped.begin(), map);
        ASSERT_EQ(hamiltonian_checked(mapped, options).order, order);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(Hamiltonian, SameInputGivesTheSameTriangles) {
  const std::vector<Point> points = generate_points("towns-like", 2000, 3);
  for (const Splitter splitter : kSplitters) {
    const HamiltonianOptions options = {.splitter = splitter, .seed = 7};
    const HamiltonianResult first = hamiltonian_cycle_triangulation(points, options);
    const HamiltonianResult second = hamiltonian_cycle_triangulation(points, options);
    EXPECT_EQ(first.mesh.tri_vertex, second.mesh.tri_vertex);
    EXPECT_EQ(first.mesh.twin, second.mesh.twin);
  }
}

TEST(Hamiltonian, BadInputIsRefusedAndDuplicatesAreMerged) {
  testing::expect_bad_points_refused(
      [](const std::vector<Point>& points) { hamiltonian_cycle_triangulation(points); });
  const std::vector<Point> repeated = {{0, 0}, {3, 0}, {1, 1}, {0, 0}, {0, 3}, {1, 1}};
  const HamiltonianResult result = hamiltonian_checked(repeated, {});
  EXPECT_EQ(result.input_to_vertex, (std::vector<VertexId>{0, 1, 2, 0, 3, 2}));
  EXPECT_EQ(result.mesh.triangle_count(), 3U);
}

TEST(Hamiltonian, ProgressCanStopTheWork) {
  const std::vector<Point> points = generate_points("uniform", 20'000, 1);
  std::size_t stages = 0;
  HamiltonianOptions options;
  options.progress = [&](std::string_view stage, double) {
    ++stages;
    return stage != "cycle";
  };
  EXPECT_THROW(hamiltonian_cycle_triangulation(points, options), Error);
  EXPECT_GE(stages, 2U);
}

/// McIlroy's adversary (A killer adversary for quicksort, 1999): decides the order of the items while
/// they are compared, so that each pivot is a bad one.
class Adversary {
 public:
  explicit Adversary(std::size_t count) : value_(count, count) {}
  bool less(std::size_t a, std::size_t b) {
    ++comparisons_;
    if (value_[a] == value_.size() && value_[b] == value_.size()) {
      value_[a == candidate_ ? a : b] = solid_++;
    }
    if (value_[a] == value_.size()) {
      candidate_ = a;
    } else if (value_[b] == value_.size()) {
      candidate_ = b;
    }
    return value_[a] < value_[b];
  }
  std::size_t comparisons() const { return comparisons_; }

 private:
  std::vector<std::size_t> value_;  // count: not decided yet, greater than all that are
  std::size_t candidate_ = 0, solid_ = 0, comparisons_ = 0;
};

TEST(MiddleThird, IsLinearAgainstAnAdversary) {
  for (const std::size_t n : {1000U, 10'000U, 100'000U}) {
    std::vector<std::size_t> items(n);
    for (std::size_t i = 0; i < n; ++i) items[i] = i;
    Adversary adversary(n);
    strips::middle_third(std::span(items),
                         [&](std::size_t a, std::size_t b) { return adversary.less(a, b); });
    EXPECT_LE(adversary.comparisons(), 60 * n);
  }
}

TEST(MiddleThird, HasTheRanksOfSorting) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed);
    const std::uint64_t range = 1 + random.below(seed % 2 == 0 ? 5 : 1000);
    std::vector<std::uint64_t> items(1 + random.below(200));
    for (auto& item : items) item = random.below(range);
    std::vector<std::uint64_t> sorted = items;
    std::sort(sorted.begin(), sorted.end());
    const auto middle = strips::middle_third(std::span(items), std::less<>());
    std::vector<std::uint64_t> found(middle.begin(), middle.end());
    std::sort(found.begin(), found.end());
    const std::size_t low = items.size() / 3, high = (2 * items.size() + 2) / 3;
    ASSERT_EQ(found,
              std::vector<std::uint64_t>(sorted.begin() + static_cast<std::ptrdiff_t>(low),
                                         sorted.begin() + static_cast<std::ptrdiff_t>(high)));
  }
}

}  // namespace
}  // namespace quadloom
