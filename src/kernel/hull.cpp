// The convex hull by the monotone chain (Andrew 1979), keeping every point of the boundary.
//
//   1. sort_points   lexicographically: the order of x after a symbolic shear, so that no two
//   points
//                    share an abscissa and vertical runs need no case of their own
//   2. lower_chain   left to right, popping only strict right turns: collinear points stay
//   3. the upper chain is the same walk from right to left
//
// Degenerate input: if all points lie on one line, both chains are the whole line and one of them
// is the answer. Cost: O(n log n) for the sort, O(n) orientation tests after it.
#include <algorithm>
#include <numeric>

#include "quadloom/kernel.hpp"

namespace quadloom {
namespace {

std::vector<VertexId> sort_points(std::span<const Point> points) {
  std::vector<VertexId> order(points.size());
  std::iota(order.begin(), order.end(), VertexId{0});
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
  if (points.size() < 3 || hull[1] == upper[upper.size() - 2]) return hull;
  hull.insert(hull.end(), upper.begin() + 1, upper.end() - 1);
  return hull;
}

}  // namespace quadloom
