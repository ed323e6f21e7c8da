// Random simple polygons of a few corners for tests against brute force.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "generate/elementary.hpp"
#include "quadloom/generate.hpp"

namespace quadloom::test {

/// "(0, 0) (1, 0) (0, 1) ", for messages.
inline std::string text_of(const std::vector<Point>& ring) {
  std::ostringstream out;
  for (const Point p : ring) out << '(' << p.x << ", " << p.y << ") ";
  return out.str();
}

inline bool turns_left_around(const std::vector<Point>& ring) {
  const std::size_t lowest =
      static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), lex_less) - ring.begin());
  const std::size_t n = ring.size();
  return orient2d(ring[(lowest + n - 1) % n], ring[lowest], ring[(lowest + 1) % n]) > 0;
}

/// A ring of about n corners, counter-clockwise: untangled or star-shaped, with random coordinates (few
/// collinear corners) or unit cells (many).
inline std::vector<Point> random_ring(Random& random, std::size_t n) {
  const char* kinds[] = {"two-opt", "star", "rectilinear", "two-opt"};
  const char* kind = kinds[random.below(4)];
  std::vector<Point> ring =
      generate_polygon(kind, std::max<std::size_t>(n, 4), random.next()).rings[0];
  if (!turns_left_around(ring)) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// A random simple ring of n corners on the width x width grid, counter-clockwise, by trial: a random
/// order of the corners, of which two crossing sides are turned around until none cross. Empty if the
/// corners do not allow it. Flat corners are frequent.
inline std::vector<Point> random_grid_ring(Random& random, std::size_t n, int width) {
  std::vector<Point> cells;
  for (int x = 0; x < width; ++x) {
    for (int y = 0; y < width; ++y) {
      cells.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  generate::shuffle(cells, random);
  std::vector<Point> ring(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(n));
  const auto on = [](Point a, Point b, Point p) {
    return orient2d(a, b, p) == 0 && dot_sign(p, a, p, b) <= 0;
  };
  const auto meet = [&](Point a, Point b, Point c, Point d) {
    return on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b) ||
           (orient2d(a, b, c) != orient2d(a, b, d) && orient2d(c, d, a) != orient2d(c, d, b));
  };
  for (int round = 0; round < 200; ++round) {
    bool clean = true;
    for (std::size_t i = 0; i < n && clean; ++i) {
      for (std::size_t j = i + 2; j < n && clean; ++j) {
        if (i == 0 && j + 1 == n) continue;
        if (!meet(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) continue;
        std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i + 1),
                     ring.begin() + static_cast<std::ptrdiff_t>(j + 1));
        clean = false;
      }
    }
    if (!clean) continue;
    for (std::size_t i = 0; i < n; ++i) {  // no two sides on each other
      const Point a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
      if (orient2d(a, b, c) == 0 && dot_sign(b, a, b, c) > 0) return {};
    }
    if (!turns_left_around(ring)) std::reverse(ring.begin(), ring.end());
    return ring;
  }
  return {};
}

}  // namespace quadloom::test
