// The insertion method of quadrangulate_points.
#pragma once

#include <optional>
#include <vector>

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// Sequential insertion of distinct points that are not all collinear; input_to_vertex is left to
/// the caller. Empty if no order tried could be inserted to the end (not seen yet).
std::optional<PointResult> insertion_quadrangulation(const std::vector<Point>& points,
                                                     const PointOptions& options);

}  // namespace quadloom::quadrangulate
