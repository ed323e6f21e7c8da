// A double that sees all of a small polygon.
#pragma once

#include <optional>
#include <span>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// A point strictly left of all edges of a polygon of a few corners, counter-clockwise: it
/// sees each edge whole, from inside. Near the middle of where such points are; none if there is
/// none, or no double was found.
std::optional<Point> place_in_kernel(std::span<const Point> polygon);

}  // namespace quadloom::quadrangulate
