// Simple polygons by construction: stars, combs, spirals.
#include "generate/polygons.hpp"

#include <algorithm>
#include <array>

#include "core/random.hpp"

namespace quadloom::generate {
namespace {

/// Whether the direction to p comes before that to q, counter-clockwise from the positive x axis.
bool by_direction(Point p, Point q) {
  const auto lower = [](Point r) { return r.y < 0 || (r.y == 0 && r.x < 0); };
  if (lower(p) != lower(q)) return lower(q);
  return cross_sign({0, 0}, p, {0, 0}, q) > 0;
}

}  // namespace

// Corners in random directions, at random distances, seen from an inner point.
Polygon make_star_polygon(std::size_t n, std::uint64_t seed) {
  constexpr std::uint64_t kSide = std::uint64_t{1} << 21;
  constexpr double kMiddle = kSide / 2.0;
  Random random(seed);
  // Three corners that have the middle between them, so that no gap is half a turn.
  std::vector<Point> ring = {{kMiddle, 0}, {-kMiddle, kMiddle - 1}, {-kMiddle + 1, -kMiddle}};
  while (ring.size() < n) {
    while (ring.size() < n + n / 8 + 3) {
      const Point p{static_cast<double>(random.below(kSide)) - kMiddle,
                    static_cast<double>(random.below(kSide)) - kMiddle};
      if (p != Point{0, 0}) ring.push_back(p);
    }
    // The first of each direction stays, and of those the three and the first n - 3.
    std::vector<std::size_t> order(ring.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return by_direction(ring[i], ring[j]); });
    std::vector<std::size_t> kept;
    for (const std::size_t i : order) {
      if (kept.empty() || by_direction(ring[kept.back()], ring[i])) kept.push_back(i);
    }
    std::sort(kept.begin(), kept.end());
    if (kept.size() > n) kept.resize(n);
    std::vector<Point> chosen;
    for (const std::size_t i : kept) chosen.push_back(ring[i]);
    ring = std::move(chosen);
  }
  std::sort(ring.begin(), ring.end(), by_direction);
  return {{std::move(ring)}};
}

// Thin teeth on a low bar: each needs a guard of its own (Chvatal 1975).
//
//       /\     /\     /\.
//      /  \   /  \   /  \.
//    _/    \_/    \_/    \_
//   '----------------------'
Polygon make_comb_polygon(std::size_t n, std::uint64_t) {
  const std::size_t teeth = (n - 2) / 3;
  std::vector<Point> ring = {{0, 0}, {6.0 * static_cast<double>(teeth), 0}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double x = 6.0 * static_cast<double>(i);
    ring.push_back({x + 4, 1});
    ring.push_back({x + 3, 30});
    ring.push_back({x + 2, 1});
  }
  return {{std::move(ring)}};
}

// A corridor of width 1 that winds outwards, counter-clockwise, along a path with arms of length 2,
// 2, 4, 4, 6, 6, ...
Polygon make_spiral_polygon(std::size_t n, std::uint64_t) {
  constexpr std::array<Point, 4> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto right_of = [](Point d) { return Point{d.y, -d.x}; };
  const std::size_t arms = std::max<std::size_t>(1, n / 2 - 1);
  std::vector<Point> inner = {{0, 0}}, outer = {right_of(kStep[0])};
  for (std::size_t arm = 0; arm < arms; ++arm) {
    const Point d = kStep[arm % 4], next = kStep[(arm + 1) % 4];
    const auto length = static_cast<double>(2 + 2 * (arm / 2));
    const Point p{inner.back().x + length * d.x, inner.back().y + length * d.y};
    Point q{p.x + right_of(d).x, p.y + right_of(d).y};
    if (arm + 1 < arms) q = {q.x + right_of(next).x, q.y + right_of(next).y};
    inner.push_back(p);
    outer.push_back(q);
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return {{std::move(outer)}};
}

}  // namespace quadloom::generate
