// The spiral method of quadrangulate_points.
#pragma once

#include <vector>

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// Bose and Toussaint's spiraling rotating calipers for distinct points that are not all collinear;
/// input_to_vertex is left to the caller. Throws Error kGuarantee if the odd point has no place
/// among the doubles, kCancelled.
PointResult spiral_quadrangulation(const std::vector<Point>& points, const PointOptions& options);

}  // namespace quadloom::quadrangulate
