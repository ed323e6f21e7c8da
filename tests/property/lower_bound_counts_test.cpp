// The default on the sets that need many added points: few more than are needed, whatever the order of the
// points, turned or stretched; and sets that are nearly such sets.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "core/random.hpp"
#include "support/convex_checks.hpp"

namespace quadloom {
namespace {

std::vector<Point> shuffled(std::vector<Point> points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  return points;
}

std::size_t added_points(const std::vector<Point>& points) {
  ConvexOptions options;
  options.odd_boundary = OddBoundary::kTriangle;
  const ConvexResult result = convex_quadrangulation(points, options);
  testing::expect_convex_quads(points, options, result);
  return result.steiner.size();
}

// Theorem 2.1 needs ceil(m / 2) - 1.
TEST(LowerBoundCounts, Lines) {
  for (std::size_t m = 4; m <= 200; ++m) {
    SCOPED_TRACE("m " + std::to_string(m));
    EXPECT_LE(added_points(generate_points("bhrs-line", m + 3)), (m + 1) / 2 + 3);
    if (HasFailure()) return;
  }
}

// Theorem 2.3 needs n / 4.
TEST(LowerBoundCounts, Rings) {
  for (std::size_t n = 6; n <= 200; n += 2) {
    SCOPED_TRACE("n " + std::to_string(n));
    EXPECT_LE(added_points(generate_points("bhrs-ring", n)), n / 4 + 2);
    if (HasFailure()) return;
  }
}

TEST(LowerBoundCounts, WhateverTheOrderAndThePlace) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::size_t m = 50 + seed;
    auto line = shuffled(generate_points("bhrs-line", m + 3), seed);
    for (Point& p : line) p = seed % 2 == 0 ? Point{-p.y, p.x} : Point{p.x - p.y, p.x + p.y};
    EXPECT_LE(added_points(line), (m + 1) / 2 + 3);
    auto ring = shuffled(generate_points("bhrs-ring", 2 * m), seed);
    for (Point& p : ring) p = {-p.y, std::ldexp(p.x, 4)};
    EXPECT_LE(added_points(ring), m / 2 + 2);
    if (HasFailure()) return;
  }
}

/// One point more or less than the theorems' sets: mended as any other set, within theorem 3.1's bound.
TEST(LowerBoundCounts, NearlySuchSets) {
  for (const auto& [kind, n] :
       {std::pair("bhrs-line", std::size_t{63}), std::pair("bhrs-ring", std::size_t{64})}) {
    const auto points = generate_points(kind, n);
    for (const std::size_t left_out : {std::size_t{5}, n - 1}) {
      SCOPED_TRACE(kind + std::to_string(left_out));
      auto fewer = points;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left_out));
      EXPECT_GT(added_points(fewer), 0U);
    }
    auto more = points;
    more.push_back({points[0].x / 2 + points[1].x / 4 + points[n - 1].x / 4,
                    points[0].y / 2 + points[1].y / 4 + points[n - 1].y / 4});
    EXPECT_GT(added_points(more), 0U);
  }
}

}  // namespace
}  // namespace quadloom
