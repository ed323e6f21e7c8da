// A double that sees all sides of a star-shaped polygon.
#pragma once

#include <optional>
#include <span>

#include "quadloom/core.hpp"

namespace quadloom::strips {

/// A point strictly left of the lines through all sides of the polygon (counter-clockwise), so that its
/// triangles with them turn left. Looked for on the line from `from` towards `to`, halfway first and then
/// ever nearer to `from`, and if no double fits there, exactly: none says that there is no such point, or
/// that they are in a region thinner than the spacing of the doubles (see convex/exact_region.hpp). A
/// polygon of more than a thousand corners is not looked at exactly.
std::optional<Point> place_in_star(std::span<const Point> star, Point from, Point to);

}  // namespace quadloom::strips
