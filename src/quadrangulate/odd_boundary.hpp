// The place of the one added point when an odd number of points lies on the hull.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "quadloom/core.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

struct OddPlace {
  Point place;
  SteinerKind kind = SteinerKind::kOutside;
};

/// A point outside the hull, near its edge a -> b (before, a, b, after: consecutive boundary
/// points, counter-clockwise), that sees the edge and leaves the boundary convex, strictly at a, at
/// b and at the new point. Impossible if the boundary is straight at a or at b.
std::optional<Point> place_outside(Point before, Point a, Point b, Point after);

/// The wished kind first, then the other one. Not for OddBoundary::kTriangle.
std::array<SteinerKind, 2> kinds_by_wish(OddBoundary wish);

/// The point of that kind (kOutside or kOnEdge) for the hull edge a -> b.
std::optional<OddPlace> place_of_kind(Point before, Point a, Point b, Point after,
                                      SteinerKind kind);

/// The point for the hull edge a -> b: of the wished kind (kOutside or kOnEdge) if there is one
/// among the doubles, else of the other kind. With the apex c of the inner triangle at the edge the
/// new quad is a, point, b, c, counter-clockwise.
std::optional<OddPlace> place_odd_point(Point before, Point a, Point b, Point after,
                                        OddBoundary wish);

/// Which hull points an edge may start at.
enum class EdgeStart { kAnyPoint, kCorner };

struct OddEdge {
  std::size_t index = 0;  ///< the edge from hull[index] to the next hull point
  OddPlace odd;
};

/// The first edge of the hull (as convex_hull gives it) that admits the wished kind; if none does,
/// the first one that admits the other kind. Throws Error kGuarantee if no edge admits either.
OddEdge choose_odd_edge(std::span<const Point> points, std::span<const VertexId> hull,
                        OddBoundary wish, EdgeStart start = EdgeStart::kAnyPoint);

}  // namespace quadloom::quadrangulate
