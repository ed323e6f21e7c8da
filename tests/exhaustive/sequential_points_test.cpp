// Sequential triangulations of point sets against all triangulations, each tested from every start.
#include <gtest/gtest.h>

#include <iostream>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"
#include "support/grid_points.hpp"
#include "support/order_checks.hpp"
#include "support/point_triangulations.hpp"

namespace quadloom {
namespace {

bool exists_by_enumeration(const std::vector<Point>& points) {
  bool found = false;
  test::for_all_point_triangulations(points, [&](const Triangulation& mesh) {
    found = found || test::brute_sequential(mesh).has_value();
  });
  return found;
}

/// Gtest failures if the witness is none.
SequentialResult checked(const std::vector<Point>& points) {
  SequentialResult result = sequential_triangulation(points);
  EXPECT_NE(result.answer, Answer::kUnknown);
  if (result.answer != Answer::kYes) return result;
  CertifyOptions promise;
  promise.corners = 3;
  promise.steiner_at_most = 0;
  const PolygonMesh mesh = to_polygon_mesh(result.mesh);
  const Certificate tiling = certify_points(mesh, points, promise);
  EXPECT_TRUE(tiling.ok()) << tiling.sentence;
  const Certificate order = certify_order(mesh, OrderKind::kSequential);
  EXPECT_TRUE(order.ok()) << order.sentence;
  EXPECT_EQ(result.sequence.size(), result.mesh.triangle_count() + 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(result.mesh.points[result.input_to_vertex[i]], points[i]);
  }
  return result;
}

std::size_t inner_count(const std::vector<Point>& points) {
  return points.size() - convex_hull(points).size();
}

TEST(SequentialPoints, AllSubsetsOfTheFourByFourGrid) {
  std::size_t sets = 0, small = 0, small_no = 0, no = 0;
  for (std::uint64_t mask = 0; mask < 1U << 16; ++mask) {
    const auto points = testing::grid_subset(4, mask);
    if (points.size() < 3 || testing::all_collinear(points)) continue;
    SCOPED_TRACE("subset " + std::to_string(mask));
    const SequentialResult result = checked(points);
    const std::size_t none = result.answer == Answer::kNo ? 1 : 0;
    if (points.size() <= 7) {
      EXPECT_EQ(none == 0, exists_by_enumeration(points));
      ++small;
      small_no += none;
    }
    if (HasFailure()) return;
    ++sets;
    no += none;
  }
  std::cout << sets << " sets, " << no << " without a sequential triangulation; " << small
            << " of at most 7 points, " << small_no << " without\n";
  EXPECT_GT(small_no, 0U);
  EXPECT_LT(no, sets / 2);
}

// The two ways against each other: the cases for at most two inner points, and the search.
TEST(SequentialPoints, FewInnerPointsAsByEnumeration) {
  constexpr std::uint64_t kSeed = 20261130;
  Random random(kSeed);
  std::size_t sets = 0, no = 0;
  for (int i = 0; i < 30000 && sets < 1500; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    const std::uint64_t width = 3 + random.below(4), height = 3 + random.below(3);
    const auto points = testing::random_grid_points(random, 7 + random.below(4), width, height);
    if (points.size() < 3 || testing::all_collinear(points) || inner_count(points) > 2) continue;
    const SequentialResult result = checked(points);
    EXPECT_EQ(result.answer, exists_by_enumeration(points) ? Answer::kYes : Answer::kNo);
    if (HasFailure()) return;
    ++sets;
    no += result.answer == Answer::kNo ? 1 : 0;
  }
  std::cout << sets << " sets, " << no << " without a sequential triangulation\n";
  EXPECT_GT(sets, 1000U);
  EXPECT_GT(no, 100U);
}

// Lemma 4.2: in general position there is always one.
TEST(SequentialPoints, AtMostTwoInnerPointsInGeneralPosition) {
  constexpr std::uint64_t kSeed = 20261201;
  Random random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    std::vector<Point> points = generate_points("convex", 3 + random.below(12), i + 1);
    const std::size_t corners = points.size();
    for (std::uint64_t inner = i % 3; inner > 0; --inner) {  // means of the corners, at random
      Point sum;
      double weights = 0;
      for (std::size_t c = 0; c < corners; ++c) {
        const double weight = random.uniform() * random.uniform() + 1e-3;
        sum = {sum.x + weight * points[c].x, sum.y + weight * points[c].y};
        weights += weight;
      }
      points.push_back({sum.x / weights, sum.y / weights});
    }
    const SequentialResult result = checked(points);
    EXPECT_EQ(result.inner_points, static_cast<std::size_t>(i % 3));
    EXPECT_EQ(result.answer, Answer::kYes);
    if (HasFailure()) return;
  }
}

TEST(SequentialPoints, ManyHullPoints) {
  for (const std::size_t inner : {0U, 1U, 2U}) {
    std::vector<Point> points = generate_points("convex", 30000, 1);
    const Point a = points[0], b = points[10000], c = points[20000];
    if (inner > 0) points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
    if (inner > 1) points.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
    const SequentialResult result = checked(points);
    EXPECT_EQ(result.answer, Answer::kYes);
    EXPECT_EQ(result.inner_points, inner);
  }
}

TEST(SequentialPoints, MoreInnerPointsAsByEnumeration) {
  constexpr std::uint64_t kSeed = 20261202;
  Random random(kSeed);
  std::size_t sets = 0, no = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    const std::size_t n = 6 + random.below(4);
    const auto points = i % 3 == 0 ? testing::uniform_points(random, n)
                                   : testing::random_grid_points(random, n, 5, i % 3 == 1 ? 4 : 5);
    if (testing::all_collinear(points) || inner_count(points) < 3) continue;
    const SequentialResult result = checked(points);
    EXPECT_EQ(result.answer, exists_by_enumeration(points) ? Answer::kYes : Answer::kNo);
    if (HasFailure()) return;
    ++sets;
    no += result.answer == Answer::kNo ? 1 : 0;
  }
  std::cout << sets << " sets, " << no << " without a sequential triangulation\n";
  EXPECT_GT(sets, 300U);
  EXPECT_GT(no, 0U);
}

