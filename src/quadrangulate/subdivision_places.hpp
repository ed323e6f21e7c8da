// Where the added points of a subdivided face go: the nearest doubles that exact predicates accept.
#pragma once

#include <array>
#include <optional>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// A triangle or quad with a point for each edge; edge[i] is for the edge from corner[i] to
/// corner[i + 1].
template <std::size_t N>
struct SplitFace {
  std::array<Point, N> corner;
  std::array<Point, N> edge;
};
using SplitTriangle = SplitFace<3>;
using SplitQuad = SplitFace<4>;

/// A place for the inner point such that all three quads are strictly convex; empty if none of the
/// places tried is one: the centroid of the edge points, then doubles in the triangle of the edge
/// points along its longer axis.
std::optional<Point> inner_place(const SplitTriangle& split);

/// The same for the four quads of a quad; empty if it is not strictly convex.
std::optional<Point> inner_place(const SplitQuad& split);

/// The point of the segment a->b at eighths / 8 of its length, up to rounding.
Point along_edge(Point a, Point b, int eighths);

/// `place` moved to the right of a->b by 2^step units in the last place of the coordinate that is
/// nearer to the edge's normal (or of the edge's extent in it, if that is more).
Point nudged_right(Point place, Point a, Point b, int step);

}  // namespace quadloom::quadrangulate
