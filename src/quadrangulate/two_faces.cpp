// A path through all inner points between two hull points u and v.
//
//           ___v___
//          /  / .  \           1. points left of the chord u v, or on it: by angle around u, from the
//         |  /r2 .  |             far left to the chord; on one ray the nearer one first
//         | / r1  . |          2. points right of it: by angle around v, from the chord to the far
//      l1 ./      ./              right; on one ray the farther one first
//         | . l2 / /
//          \_ . / /            Part 1 is star-shaped around u, part 2 around v, and the edge between
//            \_u_/             them has the nothing of part 1 nearer to the chord as seen from u, and
//                              nothing of part 2 as seen from v: the path is simple.
//
// The first edge u l1 and u's left hull neighbour make a triangle without a point in it (l1 is the
// leftmost as seen from u); if nothing is left of the chord, the last edge r v and v's right hull
// neighbour do. Points added to the path go there. Cost: O(n log n).
#include "quadrangulate/two_faces.hpp"

#include <algorithm>

namespace quadloom::quadrangulate {
namespace {

/// a is nearer to the eye than b, both on one ray from it.
bool nearer(Point eye, Point a, Point b) {
  return lex_less(eye, a) ? lex_less(a, b) : lex_less(b, a);
}

}  // namespace

CutPath cut_through_all(std::span<const Point> points, std::span<const VertexId> hull,
                        std::size_t from, std::size_t steps) {
  const std::size_t h = hull.size();
  const Point u = points[hull[from]];
  const Point v = points[hull[(from + steps) % h]];
  std::vector<char> on_hull(points.size(), 0);
  for (const VertexId p : hull) on_hull[p] = 1;
  std::vector<VertexId> left, right;
  for (VertexId p = 0; p < points.size(); ++p) {
    if (!on_hull[p]) (orient2d(u, v, points[p]) >= 0 ? left : right).push_back(p);
  }
  std::sort(left.begin(), left.end(), [&](VertexId a, VertexId b) {
    const int turn = orient2d(u, points[a], points[b]);
    return turn != 0 ? turn < 0 : a != b && nearer(u, points[a], points[b]);
  });
  std::sort(right.begin(), right.end(), [&](VertexId a, VertexId b) {
    const int turn = orient2d(v, points[a], points[b]);
    return turn != 0 ? turn > 0 : a != b && nearer(v, points[b], points[a]);
  });

  CutPath path;
  path.vertices = {hull[from]};
  path.vertices.insert(path.vertices.end(), left.begin(), left.end());
  path.vertices.insert(path.vertices.end(), right.begin(), right.end());
  path.vertices.push_back(hull[(from + steps) % h]);
  if (left.empty()) {
    path.wide_edge = path.vertices.size() - 2;
    path.wide_apex = hull[(from + steps + h - 1) % h];
  } else {
    path.wide_apex = hull[(from + h - 1) % h];
  }
  return path;
}

}  // namespace quadloom::quadrangulate
