// The exhaustive search for strictly convex quads, against another kind of enumeration, on every subset
// of the 3 x 4 grid, and on sets whose answers are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"
#include "support/grid_points.hpp"
#include "support/tilings.hpp"

namespace quadloom {
namespace {

/// Gtest failures if the mesh is not what the answers say.
void expect_consistent(const std::vector<Point>& points, const ExactConvexResult& result) {
  ASSERT_NE(result.convex, Answer::kUnknown);
  ASSERT_TRUE(result.most_convex.has_value());
  const bool odd = result.hull_points % 2 == 1;
  CertifyOptions wanted;
  wanted.triangles_allowed = odd ? 1 : 0;
  wanted.steiner_at_most = 0;
  wanted.strictly_convex = result.convex == Answer::kYes;
  const Certificate certificate = certify_points(to_polygon_mesh(result.mesh), points, wanted);
  EXPECT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.triangles, wanted.triangles_allowed);
  EXPECT_EQ(certificate.boundary, result.hull_points);
  EXPECT_EQ(certificate.strictly_convex, *result.most_convex);
  EXPECT_EQ(result.mesh.quad_count(), result.quads);
  EXPECT_EQ(result.convex == Answer::kYes, *result.most_convex == result.quads);
  const std::size_t triangles = 2 * certificate.points - 2 - result.hull_points;  // Euler
  EXPECT_EQ(2 * result.quads + (odd ? 1 : 0), triangles);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(result.mesh.points[result.input_to_vertex[i]], points[i]);
  }
}

void expect_as_enumerated(const std::vector<Point>& points, const ExactConvexResult& result) {
  const testing::Tilings all = testing::all_tilings(points);
  EXPECT_GT(all.count, 0U);
  EXPECT_EQ(*result.most_convex, all.most_convex);
  EXPECT_EQ(result.quads, all.quads);
}

TEST(ExactPoints, AllSubsetsOfTheThreeByFourGrid) {
  std::size_t sets = 0, enumerated = 0, convex = 0;
  for (std::uint64_t mask = 0; mask < 1U << 12; ++mask) {
    const auto points = testing::grid_subset(4, mask);
    if (points.size() < 3 || testing::all_collinear(points)) continue;
    SCOPED_TRACE("subset " + std::to_string(mask));
    const ExactConvexResult result = exact_convex_quadrangulation(points);
    expect_consistent(points, result);
    if (points.size() <= 7) {
      expect_as_enumerated(points, result);
      ++enumerated;
    }
    if (HasFailure()) return;
    ++sets;
    convex += result.convex == Answer::kYes ? 1 : 0;
  }
  std::cout << sets << " sets, " << convex << " with strictly convex quads alone, " << enumerated
            << " enumerated\n";
  EXPECT_GT(convex, 0U);
  EXPECT_LT(convex, sets);
}

TEST(ExactPoints, RandomSetsAsEnumerated) {
  constexpr std::uint64_t kSeed = 20261122;
  Random random(kSeed);
  for (int i = 0; i < 1500; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    const std::uint64_t side = i % 2 == 0 ? 4 : 1000;
    const auto points = testing::random_grid_points(random, 3 + random.below(5), side, side);
    if (testing::all_collinear(points)) continue;
    const ExactConvexResult result = exact_convex_quadrangulation(points);
    expect_consistent(points, result);
    expect_as_enumerated(points, result);
    if (HasFailure()) return;
  }
}

TEST(ExactPoints, RandomSetsOfTwelve) {
  constexpr std::uint64_t kSeed = 7;
  Random random(kSeed);
  std::uint64_t most_work = 0;
  std::size_t convex = 0;
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    auto points = testing::uniform_points(random, 12);
    if (i % 4 == 1) points = testing::random_grid_points(random, 12, 5, 5);
    points.push_back(points[random.below(12)]);  // a point given twice is one vertex
    const ExactConvexResult result = exact_convex_quadrangulation(points);
    expect_consistent(points, result);
    most_work = std::max(most_work, result.work);
    convex += result.convex == Answer::kYes ? 1 : 0;
    if (HasFailure()) return;
  }
  std::cout << convex << " of 40 with strictly convex quads alone, at most " << most_work
            << " faces tried\n";
}

/// Where a mesh without Steiner points is found by other means, the search must say yes.
TEST(ExactPoints, NoMethodDoesWhatIsNotThere) {
  std::size_t found = 0, there = 0, sets = 0;
  for (std::uint64_t mask = 0; mask < 1U << 12; mask += 5) {
    const auto points = testing::grid_subset(4, mask);
    if (points.size() < 3 || testing::all_collinear(points)) continue;
    SCOPED_TRACE("subset " + std::to_string(mask));
    const Answer answer = exact_convex_quadrangulation(points).convex;
    ++sets;
    there += answer == Answer::kYes ? 1 : 0;
    bool by_method = false;
    for (const ConvexMethod method : {ConvexMethod::kDelaunay, ConvexMethod::kSpiral}) {
      ConvexOptions options;
      options.method = method;
      options.odd_boundary = OddBoundary::kTriangle;
      const ConvexResult result = convex_quadrangulation(points, options);
      by_method = by_method || (result.steiner.empty() && result.not_convex.empty());
    }
    found += by_method ? 1 : 0;
    EXPECT_TRUE(!by_method || answer == Answer::kYes);
    if (HasFailure()) return;
  }
  std::cout << sets << " sets, " << there << " with strictly convex quads alone, " << found
            << " of them found by a method\n";
  EXPECT_GT(found, 0U);
}

