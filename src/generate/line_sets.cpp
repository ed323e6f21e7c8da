// Points on lines, exactly or nearly.
#include <array>
#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "generate/sets.hpp"

namespace quadloom::generate {
namespace {

double ulps_away(double v, int ulps) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (int i = std::abs(ulps); i > 0; --i) v = std::nextafter(v, ulps < 0 ? -infinity : infinity);
  return v;
}

}  // namespace

// Five lines with whole coordinates, so that the points of a line are exactly collinear, in turns,
// 1 to 3 steps apart. The higher a line begins, the steeper it is: no two points coincide.
Points make_lines(std::size_t n, std::uint64_t seed) {
  struct Line {
    Point from, step;
  };
  constexpr std::array<Line, 5> kLines = {
      {{{1, 0}, {4, 1}}, {{0, 2}, {3, 2}}, {{0, 4}, {1, 1}}, {{0, 6}, {2, 3}}, {{0, 8}, {1, 4}}}};
  Random random(seed);
  std::array<double, 5> at = {};
  Points points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [from, step] = kLines[i % 5];
    points[i] = {from.x + at[i % 5] * step.x, from.y + at[i % 5] * step.y};
    at[i % 5] += static_cast<double>(1 + random.below(3));
  }
  return points;
}

// The origin and the two axes.
Points make_cross(std::size_t n, std::uint64_t) {
  constexpr std::array<Point, 4> kArms = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  Points points = {{0, 0}};
  points.reserve(n);
  for (std::size_t i = 0; points.size() < n; ++i) {
    const auto d = static_cast<double>(i / 4 + 1);
    points.push_back({d * kArms[i % 4].x, d * kArms[i % 4].y});
  }
  return points;
}

// y = x / 3, rounded, and then up to two units in the last place above or below.
Points make_near_line(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Points points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 1 + random.uniform();
    const int ulps = static_cast<int>(random.below(5)) - 2;
    points[i] = {x, ulps_away(x / 3, i == 0 ? 2 : i == 1 ? -2 : ulps)};
  }
  return points;
}

// All on the x axis but the last.
Points make_collinear_but_one(std::size_t n, std::uint64_t) {
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i + 1 < n; ++i) points.push_back({static_cast<double>(i), 0});
  points.push_back({static_cast<double>(n) / 3, static_cast<double>(n) / 2});
  return points;
}

}  // namespace quadloom::generate
