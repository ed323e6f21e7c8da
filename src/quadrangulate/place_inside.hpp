// A double inside a triangle, however small the triangle is.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "quadloom/core.hpp"

namespace quadloom::quadrangulate {

/// A point of the triangle that `fits`: the centroid as rounded, else one of the doubles in 62
/// columns through the triangle; none if none of them fits.
std::optional<Point> place_in_triangle(const std::array<Point, 3>& triangle,
                                       const std::function<bool(Point)>& fits);

/// The same for a point strictly inside the counter-clockwise triangle a, b, c.
std::optional<Point> place_inside(Point a, Point b, Point c);

}  // namespace quadloom::quadrangulate
