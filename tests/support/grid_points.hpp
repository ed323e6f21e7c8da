// Small point sets with many collinear points, for exhaustive and random tests.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::testing {

/// The grid points of the set bits of `mask`, row by row, `width` a row.
inline std::vector<Point> grid_subset(unsigned width, std::uint64_t mask) {
  std::vector<Point> points;
  for (unsigned i = 0; i < 64; ++i) {
    if ((mask >> i) & 1U) {
      points.push_back({static_cast<double>(i % width), static_cast<double>(i / width)});
    }
  }
  return points;
}

/// `count` distinct points (fewer if the grid is smaller) of a grid, in random order.
inline std::vector<Point> random_grid_points(Random& random, std::size_t count, std::uint64_t width,
                                             std::uint64_t height) {
  std::set<std::pair<std::uint64_t, std::uint64_t>> seen;
  std::vector<Point> points;
  while (points.size() < count && seen.size() < width * height) {
    const auto x = random.below(width);
    const auto y = random.below(height);
    if (seen.insert({x, y}).second) {
      points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  return points;
}

inline std::vector<Point> uniform_points(Random& random, std::size_t count) {
  std::vector<Point> points(count);
  for (Point& p : points) p = {random.uniform(), random.uniform()};
  return points;
}

inline bool all_collinear(std::span<const Point> points) {
  for (const Point& p : points) {
    if (orient2d(points[0], points[1], p) != 0) return false;
  }
  return true;
}

}  // namespace quadloom::testing
