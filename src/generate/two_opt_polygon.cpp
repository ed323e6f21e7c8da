// A random simple polygon with given corners: a random tour, untangled by 2-opt moves. Each move
// replaces two edges that meet by two that are shorter in all, so no tour comes back. O(n^2) for
// each round, a few dozen rounds: for n up to some thousands.
#include <algorithm>

#include "core/random.hpp"
#include "generate/elementary.hpp"
#include "generate/polygons.hpp"

namespace quadloom::generate {
namespace {

constexpr std::uint64_t kSide = std::uint64_t{1} << 30;
constexpr int kMostRounds = 1000;

/// Whether the closed segments share a point.
bool meet(Point a, Point b, Point c, Point d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
    return false;
  }
  return orient2d(a, b, c) * orient2d(a, b, d) <= 0 && orient2d(c, d, a) * orient2d(c, d, b) <= 0;
}

/// No three neighbours are in line (a spike is not seen by `untangle`).
bool has_flat_corner(const std::vector<Point>& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (orient2d(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) == 0) return true;
  }
  return false;
}

//    a       d       a---c   d         edges a-b and c-d that meet become a-c and b-d: the part
//     \.   ./           /   /          from b to c is turned around
//       `X'     ->
//     ./  `.
//    c       b       b---...
bool untangle(std::vector<Point>& ring) {
  const std::size_t n = ring.size();
  for (int round = 0; round < kMostRounds; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i + 2 < n; ++i) {
      for (std::size_t j = i + 2; j < n && !(i == 0 && j == n - 1); ++j) {
        if (!meet(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) continue;
        std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        moved = true;
      }
    }
    if (!moved) return true;
  }
  return false;
}

}  // namespace

Polygon make_two_opt_polygon(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  for (;;) {
    std::vector<Point> ring(n);
    for (Point& p : ring) {
      p = {static_cast<double>(random.below(kSide)), static_cast<double>(random.below(kSide))};
    }
    if (untangle(ring) && !has_flat_corner(ring)) return {{std::move(ring)}};
  }
}

}  // namespace quadloom::generate
