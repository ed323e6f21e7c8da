// Points on circles and on a spiral, rounded to doubles.
#include <algorithm>
#include <cmath>

#include "generate/elementary.hpp"
#include "generate/sets.hpp"

namespace quadloom::generate {
namespace {

Point on_ring(std::size_t i, std::size_t of, double radius) {
  const Point d = on_unit_circle(static_cast<double>(i) / static_cast<double>(of));
  return {radius * d.x, radius * d.y};
}

}  // namespace

// Evenly spaced on the unit circle, in random order.
Points make_circle(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.push_back(on_ring(i, n, 1));
  shuffle(points, random);
  return points;
}

// Circles around the origin with the same number of points on each, aligned on rays.
Points make_circles(std::size_t n, std::uint64_t) {
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  const std::size_t rays = std::max<std::size_t>(3, 2 * root);
  const std::size_t rings = std::max<std::size_t>(1, (n + rays / 2) / rays);
  Points points;
  points.reserve(rays * rings);
  for (std::size_t r = 1; r <= rings; ++r) {
    for (std::size_t i = 0; i < rays; ++i) {
      points.push_back(on_ring(i, rays, static_cast<double>(r)));
    }
  }
  return points;
}

// An Archimedean spiral, evenly filled.
Points make_spiral(std::size_t n, std::uint64_t) {
  const double turns = std::max(1.0, std::sqrt(static_cast<double>(n)) / 3);
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = std::sqrt(static_cast<double>(i) / static_cast<double>(n));
    const Point d = on_unit_circle(turns * t);
    points.push_back({t * d.x, t * d.y});
  }
  return points;
}

}  // namespace quadloom::generate
