// The Delaunay method of quadrangulate_points.
#pragma once

#include <optional>

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// Quadrangulates the Delaunay triangulation of a point set; input_to_vertex is left to the caller.
/// Empty if a walk could not finish (not seen yet).
std::optional<PointResult> delaunay_quadrangulation(Triangulation&& delaunay,
                                                    const PointOptions& options);

}  // namespace quadloom::quadrangulate
