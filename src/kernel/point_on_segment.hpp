// Exactly collinear points among the doubles.
#pragma once

#include <optional>

#include "quadloom/core.hpp"

namespace quadloom::kernel {

/// A point with double coordinates exactly on the open segment from a to b (a != b), as near to its
/// middle as there is one; none only if no double point lies on it.
std::optional<Point> point_on_segment(Point a, Point b);

}  // namespace quadloom::kernel
