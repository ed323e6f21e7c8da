// The place of the added point for an odd hull (Bose and Toussaint, sections 4 and 4.1).
//
// The paper puts it "just outside the convex hull near the edge". So that the boundary stays convex
// it must lie in the open region between the edge a -> b and the extensions of its neighbours; the
// region exists if and only if the boundary turns strictly at a and at b:
//
//        \   s   /             region: right of a -> b, left of before -> a and of b -> after
//         \     /
//      a --\---/-- b           (here with an apex; where the extensions diverge it is unbounded)
//     /     \ /     \          .
//  before    x     after
//
// We try, and check each candidate with the exact predicates:
//   1. above the middle of the edge, at half, a quarter, an eighth of its length, or half of what
//      the region allows there: a well-shaped quad
//   2. from the middle in the mean direction of the two extensions, which always stays in the
//   region
//      near the edge (in real numbers), shrinking by halves
//   3. above the middle, shrinking by halves
//   4. neighbours by one or two ulps of a, b and the middle
// If all fail, rounding leaves no room that we can find and the answer is "none".
#include "quadrangulate/odd_boundary.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "kernel/point_on_segment.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::quadrangulate {
namespace {

struct Region {
  Point before, a, b, after;

  bool contains(Point s) const {
    return std::isfinite(s.x) && std::isfinite(s.y) && orient2d(a, b, s) < 0 &&
           orient2d(before, a, s) > 0 && orient2d(s, b, after) > 0;
  }
};

/// origin + 2^-k direction for the least k in [first, last] for which the point twice as far is in
/// the region too; failing that, the farthest one that is.
std::optional<Point> half_way(const Region& region, Point origin, Point direction, int first,
                              int last) {
  const auto at = [&](int k) {
    const double f = std::ldexp(1.0, -k);
    return Point{origin.x + f * direction.x, origin.y + f * direction.y};
  };
  bool farther_fits = region.contains(at(first - 1));
  std::optional<Point> edge_of_region;
  for (int k = first; k <= last; ++k) {
    const bool fits = region.contains(at(k));
    if (fits && farther_fits) return at(k);
    if (fits) edge_of_region = at(k);
    if (!fits && edge_of_region) break;
    farther_fits = fits;
  }
  return edge_of_region;
}

/// Half of to - from, in a way that does not overflow.
Point half_difference(Point from, Point to) {
  return {to.x / 2 - from.x / 2, to.y / 2 - from.y / 2};
}

Point scaled_to(Point v, double length) {
  const double now = std::hypot(v.x, v.y);
  return {v.x / now * length, v.y / now * length};
}

std::optional<Point> ulp_neighbour(const Region& region, Point centre) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const auto moved = [](double v, int steps) {
    for (; steps > 0; --steps) v = std::nextafter(v, kFar);
    for (; steps < 0; ++steps) v = std::nextafter(v, -kFar);
    return v;
  };
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      const Point s{moved(centre.x, i), moved(centre.y, j)};
      if (region.contains(s)) return s;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Point> place_outside(Point before, Point a, Point b, Point after) {
  if (orient2d(before, a, b) <= 0 || orient2d(a, b, after) <= 0) return std::nullopt;
  const Region region{before, a, b, after};
  const Point middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
  const Point half_edge = half_difference(a, b);
  const Point up{2 * half_edge.y, -2 * half_edge.x};  // as long as the edge
  if (const auto s = half_way(region, middle, up, 1, 3)) return s;

  const double length = std::hypot(half_edge.x, half_edge.y);
  const Point from_before = scaled_to(half_difference(before, a), length);
  const Point from_after = scaled_to(half_difference(after, b), length);
  const Point mean{from_before.x + from_after.x, from_before.y + from_after.y};
  constexpr int kHalvings = 60;
  if (const auto s = half_way(region, middle, mean, 1, kHalvings)) return s;
  if (const auto s = half_way(region, middle, up, 4, kHalvings)) return s;
  for (const Point centre : {middle, a, b}) {
    if (const auto s = ulp_neighbour(region, centre)) return s;
  }
  return std::nullopt;
}

std::optional<OddPlace> place_of_kind(Point before, Point a, Point b, Point after,
                                      SteinerKind kind) {
  const auto place = kind == SteinerKind::kOutside ? place_outside(before, a, b, after)
                                                   : kernel::point_on_segment(a, b);
  if (!place) return std::nullopt;
  return OddPlace{*place, kind};
}

std::array<SteinerKind, 2> kinds_by_wish(OddBoundary wish) {
  if (wish == OddBoundary::kOnEdge) return {SteinerKind::kOnEdge, SteinerKind::kOutside};
  return {SteinerKind::kOutside, SteinerKind::kOnEdge};
}

std::optional<OddPlace> place_odd_point(Point before, Point a, Point b, Point after,
                                        OddBoundary wish) {
  for (const SteinerKind kind : kinds_by_wish(wish)) {
    if (const auto odd = place_of_kind(before, a, b, after, kind)) return odd;
  }
  return std::nullopt;
}

OddEdge choose_odd_edge(std::span<const Point> points, std::span<const VertexId> hull,
                        OddBoundary wish, EdgeStart start) {
  const std::size_t h = hull.size();
  const auto at = [&](std::size_t i) { return points[hull[i % h]]; };
  for (const SteinerKind kind : kinds_by_wish(wish)) {
    for (std::size_t i = 0; i < h; ++i) {
      const Point before = at(i + h - 1);
      if (start == EdgeStart::kCorner && orient2d(before, at(i), at(i + 1)) == 0) continue;
      const auto odd = place_of_kind(before, at(i), at(i + 1), at(i + 2), kind);
      if (odd) return {i, *odd};
    }
  }
  throw Error(ErrorCode::kGuarantee,
              "an odd number of points lies on the hull, and no double-precision point lies near "
              "enough to any of its edges to make it even");
}

}  // namespace quadloom::quadrangulate