// Theorem 4.1 by exhaustion: by the search, and by every triangulation from every start.
TEST(SequentialPoints, TheNinePointSetAndItsLikesHaveNone) {
  for (std::size_t n = 9; n <= 14; ++n) {
    const auto points = generate_points("ahms-nine", n);
    EXPECT_EQ(checked(points).answer, Answer::kNo) << n;
    if (n > 11) continue;
    std::size_t triangulations = 0, with_the_triangle = 0, sequential = 0;
    test::for_all_point_triangulations(points, [&](const Triangulation& mesh) {
      ++triangulations;
      sequential += test::brute_sequential(mesh) ? 1 : 0;
      bool found = false;
      for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
        found = found ||
                mesh.tri_vertex[3 * t] + mesh.tri_vertex[3 * t + 1] + mesh.tri_vertex[3 * t + 2] ==
                    0 + 1 + 2;
      }
      with_the_triangle += found ? 1 : 0;
    });
    std::cout << n << " points: " << triangulations << " triangulations, " << sequential
              << " sequential\n";
    EXPECT_GT(triangulations, 50U);
    EXPECT_EQ(with_the_triangle, triangulations);  // A B C, as the proof says
    EXPECT_EQ(sequential, 0U);
  }
}

TEST(SequentialPoints, RandomNinePointSetsMostlyHaveOne) {
  constexpr std::uint64_t kSeed = 20261203;
  Random random(kSeed);
  std::size_t yes = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    yes += checked(testing::uniform_points(random, 9)).answer == Answer::kYes ? 1 : 0;
    if (HasFailure()) return;
  }
  std::cout << yes << " of 2000\n";
  EXPECT_GT(yes, 1900U);
}

TEST(SequentialPoints, UnknownIsSaid) {
  SequentialOptions options;
  options.work_at_most = 10;
  const auto points = generate_points("ahms-nine", 9);
  const SequentialResult little = sequential_triangulation(points, options);
  EXPECT_EQ(little.answer, Answer::kUnknown);
  EXPECT_LE(little.work, 10U);
  EXPECT_EQ(little.mesh.triangle_count(), 0U);
  const auto many = generate_points("uniform", 100);
  EXPECT_EQ(sequential_triangulation(many).answer, Answer::kUnknown);
  EXPECT_THROW(sequential_triangulation(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}}), Error);
}

}  // namespace
}  // namespace quadloom
