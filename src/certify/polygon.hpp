// One face by itself: is it a simple counter-clockwise polygon, and how convex is it.
#pragma once

#include <span>

#include "quadloom/core.hpp"

namespace quadloom::certify {

/// What the corners of a polygon say. With `simple` false the smallest turn means nothing.
struct PolygonVerdict {
  bool simple = false;    ///< simple, counter-clockwise, of positive area; flat corners allowed
  int smallest_turn = 0;  ///< +1 strictly convex, 0 convex with a flat corner, -1 not convex
};

/// Judges the polygon with these corners, exactly. Corners are finite and at least three. O(k^2)
/// for k <= 64, O(k log k) beyond.
PolygonVerdict judge_polygon(std::span<const Point> corners);

// The two ways in which a polygon of five corners or more is judged, for tests: no two edges that
// are not neighbours share a point, and neighbours share their common corner only.
bool edges_disjoint_by_pairs(std::span<const Point> corners);
bool edges_disjoint_by_sweep(std::span<const Point> corners);

}  // namespace quadloom::certify
