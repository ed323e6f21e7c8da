// The subdivision method of quadrangulate_points.
#pragma once

#include "quadloom/quadrangulate.hpp"

namespace quadloom::quadrangulate {

/// Every triangle into three strictly convex quads; input_to_vertex is left to the caller. Vertices:
/// those of the triangulation, one an edge, one a triangle. Throws Error kGuarantee naming a
/// triangle whose quads have no place among the doubles.
PointResult subdivide_quadrangulation(Triangulation&& triangulation, const PointOptions& options);

}  // namespace quadloom::quadrangulate
