// Point sets at the public door of this room.
#pragma once

#include "quadloom/kernel.hpp"

namespace quadloom::quadrangulate {

/// The distinct points. Throws Error kNotFinite, kTooManyPoints; kTooFewPoints for fewer than three
/// of them, kAllCollinear if they lie on one line.
DistinctPoints points_of_the_plane(std::span<const Point> input);

/// Whether there are three points that are not collinear. For distinct points.
bool span_the_plane(std::span<const Point> points);

}  // namespace quadloom::quadrangulate