Answer convex_answer(const std::vector<Point>& points) {
  const ExactConvexResult result = exact_convex_quadrangulation(points);
  expect_consistent(points, result);
  return result.convex;
}

TEST(ExactPoints, SetsThatNeedSteinerPoints) {
  for (std::size_t m = 3; m <= 13; ++m) {
    EXPECT_EQ(convex_answer(generate_points("bhrs-line", m + 3)), Answer::kNo) << m;
  }
  for (std::size_t k = 3; k <= 8; ++k) {
    EXPECT_EQ(convex_answer(generate_points("bhrs-ring", 2 * k)), Answer::kNo) << k;
  }
}

TEST(ExactPoints, KnownSmallSets) {
  const std::vector<Point> triangle = {{0, 0}, {6, 0}, {0, 6}};
  EXPECT_EQ(convex_answer(triangle), Answer::kYes);
  EXPECT_EQ(convex_answer({{0, 0}, {6, 0}, {0, 6}, {1, 2}}), Answer::kNo);
  EXPECT_EQ(convex_answer({{0, 0}, {6, 0}, {0, 6}, {3, 3}}), Answer::kNo);
  EXPECT_EQ(convex_answer({{0, 0}, {6, 0}, {6, 6}, {0, 6}}), Answer::kYes);
  // Inside a quad: two quads that share two sides, one of them convex; flat on the diagonal.
  const auto most = [](Point inner) {
    return *exact_convex_quadrangulation(std::vector<Point>{{0, 0}, {6, 0}, {6, 6}, {0, 6}, inner})
                .most_convex;
  };
  EXPECT_EQ(most({1, 2}), 1U);
  EXPECT_EQ(most({1, 1}), 1U);
  EXPECT_EQ(most({3, 3}), 0U);
  EXPECT_EQ(convex_answer({{0, 0}, {4, 0}, {6, 3}, {4, 6}, {0, 6}, {-2, 3}, {2, 3}}), Answer::kYes);
  for (const unsigned width : {2U, 3U, 4U, 5U}) {
    EXPECT_EQ(convex_answer(testing::grid_subset(width, (1U << (3 * width)) - 1)), Answer::kYes);
  }
}

TEST(ExactPoints, TheSameUnderExactMaps) {
  constexpr std::uint64_t kSeed = 99;
  Random random(kSeed);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", set " + std::to_string(i));
    auto points = testing::random_grid_points(random, 4 + random.below(8), 5, 5);
    if (testing::all_collinear(points)) continue;
    const auto before = exact_convex_quadrangulation(points);
    for (Point& p : points) p = {std::ldexp(-p.y, -1060), std::ldexp(p.x + p.y, 1000)};
    std::reverse(points.begin(), points.end());
    const auto after = exact_convex_quadrangulation(points);
    expect_consistent(points, after);
    EXPECT_EQ(before.convex, after.convex);
    EXPECT_EQ(before.most_convex, after.most_convex);
    if (HasFailure()) return;
  }
}

TEST(ExactPoints, TheWorkCanRunOutInEitherSearch) {
  const auto points = generate_points("bhrs-ring", 8);
  const ExactConvexResult whole = exact_convex_quadrangulation(points);
  ASSERT_EQ(whole.convex, Answer::kNo);
  std::size_t answered = 0;
  for (std::uint64_t work = 0; work < whole.work; ++work) {
    ExactConvexOptions options;
    options.work_at_most = work;
    const ExactConvexResult result = exact_convex_quadrangulation(points, options);
    EXPECT_EQ(result.work, work);
    EXPECT_FALSE(result.most_convex.has_value());
    EXPECT_EQ(result.mesh.quad_count(), 0U);
    EXPECT_NE(result.convex, Answer::kYes);
    if (result.convex == Answer::kNo) ++answered;
    if (HasFailure()) return;
  }
  EXPECT_GT(answered, 0U);
  EXPECT_LT(answered, whole.work);
  ExactConvexOptions options;
  options.work_at_most = whole.work;
  EXPECT_EQ(exact_convex_quadrangulation(points, options).most_convex, whole.most_convex);
}

ErrorCode refused(const std::vector<Point>& points, const ExactConvexOptions& options) {
  try {
    exact_convex_quadrangulation(points, options);
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "not refused";
  return ErrorCode::kGuarantee;
}

TEST(ExactPoints, WhatIsRefused) {
  const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  ExactConvexOptions options;
  EXPECT_EQ(refused(generate_points("uniform", options.points_at_most + 1), options),
            ErrorCode::kBadOption);
  options.points_at_most = 21;
  EXPECT_EQ(refused(square, options), ErrorCode::kBadOption);
  options.points_at_most = 3;
  EXPECT_EQ(refused(square, options), ErrorCode::kBadOption);
  options = {};
  EXPECT_EQ(refused({{0, 0}, {1, 1}, {2, 2}}, options), ErrorCode::kAllCollinear);
  EXPECT_EQ(refused({{0, 0}, {1, 1}, {1, 1}}, options), ErrorCode::kTooFewPoints);
  EXPECT_EQ(refused({{0, 0}, {1, 1}, {std::nan(""), 1}}, options), ErrorCode::kNotFinite);
  options.points_at_most = 20;
  options.progress = [](std::string_view, double) { return false; };
  EXPECT_EQ(refused(square, options), ErrorCode::kCancelled);
}

}  // namespace
}  // namespace quadloom
